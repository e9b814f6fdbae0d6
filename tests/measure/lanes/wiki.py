"""What tags of an OpenStreetMap way say of its lanes, by the pages of its wiki alone, and by nothing of this project.

read(tags, near) gives a Reading: the lanes of each direction from left to right as its driver sees them, the lanes that both use, and the
kinds of doubt that the wiki leaves, each with its page. near is the side that one drives on, 'right' or 'left'.
"""
import re
from dataclasses import dataclass, field

GENERAL, BUS, CARPOOL, CYCLE, PARKING, CLOSED = 'general', 'bus', 'carpool', 'cycle', 'parking', 'closed'
# Of a direction whose number of lanes for cars nobody says.
SOME = 'some'
FORWARD, BACKWARD = 'forward', 'backward'
OTHER = {FORWARD: BACKWARD, BACKWARD: FORWARD, 'left': 'right', 'right': 'left'}

# Kinds of doubt, and the page that leaves them.
PAGES = {
    'an odd number of lanes, of no direction': 'Key:lanes',
    'lanes and directions do not add up': 'Key:lanes',
    'a number of lanes that is none': 'Key:lanes',
    'a list without direction on a two-way street': 'Lanes',
    'a list without direction on a street driven backward': 'Lanes',
    'lists of different length': 'Lanes',
    'a list of another length than lanes': 'Lanes',
    'a lane that nobody may use': 'Lanes',
    'bicycle:lanes=designated, and cars not barred': 'Key:access',
    'a number of bus lanes without a place': 'Key:lanes:*',
    'a bus lane beside lists that have none': 'Key:busway',
    'whether lanes counts an opposite bus lane': 'Key:busway',
    'an opposite lane of a two-way street': 'Key:busway',
    'who drives on a contraflow lane': 'Key:oneway',
    'a cycle lane for both directions': 'Key:cycleway',
    'the direction of a cycle lane where bicycles go both ways': 'Key:oneway:bicycle',
    'a cycle lane that turn:lanes counts or not': 'Lanes',
    'parking beside a contraflow lane': 'Street parking',
    'where parking lies': 'Street parking',
    'a street whose direction changes': 'Key:oneway',
    'the direction of a motorway link': 'Tag:highway=motorway_link',
}
# Values of lists that say who may use a lane; an empty one says nothing of it.
ACCESS = ('access', 'vehicle', 'motor_vehicle')
SHARED = ('bus', 'psv', 'taxi')
LISTS = ACCESS + SHARED + ('bicycle', 'hov', 'cycleway', 'turn')
USED = ('yes', 'designated', 'official', 'permissive')


@dataclass
class Reading:
    states: bool = False
    lanes: dict = field(default_factory=lambda: {FORWARD: [], BACKWARD: []})
    turns: dict = field(default_factory=lambda: {FORWARD: None, BACKWARD: None})
    both: int = 0
    doubts: set = field(default_factory=set)

    def doubt(self, kind):
        assert kind in PAGES, kind
        self.doubts.add(kind)


def direction_of(tags, reading):
    """FORWARD or BACKWARD of a one-way street, None of one of both ways."""
    oneway = tags.get('oneway')
    if oneway in ('yes', 'true', '1'):
        return FORWARD
    if oneway in ('-1', 'reverse'):
        return BACKWARD
    if oneway in ('reversible', 'alternating'):
        reading.doubt('a street whose direction changes')
    if oneway is None:
        if tags.get('junction') in ('roundabout', 'circular') or tags.get('highway') == 'motorway' and 'lanes:backward' not in tags:
            return FORWARD
        if tags.get('highway') == 'motorway_link' and 'lanes:backward' not in tags:
            reading.doubt('the direction of a motorway link')
    return None


def number(tags, key, reading):
    value = tags.get(key)
    if value is None:
        return None
    if not re.fullmatch(r'\d+', value.strip()):
        reading.doubt('a number of lanes that is none')
        return None
    return int(value)


def lists_of(tags, direction, oneway, count, reading):
    """The lists that speak of a direction, by key."""
    lists = {}
    for key in LISTS:
        value = tags.get(f'{key}:lanes:{direction}')
        plain = tags.get(f'{key}:lanes')
        if value is None and plain is not None:
            if oneway is None:
                reading.doubt('a list without direction on a two-way street')
                # The likelier reading is that each direction has it, where it is as long as that.
                if len(plain.split('|')) == count:
                    value = plain
            elif oneway == BACKWARD:
                reading.doubt('a list without direction on a street driven backward')
            elif direction == oneway:
                value = plain
        if value is not None:
            lists[key] = [entry.strip() for entry in value.split('|')]
    return lists


