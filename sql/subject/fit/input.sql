-- Axes and observations as the fit takes them.

CREATE OR REPLACE FUNCTION streetgen._fit_rules(model name, axes_move boolean) RETURNS float8[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    most_rounds constant float8 := 500;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY[axes_move::integer::float8] || ARRAY(SELECT s.value::float8 FROM setting s
        JOIN unnest('{fit_scale,fit_weight_observation,fit_weight_observed_width,fit_weight_object,fit_weight_width,'
            'fit_weight_origin,fit_weight_spacing,fit_weight_angle,fit_reach,fit_width_change,fit_move,'
            'fit_width_least,fit_width_greatest,fit_piece,fit_object_margin}'::text[]) WITH ORDINALITY w(name, n)
            USING (name) ORDER BY n) || most_rounds;
END $$;
COMMENT ON FUNCTION streetgen._fit_rules(name, boolean) IS
    'The numbers that the core takes as the rules of a fit: whether axes move, the settings in their order, and the '
    'most rounds.';

CREATE OR REPLACE FUNCTION streetgen._fit_far(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    far float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT streetgen._setting_number(model, 'fit_reach') + 2 * streetgen._setting_number(model, 'fit_move')
            + greatest(streetgen._setting_number(model, 'fit_width_greatest') / 2,
                -- Index edge_reach holds this number.
                max(greatest(width, width_end) + 2 * abs(roadway_offset)) / 2)
        FROM edge INTO far;
    RETURN far;
END $$;
COMMENT ON FUNCTION streetgen._fit_far(name) IS
    'Metres from an axis beyond which it takes no observation, neither as it is nor where a fit puts it.';

CREATE OR REPLACE FUNCTION streetgen._fit_axes(model name, axes bigint[])
    RETURNS TABLE(axis_ids bigint[], lines bytea[], widths float8[], lanes integer[], moves boolean[],
        stretch_axes integer[], stretches float8[], nodes bigint[], edges bigint[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    -- Others take observations that lie between.
    beside constant float8 := 2 * streetgen._fit_far(model);
    all_axes constant bigint[] := axes;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH taken AS MATERIALIZED (
        SELECT a.axis_id, all_axes IS NULL OR a.axis_id = ANY (all_axes) AS moves FROM axis a
        WHERE a.level >= 0 AND (all_axes IS NULL OR EXISTS (SELECT FROM axis o
            WHERE o.axis_id = ANY (all_axes) AND ST_DWithin(o.geom, a.geom, beside)))),
    used AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY t.axis_id)::integer AS n, t.axis_id, t.moves, a.geom::bytea AS line,
            greatest(1, u.lane_count) AS lanes,
            ARRAY[u.width, u.width_end, u.roadway_offset, coalesce(a.sidewalk_left, -1),
                coalesce(a.sidewalk_right, -1)] AS numbers
        FROM taken t JOIN axis a USING (axis_id) JOIN axis_used u USING (axis_id)),
    met AS MATERIALIZED (SELECT v.node_id FROM used u JOIN edge e USING (axis_id),
            LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id) GROUP BY 1),
    below AS MATERIALIZED (
        SELECT m.node_id FROM met m JOIN edge e ON e.from_node = m.node_id JOIN axis a ON a.axis_id = e.axis_id
            WHERE a.level < 0
        UNION SELECT m.node_id FROM met m JOIN edge e ON e.to_node = m.node_id JOIN axis a ON a.axis_id = e.axis_id
            WHERE a.level < 0),
    stretch AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY u.n, e.start_abscissa)::integer AS k, u.n, e.edge_id,
            ARRAY[e.start_abscissa, e.end_abscissa, e.start_abscissa + f.abscissa, e.start_abscissa + t.abscissa]
                AS numbers, ARRAY[CASE WHEN b.node_id IS NULL THEN e.from_node ELSE 0 END,
                CASE WHEN c.node_id IS NULL THEN e.to_node ELSE 0 END] AS ends
        FROM used u JOIN edge e USING (axis_id)
            JOIN section_limit f ON f.edge_id = e.edge_id AND f.which = 'start'
            JOIN section_limit t ON t.edge_id = e.edge_id AND t.which = 'end'
            LEFT JOIN below b ON b.node_id = e.from_node LEFT JOIN below c ON c.node_id = e.to_node),
    axes_given AS (
        SELECT coalesce(array_agg(axis_id ORDER BY n), '{}') AS axis_ids,
            coalesce(array_agg(line ORDER BY n), '{}') AS lines, coalesce(array_agg(lanes ORDER BY n), '{}') AS lanes,
            coalesce(array_agg(moves ORDER BY n), '{}') AS moves FROM used)
    SELECT g.axis_ids, g.lines, ARRAY(SELECT v FROM used, unnest(numbers) WITH ORDINALITY w(v, i) ORDER BY n, i),
        g.lanes, g.moves, ARRAY(SELECT n FROM stretch ORDER BY k),
        ARRAY(SELECT v FROM stretch, unnest(numbers) WITH ORDINALITY w(v, i) ORDER BY k, i),
        ARRAY(SELECT v FROM stretch, unnest(ends) WITH ORDINALITY w(v, i) ORDER BY k, i),
        ARRAY(SELECT edge_id FROM stretch ORDER BY k)
    FROM axes_given g;
