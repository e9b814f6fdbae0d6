"""Counts SQL that stands in quoted text: quoted_sql.py FOLDER.

A statement in a string is neither coloured, nor checked, nor run by psql as it stands.  Bodies of functions are statements
of their own and do not count, wherever the function is made.  Prints lines in quoted text that go on over a line's end,
quoted texts of more than five lines, and statements that EXECUTE format puts together; with -v each text over five lines.
"""

import re
import sys
from pathlib import Path

QUOTE = re.compile(r"--[^\n]*|'|\$[A-Za-z_]*\$")
BODY = re.compile(r"(?:(?:FUNCTION|PROCEDURE)\b[^;]*?\bAS|\bDO)\s*$", re.S)


def quoted_texts(text, start=0, end=None):
    """Each quoted text as (start, end, is a body), those within bodies too; pieces of one literal are one text."""
    end = len(text) if end is None else end
    place = start
    while match := QUOTE.search(text, place, end):
        mark = match.group()
        place = match.end()
        if mark.startswith("--"):
            continue
        close = text.index(mark, place)
        while mark == "'" and text[close + 1 : close + 2] == "'":
            close = text.index(mark, close + 2)
        is_body = mark != "'" and bool(BODY.search(text[max(start, match.start() - 2000) : match.start()]))
        yield place, close, is_body
        if is_body:
            yield from quoted_texts(text, place, close)
        place = close + len(mark)


def main():
    lines = long_texts = formats = 0
    for path in sorted(Path(sys.argv[1]).rglob("*.sql")):
        text = path.read_text()
        formats += len(re.findall(r"EXECUTE\s+format\b", text))
        for start, end, is_body in quoted_texts(text):
            over = 0 if is_body else text.count("\n", start, end)
            lines += over
            if over >= 5:
                long_texts += 1
                if "-v" in sys.argv:
                    print(f"{path}:{text.count(chr(10), 0, start) + 1}: {over + 1} lines")
    print(f"{lines} lines in quoted text, {long_texts} texts of more than five lines, {formats} EXECUTE format")


main()
