\set ECHO none
\ir shared/truths.sql
-- Each row that an edit writes is of an axis or a chain whose key the session holds; what an edit asks for; keys that are NULL.
SELECT streetgen.create_model('town', 2154, subjects => (SELECT array_agg(subject) FROM streetgen._subject() WHERE NOT always)) \g /dev/null

-- Six blocks by six; a road over them without nodes, and a ring.
WITH place AS (SELECT x, y, ST_SetSRID(ST_Point(650000 + 80 * x + (x * 7 + y * 5) % 17, 6860000 + 80 * y + (x * 3 + y * 11) % 13), 2154) AS geom FROM generate_series(0, 6) x, generate_series(0, 6) y)
INSERT INTO town.axis (geom, width, importance, sidewalk_left) SELECT ST_MakeLine(a.geom, b.geom), 4 + (a.x * 5 + a.y * 3) % 9, 2 + (a.x + a.y) % 4, 2
FROM place a JOIN place b ON (b.x, b.y) IN ((a.x + 1, a.y), (a.x, a.y + 1)) ORDER BY a.x, a.y, b.x, b.y;
INSERT INTO town.axis (geom, width, level, kind) VALUES ('SRID=2154;LINESTRING(649900 6860130,650600 6860150)', 9, 1, 'primary');
INSERT INTO town.placement_rule (type, along, side, every, axis_offset, distance_from_limit) VALUES ('lamp', 'border', 'alternating', 20, 0.8, 2);

CREATE SCHEMA held;
CREATE TABLE held.bare (relation name, event text, ids jsonb, edit integer);
CREATE FUNCTION held.holds(key integer) RETURNS boolean LANGUAGE sql VOLATILE AS $$
  SELECT EXISTS (SELECT FROM pg_locks WHERE locktype = 'advisory' AND objsubid = 2 AND granted AND pid = pg_backend_pid() AND mode = 'ExclusiveLock'
    AND classid = (hashtext('streetgen.town')::bigint & 4294967295)::oid AND objid = (key::bigint & 4294967295)::oid) $$;
-- An axis is held by its key, or by all districts where its rows lie.
CREATE FUNCTION held.of_axis(axis bigint, line geometry) RETURNS boolean LANGUAGE sql VOLATILE AS $$
  SELECT held.holds(streetgen._axis_key(axis)) OR held.holds(-1) OR (SELECT bool_and(held.holds(key)) FROM streetgen._districts_of(line, 200) key) $$;
-- Are the axes of all edges held that a condition names?
CREATE FUNCTION held.of_edges(condition text, ids jsonb) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  all_held boolean;
BEGIN
  EXECUTE 'SELECT coalesce(bool_and(held.of_axis(e.axis_id, e.geom)), true) FROM town.edge e WHERE ' || condition INTO all_held USING ids;
  RETURN all_held;
END $$;
-- Is one of the axes held, wherever it lies and lay?
CREATE FUNCTION held.of_axes(axes bigint[]) RETURNS boolean LANGUAGE sql VOLATILE AS $$
  SELECT EXISTS (SELECT FROM unnest(axes) a WHERE held.holds(streetgen._axis_key(a))
    OR (SELECT bool_and(held.of_axis(axis_id, geom)) FROM (SELECT axis_id, geom FROM town.axis UNION ALL SELECT axis_id, geom FROM town.edge) l WHERE axis_id = a)) $$;
CREATE FUNCTION held.of_chain(relation name, chain bigint) RETURNS boolean LANGUAGE sql VOLATILE AS $$
  SELECT held.holds(streetgen._chain_key(relation, chain)) OR held.holds(streetgen._all_chains()) $$;
