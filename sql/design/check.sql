-- Rules of check_model and lines of summary for a design.

CREATE OR REPLACE FUNCTION streetgen._check_design(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH road AS (SELECT design_link_id, max(abscissa + length) AS length FROM alignment_element WHERE NOT rejected
        GROUP BY design_link_id)
    SELECT 'error', 'link of the design without a way', 'design_link', l.design_link_id, 0, ST_MakeLine(a.geom, b.geom)
        FROM design_link l JOIN design_node a ON a.design_node_id = node_a
        JOIN design_node b ON b.design_node_id = node_b WHERE NOT l.rejected AND method LIKE 'no_path%'
    UNION ALL
    SELECT 'warning', 'link that breaks rules of its standard', 'design_link', design_link_id, 0, geom
        FROM design_link WHERE NOT rejected AND method LIKE 'breaks%'
    UNION ALL
    SELECT 'error', 'gap between elements of a link, m', 'alignment_element', e.alignment_element_id, gap, e.start
        FROM (SELECT *, lead(start) OVER along AS next FROM alignment_element WHERE NOT rejected
            WINDOW along AS (PARTITION BY design_link_id ORDER BY ordinality)) e,
        LATERAL streetgen._alignment_point(ARRAY[0, ST_X(start), ST_Y(start), heading, length, curvature_start,
            curvature_end], NULL, length) p, LATERAL (SELECT ST_Distance(next, ST_SetSRID(ST_Point(p.x, p.y),
            ST_SRID(next))) AS gap) g WHERE gap > 1e-6
    UNION ALL
    SELECT 'warning', 'by hand, waits for its link, which is gone: nearest link, m', held.relation, held.id,
        coalesce((SELECT min(ST_Distance(n.geom, held.geom)) FROM design_link n WHERE NOT n.rejected), 0), held.geom
        FROM streetgen._rows_by_hand(model) held JOIN design_link l USING (design_link_id) WHERE l.rejected
    UNION ALL
    SELECT 'warning', 'by hand, waits: its link ends before it, m', 'structure', s.structure_id,
        s.start_abscissa - r.length, l.geom FROM structure s JOIN road r USING (design_link_id)
        JOIN design_link l USING (design_link_id)
        WHERE s.by_hand AND NOT s.rejected AND NOT l.rejected AND s.start_abscissa > r.length + 0.001
    UNION ALL
    SELECT 'warning', 'by hand, waits: its link ends before it, m', 'grade_point', g.grade_point_id,
        g.abscissa - r.length, l.geom FROM grade_point g JOIN road r USING (design_link_id)
        JOIN design_link l USING (design_link_id)
        WHERE g.by_hand AND NOT g.rejected AND NOT l.rejected AND g.abscissa > r.length + 0.001
    UNION ALL
    SELECT 'warning', 'by hand, radius cut to the room that there is, m', 'grade_point', g.grade_point_id, p.radius,
        g.geom FROM design_link l, LATERAL streetgen._link_grade_points(model, l.design_link_id) p
        JOIN grade_point g USING (grade_point_id)
        WHERE NOT l.rejected AND g.by_hand AND p.radius < g.radius - 0.001
    UNION ALL
    SELECT 'warning', 'by hand, waits: its links do not cross, m apart', 'design_crossing', c.design_crossing_id,
        coalesce(ST_Distance(l.geom, o.geom), 0), c.geom FROM design_crossing c
        JOIN design_link l USING (design_link_id) JOIN design_link o ON o.design_link_id = c.other_link_id
        WHERE c.by_hand AND NOT c.rejected AND c.abscissa < 0 AND NOT l.rejected
    UNION ALL
    SELECT 'warning', 'stale: the input of the design changed since', 'design_link', l.design_link_id, count(*), l.geom
        FROM design_link l CROSS JOIN streetgen._design_stage() s WHERE NOT l.rejected AND s.each_link
            AND (s.stage = 'paths' OR coalesce(l.method, '') NOT LIKE 'no_path%')
            AND streetgen._stale_input(model, s.stage, l.design_link_id) IS NOT NULL GROUP BY l.design_link_id
    UNION ALL
    SELECT 'warning', 'stale: nodes or links by hand of the design changed since', 'design_node', NULL, 0, NULL
        WHERE EXISTS (SELECT FROM design_node) AND streetgen._stale_input(model, 'links', 0) IS NOT NULL
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_design(name) IS 'The rows of streetgen.check_model for the design of a model.';

CREATE OR REPLACE FUNCTION streetgen._design_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    (1000, 'design', $part$
    (SELECT 'nodes of the design, ' || kind, count(*), NULL FROM %1$I.design_node WHERE NOT rejected
        GROUP BY kind ORDER BY kind)$part$),
    (1001, 'design', $part$
    (SELECT 'links of the design, ' || network, count(*), NULL FROM %1$I.design_link WHERE NOT rejected
        GROUP BY network ORDER BY network)$part$),
    (1002, 'design', $part$
    (SELECT 'links of the design, ' || network || ', length', round((sum(ST_Length(geom)) / 1000)::numeric, 3), 'km'
        FROM %1$I.design_link WHERE NOT rejected AND geom IS NOT NULL GROUP BY network ORDER BY network)$part$),
    (1003, 'design', $part$
    (SELECT 'structures of the design, ' || kind, count(*), NULL FROM %1$I.structure WHERE NOT rejected
        GROUP BY kind ORDER BY kind)$part$) $$;
COMMENT ON FUNCTION streetgen._design_summary() IS 'What streetgen.summary counts of designs.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('link of the design without a way',
        'terrain, a zone, the grade or the turns bar every road between the two nodes; `design_link.method` says '
            'which',
        'move a node, change the zone or the standard, or draw vertices'),
    ('link that breaks rules of its standard', '`design_link.method` names radius, grade, crest or sag',
        'move vertices or grade points, or take a lower speed'),
    ('gap between elements of a link, m', 'elements that were changed by hand do not meet',
        'take the change back (`by_hand` false), or change the vertex instead'),
    ('by hand, waits for its link, which is gone: nearest link, m',
        'a town moved or went, so no link has these ends now; the row fits again when the link comes back',
        'draw it on the link that is there, keep the link (`by_hand` true, `rejected` false in '
            '`design_link_editing`), or set `by_hand` false to drop the row'),
    ('by hand, radius cut to the room that there is, m',
        'the road beside a grade point moved, and its parabola would overlap the next one',
        'make the radius smaller, move the points apart, or empty the radius'),
    ('by hand, waits: its link ends before it, m',
        'the link got shorter than the abscissa of the structure or grade point',
        'set its abscissas anew, or `by_hand` false'),
    ('by hand, waits: its links do not cross, m apart', 'a link moved away from the crossing that was decided',
        'nothing, or set `by_hand` false in `design_crossing_editing`'),
    ('stale: the input of the design changed since', 'so many stages of the link do not know the change yet',
        '`streetgen.design`'),
    ('stale: nodes or links by hand of the design changed since', 'which towns are linked is not computed anew yet',
        '`streetgen.design`');
