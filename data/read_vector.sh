# Sourced by data/streetgen: a layer of a file that GDAL reads, as a table of schema streetgen_source.

# The columns of a .csv that may hold its lines, as WKT or as hexadecimal digits of WKB.
csv_columns=WKT,wkt_geom,geom,the_geom,geometry,geometrie,shape

# open_options FILE: a line for each.
open_options() { [[ ${1,,} != *.[ct]sv ]] || printf '%s\n' -oo "GEOM_POSSIBLE_NAMES=$csv_columns" -oo KEEP_GEOM_COLUMNS=NO; }

# layers_in FILE: a line for each of its layers, "name<tab>type of geometry"; those with a geometry alone where there are such.
layers_in() {
  local options kinds='Unknown|Point|Line String|Polygon|Multi|Geometry Collection|Circular|Compound|Curve|Surface|Polyhedral|TIN|Triangle|None'
  mapfile -t options < <(open_options "$1")
  # A layer of any type has none behind its name.
  ogrinfo -q -ro "$1" ${options[@]+"${options[@]}"} 2>/dev/null | sed -nE 's/^[0-9]+: //p' |
    sed -E "s/ \(((3D |Measured )*($kinds)[^)]*(\(any\)[^)]*)?)\)$/\t\1/; t; s/$/\tany type/" | sed -E 's/ \(title: [^\t]*\)\t/\t/' |
    awk -F'\t' '{ line[NR] = $0 } $2 != "None" { shaped[++n] = $0 } END { for (i = 1; i <= (n ? n : NR); i++) print n ? shaped[i] : line[i] }'
}

# chosen_layer FILE [LAYER]: the layer that is asked for, or the only one.
chosen_layer() {
  local file=$1 asked=${2:-} layers listed
  layers=$(layers_in "$file")
  listed=$(sed 's/\t\(.*\)/ (\1)/' <<<"$layers" | paste -sd, | sed 's/,/, /g')
  if [ -z "$layers" ]; then
    # ogr2ogr says why.
    printf %s "$asked"
  elif [ -n "$asked" ]; then
    cut -f1 <<<"$layers" | grep -xF -- "$asked" >/dev/null || fail "$(basename "$file") has no layer \"$asked\"; it has: $listed"
    printf %s "$asked"
  elif [ "$(wc -l <<<"$layers")" = 1 ]; then
    cut -f1 <<<"$layers"
  else
    fail "$(basename "$file") has several layers: name one with --layer NAME, of: $listed"
  fi
}

# text_of FILE LAYER: the values of a shapefile, byte by byte as they stand.
text_of() { ogr2ogr -q -f CSV /vsistdout/ "$1" "$2" --config SHAPE_ENCODING '' 2>/dev/null; }

# shape_encoding FILE LAYER: how the text of a shapefile is to be read; nothing for other files, and where SHAPE_ENCODING, its .cpg or the code page
# in its .dbf says so.
# No other encoding than UTF-8 gives valid UTF-8 beyond ASCII, so such text goes before what a .cpg says.
shape_encoding() {
  local said cpg
  said=$(ogrinfo -so -ro -mdd SHAPEFILE "$1" "$2" 2>/dev/null) || return 0
  if [ -n "${SHAPE_ENCODING:-}" ] || ! grep -q '^Metadata (SHAPEFILE):' <<<"$said"; then
    return
  fi
  cpg=$(sed -n 's/^  ENCODING_FROM_CPG=//p' <<<"$said")
  if [ "$(text_of "$1" "$2" | LC_ALL=C tr -d '\0-\177' | wc -c)" != 0 ] && text_of "$1" "$2" | iconv -f UTF-8 -t UTF-8 >/dev/null 2>&1; then
    [ -z "$cpg" ] || [ "${cpg^^}" = UTF-8 ] || say "the .cpg of $(basename "$1") says $cpg, but its text is UTF-8 and is read so; SHAPE_ENCODING=$cpg reads it as $cpg"
    echo UTF-8
  elif [ -z "$cpg" ] && ! grep -q '^  ENCODING_FROM_LDID=' <<<"$said"; then
    echo ISO-8859-1
  fi
}

