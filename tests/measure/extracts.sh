# Sourced by measures that read files of OpenStreetMap.

# extracts [FILE …]: those that are named, or else the extracts in STREETGEN_DATA.
extracts() {
  local data=${STREETGEN_DATA:-}
  [ $# != 0 ] || set -- "$data"/paris/paris_{marais,centre_2014}.osm.pbf "$data"/bench/porto.osm.pbf "$data"/osm/*.osm.pbf \
    "$data"/truth/cambridge_boston.osm.pbf "$data"/terrain/portland.osm.pbf "$data"/junctions/*.osm.pbf
  printf '%s\n' "$@"
}

# zone_of FILE: the UTM zone of its middle.
zone_of() { osmium fileinfo -e -g data.bbox "$1" | tr -d '()' | awk -F, '{ print ($2 + $4 < 0 ? 32700 : 32600) + int((($1 + $3) / 2 + 180) / 6) + 1 }'; }
