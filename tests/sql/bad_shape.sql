\set ECHO none
\ir shared/truths.sql
-- Streets that nobody would draw so: each gives sound surfaces, or one clear refusal.
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
-- The errors of a model made of these axes, after a run and an edit of each axis; and how many surfaces it has.
CREATE FUNCTION pg_temp.drawn(axes text[], widths float8[], directions text[], settings jsonb DEFAULT '{}') RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  said text;
  s record;
BEGIN
  PERFORM streetgen.create_model('odd', 2154, subjects => '{interconnection,kerb}');
  FOR s IN SELECT * FROM jsonb_each_text(settings) LOOP PERFORM streetgen.set('odd', s.key, s.value); END LOOP;
  INSERT INTO odd.axis (geom, width, direction) SELECT pg_temp.line(a), coalesce(w, 7), coalesce(d, 'both') FROM unnest(axes, widths, directions) u(a, w, d);
  PERFORM count(*) FROM streetgen.generate('odd', wait => true);
  UPDATE odd.axis SET geom = ST_Translate(geom, 0.25, 0);
  SELECT coalesce(string_agg(DISTINCT rule, ', '), 'sound') || ', ' || (SELECT count(*) > 0 FROM odd.section WHERE NOT ST_IsEmpty(surface)) INTO said FROM streetgen.check_model('odd') WHERE severity = 'error';
  PERFORM streetgen.drop_model('odd');
  RETURN said;
END $$;
SELECT 'a taper longer than the street', pg_temp.drawn('{"LINESTRING(0 0, 100 0)","LINESTRING(100 0, 106 0)","LINESTRING(106 0, 200 0)"}', '{6,14,6}', '{}', '{"transition_length": "60"}') = 'sound, true';
SELECT 'a taper by a ratio of 1 to 40 on a street of 6 m', pg_temp.drawn('{"LINESTRING(0 0, 100 0)","LINESTRING(100 0, 106 0)","LINESTRING(106 0, 200 0)"}', '{6,14,6}', '{}', '{"taper_ratio": "{\"0\": 40}"}') = 'sound, true';
SELECT 'a median of a centimetre', pg_temp.drawn('{"LINESTRING(0 0, 100 0)","LINESTRING(100 7.01, 0 7.01)","LINESTRING(100 0, 130 3.5)","LINESTRING(130 3.5, 100 7.01)","LINESTRING(130 3.5, 200 3.5)"}', '{7,7,7,7,10}', '{direct,direct,direct,direct,both}') = 'sound, true';
SELECT 'a median of a hundred metres', pg_temp.drawn('{"LINESTRING(0 0, 100 0)","LINESTRING(100 100, 0 100)","LINESTRING(100 0, 130 50)","LINESTRING(130 50, 100 100)","LINESTRING(130 50, 200 50)"}', '{7,7,7,7,10}', '{direct,direct,direct,direct,both}', '{"median_width_minimal": "10"}') = 'sound, true';
SELECT 'carriageways that cross each other', pg_temp.drawn('{"LINESTRING(0 0, 100 10, 200 0)","LINESTRING(200 10, 100 0, 0 10)"}', '{7,7}', '{direct,direct}') = 'sound, true';
SELECT 'a roundabout drawn against its traffic', pg_temp.drawn('{"LINESTRING(20 0, 0 -20, -20 0, 0 20, 20 0)","LINESTRING(20 0, 100 0)","LINESTRING(-20 0, -100 0)","LINESTRING(0 20, 0 100)"}', '{7,7,7,7}', '{direct,both,both,both}') = 'sound, true';
SELECT 'an axis that bends back beside itself', pg_temp.drawn('{"LINESTRING(0 0, 100 0, 101 3, 0 3.2)","LINESTRING(0 3.2, -60 40)"}', '{7,7}', '{}') = 'sound, true';
SELECT 'an axis that turns back on itself', pg_temp.drawn('{"LINESTRING(0 0, 100 0, 40 0)","LINESTRING(0 0, -60 40)"}', '{7,7}', '{}') = 'sound, true';
SELECT 'a nose radius wider than its island', pg_temp.drawn('{"LINESTRING(0 0, 60 0)","LINESTRING(60 0, 30 26)","LINESTRING(30 26, 0 0)","LINESTRING(60 0, 120 0)","LINESTRING(0 0, -60 0)"}', '{18,18,18,7,7}', '{}', '{"island_nose_radius": "5"}') = 'sound, true';
-- Each of these settings refuses what makes no sense, naming itself.
SELECT format('%s cannot be %s', setting, value), test.state(format('SELECT streetgen.set(''even'', %L, %L)', setting, value)) = '22023'
FROM (SELECT streetgen.create_model('even', 2154)) m,
    unnest('{corner_length,corner_area,follow_length,follow_area,limit_distance,median_width_minimal,median_width_maximal,island_area,island_area_minimal,island_nose_radius,kerb_radius_minimal,slit_width}'::text[]) setting, unnest('{-1,NaN,Infinity,wide}'::text[]) value ORDER BY setting COLLATE "C", value COLLATE "C";
SELECT 'taper_ratio cannot be ' || value, test.state(format('SELECT streetgen.set(''even'', ''taper_ratio'', %L)', value)) = '22023' FROM unnest('{0,"{\"50\": -1}","{\"50\": \"NaN\"}"}'::text[]) value;
