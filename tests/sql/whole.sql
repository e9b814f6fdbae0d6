\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- The first run of a whole model: rows, then indexes and keys.  Each SELECT is one truth: (name, holds).
CREATE VIEW public.source AS
    SELECT 1 + i AS axis_id, ST_SetSRID(ST_MakeLine(ST_Point(650000 + 70 * (i / 2 % 25), 6860000 + 60 * (i / 50)), ST_Point(650000 + 70 * (i / 2 % 25 + (i + 1) % 2), 6860000 + 60 * (i / 50 + i % 2))), 2154) AS geom,
           4 + i % 7 AS width, 1 + i % 4 AS importance FROM generate_series(0, 1049) i;
CREATE PROCEDURE public.town(model name, many integer) LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, 2154);
    PERFORM set_config('streetgen.live', 'off', true);
    EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, importance) SELECT * FROM source WHERE axis_id <= $1', model) USING many;
    PERFORM set_config('streetgen.live', '', true);
END $$;
-- What a model is made of, apart from its rows: each index also by its key in the catalogue, which is new where it was made anew.
CREATE FUNCTION public.made_of(model name) RETURNS TABLE(what text, key oid) LANGUAGE sql AS $$
    SELECT pg_get_indexdef(indexrelid) || coalesce(obj_description(indexrelid, 'pg_class'), '') || indisreplident, indexrelid FROM pg_index JOIN pg_class c ON c.oid = indrelid WHERE relnamespace = model::text::regnamespace
    UNION ALL SELECT conrelid::regclass || ' ' || conname || pg_get_constraintdef(k.oid) || coalesce(obj_description(k.oid, 'pg_constraint'), ''), NULL FROM pg_constraint k WHERE connamespace = model::text::regnamespace
    UNION ALL SELECT c.relname || c.relreplident::text || coalesce(c.relacl::text, ''), NULL FROM pg_class c WHERE relnamespace = model::text::regnamespace AND relkind <> 'i'
    UNION ALL SELECT tgrelid::regclass || tgname || tgenabled::text, NULL FROM pg_trigger t JOIN pg_class c ON c.oid = tgrelid WHERE relnamespace = model::text::regnamespace AND NOT tgisinternal $$;

CALL town('whole', 1050);
CALL town('parts', 1050);
CALL town('small', 90);
CALL town('watched', 1050);
COMMENT ON INDEX whole.lane_geom IS 'lanes by place';
COMMENT ON INDEX whole.node_pkey IS 'nodes by id';
COMMENT ON CONSTRAINT node_pkey ON whole.node IS 'a node each';
COMMENT ON CONSTRAINT edge_from_node_fkey ON whole.edge IS 'where it begins';
CREATE INDEX own ON whole.corner (method) WHERE radius > 0;
ALTER TABLE whole.report REPLICA IDENTITY FULL;
CREATE UNIQUE INDEX section_identity ON whole.section (edge_id);
ALTER TABLE whole.section REPLICA IDENTITY USING INDEX section_identity;
GRANT SELECT ON whole.lane TO PUBLIC;
CREATE VIEW whole.lane_of_others AS SELECT lane_id, width FROM whole.lane GROUP BY lane_id;
CREATE TABLE whole.sign (intersection bigint REFERENCES whole.intersection);
SELECT setval(m || '.lane_lane_id_seq', 41) FROM unnest(ARRAY['whole', 'watched']) m \g /dev/null
CREATE TABLE before AS SELECT * FROM made_of('whole');
CREATE TABLE counted AS SELECT * FROM streetgen.generate('whole');
SELECT 'indexes are made after the rows', (SELECT key FROM before WHERE what LIKE '% lane_geom %') <> 'whole.lane_geom'::regclass;
SELECT 'and are, with constraints, comments, rights and replica identities, as before', NOT EXISTS ((SELECT what FROM before EXCEPT ALL SELECT what FROM made_of('whole')) UNION ALL (SELECT what FROM made_of('whole') EXCEPT ALL SELECT what FROM before));
SELECT 'ids begin where their sequence stands and have no gap', min(lane_id) = 42 AND max(lane_id) = 41 + count(*) FROM whole.lane;
SELECT format('SELECT ''the sequence of %1$s goes on after its last id'', max(%2$I) = pg_sequence_last_value(%3$L) FROM whole.%1$I', relation, attname, pg_get_serial_sequence('whole.' || relation, attname))
    FROM unnest(streetgen._computed_tables('whole')) relation JOIN pg_attribute ON attrelid = ('whole.' || relation)::regclass AND attidentity <> '' \gexec
