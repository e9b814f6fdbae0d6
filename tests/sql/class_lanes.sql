\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Lanes, widths and parking that a street has by its class, where its source states none.  (name, holds)
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, driving_side => 'right'), streetgen.create_model('anew', 2154, driving_side => 'right'); END $$;
CREATE FUNCTION street(n integer, metres float8 DEFAULT 100) RETURNS geometry LANGUAGE sql AS
  $$ SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000 + 50 * n), ST_MakePoint(650000 + metres, 6860000 + 50 * n)), 2154) $$;
INSERT INTO town.axis (axis_id, geom, kind, direction, width, lane_count, roundabout_tag) OVERRIDING SYSTEM VALUE VALUES
  (1, street(1), 'residential', 'direct', NULL, NULL, NULL), (2, street(2), 'residential', 'reverse', NULL, NULL, NULL), (3, street(3), 'residential', 'both', NULL, NULL, NULL),
  (4, street(4), 'residential', 'direct', 9, NULL, NULL), (5, street(5), 'residential', 'direct', NULL, 2, NULL), (6, street(6), 'primary', 'direct', NULL, NULL, NULL),
  (7, street(7), 'primary', 'direct', 4, NULL, NULL), (8, street(8), 'residential', 'direct', NULL, NULL, 'circular'), (9, street(9), NULL, 'direct', NULL, NULL, NULL),
  (10, street(10), 'tertiary', 'both', 15, NULL, NULL), (11, street(11), 'primary', 'direct', NULL, NULL, 'roundabout'),
  (12, street(12), 'service', 'both', NULL, NULL, NULL), (13, ST_Reverse(street(13)), 'service', 'both', NULL, NULL, NULL);
