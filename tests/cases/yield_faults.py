#!/usr/bin/env python3
"""Reads a network of SUMO by itself, and prints each place where two go at once, or wait for each other:

    yield_faults.py NETWORK

lanes of one edge that lead into one lane of another of which not one yields, or that wait within the junction; a signal that shows G to who yields to somebody with
green; somebody who yields and has the sign of who goes first. Exit 1 where there is any. The numbers of links are those in the names of lanes within junctions.
"""
import collections
import sys
import xml.etree.ElementTree as tree


def faults(net):
    links, requests = collections.defaultdict(dict), collections.defaultdict(dict)  # crossings come last
    for connection in net.iter("connection"):
        # People on foot cross by lanes that are links, too.
        inside = connection.get("via") or (connection.get("to") + "_0" if "_c" in connection.get("to") else "")
        if inside and (not connection.get("from").startswith(":") or "_c" in inside):
            junction, edge, lane = inside[1:].rsplit("_", 2)
            links[junction][(1, int(edge[1:])) if edge.startswith("c") else (0, int(edge) + int(lane))] = connection
    for junction in net.iter("junction"):
        for request in junction.iter("request"):
            requests[junction.get("id")][int(request.get("index"))] = request
    phases = {program.get("id"): [phase.get("state") for phase in program.iter("phase")] for program in net.iter("tlLogic")}
    for junction, asked in requests.items():
        ways = dict(enumerate(links[junction][place] for place in sorted(links[junction])))
        for number, link in ways.items():
            before = [other for other in ways if asked[number].get("response")[::-1][other] == "1"]
            if before and link.get("state") == "M":
                yield f"junction {junction}: link {number} yields with the sign of who goes first"
            for state in phases.get(link.get("tl"), []):
                if state[int(link.get("linkIndex"))] == "G" and any(state[int(ways[other].get("linkIndex"))] in "Gg" for other in before):
                    yield f"junction {junction}: link {number} has G in {state} and yields to somebody with green"
            for other, beside in ways.items():
                if other > number and all(link.get(name) == beside.get(name) for name in ("from", "to", "toLane")):
                    if {asked[number].get("response")[::-1][other], asked[other].get("response")[::-1][number]} != {"0", "1"}:
                        yield f"junction {junction}: links {number} and {other} lead into one lane, and none or both yield"
                    if "1" in (asked[number].get("cont"), asked[other].get("cont")):
                        yield f"junction {junction}: links {number} and {other} lead into one lane, and wait within the junction"


if __name__ == "__main__":
    found = list(faults(tree.parse(sys.argv[1]).getroot()))
    print("\n".join(found))
    sys.exit(bool(found))
