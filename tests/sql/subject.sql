\set ECHO none
\ir shared/truths.sql
-- Subjects: a model computes those that it wants; a computed table is a row of one list, its folder and its page.
-- Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.draw(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width, lane_count) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 2), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860010)', 7, 2),
    (3, 'SRID=2154;LINESTRING(650100 6860000,650100 6860090)', 6, 2)$q$, model);
END $$;
CREATE FUNCTION pg_temp.relations(model name) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(relname, ' ' ORDER BY relname) FROM pg_class WHERE relnamespace = model::regnamespace AND relkind IN ('r', 'v')
    AND relname IN ('section', 'lane', 'lane_separator', 'marking', 'interconnection', 'conflict', 'lane_editing', 'interconnection_editing') $$;

-- The frame finds what a subject gives by name: a name that is written wrongly is missing here, or of no room.
SELECT 'subject ' || subject || ' has ' || format(called, subject), to_regprocedure('streetgen.' || format(called, subject)) IS NOT NULL
  FROM streetgen._subject(), (VALUES ('_check_%s(name)'), ('_%s_summary()')) v(called);
SELECT 'subject ' || subject || ' has a template of its tables', array_agg(t.relation ORDER BY t.relation) = (SELECT array_agg(relation ORDER BY relation) FROM streetgen.template WHERE (room, part) = (subject, 'table'))
  FROM streetgen._subject() JOIN streetgen._computed_table() t USING (subject) GROUP BY subject ORDER BY subject;
SELECT 'subject ' || subject || ' is computed', to_regprocedure(format('streetgen._upsert_%s(jsonb)', computed_by)) IS NOT NULL OR to_regprocedure(format('streetgen._update_%s(name, bigint[], streetgen.moved_row[], bigint[])', computed_by)) IS NOT NULL
  FROM streetgen._subject(), LATERAL (SELECT CASE subject WHEN 'signal' THEN 'junction' ELSE subject END AS computed_by) c;
SELECT 'every list is that of a room', array_agg(proname ORDER BY proname) = '{_default_setting,_subject_view}' FROM pg_proc, LATERAL (SELECT '_(setting|setting_beside|summary|drawn|drawn_instead|legend|edit_view|decision|marked_by_hand|view|chain|edited)$' AS list) l
  WHERE pronamespace = 'streetgen'::regnamespace AND pronargs = 0 AND proname ~ ('^_[a-z]+' || list) AND regexp_replace(substr(proname, 2), list, '') <> ALL (streetgen._rooms());

SELECT streetgen.create_model('whole', 2154) \g /dev/null
SELECT streetgen.create_model('bare', 2154, subjects => '{}') \g /dev/null
SELECT streetgen.create_model('laned', 2154, subjects => '{lane}') \g /dev/null
SELECT pg_temp.draw(m) FROM unnest('{whole,bare,laned}'::name[]) m \g /dev/null
SELECT 'a model computes the streets, lanes and interconnections unless told otherwise', array_agg(subject ORDER BY subject) = '{interconnection,lane,network,surface}' FROM streetgen.subject('whole') WHERE wanted;
SELECT 'a subject brings what it needs', array_agg(subject ORDER BY subject) = '{lane,network,surface}' FROM streetgen.subject('laned') WHERE wanted;
SELECT 'a model of no subject has the roadway', array_agg(subject ORDER BY subject) = '{network,surface}' FROM streetgen.subject('bare') WHERE wanted;
SELECT streetgen.create_model('full', 2154, subjects => '{all}'), streetgen.create_model('named', 2154, subjects => '{default,kerb}'), streetgen.create_model('seen', 2154, subjects => '{drawn}') \g /dev/null
SELECT 'the word all stands for every subject', bool_and(wanted) AND count(*) >= 16 FROM streetgen.subject('full');
SELECT 'the word default for those of a model of which nothing is said, beside others', array_agg(subject ORDER BY subject) = '{interconnection,kerb,lane,network,surface}' FROM streetgen.subject('named') WHERE wanted;
SELECT 'the word drawn for those that pictures show', array_agg(subject ORDER BY subject) = '{fit,height,ramp}' FROM streetgen.subject('seen') WHERE NOT wanted;
SELECT 'none of them is a subject that can be switched', (test.refusal(format('SELECT FROM streetgen.switch_subject(''named'', %L, true)', word))).state = '22023' FROM (VALUES ('all'), ('default'), ('drawn')) v(word);
DO $$ BEGIN PERFORM streetgen.drop_model('full'), streetgen.drop_model('named'), streetgen.drop_model('seen'); END $$;
SELECT 'tables and views of a subject are there only with it', pg_temp.relations('bare') = 'section' AND pg_temp.relations('laned') = 'lane lane_editing lane_separator marking section'
  AND pg_temp.relations('whole') = 'conflict interconnection interconnection_editing lane lane_editing lane_separator marking section';