-- axis: width, lanes from the left kerb to the right one, those against the axis with a minus.
CREATE FUNCTION told(axis bigint, model text DEFAULT 'town') RETURNS text LANGUAGE plpgsql AS $$
DECLARE found text;
BEGIN
  EXECUTE format('SELECT round(max(u.width)::numeric, 2) || '': '' || string_agg(CASE WHEN along_axis THEN '''' ELSE ''-'' END || l.kind || round(l.width::numeric, 2), '' '' ORDER BY lane_position)
    FROM %1$I.lane l JOIN %1$I.edge e USING (edge_id) JOIN %1$I.axis_used u USING (axis_id) WHERE axis_id = $1', model) USING axis INTO found;
  RETURN found;
END $$;
SELECT 'a one-way residential street has one lane of the usual width' AS name, told(1) = '3.50: general3.50' AS holds;
SELECT 'against the line too', told(2) = '3.50: -general3.50';
SELECT 'a two-way one has a lane each way, as wide as its class', told(3) = '6.00: -general3.00 general3.00';
SELECT 'a stated width holds, and the class says the lanes', told(4) = '9.00: general9.00';
SELECT 'stated lanes hold', told(5) = '7.00: general3.50 general3.50';
SELECT 'a one-way primary street has two', told(6) = '7.00: general3.50 general3.50';
SELECT 'but no more than its width holds', told(7) = '4.00: general4.00';
SELECT 'a roundabout is as wide as its class, and has what that holds', told(8) = '6.00: general3.00 general3.00';
SELECT 'but two at most', told(11) = '9.00: general4.50 general4.50';
SELECT 'a street without a class has what its width holds', told(9) = '6.00: general3.00 general3.00';
SELECT 'a two-way street has what its width holds', told(10) LIKE '15.00: -general3.75 -general3.75 general3.75 general3.75';

UPDATE town.axis_class SET lanes_each_way = 1 WHERE class = 'tertiary';
UPDATE town.axis_class SET lanes_one_way = 2, width_one_way = 6.4 WHERE class = 'residential';
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'a class may say the lanes of each direction', told(10) = '15.00: -general7.50 general7.50';
SELECT 'and lanes and width of a one-way street', told(1) = '6.40: general3.20 general3.20' AND told(4) = '9.00: general4.50 general4.50';
UPDATE town.axis_class SET lanes_one_way = NULL, width_one_way = NULL WHERE class = 'residential';
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'without them it has what its width holds', told(1) = '6.00: general3.00 general3.00';

-- Parking, beside the usual width.
UPDATE town.axis_class SET lanes_one_way = 1, parking_left = 2.5, parking_right = 2 WHERE class = 'residential';
UPDATE town.axis_class SET parking_left = 2, parking_right = 2.25 WHERE class = 'service';
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'parking lies beside the usual width, on its side', told(1) = '8.00: parking2.50 general3.50 parking2.00';
SELECT 'the side is that of the traffic', told(2) = '8.00: -parking2.00 -general3.50 -parking2.50';
SELECT 'on a two-way street that of the axis', told(3) = '10.50: -parking2.50 -general3.00 general3.00 parking2.00';
SELECT 'a street too narrow for two lanes beside it has one for both directions', told(12) = '8.25: -parking2.00 general4.00 parking2.25' AND told(13) = '8.25: -parking2.00 general4.00 parking2.25';
SELECT 'where a width or lanes are stated there is none', told(4) = '9.00: general9.00' AND told(5) = '7.00: general3.50 general3.50';
DELETE FROM anew.axis_class;
INSERT INTO anew.axis_class TABLE town.axis_class;
SELECT 'all is as from scratch', test.followed('town', 'anew');
UPDATE town.axis SET geom = ST_Reverse(geom), direction = 'reverse' WHERE axis_id = 1;
SELECT 'drawn backward it is the same street', told(1) = '8.00: -parking2.00 -general3.50 -parking2.50';
SELECT streetgen.set('town', 'driving_side', 'left') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'where one drives on the left too', told(3) = '10.50: parking2.50 general3.00 -general3.00 -parking2.00' AND told(2) = '8.00: -parking2.00 -general3.50 -parking2.50';
SELECT 'so has the narrow street', told(12) = '8.25: parking2.00 general4.00 -parking2.25';
SELECT 'negative parking is refused', test.state('UPDATE town.axis_class SET parking_left = -1') = '23514';

-- What an extract says of a class.
CREATE TABLE way (id integer, geom geometry, class text, way text, lanes integer);
CREATE FUNCTION import_ways() RETURNS TABLE(what text, class text, count bigint, source_refs text[]) LANGUAGE sql AS $$
  SELECT * FROM streetgen.import_axes('read', 'way', '{"geom": "geom", "kind": "class", "direction": "way", "lane_count": "lanes", "source_ref": "id"}') $$;
DO $$ BEGIN PERFORM streetgen.create_model('read', 2154, subjects => '{lane}', driving_side => 'right'); END $$;
INSERT INTO way SELECT n, street(n), 'residential', 'direct', 2 FROM generate_series(1, 49) n;
INSERT INTO way VALUES (100, street(100), 'residential', 'direct', NULL), (101, street(101), 'residential', 'both', NULL);
SELECT FROM import_ways() \g /dev/null
SELECT FROM streetgen.generate('read') \g /dev/null
SELECT 'of 49 ways an import learns nothing', told(axis_id, 'read') = '3.50: general3.50' FROM read.axis WHERE source_ref = '100';
INSERT INTO way VALUES (50, street(50), 'residential', 'reverse', 2);
CREATE TABLE report AS SELECT * FROM import_ways();
SELECT 'of 50 it learns the number of most, and tells it', what = '2 lanes on one-way lines that state none, as on most of so many that do' AND class = 'residential' AND count = 50 FROM report WHERE what LIKE '%lanes on one-way%';
SELECT 'and how wide the others become', array_agg(what ORDER BY what) = '{"neither width nor lanes stated, 6 m wide","neither width nor lanes stated, 7 m wide"}' FROM report WHERE what LIKE 'neither%';
SELECT FROM streetgen.generate('read') \g /dev/null
SELECT 'the others have it', told(axis_id, 'read') = '7.00: general3.50 general3.50' FROM read.axis WHERE source_ref = '100';
UPDATE read.axis_class SET lanes_one_way = 3 WHERE class = 'residential';
SELECT FROM import_ways() \g /dev/null
SELECT 'what somebody wrote stays', lanes_one_way = 3 FROM read.axis_class WHERE class = 'residential';
SELECT 'and says so', lanes_one_way_by = 'hand' FROM read.axis_class WHERE class = 'residential';
UPDATE read.axis_class SET lanes_one_way = 1 WHERE class = 'residential';
SELECT FROM import_ways() \g /dev/null
SELECT 'also where it equals the default', lanes_one_way = 1 FROM read.axis_class WHERE class = 'residential';
UPDATE read.axis_class SET speed = 20 WHERE class = 'tertiary';
SELECT 'who puts something else puts no lanes', lanes_one_way_by IS NULL FROM read.axis_class WHERE class = 'tertiary';
UPDATE read.axis_class SET lanes_one_way_by = NULL WHERE class = 'residential';
SELECT FROM import_ways() \g /dev/null
SELECT 'until it is given back to the import', lanes_one_way = 2 AND lanes_one_way_by = 'import' FROM read.axis_class WHERE class = 'residential';
SELECT 'check_model has no error', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');

-- Lines that have a lane at the kerb alone do not state how many others there are.
CREATE TABLE kerb_line (way_id bigint, class text, name text, ref text, tags jsonb, geom geometry(LineString, 2154));
INSERT INTO kerb_line SELECT i, 'residential', NULL, NULL, CASE WHEN i <= 60 THEN '{"oneway": "yes", "lanes": "2"}' ELSE '{"oneway": "yes", "cycleway:right": "lane"}' END::jsonb, street(i) FROM generate_series(1, 140) i;
INSERT INTO kerb_line SELECT i, 'tertiary', NULL, NULL, CASE WHEN i <= 240 THEN '{"oneway": "yes", "lanes": "2"}' ELSE '{"oneway": "yes", "cycleway:right": "lane"}' END::jsonb, street(i) FROM generate_series(201, 260) i;
SELECT streetgen.create_model('beside', 2154, driving_side => 'right') \g /dev/null
SELECT count(*) FROM streetgen.import_osm('beside', 'kerb') \g /dev/null
SELECT 'an import learns from stated lanes alone', (SELECT lanes_one_way FROM beside.axis_class WHERE class = 'residential') = 2;
SELECT 'and they must be enough', (SELECT lanes_one_way FROM beside.axis_class WHERE class = 'tertiary') = 1;
SELECT 'what it learned holds for the lines with a lane at the kerb', array_agg(DISTINCT kind_forward) = '{general|general|cycle}' FROM beside.axis WHERE source_ref::integer BETWEEN 61 AND 140;
SELECT 'so that the same delivery changes nothing', coalesce(sum(count) FILTER (WHERE what = 'new or changed'), 0) = 0 FROM streetgen.import_osm('beside', 'kerb');
-- Without tags of roundabouts a ring is a street.
SELECT streetgen.create_model('untagged', 2154, driving_side => 'right') \g /dev/null
SELECT streetgen.set('untagged', 'roundabout_tags', 'false') \g /dev/null
CREATE TABLE ring AS SELECT street(1) AS geom, 'residential' AS class, 'roundabout' AS tag, 'direct' AS way;
CREATE TABLE ring_told AS SELECT * FROM streetgen.import_axes('untagged', 'ring', '{"kind": "class", "roundabout_tag": "tag", "direction": "way"}');
SELECT 'and the report says the width that it has', (SELECT what FROM ring_told WHERE what LIKE 'neither width%') = format('neither width nor lanes stated, %s m wide', width) FROM untagged.axis_used;
