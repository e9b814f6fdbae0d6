"""Says what pages of the rooms of SQL lack: room_pages.py ROOT.

Each room of sql/order.txt has a README.md of one screen, its own or that of the folder above.  It names each file of the
room that has not a name of every room (sql/README.md lists these), and every path that it names is there.  The page of a
subject names what the subject needs, as the list of subjects says, and the tables that it gives.
"""

import re
import sys
from pathlib import Path

SCREEN = 42


def listed(text, function):
    """The rows of a list, as texts."""
    return re.findall(r"\(\d+, .*?\)(?=,\n| \$\$)", text.split(f"streetgen.{function}()", 1)[1].split("COMMENT ON")[0], re.S)


def faults(root):
    sql = root / "sql"
    usual = set(re.findall(r"`(\w+\.sql)`", (sql / "README.md").read_text()))
    subjects = (sql / "frame/catalogue/subject_order.sql").read_text()
    needs = {m[1]: re.findall(r"\w+", m[2]) for row in listed(subjects, "_subject") if (m := re.match(r"\(\d+, '(\w+)', '\{(.*?)\}'", row))}
    for room in (line for line in (sql / "order.txt").read_text().splitlines() if re.match("[a-z]", line)):
        page = next((p for p in (sql / room / "README.md", (sql / room).parent / "README.md") if p.exists()), None)
        if page is None or page.parent == sql:
            yield f"{room} has no page"
            continue
        text, own = page.read_text(), page.parent == sql / room
        if len(text.splitlines()) > SCREEN:
            yield f"{page} is longer than a screen of {SCREEN} lines"
        for path in re.findall(r"`([\w/.]+\.(?:sql|cpp|sh)|[a-z]\w*/[\w/]+)`", text) + re.findall(r"\]\(([^)]+)\)", text):
            if not (page.parent / path).exists() and not (root / path).exists():
                yield f"{page} names {path}, which is not there"
        for file in sorted((sql / room).glob("*.sql")) if own else []:
            if file.name not in usual and f"`{file.name}`" not in text:
                yield f"{page} does not name {file.name}"
        subject = Path(room).name
        if subject in needs:
            said = re.search(r"\*\*Needs:\*\* (.*?)\.", text)
            for word in needs[subject]:
                if not said or not re.search(rf"\b{word}\b", said[1]):
                    yield f"{page} does not say that {subject} needs {word}"
            for relation in re.findall(r'^CREATE TABLE :"model"\.(\w+)', (sql / room / "table.sql").read_text(), re.M):
                if f"`{relation}`" not in text:
                    yield f"{page} does not name table {relation}"


found = list(faults(Path(sys.argv[1])))
print("\n".join(found))
sys.exit(bool(found))
