-- Rules of check_model for lanes.

CREATE OR REPLACE FUNCTION streetgen._check_lane(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    -- Parts of lanes outside their sections, where nothing was contested.
    WITH astray AS MATERIALIZED (
        SELECT l.lane_id, ST_Difference(l.geom, s.surface) AS outside FROM lane l JOIN section s USING (edge_id)
        WHERE s.contested_area = 0 AND s.method <> 'crossed_limits'
            AND NOT streetgen._lies_on(l.geom::bytea, s.surface::bytea)
            AND (streetgen._surely_valid(s.surface::bytea) OR ST_IsValid(s.surface)))
    SELECT 'error', 'edge without a lane', 'edge', e.edge_id, 0, e.geom FROM edge e
        WHERE NOT EXISTS (SELECT FROM lane l WHERE l.edge_id = e.edge_id)
    UNION ALL
    SELECT 'error', 'invalid surface', 'lane', lane_id, ST_Area(surface), surface FROM lane
        WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)
    UNION ALL
    SELECT 'warning', 'lane outside its section, m', 'lane', lane_id, ST_Length(outside), outside FROM astray
        WHERE ST_Length(outside) > 0.1
    UNION ALL
    SELECT 'warning', 'lane override without its lane', 'lane_override', o.lane_override_id, o.abscissa, o.geom
        FROM lane_override o
        WHERE NOT EXISTS (SELECT FROM edge e JOIN lane l USING (edge_id) WHERE e.axis_id = o.axis_id
            AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa AND l.ordinality = o.ordinality)
    UNION ALL
    SELECT 'notice', 'narrow lane, m', 'lane', l.lane_id, l.width, l.geom
        FROM lane l, (SELECT value::float8 AS least FROM setting WHERE name = 'lane_width_minimal') s
        WHERE l.kind IN ('general', 'bus', 'carpool') AND l.width < s.least - 1e-6
    UNION ALL
    SELECT 'notice', 'paint without room before a crossing', 'marking', marking_id, ST_Length(free_geom), free_geom
        FROM marking WHERE free_geom IS NOT NULL AND ST_IsEmpty(surface)
    UNION ALL
    SELECT 'warning', 'lane adjacency override without its lanes', 'lane_adjacency_override',
        o.lane_adjacency_override_id, o.abscissa, o.geom FROM lane_adjacency_override o
        WHERE NOT EXISTS (SELECT FROM edge e JOIN lane f USING (edge_id) JOIN lane t USING (edge_id)
            WHERE e.axis_id = o.axis_id AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
                AND (f.ordinality, t.ordinality) = (o.lane_from, o.lane_to)
                AND abs(f.lane_position - t.lane_position) = 1 AND f.along_axis = t.along_axis)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_lane(name) IS
    'The rows of streetgen.check_model for lanes.';

CREATE OR REPLACE FUNCTION streetgen._lane_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    AS $$ VALUES
    (9, 'lane', $part$
    (SELECT 'lanes, ' || kind, count(*), NULL FROM %1$I.lane GROUP BY kind ORDER BY kind)$part$),
    (10, 'lane', $part$
    SELECT 'lanes, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.lane$part$),
    (11, 'lane', $part$
    SELECT 'lanes that say where they turn', count(*), NULL FROM %1$I.lane WHERE turn IS NOT NULL$part$),
    (12, 'lane', $part$
    (SELECT 'lanes, ' || method, count(*), NULL FROM %1$I.lane WHERE method <> 'hypothesis' GROUP BY method
        ORDER BY method)$part$),
    (13, 'lane', $part$
    (SELECT 'lane separators, ' || kind, count(*), NULL FROM %1$I.lane_separator GROUP BY kind ORDER BY kind)$part$),
    (14, 'lane', $part$
    (SELECT 'markings, ' || kind, count(*), NULL FROM %1$I.marking GROUP BY kind ORDER BY kind)$part$) $$;
COMMENT ON FUNCTION streetgen._lane_summary() IS 'What streetgen.summary counts of lanes.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('edge without a lane', 'an edge needs a lane', '`generate`'),
    ('lane outside its section, m', 'so much of the lane''s line lies off its section', 'redraw the lane'),
    ('lane override without its lane', 'no lane of that number is there', 'delete the override'),
    ('lane adjacency override without its lanes',
        'no two lanes of these numbers and of one direction lie beside each other there',
        'delete the override, or give the axis its lanes again'),
    ('paint without room before a crossing',
        'the lane is too short for its line or arrow before the crossing, and has none', 'move the crossing');
INSERT INTO streetgen.check_rule (rule, meaning, hint, least_is_worst) VALUES
    ('narrow lane, m',
        'a general, bus or carpool lane is narrower than setting `lane_width_minimal`',
        'correct width or lanes', true);
