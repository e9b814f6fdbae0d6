#!/usr/bin/env -S python3 -B
"""Lanes of a model against what the wiki says of the tags: compare.py SIDE WAYS.opl AXES NAMED [SHOWN] prints figures, and so many ways that are neither; exit 1 where there are any.

AXES has a JSON object a line: source_ref, the kinds and turns of each direction, lanes_both. NAMED has a way a line that the import named: source_ref, a tab, and
the tags that it did not understand. A tag excuses no lanes but those that it speaks of.
"""
import collections
import json
import re
import sys
from wiki import BACKWARD, BUS, CARPOOL, CYCLE, FORWARD, GENERAL, OTHER, PAGES, PARKING, SOME, read


def ways_of(path):
    """The ways of a file in OPL: id and tags."""
    def plain(text):
        return re.sub('%([0-9a-f]+)%', lambda m: chr(int(m[1], 16)), text)
    with open(path, encoding='utf-8') as lines:
        for line in lines:
            fields = line.rstrip('\n').split(' ')
            if fields[0].startswith('w'):
                tags = next((f[1:] for f in fields if f.startswith('T')), '')
                yield fields[0][1:], dict(map(plain, pair.split('=', 1)) for pair in tags.split(',') if pair)


def made(axis, direction):
    """Kinds of all lanes of a direction of an axis."""
    kinds = axis['kind_' + direction]
    return kinds.split('|') if kinds else [GENERAL] * (axis['lanes_' + direction] or 0)


def fits(wanted, got):
    """Whether lanes are those wanted, of which SOME stands for one or more lanes of cars."""
    if SOME not in wanted:
        return wanted == got
    i = wanted.index(SOME)
    after = len(wanted) - i - 1
    inner = got[i:len(got) - after]
    return got[:i] == wanted[:i] and got[len(got) - after:] == wanted[i + 1:] and len(inner) >= 1 and set(inner) <= {GENERAL, BUS}


def turns_fit(wanted, axis, direction):
    if wanted is None:
        return True
    def plain(turns):
        return [';'.join(sorted(t for t in turn.split(';') if t not in ('none', ''))) for turn in turns]
    got = axis['turn_' + direction]
    got = got.split('|') if got else []
    kinds = made(axis, direction)
    if len(got) == len(kinds):
        got = [turn for turn, kind in zip(got, kinds) if kind not in (CYCLE, PARKING)]
    return plain(wanted) == plain(got) or not got and not any(plain(wanted))


# Tags that may speak of any lane, and those of lanes of one kind.
ANY_LANE = r'lanes(:forward|:backward)?|\w+:lanes(:forward|:backward)?|(access|vehicle|motor_vehicle)(:forward|:backward)?|oneway|highway|junction'
OF_KIND = {CYCLE: 'cycle', PARKING: 'parking', BUS: 'bus|psv|taxi', CARPOOL: 'hov'}


def excuses(tag, part):
    """Whether a tag speaks of a part of a way: a direction, and turns or the kinds of the lanes that differ; or the lanes of both directions."""
    direction, kinds = part
    if direction == 'both':
        return bool(re.fullmatch(r'lanes(:.*)?|turn:lanes:both_ways|centre_turn_lane', tag))
    if f':{OTHER[direction]}' in tag:
        return False
    if kinds is None or tag.startswith('turn:'):
        # A list of turns says how many lanes there are, and not of what kind.
        return tag.startswith('turn:') and (kinds is None or SOME in kinds)
    return bool(re.fullmatch(ANY_LANE, tag)) or any(re.search(OF_KIND[kind], tag) for kind in kinds if kind in OF_KIND)


def differences(reading, axis):
    """What differs, with the part of the way that it is about."""
    for direction in (FORWARD, BACKWARD):
        wanted, got = reading.lanes[direction], made(axis, direction)
        if not fits(wanted, got):
            kinds = {kind for kind in {*wanted, *got} if wanted.count(kind) != got.count(kind)} or {*wanted}
            if len(wanted) != len(got):
                kinds.add(SOME)
            yield f"{direction} {'|'.join(wanted) or '-'} is {'|'.join(got) or '-'}", (direction, kinds)
        elif not turns_fit(reading.turns[direction], axis, direction):
            yield f"{direction} turns {'|'.join(reading.turns[direction])} are {axis['turn_' + direction] or '-'}", (direction, None)
    if reading.both != (axis['lanes_both'] or 0):
        yield f"for both directions {reading.both} is {axis['lanes_both'] or 0}", ('both', None)


def spoken(tags):
    return ' '.join(f'{k}={v}' for k, v in sorted(tags.items())
                    if re.search(r'lane|oneway|busway|cycleway|parking:|^junction$|^highway$|^(access|vehicle|motor_vehicle|bus|psv)$', k))


def main():
    side, opl, axes_path, named_path = sys.argv[1:5]
    shown = int(sys.argv[5]) if len(sys.argv) > 5 else 20
    with open(axes_path, encoding='utf-8') as lines:
        axes = {axis['source_ref']: axis for axis in map(json.loads, lines)}
    with open(named_path, encoding='utf-8') as lines:
        named = {ref: tags.split() for ref, tags in (line.rstrip('\n').split('\t') for line in lines)}
    # A model that nobody told the side drives on the right.
    side = 'left' if side == 'left' else 'right'
    figures = collections.Counter()
    doubts = collections.Counter()
    neither = []
    for ref, tags in ways_of(opl):
        if ref not in axes:
            continue
        reading = read(tags, side)
        if not reading.states:
            continue
        figures['state lanes'] += 1
        said = list(differences(reading, axes[ref]))
        excused = all(any(excuses(tag, part) for tag in named.get(ref, ())) for _, part in said)
        doubts.update(reading.doubts)
        figures['ambiguous'] += bool(reading.doubts)
        figures[('ambiguous and ' if reading.doubts else '') + ('equal' if not said else 'named' if excused else 'neither')] += 1
        if not excused:
            neither.append((ref, reading.doubts, [what for what, _ in said], named.get(ref, ()), tags))
    for name in ('state lanes', 'equal', 'named', 'neither', 'ambiguous', 'ambiguous and equal', 'ambiguous and named', 'ambiguous and neither'):
        print(f'{figures[name]:6}  {name}')
    for kind, count in doubts.most_common():
        print(f'{count:6}  ambiguous: {kind} (wiki: {PAGES[kind]})')
    for ref, kinds, said, told, tags in neither[:shown]:
        print(f"way {ref}: {'; '.join(said)}   [{spoken(tags)}]{'   named: ' + ' '.join(told) if told else ''}{'   ambiguous: ' + ', '.join(sorted(kinds)) if kinds else ''}")
    return 1 if neither else 0


if __name__ == '__main__':
    sys.exit(main())