# said_as_text FILE: whether it is a file of text that does not say its encoding.
said_as_text() { [[ ${1,,} =~ \.(csv|tsv|json|geojson|geojsonl)$ && $1 != /vsi* ]]; }

# in_utf8: the file of the caller becomes a copy in UTF-8, in its folder $work, where it is text in another encoding.
in_utf8() {
  local from=${SHAPE_ENCODING:-WINDOWS-1252} copy=$work/utf8
  ! LC_ALL=C grep -qaP '^\xFF\xFE|^\xFE\xFF' <(head -c 2 "$file") || from=UTF-16
  [ "$from" = UTF-16 ] || ! iconv -f UTF-8 -t UTF-8 "$file" >/dev/null 2>&1 || return 0
  mkdir -p "$copy"
  iconv -f "$from" -t UTF-8 "$file" >"$copy/$(basename "$file")" 2>/dev/null || fail "$(basename "$file") is neither UTF-8 nor $from: SHAPE_ENCODING says what it is"
  [ "$from" = UTF-16 ] || say "the text of $(basename "$file") is no UTF-8 and is read as $from; SHAPE_ENCODING=… reads it as another one"
  file=$copy/$(basename "$file")
}

# references_said FILE: the references that lines of a .csv say, as EWKT (SRID=2154;LINESTRING…) or as digits of EWKB.
references_said() {
  local digits
  {
    grep -aoiP '(?<=SRID=)\d+(?=;\s*(MULTI)?(LINE|CURVE|COMPOUND|CIRCULAR))' "$1" || true
    { grep -aoiP '\b01[01][0-9A-F]0000[26AE]0\K[0-9A-F]{8}' "$1" || true; } | sort -u | while read -r digits; do
      echo $((16#${digits:6:2}${digits:4:2}${digits:2:2}${digits:0:2}))
    done
  } | sort -un
}

# without_srid: lines of a .csv that say their reference become WKT of a copy, and the reference of the caller is theirs.
without_srid() {
  local said copy=$work/wkt
  said=$(references_said "$file")
  [ -n "$said" ] || return 0
  [ "$(wc -l <<<"$said")" = 1 ] || fail "$(basename "$file") has lines of several references: $(paste -sd, <<<"$said" | sed 's/,/, /g'); give all the same one"
  mkdir -p "$copy"
  sed -E 's/SRID=[0-9]+; *((MULTI)?(LINE|CURVE|COMPOUND|CIRCULAR))/\1/I' "$file" >"$copy/$(basename "$file")"
  file=$copy/$(basename "$file")
  reference=(-a_srs "EPSG:$said")
}

# own_query FILE LAYER [OPTION…]: a query of OGR that reads its fields, where some have names that tables keep for themselves, or where features of GeoJSON have
# numbers of their own, which become column id; else nothing.
own_query() {
  local fields number= kept='^(geom|tableoid|[xc]m(in|ax)|ctid)$'
  fields=$({ ogrinfo -so -ro "$@" 2>/dev/null || true; } |
    sed -nE '/^(Layer SRS WKT|\(unknown\)|Data axis to CRS)/,$ s/^(.+): (Integer|Real|String|Date|Time|Binary)[A-Za-z0-9]*(\([A-Za-z0-9]*\)|List)? \([0-9.]*\).*/\1/p')
  if [[ ${1,,} =~ json$ && $1 != /vsi* ]] && ! grep -qix id <<<"$fields" && grep -aqP '"id"\s*:\s*\d' "$1"; then
    number='FID AS "id"'
  fi
  [ -n "$number" ] || grep -qE "$kept" <<<"$fields" || return 0
  awk -v kept="$kept" -v layer="$2" -v number="$number" 'function quoted(name) { gsub(/["\\]/, "\\\\&", name); return "\"" name "\"" }
    $0 != "" { number = number (number != "" ? ", " : "") quoted($0) ($0 ~ kept ? " AS " quoted($0 "_") : "") } END { print "SELECT " number " FROM " quoted(layer) }' <<<"$fields"
}

# read_vector FILE TABLE SRID [LAYER]: what ogr2ogr says goes through the folder $work of the caller.
read_vector() {
  local file=$1 table=$2 srid=$3 layer encoding options reference=() about query write reason log=$work/ogr2ogr.log failed=
  if said_as_text "$file"; then
    in_utf8
    [[ ${file,,} != *.[ct]sv ]] || without_srid
  fi
  layer=$(chosen_layer "$file" "${4:-}")
  mapfile -t options < <(open_options "$file")
  if [ ${#options[@]} != 0 ] && layers_in "$file" | grep -q $'\tNone$'; then
    fail "$(basename "$file") has no column of lines: name it one of ${csv_columns//,/, }, and write them as WKT"
  elif layers_in "$file" | grep -qxF "$layer"$'\tNone'; then
    fail "$(basename "$file") has no lines: save it as .csv, with lines as WKT in a column that has one of the names ${csv_columns//,/, }"
  fi
  encoding=$(shape_encoding "$file" "$layer")
  # A file that does not say its reference is taken to be in the model's, as is one of which GDAL says degrees and that has none.
  about=$(ogrinfo -so -ro "$file" "$layer" ${options[@]+"${options[@]}"} 2>/dev/null) || true
  if [ ${#reference[@]} = 0 ] && grep -A1 '^Layer SRS WKT' <<<"$about" | grep -q '(unknown)'; then
    reference=(-a_srs "EPSG:$srid")
  elif [ ${#reference[@]} = 0 ] && grep -q '^GEOGCRS' <<<"$about" && grep -qE '^Extent: .*[0-9]{4}\.' <<<"$about"; then
    reference=(-a_srs "EPSG:$srid")
    say "coordinates of $(basename "$1") are no degrees, as its reference has them: they are taken in EPSG:$srid"
  fi
  query=$(own_query "$file" "$layer" ${options[@]+"${options[@]}"})
  if grep -qE '" AS "' <<<"$query"; then
    say "columns of $(basename "$file") whose names tables keep for themselves get another one: $(grep -oE '"[a-z]+" AS "[a-z]+_"' <<<"$query" | tr -d '"' | sed 's/ AS / as /' | paste -sd, | sed 's/,/, /g')"
  fi
  # What a column of several types, or of dates that are none, holds is text.
  write=(ogr2ogr -q -f PostgreSQL "PG:host=$PGHOST port=$PGPORT user=$PGUSER dbname=$database" "$file" ${options[@]+"${options[@]}"} ${reference[@]+"${reference[@]}"}
    ${encoding:+--config SHAPE_ENCODING "$encoding"} -nln "$table" -lco GEOMETRY_NAME=geom -lco SCHEMA=streetgen_source -lco PRECISION=NO -lco LAUNDER=NO -nlt PROMOTE_TO_MULTI
    -mapFieldType 'String(JSON)=String,Date=String,Time=String,DateTime=String')
  if [ -n "$query" ]; then write+=(-dialect OGRSQL -sql "$query"); elif [ -n "$layer" ]; then write+=("$layer"); fi
  run_sql -c "DROP TABLE IF EXISTS streetgen_source.$table"
  "${write[@]}" 2>"$log" || failed=yes
  # Ids of features that repeat or are missing are no key of a table.
  if grep -qE 'violates (unique|not-null) constraint|Wrong field type for' "$log"; then
    failed=
    run_sql -c "DROP TABLE IF EXISTS streetgen_source.$table"
    "${write[@]}" -unsetFid -lco FID=row_of_file 2>"$log" || failed=yes
    [ -n "$failed" ] || say "ids of features of $(basename "$file") repeat or are missing: its rows are numbered, in column row_of_file"
  fi
  if [ -n "$failed" ]; then
    ! grep -qa '^ERROR 1: Non UTF-8 content' "$log" || fail "$(basename "$1") has text that is no UTF-8: save it as UTF-8, or as a .csv or .geojson that is not packed as .zip"
    reason=$(sed -nE 's/^ERROR( [0-9]+)?: +//p' "$log" | grep -av 'COPY statement failed' | head -1) || true
    fail "$1 cannot be read by ogr2ogr: ${reason:-it is of no format that ogrinfo --formats lists; text is a .csv, .tsv or .geojson}"
  fi
  cat "$log" >&2
}
