#!/usr/bin/env -S python3 -B
"""Lanes of a model against what the wiki says of the tags: compare.py SIDE WAYS.opl AXES NAMED [SHOWN] prints figures, and so many ways that are neither; exit 1 where there are any.

AXES has a JSON object a line: source_ref, the kinds and turns of each direction, lanes_both. NAMED has a way a line that the import named.
"""
import collections
import json
import re
import sys
from wiki import BACKWARD, BUS, CYCLE, FORWARD, GENERAL, PAGES, PARKING, SOME, read


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


def differences(reading, axis):
    for direction in (FORWARD, BACKWARD):
        if not fits(reading.lanes[direction], made(axis, direction)):
            yield f"{direction} {'|'.join(reading.lanes[direction]) or '-'} is {'|'.join(made(axis, direction)) or '-'}"
        elif not turns_fit(reading.turns[direction], axis, direction):
            yield f"{direction} turns {'|'.join(reading.turns[direction])} are {axis['turn_' + direction] or '-'}"
    if reading.both != (axis['lanes_both'] or 0):
        yield f"for both directions {reading.both} is {axis['lanes_both'] or 0}"


def spoken(tags):
    return ' '.join(f'{k}={v}' for k, v in sorted(tags.items())
                    if re.search(r'lane|oneway|busway|cycleway|parking:|^junction$|^highway$|^(access|vehicle|motor_vehicle|bus|psv)$', k))


def main():
    side, opl, axes_path, named_path = sys.argv[1:5]
    shown = int(sys.argv[5]) if len(sys.argv) > 5 else 20
    with open(axes_path, encoding='utf-8') as lines:
        axes = {axis['source_ref']: axis for axis in map(json.loads, lines)}
    with open(named_path, encoding='utf-8') as lines:
        named = set(lines.read().split())
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
        if reading.doubts:
            figures['ambiguous'] += 1
            figures['ambiguous and equal to the likelier reading'] += not said
            figures['ambiguous and named'] += bool(said) and ref in named
            doubts.update(reading.doubts)
        elif not said:
            figures['equal'] += 1
        elif ref in named:
            figures['named'] += 1
        else:
            figures['neither'] += 1
            neither.append((ref, said, tags))
    for name in ('state lanes', 'equal', 'named', 'ambiguous', 'ambiguous and equal to the likelier reading', 'ambiguous and named', 'neither'):
        print(f'{figures[name]:6}  {name}')
    for kind, count in doubts.most_common():
        print(f'{count:6}  ambiguous: {kind} (wiki: {PAGES[kind]})')
    for ref, said, tags in neither[:shown]:
        print(f"way {ref}: {'; '.join(said)}   [{spoken(tags)}]")
    return 1 if figures['neither'] else 0


if __name__ == '__main__':
    sys.exit(main())