SELECT 'streets follow edits in each of them', (SELECT count(*) FROM bare.section) = 3 AND (SELECT count(*) FROM laned.lane) = 6 AND (SELECT count(*) > 0 FROM whole.interconnection);
SELECT 'surfaces are the same in all', NOT EXISTS (SELECT surface FROM whole.section EXCEPT SELECT surface FROM bare.section)
  AND NOT EXISTS (SELECT surface FROM whole.intersection EXCEPT SELECT surface FROM bare.intersection);
SELECT 'generate counts the tables that are there', array_agg(relation) = streetgen._computed_tables('laned')::text[] FROM streetgen.generate('laned');
SELECT 'and has nothing to do', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('bare');
SELECT 'each of them is sound: ' || m, (SELECT count(*) = 0 FROM streetgen.check_model(m) WHERE severity = 'error') FROM unnest('{whole,bare,laned}'::name[]) m;
SELECT 'each of them is summed up: ' || m, (SELECT count(*) > 5 FROM streetgen.summary(m)) FROM unnest('{whole,bare,laned}'::name[]) m;
SELECT 'each of them is drawn: ' || m, streetgen.svg(m) LIKE '%section%' FROM unnest('{whole,bare,laned}'::name[]) m;
SELECT 'each of them is exported: ' || m, (SELECT count(*) FROM streetgen.export_layer(m)) = CASE m WHEN 'whole' THEN 9 WHEN 'laned' THEN 8 ELSE 5 END
  FROM unnest('{whole,bare,laned}'::name[]) m;

UPDATE bare.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
INSERT INTO bare.lane_override (axis_id, abscissa, ordinality, width) VALUES (3, 50, 1, 3.2);
SELECT 'an axis turned round keeps its overrides where no lanes are', (SELECT count(*) = 1 FROM bare.lane_override) AND (SELECT count(*) FROM bare.section) = 3;
SELECT 'a subject that is switched on is filled', (SELECT sum(inserted) FILTER (WHERE relation = 'lane') = 6 AND sum(inserted) FILTER (WHERE relation = 'section') = 0
  FROM streetgen.switch_subject('bare', 'interconnection', true));
SELECT 'with what was decided by hand', (SELECT count(*) = 1 FROM bare.lane WHERE method = 'by_hand' AND width = 3.2);
SELECT 'it follows edits from then on', (SELECT count(*) > 0 FROM bare.interconnection) AND pg_temp.relations('bare') = pg_temp.relations('whole');
SELECT 'switched on again nothing happens', count(*) = 0 FROM streetgen.switch_subject('bare', 'lane', true);
SELECT 'a subject that another one needs stays', (test.refusal('SELECT FROM streetgen.switch_subject(''bare'', ''lane'', false)')).state = '2BP01';
SELECT 'a subject of every model stays', (test.refusal('SELECT FROM streetgen.switch_subject(''bare'', ''surface'', false)')).state = '0A000';
SELECT 'a word that is no subject is refused', (test.refusal('SELECT FROM streetgen.switch_subject(''bare'', ''tram'', true)')).state = '22023'
  AND (test.refusal('SELECT streetgen.create_model(''trams'', 2154, subjects => ''{tram}'')')).state = '22023';