CREATE FUNCTION held.is_covered(relation name, ids jsonb) RETURNS boolean LANGUAGE sql VOLATILE AS $$
  SELECT CASE
    WHEN relation = 'block' THEN held.of_chain('block', (ids ->> 'block_id')::bigint)
    WHEN relation = 'road' THEN held.of_chain('road', (ids ->> 'road_id')::bigint)
      OR held.of_edges('edge_id IN (SELECT edge_id FROM town.road_edge WHERE road_id = ($1 ->> ''road_id'')::bigint)', ids)
    WHEN relation = 'junction' THEN held.of_chain('junction', (ids ->> 'junction_id')::bigint)
      OR held.of_edges('($1 ->> ''junction_id'')::bigint IN (from_node, to_node)', ids)
    WHEN relation IN ('profile', 'overpass') AND held.of_chain('profile', 0) THEN true
    WHEN ids ? 'axis_id' THEN held.of_axes(ARRAY[(ids ->> 'axis_id')::bigint])
    WHEN ids ? 'axis_a' THEN held.of_axes(ARRAY[(ids ->> 'axis_a')::bigint, (ids ->> 'axis_b')::bigint])
    WHEN ids ? 'edge_id' THEN held.of_edges('edge_id = ($1 ->> ''edge_id'')::bigint', ids)
    WHEN ids ? 'edge_a' THEN held.of_edges('edge_id IN (($1 ->> ''edge_a'')::bigint, ($1 ->> ''edge_b'')::bigint)', ids)
    WHEN ids ? 'lane_in' THEN held.of_edges('edge_id IN (SELECT edge_id FROM town.lane WHERE lane_id IN (($1 ->> ''lane_in'')::bigint, ($1 ->> ''lane_out'')::bigint))', ids)
    WHEN ids ? 'node_id' THEN held.of_edges('($1 ->> ''node_id'')::bigint IN (from_node, to_node)', ids)
    ELSE true END $$;
-- The first argument: the ids of a row.
CREATE FUNCTION held.note() RETURNS trigger LANGUAGE plpgsql AS $$
DECLARE
  ids jsonb;
BEGIN
  IF TG_OP = 'INSERT' THEN
    EXECUTE TG_ARGV[0] INTO ids USING NEW;
  ELSE
    EXECUTE TG_ARGV[0] INTO ids USING OLD;
  END IF;
  -- A new block has no key yet; its edges have.
  IF NOT (TG_OP = 'INSERT' AND TG_TABLE_NAME = 'block' OR held.is_covered(TG_TABLE_NAME, ids)) THEN
    INSERT INTO held.bare VALUES (TG_TABLE_NAME, TG_OP, ids, current_setting('held.edit')::integer);
  END IF;
  RETURN NULL;
END $$;
SELECT format('CREATE TRIGGER held_note AFTER INSERT OR UPDATE OR DELETE ON town.%I FOR EACH ROW EXECUTE FUNCTION held.note(%L)', r,
  (SELECT format('SELECT jsonb_build_object(%s)', string_agg(format('%L, ($1).%I', attname, attname), ', ')) FROM pg_attribute WHERE attrelid = format('town.%I', r)::regclass AND attnum > 0 AND atttypid = 'int8'::regtype))
FROM unnest(streetgen._computed_tables('town')) r WHERE r NOT IN ('block_edge', 'controller', 'signal_state', 'signal_movement', 'signal_group', 'intergreen', 'signal_head') \gexec

-- A random edit; kind 3 takes an axis away.
CREATE FUNCTION held.edit(kind integer) RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  chosen town.axis;
BEGIN
  SELECT * INTO chosen FROM town.axis ORDER BY random() LIMIT 1;
  CASE kind
    WHEN 0, 1 THEN UPDATE town.axis SET width = 3 + 12 * random() WHERE axis_id = chosen.axis_id;
    WHEN 2 THEN UPDATE town.axis SET geom = ST_SetPoint(geom, 1, ST_Translate(ST_EndPoint(geom), 60 * random() - 30, 60 * random() - 30)) WHERE axis_id = chosen.axis_id;
    WHEN 3 THEN DELETE FROM town.axis WHERE axis_id = chosen.axis_id;
    ELSE INSERT INTO town.axis (geom, width) VALUES (ST_MakeLine(ST_EndPoint(chosen.geom), ST_Translate(ST_EndPoint(chosen.geom), 140 * random() - 70, 140 * random() - 70)), 6);
  END CASE;
