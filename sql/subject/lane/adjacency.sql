-- Lanes beside lanes: where one can change from one to the other, and to which place.  Wilkie, Sewall and Lin, 4.2.
CREATE OR REPLACE FUNCTION streetgen._make_lane_adjacency_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW lane_extent WITH (security_invoker = true) AS
    SELECT l.lane_id, e.axis_id, e.edge_id, coalesce(l.start_abscissa, e.start_abscissa + f.at) AS start_abscissa,
        coalesce(l.end_abscissa, e.start_abscissa + t.at) AS end_abscissa, (
            SELECT max(abs(w.axis_offset)) + max(w.width) FROM lane w WHERE w.edge_id = e.edge_id) AS widest
    FROM lane l JOIN edge e USING (edge_id)
        JOIN section_limit a ON (a.edge_id, a.which) = (e.edge_id, 'start')
        JOIN section_limit b ON (b.edge_id, b.which) = (e.edge_id, 'end')
        -- A lane is a centimetre long where limits crossed.
        CROSS JOIN LATERAL (SELECT e.end_abscissa - e.start_abscissa AS size) z
        CROSS JOIN LATERAL (SELECT CASE WHEN l.method = 'crossed_limits' THEN greatest(0, least(size - 0.01, size
            * ST_LineLocatePoint(e.geom, ST_StartPoint(l.geom)))) ELSE a.abscissa END AS at) f
        CROSS JOIN LATERAL (
            SELECT CASE WHEN l.method = 'crossed_limits' THEN f.at + 0.01 ELSE b.abscissa END AS at) t;
    EXECUTE streetgen._fill_template(streetgen._part('lane_adjacency'), jsonb_build_object('beside', streetgen._part(
        CASE WHEN 'ramp' = ANY (streetgen._subjects(model)) THEN 'lanes_beside_merging' ELSE 'lanes_beside' END)));
    COMMENT ON VIEW lane_extent IS 'Where each lane begins and ends along its axis';
    COMMENT ON COLUMN lane_extent.lane_id IS 'the lane';
    COMMENT ON COLUMN lane_extent.axis_id IS 'its axis';
    COMMENT ON COLUMN lane_extent.edge_id IS 'its edge';
    COMMENT ON COLUMN lane_extent.start_abscissa IS 'where it begins, metres along the axis';
    COMMENT ON COLUMN lane_extent.end_abscissa IS 'where it ends, metres along the axis';
    COMMENT ON COLUMN lane_extent.widest IS
        'no lane of the edge lies farther from the axis, metres: one number for all of them';
    COMMENT ON VIEW lane_adjacency IS
        'Which lanes lie beside each other, a row for each direction: on its side of lane_a, seen along the axis, '
        'lies lane_b. change is opposite where traffic comes against one; else what was decided by hand, else what '
        'change_forward or change_backward of the axis says, but for merging lanes, else allowed over a dashed line '
        'between lanes of one direction that the same traffic uses, else forbidden. lane_separator holds it';
    COMMENT ON COLUMN lane_adjacency.lane_adjacency_id IS 'key';
    COMMENT ON COLUMN lane_adjacency.lane_a IS 'a lane';
    COMMENT ON COLUMN lane_adjacency.lane_b IS 'the lane beside it';
    COMMENT ON COLUMN lane_adjacency.side IS 'on which side of lane_a, left or right along the axis';
    COMMENT ON COLUMN lane_adjacency.start_abscissa IS 'from where, metres along the axis';
    COMMENT ON COLUMN lane_adjacency.end_abscissa IS 'to where, metres along the axis';
    COMMENT ON COLUMN lane_adjacency.change IS
        'may one change from lane_a to lane_b: allowed, forbidden, or opposite (against the traffic)';
    COMMENT ON COLUMN lane_adjacency.by_hand IS 'was the change decided by hand?';
    COMMENT ON COLUMN lane_adjacency.geom IS 'the line between the two lanes, along the axis';
    CREATE OR REPLACE VIEW lane_interval WITH (security_invoker = true) AS
    SELECT a.lane_a AS lane_id, (a.start_abscissa - i.start_abscissa) / (i.end_abscissa - i.start_abscissa) AS s,
        (a.end_abscissa - i.start_abscissa) / (i.end_abscissa - i.start_abscissa) AS e,
        (a.start_abscissa - o.start_abscissa) / (o.end_abscissa - o.start_abscissa) AS os,
        (a.end_abscissa - o.start_abscissa) / (o.end_abscissa - o.start_abscissa) AS oe, a.lane_b AS l
    FROM lane_adjacency a
        CROSS JOIN LATERAL (SELECT * FROM lane_extent x WHERE x.lane_id = a.lane_a OFFSET 0) i
        CROSS JOIN LATERAL (SELECT * FROM lane_extent x WHERE x.lane_id = a.lane_b OFFSET 0) o
    WHERE i.end_abscissa > i.start_abscissa AND o.end_abscissa > o.start_abscissa AND a.change = 'allowed';
    COMMENT ON VIEW lane_interval IS
        'The adjacency intervals of the paper: from share s to share e of a lane, along the axis, lane l lies beside '
        'it, there from os to oe; where one may change';
    COMMENT ON COLUMN lane_interval.lane_id IS 'the lane';
    COMMENT ON COLUMN lane_interval.s IS 'where the interval starts on it, share of its extent';
    COMMENT ON COLUMN lane_interval.e IS 'where it ends';
    COMMENT ON COLUMN lane_interval.os IS 'where it starts on the other lane, share of its extent';
    COMMENT ON COLUMN lane_interval.oe IS 'where it ends there';
    COMMENT ON COLUMN lane_interval.l IS 'the other lane';
