-- Junctions after a run. A junction may be longer than the reach: statements of its own read the rows that the one
-- statement wrote.

CREATE OR REPLACE FUNCTION streetgen._junction_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    (40, 'junction', 'junction', 'junction_id', NULL, 'junction', 1),
    (41, 'junction_node', 'junction', 'node_id', NULL, 'junction_node', 1),
    (42, 'junction_edge', 'junction', 'edge_id', NULL, 'junction_edge', 1),
    (43, 'junction_movement', 'junction', 'junction_movement_id', 'lane_in, lane_out, along_in, along_out',
        'junction_movement', 1) $$;
COMMENT ON FUNCTION streetgen._junction_computed_table() IS 'The computed tables of junctions.';

CREATE OR REPLACE FUNCTION streetgen._make_put_junctions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _put_junctions(region bigint[], members streetgen.junction_member[],
        made streetgen.junction_made[], largest_hole float8, OUT inserted bigint[], OUT updated bigint[], OUT kept
            bigint[])
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    BEGIN
        WITH united AS MATERIALIZED (
            SELECT junction_id, array_agg(surface) AS parts FROM (
                SELECT n.junction_id, i.surface FROM unnest(members) n JOIN intersection i USING (node_id)
                UNION ALL SELECT n.junction_id, s.surface FROM unnest(members) n JOIN section s USING (edge_id)) p
            WHERE junction_id IN (SELECT m.junction_id FROM unnest(made) m WHERE m.nodes > 1) GROUP BY junction_id),
        new AS MATERIALIZED (
            SELECT m.junction_id, m.kind, m.method, m.geom, CASE WHEN m.nodes > 1
                THEN streetgen._united_ground(u.parts, largest_hole, ST_SRID(m.geom))
                ELSE coalesce(i.surface, ST_GeomFromText('MULTIPOLYGON EMPTY', ST_SRID(m.geom))) END AS surface
            FROM unnest(made) m LEFT JOIN united u USING (junction_id)
                LEFT JOIN intersection i ON m.nodes = 1 AND i.node_id = m.junction_id),
        compared AS MATERIALIZED (
            SELECT n.*, o.junction_id IS NULL AS fresh,
                (o.kind, o.method, o.geom::bytea, o.surface::bytea) IS DISTINCT FROM
                    (n.kind, n.method, n.geom::bytea, n.surface::bytea) AS changed
            FROM new n LEFT JOIN junction o USING (junction_id)),
        put AS (
            INSERT INTO junction (junction_id, kind, method, geom, surface)
            SELECT junction_id, kind, method, geom, surface FROM compared WHERE changed ORDER BY junction_id
            ON CONFLICT (junction_id) DO UPDATE SET (kind, method, geom, surface)
                = ROW (excluded.kind, excluded.method, excluded.geom, excluded.surface))
        SELECT ARRAY(SELECT junction_id FROM compared WHERE fresh),
            ARRAY(SELECT junction_id FROM compared WHERE changed AND NOT fresh),
            ARRAY(SELECT junction_id FROM compared WHERE NOT changed) INTO inserted, updated, kept;
    END $body$;
    PERFORM streetgen._own_function(model,
        '_put_junctions(bigint[], streetgen.junction_member[], streetgen.junction_made[], double precision)',
        'Writes the rows of junctions that are new or differ, and tells which');
END $$;
COMMENT ON FUNCTION streetgen._make_put_junctions(name) IS
    'Makes the function of a model that writes the rows of junctions.';

CREATE OR REPLACE FUNCTION streetgen._united_ground(parts geometry[], largest_hole float8, srid integer)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT coalesce(ST_Normalize(ST_Multi(ST_Collect(part))), ST_GeomFromText('MULTIPOLYGON EMPTY', srid)) FROM (
        SELECT ST_MakePolygon(ST_ExteriorRing(d.geom), ARRAY(
            SELECT ST_ExteriorRing(r.geom) FROM ST_DumpRings(d.geom) r
            WHERE r.path[1] > 0 AND ST_Area(r.geom) >= largest_hole)) AS part
        FROM ST_Dump(ST_CollectionExtract(ST_UnaryUnion(ST_Collect(parts)), 3)) d) p $$;
COMMENT ON FUNCTION streetgen._united_ground(geometry[], float8, integer) IS
    'The union of surfaces that share borders, a MULTIPOLYGON in normal form, its holes under a size (m2) filled; '
    'empty of none.';

