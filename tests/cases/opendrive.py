"""What a file of OpenDRIVE says, by an evaluation of its own: opendrive.py FILE prints how many lanes, connecting roads and junctions there
are, and the greatest gaps: within reference lines (m, degrees) and between linked lanes (m, degrees), and how many of them are wider than 1 cm or 0.1
degrees; how many roads that a connecting road joins do not lead to its junction, or are connecting roads themselves, or are not linked back; at last between how many linked lanes
borders lie over 1 cm apart, and how far (m). opendrive.py FILE --lanes prints a row "edge, lane number, polygon as WKT" of each lane instead, but sidewalks and the room beside lanes; opendrive.py FILE --beside a row
"element, id, edge or empty, WKT" of each object, signal, sign and sidewalk. opendrive.py FILE --curves PATHS holds connecting roads against the paths of their
interconnections (rows "id, WKT" of a file): how many turn over 45 degrees, their records on average, how many of them have an arc under 2 m where the path turns
wider, and how many of all have an arc under 3 m or half their lane where the path turns wider; those of several interconnections are not held against paths. opendrive.py FILE --grades prints how many elevation records there are, the
joints of roads with heights, the greatest difference of heights at these (m), how many have a break of grade over 1 %, and how many there are within roads."""
import math
import sys
import xml.etree.ElementTree as ElementTree


def place(geometry, s):
    """x, y and heading, s metres behind where the piece begins."""
    x, y, heading = (float(geometry.get(name)) for name in ('x', 'y', 'hdg'))
    first, last = curvatures(geometry)
    if first != last:
        # By Simpson's rule; the heading of a spiral is a quadratic of the length.
        rate, parts = (last - first) / float(geometry.get('length')), 64
        bent = [heading + (first + rate * s * i / parts / 2) * s * i / parts for i in range(parts + 1)]
        weights = [1 if i in (0, parts) else 2 + 2 * (i % 2) for i in range(parts + 1)]
        east, north = (sum(w * of(h) for w, h in zip(weights, bent)) * s / parts / 3 for of in (math.cos, math.sin))
        return x + east, y + north, bent[-1]
    if first == 0:
        return x + s * math.cos(heading), y + s * math.sin(heading), heading
    curvature = first
    end = heading + s * curvature
    return x + (math.sin(end) - math.sin(heading)) / curvature, y - (math.cos(end) - math.cos(heading)) / curvature, end


def curvatures(geometry):
    """Where a piece begins and where it ends."""
    arc, spiral = geometry.find('arc'), geometry.find('spiral')
    if spiral is not None:
        return float(spiral.get('curvStart')), float(spiral.get('curvEnd'))
    return (0.0, 0.0) if arc is None else (float(arc.get('curvature')),) * 2


def value(polynomials, name, s):
    """The polynomial that holds at s, and its slope."""
    held = [p for p in polynomials if float(p.get(name)) <= s + 1e-9]
    if not held:
        return 0.0, 0.0
    a, b, c, d = (float(held[-1].get(k)) for k in 'abcd')
    ds = s - float(held[-1].get(name))
    return a + ds * (b + ds * (c + ds * d)), b + ds * (2 * c + ds * 3 * d)


class Road:
    def __init__(self, element):
        self.element = element
        self.length = float(element.get('length'))
        self.pieces = element.findall('planView/geometry')
        self.offsets = element.findall('lanes/laneOffset')
        self.heights = element.findall('elevationProfile/elevation')
        section = element.find('lanes/laneSection')
        self.lanes = {int(lane.get('id')): lane for lane in section.iter('lane')}
        edge = element.find("userData[@code='edge']")
        self.edge = None if edge is None else edge.get('value')

    def at(self, s):
        piece = [p for p in self.pieces if float(p.get('s')) <= s + 1e-9][-1]
        first, last = curvatures(piece)
        on = s - float(piece.get('s'))
        return place(piece, on), first + (last - first) * on / float(piece.get('length'))

    def height(self, at_end):
        """At an end, with the grade there."""
        return value(self.heights, 's', self.length if at_end else 0.0)

    def borders(self, number, s):
        """Inner and outer border of a lane, metres to the left, each with its slope."""
        side = 1 if number > 0 else -1
        inner = value(self.offsets, 's', s)
        for n in range(side, number + side, side):
            width = value(self.lanes[n].findall('width'), 'sOffset', s)
            outer = inner[0] + side * width[0], inner[1] + side * width[1]
            if n != number:
                inner = outer
        return inner, outer

    def middle(self, number, at_end):
        """Place and heading of the middle of a lane, in the direction of the road, and its width."""
        s = self.length if at_end else 0.0
        (x, y, heading), curvature = self.at(s)
        (a, da), (b, db) = self.borders(number, s)
        t, slope = (a + b) / 2, (da + db) / 2
        return x - t * math.sin(heading), y + t * math.cos(heading), heading + math.atan2(slope, 1 - curvature * t), abs(a - b)

    def corners(self, number, at_end):
        """Where the borders of a lane end."""
        s = self.length if at_end else 0.0
        (x, y, heading), _ = self.at(s)
        return [(x - t * math.sin(heading), y + t * math.cos(heading)) for t, _ in self.borders(number, s)]

    def polygon(self, number):
        stations = sorted({0.0, self.length} | {s for p in self.pieces for s in piece_stations(p)} | {float(w.get('sOffset')) for w in self.lanes[number].findall('width')})
        inner, outer = [], []
        for s in stations:
            (x, y, heading), _ = self.at(min(s, self.length))
            for (t, _), points in zip(self.borders(number, s), (inner, outer)):
                points.append((x - t * math.sin(heading), y + t * math.cos(heading)))
        return inner + outer[::-1] + inner[:1]


