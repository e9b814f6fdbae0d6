-- Warnings that count what the input of a model says and a file leaves out.

CREATE OR REPLACE FUNCTION streetgen._format_content()
    RETURNS TABLE(content text, subject text, formats text[], written boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 9 SET search_path = pg_catalog
    AS $$ VALUES
    ('signals', 'signal', '{sumo,symuvia,opendrive,lanelet2}'::text[], true),
    ('pedestrian crossings', 'sidewalk', '{sumo}', true),
    ('pedestrian crossings', 'object', '{opendrive,lanelet2,cityjson,gltf,tiles,wavefront,dxf}', true),
    ('streets with sidewalks', 'sidewalk', '{sumo,opendrive,lanelet2,cityjson,gltf,tiles,wavefront,dxf}', true),
    ('streets above or below the ground', 'height', '{opendrive,lanelet2,cityjson,gltf,tiles,wavefront}', true),
    ('tracks', 'rail', '{sumo,symuvia,opendrive,lanelet2,cityjson,gltf,tiles,wavefront}', false),
    ('objects', 'object', '{gltf,tiles}', true),
    ('objects', 'object', '{symuvia,lanelet2,cityjson,wavefront}', false) $$;
COMMENT ON FUNCTION streetgen._format_content() IS
    'What formats write of a model with a subject (written), and what they do not write of a model with that subject.';

CREATE OR REPLACE FUNCTION streetgen._content_count(model name, content text, options jsonb) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    streets bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF content = 'tracks' AND to_regclass('rail_track') IS NULL
        OR content = 'objects' AND to_regclass('street_object') IS NULL THEN
        RETURN 0;
    ELSIF content = 'tracks' THEN
        RETURN (SELECT count(*) FROM rail_track);
    ELSIF content = 'objects' THEN
        RETURN (SELECT count(*) FROM street_object WHERE type <> ALL (_types_below('crossing')
            || _types_below('parking_bay')));
    END IF;
    streets := ARRAY(SELECT DISTINCT e.axis_id FROM edge e
        WHERE e.edge_id IN (SELECT streetgen._written_edges(model, options)));
    RETURN CASE content
        WHEN 'signals' THEN (SELECT count(*) FROM control_point WHERE kind = 'signals' AND axis_id = ANY (streets))
        WHEN 'pedestrian crossings' THEN (SELECT count(*) FROM control_point
            WHERE kind = 'pedestrian_crossing' AND axis_id = ANY (streets))
        WHEN 'streets with sidewalks' THEN (SELECT count(*) FROM axis
            WHERE axis_id = ANY (streets) AND greatest(sidewalk_left, sidewalk_right) > 0)
        ELSE (SELECT count(*) FROM axis WHERE axis_id = ANY (streets)
            AND level <> (SELECT value::integer FROM setting WHERE name = 'ground_level')) END;
END $$;
COMMENT ON FUNCTION streetgen._content_count(name, text, jsonb) IS
    'How many of that content the streets have that options take; all tracks and objects.';

CREATE OR REPLACE FUNCTION streetgen._left_out(model name, format text, options jsonb)
    RETURNS TABLE(content text, subject text, written boolean, number bigint)
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
    SELECT c.content, c.subject, c.written, n.number
    FROM streetgen._subjects(model) subjects, streetgen._format_content() c,
        LATERAL (SELECT streetgen._content_count(model, c.content, options) AS number) n
    WHERE format = ANY (c.formats) AND c.written <> (c.subject = ANY (subjects)) AND n.number > 0
    ORDER BY c.content $$;
COMMENT ON FUNCTION streetgen._left_out(name, text, jsonb) IS
    'The contents that the input of a model has and a format leaves out, with their number; written: the subject makes '
    'the format have them.';

CREATE OR REPLACE FUNCTION streetgen._tell_left_out(model name, format text, options jsonb) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    absent record;
BEGIN
    FOR absent IN SELECT * FROM streetgen._left_out(model, format, options) LOOP
        IF absent.written THEN
            RAISE WARNING '% of model "%" are left out (%): format % has them of a model with subject "%"',
                absent.content, model, absent.number, format, absent.subject
                USING HINT = format('SELECT * FROM streetgen.switch_subject(%L, %L, true) computes it.', model,
                    absent.subject);
        ELSE
            RAISE WARNING '% of model "%" are left out (%): format % has none yet', absent.content, model,
                absent.number, format USING HINT = 'Files for a GIS have layers of them.';
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._tell_left_out(name, text, jsonb) IS
    'Warns of what the input of a model says and a format leaves out, with the subject to switch on.';
