-- Axes and streets are drawn by these rules.

CREATE OR REPLACE FUNCTION streetgen._network_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- Below the line in the middle of the street, which runs along it.
    RETURN QUERY SELECT 'axis', '', level, geom::geometry, edge_id FROM edge
        WHERE 'axis' = ANY (layers) AND geom && box;
    RETURN QUERY SELECT 'street', importance::text, NULL::integer, geom::geometry, edge_id FROM edge
        WHERE 'street' = ANY (layers) AND geom && box;
    RETURN QUERY SELECT 'report', '', NULL::integer, ST_Buffer(geom, 2), axis_a FROM report
        WHERE 'report' = ANY (layers) AND geom && box;
END $$;
COMMENT ON FUNCTION streetgen._network_drawn(name, geometry, text[]) IS
    'What can be drawn of the network in a box: axis; street, the same by importance; and report.';

CREATE OR REPLACE FUNCTION streetgen._network_named(model name, box geometry)
    RETURNS TABLE(name text, importance integer, geom geometry, apart float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- The two carriageways of a street are less than 60 m apart; all of a ring is one place.
    RETURN QUERY SELECT s.name, s.importance, line.geom, CASE WHEN s.ring OR ST_IsClosed(line.geom)
            THEN greatest(60, ST_Perimeter(ST_Envelope(line.geom))) ELSE 60 END
        FROM (SELECT a.name, a.roundabout_tag IS NOT NULL AS ring, min(e.importance) AS importance,
                ST_LineMerge(ST_Collect(ST_Force2D(e.geom))) AS lines
            FROM edge e JOIN axis a USING (axis_id) WHERE e.geom && box AND a.name ~ '\S' GROUP BY a.name, ring) s,
            ST_Dump(s.lines) line;
END $$;
COMMENT ON FUNCTION streetgen._network_named(name, geometry) IS
    'The names of streets in a box, each along the axes that bear it.';

CREATE OR REPLACE FUNCTION streetgen._network_numbered(model name, box geometry)
    RETURNS TABLE(ref text, importance integer, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- A route of several numbers shows the first.
    RETURN QUERY SELECT r.ref, r.importance, line.geom FROM (
        SELECT first AS ref, min(e.importance) AS importance, ST_LineMerge(ST_Collect(ST_Force2D(e.geom))) AS lines
        FROM edge e JOIN axis a USING (axis_id), LATERAL (SELECT btrim(split_part(a.ref, ';', 1)) AS first) f
        WHERE e.geom && box AND first ~ '\S' GROUP BY first) r, ST_Dump(r.lines) line;
END $$;
COMMENT ON FUNCTION streetgen._network_numbered(name, geometry) IS
    'The numbers of routes in a box, each along the axes that bear it.';

INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, place, line, width, unit, meaning) VALUES
    ('street', 'street', '1', 15000, 910, '#d9822b', 2.4, 'pixel', 'motorway or main road'),
    ('street', 'street', '2', 15000, 909, '#e0a94b', 1.8, 'pixel', 'primary street'),
    ('street', 'street', '3', 15000, 908, '#c3ae6e', 1.2, 'pixel', 'secondary street'),
    ('dark', 'street', '1', 15000, 910, '#e0a060', 2.4, 'pixel', 'motorway or main road'),
    ('dark', 'street', '2', 15000, 909, '#b8945a', 1.8, 'pixel', 'primary street'),
    ('dark', 'street', '3', 15000, 908, '#8d8463', 1.2, 'pixel', 'secondary street');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, place, line, width, unit, meaning) VALUES
    ('print', 'street', '1', 15000, 910, '#000000', 3.2, 'pixel', 'motorway or main road'),
    ('print', 'street', '2', 15000, 909, '#000000', 2.2, 'pixel', 'primary street'),
    ('print', 'street', '3', 15000, 908, '#000000', 1.3, 'pixel', 'secondary street'),
    ('print', 'street', '', 15000, 905, '#707070', 0.6, 'pixel', 'other street');
INSERT INTO streetgen.symbol_rule (theme, layer, from_scale, place, line, width, unit, meaning) VALUES
    ('street', 'street', 15000, 905, '#a9a598', 0.6, 'pixel', 'other street'),
    ('dark', 'street', 15000, 905, '#565d68', 0.6, 'pixel', 'other street');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, line, width, unit, meaning) VALUES
    ('construction', 'axis', 11000, 3, '#5b7390', 1, 'pixel', 'axis');
INSERT INTO streetgen.symbol_rule (theme, layer, place, fill, meaning) VALUES
    ('construction', 'report', 903, '#dc262666', 'report');
INSERT INTO streetgen.symbol_rule (theme, layer, to_scale, place, fill, line, width, unit) VALUES
    ('street', 'name', 3000, 960, '#20242b', '#ffffffd9', 11, 'pixel'),
    ('print', 'name', 3000, 960, '#000000', '#ffffff', 11, 'pixel'),
    ('dark', 'name', 3000, 960, '#f1f3f5', '#14171cd9', 11, 'pixel');
INSERT INTO streetgen.symbol_rule (theme, layer, from_scale, to_scale, place, fill, line, width, unit)
    SELECT theme, layer, 3000, 6000, place, fill, line, 9, unit FROM streetgen.symbol_rule WHERE layer = 'name';
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, to_scale, place, fill, line, width, unit)
    SELECT theme, layer, street.kind, 3000, 15000, place, fill, line, 10, unit FROM streetgen.symbol_rule,
        unnest('{1,2,3,4}'::text[]) street(kind) WHERE layer = 'name' AND from_scale = 0;
INSERT INTO streetgen.symbol_rule (theme, layer, kind, place, fill, line, width, unit, meaning) VALUES
    ('construction', 'handle', 'axis', 980, '#2b6cb0', '#2b6cb0', 1, 'pixel', 'axis to edit'),
    ('construction', 'handle', 'node', 980, '#2b6cb0', '#2b6cb0', 1, 'pixel', 'node to drag'),
    ('construction', 'handle', 'proposed', 980, '#c2410c', '#c2410c', 1, 'pixel', 'axis as it would be mended');
INSERT INTO streetgen.symbol_rule (theme, layer, kind, to_scale, place, fill, line, width, unit) VALUES
    ('street', 'ref', '1', 25000, 970, '#b3541e', '#ffffff', 10, 'pixel'),
    ('street', 'ref', '2', 25000, 970, '#f6c878', '#3a2a08', 10, 'pixel'),
    ('street', 'ref', '3', 25000, 970, '#ffffff', '#3f454d', 9, 'pixel'),
    ('dark', 'ref', '1', 25000, 970, '#c98a4a', '#14171c', 10, 'pixel'),
    ('dark', 'ref', '2', 25000, 970, '#5d4a2a', '#f1e3c4', 10, 'pixel'),
    ('dark', 'ref', '3', 25000, 970, '#262b33', '#d5d9df', 9, 'pixel'),
    ('print', 'ref', '1', 25000, 970, '#000000', '#ffffff', 10, 'pixel'),
    ('print', 'ref', '2', 25000, 970, '#ffffff', '#000000', 10, 'pixel'),
    ('print', 'ref', '3', 25000, 970, '#ffffff', '#000000', 9, 'pixel');
