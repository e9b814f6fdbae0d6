-- City blocks, computed from edges and kerbs that are in their tables.

CREATE OR REPLACE FUNCTION streetgen._block_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (30, 'block', 'block', 'block_id', NULL, 'block', 1),
    (31, 'block_edge', 'block', NULL, NULL, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._block_computed_table() IS 'The computed tables of city blocks.';

CREATE OR REPLACE FUNCTION streetgen._blocks(edges bigint[], edge_lines bytea[], on_rings boolean[],
    kerb_edges bigint[], kerb_sides text[], kerbs_contested boolean[], kerbs_change_level boolean[], kerb_lines bytea[],
    kept_edges bigint[], kept_left boolean[], kept_starts float8[], kept_ends float8[],
    places_x float8[], places_y float8[], kinds text[],
    island_area float8, strip_width float8, strip_elongation float8)
    RETURNS TABLE(number integer, kind text, method text, surface bytea, has_all_kerbs boolean, edge_ids bigint[],
        lefts boolean[], rings integer[], starts float8[], ends float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_blocks';
COMMENT ON FUNCTION streetgen._blocks(bigint[], bytea[], boolean[], bigint[], text[], boolean[], boolean[], bytea[],
    bigint[], boolean[], float8[], float8[], float8[], float8[], text[], float8, float8, float8) IS
    'The blocks of edges of one level (ids and EWKB, in the order of their places; on_rings: whether they are '
    'parts of roundabouts) and the kerbs of that level, numbered from 1 in the order of their smallest places. kept: '
    'sides of the edges, or parts of these, beside faces that stay as they are; such faces do not come out. places '
    'and kinds: decided by hand. Each block has its ground (MULTIPOLYGON, EWKB) and the sides about it: '
    'edge, left or right of it, the ring (1 goes about the block), and from where to where, m along the edge. '
    'has_all_kerbs: no ring of kerbs has a gap, and no axis bounds '
    'it. The last row, number 0, has the sides that lie in no block. Lists of different length: 2202E; NULL in one: '
    '22004; bad geometry, or a number out of its range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._block_statement(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('block_statement'), places) $$;
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
BEGIN
    PERFORM streetgen._use_model(model);
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
    PERFORM streetgen._own_function(model, '_blocks_about(bigint[])',
        'Of axes that lie alone: the blocks that they may lie in, beside the axis; 0: what lies in no block');
    IF 'block' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._drop_own_functions(model, '{_renew_blocks,_write_blocks}');
        RETURN;
    END IF;
    PERFORM streetgen._compose_function(model, '_write_blocks(blocks bigint[], axes bigint[], by_place boolean)',
        'TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)',
        -- An error within a loop's query does not show it whole.
        format(E'#variable_conflict use_column\nBEGIN\n    FOR relation, inserted, updated, deleted, unchanged, '
            'fallbacks IN %s LOOP\n        RETURN NEXT;\n    END LOOP;\nEND',
            streetgen._block_statement(streetgen._upsert_places(model, 'part'))),
        '_write_blocks(bigint[], bigint[], boolean)',
        'Computes and writes blocks, for _renew_blocks: a row per table, none where kerbs are missing');
    CREATE OR REPLACE FUNCTION _renew_blocks(blocks bigint[], axes bigint[])
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks
            bigint)
        LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 2 SET search_path FROM CURRENT SET jit = off
        SET enable_seqscan = off SET random_page_cost = 0.01 SET plan_cache_mode = force_generic_plan
        AS $body$
    #variable_conflict use_column
    DECLARE
        model constant name := current_schema();
        further bigint[];
    BEGIN
        IF blocks = '{}' THEN
            RETURN QUERY SELECT t::text, 0::bigint, 0::bigint, 0::bigint, 0::bigint, 0::bigint
                FROM unnest('{block,block_edge}'::text[]) t;
            RETURN;
        END IF;
        RETURN QUERY SELECT * FROM _write_blocks(blocks, axes, false);
        IF FOUND THEN
            RETURN;
        END IF;
        -- More than was locked: nobody else may hold these, nor a run that does not know of them have shut the door.
        further := ARRAY(SELECT DISTINCT coalesce(b.block_id, 0) FROM edge s, LATERAL (
                SELECT edge_id FROM edge e WHERE e.from_node IN (s.from_node, s.to_node)
                UNION ALL SELECT edge_id FROM edge e WHERE e.to_node IN (s.from_node, s.to_node) OFFSET 0) e,
                LATERAL (SELECT block_id FROM block_edge b WHERE b.edge_id = e.edge_id OFFSET 0) b
            WHERE s.axis_id = ANY (axes) AND coalesce(b.block_id, 0) <> ALL (blocks));
        IF NOT (SELECT streetgen._lock_places(model, p.alone, p.shared, wait => false)
                FROM streetgen._places_of(model, '{}', '{}',
                    ARRAY(SELECT streetgen._chain_key('block', b) FROM unnest(further) b)) p)
            OR further <> '{}' AND NOT streetgen._door_is_open(model) THEN
            PERFORM streetgen._refuse_place(model);
        END IF;
        RETURN QUERY SELECT * FROM _write_blocks(blocks || further, axes, true);
    END $body$;
    PERFORM streetgen._own_function(model, '_renew_blocks(bigint[], bigint[])',
        'Computes and writes blocks that changed, or came with new edges of the axes that were written, a row per '
        'table');
END $$;
COMMENT ON FUNCTION streetgen._make_block_functions(name) IS
    'Makes the functions of a model that tell which blocks lie about an axis, and renew blocks; in a model without '
    'blocks they do nothing.';

CREATE OR REPLACE FUNCTION streetgen._update_block(model name, axes bigint[], moved streetgen.moved_row[],
    noted bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 2 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NULL THEN
        RETURN QUERY SELECT * FROM streetgen._renew_all_blocks(model);
    ELSE
        RETURN QUERY SELECT * FROM _renew_blocks(ARRAY(SELECT id FROM unnest(moved)
            WHERE room = 'block'), axes);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._update_block(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings blocks up to date. moved: those that the '
    'statement changed, 0 for what lies in no block.';
