#!/usr/bin/env python3
"""Holds a network of SUMO against the plain files that it was made of.

    hold.py NAME [TOLERANCE]

reads NAME.edg.xml, NAME.con.xml and NAME.net.xml. Lanes, connections and pedestrian crossings that the network lost or invented, other widths,
and lines that moved by more than 0.1 m are printed, a line each, with the names of SUMO and the middle of the line in the reference of the model. Exit 1 where there are any, but for lines that moved by
no more than TOLERANCE metres (0.1), and for crossings that are lost: netconvert leaves out those where it finds no sidewalk to come from.
"""
import math
import sys
import xml.etree.ElementTree as tree

# A line that moved by less is at its place; widths are written with two digits.
PLACE, WIDTH = 0.1, 0.006


def line_of(text):
    """The points of a shape: x,y or x,y,z parted by spaces."""
    return [tuple(float(number) for number in point.split(",")[:2]) for point in text.split()]


def distance_to_segment(point, start, end):
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = dx * dx + dy * dy
    share = 0 if length == 0 else ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / length
    share = min(1, max(0, share))
    return math.hypot(point[0] - start[0] - share * dx, point[1] - start[1] - share * dy)


def farthest(points, line):
    """How far the farthest of the points is from a line."""
    segments = list(zip(line, line[1:])) or [(line[0], line[0])]
    return max(min(distance_to_segment(point, *segment) for segment in segments) for point in points)


def apart(one, other):
    """How far two lines leave each other; their ends count by themselves."""
    return max(farthest(one, other), farthest(other, one), math.dist(one[0], other[0]), math.dist(one[-1], other[-1]))


def elements(path, names):
    """The elements of those names, one by one; each is forgotten before the next one of its file."""
    reading = tree.iterparse(path, events=("start", "end"))
    _, root = next(reading)
    depth = 1
    for event, element in reading:
        depth += 1 if event == "start" else -1
        if event == "end" and depth == 1:
            if element.tag in names:
                yield element
            root.clear()


class Network:
    """Lanes by name, and crossings by their edges and node, with width and line; connections by their lanes with the line of their path or None."""

    def __init__(self):
        self.lanes, self.connections, self.crossings = {}, {}, {}
        self.offset = 0, 0

    def add_crossing(self, edges, node, element):
        self.crossings[f"{' '.join(sorted(edges.split()))} at {node}"] = float(element.get("width")), line_of(element.get("shape"))

    def add_edge(self, edge):
        for lane in edge.iter("lane"):
            name = f"{edge.get('id')}_{lane.get('index')}"
            self.lanes[name] = float(lane.get("width", 0)), line_of(lane.get("shape"))


def read_plain(name):
    plain = Network()
    for edge in elements(name + ".edg.xml", {"edge"}):
        plain.add_edge(edge)
    for connection in elements(name + ".con.xml", {"connection", "crossing"}):
        if connection.tag == "crossing":
            plain.add_crossing(connection.get("edges"), connection.get("node"), connection)
        elif connection.get("to") is not None:
            shape = connection.get("shape")
            plain.connections[ends_of(connection)] = line_of(shape) if shape else None
    return plain


def ends_of(connection):
    return (f"{connection.get('from')}_{connection.get('fromLane')}", f"{connection.get('to')}_{connection.get('toLane')}")


def read_net(path):
    """Of the network; a path goes by internal lanes, several where vehicles wait between them."""
    net, inside, after, first = Network(), {}, {}, {}
    for element in elements(path, {"location", "edge", "connection"}):
        if element.tag == "location":
            net.offset = line_of(element.get("netOffset"))[0]
        elif element.tag == "edge" and element.get("function") is None:
            net.add_edge(element)
        elif element.tag == "edge" and element.get("function") == "internal":
            for lane in element.iter("lane"):
                inside[lane.get("id")] = line_of(lane.get("shape"))
        elif element.tag == "edge" and element.get("function") == "crossing":
            net.add_crossing(element.get("crossingEdges"), element.get("id")[1:].rpartition("_c")[0], element.find("lane"))
        elif element.tag == "connection":
            if element.get("from").startswith(":"):
                after[f"{element.get('from')}_{element.get('fromLane')}"] = element.get("via")
            # Sidewalks lead to places where people turn and wait, which netconvert draws.
            elif not element.get("to").startswith(":"):
                first[ends_of(element)] = element.get("via")
    for ends, via in first.items():
        path_line = []
        while via is not None:
            path_line += inside[via][1 if path_line else 0:]
            via = after.get(via)
        net.connections[ends] = path_line
    return net


def differences(plain, net):
    """Kind, what, how far and the line, of all that differs."""
    for kind in "lane", "connection", "crossing":
        of_plain, of_net = getattr(plain, kind + "s"), getattr(net, kind + "s")
        drawn = (lambda value: value) if kind == "connection" else (lambda value: value[1])
        for what in of_plain.keys() - of_net.keys():
            yield f"{kind} lost", what, None, drawn(of_plain[what])
        for what in of_net.keys() - of_plain.keys():
            yield f"{kind} invented", what, None, drawn(of_net[what])
        for name in of_plain.keys() & of_net.keys() if kind != "connection" else ():
            (width, line), (width_there, line_there) = of_plain[name], of_net[name]
            if abs(width - width_there) > WIDTH:
                yield "width changed", name, None, line
            yield f"{kind} moved", name, apart(line, line_there), line
    for ends in plain.connections.keys() & net.connections.keys():
        line, line_there = plain.connections[ends], net.connections[ends]
        if line and line_there:
            yield "path moved", ends, apart(line, line_there), line


def told(difference, offset):
    """A line of text."""
    kind, what, metres, line = difference
    text = f"{kind} {what if isinstance(what, str) else ' -> '.join(what)}"
    if metres is not None:
        text += f" by {metres:.2f} m"
    if line:
        x, y = line[len(line) // 2]
        text += f" at {x - offset[0]:.2f} {y - offset[1]:.2f}"
    return text


def main():
    name, tolerance = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else PLACE
    plain, net = read_plain(name), read_net(name + ".net.xml")
    found = [row for row in differences(plain, net) if row[2] is None or row[2] > PLACE]
    for row in sorted(found, key=lambda row: (row[0], str(row[1]))):
        print(told(row, net.offset))
    print(f"{len(plain.lanes)} lanes and {len(plain.connections)} connections, {len(plain.crossings)} crossings, {len(found)} not as in the model", file=sys.stderr)
    sys.exit(any(kind != "crossing lost" and (metres is None or metres > tolerance) for kind, _, metres, _ in found))


if __name__ == "__main__":
    main()
