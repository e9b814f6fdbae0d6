#!/usr/bin/env python3
"""Gives a network of SUMO what netconvert does not take from plain files.

    finish.py NAME NETWORK

prints the network. netconvert cuts lanes at the shapes of nodes, so that these lie where no lane comes, and the surface is a parameter of the node in
NAME.nod.xml. A node without one becomes a point. At a node with a stop line netconvert lets all stop who yield to somebody, if only at a crossing: who comes
by an edge without parameter waits gives way there, and does not stop. A program of NAME.tll.xml knows its crossings; netconvert adds them once more, and that goes. So does the
head of the file, which holds the time and what netconvert was called with.
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


def signals_of(path):
    """How many signals each program has, by its id."""
    signals = {}
    for _, element in tree.iterparse(path):
        if element.tag == "tlLogic":
            signals[element.get("id")] = len(element.find("phase").get("state"))
            element.clear()
    return signals


def finished(lines, surfaces, signals):
    within_head, shown, edge, stopping = False, None, None, set()
    for line in lines:
        within_head = within_head or line.startswith("<!-- generated")
        opened = re.match(r'\s*<edge id="([^"]*)"', line)
        edge = opened[1] if opened else edge
        if re.match(r'\s*<param key="waits"', line):
            stopping.add(edge)
        elif not within_head and not re.match(r'\s*<param key="surface"', line):
            known = re.match(r'\s*<junction id="([^"]*)"', line)
            if known and known[1] in surfaces:
                line = re.sub(r' shape="[^"]*"', lambda _: f' shape="{surfaces[known[1]]}"', line, count=1)
            program = re.match(r'\s*<tlLogic id="([^"]*)"', line)
            shown = signals.get(program[1]) if program else shown
            if shown is not None and "<phase " in line:
                line = re.sub(r' state="([^"]*)"', lambda state: f' state="{state[1][:shown]}"', line)
            comes = re.match(r'\s*<connection from="([^"]*)"', line)
            if comes and comes[1] not in stopping:
                line = line.replace(' state="s"', ' state="m"')
            yield line
        if within_head and line.rstrip().endswith("-->"):
            within_head = False


def main():
    with open(sys.argv[2], encoding="utf-8") as lines:
        sys.stdout.writelines(finished(lines, surfaces_of(sys.argv[1] + ".nod.xml"), signals_of(sys.argv[1] + ".tll.xml")))


if __name__ == "__main__":
    main()
