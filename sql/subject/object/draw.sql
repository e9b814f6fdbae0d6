-- Objects along streets are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._object_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'object', coalesce(category, ''), NULL::integer,
            streetgen._object_symbol(o.geom, angle, symbol, size), street_object_id
        FROM street_object o JOIN object_type USING (type)
        WHERE 'object' = ANY (layers) AND symbol NOT IN ('crossing', 'bay') AND o.geom && box;
    RETURN QUERY SELECT 'crossing', '', 0, stripes::geometry, street_object_id FROM pedestrian_crossing
        WHERE 'crossing' = ANY (layers) AND stripes && box;
    RETURN QUERY SELECT 'bay', '', 0, surface::geometry, street_object_id FROM parking_bay
        WHERE 'bay' = ANY (layers) AND surface && box;
END $$;
COMMENT ON FUNCTION streetgen._object_drawn(name, geometry, text[]) IS
    'What can be drawn of objects in a box: object, by category of its type; crossing, the stripes; and bay.';

INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, width, unit, marker) VALUES
    ('street', 'object', 'green', 2500, 950, '#00000033', 1, 'metre', 'shadow'),
    ('dark', 'object', 'green', 2500, 950, '#00000080', 1, 'metre', 'shadow');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'object', 'green', 2500, 951, '#6f9d57d9', '#4f7a3a', 0.5, 'pixel', 'tree or hedge'),
    ('dark', 'object', 'green', 2500, 951, '#2f5a35d9', '#3f7a46', 0.5, 'pixel', 'tree or hedge'),
    ('construction', 'object', 'green', 2000, 951, '#4d7c0f99', '#3f6212', 0.5, 'pixel', 'tree or hedge');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('street', 'object', 1500, 952, '#3f454d', 'object'),
    ('street', 'crossing', 5000, 7, '#fbfbf8', 'crossing'),
    ('dark', 'object', 1500, 952, '#21262d', 'object'),
    ('dark', 'crossing', 5000, 7, '#dfe2e6', 'crossing');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('street', 'bay', 1500, 3.5, '#73777f', '#fbfbf8', 0.1, 'metre', 'parking bay'),
    ('dark', 'bay', 1500, 3.5, '#454b54', '#dfe2e6', 0.1, 'metre', 'parking bay'),
    ('construction', 'object', 2000, 952, '#7c3aed', '#4c1d95', 0.8, 'pixel', 'object'),
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
    ('print', 'object', 'green', 2500, 951, '#d0d0d0b3', '#000000', 0.5, 'pixel', 'tree or hedge');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, meaning) VALUES
    ('print', 'object', 1500, 952, '#000000', 'object'),
    ('print', 'crossing', 2500, 7, '#000000', 'crossing');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit, meaning) VALUES
    ('print', 'bay', 1500, 3.5, '#ffffff', '#000000', 0.5, 'pixel', 'parking bay');
