# Sourced by measures of the surveyed places, in the database that PGDATABASE names: axes of a city as a model, and the same streets in other tables.
truth=${STREETGEN_DATA:?names the folder of the real extracts}/truth

ask() { psql -qXAt -v ON_ERROR_STOP=1 "$@"; }

# read_layer FILE LAYER TABLE
read_layer() {
  ogr2ogr -q -f PostgreSQL "PG:host=$PGHOST port=$PGPORT user=gis dbname=$PGDATABASE" "$1" "$2" -nln "$3" -lco GEOMETRY_NAME=geom -lco SCHEMA=public -nlt GEOMETRY
}

# Model neukoelln has an axis for each edge of the named streets; neukoelln_way holds the ways of OpenStreetMap, neukoelln_kerb the ground between kerbs.
read_neukoelln() {
  read_layer "$truth/neukoelln_kerbs.gpkg" street_names neukoelln_street
  read_layer "$truth/neukoelln_kerbs.gpkg" osm_lines neukoelln_osm
  read_layer "$truth/neukoelln_kerbs.gpkg" kerb_street_areas neukoelln_kerb
  ask <<'SQL' >/dev/null
CREATE TABLE neukoelln_line AS SELECT row_number() OVER (ORDER BY fid, d.path) AS id, name, highway, d.geom
FROM neukoelln_street, ST_Dump(ST_LineMerge(geom)) d WHERE highway IN ('residential', 'living_street', 'secondary', 'tertiary');
CREATE TABLE neukoelln_way AS SELECT osm_id AS source_ref, name, highway, geom, substring(other_tags FROM '"maxspeed"=>"(\d+)"')::float8 AS speed,
    substring(other_tags FROM '"width"=>"([\d.]+)"')::float8 AS width FROM neukoelln_osm WHERE highway IS NOT NULL;
SELECT streetgen.create_model('whole', 25833, subjects => '{}');
SELECT streetgen.set('whole', 'crossing', 'split');
SELECT streetgen.import_axes('whole', 'neukoelln_line', '{"source_ref": "id", "name": "name", "kind": "highway"}');
SELECT streetgen.generate('whole');
SELECT streetgen.create_model('neukoelln', 25833, subjects => '{}');
INSERT INTO neukoelln.axis (geom, name, kind, source_ref) SELECT e.geom, a.name, a.kind, e.edge_id FROM whole.edge e JOIN whole.axis a USING (axis_id);
SELECT streetgen.drop_model('whole');
SQL
}

# Model cambridge has the centrelines of the city; cambridge_way holds the ways of OpenStreetMap, cambridge_kerb the lines of kerbs.
read_cambridge() {
  read_layer "$truth/cambridge_roadway.gpkg" trans_centerlines cambridge_centreline
  read_layer "$truth/cambridge_roadway.gpkg" basemap_curbs cambridge_kerb
  STREETGEN_PREFIX=cambridge STREETGEN_SRID=32619 osm2pgsql -d "$PGDATABASE" -O flex -S "$root/data/osm2pgsql_flex.lua" --log-level=error \
    "$truth/cambridge_boston.osm.pbf" 2>/dev/null || fail 'osm2pgsql did not read Cambridge'
  ask <<'SQL' >/dev/null
CREATE VIEW cambridge_way AS SELECT way_id AS source_ref, name, class, geom FROM cambridge_line;
SELECT streetgen.create_model('cambridge', 32619, subjects => '{}');
SELECT streetgen.import_axes('cambridge', 'cambridge_centreline', '{"source_ref": "id", "name": "street"}');
SQL
}
