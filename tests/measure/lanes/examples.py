#!/usr/bin/env -S python3 -B
"""Tags and the lanes that the wiki gives them, as its pages explain: rows "t or f, name"; with a side, a file of such streets instead."""
import sys
from wiki import read

# Tags, lanes along the way and against it, from left to right for who drives there on the right; what both use; words of the doubt.
EXAMPLES = [
    ('highway=primary lanes=4', 'general|general', 'general|general'),
    ('highway=primary lanes=3 lanes:forward=2 lanes:backward=1', 'general|general', 'general'),
    ('highway=primary lanes=3 lanes:both_ways=1', 'general', 'general', 1),
    ('highway=unclassified lanes=1', '', '', 1),
    ('highway=primary oneway=yes lanes=2', 'general|general', ''),
    ('highway=primary oneway=-1 lanes=2', '', 'general|general'),
    ('highway=primary oneway=yes lanes=3 turn:lanes=left|through|right', 'general|general|general', ''),
    ('highway=primary oneway=yes lanes=2 vehicle:lanes=yes|yes|no bicycle:lanes=yes|yes|designated', 'general|general|cycle', ''),
    ('highway=primary oneway=yes lanes=2 vehicle:lanes=yes|no|yes bicycle:lanes=yes|designated|yes', 'general|cycle|general', ''),
    ('highway=primary oneway=yes lanes=3 access:lanes=||no psv:lanes=||designated', 'general|general|bus', ''),
    ('highway=motorway lanes=3 hov:lanes=designated|no|no', 'carpool|general|general', ''),
    ('highway=primary lanes=2 cycleway:right=lane cycleway:left=no', 'general|cycle', 'general'),
    ('highway=primary lanes=2 cycleway:both=lane', 'general|cycle', 'general|cycle'),
    ('highway=primary oneway=yes lanes=1 oneway:bicycle=no cycleway:left=lane cycleway:left:oneway=-1', 'general', 'cycle'),
    ('highway=primary oneway=yes lanes=2 lanes:backward=1 oneway:bus=no', 'general', 'bus'),
    ('highway=secondary lanes=2 parking:both=lane', 'general|parking', 'general|parking'),
    ('highway=secondary lanes=2 parking:both=street_side', 'general', 'general'),
    ('highway=secondary lanes=2 cycleway:right=lane parking:right=lane', 'general|cycle|parking', 'general'),
    ('highway=residential access=no bus=yes lanes=2', 'bus', 'bus'),
    ('highway=service access=private psv=yes lanes=2', 'bus', 'bus'),
    ('highway=residential access=no bus=yes lanes=2 busway:both=lane', 'bus', 'bus'),
    ('highway=residential motor_vehicle=no oneway=yes lanes=2 bus:lanes=designated|designated', 'bus|bus', ''),
    ('highway=primary oneway=yes lanes=3 lanes:psv=1 busway:left=lane', 'bus|general|general', ''),
    ('highway=primary oneway=yes lanes=2 bicycle:lanes=||lane', 'general|general|cycle', ''),
    ('highway=primary oneway=yes lanes=2 bus:lanes=lane|', 'bus|general', ''),
    ('highway=residential motor_vehicle=destination lanes=2', 'general', 'general'),
    ('highway=motorway_link lanes=3 lanes:backward=1', 'general|general', 'general'),
    ('highway=motorway lanes=3 hov=designated hov:lanes=designated|no|no', 'carpool|general|general', ''),
    ('highway=secondary lanes=2 parking:lane:both=parallel parking:lane:both:parallel=on_street', 'general|parking', 'general|parking'),
    ('highway=secondary lanes=2 parking:lane:right=parallel parking:lane:right:parallel=half_on_kerb', 'general', 'general'),
    ('highway=secondary lanes=2 parking:lane:right=parallel parking:right=on_kerb', 'general', 'general'),
    ('highway=secondary lanes=3 lanes:forward=2 turn:lanes:forward=left| cycleway:left=lane cycleway:left:lane=advisory', 'general|general', 'general|cycle'),
    ('highway=primary oneway=yes lanes:forward=3 turn:lanes:forward=left|through|right change:lanes:forward=no|no|no', 'general|general|general', ''),
]
DOUBTS = [
    ('highway=primary lanes=3', 'an odd number of lanes, of no direction'),
    ('highway=primary oneway=yes lanes=3 lanes:psv=1 busway=opposite_lane', 'whether lanes counts an opposite bus lane'),
    ('highway=primary lanes=2 lanes:both_ways=1', 'lanes and directions do not add up'),
    ('highway=primary oneway=yes lanes=2 access:lanes=private|yes', 'a lane that nobody may use'),
    ('highway=motorway_link lanes=2', 'the direction of a motorway link'),
    ('highway=primary lanes=2 turn:lanes=left|through|right', 'a list without direction on a two-way street'),
    ('highway=primary oneway=yes lanes=2 turn:lanes=left|through|right', 'a list of another length than lanes'),
    ('highway=primary oneway=yes turn:lanes=left|right psv:lanes=yes|yes|designated bus:lanes=yes|designated', 'lists of different length'),
]


