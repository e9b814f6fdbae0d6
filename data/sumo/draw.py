#!/usr/bin/env python3
"""Draws a part of a network that a simulator reads, as the file says it: draw.py FILE XMIN,YMIN,XMAX,YMAX COLOURS prints SVG.

FILE is a network of SUMO (.net.xml) or of SymuVia (.xml), the extent in the coordinates of the file. Of SUMO these are lanes by who may use them, junctions,
crossings, places where people on foot turn, and paths; of SymuVia troncons with the lanes they have, and movements by who goes first.
COLOURS is a JSON object of colours by theme, layer and kind, as streetgen.symbol_rule has them: this program knows files alone.
"""
import json
import math
import sys
import xml.etree.ElementTree as tree

WIDTH = 900
CAR, PARKING, BUS, CARPOOL, CYCLE, FOOT = "street section", "street bay", "street lane bus", "street lane carpool", "street lane cycle", "street sidewalk"
PATHS = {"defaut": "construction arc", "cedez_le_passage": "construction arc fallback", "stop": "construction signal_head"}


def line_of(text, part=","):
    return [tuple(float(number) for number in point.split(part)[:2]) for point in (text.split() if part == "," else [text])]


class Picture:
    """Layers of SVG in their order, in an extent; colours are told by theme, layer and kind."""

    def __init__(self, extent, colours):
        self.extent, self.colours, self.layers = extent, {"none": "none", **colours}, {}

    def place(self, point):
        xmin, ymin, xmax, ymax = self.extent
        scale = WIDTH / (xmax - xmin)
        return f"{(point[0] - xmin) * scale:.1f},{(ymax - point[1]) * scale:.1f}"

    def seen(self, line):
        xmin, ymin, xmax, ymax = self.extent
        xs, ys = zip(*line)
        return max(xs) > xmin and min(xs) < xmax and max(ys) > ymin and min(ys) < ymax

    def add(self, layer, line, metres=0.0, stroke="none", fill="none", opacity=1.0, arrow=False):
        if len(line) > 1 and self.seen(line):
            width = metres * WIDTH / (self.extent[2] - self.extent[0])
            self.layers.setdefault(layer, []).append(
                f'<path d="M{" L".join(self.place(p) for p in line)}" stroke="{self.colours[stroke]}" fill="{self.colours[fill]}" stroke-width="{width:.2f}" opacity="{opacity}"'
                + (f' marker-end="url(#{self.colours[stroke][1:]})"' if arrow else "") + "/>")

    def svg(self):
        xmin, ymin, xmax, ymax = self.extent
        arrows = "".join(f'<marker id="{colour[1:]}" viewBox="0 0 6 6" refX="5" refY="3" markerWidth="9" markerHeight="9" markerUnits="userSpaceOnUse" orient="auto">'
                         f'<path d="M0,0 L6,3 L0,6 z" fill="{colour}"/></marker>' for colour in [self.colours[symbol] for symbol in [*PATHS.values(), "construction ink"]])
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{WIDTH * (ymax - ymin) / (xmax - xmin):.0f}"><defs>{arrows}</defs>'
                f'<rect width="100%" height="100%" fill="{self.colours["street ground"]}"/>' + "".join(text for layer in sorted(self.layers) for text in self.layers[layer]) + "</svg>")


def symbol_of(lane):
    allow, disallow = lane.get("allow"), lane.get("disallow")
    if allow == "pedestrian":
        return FOOT
    if disallow == "all":
        return PARKING
    if allow and "hov" in allow:
        return CARPOOL
    return BUS if allow and "bus" in allow else CYCLE if allow == "bicycle" else CAR


def draw_sumo(root, picture):
    for junction in root.iter("junction"):
        if junction.get("type") != "internal" and junction.get("shape"):
            picture.add(1, line_of(junction.get("shape")), fill="street intersection")
    for edge in root.iter("edge"):
        function = edge.get("function")
        for lane in edge.iter("lane"):
            line, width = line_of(lane.get("shape")), float(lane.get("width", 3.2))
            if function == "walkingarea":
                picture.add(2, line, fill="street sidewalk")
            elif function == "crossing":
                picture.add(4, line, width, stroke="street crossing", opacity=0.75)
            elif function == "internal":
                picture.add(5, line, 0.15, stroke="construction path")
            else:
                picture.add(2, line, width + 0.15, stroke="street kerb")
                picture.add(3, line, width - 0.1, stroke=symbol_of(lane))


def beside(line, aside):
    """The line, metres to the right of its sides."""
    out = []
    for i, (x, y) in enumerate(line):
        (ax, ay), (bx, by) = line[max(i - 1, 0)], line[min(i + 1, len(line) - 1)]
        length = math.hypot(bx - ax, by - ay) or 1
        out.append((x + (by - ay) / length * aside, y - (bx - ax) / length * aside))
    return out


def ids_of(entry, way):
    return tuple(element.get(name + end) for element, end in ((entry, "amont"), (way, "aval")) for name in ("id_troncon_", "num_voie_"))


def draw_symuvia(root, picture):
    lines = {}
    for troncon in root.iter("TRONCON"):
        ends = [line_of(troncon.get(name), " ")[0] for name in ("extremite_amont", "extremite_aval")]
        inner = [line_of(point.get("coordonnees"), " ")[0] for point in troncon.iter("POINT_INTERNE")]
        line, lanes, width = [ends[0], *inner, ends[1]], int(troncon.get("nb_voie", 1)), float(troncon.get("largeur_voie"))
        lines[troncon.get("id")] = [beside(line, (lanes / 2 - lane - 0.5) * width) for lane in range(lanes)]
        for lane in lines[troncon.get("id")]:
            picture.add(1, lane, width - 0.15, stroke=CAR)
        picture.add(2, line, 0.35, stroke="construction ink", arrow=True)
    ways = [(entry, way, entry.get("priorite")) for entry in root.iter("ENTREE_CAF") for way in entry.iter("MOUVEMENT")]
    known = {ids_of(entry, way) for entry, way, _ in ways}
    ways += [(entry, way, "defaut") for entry in root.iter("MOUVEMENT_AUTORISE") for way in entry.iter("MOUVEMENT_SORTIE") if ids_of(entry, way) not in known]
    for entry, way, priority in ways:
        come, go = (lines[troncon][int(lane) - 1] for troncon, lane in (ids_of(entry, way)[:2], ids_of(entry, way)[2:]))
        inner = [line_of(point.get("coordonnees"), " ")[0] for point in way.iter("POINT_INTERNE")]
        picture.add(3, [come[-1], *inner, go[0]], 0.3, stroke=PATHS[priority], arrow=True)


def main():
    root = tree.parse(sys.argv[1]).getroot()
    picture = Picture([float(number) for number in sys.argv[2].split(",")], json.loads(sys.argv[3]))
    (draw_sumo if root.tag == "net" else draw_symuvia)(root, picture)
    print(picture.svg())


if __name__ == "__main__":
    main()