def kind_in(lists, i, reading):
    """The kind of the lane at place i."""
    def at(key):
        return lists[key][i] if key in lists and i < len(lists[key]) else ''
    barred = any(at(key) in ('no', 'private') for key in ACCESS)
    if at('cycleway') in ('lane', 'exclusive', 'advisory') or at('bicycle') == 'lane':
        return CYCLE
    if any(at(key) in ('designated', 'lane') or barred and at(key) in USED for key in SHARED):
        return BUS
    if at('hov') in ('designated', 'lane'):
        return CARPOOL
    if barred and at('bicycle') in USED:
        return CYCLE
    if at('bicycle') == 'designated':
        reading.doubt('bicycle:lanes=designated, and cars not barred')
    if barred:
        # The likelier reading is that nobody drives there.
        reading.doubt('a lane that nobody may use')
        return CLOSED
    return GENERAL


def listed(tags, direction):
    """How many lanes for motor traffic the lists of a direction have, where they agree."""
    lists = {key: tags[name].split('|') for key in LISTS for name in [f'{key}:lanes:{direction}'] if name in tags}
    if len({len(entries) for entries in lists.values()}) != 1:
        return None
    return sum(kind_in(lists, i, Reading()) != CYCLE for i in range(len(next(iter(lists.values())))))


def counts(tags, oneway, reading):
    """Lanes for motor traffic of each direction where the tags say them, else None."""
    total = number(tags, 'lanes', reading)
    stated = {d: number(tags, f'lanes:{d}', reading) for d in (FORWARD, BACKWARD)}
    both = number(tags, 'lanes:both_ways', reading)
    if both is None:
        both = 1 if tags.get('centre_turn_lane') == 'yes' or tags.get('turn:lanes:both_ways') else 0
    reading.both = both
    reading.states |= total is not None or both > 0 or any(n is not None for n in stated.values())
    if total is None:
        return stated
    left = total - both
    if tags.get('oneway') in ('reversible', 'alternating'):
        # The likelier reading is that all lanes are driven in turns.
        reading.both = total
        return {FORWARD: 0, BACKWARD: 0}
    if oneway is None and list(stated.values()) == [None, None]:
        said = {d: listed(tags, d) for d in stated}
        if None not in said.values() and sum(said.values()) == left:
            stated = said
        elif list(said.values()).count(None) == 1:
            stated = {d: n if n is not None and n < left else None for d, n in said.items()}
    if oneway is not None:
        if stated[oneway] is None:
            stated[oneway] = left - (stated[OTHER[oneway]] or 0)
        elif stated[oneway] + (stated[OTHER[oneway]] or 0) != left:
            reading.doubt('lanes and directions do not add up')
        if stated[oneway] < 1:
            reading.doubt('lanes and directions do not add up')
        return stated
    known = [d for d in stated if stated[d] is not None]
    if len(known) == 2:
        if sum(stated.values()) != left:
            reading.doubt('lanes and directions do not add up')
    elif len(known) == 1:
        stated[OTHER[known[0]]] = left - stated[known[0]]
        if stated[OTHER[known[0]]] < 0:
            reading.doubt('lanes and directions do not add up')
    elif left % 2 and reading.both:
        # The likelier reading is that lanes leaves out the lane in the middle.
        reading.doubt('lanes and directions do not add up')
        stated[FORWARD] = stated[BACKWARD] = (left + 1) // 2
    elif left == 1:
        # A narrow road, on which both directions use one lane.
        reading.both += 1
        stated[FORWARD] = stated[BACKWARD] = 0
    elif left % 2:
        # The likelier reading is that those in the middle turn off.
        reading.doubt('an odd number of lanes, of no direction')
        reading.both += 1
        stated[FORWARD] = stated[BACKWARD] = left // 2
    elif left < 1:
        reading.doubt('lanes and directions do not add up')
    else:
        stated[FORWARD] = stated[BACKWARD] = left // 2
    return stated


def motor_lanes(tags, direction, oneway, count, reading):
    """The lanes of a direction as lists and numbers say them: with the cycle lanes of lists, without those of sides."""
    lists = lists_of(tags, direction, oneway, count, reading)
    turns = lists.pop('turn', None)
    lengths = {len(entries) for entries in lists.values()}
    if len(lengths) > 1:
        reading.doubt('lists of different length')
    lanes = [kind_in(lists, i, reading) for i in range(max(lengths, default=0))]
    reading.states |= bool(lists) or turns is not None
    motor = sum(kind != CYCLE for kind in lanes)
    if lanes and count is not None and motor != count:
        reading.doubt('a list of another length than lanes')
    if not lanes:
        if count is None and turns is not None:
            count = len(turns)
        lanes = [SOME] if count is None else [GENERAL] * count
        motor = len(lanes)
    if turns is not None:
        if len(turns) == len(lanes):
            turns = [turn for turn, kind in zip(turns, lanes) if kind != CYCLE]
        elif len(turns) != motor:
            cycle = any(tags.get(key) in ('lane', 'opposite_lane') for key in ('cycleway', 'cycleway:left', 'cycleway:right', 'cycleway:both'))
            reading.doubt('a cycle lane that turn:lanes counts or not' if cycle else 'a list of another length than lanes')
        reading.turns[direction] = turns
    return lanes


