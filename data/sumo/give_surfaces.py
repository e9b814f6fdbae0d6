#!/usr/bin/env python3
"""Gives the junctions of a network of SUMO the surfaces of their intersections.

    give_surfaces.py NAME.nod.xml NETWORK

prints the network. netconvert cuts lanes at the shapes of nodes, so that these lie where no lane comes, and the surface
is a parameter of the node. A node without one becomes a point. The head of the file, which holds the time and what netconvert was called with, goes.
"""
import re
import sys
import xml.etree.ElementTree as tree


def surfaces_of(path):
    """The surface of each node, by its id."""
    surfaces = {}
    for _, element in tree.iterparse(path):
        if element.tag == "node":
            given = element.find("param[@key='surface']")
            surfaces[element.get("id")] = f"{element.get('x')},{element.get('y')}" if given is None else given.get("value")
            element.clear()
    return surfaces


def finished(lines, surfaces):
    within_head = False
    for line in lines:
        within_head = within_head or line.startswith("<!-- generated")
        if not within_head and not re.match(r'\s*<param key="surface"', line):
            known = re.match(r'\s*<junction id="([^"]*)"', line)
            if known and known[1] in surfaces:
                line = re.sub(r' shape="[^"]*"', lambda _: f' shape="{surfaces[known[1]]}"', line, count=1)
            yield line
        if within_head and line.rstrip().endswith("-->"):
            within_head = False


def main():
    with open(sys.argv[2], encoding="utf-8") as lines:
        sys.stdout.writelines(finished(lines, surfaces_of(sys.argv[1])))


if __name__ == "__main__":
    main()