CREATE VIEW public.others AS SELECT lane_in FROM bare.interconnection;
SELECT 'what something of others builds on stays', (test.refusal('SELECT FROM streetgen.switch_subject(''bare'', ''interconnection'', false)')).state = '2BP01';
DROP VIEW public.others;
SELECT FROM streetgen.switch_subject('bare', 'interconnection', false) \g /dev/null
SELECT FROM streetgen.switch_subject('bare', 'lane', false) \g /dev/null
SELECT 'switched off, tables and views go', pg_temp.relations('bare') = 'section';
SELECT 'decisions by hand stay', (SELECT count(*) = 1 FROM bare.lane_override);
UPDATE bare.axis SET width = 8 WHERE axis_id = 2;
SELECT 'and streets follow edits', (SELECT width = 8 FROM bare.edge WHERE axis_id = 2);
TRUNCATE bare.axis;
SELECT 'also where all axes go', NOT EXISTS (SELECT FROM bare.edge);
CREATE ROLE subject_reader ROLE CURRENT_USER;
SELECT streetgen.grant('bare', 'subject_reader', 'reader') \g /dev/null
SELECT pg_temp.draw('bare') \g /dev/null
SELECT FROM streetgen.switch_subject('bare', 'lane', true) \g /dev/null
SELECT 'who reads the axes reads the tables that came', has_table_privilege('subject_reader', 'bare.lane', 'SELECT') AND has_table_privilege('subject_reader', 'bare.lane_editing', 'SELECT');
DROP OWNED BY subject_reader;
DROP ROLE subject_reader;

-- A toy: a milestone in the middle of each edge. One row of the list of subjects, functions for its table and its part.
ALTER FUNCTION streetgen._subject() RENAME TO _subject_shipped;
CREATE FUNCTION streetgen._subject() RETURNS TABLE(place integer, subject text, needs text[], reach text, always boolean, by_default boolean, cost text, description text) LANGUAGE sql IMMUTABLE AS $$
  SELECT * FROM streetgen._subject_shipped() UNION ALL VALUES (9, 'milestone', '{network}'::text[], 'near', false, false, 'nothing', 'a stone in the middle of each edge') $$;
CREATE FUNCTION streetgen._milestone_computed_table() RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name, gone_each integer) LANGUAGE sql IMMUTABLE AS $$
  VALUES (20, 'milestone', 'milestone', 'milestone_id', 'edge_id', 'milestone', 1) $$;
SELECT streetgen._compose_computed_table() \g /dev/null
SELECT streetgen._take_template('milestone', 'table', $$CREATE TABLE :"model".milestone (milestone_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY,
    edge_id bigint NOT NULL REFERENCES :"model".edge ON DELETE CASCADE, geom geometry(Point, :srid) NOT NULL, UNIQUE (edge_id));
COMMENT ON COLUMN :"model".milestone.geom IS 'the middle of the edge';$$) \g /dev/null
CREATE FUNCTION streetgen._upsert_milestone(places jsonb) RETURNS text LANGUAGE sql AS $$
  SELECT streetgen._upsert_rows(places, 'milestone', columns => 'edge_id, geom', rows => $part$
    SELECT number, edge_id, ST_LineInterpolatePoint(ST_Force2D(geom), 0.5) AS geom FROM (
      SELECT c.number, (SELECT ids FROM edge_ids)[c.number] AS edge_id, c.geom FROM written_edge c) e WHERE edge_id > 0$part$,
    there => $part$SELECT m.milestone_id FROM new_edge e, LATERAL (SELECT * FROM {model}.milestone m WHERE m.edge_id = e.edge_id {by_key}) m WHERE e.affected AND NOT e.fresh$part$) $$;
