-- The roadway is drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._roadway_at_nodes(model name, box geometry)
    RETURNS TABLE(node_id bigint, importance integer, level integer, surface geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH arm AS MATERIALIZED (
        SELECT i.node_id, i.level, i.surface::geometry, e.importance, l.border_line::geometry
        FROM intersection i, LATERAL (SELECT edge_id, importance, 'start' AS which FROM edge
                WHERE from_node = i.node_id
            UNION ALL SELECT edge_id, importance, 'end' FROM edge WHERE to_node = i.node_id) e
            JOIN section_limit l USING (edge_id, which) WHERE i.surface && box),
    least AS (SELECT node_id, max(importance) AS importance FROM arm GROUP BY node_id)
    SELECT * FROM (SELECT DISTINCT ON (node_id) node_id, a.importance, a.level, a.surface
        FROM arm a JOIN least USING (node_id, importance)) whole
    UNION ALL SELECT node_id, w.importance, a.level, ST_Intersection(a.surface,
            ST_ConvexHull(ST_Collect(a.border_line)))
        FROM (SELECT DISTINCT node_id, importance FROM arm) w JOIN least l USING (node_id) JOIN arm a USING (node_id)
        WHERE w.importance < l.importance AND a.importance <= w.importance
        GROUP BY node_id, w.importance, a.level, a.surface HAVING count(*) > 1;
END $$;
COMMENT ON FUNCTION streetgen._roadway_at_nodes(name, geometry) IS
    'Intersections in a box by importance: the whole of each as its least important street, and the ways through it '
    'from limit to limit of the more important ones.';

CREATE OR REPLACE FUNCTION streetgen._surface_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'section', CASE WHEN method IN ('contested', 'crowded') THEN 'contested'
            ELSE streetgen._paving_kind(roadway) END, level, surface::geometry, edge_id
        FROM section JOIN paving USING (edge_id) WHERE 'section' = ANY (layers) AND surface && box;
    RETURN QUERY SELECT 'intersection', CASE WHEN method IN ('contested', 'crowded') THEN 'contested'
            WHEN method = 'transition' THEN 'transition'
            -- An intersection looks as its streets do, where all of these are paved alike.
            ELSE (SELECT CASE WHEN min(k) = max(k) THEN min(k) ELSE '' END FROM (SELECT streetgen._paving_kind(roadway)
                FROM paving JOIN edge e USING (edge_id) WHERE node_id IN (e.from_node, e.to_node)) p(k)) END, level,
            surface::geometry, node_id
        FROM intersection WHERE 'intersection' = ANY (layers) AND surface && box;
    RETURN QUERY SELECT 'roadway', importance::text, s.level, s.surface::geometry, edge_id FROM section s
        JOIN edge USING (edge_id) WHERE 'roadway' = ANY (layers) AND surface && box;
    IF 'roadway' = ANY (layers) THEN
        RETURN QUERY SELECT 'roadway', importance::text, level, surface, node_id
            FROM streetgen._roadway_at_nodes(model, box);
    END IF;
    RETURN QUERY SELECT 'limit', '', NULL::integer, border_line::geometry, section_limit_id FROM section_limit
        WHERE 'limit' = ANY (layers) AND method = 'hypothesis' AND border_line && box;
    RETURN QUERY SELECT 'arc', CASE method WHEN 'hypothesis' THEN '' ELSE 'fallback' END, NULL::integer,
        ST_CurveToLine(arc, 16), corner_id FROM corner WHERE 'arc' = ANY (layers) AND arc && box;
END $$;
COMMENT ON FUNCTION streetgen._surface_drawn(name, geometry, text[]) IS
    'What can be drawn of the roadway in a box: section, intersection, limit and arc; and roadway, both by importance.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'section', 5000, 1, '#73777f', '#73777f', 0.7, 'pixel', 'roadway'),
    ('dark', 'section', 5000, 1, '#454b54', '#454b54', 0.7, 'pixel', 'roadway');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit) VALUES
    ('street', 'intersection', 5000, 1, '#73777f', '#73777f', 0.7, 'pixel'),
    ('dark', 'intersection', 5000, 1, '#454b54', '#454b54', 0.7, 'pixel');
-- Stones and unpaved ground show where a source says so.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, layer, kind, 5000, 1, colour, colour, 0.7, 'pixel', CASE layer WHEN 'section' THEN meaning END
    FROM unnest('{section,intersection}'::text[]) layer, (VALUES
        ('street', 'stone', '#8b8079', 'roadway of stones'), ('street', 'unpaved', '#a8967c', 'unpaved roadway'),
        ('dark', 'stone', '#57504c', 'roadway of stones'), ('dark', 'unpaved', '#665a48', 'unpaved roadway'))
        v(theme, kind, colour, meaning);
