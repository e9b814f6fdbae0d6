\set ECHO none
\ir shared/truths.sql
\ir shared/cross_section.sql
-- The cross-section of streets: view cross_section, one cut, and what subjects give to it.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.mirrored(geometry) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Affine($1, 1, 0, 0, -1, 0, 2 * 6860000) $$;
CREATE FUNCTION pg_temp.turned(text) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(word, '|' ORDER BY n DESC) FROM string_to_table($1, '|') WITH ORDINALITY w(word, n) $$;
-- A cut as one line a side, with widths in metres.
CREATE FUNCTION pg_temp.cut(model name, axis bigint, metres float8) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(side || ':' || pieces, ' ' ORDER BY side) FROM (
    SELECT side, string_agg(concat_ws(' ', '', nullif(kerb, 'standing'), kind, trim_scale(round((offset_to - offset_from)::numeric, 3))), ',' ORDER BY "order") AS pieces
    FROM streetgen.cross_section(model, axis, metres) GROUP BY side) s $$;
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154, subjects => '{all}') FROM unnest('{town,against,mirror}'::name[]) m;
  PERFORM streetgen.set('mirror', 'driving_side', 'left');
  -- Three lanes of 4 m leave 2 m; a street that widens; one with more lanes past a node; a roadway beside its axis; two carriageways; lanes at the kerb; a bend; streets too close; a junction.
  INSERT INTO town.axis (axis_id, geom, width, width_end, roadway_offset, direction, name, lanes_forward, lanes_backward, kind_forward, kind_backward, sidewalk_left, sidewalk_right, importance) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 14, NULL, NULL, 'both', 'one', 2, 1, 'general|bus', NULL, 3, 2, 4),
    (2, pg_temp.line('LINESTRING(0 200,100 200)'), 7, 10, NULL, 'both', 'two', 1, 1, NULL, NULL, 2, 0, 4),
    (3, pg_temp.line('LINESTRING(0 400,100 400)'), 7, NULL, NULL, 'both', 'three', 1, 1, NULL, NULL, 2, 2, 4),
    (4, pg_temp.line('LINESTRING(100 400,200 400)'), 13, NULL, NULL, 'both', 'three', 2, 2, NULL, NULL, 2, 2, 4),
    (5, pg_temp.line('LINESTRING(0 600,100 600)'), 7, NULL, 6, 'both', 'five', 1, 1, NULL, NULL, 2, 3, 4),
    (6, pg_temp.line('LINESTRING(0 800,100 800)'), 7, NULL, NULL, 'direct', 'six', 2, NULL, NULL, NULL, 0, 2, 4),
    (7, pg_temp.line('LINESTRING(0 812,100 812)'), 7, NULL, NULL, 'reverse', 'six', NULL, 2, NULL, NULL, 2, 0, 4),
    (8, pg_temp.line('LINESTRING(0 1000,100 1000)'), 12.5, NULL, NULL, 'both', 'eight', 1, 1, 'general|cycle|parking', 'general|parking', 2, 2, 4),
    (9, pg_temp.line('LINESTRING(0 1200,60 1200,100 1240)'), 8, NULL, NULL, 'both', 'nine', 1, 1, NULL, NULL, 2, 2, 4),
    (10, pg_temp.line('LINESTRING(0 1400,100 1400)'), 8, NULL, NULL, 'direct', 'ten', 2, NULL, NULL, NULL, 2, 2, 4),
    (11, pg_temp.line('LINESTRING(0 1405,100 1405)'), 8, NULL, NULL, 'direct', 'eleven', 2, NULL, NULL, NULL, 2, 2, 5),
    (12, pg_temp.line('LINESTRING(0 1600,100 1600)'), 6, NULL, NULL, 'both', 'twelve', 1, 1, NULL, NULL, 2, 2, 4), (13, pg_temp.line('LINESTRING(50 1600,50 1700)'), 6, NULL, NULL, 'both', 'thirteen', 1, 1,
      NULL, NULL, 2, 2, 4);
  INSERT INTO against.axis (axis_id, geom, width, width_end, roadway_offset, direction, name, lanes_forward, lanes_backward, kind_forward, kind_backward, sidewalk_left, sidewalk_right, importance)
    SELECT axis_id, ST_Reverse(geom), coalesce(width_end, width), width, -roadway_offset, CASE direction WHEN 'direct' THEN 'reverse' WHEN 'reverse' THEN 'direct' ELSE direction END, name, lanes_backward,
      lanes_forward, kind_backward, kind_forward, sidewalk_right, sidewalk_left, importance FROM town.axis;
  INSERT INTO mirror.axis (axis_id, geom, width, width_end, roadway_offset, direction, name, lanes_forward, lanes_backward, kind_forward, kind_backward, sidewalk_left, sidewalk_right, importance)
    SELECT axis_id, pg_temp.mirrored(geom), width, width_end, -roadway_offset, direction, name, lanes_forward, lanes_backward, pg_temp.turned(kind_forward), pg_temp.turned(kind_backward), sidewalk_right,
      sidewalk_left, importance FROM town.axis;
