-- Objects along streets are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._object_drawn_as(model name)
    RETURNS TABLE(layer text, kind text, drawn_as text, turn integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 60 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH RECURSIVE above AS (
        SELECT o.type, o.type AS word, o.parent, o.symbol, o.category, 1 AS turn FROM object_type o
        UNION ALL SELECT a.type, o.type, o.parent, o.symbol, o.category, a.turn + 1
            FROM above a JOIN object_type o ON o.type = a.parent WHERE a.turn < 20)
    SELECT 'object', a.type, v.word, a.turn + v.after
    FROM above a, LATERAL (VALUES (a.word, 0), (a.symbol, 100), (a.category, 200)) v(word, after)
    WHERE v.word IS NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._object_drawn_as(name) IS
    'The kinds as which objects of a type may be drawn, in turn: the type, those above it, their symbols, their '
    'categories.';

CREATE OR REPLACE FUNCTION streetgen._object_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'object', type, NULL::integer, streetgen._object_symbol(o.geom, angle, symbol, size),
            street_object_id
        FROM street_object o JOIN object_type USING (type)
        WHERE 'object' = ANY (layers) AND symbol NOT IN ('crossing', 'bay') AND o.geom && box;
    RETURN QUERY SELECT 'crossing', painted_as, coalesce(level, 0), stripes::geometry, street_object_id
        FROM pedestrian_crossing JOIN street_object USING (street_object_id) LEFT JOIN axis USING (axis_id)
        WHERE 'crossing' = ANY (layers) AND stripes && box;
    RETURN QUERY SELECT 'refuge', '', coalesce(level, 0), island::geometry, street_object_id
        FROM pedestrian_crossing JOIN street_object USING (street_object_id) LEFT JOIN axis USING (axis_id)
        WHERE 'refuge' = ANY (layers) AND island && box;
    RETURN QUERY SELECT 'bay', '', coalesce(level, 0), surface::geometry, street_object_id
        FROM parking_bay JOIN street_object USING (street_object_id) LEFT JOIN axis USING (axis_id)
        WHERE 'bay' = ANY (layers) AND surface && box;
    IF 'bus_stop_box' = ANY (layers) AND to_regclass('bus_stop_box') IS NOT NULL THEN
        RETURN QUERY SELECT 'bus_stop_box', b.kind, b.level, b.paint::geometry, b.street_object_id
            FROM bus_stop_box b WHERE b.street_object_id = ANY (ARRAY(SELECT o.street_object_id FROM street_object o
                WHERE o.geom && ST_Expand(box, 100))) AND b.surface && box;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._object_drawn(name, geometry, text[]) IS
    'What can be drawn of objects in a box: object, by type; crossing, the stripes, by what they are; '
    'refuge; bay; and bus_stop_box, the paint where buses stand, on a bay or on a lane.';

CREATE OR REPLACE FUNCTION streetgen._object_kept_clear(model name, box geometry) RETURNS SETOF geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT stripes::geometry FROM pedestrian_crossing WHERE stripes && box;
END $$;
COMMENT ON FUNCTION streetgen._object_kept_clear(name, geometry) IS
    'The crossings in a box, over which no name stands where another place is free.';

INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, width, unit, marker) VALUES
    ('street', 'object', 'tree', 2500, 949, '#0000001f', 1.5, 'metre', 'shadow'),
    ('street', 'object', 'tree', 2500, 950, '#00000026', 0.9, 'metre', 'shadow'),
    ('street', 'object', 'green', 2500, 950, '#00000033', 0.4, 'metre', 'shadow'),
    ('dark', 'object', 'tree', 2500, 950, '#00000080', 1, 'metre', 'shadow'),
    ('dark', 'object', 'green', 2500, 950, '#00000080', 0.4, 'metre', 'shadow');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'object', 'tree', 2500, 953, '#6f9d57d9', '#4f7a3a', 0.5, 'pixel', 'tree'),
    ('street', 'object', 'green', 2500, 951, '#6f9d57', '#4f7a3a', 0.5, 'pixel', 'hedge'),
    ('street', 'object', 'lamp', 1500, 952, '#f4c542', '#5a4a12', 0.06, 'metre', 'street lamp'),
    ('street', 'object', 'traffic_light', 1500, 952, '#c92a2a', '#ffffff', 0.06, 'metre', 'signal'),
    ('street', 'object', 'sign', 1500, 952, '#2f5fb3', '#ffffff', 0.06, 'metre', 'traffic sign'),
    ('street', 'object', 'bus_stop', 1500, 952, '#1d4ed8', '#ffffff', 0.1, 'metre', 'bus stop'),
    ('dark', 'object', 'tree', 2500, 953, '#2f5a35d9', '#3f7a46', 0.5, 'pixel', 'tree'),
    ('dark', 'object', 'green', 2500, 951, '#2f5a35', '#3f7a46', 0.5, 'pixel', 'hedge'),
    ('dark', 'object', 'lamp', 1500, 952, '#ffd873', '#ffd87366', 0.5, 'metre', 'street lamp'),
    ('construction', 'object', 'tree', 2000, 951, '#4d7c0f99', '#3f6212', 0.5, 'pixel', 'tree'),
    ('construction', 'object', 'green', 2000, 951, '#4d7c0f', '#4d7c0f', 1.5, 'pixel', 'hedge'),
    ('construction', 'object', 'lamp', 2000, 952, '#b45309', '#b45309', 3, 'pixel', 'street lamp'),
    ('construction', 'object', 'traffic_light', 2000, 952, '#dc2626', '#dc2626', 3, 'pixel', 'signal'),
    ('construction', 'object', 'sign', 2000, 952, '#2563eb', '#2563eb', 3, 'pixel', 'traffic sign'),
    ('construction', 'object', 'bus_stop', 2000, 952, '#0e7490', '#0e7490', 3, 'pixel', 'bus stop'),
    ('construction', 'object', 'furniture', 2000, 952, '#7c3aed', '#7c3aed', 3, 'pixel', 'street furniture'),
    ('construction', 'object', 'protection', 2000, 952, '#475569', '#475569', 2, 'pixel', 'bollard or barrier'),
    ('construction', 'object', 'calming', 2000, 952, '#a16207', '#a16207', 2, 'pixel', 'what slows traffic'),
    ('construction', 'object', 'manhole', 2000, 952, '#64748b', '#64748b', 2, 'pixel', 'manhole'),
    ('construction', 'object', 'arrow', 2000, 952, '#ffffff', '#ffffff', 0.5, 'pixel', 'paint');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, meaning) VALUES
    ('street', 'crossing', 'surface', 5000, 7, '#b98d74', 'coloured crossing'),
    ('dark', 'crossing', 'surface', 5000, 7, '#7d6152', 'coloured crossing'),
    ('construction', 'crossing', 'surface', 2000, 7, '#b98d74', 'coloured crossing'),
    ('print', 'crossing', 'surface', 2500, 7, '#c8c8c8', 'coloured crossing'),
    ('street', 'object', 'furniture', 1500, 952, '#7a4f2a', 'street furniture'),
    ('street', 'object', 'protection', 1500, 952, '#3f454d', 'bollard or barrier'),
    ('street', 'object', 'calming', 1500, 948, '#8b8f97', 'what slows traffic'),
    ('street', 'object', 'manhole', 1500, 948, '#5f636a', 'manhole'),
    ('street', 'object', 'arrow', 1500, 948, '#fbfbf8', 'paint'),
    ('dark', 'object', 'traffic_light', 1500, 952, '#ff5a4a', 'signal'),
    ('dark', 'object', 'sign', 1500, 952, '#6d9eeb', 'traffic sign'),
    ('dark', 'object', 'bus_stop', 1500, 952, '#7aa2ff', 'bus stop'),
    ('dark', 'object', 'furniture', 1500, 952, '#b08a5f', 'street furniture'),
    ('dark', 'object', 'protection', 1500, 952, '#8d949e', 'bollard or barrier'),
    ('dark', 'object', 'calming', 1500, 948, '#5b626d', 'what slows traffic'),
    ('dark', 'object', 'manhole', 1500, 948, '#262b32', 'manhole'),
    ('dark', 'object', 'arrow', 1500, 948, '#dfe2e6', 'paint');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('street', 'object', 1500, 952, '#3f454d', 'object'),
    ('street', 'crossing', 5000, 7, '#fbfbf8', 'crossing'),
    ('dark', 'object', 1500, 952, '#21262d', 'object'),
    ('dark', 'crossing', 5000, 7, '#dfe2e6', 'crossing');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('street', 'bus_stop_box', 2500, 7, '#f2c230', 'where buses stop'),
    ('dark', 'bus_stop_box', 2500, 7, '#b8942a', 'where buses stop'),
    ('construction', 'bus_stop_box', 2000, 7, '#eab308', 'where buses stop'),
    ('print', 'bus_stop_box', 2500, 7, '#000000', 'where buses stop');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'refuge', 5000, 7.5, '#bbb5aa', '#efece4', 0.15, 'metre', 'refuge'),
    ('dark', 'refuge', 5000, 7.5, '#7d848e', '#9aa1ab', 0.15, 'metre', 'refuge'),
    ('construction', 'refuge', 5000, 7.5, '#e9d6ac', '#c9b791', 0.4, 'pixel', 'refuge'),
    ('print', 'refuge', 5000, 7.5, '#ffffff', '#000000', 0.5, 'pixel', 'refuge');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'bay', 1500, 3.5, '#73777f', '#fbfbf8', 0.1, 'metre', 'parking bay'),
    ('dark', 'bay', 1500, 3.5, '#454b54', '#dfe2e6', 0.1, 'metre', 'parking bay'),
    ('construction', 'object', 2000, 952, '#9333ea', '#9333ea', 3, 'pixel', 'object'),
    ('construction', 'bay', 2000, 3.5, '#b4bac3', '#ffffff', 1.2, 'pixel', 'parking bay');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill) VALUES
    ('construction', 'crossing', 2000, 7, '#ffffff');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', 'object', 980, '#7c3aed', '#7c3aed', 1, 'pixel', 'object to drag'),
    ('construction', 'handle', 'lamp', 980, '#f59f00', '#f59f00', 1, 'pixel', 'lamp'),
    ('construction', 'handle', 'tree', 980, '#4d7c0f', '#4d7c0f', 1, 'pixel', 'tree'),
    ('construction', 'handle', 'sign', 980, '#dc2626', '#dc2626', 1, 'pixel', 'sign'),
    ('construction', 'handle', 'traffic_light', 980, '#1a9641', '#1a9641', 1, 'pixel', 'traffic light'),
    ('construction', 'handle', 'bench', 980, '#7c4a1e', '#7c4a1e', 1, 'pixel', 'bench'),
    ('construction', 'handle', 'bollard', 980, '#2b6cb0', '#2b6cb0', 1, 'pixel', 'bollard'),
    ('construction', 'handle', 'bus_stop', 980, '#0f766e', '#0f766e', 1, 'pixel', 'bus stop'),
    ('construction', 'handle', 'arrow', 980, '#52575f', '#52575f', 1, 'pixel', 'arrow');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'object', 'tree', 2500, 953, '#d0d0d0b3', '#000000', 0.5, 'pixel', 'tree or hedge'),
    ('print', 'object', 'green', 2500, 951, '#d0d0d0b3', '#000000', 0.5, 'pixel', 'tree or hedge');
-- A stop is a stop, whoever comes.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning)
    SELECT theme, layer, 'tram_stop', to_scale, place, fill, line, width, unit, 'tram stop' FROM streetgen.symbol_rule
    WHERE kind = 'bus_stop';
-- In black and white their shapes tell them apart.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, meaning)
    SELECT 'print', 'object', kind, 1500, 952, '#000000', CASE kind WHEN 'arrow' THEN 'paint'
        ELSE 'lamp, signal, sign or furniture' END
    FROM unnest('{lamp,traffic_light,sign,bus_stop,tram_stop,furniture,protection,manhole,calming,arrow}'::text[]) kind;
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('print', 'object', 1500, 952, '#000000', 'object'),
    ('print', 'crossing', 2500, 7, '#000000', 'crossing');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'bay', 1500, 3.5, '#ffffff', '#000000', 0.5, 'pixel', 'parking bay');
