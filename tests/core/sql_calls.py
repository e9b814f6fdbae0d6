"""Counts calls between the rooms of SQL that run against their order: sql_calls.py FOLDER.

The file order.txt of FOLDER lists the rooms.  A room may call functions of its own and of the rooms above it in the list.
A call is the name of a function of ours before a parenthesis, in quoted text too but for hints to users.  Prints each
arrow that runs against the order with the functions that are called, then the counts: such arrows of all, and rooms in a
knot.
"""

import re
import sys
from pathlib import Path

MADE = re.compile(r"CREATE (?:OR REPLACE )?(?:FUNCTION|PROCEDURE|AGGREGATE)\s+(?:streetgen|%\d*\$?I|\{model\})\.(\w+)\(")
ASIDE = re.compile(r"--[^\n]*|streetgen\.\w+\(%L|\bHINT = (?:'(?:[^']|'')*'|[^;'])*|^(?:COMMENT ON|REVOKE|GRANT|ALTER) [^;]*?(?:;$|IS\s+(?:'(?:[^']|'')*'\s*)+;)", re.M)
CALL = re.compile(r"(?:\.|\b(?=_))(\w+)\(")


def read_rooms(folder):
    """The rooms in their order, each with the text of its files without comments."""
    rooms = [line.strip() for line in (folder / "order.txt").read_text().splitlines() if re.match("[a-z]", line)]
    return {room: ASIDE.sub("", "\n".join(p.read_text() for p in sorted((folder / room).glob("*.sql")))) for room in rooms}


def find_arrows(rooms):
    """For each pair of rooms (caller, called): the functions that are called."""
    home = {name: room for room, text in rooms.items() for name in MADE.findall(text)}
    arrows = {}
    for room, text in rooms.items():
        for name in set(CALL.findall(MADE.sub("", text))):
            if home.get(name, room) != room:
                arrows.setdefault((room, home[name]), set()).add(name)
    return arrows


def find_knots(rooms, arrows):
    """The rooms from which calls lead back to themselves by way of others."""
    reached = {room: {called for caller, called in arrows if caller == room} for room in rooms}
    for between in rooms:
        for room in rooms:
            if between in reached[room]:
                reached[room] |= reached[between]
    return [room for room in rooms if room in reached[room]]


def main():
    rooms = read_rooms(Path(sys.argv[1]))
    arrows = find_arrows(rooms)
    place = {room: number for number, room in enumerate(rooms)}
    against = {pair: names for pair, names in arrows.items() if place[pair[0]] < place[pair[1]]}
    for (caller, called), names in sorted(against.items(), key=lambda a: (place[a[0][0]], place[a[0][1]])):
        print(f"{caller} calls {called}: {', '.join(sorted(names))}")
    knot = find_knots(rooms, arrows)
    print(f"{len(against)} of {len(arrows)} arrows against the order, {len(knot)} of {len(rooms)} rooms in a knot")


main()
