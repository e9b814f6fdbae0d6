-- The one statement, roundabouts: rings are found and scored before streets are computed, since traffic on the
-- accepted ones runs one way round; their rows are written after the edges.

CREATE OR REPLACE FUNCTION streetgen._roundabout_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    (25, 'roundabout', 'roundabout', 'roundabout_id', 'edge_id, along_axis', 'roundabout', 1),
    (26, 'roundabout_edge', 'roundabout', 'roundabout_edge_id', 'edge_id, along_axis', 'roundabout_edge', 1),
    (27, 'roundabout_arm', 'roundabout', 'roundabout_arm_id', 'roundabout_id, edge_id, along_axis',
        'roundabout_arm', 1) $$;
COMMENT ON FUNCTION streetgen._roundabout_computed_table() IS 'The computed tables of roundabouts.';

CREATE OR REPLACE FUNCTION streetgen._upsert_ring_score(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('ring_score'),
    places) $$;
COMMENT ON FUNCTION streetgen._upsert_ring_score(jsonb) IS
    'Part of the one statement: ring, the rings of the axes used with their terms, scores and what is decided.';

CREATE OR REPLACE FUNCTION streetgen._upsert_ring(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._upsert_ring_score(places), streetgen._fill_template(streetgen._part('ring'),
    places || jsonb_build_object('beside_rings', CASE places ->> 'run' WHEN 'cluster' THEN '0'
        ELSE '(v ->> ''roundabout_radius_greatest'')::float8' END))) $$;
COMMENT ON FUNCTION streetgen._upsert_ring(jsonb) IS
    'Part of the one statement: new_ring, the rings to be written, with new_ring_edge and new_ring_arm; circulated and '
    'yielding, all edges whose traffic goes round, and those that come to them; ring_turned, axes whose traffic '
    'another decision turns.';

CREATE OR REPLACE FUNCTION streetgen._upsert_roundabout(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('roundabout'), places),
    streetgen._upsert_rows(places, 'roundabout', named => true,
        columns => 'edge_id, along_axis, level, kind, centre, radius, geom, island, score, term_shape, term_name, '
            'term_network, accepted, confirmed, method', rows => streetgen._part('roundabout_rows'),
        there => 'SELECT roundabout_id FROM old_ring'),
    streetgen._upsert_rows(places, 'roundabout_edge', columns => 'edge_id, along_axis, roundabout_id, face, '
            'ordinality',
        rows => $part$
        SELECT row_number() OVER (ORDER BY ring, ordinality)::integer AS number, edge_id, along_axis,
            (SELECT ids FROM roundabout_ids)[ring] AS roundabout_id, face, ordinality
        FROM named_ring_edge WHERE ring IN (SELECT ring FROM named_ring_edge WHERE ordinality = 1)$part$,
        there => 'SELECT roundabout_edge_id FROM {model}.roundabout_edge JOIN old_ring USING (roundabout_id)'),
    streetgen._upsert_rows(places, 'roundabout_arm', columns => 'roundabout_id, edge_id, along_axis, node_id',
        rows => streetgen._part('roundabout_arm_rows'),
        there => 'SELECT roundabout_arm_id FROM {model}.roundabout_arm JOIN old_ring USING (roundabout_id)'))
    $$;
COMMENT ON FUNCTION streetgen._upsert_roundabout(jsonb) IS
    'Part of the one statement: rings with their edges and arms at new_edge.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_places(places jsonb) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN NOT places -> 'subjects' ? 'roundabout' THEN jsonb_build_object('rings', '', 'or_turned', '',
        'yields', '', 'edge_circulation', '',
        'lanes_of_edge', 'u.lanes_forward, u.lanes_backward, u.lanes_both')
    ELSE jsonb_build_object('rings', streetgen._upsert_ring(places) || ',',
        'or_turned', 'OR axis_id IN (SELECT axis_id FROM ring_turned)',
        'yields', $part$
                -- Traffic on a roundabout goes first.
                UNION ALL SELECT 0, axis_id, CASE WHEN along_axis THEN end_abscissa ELSE start_abscissa END, 'yield',
                    CASE WHEN along_axis THEN 'direct' ELSE 'reverse' END
                FROM yielding$part$,
        'edge_circulation', $part$LEFT JOIN (SELECT DISTINCT ON (axis_id, start_abscissa) axis_id AS turned_axis,
                  start_abscissa AS turned_start, along_axis AS turned_along FROM circulated
                  ORDER BY axis_id, start_abscissa, along_axis) t
                  ON u.direction = 'both' AND (turned_axis, turned_start) = (e.axis_id, e.start_abscissa)$part$,
        'lanes_of_edge', streetgen._part('lanes_of_edge')) END $$;
COMMENT ON FUNCTION streetgen._roundabout_places(jsonb) IS
    'The places of the one statement where rings are found, and where traffic that goes round them counts; empty where '
    'the model does not compute roundabouts.';

CREATE OR REPLACE FUNCTION streetgen._axes_of_roundabout_override(model name, changed jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    found bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'roundabout' <> ALL (streetgen._subjects(model)) THEN
        RETURN '{}';
    END IF;
    SELECT coalesce(array_agg(DISTINCT e.axis_id), '{}') FROM unnest(changed) c,
        LATERAL (SELECT ST_GeomFromGeoJSON(c ->> 'geom') AS geom) p
        JOIN roundabout r ON r.geom && p.geom AND ST_Covers(ST_ConvexHull(r.geom), p.geom)
        JOIN roundabout_edge USING (roundabout_id) JOIN edge e ON e.edge_id = roundabout_edge.edge_id INTO found;
    RETURN found;
END $$;
COMMENT ON FUNCTION streetgen._axes_of_roundabout_override(name, jsonb[]) IS
    'The axes of the rings about the places of overrides that changed.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_arguments(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 'circulations => ' || CASE WHEN NOT places -> 'subjects' ? 'roundabout' THEN 'NULL'
        ELSE $part$(
            SELECT array_agg(ROW (axis_id, (start_abscissa + end_abscissa) / 2, along_axis,
                direction = 'both')::streetgen.street_circulation)
            FROM circulated JOIN used USING (axis_id))$part$ END $$;
COMMENT ON FUNCTION streetgen._roundabout_arguments(jsonb) IS
    'Part of the one statement: which way traffic goes round.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_told_others(model name, computed text[]) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    -- Traffic that went round goes as the axes say, and the kinds of junctions are told anew.
    RETURN 'junction' = ANY (computed) OR streetgen._stale_axes(model) > 0;
END $$;
COMMENT ON FUNCTION streetgen._roundabout_told_others(name, text[]) IS
    'Did other subjects of a model read its roundabouts before these were switched off? Then it is computed anew.';
