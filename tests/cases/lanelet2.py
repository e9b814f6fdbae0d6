"""What a file of Lanelet2 says, read by itself as Lanelet2 reads it: lanelet2.py FILE prints "name value" lines, as many lanelets, how many of these lie across
junctions, references that lead nowhere, lanelets whose bounds a reader turns round against their traffic, bounds of a lanelet that cross each other or themselves.
lanelet2.py FILE --joined prints a line "lane f lane f" for each pair of lanes of which one is reached from the other by a lanelet across a junction, by their ids in
the model; t: against the direction of a lane for both."""
import math
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
        self.heights = {n.get('id'): n.find("tag[@k='ele']") is not None for n in root.iter('node')}
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
    yield 'lanelets', len(file.lanelets)
    yield 'across', sum(map(file.across, file.lanelets))
    yield 'astray', astray
    yield 'twice', len(file.ids) - len(set(file.ids))
    yield 'turned', turned
    yield 'crossing', crossing
    yield 'heights', sum(file.heights.values())
    for kind in ('right_of_way', 'traffic_light', 'crosswalk'):
        yield kind, sum(t.get('subtype') == kind and t.get('type') == 'regulatory_element' for t in file.tags.values())


def main():
    file = File(sys.argv[1])
    if '--joined' in sys.argv[2:]:
        for (a, against), (b, there) in sorted(joined(file), key=str):
            print(int(a) // 64, 'ft'[against], int(b) // 64, 'ft'[there], sep='\t')
    else:
        for figure in figures(file):
            print(*figure)


main()
