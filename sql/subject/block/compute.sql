-- City blocks, computed from edges and kerbs that are in their tables.

CREATE OR REPLACE FUNCTION streetgen._blocks(edges bigint[], edge_lines bytea[], kerb_edges bigint[],
    kerb_sides text[], kerbs_contested boolean[], kerbs_change_level boolean[], kerb_lines bytea[],
    kept_edges bigint[], kept_left boolean[], kept_starts float8[], kept_ends float8[],
    places_x float8[], places_y float8[], kinds text[],
    island_area float8, strip_width float8, strip_elongation float8)
    RETURNS TABLE(number integer, kind text, method text, surface bytea, has_all_kerbs boolean, edge_ids bigint[],
        lefts boolean[], rings integer[], starts float8[], ends float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_blocks';
COMMENT ON FUNCTION streetgen._blocks(bigint[], bytea[], bigint[], text[], boolean[], boolean[], bytea[], bigint[],
    boolean[], float8[], float8[], float8[], float8[], text[], float8, float8, float8) IS
    'The blocks of edges of one level (ids and EWKB, in the order of their places) and the kerbs of that level, '
    'numbered from 1 in the order of their smallest places. kept: sides of the edges, or parts of these, beside faces '
    'that stay as they are; such faces do not come out. places and kinds: decided by hand. Each block has its ground '
    '(MULTIPOLYGON, EWKB) and the sides about it: edge, left or right of it, the ring (1 goes about the block), and '
    'from where to where, m along the edge. has_all_kerbs: no ring of kerbs has a gap, and no axis bounds '
    'it. The last row, number 0, has the sides that lie in no block. Lists of different length: 2202E; NULL in one: '
    '22004; bad geometry, or a number out of its range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._block_statement(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$
WITH ground AS MATERIALIZED (
    SELECT max(value) FILTER (WHERE name = 'ground_level')::integer AS level,
        max(value) FILTER (WHERE name = 'block_island_area')::float8 AS island_area,
        max(value) FILTER (WHERE name = 'block_strip_width')::float8 AS strip_width,
        max(value) FILTER (WHERE name = 'block_strip_elongation')::float8 AS strip_elongation
    FROM {model}.setting WHERE name = 'ground_level' OR name LIKE 'block%'),
-- The rows that may change.
old_side AS MATERIALIZED (
    SELECT * FROM {model}.block_edge WHERE {whole} OR block_id = ANY ($1)
    UNION ALL SELECT * FROM {model}.block_edge WHERE NOT {whole} AND 0 = ANY ($1) AND block_id IS NULL),
street AS MATERIALIZED (
    SELECT e.edge_id, e.geom, e.from_node, e.to_node,
        row_number() OVER (ORDER BY e.axis_id, e.start_abscissa) AS number
    FROM ground, {model}.edge e
    WHERE e.level = ground.level AND ({whole} OR e.edge_id = ANY (ARRAY(SELECT edge_id FROM old_side
        UNION SELECT n.edge_id FROM {model}.edge n WHERE n.axis_id = ANY ($2)
            AND (SELECT true FROM {model}.block_edge b WHERE b.edge_id = n.edge_id LIMIT 1) IS NULL)))),
kept AS MATERIALIZED (
    SELECT b.edge_id, b.side, b.start_abscissa, b.end_abscissa
    FROM street s, LATERAL (SELECT * FROM {model}.block_edge b WHERE b.edge_id = s.edge_id OFFSET 0) b
    WHERE NOT {whole} AND coalesce(b.block_id, 0) <> ALL ($1)),
-- Kerbs that others contest may lie beside an edge that they are not of. Those near streets that begin in one cell
-- are looked up together.
cell AS MATERIALIZED (
    SELECT ST_SetSRID(ST_Expand(ST_Extent(geom)::geometry, 50), {srid}) AS box FROM street WHERE NOT $3
    GROUP BY floor(ST_XMin(geom) / 400), floor(ST_YMin(geom) / 400)),
-- All of a place, where a ring has a gap else.
extent AS MATERIALIZED (
    SELECT ST_SetSRID(ST_Expand(ST_Extent(geom)::geometry, 200), {srid}) AS extent FROM street WHERE $3),
beside AS MATERIALIZED (
    SELECT k.edge_id, k.side, k.method, k.geom
    FROM ground, street s, LATERAL (SELECT * FROM {model}.kerb k WHERE k.edge_id = s.edge_id {by_key}) k
    WHERE k.level = ground.level AND NOT $3
    -- The edge of another level may have the corner where that level begins.
    UNION ALL SELECT k.edge_id, k.side, k.method, k.geom
    FROM ground, (SELECT from_node AS node_id FROM street UNION SELECT to_node FROM street) n,
        LATERAL (SELECT * FROM {model}.kerb k WHERE k.node_id = n.node_id {by_key}) k,
        LATERAL (SELECT level FROM {model}.edge e WHERE e.edge_id = k.edge_id {by_key}) e
    WHERE k.level = ground.level AND k.edge_id NOT IN (SELECT edge_id FROM street) AND e.level <> ground.level
        AND NOT $3
    UNION ALL (SELECT DISTINCT ON (k.kerb_id) k.edge_id, k.side, k.method, k.geom FROM ground, cell, LATERAL (
        SELECT * FROM {model}.kerb k WHERE k.geom && cell.box AND k.method = 'contested' {by_key}) k
    WHERE k.level = ground.level AND k.edge_id NOT IN (SELECT edge_id FROM street))
    UNION ALL SELECT k.edge_id, k.side, k.method, k.geom FROM ground, extent, LATERAL (
        SELECT * FROM {model}.kerb k WHERE {whole} OR k.geom && extent {by_key}) k
    WHERE k.level = ground.level AND $3),
found AS MATERIALIZED (
    SELECT b.* FROM ground g,
        (SELECT array_agg(edge_id ORDER BY number) AS ids, array_agg(ST_Force2D(geom)::bytea ORDER BY number) AS lines
            FROM street) s,
        (SELECT coalesce(array_agg(edge_id), ARRAY[]::bigint[]) AS edges,
            coalesce(array_agg(side), ARRAY[]::text[]) AS sides,
            coalesce(array_agg(method = 'contested'), ARRAY[]::boolean[]) AS contested,
            coalesce(array_agg(method = 'level_change'), ARRAY[]::boolean[]) AS change_level,
            coalesce(array_agg(geom::bytea), ARRAY[]::bytea[]) AS lines FROM beside) k,
        (SELECT coalesce(array_agg(edge_id), ARRAY[]::bigint[]) AS edges,
            coalesce(array_agg(side = 'left'), ARRAY[]::boolean[]) AS lefts,
            coalesce(array_agg(start_abscissa), ARRAY[]::float8[]) AS starts,
            coalesce(array_agg(end_abscissa), ARRAY[]::float8[]) AS ends FROM kept) t,
        (SELECT coalesce(array_agg(ST_X(geom) ORDER BY block_override_id), ARRAY[]::float8[]) AS x,
            coalesce(array_agg(ST_Y(geom) ORDER BY block_override_id), ARRAY[]::float8[]) AS y,
            coalesce(array_agg(kind ORDER BY block_override_id), ARRAY[]::text[]) AS kinds
            FROM {model}.block_override) o,
        LATERAL streetgen._blocks(s.ids, s.lines, k.edges, k.sides, k.contested, k.change_level, k.lines, t.edges,
            t.lefts, t.starts, t.ends, o.x, o.y, o.kinds, g.island_area, g.strip_width, g.strip_elongation) b),
-- Without all kerbs nothing is written: they are then asked for by place. What an axis bounds depends on blocks across.
given AS MATERIALIZED (
    SELECT $3 OR coalesce(bool_and(has_all_kerbs), true) AND NOT EXISTS (SELECT FROM {model}.block
        WHERE block_id = ANY ($1) AND method = 'axis_bound') AS whole FROM found),
found_side AS MATERIALIZED (
    SELECT f.number, s.edge_id, CASE WHEN s."left" THEN 'left' ELSE 'right' END AS side, s.start_abscissa,
        s.end_abscissa, s.ring, s.ordinality::integer AS ordinality
    FROM found f, given, unnest(edge_ids, lefts, rings, starts, ends)
        WITH ORDINALITY s(edge_id, "left", ring, start_abscissa, end_abscissa, ordinality) WHERE given.whole),
-- Identity of blocks: by the smallest place of their ring.
heir AS MATERIALIZED (
    SELECT DISTINCT ON (f.number) f.number, o.block_id FROM found_side f JOIN old_side o
        ON (o.edge_id, o.side, o.start_abscissa) = (f.edge_id, f.side, f.start_abscissa)
    WHERE f.number > 0 AND o.block_id IS NOT NULL AND o.ordinality = 1 ORDER BY f.number, f.ordinality),
new_block AS MATERIALIZED (
    SELECT number, coalesce(h.block_id, nextval('{quoted_model}.block_block_id_seq')) AS block_id,
        h.block_id IS NULL AS fresh, kind, surface::geometry(MultiPolygon, {srid}) AS surface, method
    FROM (SELECT f.* FROM found f, given WHERE f.number > 0 AND given.whole ORDER BY f.number) f
        LEFT JOIN heir h USING (number) ORDER BY number),
changed_block AS MATERIALIZED (
    SELECT n.* FROM new_block n LEFT JOIN {model}.block o USING (block_id)
    WHERE n.fresh OR (o.kind, o.surface, o.method) IS DISTINCT FROM (n.kind, n.surface, n.method)),
set_block AS (
    INSERT INTO {model}.block (block_id, kind, surface, method)
    SELECT block_id, kind, surface, method FROM changed_block ORDER BY number
    ON CONFLICT (block_id) DO UPDATE SET (kind, surface, method) =
        (excluded.kind, excluded.surface, excluded.method)),
gone_block AS (
    DELETE FROM {model}.block b USING given
    WHERE given.whole AND ({whole} OR b.block_id = ANY ($1)) AND b.block_id NOT IN (SELECT block_id FROM new_block)
    RETURNING 1),
changed_side AS MATERIALIZED (
    SELECT f.edge_id, f.side, f.start_abscissa, f.end_abscissa, n.block_id, f.ring,
        -- About the outside there is no order.
        CASE WHEN n.number IS NULL THEN 1 ELSE f.ordinality END AS ordinality, o.edge_id IS NULL AS fresh
    FROM found_side f LEFT JOIN new_block n USING (number)
        LEFT JOIN old_side o ON (o.edge_id, o.side, o.start_abscissa) = (f.edge_id, f.side, f.start_abscissa)
    WHERE (o.block_id, o.end_abscissa, o.ring, o.ordinality) IS DISTINCT FROM (n.block_id, f.end_abscissa, f.ring,
        CASE WHEN n.number IS NULL THEN 1 ELSE f.ordinality END)),
set_side AS (
    INSERT INTO {model}.block_edge (edge_id, side, start_abscissa, end_abscissa, block_id, ring, ordinality)
    SELECT edge_id, side, start_abscissa, end_abscissa, block_id, ring, ordinality FROM changed_side
    ON CONFLICT (edge_id, side, start_abscissa) DO UPDATE SET (end_abscissa, block_id, ring, ordinality) =
        (excluded.end_abscissa, excluded.block_id, excluded.ring, excluded.ordinality)),
gone_side AS (
    DELETE FROM {model}.block_edge b USING given, old_side o
    WHERE given.whole AND (b.edge_id, b.side, b.start_abscissa) = (o.edge_id, o.side, o.start_abscissa)
        -- By hash, whatever the planner expects.
        AND (o.edge_id, o.side, o.start_abscissa) NOT IN (SELECT edge_id, side, start_abscissa FROM found_side)
    RETURNING 1)
SELECT 'block', (SELECT count(*) FROM changed_block WHERE fresh), (SELECT count(*) FROM changed_block WHERE NOT fresh),
    (SELECT count(*) FROM gone_block), (SELECT count(*) FROM new_block) - (SELECT count(*) FROM changed_block),
    (SELECT count(*) FROM new_block WHERE method <> 'hypothesis')
FROM given WHERE given.whole
UNION ALL SELECT 'block_edge', (SELECT count(*) FROM changed_side WHERE fresh),
    (SELECT count(*) FROM changed_side WHERE NOT fresh), (SELECT count(*) FROM gone_side),
    (SELECT count(*) FROM found_side) - (SELECT count(*) FROM changed_side), 0
FROM given WHERE given.whole$part$, places) $$;
COMMENT ON FUNCTION streetgen._block_statement(jsonb) IS
    'The statement that computes and writes blocks: of all of a model, or those of an array of ids ($1; 0: what lies '
    'in no block) with the edges of an array of axes ($2) that are new; kerbs are looked up by edges, or by place '
    '($3). A row for each of the two tables: relation, inserted, updated, deleted, unchanged, fallbacks; none, and '
    'nothing written, where kerbs are missing that a look by place may find.';