END $$;
CREATE PROCEDURE held.edits(many integer) LANGUAGE plpgsql AS $$
BEGIN
  PERFORM setseed(0.42);
  FOR i IN 1 .. many LOOP
    PERFORM set_config('held.edit', i::text, false), held.edit(i % 5);
    COMMIT;
  END LOOP;
END $$;
CALL held.edits(25);
SELECT 'each row that an edit writes is of an axis or a chain that it holds', count(*) = 0 FROM held.bare;
-- As if this transaction had locked so many places.
CREATE FUNCTION held.count(alone boolean) RETURNS bigint LANGUAGE sql VOLATILE AS $$
  SELECT count(*) FROM pg_locks WHERE locktype = 'advisory' AND objsubid = 2 AND granted AND pid = pg_backend_pid() AND (NOT alone OR mode = 'ExclusiveLock') $$;
BEGIN;
SET LOCAL streetgen.places = 500;
SELECT held.edit((ARRAY[0, 2, 4])[1 + i % 3]) FROM generate_series(1, 9) i \g /dev/null
SELECT 'of many places also in the districts that it holds, no axis by itself', count(*) = 0 AND NOT EXISTS (SELECT FROM town.axis WHERE held.holds(streetgen._axis_key(axis_id)))
  AND EXISTS (SELECT FROM town.axis WHERE held.of_axis(axis_id, geom)) AND NOT held.holds(-1) FROM held.bare;
ROLLBACK;
BEGIN;
SET LOCAL streetgen.places = 768;
SELECT held.edit((ARRAY[0, 2, 4])[1 + i % 3]) FROM generate_series(1, 6) i \g /dev/null
SELECT 'of more still all places and all chains are held', count(*) = 0 AND held.holds(-1) AND held.holds(streetgen._all_chains()) AND held.count(true) = 2 FROM held.bare;
ROLLBACK;
SELECT set_config('held.edit', '0', false) \g /dev/null
BEGIN;
SET LOCAL streetgen.computes = 'on';
UPDATE town.lane SET width = width + 0.1;
UPDATE town.road SET length = length + 1;
UPDATE town.block SET kind = 'strip';
SELECT 'without a lock it is told', count(DISTINCT relation) = 3 FROM held.bare;
ROLLBACK;

-- The keys that an edit asks for.
SELECT 'a width leaves the outside alone', NOT streetgen._chain_key('block', 0) = ANY ((streetgen._reach_of('town', ARRAY[axis_id])).chains) FROM (SELECT min(axis_id) AS axis_id FROM town.axis) a;
BEGIN;
SET LOCAL streetgen.live = off;
UPDATE town.axis SET geom = ST_SetPoint(geom, 0, ST_Translate(ST_StartPoint(geom), -1, -1)) WHERE axis_id = (SELECT min(axis_id) FROM town.axis);
SELECT 'a border street that moves does not', streetgen._chain_key('block', 0) = ANY ((streetgen._reach_of('town', ARRAY[axis_id])).chains) FROM (SELECT min(axis_id) AS axis_id FROM town.axis) a;
ROLLBACK;
SELECT 'cells reach as far as the margin, and no farther than a diagonal of both', bool_and(keys && within) AND NOT bool_or(keys && beyond)
FROM generate_series(0, 350, 10) angle, LATERAL (SELECT array_agg(key) AS keys FROM streetgen._cells('SRID=2154;LINESTRING(650000 6860000,650000.1 6860000)', 150, 200) key) k,
  LATERAL (SELECT array_agg(key) AS within FROM streetgen._cells(ST_Translate('SRID=2154;POINT(650000 6860000)', 149 * cosd(angle), 149 * sind(angle)), 0, 200) key) w,
  LATERAL (SELECT array_agg(key) AS beyond FROM streetgen._cells(ST_Translate('SRID=2154;POINT(650000 6860000)', 293 * cosd(angle), 293 * sind(angle)), 0, 200) key) b;