SELECT 'a subject of a user''s own is listed', wanted = false AND tables = '{milestone}' FROM streetgen.subject('laned') WHERE subject = 'milestone';
SELECT 'switched on it is filled', (SELECT inserted = 3 FROM streetgen.switch_subject('laned', 'milestone', true) WHERE relation = 'milestone');
SELECT 'with a row for each edge', count(*) = 3 FROM laned.milestone;
UPDATE laned.axis SET geom = 'SRID=2154;LINESTRING(650100 6860000,650100 6860120)' WHERE axis_id = 3;
SELECT 'it follows edits', (SELECT ST_Distance(m.geom, 'SRID=2154;POINT(650100 6860060)') < 0.01 FROM laned.milestone m JOIN laned.edge USING (edge_id) WHERE axis_id = 3);
SELECT 'a second run leaves it as it is', inserted + updated + deleted = 0 AND unchanged = 3 FROM streetgen.generate('laned') WHERE relation = 'milestone';
DELETE FROM laned.axis WHERE axis_id = 3;
SELECT 'and goes with its edge', (SELECT count(*) = (SELECT count(*) FROM laned.edge) FROM laned.milestone);
SELECT streetgen.live('laned', false) \g /dev/null
TRUNCATE laned.axis;
SELECT streetgen.live('laned', true) \g /dev/null
SELECT FROM streetgen.generate('laned') \g /dev/null
SELECT 'a model of no axes has none', NOT EXISTS (SELECT FROM laned.milestone);
SELECT FROM streetgen.switch_subject('laned', 'milestone', false) \g /dev/null
SELECT 'switched off nothing is left of it', to_regclass('laned.milestone') IS NULL AND NOT EXISTS (SELECT FROM streetgen.generate('laned') WHERE relation = 'milestone');
-- What edits plan by.
DO $$ BEGIN
  PERFORM streetgen.create_model('planned', 2154);
  INSERT INTO planned.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650060 6860000)', 6), ('SRID=2154;LINESTRING(650060 6860000,650060 6860060)', 6);
  PERFORM streetgen.switch_subject('planned', 'sidewalk', true);
END $$;
SELECT 'tables of a subject that is switched on have statistics, those that it needs too', count(DISTINCT tablename) = 2 FROM pg_stats WHERE schemaname = 'planned' AND tablename IN ('kerb', 'sidewalk');
-- What the server says while subjects go and come.
-- Each subject is switched off when no other one needs it any more.
DO $$ DECLARE one text; left_on integer := -1; before integer; BEGIN
  PERFORM streetgen.create_model('peeled', 2154, subjects => '{all}'), streetgen.create_model('never', 2154, subjects => '{}');
  WHILE left_on IS DISTINCT FROM before LOOP
    before := left_on;
    FOR one IN SELECT unnest(streetgen._subjects('peeled')) INTERSECT SELECT subject FROM streetgen._subject() WHERE NOT always LOOP
      BEGIN PERFORM streetgen.switch_subject('peeled', one, false); EXCEPTION WHEN dependent_objects_still_exist THEN NULL; END;
    END LOOP;
    left_on := cardinality(streetgen._subjects('peeled'));
  END LOOP;
END $$;
SELECT 'all subjects can be switched off again', streetgen._subjects('peeled') = streetgen._subjects('never');
SELECT 'and leave no function behind' || coalesce(': ' || string_agg(name, ' '), ''), count(*) = 0
  FROM (SELECT replace(oid::regprocedure::text, 'peeled.', '') AS name FROM pg_proc WHERE pronamespace = 'peeled'::regnamespace
    EXCEPT SELECT replace(oid::regprocedure::text, 'never.', '') FROM pg_proc WHERE pronamespace = 'never'::regnamespace) f;

\setenv PGDATABASE :DBNAME
\setenv PGOPTIONS '-c client_min_messages=notice'
SELECT streetgen.create_model('quiet', 2154, subjects => '{all}') \g /dev/null
SELECT pg_temp.draw('quiet') \g /dev/null
\! test -z "$(psql -qXAt -c "DO \$\$ DECLARE gone text; BEGIN FOR gone IN SELECT subject FROM streetgen._subject() s WHERE NOT always AND NOT EXISTS (SELECT FROM streetgen._subject() n WHERE s.subject = ANY (n.needs)) LOOP PERFORM streetgen.switch_subject('quiet', gone, false); PERFORM streetgen.switch_subject('quiet', gone, true); END LOOP; END \$\$" 2>&1)" && holds=t || holds=f; printf 'a subject goes and comes without a notice\t%s\n' $holds
