"""Says which tags of OpenStreetMap importers read though streetgen.tag_use() has no row of them: tags_read.py ROOT.

Read are tags of ways in SQL (tags ->> 'key', tags ? 'key' and lists named tag), and of all objects in data/osm2pgsql_flex.lua.
src/core/osm has one door to its tags, which holds them to the same table.
"""

import re
import sys
from pathlib import Path

SCOPES = {"process_way": "ways", "process_node": "nodes", "no_crossing": "nodes", "has_lights": "nodes", "insert_crossing_way": "crossings", "process_relation": "relations", "held_for": "relations", "insert_route": "relations",
          "is_area_of_street": "areas", "insert_area": "areas", "standing_class": "nodes", "is_tram_platform": "nodes"}


def expanded(pattern):
    """All keys of a pattern with alternatives in brackets."""
    if not (choice := re.search(r"\[(.*?)\]", pattern)):
        return {pattern}
    return {key for word in choice[1].split("|") for key in expanded(pattern[: choice.start()] + word + pattern[choice.end() :])}


def told(root):
    """Pairs of a scope and a key."""
    core = (root / "src/core/osm/tag_use.cpp").read_text().split("namespace {")[0]
    for first in re.findall(r'\{("[^"]*"(?:\s*"[^"]*")*),\s*"', core):
        yield from (("ways", key) for pattern in "".join(re.findall(r'"([^"]*)"', first)).split(", ") for key in expanded(pattern))
    for scope, keys in re.findall(r"\('OpenStreetMap, (\w+)',\s*'([^']*)'", (root / "sql/source/tag_use.sql").read_text()):
        yield from ((scope, key) for pattern in keys.split(", ") for key in expanded(pattern))


def read_by_sql(root):
    for file in sorted((root / "sql/source").glob("*.sql")):
        text = re.sub(r"--.*", "", file.read_text())
        keys = re.findall(r"\btags (?:->>|\?) '([^']+)'", text)
        keys += [base + way for base in re.findall(r"\btags ->> \('([^']+:)' \|\|", text) for way in ("forward", "backward")]
        for listed in re.findall(r"\btags \?[|&] ARRAY\[(.*?)\]", text, re.S) + re.findall(r"\(VALUES ([^;]*?)\) \w+\(tag\b", text, re.S):
            keys += re.findall(r"'([^']+)'", listed)
        keys += [key for listed in re.findall(r"unnest\('\{(.*?)\}'[^;]*?\) (?:WITH ORDINALITY )?\w+\(tag\b", text, re.S) for key in listed.split(",")]
        yield from (("areas" if file.name == "osm_area.sql" else "ways", key, file) for key in keys)


def read_by_flex(root):
    file = root / "data/osm2pgsql_flex.lua"
    for name, body in re.findall(r"^(?:local )?function (?:osm2pgsql\.)?(\w+)\(.*?\)\n(.*?)^end$", file.read_text(), re.S | re.M):
        keys = re.findall(r"\btags\.(\w+)", body) + re.findall(r"\btags\['([^']+)'\]", body)
        for listed in re.findall(r"ipairs\(\{(.*?)\}\) do\n[^\n]*tags\[key\]", body, re.S):
            keys += re.findall(r"'([^']+)'", listed)
        yield from ((SCOPES.get(name, name), key, file) for key in keys)


def main():
    root = Path(sys.argv[1])
    known, read = set(told(root)), set(read_by_sql(root)) | set(read_by_flex(root))
    missing = sorted(f"{file.relative_to(root)} reads tag {key} of {scope}" for scope, key, file in read if (scope, key) not in known)
    print("\n".join(missing), end="\n" if missing else "")
    # Fewer would be a reader of sources that finds nothing.
    sys.exit(bool(missing) or len(read) < 40)


main()
