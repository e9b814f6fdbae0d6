#!/usr/bin/env python3
"""Colours that stand outside streetgen.symbol_rule: colours.py ROOT prints each with its place, and last their count.

Colours are codes (#rrggbb and its short and long forms, rgb and hsl with numbers in them) and names given to an attribute of a drawing, in sql, data and
tests/measure. What INSERT statements put into the table is where colours belong. A hue or a shade that is computed is no code.
"""
import pathlib
import re
import sys

CODE = r"(?<![&\w{$])#(?:[0-9a-fA-F]{8}|[0-9a-fA-F]{6}|[0-9a-fA-F]{3,4})\b|\b(?:rgb|hsl)a?\(\s*\d"
NAME = (r"\b(?:fill|stroke|background|colou?r|stop-color)[a-z_]*\\?[\"']?\s*(?:=>|[:=,(])\s*\\?[\"']?"
        r"(?:black|white|gr[ae]y|silver|red|green|blue|orange|yellow|purple|violet|pink|brown|navy|teal|gold|(?:light|dark|medium)[a-z]+)\b")
RULES = re.compile(r"^INSERT INTO streetgen\.symbol_rule\b.*?;$", re.S | re.M)


def colours(path):
    text = path.read_text(encoding="utf-8", errors="replace")
    if path.suffix == ".sql":
        text = RULES.sub(lambda rules: "\n" * rules.group(0).count("\n"), text)
    for number, line in enumerate(text.splitlines(), 1):
        for match in re.finditer(f"{CODE}|{NAME}", line):
            yield f"{path}:{number}: {match.group(0)}"


root = pathlib.Path(sys.argv[1])
files = [path for folder in ("sql", "data", "tests/measure") for path in sorted((root / folder).rglob("*")) if path.is_file() and path.suffix not in (".pyc", ".png")]
found = [colour for path in files for colour in colours(path)]
print("\n".join(found + [f"{len(found)} outside the table"]))
