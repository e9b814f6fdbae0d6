# Sourced by the measures of lanes with their arguments: $files, those that are named or else the extracts in STREETGEN_DATA.
: "${STREETGEN_DATA:=}"
files=("$@")
[ $# != 0 ] || files=("$STREETGEN_DATA"/paris/paris_{marais,centre_2014}.osm.pbf "$STREETGEN_DATA"/bench/porto.osm.pbf "$STREETGEN_DATA"/osm/*.osm.pbf
  "$STREETGEN_DATA"/truth/cambridge_boston.osm.pbf "$STREETGEN_DATA"/terrain/portland.osm.pbf "$STREETGEN_DATA"/junctions/*.osm.pbf)

# zone_of FILE: the UTM zone of its middle.
zone_of() { osmium fileinfo -e -g data.bbox "$1" | tr -d '()' | awk -F, '{ print ($2 + $4 < 0 ? 32700 : 32600) + int((($1 + $3) / 2 + 180) / 6) + 1 }'; }
