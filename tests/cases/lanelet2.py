"""What a file of Lanelet2 says, read by itself: lanelet2.py FILE prints how many lanelets it has, how many of these lie across junctions (both bounds virtual), how
many references lead nowhere, how many lanelets have their left bound at the right, how many lanelets across a junction begin or end at no lane's two points, and
how many regulatory elements of each kind, right_of_way and traffic_light, there are."""
import math
import sys
import xml.etree.ElementTree as ElementTree


def main():
    root = ElementTree.parse(sys.argv[1]).getroot()
    nodes = {n.get('id'): (float(n.get('lon')), float(n.get('lat'))) for n in root.iter('node')}
    ways = {w.get('id'): [nd.get('ref') for nd in w.iter('nd')] for w in root.iter('way')}
    tags = {e.get('id'): {t.get('k'): t.get('v') for t in e.iter('tag')} for e in root if e.tag in ('way', 'relation')}
    relations = {r.get('id'): [(m.get('type'), m.get('ref'), m.get('role')) for m in r.iter('member')] for r in root.iter('relation')}
    astray = sum(ref not in nodes for refs in ways.values() for ref in refs)
    astray += sum(ref not in (ways if kind == 'way' else relations) for members in relations.values() for kind, ref, _ in members)
    lanelets = {}
    for name, members in relations.items():
        if tags[name].get('type') == 'lanelet':
            lanelets[name] = [next(ref for _, ref, role in members if role == side) for side in ('left', 'right')]
    wrong, ends, across = 0, {}, []
    for name, (left, right) in lanelets.items():
        a, b = ways[left], ways[right]
        # As Lanelet2 does, the bounds are turned so that they run beside each other, with the left one at the left.
        def area(one, other):
            ring = [nodes[n] for n in one + other[::-1]]
            east = math.cos(math.radians(ring[0][1]))
            return sum((x - ring[0][0]) * (v - ring[0][1]) - (u - ring[0][0]) * (y - ring[0][1]) for (x, y), (u, v) in zip(ring, ring[1:] + ring[:1])) * east
        if tags[left].get('type') == tags[right].get('type') == 'virtual' and 'edge' not in tags[name]:
            across.append((name, a, b))
            wrong += area(a, b) > 0
        else:
            if area(a, b) > 0:
                a, b = a[::-1], b[::-1]
            wrong += area(a, b) > 0
            ends[(a[0], b[0])], ends[(a[-1], b[-1])] = name, name
            if tags[name].get('one_way') == 'no':
                ends[(b[0], a[0])], ends[(b[-1], a[-1])] = name, name
    apart = sum((a[0], b[0]) not in ends or (a[-1], b[-1]) not in ends for _, a, b in across)
    kinds = [sum(t.get('subtype') == kind and t.get('type') == 'regulatory_element' for t in tags.values()) for kind in ('right_of_way', 'traffic_light')]
    print(len(lanelets), len(across), astray, wrong, apart, *kinds)


main()
