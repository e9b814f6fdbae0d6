-- Calls that take long: on lines of :vertices vertices, on a town of about 2 * :blocks * :blocks axes, on :crowd axes
-- from one point, 10 * :crowd axes a centimetre apart and :crowd equal ones.
-- Fills long_call (name, statement), and town, a model that is generated.
SET client_min_messages = warning;
CREATE EXTENSION IF NOT EXISTS postgis_topology;
CREATE TABLE long_line AS
  SELECT 'gentle' AS kind, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + i * 0.5, 6860000 + 20 * sin(i / 100.0)) ORDER BY i), 2154) AS geom FROM generate_series(1, :vertices) i
  UNION ALL SELECT 'coiled', ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + (10 + i * 0.01) * cos(i / 50.0), 6860000 + (10 + i * 0.01) * sin(i / 50.0)) ORDER BY i), 2154) FROM generate_series(1, :vertices) i;
CREATE TABLE long_pair AS SELECT kind, geom, ST_Rotate(geom, 1.3, ST_StartPoint(geom)) AS turned FROM long_line;

DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154) FROM unnest(ARRAY['town', 'alone', 'dual', 'crossed', 'imported', 'star', 'band', 'bundle']) m;
  PERFORM streetgen.live(m, false) FROM unnest(ARRAY['star', 'band', 'bundle']) m;
END $$;
CREATE TABLE street AS SELECT row_number() OVER () AS id, 'residential' AS class, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 80 * x, 6860000 + 60 * y),
    ST_MakePoint(650000 + 80 * (x + dx), 6860000 + 60 * (y + 1 - dx))), 2154) AS geom
  FROM generate_series(1, :blocks) x, generate_series(1, :blocks) y, generate_series(0, 1) dx;
CREATE TABLE osm_line AS SELECT id AS way_id, class, NULL::text AS name, '2' AS lanes, NULL::text AS lanes_forward, NULL::text AS lanes_backward, '7' AS width, NULL::text AS oneway,
    NULL::text AS junction, NULL::text AS layer, NULL::text AS bridge, NULL::text AS tunnel, '50' AS maxspeed, NULL::text AS area, geom FROM street;
INSERT INTO town.axis (geom, width) SELECT geom, 7 FROM street;
DO $$ BEGIN
  PERFORM streetgen.generate('town');
END $$;
INSERT INTO alone.axis (geom, width) SELECT geom, 7 FROM long_line WHERE kind = 'gentle';
INSERT INTO dual.axis (geom, width) SELECT ST_Translate(geom, 0, d), 7 FROM long_line, generate_series(0, 5, 5) d WHERE kind = 'gentle';
INSERT INTO crossed.axis (geom, width) SELECT geom, 7 FROM long_line WHERE kind = 'gentle'
  UNION ALL SELECT ST_MakeLine(p, ST_Translate(p, 0, 60)), 6 FROM long_line, generate_series(1, ST_NPoints(geom), 200) i, ST_PointN(geom, i) p WHERE kind = 'gentle';

INSERT INTO star.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000),
    ST_MakePoint(650000 + 100 * cosd(360.0 * i / :crowd), 6860000 + 100 * sind(360.0 * i / :crowd))), 2154), 6
  FROM generate_series(1, :crowd) i;
INSERT INTO band.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000 + 0.01 * i),
    ST_MakePoint(650100, 6860000 + 0.01 * i)), 2154), 6 FROM generate_series(1, 10 * :crowd) i;
INSERT INTO bundle.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000),
    ST_MakePoint(650100, 6860000)), 2154), 6 FROM generate_series(1, :crowd) i;