END $$;
COMMENT ON FUNCTION streetgen._make_lane_adjacency_views(name) IS
    'Makes the views lane_extent, lane_adjacency and lane_interval of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._lane_measures(axis bytea, lane bytea, widest float8, first float8, last float8)
    RETURNS TABLE(on_axis float8[], on_lane float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_lane_measures';
COMMENT ON FUNCTION streetgen._lane_measures(bytea, bytea, float8, float8, float8) IS
    'Places along an axis and the same places along a lane of it (EWKB), ascending, m: between two of them shares are '
    'equal. widest: the largest offset of a lane from the axis, m, so that all lanes of an edge have the same places. '
    'first, last: where the lane begins and ends along the axis, m.';

CREATE OR REPLACE FUNCTION streetgen._measure_at(places float8[], measures float8[], place float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN place <= places[1] THEN measures[1] WHEN i IS NULL THEN measures[cardinality(measures)]
        ELSE measures[i] + (measures[i + 1] - measures[i]) * (place - places[i]) / (places[i + 1] - places[i]) END
    FROM (SELECT min(i) AS i FROM generate_subscripts(places, 1) i
        WHERE place <= places[i + 1] AND places[i + 1] > places[i]) s $$;
COMMENT ON FUNCTION streetgen._measure_at(float8[], float8[], float8) IS
    'What belongs to a place between others, by equal shares; before the first and after the last what belongs to '
    'these.';

CREATE OR REPLACE FUNCTION streetgen._lane_beside(model name, lane bigint, place_on_lane float8, side text)
    RETURNS TABLE(lane_id bigint, metres float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    place record;
    here record;
    there record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('lane', lane::text,
        'metres', place_on_lane::text, 'side', side);
    IF side NOT IN ('left', 'right') THEN
        RAISE EXCEPTION 'side is "%", expected left or right', side USING ERRCODE = '22023',
            HINT = 'Sides are seen along the axis.';
    END IF;
    SELECT ST_Force2D(e.geom) AS axis, l.geom AS line, o.lane_id AS other, o.geom AS other_line, x.widest,
        x.start_abscissa - e.start_abscissa AS first, x.end_abscissa - e.start_abscissa AS last,
        y.start_abscissa - e.start_abscissa AS other_first, y.end_abscissa - e.start_abscissa AS other_last
    FROM lane l JOIN edge e USING (edge_id) JOIN lane_extent x ON x.lane_id = l.lane_id LEFT JOIN LATERAL (
        -- The nearest one that is there: merging lanes lie on a part of the edge.
        SELECT o.lane_id, o.geom FROM lane o, (SELECT e.start_abscissa + ST_Length(e.geom) * ST_LineLocatePoint(
            ST_Force2D(e.geom), ST_LineInterpolatePoint(l.geom, least(greatest(place_on_lane / ST_Length(l.geom), 0),
                1))) AS at) p
        WHERE o.edge_id = l.edge_id AND CASE _lane_beside.side WHEN 'left' THEN l.lane_position - o.lane_position
                ELSE o.lane_position - l.lane_position END > 0
            AND coalesce(at >= o.start_abscissa, true) AND coalesce(at <= o.end_abscissa, true)
        ORDER BY abs(o.lane_position - l.lane_position) LIMIT 1) o ON true
        LEFT JOIN lane_extent y ON y.lane_id = o.lane_id
    WHERE l.lane_id = lane INTO place;
    IF place.line IS NULL THEN
        RAISE EXCEPTION 'there is no lane %', lane USING ERRCODE = '22023',
            HINT = format('SELECT lane_id FROM %I.lane lists them.', model);
    ELSIF NOT place_on_lane BETWEEN -1e-6 AND ST_Length(place.line) + 1e-6 THEN
        RAISE EXCEPTION 'lane % has no place at % m', lane, place_on_lane USING ERRCODE = '22023',
            DETAIL = format('It is %s m long.', round(ST_Length(place.line)::numeric, 3)),
            HINT = 'Metres count along the line of the lane.';
    ELSIF place.other IS NULL THEN
        RETURN;
    END IF;
    SELECT * FROM streetgen._lane_measures(place.axis::bytea, place.line::bytea, place.widest, place.first, place.last)
        INTO here;
    SELECT * FROM streetgen._lane_measures(place.axis::bytea, place.other_line::bytea, place.widest, place.other_first,
        place.other_last) INTO there;
    RETURN QUERY SELECT place.other, streetgen._measure_at(there.on_axis, there.on_lane,
        streetgen._measure_at(here.on_lane, here.on_axis, place_on_lane));
END $$;
COMMENT ON FUNCTION streetgen._lane_beside(name, bigint, float8, text) IS
    'What streetgen.lane_beside gives.';

-- PL/pgSQL takes no name twice.
CREATE OR REPLACE FUNCTION streetgen.lane_beside(model name, lane bigint, metres float8, side text)
    RETURNS TABLE(lane_id bigint, metres float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._lane_beside($1, $2, $3, $4) $$;
COMMENT ON FUNCTION streetgen.lane_beside(name, bigint, float8, text) IS
    'The lane beside a lane, and the place there beside a place of it: metres along the line of each lane, side left '
    'or right along the axis. Through the axis: straight pieces have equal lengths on all lanes, at a bend the inner '
    'lane has less; there and back is the same place. No lane on that side: no row. An unknown lane, a place off the '
    'lane, NaN or another side: 22023; NULL: 22004; an unknown model: 3F000. Wilkie, Sewall and Lin, section 4.2.';