def of_side(tags, key, side, default_sides):
    """The value of a key on a side of the way."""
    for name in (f'{key}:{side}', f'{key}:both'):
        if name in tags:
            return tags[name]
    return tags.get(key) if side in default_sides else None


def place(side, oneway, near):
    """The direction whose lanes lie on a side of the way, and whether they lie at its right end."""
    if oneway is None:
        return (FORWARD if side == near else BACKWARD), near == 'right'
    return oneway, (side == 'right') == (oneway == FORWARD)


def put(lanes, kind, at_right):
    lanes.insert(len(lanes) if at_right else 0, kind)


def bus_sides(tags, direction, oneway, near):
    """The sides whose bus lanes a number of bus lanes of a direction counts; on a one-way street that of the way counts those against it too."""
    ways = (near,) if oneway == FORWARD else (OTHER[near],) if oneway == BACKWARD else ('left', 'right')
    said = {side: of_side(tags, 'busway', side, ways) for side in ('left', 'right')}
    if tags.get('busway') == 'opposite_lane' and oneway is not None:
        said[OTHER[ways[0]]] = 'opposite_lane'
    return [side for side, value in said.items() if value == 'opposite_lane' or value == 'lane' and place(side, oneway, near)[0] == direction]


def add_buses(tags, oneway, near, counted, reading):
    lanes = reading.lanes
    for direction in (FORWARD, BACKWARD):
        buses = None
        for key in ('lanes:psv', 'lanes:bus'):
            for name in [f'{key}:{direction}'] + ([key] if direction == oneway else []):
                if buses is None and name in tags:
                    buses = number(tags, name, reading)
        if buses:
            reading.states = True
            # Tags of the sides say where the lanes are that are counted.
            if BUS in lanes[direction] or buses == len(bus_sides(tags, direction, oneway, near)):
                continue
            general = lanes[direction].count(GENERAL)
            if general == buses:
                lanes[direction][:] = [BUS if kind == GENERAL else kind for kind in lanes[direction]]
            else:
                # The likelier place is the kerb.
                reading.doubt('a number of bus lanes without a place')
                places = [i for i, kind in enumerate(lanes[direction]) if kind == GENERAL]
                for i in places[-buses:] if near == 'right' else places[:buses]:
                    lanes[direction][i] = BUS
    if oneway is None and number(tags, 'lanes:psv', reading) or oneway is None and number(tags, 'lanes:bus', reading):
        if not any(BUS in lanes[d] for d in lanes):
            reading.doubt('a number of bus lanes without a place')
    ways = (near,) if oneway == FORWARD else (OTHER[near],) if oneway == BACKWARD else ('left', 'right')
    for side in ('left', 'right'):
        value = of_side(tags, 'busway', side, ways)
        if value is None and oneway is not None and side not in ways and tags.get('busway') == 'opposite_lane':
            value = 'opposite_lane'
        if value == 'opposite_lane':
            reading.states = True
            if oneway is None:
                reading.doubt('an opposite lane of a two-way street')
            elif BUS not in lanes[OTHER[oneway]]:
                if counted and not lanes[OTHER[oneway]]:
                    reading.doubt('whether lanes counts an opposite bus lane')
                lanes[OTHER[oneway]] = [BUS]
        elif value == 'lane':
            reading.states = True
            direction, at_right = place(side, oneway, near)
            row = lanes[direction]
            if BUS in row or kind_of_all(tags) == BUS:
                continue
            if SOME in row:
                put(row, BUS, at_right)
            elif any(f'{key}:lanes{suffix}' in tags for key in SHARED + ACCESS for suffix in ('', ':' + direction)):
                reading.doubt('a bus lane beside lists that have none')
            else:
                outer = [i for i, kind in enumerate(row) if kind != CYCLE]
                if len(outer) < 2:
                    reading.doubt('a number of bus lanes without a place')
                else:
                    row[outer[-1] if at_right else outer[0]] = BUS