END $$;
SELECT m || ': ' || name, holds FROM unnest('{town,against,mirror}'::name[]) m, test.cross_section(m);

-- Widths by hand: 14 m less three lanes of 4 m leave 2 m, half of it on either side, with 0.3 m of gutter. A sidewalk of 3 m keeps 1.7 m beside stones and furnishing, one of 2 m has none.
SELECT 'lanes, shoulder, gutter, kerb, furnishing, sidewalk, ground', pg_temp.cut('town', 1, 50) = 'left: general 2, general 4, shoulder 0.7, gutter 0.3, kerb 0.3, furnishing 1, sidewalk 1.7, outer'
  || ' right: general 2, bus 4, shoulder 0.7, gutter 0.3, kerb 0.3, sidewalk 1.7, outer';
SELECT 'a lane on both sides of the axis is one', count(*) = 2 AND count(DISTINCT lane_id) = 1 FROM streetgen.cross_section('town', 1, 50) WHERE "order" = 1;
SELECT 'a street that widens is as wide as it is there', pg_temp.cut('town', 2, 25) ~ '^left: general 3.875, kerb 0.3, sidewalk 1.7, outer right: general 3.875, kerb 0.3, outer$'
  AND pg_temp.cut('town', 2, 75) ~ '^left: general 4.625';
SELECT 'heights are not known', bool_and(height IS NULL) FROM streetgen.cross_section('town', 1, 50);
SELECT 'past a taper the lanes are those of the edge', pg_temp.cut('town', 4, 90) ~ '^left: general 3.25, general 3.25, kerb' AND pg_temp.cut('town', 3, 10) ~ '^left: general 3.5, kerb';
SELECT 'an axis at the border of its roadway has all lanes on one side', pg_temp.cut('town', 5, 50) = 'left: general 3.5, general 3.5, kerb 0.3, sidewalk 1.7, outer right: kerb 0.3, furnishing 1, sidewalk 1.7, outer';
SELECT 'between carriageways lies a median', pg_temp.cut('town', 6, 50) ~ '^left: general 3.5, kerb 0.3, median right: .*outer$' AND pg_temp.cut('town', 7, 50) ~ '^left: .*outer right: general 3.5, kerb 0.3, median$';
SELECT 'cycle and parking lanes', pg_temp.cut('town', 8, 50) ~ '^left: general 0.75, general 3.5, parking 2, kerb .* right: general 2.75, cycle 1.5, parking 2, kerb ';
SELECT 'a border to roadway has no kerb', pg_temp.cut('town', 10, 50) = 'left: general 4, none kerb 0, roadway right: general 4, kerb 0.3, sidewalk 1.7, outer';