SELECT 'of a long line cells follow the line', count(DISTINCT key) BETWEEN 300 AND 450 FROM streetgen._cells('SRID=2154;LINESTRING(650000 6860000,657000 6867000)', 76, 200) key;
SELECT 'many cells and axes are locked by their districts, many districts and chains by one key each', (p).alone = ARRAY[-7, 5] AND (p).shared <@ ARRAY[-1, streetgen._all_chains()] AND (q).alone = ARRAY[-1, streetgen._all_chains()]
FROM (SELECT streetgen._places_of('town', ARRAY(SELECT generate_series(1073741824, 1073742335)), ARRAY[-7], ARRAY[5, streetgen._axis_key(1)]) AS p,
  streetgen._places_of('town', ARRAY(SELECT generate_series(1073741824, 1073742336)), ARRAY(SELECT generate_series(-800, -7)), ARRAY(SELECT generate_series(5000, 5800))) AS q) k;
SELECT 'few are locked one by one', (p).alone = ARRAY[1073741824, streetgen._axis_key(1), 5] AND (SELECT array_agg(key ORDER BY key) FROM unnest((p).shared) key) = ARRAY[-7, -1, streetgen._all_chains()]
FROM (SELECT streetgen._places_of('town', ARRAY[1073741824], ARRAY[-7], ARRAY[5, streetgen._axis_key(1)]) AS p) q;

-- Many keys are compared as sets: each with each would take minutes, and hear no cancel.
SET statement_timeout = '60s';
SELECT 'many keys are among as many', streetgen._holds_all(k, k || k) AND NOT streetgen._holds_all(k, k || 0) AND streetgen._holds_all('{1,2}', '{2}'::integer[]) AND NOT streetgen._holds_all('{1,2}', '{3}'::integer[]) FROM (SELECT array_agg(i) AS k FROM generate_series(1, 500000) i) a;
RESET statement_timeout;

-- A lock of nothing is no lock.
SELECT 'places that are NULL are refused', test.state($$SELECT streetgen._lock_places('town', NULL::bigint[], true)$$) = '22004' AND test.state($$SELECT streetgen._lock_places('town', NULL, '{}'::integer[], true)$$) = '22004'
  AND test.state($$SELECT streetgen._lock_places('town', '{1}'::bigint[], NULL)$$) = '22004' AND test.hint($$SELECT streetgen._lock_places('town', NULL::bigint[], true)$$) <> ''
  AND test.state($$SELECT streetgen._wait_for_places('town', '{}', '{}', NULL)$$) = '22004';

-- One transaction edits all over a city.
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('city', 2154) \g /dev/null
RESET streetgen_test.subjects;
SET streetgen.live = off;
INSERT INTO city.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_Point(650000 + 300 * x, 6860000 + 300 * y), ST_Point(650080 + 300 * x, 6860000 + 300 * y)), 2154), 6 FROM generate_series(0, 24) x, generate_series(0, 24) y;
RESET streetgen.live;
SELECT streetgen.generate('city') \g /dev/null
CREATE TEMPORARY TABLE most (locks bigint, places integer);
DO $$
BEGIN
  FOR i IN 1 .. 300 LOOP
    UPDATE city.axis SET width = 5 + i % 4 WHERE axis_id = 1 + (i * 577) % 625;
    IF i % 20 = 0 THEN
      INSERT INTO most SELECT held.count(false), streetgen._places_held();
    END IF;
  END LOOP;
  INSERT INTO most SELECT held.count(false), NULL;
END $$;
SELECT 'a transaction of 300 edits all over a city holds 770 places at most', max(locks) BETWEEN 512 AND 770 AND max(places) BETWEEN 512 AND 770 FROM most;
SELECT 'its edits are done', count(*) = 625 AND bool_and(e.width = a.width) AND held.count(false) = 0 AND streetgen._places_held() = 0 FROM city.edge e JOIN city.axis a USING (axis_id);