CREATE TABLE long_call (name text, statement text);
INSERT INTO long_call SELECT primitive || ', ' || kind, format('SELECT streetgen.%s FROM long_pair WHERE kind = %L', call, kind) FROM long_line, (VALUES
  ('arc_centre', 'arc_centre(geom, turned, 7, 6, 5)'), ('corner_arc', 'corner_arc(geom, turned, 7, 6, 5)'), ('max_corner_radius', 'max_corner_radius(geom, turned, 7, 6)'),
  ('border_line', 'border_line(geom, 1e9, 7)'), ('section_surface', 'section_surface(geom, 7, 10, 1e9)'), ('clean', 'clean(geom, ''{}'', 0.3, 3)'),
  ('intersection_surface', 'intersection_surface(ARRAY[geom, turned], ''{7,6}'', ''{5,5}'')'),
  ('variable_buffer', 'variable_buffer(geom, array_fill(3.5::float8, ARRAY[ST_NPoints(geom)]))'), ('arc_road', 'arc_road(geom)'),
  ('arc_road_offset', 'arc_road_offset(streetgen.arc_road(geom), 15)'), ('arc_road_mesh', 'arc_road_mesh(streetgen.arc_road(geom), 15, -15, 0.001)')) v(primitive, call);
INSERT INTO long_call VALUES
  ('import_axes, long lines', 'SELECT streetgen.import_axes(''imported'', ''long_line'', ''{"source_ref": "kind"}'')'),
  ('import_axes, town', 'SELECT streetgen.import_axes(''imported'', ''street'', ''{"source_ref": "id"}'')'),
  ('import_osm, town', 'SELECT streetgen.import_osm(''imported'')'),
  ('generate, long line', 'SELECT streetgen.generate(''alone'')'),
  ('generate, two long lines side by side', 'SELECT streetgen.generate(''dual'')'),
  ('generate, long line with side streets', 'SELECT streetgen.generate(''crossed'')'),
  ('generate, axes from one point', 'SELECT streetgen.generate(''star'')'),
  ('generate, axes a centimetre apart', 'SELECT streetgen.generate(''band'')'),
  ('generate, equal axes', 'SELECT streetgen.generate(''bundle'')'),
  ('generate, town', 'SELECT streetgen.generate(''town'')'),
  ('check_model, town', 'SELECT streetgen.check_model(''town'')'),
  ('summary, town', 'SELECT streetgen.summary(''town'')'),
  ('svg, town', 'SELECT streetgen.svg(''town'')'),
  ('roundabout_candidates, town', 'SELECT streetgen.roundabout_candidates(''town'')'),
  ('road_mesh, town', 'SELECT streetgen.road_mesh(''town'')'),
  ('export_topology, town', 'SELECT streetgen.export_topology(''town'', ''town_topology'')');
-- The writers of files, which make a town's in one call.
INSERT INTO long_call SELECT format('export_%s, town', writer), format('SELECT streetgen.export_%s(''town''%s)', writer, part)
  FROM (VALUES ('cityjson', ''), ('gltf', ''), ('lanelet2', ''), ('opendrive', ''), ('symuvia', ''), ('sumo', ', ''connections''')) w(writer, part);

-- Milliseconds that a statement takes, under the statement_timeout of the statement around it; what it wrote is taken back.
CREATE FUNCTION pg_temp.run(statement text, OUT ms float8, OUT state text, OUT said text) LANGUAGE plpgsql AS $$
DECLARE
  began timestamptz := clock_timestamp();
BEGIN
  BEGIN
    EXECUTE statement;
    RAISE EXCEPTION USING ERRCODE = 'ZZZZZ', MESSAGE = 'taken back';
  EXCEPTION WHEN OTHERS OR query_canceled THEN
    -- PostGIS may raise by itself and leave the interrupt pending: then it comes here.
    state := nullif(SQLSTATE, 'ZZZZZ');
    said := SQLERRM;
  END;
  ms := 1000 * extract(epoch FROM clock_timestamp() - began);
EXCEPTION WHEN query_canceled THEN
  state := SQLSTATE;
  ms := 1000 * extract(epoch FROM clock_timestamp() - began);
END $$;
