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

CREATE OR REPLACE FUNCTION streetgen._opendrive_courses(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN streetgen._has_design(model) THEN $part$,
-- A carriageway of two lies beside the alignment.
designed AS MATERIALIZED (
    SELECT edge_id, alignment, reach
    FROM (SELECT design_link_id::text AS link, streetgen._link_elements(%1$L, design_link_id) AS alignment,
            0.1 + CASE carriageways WHEN 2 THEN (roadway_width + median_width) / 2 ELSE 0 END AS reach
        FROM %1$I.design_link l JOIN %1$I.design_class c USING (network) WHERE NOT l.rejected) d
        JOIN %1$I.axis a ON a.source = 'design' AND split_part(a.source_ref, '/', 1) = link
        JOIN written_edge e USING (axis_id))$part$
    ELSE $part$,
designed AS (SELECT NULL::bigint AS edge_id, NULL::float8[] AS alignment, NULL::float8 AS reach WHERE false)$part$ END
    || $part$,
-- An edge has one at most, which the planner shall know.
course AS NOT MATERIALIZED (
    SELECT DISTINCT ON (edge_id) * FROM (
        SELECT * FROM designed
        UNION ALL SELECT edge_id, streetgen._arc_road_elements(curve), 0.1 FROM written_edge
        WHERE curve IS NOT NULL AND edge_id NOT IN (SELECT edge_id FROM designed)) c
    ORDER BY edge_id)$part$ $$;
COMMENT ON FUNCTION streetgen._opendrive_courses(name) IS
    'Query course of a file of OpenDRIVE over a model: the alignment that an edge follows, and within how many metres: '
    'that of its link where it is designed, else its arcs where it is smoothed.';