def add_cycle_lanes(tags, oneway, near, reading):
    listed = {d for d in reading.lanes if CYCLE in reading.lanes[d]}
    both_ways = tags.get('oneway:bicycle') == 'no'
    ways = (near,) if oneway == FORWARD else (OTHER[near],) if oneway == BACKWARD else ('left', 'right')
    seen = set()
    # Values are parted by semicolons (wiki: Semi-colon value separator).
    said = ((side, value) for side in ('left', 'right') for value in (of_side(tags, 'cycleway', side, ways) or '').split(';'))
    for side, value in said:
        if value not in ('lane', 'soft_lane', 'opposite_lane'):
            continue
        reading.states = True
        direction, at_right = place(side, oneway, near)
        goes = of_side(tags, f'cycleway:{side}', 'oneway', ()) or tags.get('cycleway:both:oneway')
        if goes == 'no':
            reading.doubt('a cycle lane for both directions')
        if value == 'opposite_lane' and oneway is None:
            reading.doubt('an opposite lane of a two-way street')
        against = value == 'opposite_lane' or oneway is not None and goes == '-1'
        if against and oneway is not None:
            if not reading.lanes[OTHER[oneway]] or CYCLE not in reading.lanes[OTHER[oneway]]:
                put(reading.lanes[OTHER[oneway]], CYCLE, near == 'right')
            continue
        if goes == '-1' or oneway is not None and both_ways and goes is None and ('cycleway:both' in tags or side != ways[0] or 'cycleway' in tags):
            reading.doubt('the direction of a cycle lane where bicycles go both ways')
            if goes is None and side not in ways and CYCLE not in reading.lanes[OTHER[oneway]]:
                # The likelier reading is that a lane on the far side goes against the traffic.
                put(reading.lanes[OTHER[oneway]], CYCLE, near == 'right')
                continue
        if direction in listed or (direction, at_right) in seen:
            continue
        seen.add((direction, at_right))
        put(reading.lanes[direction], CYCLE, at_right)


def add_parking(tags, oneway, near, reading):
    for side in ('left', 'right'):
        value = of_side(tags, 'parking', side, ())
        old = of_side(tags, 'parking:lane', side, ())
        if value is None and old in ('parallel', 'diagonal', 'perpendicular'):
            how = tags.get(f'parking:lane:{side}:{old}', tags.get(f'parking:lane:both:{old}', 'on_street'))
            value = {'on_street': 'lane', 'painted_area_only': 'lane'}.get(how, how)
        elif value is None and old in ('marked', 'yes'):
            value = 'yes'
        if value == 'yes':
            reading.doubt('where parking lies')
            reading.states = True
        elif value == 'lane':
            reading.states = True
            direction, at_right = place(side, oneway, near)
            if oneway is not None and reading.lanes[OTHER[oneway]]:
                reading.doubt('parking beside a contraflow lane')
            put(reading.lanes[direction], PARKING, at_right)


def kind_of_all(tags):
    """The kind of the lanes of a way that is shut to other cars, where it is."""
    shut = any(tags.get(key) in ('no', 'private') for key in ACCESS)
    listed = any('designated' in value.split('|') for key, value in tags.items() if re.match('(bus|psv|taxi):lanes', key))
    if tags.get('highway') == 'busway' or shut and (listed or any(tags.get(key) in USED for key in ('bus', 'psv'))):
        return BUS
    if tags.get('hov') == 'designated' or any(tags.get(key) == 'hov' for key in ACCESS):
        return CARPOOL
    return GENERAL


def read(tags, near):
    reading = Reading()
    oneway = direction_of(tags, reading)
    stated = counts(tags, oneway, reading)
    counted = 'lanes' in tags
    for direction in (FORWARD, BACKWARD):
        if oneway in (None, direction) or stated[direction] or any(f'{key}:lanes:{direction}' in tags for key in LISTS):
            reading.lanes[direction] = motor_lanes(tags, direction, oneway, stated[direction], reading)
    if oneway is not None:
        other = reading.lanes[OTHER[oneway]]
        if GENERAL in other:
            if tags.get('oneway:bus') == 'no' or tags.get('oneway:psv') == 'no':
                other[:] = [BUS if kind == GENERAL else kind for kind in other]
            elif not any(name in tags for name in (f'lanes:{key}:{OTHER[oneway]}' for key in ('psv', 'bus'))):
                reading.doubt('who drives on a contraflow lane')
    add_buses(tags, oneway, near, counted, reading)
    for row in reading.lanes.values():
        # A list says which lanes are those of carpools.
        general = GENERAL if CARPOOL in row else kind_of_all(tags)
        row[:] = [general if kind == GENERAL else kind for kind in row]
    add_cycle_lanes(tags, oneway, near, reading)
    for direction, row in reading.lanes.items():
        turns = reading.turns[direction]
        if turns is not None and CYCLE in row and len(turns) == len(row):
            # The likelier reading is that a list as long as all lanes counts them.
            reading.turns[direction] = [turn for turn, kind in zip(turns, row) if kind != CYCLE]
    add_parking(tags, oneway, near, reading)
    return reading