INSERT INTO streetgen.symbol_rule (theme, layer, from_scale, to_scale, place, fill, line, width, unit) VALUES
    ('street', 'roadway', 5000, 15000, 1, '#a39d90', '#a39d90', 1.6, 'pixel'),
    ('dark', 'roadway', 5000, 15000, 1, '#3a3f47', '#3a3f47', 1.6, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, to_scale, place, fill, line, width, unit) VALUES
    ('street', 'roadway', '1', 5000, 15000, 1.3, '#a8662a', '#a8662a', 2, 'pixel'),
    ('street', 'roadway', '2', 5000, 15000, 1.2, '#b5843c', '#b5843c', 2, 'pixel'),
    ('street', 'roadway', '3', 5000, 15000, 1.1, '#b39a5a', '#b39a5a', 2, 'pixel'),
    ('dark', 'roadway', '1', 5000, 15000, 1.3, '#6b4a26', '#6b4a26', 2, 'pixel'),
    ('dark', 'roadway', '2', 5000, 15000, 1.2, '#5d4a2a', '#5d4a2a', 2, 'pixel'),
    ('dark', 'roadway', '3', 5000, 15000, 1.1, '#4c4530', '#4c4530', 2, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, from_scale, to_scale, place, fill, line, width, unit, meaning)
    VALUES
    ('street', 'roadway', 5000, 15000, 2, '#ffffff', '#ffffff', 0.4, 'pixel', 'other street'),
    ('dark', 'roadway', 5000, 15000, 2, '#5a616b', '#5a616b', 0.4, 'pixel', 'other street');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, to_scale, place, fill, line, width, unit,
    meaning) VALUES
    ('street', 'roadway', '1', 5000, 15000, 3.0, '#f0a24e', '#f0a24e', 0.6, 'pixel', 'motorway or main road'),
    ('street', 'roadway', '2', 5000, 15000, 2.9, '#f6c878', '#f6c878', 0.6, 'pixel', 'primary street'),
    ('street', 'roadway', '3', 5000, 15000, 2.8, '#fbe5ac', '#fbe5ac', 0.6, 'pixel', 'secondary street'),
    ('dark', 'roadway', '1', 5000, 15000, 3.0, '#c98a4a', '#c98a4a', 0.6, 'pixel', 'motorway or main road'),
    ('dark', 'roadway', '2', 5000, 15000, 2.9, '#a8874f', '#a8874f', 0.6, 'pixel', 'primary street'),
    ('dark', 'roadway', '3', 5000, 15000, 2.8, '#8a7c55', '#8a7c55', 0.6, 'pixel', 'secondary street');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('construction', 'section', 11000, 1, '#b4bac3', 'section of a street'),
    ('construction', 'intersection', 11000, 2, '#939ca9', 'intersection');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, meaning) VALUES
    ('construction', 'section', 'contested', 11000, 1, '#cfa659', 'contested section'),
    ('construction', 'intersection', 'transition', 11000, 2, '#a58fd0', 'change of width'),
    ('construction', 'intersection', 'contested', 11000, 2, '#cfa659', 'contested intersection');
INSERT INTO streetgen.symbol_rule (theme, layer, from_scale, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'section', 11000, 1, '#4b5563', '#4b5563', 0.6, 'pixel', 'roadway');
INSERT INTO streetgen.symbol_rule (theme, layer, from_scale, place, fill, line, width, unit) VALUES
    ('construction', 'intersection', 11000, 1, '#4b5563', '#4b5563', 0.6, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'limit', 11000, 901, '#4b5563', 1, 'pixel', 'limit of a section'),
    ('construction', 'arc', 11000, 902, '#1d4ed8', 1.5, 'pixel', 'corner of the wanted radius');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'arc', 'fallback', 11000, 902, '#c2410c', 1.5, 'pixel', 'corner of another radius');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', 'limit', 980, '#0f766e', '#0f766e', 1, 'pixel', 'limit to drag');
-- Black below a white roadway leaves a line along its border.
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'section', 5000, 0.8, '#000000', '#000000', 1.8, 'pixel', NULL),
    ('print', 'intersection', 5000, 0.8, '#000000', '#000000', 1.8, 'pixel', NULL),
    ('print', 'section', 5000, 1, '#ffffff', '#ffffff', 0.7, 'pixel', 'roadway'),
    ('print', 'intersection', 5000, 1, '#ffffff', '#ffffff', 0.7, 'pixel', NULL);
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning)
    SELECT 'print', layer, kind, 5000, place, colour, colour, width, 'pixel', CASE WHEN place = 1 AND layer = 'section'
        THEN meaning END
    FROM unnest('{section,intersection}'::text[]) layer, (VALUES ('stone', 0.8, '#000000', 1.8, NULL),
        ('stone', 1, '#f0f0f0', 0.7, 'roadway of stones'), ('unpaved', 0.8, '#000000', 1.8, NULL),
        ('unpaved', 1, '#e6e6e6', 0.7, 'unpaved roadway')) v(kind, place, colour, width, meaning);
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, to_scale, place, fill, line, width, unit, meaning)
    VALUES
    ('print', 'roadway', '', 5000, 15000, 1, '#000000', '#000000', 1.6, 'pixel', NULL),
    ('print', 'roadway', '1', 5000, 15000, 1.3, '#000000', '#000000', 2, 'pixel', NULL),
    ('print', 'roadway', '2', 5000, 15000, 1.2, '#000000', '#000000', 2, 'pixel', NULL),
    ('print', 'roadway', '3', 5000, 15000, 1.1, '#000000', '#000000', 2, 'pixel', NULL),
    ('print', 'roadway', '', 5000, 15000, 2, '#ffffff', '#ffffff', 0.6, 'pixel', 'other street'),
    ('print', 'roadway', '1', 5000, 15000, 3.0, '#606060', '#606060', 0.6, 'pixel', 'motorway or main road'),
    ('print', 'roadway', '2', 5000, 15000, 2.9, '#a0a0a0', '#a0a0a0', 0.6, 'pixel', 'primary street'),
    ('print', 'roadway', '3', 5000, 15000, 2.8, '#d8d8d8', '#d8d8d8', 0.6, 'pixel', 'secondary street');