def piece_stations(piece):
    s, length = float(piece.get('s')), float(piece.get('length'))
    parts = 1 if piece.find('line') is not None else 8
    return [s + length * i / parts for i in range(parts)]


def is_lane(lane):
    return lane.get('id') != '0' and lane.get('type') not in ('sidewalk', 'shoulder')


def ring(points):
    return 'POLYGON((' + ','.join(f'{x:.4f} {y:.4f}' for x, y in points + points[:1]) + '))'


def beside(roads, east, north):
    """What a road has beside its lanes: element, id, edge and where it is."""
    for road in roads.values():
        edge = road.edge or ''
        for number, lane in road.lanes.items():
            if lane.get('type') == 'sidewalk':
                yield 'sidewalk', number, edge, ring([(x + east, y + north) for x, y in road.polygon(number)[:-1]])
        for element in road.element.findall('objects/object') + road.element.findall('signals/signal'):
            (x, y, heading), _ = road.at(float(element.get('s')))
            t = float(element.get('t'))
            x, y = x - t * math.sin(heading) + east, y + t * math.cos(heading) + north
            turn = heading + float(element.get('hdg', 0))
            corners = [(x + u * math.cos(turn) - v * math.sin(turn), y + u * math.sin(turn) + v * math.cos(turn))
                       for c in element.iterfind('outlines//cornerLocal') for u, v in [(float(c.get('u')), float(c.get('v')))]]
            yield 'sign' if element.get('dynamic') == 'no' else element.tag, element.get('id'), edge, ring(corners) if corners else f'POINT({x:.4f} {y:.4f})'


def degrees_between(a, b):
    return abs(math.degrees(math.remainder(a - b, 2 * math.pi)))


def links(roads):
    """Lanes that are linked to a lane of another road: road, number and whether at its end, road, number and end of the other."""
    for road in roads.values():
        for end, at_end in (('predecessor', False), ('successor', True)):
            link = road.element.find('link/' + end)
            if link is None or link.get('elementType') != 'road':
                continue
            for number, lane in road.lanes.items():
                if lane.find('link/' + end) is not None:
                    yield (road, number, at_end), (roads[link.get('elementId')], int(lane.find('link/' + end).get('id')), link.get('contactPoint') == 'end')


def joints(roads):
    """Gaps, metres and degrees, where lanes are linked."""
    for (road, number, at_end), (other, other_number, other_end) in links(roads):
        x, y, heading, width = road.middle(number, at_end)
        u, v, turned, other_width = other.middle(other_number, other_end)
        ours, theirs = road.corners(number, at_end), other.corners(other_number, other_end)
        apart = min(max(map(math.dist, ours, order)) for order in (theirs, theirs[::-1]))
        yield max(math.hypot(x - u, y - v), abs(width - other_width)), degrees_between(heading, turned + (0 if at_end != other_end else math.pi)), apart


def movements(roads):
    """Connecting roads, and lanes of one edge that go on as lanes of another."""
    joined = sum(1 if road.lanes[number].get('type') == 'bidirectional' else 0.5
                 for (road, number, _), (other, _, _) in links(roads) if None not in (road.edge, other.edge) and road.edge != other.edge)
    return round(joined) + sum(road.edge is None for road in roads.values())


def not_linked_back(roads):
    """Lanes that are linked to a lane of a road without junction that is not linked to them."""
    found = set((a[0].element, *a[1:], b[0].element, *b[1:]) for a, b in links(roads))
    for a, b in links(roads):
        if None not in (a[0].edge, b[0].edge) and (b[0].element, *b[1:], a[0].element, *a[1:]) not in found:
            yield a[0].element.get('id')


def grade_gaps(roads):
    """Differences of height (m) and grade, where connecting roads begin and end."""
    for road in roads.values():
        for end, at_end in (('predecessor', False), ('successor', True)):
            link = road.element.find('link/' + end)
            if link is None or link.get('elementType') != 'road' or not road.heights:
                continue
            other, other_end = roads[link.get('elementId')], link.get('contactPoint') == 'end'
            (z, grade), (y, slope) = (r.height(at) for r, at in ((road, at_end), (other, other_end)))
            yield abs(z - y), abs(grade - slope * (1 if at_end != other_end else -1))


def inner_breaks(roads):
    """Breaks of grade between elevation records."""
    for road in roads.values():
        for before, behind in zip(road.heights, road.heights[1:]):
            yield abs(value([before], 's', float(behind.get('s')))[1] - float(behind.get('b')))


