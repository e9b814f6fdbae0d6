-- Places where vehicles stand beside lanes of SUMO: bus stops and places to park, in an additional file.

CREATE OR REPLACE FUNCTION streetgen._lanes_with_bays(model name) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' <> ALL (streetgen._subjects(model)) THEN
        RETURN '{}';
    END IF;
    RETURN ARRAY(SELECT DISTINCT l.lane_id FROM parking_bay b
        JOIN object_edge e ON e.street_object_id = b.street_object_id
        JOIN lane l ON l.edge_id = e.edge_id AND l.kind = 'parking' AND ST_DWithin(l.geom, b.surface, l.width / 2));
END $$;
COMMENT ON FUNCTION streetgen._lanes_with_bays(name) IS 'The parking lanes of a model whose bays are objects.';

CREATE OR REPLACE FUNCTION streetgen._stands(model name)
    RETURNS TABLE(kind text, stand_id bigint, edge_id bigint, along_axis boolean, width float8, angle float8,
        lot float8, ground geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'parking_lane', l.lane_id, l.edge_id, l.along_axis, l.width, 0::float8, 6::float8,
                l.geom
            FROM streetgen._lanes_with_bays(model) with_bays, lane l
            WHERE l.kind = 'parking' AND l.lane_id <> ALL (with_bays);
    END IF;
    IF 'object' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'parking_bay', b.street_object_id, e.edge_id, NULL::boolean,
                streetgen._bay_depth(b.length, b.width, b.angle), b.angle,
                streetgen._bay_run(b.length, b.width, b.angle), b.surface::geometry
            FROM parking_bay b JOIN object_edge e ON e.street_object_id = b.street_object_id
            WHERE b.surface IS NOT NULL;
        RETURN QUERY SELECT 'bus_stop', b.street_object_id, b.edge_id, l.along_axis, b.width, 0::float8, NULL::float8,
                b.surface::geometry
            FROM bus_stop_box b JOIN lane l ON l.lane_id = b.lane_id;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._stands(name) IS
    'Where vehicles stand along edges: parking_lane, parking_bay or bus_stop, the id of the lane or the object, and '
    'the direction of their lane (NULL: any); a lane whose bays are objects counts by these. '
    'width is across the street; a lot takes so many metres of it. ground is '
    'a surface, or the line of a lane.';

CREATE OR REPLACE FUNCTION streetgen._sumo_stands(model name, options jsonb)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH stand AS MATERIALIZED (SELECT * FROM streetgen._stands(model)),
    sumo_lane AS MATERIALIZED (
        SELECT e.name, e.edge_id, e.along_axis, e.since, e.until, l.lane_id, i - 1 + e.walk AS index,
            ST_Length(e.geom) * (e.until - e.since) AS length, CASE WHEN e.along_axis THEN l.geom
                ELSE ST_Reverse(l.geom) END AS driven
        FROM streetgen._sumo_edges(model, options, true, false) e
            CROSS JOIN LATERAL streetgen._few(e.lanes) WITH ORDINALITY m(lane_id, i) JOIN lane l USING (lane_id)
        WHERE l.kind IN ('general', 'bus') AND e.edge_id IN (SELECT s.edge_id FROM stand s)),
    -- The lane beside which it lies, and from where to where: a part of a street that has several.
    beside AS MATERIALIZED (
        SELECT s.*, o.*, (part_from - since) / (until - since) * length AS starts,
            (part_to - since) / (until - since) * length AS ends
        FROM stand s CROSS JOIN LATERAL (
            SELECT l.name, l.index, l.since, l.until, l.length, greatest(r.low, l.since) AS part_from,
                least(r.high, l.until) AS part_to
            FROM sumo_lane l, LATERAL (SELECT min(share) AS low, max(share) AS high
                FROM ST_DumpPoints(s.ground) p, ST_LineLocatePoint(l.driven, p.geom) share) r
            WHERE l.edge_id = s.edge_id AND r.low < l.until AND r.high > l.since
            ORDER BY l.along_axis IS DISTINCT FROM coalesce(s.along_axis, l.along_axis),
                round(ST_Distance(l.driven, ST_Centroid(s.ground))::numeric, 1), least(r.high, l.until)
                    - greatest(r.low, l.since) DESC, l.lane_id, l.name LIMIT 1) o),
    -- Bays side by side are one place.
    run AS (
        SELECT *, count(*) FILTER (WHERE apart) OVER (PARTITION BY kind, name, index, angle ORDER BY starts, stand_id)
            AS turn
        FROM (SELECT *, kind <> 'parking_bay' OR starts > 1 + max(ends) OVER (PARTITION BY kind, name, index, angle
                ORDER BY starts, stand_id ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING) IS NOT FALSE AS apart
            FROM beside WHERE ends - starts >= 1) b),
    place AS (
        SELECT kind, min(stand_id) AS id, name, index, angle, max(width) AS width, min(starts) AS starts,
            max(ends) AS ends, max(length) AS length,
            CASE kind WHEN 'parking_lane' THEN floor((max(ends) - min(starts)) / max(lot)) ELSE count(*) END AS lots
        FROM run GROUP BY kind, name, index, angle, turn)
    SELECT CASE kind WHEN 'bus_stop' THEN 1 ELSE 2 END, id, concat('<', CASE kind WHEN 'bus_stop' THEN 'busStop'
            ELSE 'parkingArea' END, ' id="', kind, '.', id, '" lane="', name, '_', index, '" startPos="',
        round(starts::numeric, 2), '" endPos="', round(ends::numeric, 2), '" friendlyPos="true"',
        CASE WHEN kind <> 'bus_stop' THEN concat(' roadsideCapacity="', lots, '" width="', round(width::numeric, 2),
            '" angle="', round(angle), '"') END, '/>')
    FROM place WHERE kind = 'bus_stop' OR lots > 0;
END $$;
COMMENT ON FUNCTION streetgen._sumo_stands(name, jsonb) IS
    'The elements of an additional file of SUMO: bus stops where buses stand at them, and parking areas, of parking '
    'lanes and of bays side by side, along the nearest lane of their street on which one drives.';
