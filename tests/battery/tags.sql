-- Ways with nonsense in their tags, through import_osm: psql -v rows=10000 -v seed=0.45.  Each row that is printed is a truth: t or f, its name.
\set ECHO none
\ir ../sql/shared/statement.sql
SELECT setseed(:seed) \g /dev/null
CREATE TEMPORARY TABLE tag_kind (kind text, keys text[], senseless text[], words text[]);
INSERT INTO tag_kind VALUES
  ('number', '{lanes,lanes:forward,lanes:backward,lanes:both_ways,lanes:reversible,lanes:psv,lanes:bus,lanes:psv:forward,lanes:bus:backward}',
    '{many,-3,1e9,99999999999999999999,3x,¾,NaN,2;3,31,0x2}', '{1,2,3,4,5,30,2.0," 2 "}'),
  ('list of turns', '{turn:lanes,turn:lanes:forward,turn:lanes:backward,turn:lanes:both_ways}', '{left;lefft|through,left|leftt,;x;|,"left,right|through",|||xyzzy,🚲|🚲}',
    '{left|right,left;through|right,|,none,left,merge_to_left|through|,reverse;left}'),
  ('list of changes', '{change:lanes,change:lanes:forward,change:lanes:backward}', '{never|no,"no,no",1|2}', '{yes|no,not_left|,only_right,no|no|no}'),
  ('list of widths', '{width:lanes,width:lanes:forward,width:lanes:backward}', '{-3|3,99.9999|3,0|0,wide|3,1e308|3,3 furlongs|3,NaN|3,∞|3}', '{3|3,3.5|,"10 ft|3,5",2.75}'),
  ('list of who', '{vehicle:lanes,access:lanes:forward,bicycle:lanes,bicycle:lanes:backward,bus:lanes,psv:lanes:forward,taxi:lanes,hov:lanes,cycleway:lanes,cycleway:lanes:forward,motor_vehicle:lanes}',
    '{xyzzy|,designatd|yes,|||-3,"yes,no|yes",läne}', '{yes|no,designated|,|yes|no,no|designated}'),
  ('word', '{oneway,oneway:bus,oneway:bicycle,centre_turn_lane,hov,access,vehicle,motor_vehicle,motorcar,bus,psv,bus:backward,access:forward,busway,busway:left,cycleway,cycleway:left,cycleway:both,
    cycleway:right:oneway,cycleway:left:lane,parking:right,parking:lane:both,parking:lane:both:parallel,parking:lane:left:marked,parking:left:orientation,placement,placement:forward}',
    '{xyzzy,-3,"yes,no",läne,🚲,"{}",lane;xyzzy,"left_of:","lane lane"}', '{yes,no,lane,opposite_lane,reversible,alternating,designated,-1,parallel,diagonal,left_of:1,right_of:2,separate}'),
  ('width of a kerb lane', '{cycleway:right:width,cycleway:both:width,cycleway:left:est_width,parking:right:width,parking:both:width}', '{-1,0,wide,1e9,3 furlongs,"1,2,3"}', '{1.5,2 m,6 ft}'),
  ('metres', '{width,width:carriageway,est_width,sidewalk:left:width,sidewalk:both:width}', '{-1,wide,1e9,3 furlongs,"1.234,5",NaN,6 mph}', '{7,"3,5 m",10 feet,"12''6\"",~6,5-6}'),
  ('speed', '{maxspeed,maxspeed:forward,zone:maxspeed}', '{fast,-30,1e9,30 furlongs,XX:urban,NaN}', '{50,30 mph,DE:zone30,walk,30;50,20 knots}'),
  ('list of speeds', '{maxspeed:lanes,maxspeed:lanes:forward,maxspeed:lanes:backward}', '{fast|50,50|-30,30 furlongs|,XX:urban|50,NaN|NaN}', '{50|,none|50,30 mph|20 mph,|}'),
  ('level', '{layer}', '{x,1e3,--1,1.5,99999999999}', '{-1,1,0,2}'),
  ('misspelt', '{Lanes,lane,turns:lanes,Oneway,cicleway,lanes:foward,access:motorcar,width:feet}', '{2,yes,xyzzy}', '{2}');
CREATE FUNCTION pg_temp.any_of(list text[]) RETURNS text LANGUAGE sql VOLATILE AS 'SELECT list[1 + floor(random() * cardinality(list))]';
-- A width of a kerb lane is asked for where there is such a lane.
CREATE TABLE osm_line AS
SELECT n AS way_id, (ARRAY['primary', 'secondary', 'residential', 'trunk', 'motorway', 'busway'])[1 + n % 6] AS class, 'street ' || n AS name, NULL::text AS ref, t.tags, t.kind, t.key,
  ST_SetSRID(ST_MakeLine(ST_MakePoint(500000 + 300 * (n % 100), 300 * (n / 100)), ST_MakePoint(500120 + 300 * (n % 100), 300 * (n / 100))), 32631) AS geom