CREATE OR REPLACE FUNCTION streetgen._renew_all_blocks(model name)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 2 SET search_path = pg_catalog, public SET jit = off
    SET enable_nestloop = off SET enable_mergejoin = off SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF 'block' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY EXECUTE streetgen._block_statement(streetgen._upsert_places(model, 'whole'))
            USING '{}'::bigint[], '{}'::bigint[], true;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._renew_all_blocks(name) IS
    'Computes and writes all blocks of a model that computes them, for who is alone in it; gives a row per table.';

CREATE OR REPLACE FUNCTION streetgen._make_block_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    renewed text := '';
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'block' = ANY (streetgen._subjects(model)) THEN
        renewed := format($sql$
    IF blocks = '{}' THEN
        RETURN QUERY SELECT t::text, 0::bigint, 0::bigint, 0::bigint, 0::bigint, 0::bigint
            FROM unnest('{block,block_edge}'::text[]) t;
        RETURN;
    END IF;
    FOREACH by_place IN ARRAY ARRAY[false, true] LOOP
        IF by_place THEN
            -- More than was locked: nobody else may hold these, nor a run that does not know of them have shut the
            -- door.
            further := ARRAY(SELECT DISTINCT coalesce(b.block_id, 0) FROM %2$I.edge s, LATERAL (
                    SELECT edge_id FROM %2$I.edge e WHERE e.from_node IN (s.from_node, s.to_node)
                    UNION ALL SELECT edge_id FROM %2$I.edge e WHERE e.to_node IN (s.from_node, s.to_node) OFFSET 0) e,
                    LATERAL (SELECT block_id FROM %2$I.block_edge b WHERE b.edge_id = e.edge_id OFFSET 0) b
                WHERE s.axis_id = ANY (axes) AND coalesce(b.block_id, 0) <> ALL (blocks));
            IF NOT (SELECT streetgen._lock_places(%3$L, p.alone, p.shared, wait => false)
                    FROM streetgen._places_of(%3$L, '{}', '{}',
                        ARRAY(SELECT streetgen._chain_key('block', b) FROM unnest(further) b)) p)
                OR further <> '{}' AND NOT streetgen._door_is_open(%3$L) THEN
                PERFORM streetgen._refuse_place(%3$L);
            END IF;
            blocks := blocks || further;
        END IF;
        FOR relation, inserted, updated, deleted, unchanged, fallbacks IN %1$s LOOP
            found := true;
            RETURN NEXT;
        END LOOP;
        EXIT WHEN found;
    END LOOP;$sql$, regexp_replace(regexp_replace(regexp_replace(
            streetgen._block_statement(streetgen._upsert_places(model, 'part')),
            '\$1', 'blocks', 'g'), '\$2', 'axes', 'g'), '\$3', 'by_place', 'g'), model, model);
    END IF;
    CREATE OR REPLACE FUNCTION _blocks_about(axes bigint[]) RETURNS TABLE(axis_id bigint, block_id bigint)
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path FROM CURRENT SET jit = off
        SET enable_seqscan = off SET plan_cache_mode = force_generic_plan
        AS $body$
    #variable_conflict use_column
    BEGIN
        IF 'block' <> ALL (streetgen._subjects(current_schema())) THEN
            RETURN;
        END IF;
        -- The face about an axis that lies alone is the one at the nearest edge: at all edges of its nodes, since the
        -- nearest place may be a node.
        RETURN QUERY
        WITH reach AS MATERIALIZED (SELECT value::float8 AS reach FROM setting WHERE name = 'reach'),
        ground AS MATERIALIZED (SELECT value::integer AS level FROM setting WHERE name = 'ground_level'),
        street AS MATERIALIZED (
            SELECT a.axis_id, o.from_node, o.to_node FROM reach, ground, axis a
            -- The nearest box bounds the distance, as in _nearest_axis.
            LEFT JOIN LATERAL (SELECT e.geom FROM edge e WHERE e.axis_id <> a.axis_id AND e.level = ground.level
                ORDER BY e.geom <#> a.geom LIMIT 1) b ON true
            LEFT JOIN LATERAL (SELECT e.from_node, e.to_node FROM edge e
                WHERE e.axis_id <> a.axis_id AND e.level = ground.level
                    AND ST_DWithin(e.geom, a.geom, ST_Distance(b.geom, a.geom))
                ORDER BY ST_Distance(e.geom, a.geom), e.edge_id LIMIT 1) o ON true
            WHERE a.axis_id = ANY (axes) AND NOT EXISTS (SELECT FROM edge e WHERE e.axis_id <> a.axis_id
                AND e.geom && ST_Expand(a.geom, reach) AND ST_DWithin(e.geom, a.geom, reach))
                -- Its own edges tell where it lies as it did.
                AND NOT coalesce((SELECT ST_HausdorffDistance(ST_Collect(e.geom), a.geom) < 0.001
                        AND bool_and(streetgen._runs_along(e.geom, a.geom, e.start_abscissa, e.end_abscissa))
                    FROM edge e WHERE e.axis_id = a.axis_id), false))
        SELECT DISTINCT s.axis_id, coalesce(b.block_id, 0) FROM street s LEFT JOIN LATERAL (
                SELECT edge_id FROM edge e WHERE e.from_node IN (s.from_node, s.to_node)
                UNION ALL SELECT edge_id FROM edge e WHERE e.to_node IN (s.from_node, s.to_node) OFFSET 0) e ON true
            LEFT JOIN LATERAL (SELECT block_id, true AS there FROM block_edge b WHERE b.edge_id = e.edge_id OFFSET 0) b
                ON true
        WHERE b.there OR e.edge_id IS NULL;
    END $body$;
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._renew_blocks(blocks bigint[], axes bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 2 SET search_path FROM CURRENT SET jit = off
    SET enable_seqscan = off SET random_page_cost = 0.01 SET plan_cache_mode = force_generic_plan
    AS $body$
#variable_conflict use_column
DECLARE
    by_place boolean;
    further bigint[];
    found boolean := false;
BEGIN
    %2$s
END $body$ $sql$, model, renewed);
    PERFORM streetgen._own_function(model, '_blocks_about(bigint[])',
        'Of axes that lie alone: the blocks that they may lie in, beside the axis; 0: what lies in no block'),
        streetgen._own_function(model, '_renew_blocks(bigint[], bigint[])',
        'Computes and writes blocks that changed, or came with new edges of the axes that were written, a row per '
        'table');
END $$;
COMMENT ON FUNCTION streetgen._make_block_functions(name) IS
    'Makes the functions of a model that tell which blocks lie about an axis, and renew blocks; in a model without '
    'blocks they do nothing.';

CREATE OR REPLACE FUNCTION streetgen._update_block(model name, axes bigint[], moved bigint[], noted bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 2 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NULL THEN
        RETURN QUERY SELECT * FROM streetgen._renew_all_blocks(model);
    ELSE
        RETURN QUERY SELECT * FROM _renew_blocks(moved, axes);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._update_block(name, bigint[], bigint[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings blocks up to date. moved: those that the '
    'statement changed, 0 for what lies in no block.';
