# Sourced by data/streetgen: a layer of a file that GDAL reads, as a table of schema streetgen_source.

# The columns of a .csv that may hold its lines, as WKT or as hexadecimal digits of WKB.
csv_columns=WKT,wkt_geom,geom,the_geom,geometry,geometrie,shape

# open_options FILE: a line for each.
open_options() { [[ ${1,,} != *.csv ]] || printf '%s\n' -oo "GEOM_POSSIBLE_NAMES=$csv_columns" -oo KEEP_GEOM_COLUMNS=NO; }

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

# read_vector FILE TABLE SRID [LAYER]: what ogr2ogr says goes through the folder $work of the caller.
read_vector() {
  local file=$1 table=$2 srid=$3 layer encoding options reference=() log=$work/ogr2ogr.log failed=
  layer=$(chosen_layer "$file" "${4:-}")
  mapfile -t options < <(open_options "$file")
  if [ ${#options[@]} != 0 ] && layers_in "$file" | grep -q $'\tNone$'; then
    fail "$(basename "$file") has no column of lines: name it one of ${csv_columns//,/, }, and write them as WKT"
  fi
  encoding=$(shape_encoding "$file" "$layer")
  # A file that does not say its reference is taken to be in the model's.
  if ogrinfo -so -ro "$file" "$layer" ${options[@]+"${options[@]}"} 2>/dev/null | grep -A1 '^Layer SRS WKT' | grep -q '(unknown)'; then
    reference=(-a_srs "EPSG:$srid")
  fi
  run_sql -c "DROP TABLE IF EXISTS streetgen_source.$table"
  ogr2ogr -q -f PostgreSQL "PG:host=$PGHOST port=$PGPORT user=$PGUSER dbname=$database" "$file" ${layer:+"$layer"} ${options[@]+"${options[@]}"} ${reference[@]+"${reference[@]}"} \
    ${encoding:+--config SHAPE_ENCODING "$encoding"} -nln "$table" -lco GEOMETRY_NAME=geom -lco SCHEMA=streetgen_source -lco PRECISION=NO -nlt PROMOTE_TO_MULTI 2>"$log" || failed=yes
  [ -z "$failed" ] || fail "$file cannot be read by ogr2ogr$(sed -n 's/^ERROR [0-9]*: /: /p' "$log" | head -1)"
  cat "$log" >&2
}
