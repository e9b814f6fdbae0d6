-- The rings of a network, what tells them from blocks, and their score.

CREATE OR REPLACE FUNCTION streetgen._network_rings(axis_ids bigint[], lines bytea[], levels integer[],
    one_ways integer[], tagged boolean[], widths float8[], widths_end float8[], roadway_offsets float8[],
    importances integer[], lanes_forward integer[], lanes_backward integer[], tolerance float8, radius_least float8,
    radius_greatest float8, shape_least float8, split boolean, counter_clockwise boolean,
    controls streetgen.street_control[], control_distance float8, queue_length float8)
    RETURNS TABLE(number integer, level integer, geom bytea, centre bytea, radius float8, on_circle float8,
        compactness float8, one_way float8, against float8, single_arm float8, arm_nodes integer, inside integer,
        edge_axes bigint[], edge_starts float8[], edge_ends float8[], edge_along boolean[],
        arm_axes bigint[], arm_starts float8[], arm_ends float8[], arm_along boolean[],
        edge_faces integer[], faces bytea[], waist boolean)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_network_rings';
COMMENT ON FUNCTION streetgen._network_rings(bigint[], bytea[], integer[], integer[], boolean[], float8[], float8[],
    float8[], integer[], integer[], integer[], float8, float8, float8, float8, boolean, boolean,
    streetgen.street_control[], float8, float8) IS
    'The rings of the network of axes (LINESTRINGs, EWKB; one_ways: 1 along the axis, -1 against it, 0 unknown or '
    'both; tagged: a source says that it is part of a roundabout; widths and offsets in metres, importances and lanes '
    'by direction tell which axis lies on another and has no edge) that may be roundabouts, in the order of their '
    'smallest places: closed ways with no edge between them and the ground within, first those of tagged axes alone, '
    'whatever lies within. What crosses without a node parts nothing; level: where most of the ring lies. Two '
    'neighbours that are nearly circles are one ring, a double roundabout: faces has the line of each, edge_faces '
    'which of them an edge bounds, geom the line about both. Of the circle fitted to geom: centre and radius in '
    'metres, radius_least and more where it is not tagged; the smallest circle about it has at most radius_greatest. '
    'compactness: area by that of the circle of the same length, shape_least and more where it is not tagged. '
    'on_circle: share of the ring within a tenth of the radius of its circle. Both are those of the less round half '
    'of a double roundabout or a peanut (waist). one_way, against: share whose one-way traffic goes round, or the '
    'other way; single_arm: share of the nodes with arms (arm_nodes) that have one arm; inside: nodes of its level '
    'within, and loops that hang on it there. The edges of the ring, face by face, and its arms by axis and abscissas '
    'in metres, along: whether traffic that goes round, or comes to the ring, drives along the axis. Edges are those '
    'of the model: signals among controls cut them in mid-block, by control_distance and queue_length in metres. '
    'A value out of range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._edges_on_rings(model name, edges bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    computed constant boolean := 'roundabout' = ANY (streetgen._subjects(model));
BEGIN
    PERFORM streetgen._use_model(model);
    IF computed AND edges IS NULL THEN
        RETURN ARRAY(SELECT r.edge_id FROM roundabout_edge r JOIN roundabout USING (roundabout_id) WHERE accepted);
    ELSIF computed THEN
        RETURN ARRAY(SELECT r.edge_id FROM roundabout_edge r JOIN roundabout USING (roundabout_id)
            WHERE accepted AND r.edge_id = ANY (edges));
    ELSIF edges IS NULL THEN
        RETURN ARRAY(SELECT edge_id FROM edge JOIN axis USING (axis_id) WHERE streetgen._names_ring(roundabout_tag));
    ELSE
        RETURN ARRAY(SELECT edge_id FROM edge JOIN axis USING (axis_id)
            WHERE streetgen._names_ring(roundabout_tag) AND edge_id = ANY (edges));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._edges_on_rings(name, bigint[]) IS
    'Of some edges (NULL: of all) those of roundabouts: of accepted ones, or, where the model looks for none, those of '
    'which the source says so.';