SELECT 'and so are keys of rows', (SELECT key FROM before WHERE what LIKE '% node_pkey %') <> 'whole.node_pkey'::regclass AND (SELECT key FROM before WHERE what LIKE '% lane_edge_id_ordinality_key %') <> 'whole.lane_edge_id_ordinality_key'::regclass;
SELECT 'but not where a view or a table of others builds on them', (SELECT key FROM before WHERE what LIKE '% lane_pkey %') = 'whole.lane_pkey'::regclass AND (SELECT key FROM before WHERE what LIKE '% intersection_pkey %') = 'whole.intersection_pkey'::regclass;
SELECT 'keys of rows hold', test.state($$INSERT INTO whole.node SELECT * FROM whole.node LIMIT 1$$) = '23505';
SELECT 'an index that tells rows for replication stays on', (SELECT key FROM before WHERE what LIKE '% section_identity %') = 'whole.section_identity'::regclass;
SELECT 'tables have statistics', bool_and(reltuples > 0) FROM pg_class WHERE relnamespace = 'whole'::regnamespace AND relname IN ('node', 'edge', 'lane', 'interconnection');
SELECT 'foreign keys hold', test.state($$INSERT INTO whole.section_limit SELECT 1000000, -1, which, wanted_abscissa, abscissa, geom, border_line, method FROM whole.section_limit LIMIT 1$$) = '23503';
CREATE TRIGGER seen AFTER INSERT ON watched.node EXECUTE FUNCTION whole._begin_edit();
CREATE TABLE watched_before AS SELECT * FROM made_of('watched');
SELECT 'both ways count alike', count(*) = 11 AND bool_and(c = g) FROM counted c JOIN streetgen.generate('watched') g USING (relation);
SELECT 'beside a trigger of others nothing is taken off', NOT EXISTS (SELECT * FROM watched_before EXCEPT SELECT * FROM made_of('watched'));
SELECT 'and the streets are the same, keys too', test.same('whole', 'watched')
    AND NOT EXISTS (SELECT t::text FROM whole.lane t EXCEPT SELECT t::text FROM watched.lane t) AND NOT EXISTS (SELECT t::text FROM whole.corner t EXCEPT SELECT t::text FROM watched.corner t)
    AND NOT EXISTS (SELECT t::text FROM whole.interconnection t EXCEPT SELECT t::text FROM watched.interconnection t);
CREATE TABLE small_before AS SELECT * FROM made_of('small');
SELECT streetgen.generate('small') \g /dev/null
SELECT 'of a small model nothing is taken off', NOT EXISTS (SELECT * FROM small_before EXCEPT SELECT * FROM made_of('small'));
CREATE TABLE after AS SELECT * FROM made_of('whole');
SELECT 'a second run finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('whole');
SELECT 'and takes nothing off', NOT EXISTS (SELECT * FROM after EXCEPT SELECT * FROM made_of('whole'));
CREATE TABLE parts_before AS SELECT * FROM made_of('parts');
BEGIN;
DECLARE reading CURSOR FOR SELECT * FROM parts.edge;
SELECT 'where this session reads a table nothing is taken off', sum(inserted) > 0 FROM streetgen.generate('parts');
SELECT 'nothing at all', NOT EXISTS (SELECT * FROM parts_before EXCEPT SELECT * FROM made_of('parts'));
ROLLBACK;
BEGIN;
SELECT streetgen.generate('parts') \g /dev/null
ROLLBACK;
SELECT 'a run rolled back leaves all as it was', NOT EXISTS (SELECT * FROM parts_before EXCEPT SELECT * FROM made_of('parts')) AND NOT EXISTS (SELECT FROM parts.node);
BEGIN;
SELECT 'all axes one by one, whatever else is named, are a whole model', sum(inserted) = (SELECT sum(inserted) FROM counted) AND sum(skipped) = 2 FROM streetgen.generate('parts', ARRAY[-1, 7000, 1] || ARRAY(SELECT axis_id FROM parts.axis));
SELECT 'whose indexes are made after the rows', (SELECT key FROM parts_before WHERE what LIKE '% lane_geom %') <> 'parts.lane_geom'::regclass;
UPDATE parts.setting SET value = '0.7' WHERE name = 'tolerance';
SELECT 'after a change of settings all but one are a part', test.state($$SELECT FROM streetgen.generate('parts', ARRAY(SELECT axis_id FROM parts.axis WHERE axis_id > 1))$$) = '55000';
SELECT 'and all of them are none', sum(inserted + updated) > 0 FROM streetgen.generate('parts', ARRAY(SELECT axis_id FROM parts.axis));
ROLLBACK;
BEGIN;
ALTER TABLE parts.node ALTER node_id SET INCREMENT 2;
SELECT streetgen.generate('parts') \g /dev/null
SELECT 'ids step as their sequence does', count(DISTINCT node_id % 2) = 1 AND count(*) > 500 FROM parts.node;
ROLLBACK;
-- TRUNCATE would refuse.
CREATE TABLE noted (node_id bigint REFERENCES parts.node, word text);
SELECT 'a table of others may refer to one of the model', sum(inserted) > 0 FROM streetgen.generate('parts');
SELECT 'and its key holds', test.state($$INSERT INTO noted VALUES (-1, 'nowhere')$$) = '23503' AND test.state($$INSERT INTO noted SELECT node_id, 'here' FROM parts.node$$) = 'none';