-- Drawn backward the street is the same, and on the left it is its image.
SELECT 'drawn backward it is the same', count(*) > 100 AND count(*) = count(b.edge_id)
  FROM (SELECT c.*, ST_Length(a.geom) AS long FROM town.cross_section c JOIN town.axis a USING (axis_id)) c LEFT JOIN against.cross_section b ON b.axis_id = c.axis_id AND b.side <> c.side
    AND b."order" = c."order" AND b.kind = c.kind AND b.kerb IS NOT DISTINCT FROM c.kerb AND abs(b.start_abscissa + c.end_abscissa - long) < 1e-4 AND abs(b.end_abscissa + c.start_abscissa - long) < 1e-4
    AND abs(b.offset_from - c.offset_from_end) < 1e-6 AND abs(b.offset_from_end - c.offset_from) < 1e-6;
SELECT 'driven on the left it is the image', count(*) > 100 AND count(*) = count(b.edge_id)
  FROM town.cross_section c LEFT JOIN mirror.cross_section b ON b.axis_id = c.axis_id AND b.side <> c.side
    AND b."order" = c."order" AND b.kind = c.kind AND b.kerb IS NOT DISTINCT FROM c.kerb AND abs(b.start_abscissa - c.start_abscissa) < 1e-4 AND abs(b.end_abscissa - c.end_abscissa) < 1e-4
    AND abs(b.offset_from - c.offset_from) < 1e-6 AND abs(b.offset_from_end - c.offset_from_end) < 1e-6;

-- Objects: at a crossing the kerb is flush, askew further on at one side; a bay takes from lanes.
INSERT INTO town.pedestrian_crossing_editing (geom, width, angle) VALUES (pg_temp.line('POINT(30 0)'), 4, 90), (pg_temp.line('POINT(70 0)'), 4, 45);
INSERT INTO town.parking_bay_editing (geom, length, width, angle) VALUES (pg_temp.line('POINT(50 204.25)'), 5, 2.3, 0), (pg_temp.line('POINT(30 196.05)'), 4, 2.5, 90);
SELECT 'the kerb is flush at a crossing', pg_temp.cut('town', 1, 31.9) ~ 'flush kerb.*flush kerb' AND pg_temp.cut('town', 1, 32.1) !~ 'flush';
SELECT 'at its mouth on each side', pg_temp.cut('town', 1, 77) ~ '^left.*flush kerb.*right' AND pg_temp.cut('town', 1, 77) !~ 'right.*flush' AND pg_temp.cut('town', 1, 63) ~ 'right.*flush' AND pg_temp.cut('town', 1, 70) !~ 'flush';
SELECT 'a bay lies before its kerb', pg_temp.cut('town', 2, 50) ~ '^left: general 1.95, bay 2.3, kerb .* right: general 4.25, kerb' AND pg_temp.cut('town', 2, 53) !~ 'bay';
SELECT 'one across the street is as deep as long, and may pass the axis', pg_temp.cut('town', 2, 30) ~ '^left: bay 0.05, general 3.9, kerb .* right: bay 3.95, kerb';
-- Behind a bay goes on what lies between it and the kerb; before a bay behind its kerb one drives over the kerb, whose stone lies in the ground of the bay.
INSERT INTO town.axis (axis_id, geom, width, direction, name, lanes_forward, lanes_backward, kind_forward, kind_backward, sidewalk_left, sidewalk_right, importance) VALUES
  (14, pg_temp.line('LINESTRING(0 1800,100 1800)'), 14, 'both', 'fourteen', 1, 1, 'general|parking|cycle', 'general|parking|cycle', 4, 4, 4);
INSERT INTO town.parking_bay_editing (axis_id, abscissa, side, axis_offset, length, width, angle) VALUES (14, 50, 'right', -1.5, 5, 2, 0), (14, 50, 'left', -2, 5, 1, 0), (14, 70, 'right', 2, 5, 2, 0), (14, 70, 'left', 1, 5, 2, 0),
  (14, 30, 'right', 3.5, 5, 2, 0);
