"""The reference of files: georeference.py STEM prints rows "file, reference, x, y, z, matrix" with the origin of its coordinates, and of tiles their matrix."""
import glob
import json
import re
import struct
import sys

stem = sys.argv[1]


def row(*values):
    print(*values, sep="\t")


text = open(f"{stem}.xodr").read(20000)
offset = re.search(r'<offset x="([^"]*)" y="([^"]*)"', text)
row("xodr", re.search(r"<!\[CDATA\[(.*?)\]\]>", text).group(1), offset.group(1), offset.group(2), 0, "")
text = open(f"{stem}.net.xml").read(200000)
location = re.search(r'<location netOffset="([^",]*),([^"]*)".*projParameter="([^"]*)"', text)
row("net.xml", location.group(3), -float(location.group(1)), -float(location.group(2)), 0, "")
city = json.load(open(f"{stem}.city.json"))
row("city.json", city["metadata"]["referenceSystem"].rsplit("/", 1)[1], *city["transform"]["translate"], "")
data = open(f"{stem}.glb", "rb").read()
extras = json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])["asset"]["extras"]
row("glb", extras["srid"], *extras["origin"], "")


def tiles(tile):
    if "content" in tile:
        file = open(f"{stem}.tiles/{tile['content']['uri']}", "rb").read()
        told = json.loads(file[20:20 + struct.unpack("<I", file[12:16])[0]])["asset"]["extras"]
        row("tiles", "4978", *told["origin"], "{" + ",".join(map(str, tile["transform"])) + "}")
    for child in tile.get("children", []):
        tiles(child)


tiles(json.load(open(f"{stem}.tiles/tileset.json"))["root"])
