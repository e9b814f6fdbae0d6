\set ECHO none
\ir shared/truths.sql
-- Where buses stand at their stops: on parking lanes, or on the lane beside the kerb.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.at(x float8, y float8, mirrored boolean) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + CASE WHEN mirrored THEN -y ELSE y END), 2154) $$;
CREATE FUNCTION pg_temp.turned(text) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(word, '|' ORDER BY n DESC) FROM string_to_table($1, '|') WITH ORDINALITY w(word, n) $$;
-- The same streets as drawn, drawn the other way, and mirrored with traffic on the left.
CREATE TEMPORARY TABLE street (axis_id bigint, y float8, width float8, kind text);
INSERT INTO street VALUES (1, 0, 7, NULL), (2, 100, 9, 'general|parking'), (3, 200, 10, 'general|cycle'), (4, 300, 10.5, 'general|bus');
DO $$ DECLARE m name; mirrored boolean; against boolean; BEGIN
  FOREACH m IN ARRAY '{town,against,mirror}'::name[] LOOP
    mirrored := m = 'mirror'; against := m = 'against';
    PERFORM streetgen.create_model(m, 2154, subjects => '{lane,object}', driving_side => CASE WHEN mirrored THEN 'left' ELSE 'right' END);
    EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lanes_forward, lanes_backward, kind_forward, kind_backward)
      SELECT axis_id, CASE WHEN $2 THEN ST_Reverse(line) ELSE line END, width, 1 + f.n, 1 + b.n, f.kind, b.kind
      FROM street s, LATERAL (SELECT ST_MakeLine(pg_temp.at(0, y, $1), pg_temp.at(100, y, $1)) AS line) g,
        LATERAL (SELECT CASE WHEN $2 THEN NULL ELSE CASE WHEN $1 THEN pg_temp.turned(s.kind) ELSE s.kind END END AS kind, CASE WHEN NOT $2 AND s.kind = ''general|bus'' THEN 1 ELSE 0 END AS n) f,
        LATERAL (SELECT CASE WHEN $2 THEN s.kind END AS kind, CASE WHEN $2 AND s.kind = ''general|bus'' THEN 1 ELSE 0 END AS n) b', m) USING mirrored, against;
    -- Stops beside the kerb of those who drive east, whatever the axis: in the middle of each street, and near its ends.
    EXECUTE format('INSERT INTO %I.street_object_editing (type, geom) SELECT ''bus_stop'', pg_temp.at(x, s.y - s.width / 2 - 1, $1) FROM street s, (VALUES (50), (5.5), (97)) v(x) ORDER BY x, axis_id', m) USING mirrored;
  END LOOP;
