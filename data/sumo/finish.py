#!/usr/bin/env python3
"""Gives a network of SUMO what netconvert does not take from plain files.

    finish.py NAME NETWORK

prints the network. netconvert cuts lanes at the shapes of nodes, so that no lane reaches the border of these, and the surface is a parameter of the node in
NAME.nod.xml. A node without one becomes a point. At a node with a stop line netconvert lets all stop who yield to somebody, if only at a crossing: who comes
by an edge without parameter waits gives way there, and does not stop. A program of NAME.tll.xml knows its crossings; netconvert adds them once more, and that goes. So does the
head of the file, which holds the time and what netconvert was called with. right_of_way.py says who gives way where netconvert, or a program, lets two go at once.
"""
import re
import sys
import xml.etree.ElementTree as tree

from right_of_way import RightOfWay, value


def surfaces_of(path):
    """The surface of each node, by its id."""
    surfaces = {}
    for _, element in tree.iterparse(path):
        if element.tag == "node":
            given = element.find("param[@key='surface']")
            surfaces[element.get("id")] = f"{element.get('x')},{element.get('y')}" if given is None else given.get("value")
            element.clear()
    return surfaces


def signals_of(path):
    """How many signals each program has, by its id."""
    signals = {}
    for _, element in tree.iterparse(path):
        if element.tag == "tlLogic":
            signals[element.get("id")] = len(element.find("phase").get("state"))
            element.clear()
    return signals


def finished(lines, surfaces, signals, right_of_way):
    within_head, program, junction, edge, stopping = False, None, None, None, set()
    for line in lines:
        within_head = within_head or line.startswith("<!-- generated")
        opened = re.match(r'\s*<edge id="([^"]*)"', line)
        edge = opened[1] if opened else edge
        if re.match(r'\s*<param key="waits"', line):
            stopping.add(edge)
        elif not within_head and not re.match(r'\s*<param key="surface"', line):
            if re.match(r"\s*<junction ", line):
                junction = value(line, "id")
                if junction in surfaces:
                    line = re.sub(r' shape="[^"]*"', lambda _: f' shape="{surfaces[junction]}"', line, count=1)
            elif re.match(r"\s*<request ", line):
                line = right_of_way.request(junction, line)
            elif re.match(r"\s*<tlLogic ", line):
                program = value(line, "id")
            elif re.match(r"\s*<phase ", line):
                line = re.sub(r' state="([^"]*)"', lambda state: f' state="{right_of_way.phase(program, state[1])[:signals.get(program)]}"', line)
            elif re.match(r"\s*<connection ", line):
                if value(line, "from") not in stopping:
                    line = line.replace(' state="s"', ' state="m"')
                line = right_of_way.connection(line)
            yield line
        if within_head and line.rstrip().endswith("-->"):
            within_head = False


def main():
    name, made = sys.argv[1:]
    with open(made, encoding="utf-8") as lines:
        right_of_way = RightOfWay(lines)
    with open(made, encoding="utf-8") as lines:
        sys.stdout.writelines(finished(lines, surfaces_of(name + ".nod.xml"), signals_of(name + ".tll.xml"), right_of_way))


if __name__ == "__main__":
    main()
