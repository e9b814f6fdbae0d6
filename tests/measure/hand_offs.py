"""Counts hand-offs between files of SQL: hand_offs.py FOLDER SUBJECTS, with the functions that ran on standard input.

A line of the input is the name of a function, how often it ran, and its language.  A hand-off is a pair of files: a function
of the one that ran names a function of the other that ran.  Prints a row of a table.
"""

import re
import sys
from pathlib import Path

MADE = re.compile(r"(?:CREATE (?:OR REPLACE )?FUNCTION\s+(?:(?:streetgen|%\d*\$?I|\{model\})\.)?|_compose_function\(model,\s*')(\w+)\(")
NOTE = re.compile(r"--[^\n]*|^COMMENT ON [^;]*?IS\s+(?:'(?:[^']|'')*'\s*)+;", re.M)


def read_functions(folder):
    """For each function: its file, and the text from its head to that of the next one."""
    functions = {}
    for path in sorted(folder.rglob("*.sql")):
        text = NOTE.sub("", path.read_text())
        heads = list(MADE.finditer(text))
        for head, after in zip(heads, heads[1:] + [None]):
            file, body = functions.get(head[1], (path, ""))
            functions[head[1]] = file, body + text[head.end() : after.start() if after else len(text)]
    return functions


def main():
    functions = read_functions(Path(sys.argv[1]))
    ran = [line.rstrip("\n").split("\t") for line in sys.stdin]
    ours = {name for name, _, _ in ran}
    files = {name: functions[name][0] for name in ours if name in functions}
    handed = {(files[caller], files[called]) for caller in files for called in files
              if files[caller] != files[called] and re.search(rf"\b{called}\(|'{called}'", functions[caller][1])}
    in_c = [int(calls) for _, calls, language in ran if language == "c"]
    print(f"| {sys.argv[2]} | {len(ours)} | {len(in_c)} | {sum(int(calls) for _, calls, _ in ran)} | {sum(in_c)}"
          f" | {len(set(files.values()))} | {len(handed)} |")
    print(*sorted(ours - set(files)), file=sys.stderr)


main()
