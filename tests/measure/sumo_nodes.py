"""Ground that nodes of a network of SUMO share: sumo_nodes.py NET prints how many ways for cars across a node are shorter than 1 m and have foes there,
how many such ways those across another node pass within a metre, and how many lanes for cars are shorter than 5 m and have their middle in the ground of a node that they neither leave nor lead to."""
import math
import sys
from collections import defaultdict
import xml.etree.ElementTree as ElementTree


def points(text):
    return [tuple(map(float, point.split(',')[:2])) for point in (text or '').split()]


def inside(point, ring):
    (x, y), odd = point, False
    for (a, b), (c, d) in zip(ring, ring[1:] + ring[:1]):
        if (b > y) != (d > y) and x < a + (c - a) * (y - b) / (d - b):
            odd = not odd
    return odd


def off(point, a, b):
    """Metres from a point to a side."""
    (x, y), (u, v) = (b[0] - a[0], b[1] - a[1]), (point[0] - a[0], point[1] - a[1])
    square = x * x + y * y
    share = min(max((u * x + v * y) / square, 0), 1) if square > 0 else 0
    return math.hypot(u - share * x, v - share * y)


def for_cars(lane):
    return 'passenger' not in lane.get('disallow', '').split() and (lane.get('allow') is None or 'passenger' in lane.get('allow').split()) and lane.get('disallow') != 'all'


def main():
    net = ElementTree.parse(sys.argv[1]).getroot()
    lanes = {lane.get('id'): lane for lane in net.iter('lane')}
    nodes = [n for n in net.iter('junction') if n.get('type') != 'internal']
    crossed = 0
    for node in nodes:
        requests = {int(r.get('index')): r.get('foes') for r in node.findall('request')}
        for index, via in enumerate(node.get('intLanes', '').split()):
            crossed += via in lanes and for_cars(lanes[via]) and float(lanes[via].get('length')) < 1 and '1' in requests.get(index, '')
    ways = [(n.get('id'), via, points(lanes[via].get('shape'))) for n in nodes for via in n.get('intLanes', '').split() if via in lanes and for_cars(lanes[via])]
    near, passed = defaultdict(list), 0
    for node, _, line in ways:
        for a, b in zip(line, line[1:]):
            for x in range(int(min(a[0], b[0]) - 1) // 10, int(max(a[0], b[0]) + 1) // 10 + 1):
                for y in range(int(min(a[1], b[1]) - 1) // 10, int(max(a[1], b[1]) + 1) // 10 + 1):
                    near[x, y].append((node, a, b))
    for node, via, line in ways:
        if float(lanes[via].get('length')) < 1:
            middle = tuple((a + b) / 2 for a, b in zip(line[0], line[-1]))
            passed += any(other != node and off(middle, a, b) < 1 for other, a, b in near[int(middle[0]) // 10, int(middle[1]) // 10])
    grounds = [(n.get('id'), points(n.get('shape'))) for n in nodes]
    within = 0
    for edge in net.iter('edge'):
        if edge.get('function') == 'internal':
            continue
        for lane in edge.findall('lane'):
            if float(lane.get('length')) >= 5 or not for_cars(lane):
                continue
            line = points(lane.get('shape'))
            middle = tuple((a + b) / 2 for a, b in zip(line[0], line[-1]))
            within += any(name not in (edge.get('from'), edge.get('to')) and len(ring) > 2 and inside(middle, ring) for name, ring in grounds)
    print(crossed, passed, within)


main()