FROM generate_series(1, :rows) n CROSS JOIN LATERAL (
  SELECT CASE WHEN n % 2 = 1 THEN jsonb_build_object(one.key, pg_temp.any_of(k.senseless)) || CASE k.kind WHEN 'width of a kerb lane' THEN '{"cycleway:both": "lane", "parking:both": "lane"}'::jsonb ELSE '{}' END
    ELSE (SELECT jsonb_object_agg(pg_temp.any_of(m.keys), pg_temp.any_of(CASE WHEN random() < 0.3 THEN m.senseless ELSE m.words END) || left('', n))
      FROM (SELECT * FROM tag_kind ORDER BY random() + 0 * n LIMIT 1 + n % 5) m) END AS tags, CASE WHEN n % 2 = 1 THEN k.kind END AS kind, one.key
  FROM (SELECT * FROM tag_kind ORDER BY random() + 0 * n LIMIT 1) k, LATERAL (SELECT pg_temp.any_of(k.keys) AS key) one) t;
SELECT streetgen.create_model('nonsense', 32631, subjects => '{lane}') \g /dev/null
CREATE TEMPORARY TABLE outcome (what text, state text, said text);
DO $$
BEGIN
  CREATE TEMPORARY TABLE told AS SELECT * FROM streetgen.import_osm('nonsense');
  PERFORM FROM streetgen.generate('nonsense');
EXCEPTION WHEN OTHERS THEN
  INSERT INTO outcome VALUES ('load', SQLSTATE, SQLERRM);
END $$;
CREATE TABLE IF NOT EXISTS told (what text, source_refs text[]);
SELECT CASE WHEN count(*) = 0 THEN 't' ELSE 'f' END, 'no nonsense stops the load' || coalesce(': ' || min(state || ' ' || said), '') FROM outcome;
SELECT CASE WHEN count(*) = :rows THEN 't' ELSE 'f' END, 'each way becomes a street' FROM nonsense.axis;
SELECT CASE WHEN count(l.way_id) = 0 THEN 't' ELSE 'f' END, k.kind || ': each way is named' || coalesce(', but not ' || (array_agg(l.class || ' ' || l.tags::text ORDER BY l.way_id))[1] || ' and ' || nullif(count(*) - 1, 0) || ' more', '')
FROM tag_kind k LEFT JOIN osm_line l ON l.kind = k.kind AND NOT EXISTS (SELECT FROM told t WHERE t.what ~ 'not understood' AND l.way_id::text = ANY (t.source_refs)) GROUP BY k.kind ORDER BY k.kind;
SELECT CASE WHEN count(*) = 0 THEN 't' ELSE 'f' END, 'with the tag and a reason' FROM nonsense.unread_tag u JOIN osm_line l ON l.way_id::text = u.source_ref
  WHERE coalesce(u.reason, '') = '' OR NOT (l.tags ? u.tag OR u.tag = 'highway');
-- Each tag of ways that the page of tags has, with a word that means nothing.
CREATE FUNCTION pg_temp.keys_of(written text) RETURNS SETOF text LANGUAGE plpgsql AS $$
DECLARE
  parts constant text[] := regexp_match(written, '^([^][]*)\[([^][]*)\](.*)$');
BEGIN
  IF parts IS NULL THEN
    RETURN NEXT written;
  ELSE
    RETURN QUERY SELECT keys_of FROM unnest(string_to_array(parts[2], '|')) word, pg_temp.keys_of(parts[1] || word || parts[3]);
  END IF;
END $$;
CREATE TABLE every_line AS SELECT row_number() OVER () AS way_id, CASE WHEN walked THEN 'footway' ELSE 'primary' END AS class, NULL::text AS name, NULL::text AS ref,
  CASE WHEN walked THEN '{"footway": "crossing"}' ELSE '{}' END::jsonb || jsonb_build_object(key, 'xyzzy') AS tags, key,
  ST_SetSRID(ST_MakeLine(ST_MakePoint(500000, 300 * row_number() OVER ()), ST_MakePoint(500120, 300 * row_number() OVER ())), 32631) AS geom
-- Of what is walked on a crossing has all tags; any word is a surface.
FROM (SELECT key, bool_and(u.becomes LIKE 'Of what%' AND u.becomes NOT LIKE '%left out%') AS walked FROM streetgen.tag_use() u, regexp_split_to_table(u.tag, ',\s*') part, pg_temp.keys_of(btrim(part)) key WHERE u.source ~ '^OpenStreetMap, (lanes|ways)' AND key <> 'surface' GROUP BY key HAVING bool_and(u.becomes NOT LIKE 'Nothing%')) k;
SELECT streetgen.create_model('every_tag', 32631, subjects => '{lane}') \g /dev/null
CREATE TEMPORARY TABLE every_told AS SELECT * FROM streetgen.import_osm('every_tag', 'every');
-- Texts of any words, surfaces among them, values beside those that say something of a street, and widths of lanes that are not there.
SELECT CASE WHEN count(*) = 0 AND (SELECT count(*) FROM every_line) > 120 THEN 't' ELSE 'f' END, 'a word that means nothing is named, whichever tag has it' || coalesce(', but not ' || string_agg(key, ', '), '')
FROM every_line l WHERE key !~ '^((source:)?maxspeed(:type)?|name|ref|highway|aeroway|area|junction|bridge|tunnel|bicycle(:forward|:backward)?|cycleway:(est_)?width|.*:surface)$' AND NOT EXISTS (SELECT FROM every_told t WHERE t.what ~ 'not understood' AND l.way_id::text = ANY (t.source_refs));
