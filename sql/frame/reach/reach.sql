-- The reach of an edit or a run: the axes that it writes, those it computes with, and the keys that lock both.

CREATE OR REPLACE FUNCTION streetgen._runs_along(edge geometry, axis geometry, start_abscissa float8,
    end_abscissa float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN ST_Distance(ST_LineInterpolatePoint(edge, 1.0 / 3), ST_LineInterpolatePoint(axis, greatest(0, least(1,
        (2 * start_abscissa + end_abscissa) / (3 * ST_Length(axis)))))) < 0.01;
COMMENT ON FUNCTION streetgen._runs_along(geometry, geometry, float8, float8) IS
    'Does an edge still run between these abscissas of its axis, in its direction? A reversed axis lies where it did.';

CREATE OR REPLACE FUNCTION streetgen._change_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    reach float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT _change_reach() INTO reach;
    RETURN reach;
END $$;
COMMENT ON FUNCTION streetgen._change_reach(name) IS 'How far a change of an axis reaches by the settings, metres.';

CREATE OR REPLACE FUNCTION streetgen._make_change_reach(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._compose_function(model, '_change_reach()', 'float8', format('BEGIN RETURN greatest(%s); END',
        (SELECT string_agg(format('streetgen.%I(current_schema())', called), ', ' ORDER BY called)
        FROM unnest(streetgen._subjects(model)) s, concat('_', s, '_reach') called
        WHERE to_regprocedure(format('streetgen.%I(name)', called)) IS NOT NULL)),
        '_change_reach()', 'How far a change of an axis reaches by the settings, metres');
END $$;
COMMENT ON FUNCTION streetgen._make_change_reach(name) IS
    'Makes the function of a model that tells how far a change reaches: the farthest of its subjects, by functions '
    '_SUBJECT_reach (model).';

CREATE OR REPLACE FUNCTION streetgen._make_reach(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _place_without_edge(requested bigint[]) RETURNS TABLE(geom geometry, width float8)
        LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path FROM CURRENT
        AS $body$
    -- Too short for an edge, it joined others.
    SELECT geom, 0 FROM report WHERE axis_a = ANY (requested) AND issue = 'collapsed_axis'
    -- It lay on edges of another, which it cut.
    UNION ALL SELECT e.geom, greatest(e.width, e.width_end) + 2 * abs(e.roadway_offset)
        FROM report r JOIN edge e ON e.axis_id = r.axis_b
        WHERE r.axis_a = ANY (requested) AND r.issue = 'axis lies on another'
            AND e.geom && ST_Expand(r.geom, r.measure)
    $body$;
    PERFORM streetgen._own_function(model, '_place_without_edge(bigint[])',
        'Where axes lie that have no edge of their own, or not everywhere, and how wide the street there is');
    CREATE OR REPLACE FUNCTION _reach(requested bigint[], OUT stale bigint[], OUT written bigint[],
        OUT gathered bigint[], OUT cells integer[], OUT districts integer[], OUT chains integer[])
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        SET enable_seqscan = off SET plan_cache_mode = force_generic_plan
        AS $body$
    DECLARE
        reach constant float8 := _change_reach();
        size float8;
        tolerance float8;
        -- No roadway is wider.
        widest float8;
        -- The requested axes that are there, and how wide they are.
        present bigint[];
        widths float8[];
        -- The edges that the requested axes can change, and their axes: NULL where nothing but a surface can change.
        edges bigint[];
        turned bigint[];
        -- Do the requested axes lie as their edges say? What changed is a width, or another value.
        still boolean;
    BEGIN
        SELECT max(value::float8) FILTER (WHERE name = 'cell_size'),
               max(value::float8) FILTER (WHERE name = 'tolerance'),
               greatest(max(value::float8) FILTER (WHERE name = 'width_default'),
                   (SELECT max(greatest(e.width, e.width_end) + 2 * abs(e.roadway_offset)) FROM edge e),
                   (SELECT max(a.width) FROM axis a),
                   (SELECT max(k.width) FROM kerb_point_override k), (SELECT max(greatest(c.width, c.width_one_way,
                       c.lanes_one_way * lane.width) + c.parking_left + c.parking_right) FROM axis_class c,
                       (SELECT value::float8 AS width FROM setting WHERE name = 'lane_width') lane))
                   + coalesce((SELECT 2 * greatest(max(roadway_offset), -min(roadway_offset)) FROM axis
                       WHERE roadway_offset <> 0), 0)
            INTO size, tolerance, widest FROM setting WHERE name IN ('cell_size', 'tolerance', 'width_default');
        SELECT array_agg(u.axis_id), array_agg(greatest(u.width, u.width_end)
            + 2 * abs(u.roadway_offset)) INTO present, widths FROM axis_used u
            WHERE u.axis_id = ANY (requested);
        -- Axes that the requested ones can change: along the network, and by their roadway.
        WITH line AS MATERIALIZED (
            SELECT geom, u.width FROM unnest(present, widths) u(axis_id, width) JOIN axis USING (axis_id)
            UNION ALL SELECT geom, greatest(width, width_end) + 2 * abs(roadway_offset) FROM edge
                WHERE axis_id = ANY (requested)
            UNION ALL SELECT geom, width FROM _place_without_edge(requested)),
        near AS MATERIALIZED (
            SELECT e.*, distance <= 3 * tolerance AS met
            FROM line l, LATERAL (
                SELECT edge_id, axis_id, from_node, to_node, e.geom,
                    greatest(e.width, width_end) + 2 * abs(roadway_offset) AS width,
                    ST_Distance(e.geom, l.geom) AS distance
                FROM edge e WHERE e.geom && ST_Expand(l.geom, greatest(reach + (l.width + widest) / 2,
                    3 * tolerance)) OFFSET 0) e
            WHERE distance <= greatest(reach + (l.width + e.width) / 2, 3 * tolerance)),
        -- The far end of an edge moves too where limits cross, however far.
        far_end AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS ids FROM near WHERE met),
        -- An intersection that they meet claims ground farther off too, where a limit lies beyond the reach.
        reaching AS MATERIALIZED (
            SELECT DISTINCT ON (edge_id) geom, width FROM near n WHERE met AND EXISTS (
                SELECT FROM section_limit l WHERE l.edge_id = n.edge_id AND n.width / 2 + CASE which WHEN 'start'
                    THEN l.abscissa ELSE ST_Length(n.geom) - l.abscissa END > reach)),
        part AS MATERIALIZED (
            SELECT axis_id, edge_id, true AS turns FROM edge
                WHERE from_node = ANY ((SELECT ids FROM far_end)::bigint[])
            UNION SELECT axis_id, edge_id, true FROM edge WHERE to_node = ANY ((SELECT ids FROM far_end)::bigint[])
            -- An axis put between others may turn those that lie nearest.
            UNION SELECT axis_id, edge_id, cardinality(requested) > 1
                OR NOT EXISTS (SELECT FROM near n WHERE n.met AND n.axis_id <> ALL (requested))
                FROM near
            UNION SELECT e.axis_id, e.edge_id, false FROM reaching l
                JOIN edge e ON e.geom && ST_Expand(l.geom, reach + (l.width + widest) / 2)
                AND ST_DWithin(e.geom, l.geom, reach + (l.width + greatest(e.width, e.width_end)) / 2
                    + abs(e.roadway_offset)))
        SELECT ARRAY(SELECT axis_id FROM part
                -- An axis that joined its ends may part them, one that lay on another may be a street.
                UNION SELECT axis_a FROM report r JOIN line l ON l.geom && ST_Expand(r.geom, measure + 3 * tolerance)
                    WHERE issue IN ('collapsed_axis', 'axis lies on another')
                UNION SELECT axis_a FROM report WHERE axis_b = ANY (requested) AND issue = 'axis lies on another'
                UNION SELECT unnest(requested)),
            e.edges, e.turned
            INTO written, edges, turned
            FROM (SELECT coalesce(array_agg(edge_id), '{}') AS edges,
                coalesce(array_agg(CASE WHEN turns THEN axis_id END), '{}') AS turned FROM part) e;
        stale := ARRAY(SELECT axis_id FROM axis_used u WHERE axis_id = ANY (written)
            AND axis_id NOT IN (SELECT unnest(requested))
            AND coalesce((SELECT bool_or(e.input_hash <> u.input_hash) FROM edge e WHERE e.axis_id = u.axis_id),
                true));
        IF stale <> '{}' THEN
            RETURN;
        END IF;
        WITH own AS MATERIALIZED (
            SELECT axis_id, from_node, to_node, geom, greatest(width, width_end) + 2 * abs(roadway_offset) AS width,
                box3d(geom) AS extent
                FROM edge WHERE axis_id = ANY (written)),
        line AS MATERIALIZED (
            SELECT axis_id, geom, floor(ST_XMin(extent) / size) AS x, floor(ST_YMin(extent) / size) AS y, extent,
                reach + width / 2 AS margin, ST_Expand(geom, reach + (width + widest) / 2) AS box
            FROM (SELECT axis_id, max(width) AS width FROM (SELECT axis_id, width FROM own
                UNION ALL SELECT * FROM unnest(present, widths)) w(axis_id, width) GROUP BY axis_id OFFSET 0) w
                JOIN (SELECT axis_id, geom, box3d(geom) AS extent FROM axis WHERE axis_id = ANY (written) OFFSET 0) a
                    USING (axis_id)),
        -- What that depends on. Axes are looked up once for all lines that begin in one cell.
        around AS MATERIALIZED (
            SELECT x, y, a.axis_id, a.geom FROM (SELECT x, y, ST_Extent(box)::geometry AS box FROM line GROUP BY x, y) b
                JOIN axis a ON a.geom && b.box AND a.axis_id NOT IN (SELECT unnest(written))),
        edge_around AS MATERIALIZED (
            SELECT axis_id, from_node, to_node, geom, greatest(width, width_end) + 2 * abs(roadway_offset) AS width
                FROM edge WHERE axis_id = ANY (ARRAY(SELECT axis_id FROM around))),
        beside AS MATERIALIZED (
            SELECT DISTINCT axis_id FROM around b LEFT JOIN (SELECT axis_id, max(width) AS width FROM edge_around
                GROUP BY axis_id) e USING (axis_id)
            WHERE EXISTS (SELECT FROM line l WHERE (l.x, l.y) = (b.x, b.y) AND b.geom && l.box
                AND ST_DWithin(b.geom, l.geom, l.margin + coalesce(e.width, widest) / 2))),
        -- Merging lanes come along a highway from afar, from links that meet it, and turn marks from before a node of
        -- two edges.
        run AS MATERIALIZED (SELECT axis_id, from_node, to_node, geom FROM _merging_run(written)
            UNION ALL SELECT axis_id, from_node, to_node, geom FROM _marked_run(written)),
        run_node AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS ids FROM run),
        -- With what meets it farther on: that bounds its edges.
        bounded AS MATERIALIZED (SELECT from_node, to_node, geom FROM own
            UNION ALL SELECT from_node, to_node, geom FROM edge
                WHERE from_node = ANY ((SELECT ids FROM run_node)::bigint[])
            UNION ALL SELECT from_node, to_node, geom FROM edge
                WHERE to_node = ANY ((SELECT ids FROM run_node)::bigint[])
            UNION ALL SELECT from_node, to_node, geom FROM edge_around WHERE axis_id IN (SELECT axis_id FROM beside)),
        met AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS ids FROM bounded),
        met_axis AS MATERIALIZED (
            SELECT axis_id FROM edge WHERE from_node = ANY ((SELECT ids FROM met)::bigint[])
                UNION SELECT axis_id FROM edge WHERE to_node = ANY ((SELECT ids FROM met)::bigint[])
            -- An axis too short for an edge has no node, but may place that of others.
            UNION SELECT axis_a FROM report r WHERE issue IN ('collapsed_axis', 'axis lies on another')
                AND ST_Expand(geom, measure)
                    && (SELECT ST_Expand(ST_Extent(geom)::geometry, 3 * tolerance) FROM bounded)
                AND EXISTS (SELECT FROM axis a JOIN node n ON ST_DWithin(n.geom, a.geom, 3 * tolerance)
                    WHERE a.axis_id = r.axis_a AND n.node_id = ANY ((SELECT ids FROM met)::bigint[]))
            EXCEPT (SELECT axis_id FROM line UNION ALL SELECT axis_id FROM beside)),
        -- A run writes every axis near the requested ones whole, ends included. Most lie in the same few districts.
        box AS MATERIALIZED (
            SELECT DISTINCT streetgen._district_of(ST_XMin(extent) - margin, size) AS west,
                streetgen._district_of(ST_YMin(extent) - margin, size) AS south,
                streetgen._district_of(ST_XMax(extent) + margin, size) AS east,
                streetgen._district_of(ST_YMax(extent) + margin, size) AS north
            FROM (SELECT extent,
                    CASE WHEN axis_id IN (SELECT unnest(requested)) THEN reach + widest ELSE 10 END AS margin
                FROM (SELECT axis_id, extent FROM line UNION ALL SELECT axis_id, extent FROM own
                    UNION ALL SELECT NULL, box3d(geom) FROM run) l OFFSET 0) m)
        SELECT ARRAY(SELECT axis_id FROM line UNION ALL SELECT axis_id FROM beside
            UNION ALL SELECT axis_id FROM axis WHERE axis_id = ANY (ARRAY(SELECT axis_id FROM met_axis))),
               ARRAY(SELECT DISTINCT key FROM box, streetgen._districts(west, south, east, north) key),
               ARRAY(SELECT streetgen._axis_key(axis_id) FROM (SELECT unnest(written) AS axis_id
                   UNION SELECT axis_id FROM run) a)
            INTO gathered, districts, chains;
        still := NOT EXISTS (SELECT FROM unnest(requested) r(axis_id) LEFT JOIN axis a USING (axis_id)
            WHERE NOT coalesce((SELECT bool_and(e.level = a.level AND e.input_hash <> 0
                        AND streetgen._runs_along(e.geom, a.geom, e.start_abscissa, e.end_abscissa))
                    AND ST_HausdorffDistance(ST_Collect(e.geom), a.geom) < 0.001
                FROM edge e WHERE e.axis_id = r.axis_id), false));
        -- Two sessions that change an axis each have half of the way each: both know the axes that are there.
        cells := ARRAY(
            SELECT DISTINCT key FROM (
                SELECT geom, u.width FROM unnest(present, widths) u(axis_id, width) JOIN axis USING (axis_id)
                UNION ALL SELECT geom, greatest(width, width_end) + 2 * abs(roadway_offset) FROM edge
                    WHERE axis_id = ANY (requested) AND NOT still
                UNION ALL SELECT geom, width FROM _place_without_edge(requested) WHERE NOT still) l,
                streetgen._cells(l.geom, greatest(reach + (l.width + widest) / 2, 3 * tolerance) / 2, size) key);
        -- The outside changes with edges alone.
        chains := chains || ARRAY(SELECT DISTINCT key FROM _chain_keys(requested, written, turned, edges)
            WHERE NOT still AND axis_id IS NOT NULL OR key <> streetgen._chain_key('block', 0));
    END $body$;
    PERFORM streetgen._own_function(model, '_reach(bigint[])',
        'Of requested axes: the stale ones near, all whose rows a run for them writes; where none is stale, all that '
        'these are computed with, and the keys of the cells about the requested ones, of the districts of all that '
        'it writes, and of the axes and chains that it may change');
