"""What a file of Lanelet2 says, read by itself as Lanelet2 reads it: lanelet2.py FILE prints "name value" lines, as many lanelets for traffic, how many of these lie
across junctions and say where they turn, walkways and crosswalks, references that lead nowhere, ids that are there twice, lanelets whose bounds a reader turns round
against their traffic, those whose bounds cross each other or themselves, and points with heights and local coordinates.
lanelet2.py FILE --joined prints a line "lane f lane f" for each pair of lanes of which one is reached from the other by a lanelet across a junction, by their ids in
the model; t: against the direction of a lane for both.
lanelet2.py FILE --findings prints a line "lanelet what" for each that Lanelet2's validator, whose output is at standard input, finds something about, or about a
point or a line of it; but for the tag turn_direction."""
import math
import re
import sys
import xml.etree.ElementTree as ElementTree

# Ids of files by 64: what is left says what it is of, a lane, or a way across a junction from here on.
LANE, WAY = 2, 16


class File:
    def __init__(self, name):
        root = ElementTree.parse(name).getroot()
        first = next(root.iter('node'))
        lat, lon = float(first.get('lat')), float(first.get('lon'))
        # Metres about the first point suffice to tell sides.
        north, east = math.radians(6371000), math.radians(6371000) * math.cos(math.radians(lat))
        self.points = {n.get('id'): ((float(n.get('lon')) - lon) * east, (float(n.get('lat')) - lat) * north) for n in root.iter('node')}
        self.told = {key: sum(n.find(f"tag[@k='{key}']") is not None for n in root.iter('node')) for key in ('ele', 'local_x', 'local_y')}
        self.ways = {w.get('id'): [nd.get('ref') for nd in w.iter('nd')] for w in root.iter('way')}
        self.tags = {e.get('id'): {t.get('k'): t.get('v') for t in e.iter('tag')} for e in root if e.tag in ('way', 'relation')}
        self.members = {r.get('id'): [(m.get('type'), m.get('ref'), m.get('role')) for m in r.iter('member')] for r in root.iter('relation')}
        self.ids = [e.get('id') for e in root]
        self.lanelets = {}
        for name, members in self.members.items():
            if self.tags[name].get('type') == 'lanelet':
                self.lanelets[name] = [next(self.ways[ref] for _, ref, role in members if role == side) for side in ('left', 'right')]

    def line(self, refs):
        return [self.points[ref] for ref in refs]

    def across(self, name):
        return int(name) % 64 >= WAY

    def on_foot(self, name):
        return 'participant:pedestrian' in self.tags[name]

    def aligned(self, name):
        """The bounds of a lanelet, each turned round where a reader does so."""
        left, right = self.lanelets[name]
        if not side_of(self.line(left), middle(self.line(right))) < 0:
            left = left[::-1]
        if not side_of(self.line(right), middle(self.line(left))) > 0:
            right = right[::-1]
        return left, right


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def middle(line):
    return line[len(line) // 2] if len(line) > 2 else tuple((a + b) / 2 for a, b in zip(line[0], line[-1]))


def nearest(a, b, p):
    square = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
    share = 0 if square == 0 else ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / square
    return a if share <= 0 else b if share >= 1 else (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]))


def side_of(line, p):
    """Metres from the line, negative at its right: geometry::signedDistance of Lanelet2."""
    i = min(range(len(line) - 1), key=lambda k: math.dist(nearest(line[k], line[k + 1], p), p))
    a, b, place = line[i], line[i + 1], nearest(line[i], line[i + 1], p)
    left = cross(a, b, p) > 0
    if place == b and i + 2 < len(line) and left != (cross(b, line[i + 2], p) > 0) and left == (cross(a, b, line[i + 2]) > 0):
        left = not left
    return math.dist(place, p) if left else -math.dist(place, p)


def cross_each_other(a, b, c, d):
    return cross(a, b, c) * cross(a, b, d) < -1e-9 and cross(c, d, a) * cross(c, d, b) < -1e-9


def sides(line):
    return list(zip(line, line[1:]))


def joined(file):
    """Pairs (lanelet, against) of lanes that a lanelet across a junction joins."""
    begins, ends = {}, {}
    for name in file.lanelets:
        left, right = file.aligned(name)
        begins.setdefault((left[0], right[0]), set()).add((name, False))
        ends.setdefault((left[-1], right[-1]), set()).add((name, False))
        if file.tags[name].get('one_way') == 'no':
            begins.setdefault((right[-1], left[-1]), set()).add((name, True))
            ends.setdefault((right[0], left[0]), set()).add((name, True))
    pairs = set()
    for name in file.lanelets:
        if file.across(name):
            left, right = file.aligned(name)
            for before in ends.get((left[0], right[0]), ()):
                for behind in begins.get((left[-1], right[-1]), ()):
                    if not file.across(before[0]) and not file.across(behind[0]):
                        pairs.add((before, behind))
    return pairs


def figures(file):
    astray = sum(ref not in file.points for refs in file.ways.values() for ref in refs)
    astray += sum(ref not in (file.ways if kind == 'way' else file.members) for members in file.members.values() for kind, ref, _ in members)
    turned = crossing = 0
    for name, bounds in file.lanelets.items():
        left, right = file.aligned(name)
        turns = [list(a) != list(b) for a, b in zip((left, right), bounds)]
        turned += any(turns) if file.across(name) else turns[0] != turns[1]
        a, b = sides(file.line(left)), sides(file.line(right))
        crossing += any(cross_each_other(*s, *t) for s in a for t in b) or any(
            cross_each_other(*s[i], *s[k]) for s in (a, b) for i in range(len(s)) for k in range(i + 2, len(s)))
    yield 'lanelets', sum(not file.on_foot(name) for name in file.lanelets)
    yield 'across', sum(map(file.across, file.lanelets))
    for turn in ('straight', 'left', 'right'):
        yield turn, sum(file.tags[name].get('turn_direction') == turn for name in file.lanelets)
    for kind in ('walkway', 'crosswalk'):
        yield kind, sum(file.tags[name].get('subtype') == kind for name in file.lanelets)
    yield 'astray', astray
    yield 'twice', len(file.ids) - len(set(file.ids))
    yield 'turned', turned
    yield 'crossing', crossing
    yield 'points', len(file.points)
    yield from file.told.items()
    for kind in ('right_of_way', 'traffic_light', 'crosswalk'):
        yield 'rule_' + kind, sum(t.get('subtype') == kind and t.get('type') == 'regulatory_element' for t in file.tags.values())


def findings(file, text):
    """Pairs of a lanelet and what is found about it."""
    of = {}
    for name, bounds in file.lanelets.items():
        for kind, ref, role in file.members[name]:
            if role in ('left', 'right'):
                of.setdefault(('linestring', ref), []).append(name)
        for ref in {ref for bound in bounds for ref in bound}:
            of.setdefault(('point', ref), []).append(name)
    found = set()
    for kind, ref, what in re.findall(r'^\w+: (\w+) (\d+) .*\[[\w.]*?(\w+)\]$', re.sub(r'^.* turn_direction .*$', '', text, flags=re.M), re.M):
        found |= {(name, what) for name in of.get((kind, ref), [ref])}
    return found


def main():
    file = File(sys.argv[1])
    if '--findings' in sys.argv[2:]:
        for finding in sorted(findings(file, sys.stdin.read())):
            print(*finding)
    elif '--joined' in sys.argv[2:]:
        for (a, against), (b, there) in sorted(joined(file), key=str):
            print(int(a) // 64, 'ft'[against], int(b) // 64, 'ft'[there], sep='\t')
    else:
        for figure in figures(file):
            print(*figure)


main()