def not_of_junction(roads):
    """Ends of connecting roads at roads that do not lead to their junction."""
    for road in roads.values():
        junction = road.element.get('junction')
        if junction == '-1':
            continue
        for end in ('predecessor', 'successor'):
            link = road.element.find('link/' + end)
            other = roads[link.get('elementId')].element
            back = other.find('link/' + ('successor' if link.get('contactPoint') == 'end' else 'predecessor'))
            if other.get('junction') != '-1' or back is None or (back.get('elementType'), back.get('elementId')) != ('junction', junction):
                yield road.element.get('id')


def tightest(points, over=2.0):
    """The least radius with which a path turns over so many metres."""
    at, stations = 0.0, []
    for (x, y), (u, v) in zip(points, points[1:]):
        side, heading = math.hypot(u - x, v - y), math.atan2(v - y, u - x)
        parts = math.ceil(side)
        for part in range(parts):
            before = stations[-1][1] if stations else heading
            stations.append((at + side * (part + 0.5) / parts, before + math.remainder(heading - before, 2 * math.pi)))
        at += side
    most = max((abs(h - g) / (t - s) for i, (s, g) in enumerate(stations) for t, h in stations[i + 1:] if over <= t - s <= 2 * over), default=0.0)
    return 1 / most if most > 0 else math.inf


def curves(roads, paths):
    """Turns over 45 degrees, their records on average, those with an arc under 2 m for no reason, and roads with one that is over a hundredth too tight for no reason."""
    turns, records, sharp, tight = 0, 0, 0, 0
    for road in roads.values():
        if road.element.get('junction') == '-1':
            continue
        turn = math.degrees(abs(math.remainder(road.at(road.length)[0][2] - road.at(0.0)[0][2], 2 * math.pi)))
        most = max(abs(k) for piece in road.pieces for k in curvatures(piece))
        radius, half_lane = 1 / most if most > 0 else math.inf, max(road.middle(min(road.lanes, key=lambda n: n == 0), end)[3] for end in (False, True)) / 2
        path = tightest(paths.get(road.element.find("userData[@code='interconnection']").get('value'), []))
        turns, records = turns + (turn > 45), records + (turn > 45) * len(road.pieces)
        radius *= 1.01
        sharp += turn > 45 and radius < 2 <= path < math.inf
        tight += radius < max(3, half_lane) <= path < math.inf
    return turns, f'{records / max(turns, 1):.2f}', sharp, tight


def main():
    tree = ElementTree.parse(sys.argv[1])
    roads = {road.get('id'): Road(road) for road in tree.iter('road')}
    offset = tree.find('header/offset')
    east, north = float(offset.get('x')), float(offset.get('y'))
    if '--beside' in sys.argv:
        for row in beside(roads, east, north):
            print(*row, sep='\t')
        return
    if '--curves' in sys.argv:
        with open(sys.argv[sys.argv.index('--curves') + 1], encoding='utf-8') as file:
            paths = {number: [tuple(map(float, point.split())) for point in wkt.strip().removeprefix('LINESTRING(').removesuffix(')').split(',')]
                     for number, wkt in (row.split('\t') for row in file)}
        print(*curves(roads, paths))
        return
    if '--grades' in sys.argv:
        at_joints = list(grade_gaps(roads))
        print(sum(len(road.heights) for road in roads.values()), len(at_joints), f'{max((z for z, _ in at_joints), default=0):.4f}',
              sum(grade > 0.01 for _, grade in at_joints), sum(grade > 0.01 for grade in inner_breaks(roads)))
        return
    if '--lanes' in sys.argv:
        for road in roads.values():
            for number in sorted(road.lanes):
                if road.edge is not None and is_lane(road.lanes[number]):
                    print(road.edge, number, 'POLYGON((' + ','.join(f'{x + east:.4f} {y + north:.4f}' for x, y in road.polygon(number)) + '))', sep='\t')
        return
    chain = [(math.hypot(x - float(b.get('x')), y - float(b.get('y'))), degrees_between(heading, float(b.get('hdg'))))
             for road in roads.values() for a, b in zip(road.pieces, road.pieces[1:]) for x, y, heading in [place(a, float(a.get('length')))]]
    gaps = list(joints(roads))
    # Of a road in two halves, which are joined, the lanes count once.
    edges = {road.edge: road for road in reversed(roads.values()) if road.edge is not None}
    halves = [a for (a, _, _), (b, _, _) in links(roads) if a.edge == b.edge and a is not edges[a.edge]]
    lanes = sum(is_lane(lane) for road in roads.values() if road.edge is not None and not any(road is half for half in halves) for lane in road.lanes.values())
    print(lanes, movements(roads), len(tree.findall('junction')), *(f'{max((g[i] for g in found), default=0):.6f}' for found in (chain, gaps) for i in (0, 1)),
          sum(metres > 0.01 or degrees > 0.1 for metres, degrees, _ in gaps), sum(1 for _ in not_of_junction(roads)) + sum(1 for _ in not_linked_back(roads)),
          sum(apart > 0.01 for *_, apart in gaps), f'{max((apart for *_, apart in gaps), default=0):.3f}')


main()
