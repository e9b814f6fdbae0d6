-- Junctions are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._junction_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'junction', '', level, j.surface::geometry, junction_id FROM junction j
        JOIN intersection i ON node_id = junction_id
        WHERE 'junction' = ANY (layers) AND j.method <> 'hypothesis' AND j.surface && box;
    RETURN QUERY SELECT 'rim_marking', m.kind, level, m.surface::geometry, marking_id FROM rim_marking m
        JOIN edge USING (edge_id) WHERE 'rim_marking' = ANY (layers) AND m.surface && box;
    RETURN QUERY SELECT 'movement', CASE WHEN plausible THEN '' ELSE 'implausible' END, NULL::integer, geom::geometry,
        interconnections[1] FROM movement WHERE 'movement' = ANY (layers) AND geom && box;
    RETURN QUERY SELECT 'junction_limit', '', NULL::integer, border_line::geometry, section_limit_id
        FROM section_limit WHERE 'junction_limit' = ANY (layers) AND method = 'hypothesis' AND border_line && box
            AND edge_id NOT IN (SELECT edge_id FROM junction_edge);
    -- Arcs inside a junction are no kerb.
    RETURN QUERY SELECT 'junction_arc', CASE c.method WHEN 'hypothesis' THEN '' ELSE 'fallback' END, NULL::integer,
            d.geom, c.corner_id
        FROM corner c LEFT JOIN junction_node n USING (node_id)
            LEFT JOIN junction j ON j.junction_id = n.junction_id AND j.method <> 'hypothesis'
            CROSS JOIN LATERAL ST_CurveToLine(c.arc, 16) whole CROSS JOIN LATERAL ST_Dump(CASE WHEN j.surface IS NULL
                THEN whole ELSE ST_Intersection(whole, ST_Buffer(ST_Boundary(j.surface), 0.05)) END) d
        WHERE 'junction_arc' = ANY (layers) AND c.arc && box AND (j.surface IS NULL OR ST_Length(d.geom) > 0.5);
END $$;
COMMENT ON FUNCTION streetgen._junction_drawn(name, geometry, text[]) IS
    'What can be drawn of junctions in a box: junction; and rim_marking, movement, junction_limit and junction_arc, '
    'which stand for markings, paths, limits and arcs of single nodes.';

CREATE OR REPLACE FUNCTION streetgen._junction_drawn_instead() RETURNS TABLE(layer text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES ('marking'), ('limit'), ('arc'), ('path') $$;
COMMENT ON FUNCTION streetgen._junction_drawn_instead() IS
    'The layers of other rooms that are not drawn where junctions are computed: those of junctions show more.';

INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('construction', 'junction', 11000, 3, '#7f9cc0', 'junction of several nodes');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill) VALUES
    ('street', 'rim_marking', 1500, 4, '#fbfbf8'),
    ('dark', 'rim_marking', 1500, 4, '#dfe2e6'),
    ('construction', 'rim_marking', 2000, 4, '#ffffff');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'movement', 2000, 895, '#15803d', 0.7, 'pixel', 'path from lane to lane'),
    ('construction', 'junction_limit', 11000, 901, '#4b5563', 1, 'pixel', 'limit of a section'),
    ('construction', 'junction_arc', 11000, 902, '#1d4ed8', 1.5, 'pixel', 'corner of the wanted radius');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'movement', 'implausible', 2000, 894, '#6b728080', 0.4, 'pixel', 'path that is not plausible'),
    ('construction', 'junction_arc', 'fallback', 11000, 902, '#c2410c', 1.5, 'pixel', 'corner of another radius');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', 'signals', 980, '#1a9641', '#1a9641', 1, 'pixel', 'with signals'),
    ('construction', 'handle', 'stop', 980, '#d7191c', '#d7191c', 1, 'pixel', 'with stop lines'),
    ('construction', 'handle', 'yield', 980, '#0f766e', '#0f766e', 1, 'pixel', 'with yield lines'),
    ('construction', 'handle', 'priority', 980, '#fdae61', '#fdae61', 1, 'pixel', 'one street has priority'),
    ('construction', 'handle', 'right_before_left', 980, '#7cc4e8', '#7cc4e8', 1, 'pixel', 'right before left'),
    ('construction', 'handle', 'ramp', 980, '#7b3294', '#7b3294', 1, 'pixel', 'of a ramp'),
    ('construction', 'handle', 'fork', 980, '#a16207', '#a16207', 1, 'pixel', 'where a street parts'),
    ('construction', 'handle', 'merge', 980, '#b45309', '#b45309', 1, 'pixel', 'where streets come together'),
    ('construction', 'handle', 'roundabout', 980, '#2c7bb6', '#2c7bb6', 1, 'pixel', 'roundabout'),
    ('construction', 'handle', 'mini_roundabout', 980, '#2c7bb6', '#2c7bb6', 1, 'pixel', 'mini-roundabout'),
    ('construction', 'handle', 'pedestrian_crossing', 980, '#2b6cb0', '#2b6cb0', 1, 'pixel', 'pedestrian crossing'),
    ('construction', 'handle', 'continuation', 980, '#bababa', '#bababa', 1, 'pixel', 'where a street goes on'),
    ('construction', 'handle', 'end', 980, '#e0e0e0', '#e0e0e0', 1, 'pixel', 'end of a street'),
    ('construction', 'handle', 'inside', 980, '#0f766e', '#0f766e', 1, 'pixel', 'inside a junction');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit) VALUES
    ('print', 'rim_marking', 1500, 4, '#000000', '#000000', 0.5, 'pixel');