END $$;
COMMENT ON FUNCTION streetgen._make_reach(name) IS
    'Makes the function of a model that tells how far a run for some axes reaches.';

CREATE OR REPLACE FUNCTION streetgen._reach_of(model name, axes bigint[], OUT requested bigint[], OUT written bigint[],
    OUT gathered bigint[], OUT cells integer[], OUT districts integer[], OUT chains integer[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    stale bigint[] := axes;
BEGIN
    PERFORM streetgen._use_model(model);
    requested := '{}';
    written := '{}';
    gathered := '{}';
    -- An axis that changed while nobody followed changes what is around it too.
    WHILE stale <> '{}' LOOP
        requested := requested || stale;
        SELECT * FROM _reach(requested) INTO stale, written, gathered, cells, districts, chains;
    END LOOP;
    cells := coalesce(cells, '{}');
    districts := coalesce(districts, '{}');
    chains := coalesce(chains, '{}');
END $$;
COMMENT ON FUNCTION streetgen._reach_of(name, bigint[]) IS
    'What a run for some axes requests, writes and gathers, and the keys of its cells, districts, axes and chains: '
    'stale axes near the requested ones are requested too.';

CREATE OR REPLACE FUNCTION streetgen._make_setting_changed(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- No run mixes settings: any edge tells.
    CREATE OR REPLACE FUNCTION _setting_changed() RETURNS boolean
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT
        AS $body$
    BEGIN
        RETURN coalesce((SELECT setting_hash FROM edge LIMIT 1) <> (SELECT setting_hash FROM setting_used),
            false);
    END $body$;
    PERFORM streetgen._own_function(model, '_setting_changed()',
        'Were settings changed since the streets were computed?');
END $$;
COMMENT ON FUNCTION streetgen._make_setting_changed(name) IS
    'Makes the function of a model that tells whether its settings changed.';

CREATE OR REPLACE FUNCTION streetgen._setting_changed(model name) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    changed boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT _setting_changed() INTO changed;
    RETURN changed;
END $$;
COMMENT ON FUNCTION streetgen._setting_changed(name) IS
    'Were settings of the model changed since its streets were computed?';