END $$;
-- Each box as it lies in the town as drawn: its kind, width, length, and from where to where it goes east.
CREATE FUNCTION pg_temp.boxes(model name, x float8) RETURNS text LANGUAGE plpgsql AS $$ DECLARE said text; BEGIN
  EXECUTE format('SELECT string_agg(concat_ws('' '', axis_id, kind, round(width::numeric, 2), round((ST_XMin(surface) - 650000)::numeric, 2), round((ST_XMax(surface) - 650000)::numeric, 2)), '', '' ORDER BY axis_id)
    FROM %1$I.bus_stop_box JOIN %1$I.street_object o USING (street_object_id) WHERE abs(ST_X(o.geom) - 650000 - $1) < 1', model) USING x INTO said;
  RETURN said; END $$;
SELECT m || ': a bus stands beside the kerb, on a parking lane, left of a cycle lane, on its own lane; its front is 1 m beyond the stop',
  pg_temp.boxes(m, 50) SIMILAR TO '1 mark 3.50 36.00 51.00, 2 bay [0-9.]+ 36.00 51.00, 3 mark [0-9.]+ 36.00 51.00, 4 mark [0-9.]+ 36.00 51.00' FROM unnest('{town,against,mirror}'::name[]) m;
SELECT m || ': as it does in the town', pg_temp.boxes(m, 50) = pg_temp.boxes('town', 50) FROM unnest('{against,mirror}'::name[]) m;
SELECT m || ': near an end it is as long as there is lane', pg_temp.boxes(m, 5.5) LIKE '1 mark 3.50 0.00 6.50,%' AND pg_temp.boxes(m, 97) LIKE '1 mark 3.50 83.00 98.00,%' FROM unnest('{town,against,mirror}'::name[]) m;
SELECT 'it lies on its lane', bool_and(ST_Area(ST_Difference(b.surface, l.surface)) < 1e-6), count(*) = 12 FROM town.bus_stop_box b JOIN town.lane l USING (lane_id);
SELECT 'its lane drives east', bool_and(along_axis) FROM town.bus_stop_box JOIN town.lane USING (lane_id);
SELECT 'its paint lies on its ground, 30 cm from the borders, from end to end', bool_and(ST_Covers(ST_Buffer(surface, 0.1), paint) AND abs(ST_XMax(paint) - ST_XMax(surface)) < 0.1
  AND abs(ST_YMax(surface) - ST_YMax(paint) - 0.3) < 0.15) FROM town.bus_stop_box;
SELECT 'its zigzag has as much paint as strokes of 12 cm', bool_and(abs(ST_Area(paint) / 0.12 - strokes * sqrt((size / strokes) ^ 2 + (width - 0.6) ^ 2)) < strokes * 0.5)
  FROM town.bus_stop_box, LATERAL (SELECT ST_XMax(surface) - ST_XMin(surface) AS size) l, LATERAL (SELECT greatest(2, round(size / 2)) AS strokes) s;
-- It keeps 1 m from crossings, which are 4 m wide: one before it, and one behind it.
INSERT INTO town.street_object_editing (type, geom) VALUES ('crossing', pg_temp.at(53, 100, false)), ('crossing', pg_temp.at(38, 200, false)), ('crossing', pg_temp.at(91, 300, false)), ('crossing', pg_temp.at(99, 300, false));
INSERT INTO against.street_object_editing (type, geom) SELECT 'crossing', geom FROM town.street_object WHERE type = 'crossing';
SELECT m || ': it keeps a metre from crossings', pg_temp.boxes(m, 50) SIMILAR TO '1 mark [^,]+, 2 bay [0-9.]+ 35.00 50.00, 3 mark [0-9.]+ 41.00 51.00, 4 mark [0-9.]+ 36.00 51.00' FROM unnest('{town,against}'::name[]) m;
SELECT m || ': none stands where less than 5 m are left', pg_temp.boxes(m, 97) NOT LIKE '%4 mark%' FROM unnest('{town,against}'::name[]) m;
DO $$ BEGIN DELETE FROM town.street_object_editing WHERE type = 'crossing'; END $$;
-- By setting, live, of types below, and of no other.
UPDATE town.setting SET value = '30' WHERE name = 'bus_stop_length';
SELECT 'it is as long as is set', pg_temp.boxes('town', 50) LIKE '1 mark 3.50 21.00 51.00,%';
INSERT INTO town.object_type (type, parent, category) VALUES ('shelter', 'bus_stop', 'furniture');
UPDATE town.street_object SET type = 'shelter' WHERE street_object_id = (SELECT min(street_object_id) FROM town.street_object);
INSERT INTO town.street_object_editing (type, geom) VALUES ('bench', pg_temp.at(70, -4.5, false));
SELECT 'types below count, others do not', count(*) = 12 FROM town.bus_stop_box;
UPDATE town.axis SET geom = ST_Translate(geom, 0, 0.5), width = 8 WHERE axis_id = 1;
SELECT 'it follows its street', pg_temp.boxes('town', 50) LIKE '1 mark 4.00 21.00 51.00,%';
SELECT 'it is drawn', count(*) = 12 FROM streetgen._object_drawn('town', ST_MakeEnvelope(649900, 6859900, 650200, 6860400, 2154), '{bus_stop_box}');
SELECT 'a model without lanes has no such view', to_regclass('bare.bus_stop_box') IS NULL FROM streetgen.create_model('bare', 2154, subjects => '{object}');
DO $$ BEGIN PERFORM streetgen.switch_subject('town', 'lane', false); END $$;
SELECT 'it goes with the lanes', to_regclass('town.bus_stop_box') IS NULL;
