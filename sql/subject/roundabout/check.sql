-- Rules of check_model for roundabouts.

CREATE OR REPLACE FUNCTION streetgen._check_roundabout(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'warning', 'roundabout override without its ring', 'roundabout_override', o.roundabout_override_id, 0, o.geom
        FROM roundabout_override o WHERE NOT EXISTS (SELECT FROM roundabout r
            WHERE r.geom && o.geom AND ST_Covers(ST_ConvexHull(r.geom), o.geom))
    UNION ALL
    SELECT 'error', 'ring of a roundabout is not closed', 'roundabout', r.roundabout_id, count(n.edge_id), r.geom
        FROM roundabout r LEFT JOIN roundabout_edge n USING (roundabout_id)
        GROUP BY r.roundabout_id
        HAVING NOT ST_IsClosed(r.geom) OR count(n.edge_id) <> coalesce(max(n.ordinality), -1)
    UNION ALL
    SELECT 'warning', 'traffic of a source against a roundabout', 'edge', e.edge_id, e.lane_count, e.geom
        FROM roundabout r JOIN roundabout_edge n USING (roundabout_id)
            JOIN edge e ON e.edge_id = n.edge_id
        WHERE r.accepted AND CASE WHEN n.along_axis THEN lanes_backward ELSE lanes_forward END > 0
            -- Between two faces traffic goes as the axis says.
            AND NOT EXISTS (SELECT FROM roundabout_edge o JOIN roundabout p USING (roundabout_id)
                WHERE o.edge_id = n.edge_id AND o.along_axis <> n.along_axis AND p.accepted)
    UNION ALL
    SELECT 'warning', 'arm of a roundabout that nobody may enter or leave', 'edge', e.edge_id, e.lane_count, e.geom
        FROM roundabout r JOIN roundabout_arm n USING (roundabout_id)
            JOIN edge e ON e.edge_id = n.edge_id
        WHERE r.accepted AND lanes_forward + lanes_backward + lanes_both = 0
    UNION ALL
    SELECT 'warning', 'roundabout of a source without a ring', 'axis', a.axis_id, round(ST_Length2D(a.geom)), a.geom
        FROM axis a WHERE streetgen._names_ring(a.roundabout_tag)
            AND EXISTS (SELECT FROM setting WHERE name = 'roundabout_tags' AND value = 'true')
            AND EXISTS (SELECT FROM edge e WHERE e.axis_id = a.axis_id)
            AND NOT EXISTS (SELECT FROM edge e JOIN roundabout_edge n USING (edge_id) WHERE e.axis_id = a.axis_id)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_roundabout(name) IS
    'The rows of streetgen.check_model for roundabouts.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (30, 'roundabout', $part$
    (SELECT 'roundabouts, ' || CASE WHEN accepted THEN kind ELSE 'not accepted' END, count(*), NULL FROM %1$I.roundabout
        GROUP BY 1 ORDER BY 1)$part$) $$;
COMMENT ON FUNCTION streetgen._roundabout_summary() IS 'What streetgen.summary counts of roundabouts.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('ring of a roundabout is not closed', 'its edges do not lead all the way round', '`generate`'),
    ('traffic of a source against a roundabout',
        'a source states a direction against the sense of the ring, and it holds',
        'mend the direction, or say in `roundabout_editing` that it is none'),
    ('arm of a roundabout that nobody may enter or leave', 'the edge has no lane for cars', 'mend its lanes'),
    ('roundabout of a source without a ring',
        'an axis is part of a roundabout by its tag, but its ring is open, or wider than setting '
        '`roundabout_radius_greatest`', 'close the ring, raise the setting, or take `roundabout_tag` away'),
    ('roundabout override without its ring', 'no ring of the bounds of the settings lies about it',
        'move or delete the override');