SELECT 'a cycle lane between a bay and the kerb', pg_temp.cut('town', 14, 50) ~ ' right: general 3.5, bay 2, cycle 1.5, kerb 0.3, furnishing 1, sidewalk 2.7, outer$';
SELECT 'a bay parts its lane', pg_temp.cut('town', 14, 50) ~ '^left: general 3.5, parking 0.5, bay 1, parking 0.5, cycle 1.5, kerb 0.3, furnishing 1, sidewalk 2.7, outer right';
SELECT 'a bay behind the kerb takes from the sidewalk', pg_temp.cut('town', 14, 70) ~ ' right: general 3.5, parking 2, cycle 1.5, flush kerb 0, bay 2, sidewalk 2, outer$';
SELECT 'and one on both sides of it from both', pg_temp.cut('town', 14, 70) ~ '^left: general 3.5, parking 2, cycle 0.5, bay 1, flush kerb 0, bay 1, furnishing 1, sidewalk 2, outer right';
SELECT 'one away from its kerb lies on other ground', pg_temp.cut('town', 14, 30) !~ 'bay';
SELECT 'each part of a lane is drawn', (SELECT count(*) FROM regexp_matches(streetgen.cross_section_svg('town', 14, 50), '>0\.50<', 'g')) = 2;
SELECT 'with objects: ' || name, holds FROM test.cross_section('town');
-- Sidewalks by hand, lanes by hand, settings.
UPDATE town.sidewalk_editing SET width = 4 WHERE edge_id IN (SELECT edge_id FROM town.edge WHERE axis_id = 2) AND side = 'left';
SELECT 'a sidewalk by hand', pg_temp.cut('town', 2, 10) ~ '^left: .*, furnishing 1, sidewalk 2.7, outer';
UPDATE town.lane_editing SET geom = ST_Translate(geom, 0, 0.3) WHERE edge_id IN (SELECT edge_id FROM town.edge WHERE axis_id = 4) AND ordinality = 1;
SELECT 'a lane drawn by hand keeps the place that its neighbours leave', pg_temp.cut('town', 4, 90) ~ '^left: general 3.25, general 3.25, kerb' AND (SELECT count(*) > 0 FROM town.lane WHERE method = 'by_hand');
SELECT 'with decisions: ' || name, holds FROM test.cross_section('town') WHERE name !~ 'ground';
SELECT streetgen.set('town', 'gutter_width', '0.5'), streetgen.set('town', 'furnishing_width', '0') \g /dev/null
SELECT 'settings hold at once', pg_temp.cut('town', 1, 50) ~ '^left: general 2, general 4, shoulder 0.5, gutter 0.5, kerb 0.3, sidewalk 2.7, outer';
SELECT 'and no street waits for a run', count(*) = 0 FROM streetgen.check_model('town') WHERE rule ~ 'setting|stale|changed';

-- Drawn: valid XML with the widths of the pieces, of the roadway and of all; what the owner calls a street stands in it as text.
UPDATE town.axis SET name = 'Rue <b> & "x"' WHERE axis_id = 1;
CREATE TEMPORARY TABLE drawn AS SELECT streetgen.cross_section_svg('town', 1, 50) AS svg;
SELECT 'a cut is drawn with its widths', xml_is_well_formed_document(svg) AND svg ~ '>14.00<' AND svg ~ '>3.00<' AND svg ~ '>2.00<' AND svg ~ '>19.00<' AND svg ~ '>bus lane ↑<' AND svg ~ '>lane ↓<' FROM drawn;
SELECT 'each width once', (SELECT count(*) FROM regexp_matches(svg, '>4\.00<', 'g')) = 3 FROM drawn;
SELECT 'names are text', svg ~ 'Rue &lt;b> &amp; &quot;x' FROM drawn;
SELECT 'in each theme', count(DISTINCT svg) = 4 AND bool_and(xml_is_well_formed_document(svg)) FROM unnest('{street,dark,print,construction}'::text[]) theme, streetgen.cross_section_svg('town', 6, 50, theme) svg;
SELECT 'at half the scale it is twice as wide', (SELECT substring(streetgen.cross_section_svg('town', 1, 50, scale => s), 'width="(\d+)"')::integer FROM unnest(ARRAY[50]) s) BETWEEN 2 * wide - 42 AND 2 * wide - 38
  FROM (SELECT substring(svg, 'width="(\d+)"')::integer AS wide FROM drawn) d;