END $$;
COMMENT ON FUNCTION streetgen._fit_axes(name, bigint[]) IS
    'The axes of a model as streetgen._fit_streets takes them, with their ids and those of their edges. axes: those '
    'that may change, NULL: all; others near them take observations too. Axes below the ground take none, and their '
    'nodes are 0, which stay.';

CREATE OR REPLACE FUNCTION streetgen._sampled(geom geometry, spacing float8) RETURNS SETOF geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
    SELECT (ST_Dump(CASE WHEN ST_Dimension(part) = 0 THEN part WHEN pieces < 2
            THEN ST_LineInterpolatePoint(part, 0.5) ELSE ST_LineInterpolatePoints(part, 1 / pieces, true) END)).geom
    FROM (SELECT ST_Force2D(ST_CurveToLine(geom)) AS flat) f,
        LATERAL ST_Dump(CASE ST_Dimension(flat) WHEN 2 THEN ST_Boundary(flat) ELSE flat END) d(path, part),
        -- A line of a slip of the pen may go round the earth.
        LATERAL (SELECT least(1e6, round(ST_Length(part) / spacing)) AS pieces) p $$;
COMMENT ON FUNCTION streetgen._sampled(geometry, float8) IS
    'Points, or points along lines and the borders of areas, so many metres apart (POINT each), at most a million of '
    'each.';

CREATE OR REPLACE FUNCTION streetgen._observed_objects(model name)
    RETURNS TABLE(observation_id bigint, kind integer, relation integer, place geometry, confidence float8,
        weight float8, width float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF (SELECT value = 'true' FROM setting WHERE name = 'fit_objects')
        AND 'object' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 0::bigint, 3, 2, ST_Force2D(o.geom), 1::float8, 1::float8, 0::float8
            FROM street_object o WHERE ST_Dimension(o.geom) = 0 AND o.placed_by <> 'rule'
                AND o.type <> ALL (_types_on_roadway());
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._observed_objects(name) IS
    'Objects that stand out of the roadway, imported or by hand, as observations; none unless setting fit_objects is '
    'true.';

CREATE OR REPLACE FUNCTION streetgen._fit_observations(model name, axes bigint[], kerbs_alone boolean)
    RETURNS TABLE(observation_ids bigint[], kinds integer[], relations integer[], x float8[], y float8[],
        confidence float8[], weight float8[], width float8[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    beside constant float8 := streetgen._fit_far(model);
    spacing constant float8 := streetgen._setting_number(model, 'fit_spacing');
    only_kerbs constant boolean := kerbs_alone;
    near_axes constant bigint[] := axes;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH near AS MATERIALIZED (
        SELECT observation_id FROM observation WHERE near_axes IS NULL AND (kind = 'kerb' OR NOT only_kerbs)
        UNION SELECT o.observation_id FROM axis a JOIN observation o ON ST_DWithin(a.geom, o.geom, beside)
            WHERE a.axis_id = ANY (near_axes) AND (o.kind = 'kerb' OR NOT only_kerbs)),
    point AS MATERIALIZED (
        SELECT o.observation_id, array_position('{kerb,sidewalk_back,marking,object,width}', o.kind) - 1 AS kind,
            CASE o.relation WHEN 'in' THEN 1 WHEN 'out' THEN 2 ELSE 0 END AS relation, p.place, o.confidence, o.weight,
            p.width
        FROM near JOIN observation o USING (observation_id), LATERAL (
            -- A point is itself: to sample it takes longer than all the rest.
            SELECT o.geom AS place, 0 AS width WHERE o.kind <> 'width' AND GeometryType(o.geom) = 'POINT'
            UNION ALL SELECT place, 0 FROM streetgen._sampled(o.geom, spacing) place
                WHERE o.kind <> 'width' AND GeometryType(o.geom) <> 'POINT'
            UNION ALL SELECT ST_LineInterpolatePoint(across, 0.5), ST_Length(across)
                FROM ST_Dump(ST_Force2D(o.geom)) d(path, across) WHERE o.kind = 'width') p
        UNION ALL SELECT b.* FROM streetgen._observed_objects(model) b WHERE NOT only_kerbs)
    SELECT coalesce(array_agg(observation_id), '{}'), coalesce(array_agg(kind), '{}'),
        coalesce(array_agg(relation), '{}'), coalesce(array_agg(ST_X(place)), '{}'),
        coalesce(array_agg(ST_Y(place)), '{}'), coalesce(array_agg(confidence), '{}'),
        coalesce(array_agg(weight), '{}'), coalesce(array_agg(width), '{}') FROM point;
END $$;
COMMENT ON FUNCTION streetgen._fit_observations(name, bigint[], boolean) IS
    'The points of observations of a model as streetgen._fit_streets takes them, each with the id of its row (0: '
    'an object, since an array with NULL is read from its start for each of its values). axes: points near these, '
    'NULL: all; kerbs_alone: of kerbs alone.';
