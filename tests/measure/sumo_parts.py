#!/usr/bin/env python3
"""Says how much of a network of SUMO hangs together: sumo_parts.py NET.

Prints a line each, in metres and as shares: the largest strongly connected part of the edges that passenger cars use, that of the same edges
with every turn allowed, the share of both, and the share of the lanes on which people walk that lies in the largest part on foot. People walk as SUMO's router
does: along one lane of each edge, both ways, and from one to the next by walking areas and crossings.
"""
import sys
import xml.etree.ElementTree as tree


class Network:
    """Edges with their lanes, their nodes and what they are for; connections between lanes."""

    def __init__(self, path):
        self.edges, self.connections = {}, []
        for _, element in tree.iterparse(path):
            if element.tag == "edge":
                lanes = [(float(lane.get("length")), lets_in(lane, "passenger"), lets_in(lane, "pedestrian")) for lane in element.iter("lane")]
                self.edges[element.get("id")] = element.get("function", "normal"), element.get("from"), element.get("to"), lanes
                element.clear()
            elif element.tag == "connection":
                self.connections.append((element.get("from"), int(element.get("fromLane")), element.get("to"), int(element.get("toLane"))))
                element.clear()


def lets_in(lane, kind):
    allow, disallow = lane.get("allow"), lane.get("disallow")
    if allow is not None:
        return kind in allow.split() or allow == "all"
    return disallow is None or (kind not in disallow.split() and disallow != "all")


def strong_parts(successors):
    """The strongly connected parts of a graph, by Tarjan, without recursion."""
    index, low, on_stack, stack, parts = {}, {}, set(), [], []
    for root in successors:
        if root in index:
            continue
        work = [(root, iter(successors[root]))]
        index[root] = low[root] = len(index)
        stack.append(root)
        on_stack.add(root)
        while work:
            node, following = work[-1]
            for other in following:
                if other not in index:
                    index[other] = low[other] = len(index)
                    stack.append(other)
                    on_stack.add(other)
                    work.append((other, iter(successors[other])))
                    break
                if other in on_stack:
                    low[node] = min(low[node], index[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    part = set()
                    while not part or other != node:
                        other = stack.pop()
                        on_stack.discard(other)
                        part.add(other)
                    parts.append(part)
    return parts


def driven(net):
    """Length of the largest part for cars, of that with every turn, and of all."""
    length = {edge: lanes[0][0] for edge, (function, _, _, lanes) in net.edges.items() if function == "normal" and any(car for _, car, _ in lanes)}
    said, every, starting = {edge: set() for edge in length}, {}, {}
    for edge in length:
        starting.setdefault(net.edges[edge][1], []).append(edge)
    for edge in length:
        every[edge] = starting.get(net.edges[edge][2], [])
    for a, i, b, j in net.connections:
        if a in length and b in length and net.edges[a][3][i][1] and net.edges[b][3][j][1]:
            said[a].add(b)

    def largest(successors):
        return max((sum(length[edge] for edge in part) for part in strong_parts(successors)), default=0)
    return largest(said), largest(every), sum(length.values())


def walked(net):
    """Edges of the largest part on foot, the number of parts, and the length of all edges on which people walk."""
    walk = {edge: next(i for i, (_, _, foot) in enumerate(lanes) if foot)
            for edge, (function, _, _, lanes) in net.edges.items() if function != "internal" and any(foot for _, _, foot in lanes)}
    by_area = {a for a, i, b, _ in net.connections if walk.get(a) == i and b in walk and net.edges[b][0] == "walkingarea"}
    above = {edge: edge for edge in walk}

    def top(edge):
        while above[edge] != edge:
            above[edge] = edge = above[above[edge]]
        return edge
    for a, i, b, j in net.connections:
        if walk.get(a) == i and walk.get(b) == j and (a not in by_area or net.edges[b][0] == "walkingarea"):
            above[top(a)] = top(b)
    length = {edge: net.edges[edge][3][i][0] for edge, i in walk.items() if net.edges[edge][0] == "normal"}
    of_part = {}
    for edge, metres in length.items():
        of_part[top(edge)] = of_part.get(top(edge), 0) + metres
    largest = max(of_part, key=of_part.get, default=None)
    return {edge for edge in length if top(edge) == largest}, len(of_part), length


def main():
    net = Network(sys.argv[1])
    said, every, whole = driven(net)
    print(f"driven {said:.0f} of {every:.0f} of {whole:.0f} m: {said / every if every else 1:.3f} of every turn")
    largest, parts, length = walked(net)
    inside = sum(length[edge] for edge in largest)
    print(f"walked {inside:.0f} of {sum(length.values()):.0f} m in {parts} parts: {inside / sum(length.values()) if length else 1:.3f} in the largest")


if __name__ == "__main__":
    main()