SELECT 'in a junction it says so', streetgen.cross_section_svg('town', 12, 50) ~ 'no cross-section';
SELECT 'an unknown theme is refused', test.state($$SELECT streetgen.cross_section_svg('town', 1, 50, 'mud')$$) = '22023' AND test.state($$SELECT streetgen.cross_section_svg('town', 1, 50, NULL)$$) = '22004';
SELECT 'and a scale that is none', test.state($$SELECT streetgen.cross_section_svg('town', 1, 50, scale => 1)$$) = '22023' AND test.state($$SELECT streetgen.cross_section_svg('town', 1, 50, scale => 'NaN')$$) = '22023';
SELECT 'an axis that is none', test.state($$SELECT streetgen.cross_section_svg('town', 99, 50)$$) = '22023';

-- What is asked in vain.
SELECT 'in a junction there is none', count(*) = 0 FROM streetgen.cross_section('town', 12, 50);
SELECT 'an unknown axis is refused', test.state($$SELECT * FROM streetgen.cross_section('town', 99, 5)$$) = '22023';
SELECT 'a place off it', test.state($$SELECT * FROM streetgen.cross_section('town', 1, 101)$$) = '22023' AND test.state($$SELECT * FROM streetgen.cross_section('town', 1, -1)$$) = '22023'
  AND test.state($$SELECT * FROM streetgen.cross_section('town', 1, 'NaN')$$) = '22023';
SELECT 'NULL', test.state($$SELECT * FROM streetgen.cross_section('town', NULL, 5)$$) = '22004' AND test.state($$SELECT * FROM streetgen.cross_section('town', 1, NULL)$$) = '22004';
SELECT 'an unknown model', test.state($$SELECT * FROM streetgen.cross_section('nowhere', 1, 5)$$) = '3F000';

-- Each subject gives its pieces, and the view is there without it.
SELECT streetgen.switch_subject('town', 'object', false) \g /dev/null
SELECT 'without objects no kerb is flush and there is no bay', pg_temp.cut('town', 1, 31.9) !~ 'flush' AND pg_temp.cut('town', 2, 50) !~ 'bay';
SELECT streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT streetgen.switch_subject('town', 'sidewalk', false) \g /dev/null
SELECT 'without sidewalks the ground begins behind the stones', pg_temp.cut('town', 1, 50) ~ '^left: general 2, general 4, shoulder 0.5, gutter 0.5, kerb 0.3, outer right';
DO $$ BEGIN
  PERFORM set_config('streetgen_test.subjects', 'asked', true), streetgen.create_model('plain', 2154, subjects => '{lane}'), streetgen.create_model('bare', 2154, subjects => '{}');
  INSERT INTO plain.axis (geom, width, lane_count) VALUES (pg_temp.line('LINESTRING(0 0,100 0)'), 7, 2);
  INSERT INTO bare.axis (geom, width, lane_count) VALUES (pg_temp.line('LINESTRING(0 0,100 0)'), 7, 2);
END $$;
SELECT 'with lanes alone it ends at the border of the roadway', pg_temp.cut('plain', 1, 50) = 'left: general 3.5, outer right: general 3.5, outer';
SELECT 'and without them it is one roadway', pg_temp.cut('bare', 1, 50) = 'left: roadway 3.5, outer right: roadway 3.5, outer';
