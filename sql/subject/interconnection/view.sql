-- Paths of a junction that traffic cannot take at the same time.
CREATE OR REPLACE FUNCTION streetgen._paths_meet(a text, b text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format($sql$(%1$s.lane_in, %1$s.along_in) <> (%2$s.lane_in, %2$s.along_in)
    -- A lane for both directions is entered and left at one end: the other way there.
    AND ((%1$s.lane_out, %1$s.along_out) IN ((%2$s.lane_out, %2$s.along_out), (%2$s.lane_in, NOT %2$s.along_in))
        OR (%1$s.lane_in, NOT %1$s.along_in) = (%2$s.lane_out, %2$s.along_out)
        OR ST_Intersects(%1$s.geom, %2$s.geom))$sql$, a, b) $$;
COMMENT ON FUNCTION streetgen._paths_meet(text, text) IS
    'Whether two paths with their lanes cross, merge or oppose each other, as SQL.';

CREATE OR REPLACE FUNCTION streetgen._make_conflict_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.conflict WITH (security_invoker = true) AS
WITH path AS (%2$s)
SELECT a.node_id, a.interconnection_id AS interconnection_a, b.interconnection_id AS interconnection_b, kind,
       CASE WHEN kind = 'merging' OR meets_in_out THEN ST_EndPoint(a.geom) WHEN kind = 'opposing'
           THEN ST_StartPoint(a.geom)
            ELSE ST_Intersection(a.geom, b.geom) END AS geom,
       a.junction_id, a.junction_movement_id AS junction_movement_a, b.junction_movement_id AS junction_movement_b
FROM path a JOIN path b ON b.place = a.place AND a.number < b.number
-- A lane for both directions is entered and left at one end: the other way there.
CROSS JOIN LATERAL (SELECT (a.lane_out, a.along_out) = (b.lane_in, NOT b.along_in) AS meets_in_out,
                           (a.lane_in, NOT a.along_in) = (b.lane_out, b.along_out) AS meets_in_in,
                           (a.lane_out, a.along_out) = (b.lane_out, b.along_out) AS merges) m
CROSS JOIN LATERAL (
    SELECT CASE WHEN merges THEN 'merging' WHEN meets_in_out OR meets_in_in THEN 'opposing' ELSE 'crossing'
        END AS kind) k
WHERE %3$s
$sql$, model, format(CASE WHEN 'junction' = ANY (streetgen._subjects(model)) THEN $path$
    SELECT node_id, junction_id, CASE WHEN junction_movement_id IS NULL THEN interconnections[1]
        END AS interconnection_id, junction_movement_id,
        coalesce(junction_movement_id, interconnections[1]) AS number, coalesce(-node_id, junction_id) AS place,
        lane_in, lane_out, along_in, along_out, geom
    FROM %1$I.movement WHERE connecting$path$ ELSE $path$
    SELECT node_id, NULL::bigint AS junction_id, interconnection_id, NULL::bigint AS junction_movement_id,
        interconnection_id AS number, node_id AS place, lane_in, lane_out, along_in, along_out, geom
    FROM %1$I.interconnection WHERE connecting$path$ END, model), streetgen._paths_meet('a', 'b'));
    COMMENT ON VIEW conflict
        IS 'Pairs of connecting paths from two lanes that cross, merge in one lane, or oppose each other in one that '
        'both directions use; geom is where. At a node: two interconnections; across a junction of several nodes, '
        'where the model computes junctions: two rows of junction_movement';
    COMMENT ON COLUMN conflict.node_id IS 'the node';
    COMMENT ON COLUMN conflict.interconnection_a IS 'one of the two, the smaller key';
    COMMENT ON COLUMN conflict.interconnection_b IS 'the other';
    COMMENT ON COLUMN conflict.kind IS
        'crossing, merging in one lane, or opposing: one enters the lane that the other leaves';
    COMMENT ON COLUMN conflict.geom IS 'where they cross, or the end of the lane in which they merge or meet';
    COMMENT ON COLUMN conflict.junction_id IS 'the junction, where the model computes junctions';
    COMMENT ON COLUMN conflict.junction_movement_a IS 'one of the paths, across a junction of several nodes';
    COMMENT ON COLUMN conflict.junction_movement_b IS 'the other one';
END $$;
COMMENT ON FUNCTION streetgen._make_conflict_view(name) IS 'Makes the view conflict of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('conflict'::name, 'interconnection'), ('conflict', 'junction') $$;
COMMENT ON FUNCTION streetgen._interconnection_view() IS
    'Views of interconnections, and the subjects whose tables they read.';

CREATE OR REPLACE FUNCTION streetgen._make_interconnection_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- Beside junctions the view is of their paths, and comes after these.
    IF 'junction' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._make_conflict_view(model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_interconnection_views(name) IS
    'Makes the view conflict of a model without junctions, again and again.';