def tags_of(text):
    return dict(pair.split('=', 1) for pair in text.split())


def mirrored(text):
    """As the same street is tagged where one drives on the left: kerbs and lists change their sides."""
    def turn(pair):
        key, value = pair.split('=', 1)
        parts = [{'left': 'right', 'right': 'left'}.get(part, part) for part in key.split(':')]
        if '|' in value:
            swap = {'left': 'right', 'right': 'left'}
            value = '|'.join(swap.get(entry, entry) for entry in reversed(value.split('|')))
        return f"{':'.join(parts)}={value}"
    return ' '.join(map(turn, text.split()))


def truths():
    for text, forward, backward, *both in EXAMPLES:
        for side in ('right', 'left'):
            said = text if side == 'right' else mirrored(text)
            reading = read(tags_of(said), side)
            rows = [row if side == 'right' else row[::-1] for row in (reading.lanes['forward'], reading.lanes['backward'])]
            holds = ['|'.join(row) for row in rows] == [forward, backward] and reading.both == (both or [0])[0] and not reading.doubts
            yield holds, f'{side}: {said}'
    for text, kind in DOUBTS:
        yield kind in read(tags_of(text), 'right').doubts, f'in doubt: {text}'


def street_file(side):
    """Each example as a street of its own, 200 m apart; three rings say on which side one drives."""
    from math import cos, pi, sin
    nodes, ways = [], []
    def way(points, tags):
        refs = []
        for longitude, latitude in points:
            nodes.append(f'<node id="{len(nodes) + 1}" lat="{latitude:.7f}" lon="{longitude:.7f}"/>')
            refs.append(len(nodes))
        if tags.get('junction'):
            refs.append(refs[0])
        ways.append(f'<way id="{len(ways) + 1}">' + ''.join(f'<nd ref="{ref}"/>' for ref in refs) +
                    ''.join(f'<tag k="{k}" v="{v}"/>' for k, v in tags.items()) + '</way>')
    for i, (text, *_) in enumerate(EXAMPLES):
        tags = tags_of(text if side == 'right' else mirrored(text))
        way([(9, 48 + 0.002 * i), (9.002, 48 + 0.002 * i)], tags)
    for i in range(4):
        turn = 2 * pi / 12 * (1 if side == 'right' else -1)
        way([(9.01 + 0.00027 * cos(turn * k), 48 + 0.002 * i + 0.00018 * sin(turn * k)) for k in range(12)],
            {'highway': 'primary', 'junction': 'roundabout', 'oneway': 'yes'})
    print('<osm version="0.6">', *nodes, *ways, '</osm>', sep='\n')


if __name__ == '__main__':
    if len(sys.argv) > 1:
        street_file(sys.argv[1])
    else:
        for holds, name in truths():
            print('t' if holds else 'f', name, sep='\t')
