#!/usr/bin/env bash
# layers_test.sh ROOT MODULE: the layer rules of docs/development/architecture.md, a line "t|f what" each.
root=$1 module=$2
rule() { if eval "$2"; then echo "t $1"; else echo "f $1"; fi; }

# The floors of src/core, from the ground up.  A folder may include itself and the floors below its own.
floors=(
  'support'
  'geometry'
  'measure network road height overpass mesh object design virtual_city osm fit forest'
  'layout block roundabout'
  'ramp strip footway'
  'roadway sidewalk'
  'ownership lane'
  'kerb interconnection'
  'junction'
  'signal simulation'
  'pipeline driving'
)

# upward_includes: each include of src/core that does not lead down, and each folder without a floor.
upward_includes() {
  local -A floor_of
  local floor folder file included from to
  for floor in "${!floors[@]}"; do
    for folder in ${floors[$floor]}; do floor_of[$folder]=$floor; done
  done
  while IFS=: read -r file included; do
    file=${file#"$root/src/core/"}
    from=${file%%/*} to=${included%%/*}
    [ "$to" = streetgen ] || [ "$from" = "$to" ] && continue
    [ -n "${floor_of[$from]:-}" ] && [ -n "${floor_of[$to]:-}" ] && [ "${floor_of[$to]}" -lt "${floor_of[$from]}" ] ||
      echo "$file includes $included"
  done < <(grep -rE '^#include "' "$root/src/core" | sed 's/#include "\([^"]*\)"/\1/')
}

rule 'folders of the core include the floors below them alone' '! upward_includes | grep . >&2'
# circles: units (a header with its source file) that include each other, directly or by others.
circles() {
  grep -rE '^#include "' "$root/src/core" | sed "s:^$root/src/core/::; s/\.[ch]pp:#include \"/ /; s/\.hpp\"//" | awk '$1 != $2' | tsort 2>&1 >/dev/null
}
rule 'no units of the core include each other in a circle' '! circles | grep . >&2'
rule 'the core names no database' '! grep -rnE "postgres\.h|fmgr\.h|ereport|palloc|SPI_|libpq" "$root/include" "$root/src/core" >&2'
rule 'the border names no geometry library and no SPI' '! grep -rnE "geos_c\.h|<CGAL/|<Eigen/|<boost/|SPI_" "$root/src/pg" >&2'
rule 'public headers use std alone' '! grep -rnE "#include [<\"](geos|CGAL|Eigen|boost|postgres)" "$root/include" >&2'
rule 'the module exports its SQL functions alone' '! nm -D --defined-only "$module" | awk "{print \$3}" | grep -vE "^(Pg_magic_func|pg_finfo_streetgen_.*|streetgen_.*)$" >&2'

# Names of types that more than one header defines: two definitions of one name are one type to the linker.
types_defined_twice() {
  sed -nE 's/^(struct|class|union|enum|enum class) ([A-Za-z_0-9]+)( final)?( *:[^:].*)? *\{.*/\2/p' "$root"/src/core/*/*.hpp "$root"/src/pg/*/*.hpp \
    "$root"/include/streetgen/*.hpp | sort | uniq -d
}
rule 'no two headers define a type of the same name' '! types_defined_twice | grep . >&2'
for header in "$root"/include/streetgen/*.hpp; do
  rule "$(basename "$header") compiles alone" 'g++ -std=c++17 -fsyntax-only -x c++ -I"$root/include" -include "$header" /dev/null'
done
rule 'lines of SQL end at 120 characters' '! awk "length > 120 { print FILENAME \":\" FNR }" "$root"/sql/*/*.sql "$root"/sql/*/*/*.sql | grep . >&2'

# Statements stand in strings only where names or pieces of them vary.  The counts only fall.
quoted=$(python3 "$root/tests/core/quoted_sql.py" "$root/sql")
rule 'SQL in quoted text: at most 290 lines, no text of more than five lines and 120 EXECUTE format' \
  '[[ $quoted =~ ^([0-9]+)\ lines[^,]*,\ ([0-9]+)\ texts[^,]*,\ ([0-9]+)\  ]] && [ "${BASH_REMATCH[1]}" -le 290 ] && [ "${BASH_REMATCH[2]}" -le 0 ] && [ "${BASH_REMATCH[3]}" -le 120 ] || { echo "$quoted" >&2; false; }'

# The frame serves every subject and names none: a subject gives to its lists by functions that are found by their names.  The list of subjects
# itself is not counted.  The count only falls; the aim is 0.
words_of_subjects='kerb|sidewalk|block|ramp|roundabout|junction|signal|overpass|bridge|interconnection|marking'
named=$(find "$root/sql/frame" -name '*.sql' ! -name subject_order.sql -exec cat {} + | sed 's/pg_blocking_pids//g' | grep -oiE "$words_of_subjects" | wc -l)
rule 'sql/frame names subjects at most 6 times' '[ "$named" -le 6 ] || { grep -rnoiE "$words_of_subjects" "$root/sql/frame" | cut -d: -f1,3 | sort | uniq -c >&2; false; }'

# Rooms of SQL call those above them in sql/order.txt.
called=$(python3 "$root/tests/core/sql_calls.py" "$root/sql")
rule 'calls between rooms of SQL: no arrow against the order, no rooms in a knot' \
  '[[ ${called##*$'"'\n'"'} =~ ^([0-9]+)\ of\ [^,]*,\ ([0-9]+)\  ]] && [ "${BASH_REMATCH[1]}" -le 0 ] && [ "${BASH_REMATCH[2]}" -le 0 ] || { echo "$called" >&2; false; }'

# A colour stands in streetgen.symbol_rule alone.
outside=$(python3 "$root/tests/core/colours.py" "$root")
rule 'colours outside streetgen.symbol_rule: none' '[ "$outside" = "0 outside the table" ] || { echo "$outside" >&2; false; }'

# Views by name that the SQL makes in a model; data/renew.sql drops them before the extension that they read.
views_kept() {
  grep -rhoE 'CREATE OR REPLACE VIEW [a-z_]+' "$root/sql" | cut -d' ' -f5 | sort -u | while read -r view; do
    grep -q "'$view'" "$root/data/renew.sql" || echo "$view"
  done
}
rule 'data/renew.sql names each view that the SQL makes in a model' '! views_kept | grep . >&2'

rule 'each room of SQL has a page of one screen that says what stands there' 'python3 "$root/tests/core/room_pages.py" "$root" >&2'

rule 'streetgen.tag_use() has a row of each tag that importers read' 'python3 "$root/tests/core/tags_read.py" "$root" >&2'

# Comments begin with their subject: "The nearest edge …", not "Of two edges …" or "What lies …".  Prints the first line of each other one, and last
# how many of a thousand these are.
comments_without_subject() {
  find "$root"/{src,include,sql,data,tests} -type f | grep -vE '\.(out|md|txt|spec|png|pyc)$' | sort | xargs awk '
    FNR == 1 { mark = FILENAME ~ /\.[ch]pp$/ ? "//" : FILENAME ~ /\.sql$/ ? "--" : "#"; inside = 0 }
    { line = $0; sub(/^[ \t]+/, "", line) }
    index(line, mark) != 1 || line ~ /^#!/ { inside = 0; next }
    inside { next }
    { inside = 1; all++; text = substr(line, length(mark) + 1); sub(/^[ \t]+/, "", text) }
    text ~ /^(Of|What|Whose|Which|Those|It|Who|Where|How)[^a-z]/ { without++; print FILENAME ":" FNR ": " text }
    END { printf "%d\n", 1000 * without / all }'
}
# The share only falls: whoever mends comments lowers the bound.
share=$(comments_without_subject | tail -1)
rule "of a thousand comments no more than 80 begin without a subject" '[ "$share" -le 80 ] || { comments_without_subject >&2; false; }'

rule 'pages of docs/development hold at most 12,000 words together' '[ "$(cat "$root"/docs/development/*.md | wc -w)" -le 12000 ]'