CREATE OR REPLACE FUNCTION streetgen._make_put_movements(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _put_movements(junctions bigint[], former bigint[], OUT inserted bigint,
        OUT updated bigint, OUT deleted bigint, OUT unchanged bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    BEGIN
        WITH found AS MATERIALIZED (SELECT * FROM _found_movements(junctions)),
        new AS MATERIALIZED (
            SELECT f.junction_id, f.lane_in, f.lane_out, f.along_in, f.along_out, f.turn, f.angle, f.plausible,
                f.reason, f.traffic,
                -- All paths on the way must connect where somebody decided of one.
                CASE WHEN d.by_hand THEN d.connecting ELSE f.plausible END AS connecting, f.interconnections,
                f.geom::geometry AS geom
            FROM found f LEFT JOIN LATERAL (
                SELECT bool_or(i.method = 'by_hand') AS by_hand, bool_and(i.connecting) AS connecting
                FROM interconnection i WHERE i.interconnection_id = ANY (f.interconnections)) d ON true),
        compared AS MATERIALIZED (
            SELECT n.*, o.junction_movement_id,
                (o.junction_id, o.turn, o.angle, o.plausible, o.reason, o.traffic, o.connecting, o.interconnections,
                    o.geom::bytea) IS DISTINCT FROM (n.junction_id, n.turn, n.angle, n.plausible, n.reason, n.traffic,
                    n.connecting, n.interconnections, n.geom::bytea) AS changed
            -- OFFSET 0: each is looked up by its key, and not joined.
            FROM new n LEFT JOIN LATERAL (SELECT * FROM junction_movement o
                WHERE (o.lane_in, o.lane_out, o.along_in, o.along_out) = (n.lane_in, n.lane_out, n.along_in,
                    n.along_out)
                OFFSET 0) o ON true),
        gone AS (
            DELETE FROM junction_movement m WHERE m.junction_id = ANY (former || junctions)
                AND m.junction_movement_id <> ALL (ARRAY(SELECT c.junction_movement_id FROM compared c
                    WHERE c.junction_movement_id IS NOT NULL)) RETURNING 1),
        put AS (
            INSERT INTO junction_movement (junction_id, lane_in, lane_out, along_in, along_out, turn, angle,
                plausible, reason, traffic, connecting, interconnections, geom)
            SELECT junction_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, traffic,
                connecting, interconnections, geom FROM compared WHERE changed ORDER BY junction_id, lane_in, lane_out
            ON CONFLICT (lane_in, lane_out, along_in, along_out) DO UPDATE SET (junction_id, turn, angle, plausible,
                reason, traffic, connecting, interconnections, geom) = ROW (excluded.junction_id, excluded.turn,
                excluded.angle, excluded.plausible, excluded.reason, excluded.traffic, excluded.connecting,
                excluded.interconnections, excluded.geom))
        SELECT count(*) FILTER (WHERE junction_movement_id IS NULL),
            count(*) FILTER (WHERE changed AND junction_movement_id IS NOT NULL), (SELECT count(*) FROM gone),
            count(*) FILTER (WHERE NOT changed) INTO inserted, updated, deleted, unchanged FROM compared;
    END $body$;
    PERFORM streetgen._own_function(model, '_put_movements(bigint[], bigint[])',
        'Writes the paths across junctions that are new or differ, and takes away those that are gone');
END $$;
COMMENT ON FUNCTION streetgen._make_put_movements(name) IS
    'Makes the function of a model that writes the paths across junctions.';

CREATE OR REPLACE FUNCTION streetgen._make_junction_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'junction' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._drop_own_functions(model, '{_update_junctions,_put_movements,_found_movements,'
            '_junction_members,_made_junctions,_put_junctions}');
        RETURN;
    END IF;
    PERFORM streetgen._make_junction_members(model), streetgen._make_made_junctions(model),
        streetgen._make_put_junctions(model), streetgen._make_found_movements(model),
        streetgen._make_put_movements(model);
    CREATE OR REPLACE FUNCTION _update_junctions(touched bigint[])
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint,
            fallbacks bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        SET plan_cache_mode = auto
        AS $body$
    #variable_conflict use_column
    DECLARE
        region bigint[];
        members streetgen.junction_member[];
        put record;
        made streetgen.junction_made[];
        former bigint[];
        obsolete bigint[];
        nodes record;
        edges record;
        movements record;
    BEGIN
        IF touched IS NOT NULL THEN
            -- Planning anew costs an edit more than the plans do.
            PERFORM set_config('plan_cache_mode', 'force_generic_plan', true);
        END IF;
        SELECT m.region, m.members INTO region, members FROM _junction_members(touched) m;
        made := _made_junctions(region, members);
        former := CASE WHEN touched IS NULL THEN ARRAY(SELECT DISTINCT junction_id FROM junction_node)
            ELSE ARRAY(SELECT DISTINCT junction_id FROM junction_node WHERE node_id = ANY (region)) END;
        SELECT * INTO put FROM _put_junctions(region, members, made,
            (SELECT value::float8 FROM setting WHERE name = 'max_hole_area'));
        WITH new AS MATERIALIZED (
            -- Not joins: of many the planner would guess billions of rows.
            SELECT n.node_id, n.junction_id FROM unnest(members) n WHERE n.node_id IN (SELECT unnest(region))
                AND n.junction_id IN (SELECT m.junction_id FROM unnest(made) m)),
        compared AS MATERIALIZED (
            SELECT n.*, o.node_id IS NULL AS fresh, o.junction_id IS DISTINCT FROM n.junction_id AS changed
            FROM new n LEFT JOIN junction_node o USING (node_id)),
        gone AS (
            DELETE FROM junction_node o WHERE o.node_id = ANY (ARRAY(SELECT r.node_id
                FROM unnest(region) r(node_id) WHERE NOT EXISTS (SELECT FROM new n WHERE n.node_id = r.node_id)))
            RETURNING 1),
        put_node AS (
            INSERT INTO junction_node SELECT node_id, junction_id FROM compared WHERE changed ORDER BY node_id
            ON CONFLICT (node_id) DO UPDATE SET junction_id = excluded.junction_id)
        SELECT count(*) FILTER (WHERE fresh) AS inserted, count(*) FILTER (WHERE changed AND NOT fresh) AS updated,
            (SELECT count(*) FROM gone) AS deleted, count(*) FILTER (WHERE NOT changed) AS unchanged
            INTO nodes FROM compared;
        WITH new AS MATERIALIZED (
            SELECT e.edge_id, e.junction_id, e.role FROM unnest(members) e
            WHERE e.role IS NOT NULL AND e.junction_id IN (SELECT m.junction_id FROM unnest(made) m)),
        compared AS MATERIALIZED (
            SELECT n.*, o.edge_id IS NULL AS fresh,
                (o.junction_id, o.role) IS DISTINCT FROM (n.junction_id, n.role) AS changed
            FROM new n LEFT JOIN junction_edge o USING (edge_id)),
        gone AS (
            DELETE FROM junction_edge o WHERE o.junction_id = ANY (former || put.inserted || put.updated || put.kept)
                AND NOT EXISTS (SELECT FROM new n WHERE n.edge_id = o.edge_id) RETURNING 1),
        put_edge AS (
            INSERT INTO junction_edge SELECT edge_id, junction_id, role FROM compared WHERE changed ORDER BY edge_id
            ON CONFLICT (edge_id) DO UPDATE SET (junction_id, role) = ROW (excluded.junction_id, excluded.role))
        SELECT count(*) FILTER (WHERE fresh) AS inserted, count(*) FILTER (WHERE changed AND NOT fresh) AS updated,
            (SELECT count(*) FROM gone) AS deleted, count(*) FILTER (WHERE NOT changed) AS unchanged
            INTO edges FROM compared;
        IF touched IS NULL THEN
            PERFORM streetgen._analyse('junction_node'), streetgen._analyse('junction_edge');
        END IF;
        SELECT * INTO movements FROM _put_movements(
            ARRAY(SELECT m.junction_id FROM unnest(made) m WHERE m.nodes > 1), former);
        WITH gone AS (DELETE FROM junction j WHERE j.junction_id = ANY (former)
            AND NOT EXISTS (SELECT FROM unnest(made) m WHERE m.junction_id = j.junction_id) RETURNING j.junction_id)
        SELECT ARRAY(SELECT junction_id FROM gone) INTO obsolete;
        RETURN QUERY VALUES
            ('junction', cardinality(put.inserted)::bigint, cardinality(put.updated)::bigint,
                cardinality(obsolete)::bigint, cardinality(put.kept)::bigint,
                (SELECT count(*) FROM unnest(made) m WHERE m.method <> 'hypothesis')),
            ('junction_node', nodes.inserted, nodes.updated, nodes.deleted, nodes.unchanged, 0::bigint),
            ('junction_edge', edges.inserted, edges.updated, edges.deleted, edges.unchanged, 0::bigint),
            ('junction_movement', movements.inserted, movements.updated, movements.deleted, movements.unchanged,
                0::bigint);
        IF 'signal' = ANY (streetgen._subjects(current_schema())) THEN
            RETURN QUERY SELECT * FROM _update_signals(ARRAY(SELECT m.junction_id FROM unnest(made) m), former);
        END IF;
    END $body$;
    PERFORM streetgen._own_function(model, '_update_junctions(bigint[])',
        'Brings the junctions about nodes (NULL: all) up to date with the rows of the model; a row per table');
END $$;
COMMENT ON FUNCTION streetgen._make_junction_functions(name) IS
    'Makes the functions of a model that bring its junctions up to date, or drops them where it computes none.';

CREATE OR REPLACE FUNCTION streetgen._junction_arguments(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$junctions => (
            SELECT array_agg(ROW (axis_id, ST_X(geom), ST_Y(geom), kind)::streetgen.street_junction
                ORDER BY junction_override_id)
            FROM {model}.junction_override WHERE kind IS NOT NULL AND ({whole} OR axis_id = ANY ($2)))$part$,
        places) $$;
COMMENT ON FUNCTION streetgen._junction_arguments(jsonb) IS
    'Part of the one statement: what the core gets of junctions.';

CREATE OR REPLACE FUNCTION streetgen._update_junction(model name, axes bigint[], moved streetgen.moved_row[],
    noted bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
DECLARE
    touched bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NOT NULL THEN
        SELECT ARRAY(SELECT from_node FROM edge WHERE axis_id = ANY (axes) UNION SELECT to_node FROM edge
            WHERE axis_id = ANY (axes)) INTO touched;
    END IF;
    RETURN QUERY SELECT * FROM _update_junctions(touched);
END $$;
COMMENT ON FUNCTION streetgen._update_junction(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings junctions up to date, and signals with them.';
