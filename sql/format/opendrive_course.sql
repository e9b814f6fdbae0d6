-- OpenDRIVE: the alignments that reference lines follow.

CREATE OR REPLACE FUNCTION streetgen._arc_road_elements(road geometry) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 1000 SET search_path = pg_catalog, public
    AS $$
    SELECT coalesce(array_agg(v ORDER BY start_abscissa, k), '{}')
    FROM streetgen._arc_road_stretches(road) s,
        streetgen.arc_road_point(road, start_abscissa) p,
        streetgen.arc_road_point(road, (start_abscissa + end_abscissa) / 2) m,
        LATERAL (SELECT end_abscissa - start_abscissa AS length,
            CASE WHEN radius IS NULL THEN 0 ELSE m.curvature END AS bend) b,
        unnest(ARRAY[start_abscissa, ST_X(p.geom), ST_Y(p.geom), radians(90 - m.heading) - bend * length / 2, length,
            bend, bend]) WITH ORDINALITY n(v, k) $$;
COMMENT ON FUNCTION streetgen._arc_road_elements(geometry) IS
    'The pieces of an arc road as elements of an alignment, seven numbers each.';

CREATE OR REPLACE FUNCTION streetgen._designed_courses(model name)
    RETURNS TABLE(edge_id bigint, alignment float8[], reach float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._has_design(model) THEN
        -- A carriageway of two lies beside the alignment.
        RETURN QUERY SELECT e.edge_id, d.alignment, d.reach
            FROM (SELECT design_link_id::text AS link, streetgen._link_elements(model, design_link_id) AS alignment,
                    0.1 + CASE carriageways WHEN 2 THEN (roadway_width + median_width) / 2 ELSE 0 END AS reach
                FROM design_link l JOIN design_class c USING (network) WHERE NOT l.rejected) d
                JOIN axis a ON a.source = 'design' AND split_part(a.source_ref, '/', 1) = d.link
                JOIN edge e USING (axis_id);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._designed_courses(name) IS
    'The alignments of edges that are designed, and within how many metres an edge follows its own; none of a model '
    'without a design.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_courses(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, alignment float8[], reach float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH designed AS MATERIALIZED (SELECT * FROM streetgen._designed_courses(model))
    SELECT DISTINCT ON (c.edge_id) c.* FROM (
        TABLE designed
        UNION ALL SELECT e.edge_id, streetgen._arc_road_elements(e.curve), 0.1 FROM edge e
        WHERE e.curve IS NOT NULL AND e.edge_id IN (SELECT streetgen._written_edges(model, options))
            AND e.edge_id NOT IN (SELECT d.edge_id FROM designed d)) c
    ORDER BY c.edge_id;
END $$;
COMMENT ON FUNCTION streetgen._opendrive_courses(name, jsonb) IS
    'The alignment that an edge follows in a file of OpenDRIVE, and within how many metres: that of its link where it '
    'is designed, else its arcs where it is smoothed.';
