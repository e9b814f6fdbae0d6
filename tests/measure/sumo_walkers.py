#!/usr/bin/env python3
"""Sends people from place to place on two networks of SUMO: sumo_walkers.py NET OTHER PEOPLE FILE OTHER_FILE writes the same people for both.

Places are chosen by chance, by length, along the edges of NET on which people walk beside cars, and are those where the other network has an edge to walk on within 20 m.
"""
import math
import random
import subprocess
import sys
import xml.etree.ElementTree as tree

from sumo_parts import lets_in

NEAR, CELL = 20.0, 50.0


def read(path):
    """The walks of a network, an edge each with its lane's line, and the reference of the coordinates."""
    walks, reference, offset = {}, None, None
    for _, element in tree.iterparse(path):
        if element.tag == "location":
            reference, offset = element.get("projParameter"), [float(v) for v in element.get("netOffset").split(",")]
        elif element.tag == "edge":
            if element.get("function") is None:
                for lane in element.iter("lane"):
                    if lets_in(lane, "pedestrian"):
                        walks[element.get("id")] = [tuple(float(v) for v in point.split(",")[:2]) for point in lane.get("shape").split()]
                        break
            element.clear()
    return walks, reference, offset


def transformed(points, source, target):
    """The points in the other reference, by gdaltransform."""
    text = "".join(f"{x} {y}\n" for x, y in points)
    said = subprocess.run(["gdaltransform", "-s_srs", source, "-t_srs", target, "-output_xy"], input=text, capture_output=True, text=True, check=True).stdout
    return [tuple(float(v) for v in line.split()) for line in said.splitlines()]


class Nearest:
    """The edge nearest to a place, of lines in cells of a grid."""

    def __init__(self, walks):
        self.cells = {}
        for edge, line in walks.items():
            for a, b in zip(line, line[1:]):
                steps = max(1, math.ceil(math.dist(a, b) / CELL * 2))
                for i in range(steps + 1):
                    x, y = (a[k] + (b[k] - a[k]) * i / steps for k in (0, 1))
                    self.cells.setdefault((int(x // CELL), int(y // CELL)), set()).add((edge, a, b))

    def of(self, place):
        column, row = (int(v // CELL) for v in place)
        around = set().union(*(self.cells.get((column + i, row + j), set()) for i in (-1, 0, 1) for j in (-1, 0, 1)))
        return min(((distance(place, a, b), edge) for edge, a, b in around), default=(math.inf, None))


def distance(place, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    share = min(1, max(0, ((place[0] - a[0]) * dx + (place[1] - a[1]) * dy) / length)) if length else 0
    return math.hypot(place[0] - a[0] - share * dx, place[1] - a[1] - share * dy)


def main():
    net, other, people, *files = sys.argv[1:]
    (walks, reference, offset), (other_walks, other_reference, other_offset) = read(net), read(other)
    chance = random.Random(1)
    edges = sorted(walks)
    lengths = [sum(math.dist(a, b) for a, b in zip(walks[edge], walks[edge][1:])) for edge in edges]
    chosen = chance.choices(edges, lengths, k=12 * int(people))
    places = []
    for edge in chosen:
        line = walks[edge]
        i = chance.randrange(len(line) - 1)
        share = chance.random()
        places.append(tuple(line[i][k] + (line[i + 1][k] - line[i][k]) * share - offset[k] for k in (0, 1)))
    nearest = Nearest(other_walks)
    pairs = []
    for edge, place in zip(chosen, transformed(places, reference, other_reference)):
        metres, other_edge = nearest.of([place[k] + other_offset[k] for k in (0, 1)])
        if metres <= NEAR:
            pairs.append((edge, other_edge))
    for side, file in enumerate(files):
        with open(file, "w", encoding="utf-8") as out:
            out.write("<routes>\n")
            for number in range(min(int(people), len(pairs) // 2)):
                out.write(f'  <person id="{number}" depart="{number}"><walk from="{pairs[2 * number][side]}" to="{pairs[2 * number + 1][side]}"/></person>\n')
            out.write("</routes>\n")


if __name__ == "__main__":
    main()
