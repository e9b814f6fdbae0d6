# Sourced by data/streetgen: heights of a file that GDAL reads become tiles of a model.

# file_reference FILE SRID: options of gdalwarp where the file does not say its own reference.
file_reference() { if ! gdalsrsinfo -o epsg "$1" 2>/dev/null | grep -q EPSG; then echo "-s_srs EPSG:$2"; fi; }

# read_terrain FILE TABLE SRID: a table of tiles, raster WKB as hexadecimal text, in the SRID, of square cells.
read_terrain() {
  local file=$1 table=$2 srid=$3 folder log=$build/gdal.log
  folder=$(mktemp -d)
  # shellcheck disable=SC2046
  gdalwarp -q $(file_reference "$file" "$srid") -t_srs "EPSG:$srid" -r bilinear -dstnodata -32768 "$file" "$folder/heights.tif" >"$log" 2>&1 ||
    { tail -3 "$log" >&2; fail "$file cannot be read by gdalwarp"; }
  raster2pgsql -t 128x128 -b 1 "$folder/heights.tif" heights 2>"$log" | sed -n "s/^INSERT INTO .*('\([0-9A-F]*\)'.*/\1/p" >"$folder/tiles"
  [ -s "$folder/tiles" ] || { tail -3 "$log" >&2; fail "$file has no heights"; }
  run_sql -c "DROP TABLE IF EXISTS streetgen_source.$table" -c "CREATE TABLE streetgen_source.$table (heights text NOT NULL)" \
    -c "\\copy streetgen_source.$table FROM '$folder/tiles'"
  rm -rf "$folder"
}
