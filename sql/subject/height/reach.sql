-- The chains of heights that a run locks.

CREATE OR REPLACE FUNCTION streetgen._height_chain() RETURNS TABLE(relation name, touched text, at_end boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    -- All that is off the ground is one chain: few edits touch it, and what is lifted has no end that is known before.
    ('profile'::name, $q$
        SELECT t.axis_id, 0::bigint AS chain FROM touched t JOIN {model}.profile p USING (edge_id)
            WHERE p.method <> 'ground' OR p.tied_from OR p.tied_to
        UNION SELECT t.axis_id, 0 FROM touched t JOIN {model}.overpass o ON o.edge_above = t.edge_id
        UNION SELECT t.axis_id, 0 FROM touched t JOIN {model}.overpass o ON o.edge_below = t.edge_id
        -- The ground at a node without a height is that of an axis near (streetgen._node_ground).
        UNION SELECT t.axis_id, 0 FROM touched t JOIN {model}.edge e USING (edge_id)
            JOIN {model}.node n ON ST_DWithin(n.geom, e.geom, 500) WHERE ST_Z(n.geom) NOT BETWEEN -500 AND 10000
        UNION SELECT a.axis_id, 0 FROM {model}.axis a JOIN {model}.node n ON ST_DWithin(n.geom, a.geom, 500)
            WHERE a.axis_id = ANY (axes) AND ST_Z(n.geom) NOT BETWEEN -500 AND 10000
        UNION SELECT axis_id, 0 FROM {model}.height_override WHERE axis_id = ANY (axes)
        UNION SELECT a.axis_id, 0 FROM {model}.axis a JOIN {model}.axis b ON ST_Crosses(a.geom, b.geom)
            WHERE a.axis_id = ANY (axes) AND (a.level <> b.level
                -- Axes of one level cross where they do not both have a vertex, which would be a node.
                OR EXISTS (SELECT FROM {model}.setting s, ST_Dump(ST_Intersection(a.geom, b.geom)) p
                    WHERE s.name = 'tolerance' AND NOT (ST_DWithin(p.geom, ST_Points(a.geom), s.value::float8)
                        AND ST_DWithin(p.geom, ST_Points(b.geom), s.value::float8))))$q$, true) $f$;
COMMENT ON FUNCTION streetgen._height_chain() IS 'The chains of heights, as streetgen._chain has them.';
