# Sourced by data/streetgen: heights of a file that GDAL reads become tiles of a model.

# file_reference FILE SRID: options of gdalwarp where the file does not say its own reference.
file_reference() {
  gdalsrsinfo -o epsg "$1" 2>/dev/null | grep -q EPSG && return
  gdalsrsinfo -o proj4 "$1" 2>/dev/null | grep -q proj && return
  say "$1 says no spatial reference: its coordinates are taken as those of EPSG:$2"
  echo "-s_srs EPSG:$2"
}

# file_gaps FILE: options of gdalwarp where the file has a usual value for missing heights and does not say so.
file_gaps() {
  local least
  gdalinfo -json "$1" 2>/dev/null | grep -q '"noDataValue"' && return
  least=$(gdalinfo -mm "$1" 2>/dev/null | sed -n 's:.*Computed Min/Max=\(-9999\|-3276[78]\)\(\.0*\)\?,.*:\1:p' | head -1)
  [ -n "$least" ] || return 0
  say "$1 says no value for missing heights: those of $least are taken as missing"
  echo "-srcnodata $least"
}

# read_terrain FILE TABLE SRID: a table of tiles, raster WKB as hexadecimal text, in the SRID, of square cells. Heights are parts of metres, whatever
# the file holds: whole numbers would stay whole where they are transformed, and those without a sign have no room for missing heights.
read_terrain() {
  local file=$1 table=$2 srid=$3 folder log=$build/gdal.log options
  folder=$(mktemp -d)
  options="$(file_reference "$file" "$srid") $(file_gaps "$file")"
  # shellcheck disable=SC2086
  gdalwarp -q $options -t_srs "EPSG:$srid" -r bilinear -ot Float32 -dstnodata -32768 "$file" "$folder/heights.tif" >"$log" 2>&1 ||
    { tail -3 "$log" >&2; fail "$file cannot be read by gdalwarp"; }
  raster2pgsql -t 128x128 -b 1 "$folder/heights.tif" heights 2>"$log" | sed -n "s/^INSERT INTO .*('\([0-9A-F]*\)'.*/\1/p" >"$folder/tiles"
  [ -s "$folder/tiles" ] || { tail -3 "$log" >&2; fail "$file has no heights"; }
  run_sql -c "DROP TABLE IF EXISTS streetgen_source.$table" -c "CREATE TABLE streetgen_source.$table (heights text NOT NULL)" \
    -c "\\copy streetgen_source.$table FROM '$folder/tiles'"
  rm -rf "$folder"
}
