-- Lanes as traffic sees them: lines in its direction, and the lanes of one direction side by side.

CREATE OR REPLACE FUNCTION streetgen._make_lane_driving_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW lane_driving WITH (security_invoker = true) AS
    SELECT 2 * lane_id + v.along::integer AS lane_driving_id, lane_id, edge_id, v.along AS along_axis, lane_position,
        kind,
        width, CASE WHEN v.along THEN geom ELSE ST_Reverse(geom) END AS geom
    FROM lane l JOIN (VALUES (true), (false)) v(along) ON both_ways OR along_axis = v.along;
    COMMENT ON VIEW lane_driving
        IS 'Lanes in the direction of their traffic; a lane for both directions has a row for each';
    COMMENT ON COLUMN lane_driving.lane_driving_id IS
        'unique and kept as long as the lane: twice lane_id, and one along the axis';
    COMMENT ON COLUMN lane_driving.lane_id IS 'the lane';
    COMMENT ON COLUMN lane_driving.edge_id IS 'its edge';
    COMMENT ON COLUMN lane_driving.along_axis IS 'does this traffic run in the direction of the axis';
    COMMENT ON COLUMN lane_driving.lane_position IS 'number from 1 at the left kerb, in the direction of the axis';
    COMMENT ON COLUMN lane_driving.kind IS 'general, bus, carpool, cycle, parking or closed';
    COMMENT ON COLUMN lane_driving.width IS 'width at the start limit of the edge, metres';
    COMMENT ON COLUMN lane_driving.geom IS 'centre line between the limits, in the direction of this traffic';
END $$;
COMMENT ON FUNCTION streetgen._make_lane_driving_view(name) IS
    'Makes the view lane_driving of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._make_lane_group_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW lane_group WITH (security_invoker = true) AS
    WITH side AS (SELECT value IS DISTINCT FROM 'left' AS right_hand FROM setting WHERE name = 'driving_side'),
    -- Positions without a gap between them count up as their numbers do.
    beside AS (
        SELECT d.*, lane_position - row_number() OVER (PARTITION BY edge_id, along_axis ORDER BY lane_position) AS run,
            CASE WHEN along_axis = right_hand THEN -lane_position ELSE lane_position END AS from_kerb
        FROM lane_driving d, side
        -- A merging lane that does not go all along is in no group.
        WHERE NOT EXISTS (SELECT FROM lane m WHERE m.lane_id = d.lane_id
            AND (m.start_abscissa IS NOT NULL OR m.end_abscissa IS NOT NULL)))
    SELECT (array_agg(lane_driving_id ORDER BY from_kerb))[1] AS lane_group_id, edge_id, along_axis,
        row_number() OVER (PARTITION BY edge_id, along_axis ORDER BY min(from_kerb))::integer AS number,
        CASE WHEN along_axis THEN e.from_node ELSE e.to_node END AS from_node,
        CASE WHEN along_axis THEN e.to_node ELSE e.from_node END AS to_node,
        array_agg(lane_id ORDER BY from_kerb) AS lanes, count(*)::integer AS lane_count, sum(b.width) AS width,
        CASE count(*) WHEN 1 THEN (array_agg(b.geom))[1]
            ELSE streetgen._mean_line(array_agg(b.geom::bytea ORDER BY from_kerb))::geometry END AS geom
    FROM beside b JOIN edge e USING (edge_id)
    GROUP BY edge_id, along_axis, run, e.from_node, e.to_node;
    COMMENT ON VIEW lane_group
        IS 'Lanes of one direction of an edge that lie side by side, numbered from the kerb on the side that one '
        'drives on; a lane for both directions is in two groups. What simulators call an edge or a troncon';
    COMMENT ON COLUMN lane_group.lane_group_id IS 'lane_driving_id of its lane at the kerb';
    COMMENT ON COLUMN lane_group.edge_id IS 'the edge';
    COMMENT ON COLUMN lane_group.along_axis IS 'does its traffic run in the direction of the axis';
    COMMENT ON COLUMN lane_group.number IS
        'number from 1 at the kerb among the groups of this direction of the edge; more than one only where lanes of '
        'the other direction part them';
    COMMENT ON COLUMN lane_group.from_node IS 'node that its traffic comes from';
    COMMENT ON COLUMN lane_group.to_node IS 'node that its traffic comes to';
    COMMENT ON COLUMN lane_group.lanes IS 'its lanes from the kerb inwards, lane_id';
    COMMENT ON COLUMN lane_group.lane_count IS 'how many they are, parking lanes too';
    COMMENT ON COLUMN lane_group.width IS 'sum of their widths, metres';
    COMMENT ON COLUMN lane_group.geom IS 'mean of their centre lines, in the direction of their traffic';
END $$;
COMMENT ON FUNCTION streetgen._make_lane_group_view(name) IS
    'Makes the view lane_group of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._lane_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES ('lane_group'::name, 'lane'), ('lane_driving', 'lane'), ('lane_interval', 'lane'),
        ('lane_adjacency', 'lane'), ('lane_extent', 'lane') $$;
COMMENT ON FUNCTION streetgen._lane_view() IS
    'Views of lanes, and the subjects whose tables they read.';

CREATE OR REPLACE FUNCTION streetgen._make_lane_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._make_lane_driving_view(model), streetgen._make_lane_group_view(model),
        streetgen._make_lane_adjacency_views(model);
END $$;
COMMENT ON FUNCTION streetgen._make_lane_views(name) IS 'Makes the views of lanes of a model, again and again.';
