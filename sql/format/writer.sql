-- What the writers of formats share: their options, what they need of a model, and how values are written.

CREATE OR REPLACE FUNCTION streetgen.export_option()
    RETURNS TABLE(name text, formats text[], kind text, value jsonb, unit text, description text, minimum float8,
        maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 8 SET search_path = pg_catalog
    AS $$ VALUES
    ('extent', '{sumo,symuvia,opendrive,lanelet2,cityjson,gltf,tiles,wavefront,opensidewalks,dxf}'::text[],
        'box',
        'null'::jsonb, 'm', 'xmin, ymin, xmax, ymax in the SRID of the model: whole edges that touch it; null: all',
        -1e12::float8, 1e12::float8, NULL::text[]),
    ('level', '{sumo,symuvia,opendrive,lanelet2,cityjson,gltf,tiles,wavefront,dxf}', 'integer', 'null', '',
        'edges of this level alone; null: all', -50, 50, NULL),
    ('junctions', '{sumo,symuvia,opendrive,lanelet2}', 'word', '"node"', '',
        'what a junction is: each node, or the nodes of a '
        'junction as one, without the edges inside', NULL, NULL, '{node,group}'),
    ('origin', '{sumo,symuvia,opendrive,lanelet2,cityjson,gltf,wavefront}', 'place', '"corner"', 'm',
        'where coordinates are counted from: whole metres of the lower left corner or of the middle of what is '
        'written, or [x, y] or [x, y, z] in the SRID of the model; z is 0 unless given', -1e12, 1e12,
        '{corner,middle}'),
    ('origin', '{dxf}', 'place', '[0, 0]', 'm',
        'where coordinates are counted from: the origin of the SRID, or as in other formats', -1e12, 1e12,
        '{corner,middle}'),
    ('precision', '{sumo}', 'integer', '2', 'digits', 'digits of a coordinate behind the point', 2, 8, NULL),
    ('precision', '{symuvia}', 'integer', '3', 'digits', 'digits of a coordinate behind the point', 2, 8, NULL),
    ('tolerance', '{sumo}', 'number', '0', 'm', 'how far a simplified line may leave that of the model; 0: all its '
        'points', 0, 10, NULL),
    ('tolerance', '{symuvia}', 'number', '0.1', 'm', 'how far a simplified line may leave that of the model; 0: all '
        'its points', 0, 10, NULL),
    ('precision', '{opendrive}', 'integer', '7', 'digits', 'digits of a coordinate behind the point', 3, 8, NULL),
    ('tolerance', '{opendrive,lanelet2}', 'number', '0.05', 'm',
        'how far lines and arcs may leave the lines of the model', 0.001, 1, NULL),
    ('programs', '{sumo}', 'word', '"static"', '', 'whether signals keep their times, or end and prolong their greens '
        'as detectors say', NULL, NULL, '{static,actuated}'),
    ('two_way_lanes', '{opendrive}', 'word', '"bidirectional"', '', 'what a lane for both directions is: one lane of '
        'type bidirectional, or a lane of type driving each way, half as wide', NULL, NULL, '{bidirectional,driving}'),
    ('georeference', '{opendrive}', 'word', '"srid"', '', 'where coordinates count: in the SRID of the model, '
        'from offset, or in a transverse Mercator one about the origin, with offset 0', NULL, NULL, '{srid,local}'),
    ('undulation', '{tiles}', 'number', '0', 'm', 'how far the zero of the model''s heights, the geoid, lies above '
        'the ellipsoid', -150, 150, NULL),
    ('nodes', '{gltf,tiles}', 'word', '"cell"', '',
        'what a node is: a square of 500 m, or each edge and each node of the model, to be picked', NULL, NULL,
        '{cell,street}'),
    ('autoware', '{lanelet2}', 'word', '"no"', '', 'whether points have local_x and local_y, and crosswalks a rule '
        'that Autoware knows', NULL, NULL, '{no,yes}'),
    ('version', '{opendrive}', 'word', '"1.7"', '', 'the version of OpenDRIVE', NULL, NULL, '{1.7,1.6}'),
    ('precision', '{cityjson,wavefront,dxf}', 'integer', '3', 'digits',
        'digits of a coordinate behind the point', 2, 8, NULL),
    ('tolerance', '{cityjson,gltf,tiles,wavefront}', 'number', '0.05', 'm',
        'how far triangles may leave the heights of the streets', 0.001, 10, NULL)
    $$;
COMMENT ON FUNCTION streetgen.export_option() IS
    'The options of the writers of files: name, the formats that have it (the word behind export_), kind (box, '
    'place, integer, number or word), default value, unit, meaning, range of numbers and words of choice.';

CREATE OR REPLACE FUNCTION streetgen._are_numbers(list jsonb, minimum float8, maximum float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT bool_and(CASE jsonb_typeof(v) WHEN 'number' THEN (v #>> '{}')::numeric
            BETWEEN minimum::numeric AND maximum::numeric ELSE false END) FROM jsonb_array_elements(list) v $$;
COMMENT ON FUNCTION streetgen._are_numbers(jsonb, float8, float8) IS
    'Whether all elements of a list are numbers within a range.';

CREATE OR REPLACE FUNCTION streetgen._fits_option(kind text, value jsonb, minimum float8, maximum float8,
    choice text[]) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE kind
        WHEN 'word' THEN jsonb_typeof(value) = 'string' AND value #>> '{}' = ANY (choice)
        WHEN 'place' THEN jsonb_typeof(value) = 'string' AND value #>> '{}' = ANY (choice)
            OR jsonb_typeof(value) = 'array' AND jsonb_array_length(value) IN (2, 3)
                AND streetgen._are_numbers(value, minimum, maximum)
        WHEN 'box' THEN jsonb_typeof(value) = 'array' AND jsonb_array_length(value) = 4
            AND streetgen._are_numbers(value, minimum, maximum)
            AND (value ->> 0)::numeric <= (value ->> 2)::numeric AND (value ->> 1)::numeric <= (value ->> 3)::numeric
        ELSE jsonb_typeof(value) = 'number' AND (value #>> '{}')::numeric BETWEEN minimum::numeric AND maximum::numeric
            AND (kind = 'number' OR (value #>> '{}')::numeric % 1 = 0) END
    $$;
COMMENT ON FUNCTION streetgen._fits_option(text, jsonb, float8, float8, text[]) IS
    'Whether a value is one that an option of that kind takes.';

CREATE OR REPLACE FUNCTION streetgen._export_options(format text, options jsonb) RETURNS jsonb
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    wrong record;
    known text;
BEGIN
    IF jsonb_typeof(options) IS DISTINCT FROM 'object' THEN
        RAISE EXCEPTION 'the options are %, expected an object', coalesce(left(options::text, 100), 'NULL')
            USING ERRCODE = '22023', HINT = 'For example {"precision": 3}; {} takes the defaults.';
    END IF;
    SELECT o.key, o.value, e.name, e.kind, e.minimum, e.maximum, e.choice INTO wrong
        FROM jsonb_each(options) o LEFT JOIN streetgen.export_option() e ON e.name = o.key AND format = ANY (e.formats)
        WHERE (e.name IS NOT NULL AND (o.value = e.value
            OR streetgen._fits_option(e.kind, o.value, e.minimum, e.maximum, e.choice))) IS NOT TRUE
        ORDER BY o.key LIMIT 1;
    IF wrong.key IS NOT NULL THEN
        SELECT string_agg(e.name, ', ' ORDER BY e.name) INTO known FROM streetgen.export_option() e
            WHERE format = ANY (e.formats);
        IF wrong.name IS NULL THEN
            RAISE EXCEPTION 'format % has no option "%"', format, wrong.key USING ERRCODE = '22023',
                HINT = format('Its options are %s; SELECT * FROM streetgen.export_option() explains them.', known);
        END IF;
        RAISE EXCEPTION 'option "%" is %, expected %', wrong.key, left(wrong.value::text, 100),
            CASE wrong.kind WHEN 'word' THEN array_to_string(wrong.choice, ' or ')
                WHEN 'box' THEN '[xmin, ymin, xmax, ymax]'
                WHEN 'place' THEN array_to_string(wrong.choice, ', ') || ', [x, y] or [x, y, z]'
                ELSE format('a%s number from %s to %s', CASE wrong.kind WHEN 'integer' THEN ' whole' ELSE '' END,
                    wrong.minimum, wrong.maximum) END USING ERRCODE = '22023',
            HINT = 'SELECT * FROM streetgen.export_option() explains the options.';
    END IF;
    RETURN (SELECT jsonb_object_agg(e.name, e.value) FROM streetgen.export_option() e WHERE format = ANY (e.formats))
        || options;
END $$;
COMMENT ON FUNCTION streetgen._export_options(text, jsonb) IS
    'The options of a format with the defaults of those that are left out. An unknown one, or a value that it does not '
    'take: 22023.';

CREATE OR REPLACE FUNCTION streetgen._xml_frame(opening text, closing text)
    RETURNS TABLE(rank integer, ref bigint, markup text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES (-1, 0::bigint, '<?xml version="1.0" encoding="UTF-8"?>'), (0, 0, opening), (1000, 0, closing) $$;
COMMENT ON FUNCTION streetgen._xml_frame(text, text) IS
    'The lines of a file of XML before and after its elements, which have ranks from 1 to 999: what opens and closes '
    'its root.';

CREATE OR REPLACE FUNCTION streetgen._begin_export(model name, format text, needs text, options jsonb) RETURNS jsonb
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known jsonb;
    stale bigint;
BEGIN
    PERFORM streetgen._require_reader(model);
    known := streetgen._export_options(format, options);
    IF needs <> ALL (streetgen._subjects(model)) THEN
        RAISE EXCEPTION 'model "%" has no %, which format % needs', model, needs, format USING ERRCODE = '55000',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, %L, true) computes it.', model, needs);
    END IF;
    -- Counting hashes each axis, and is left out where no warning is shown.
    IF current_setting('client_min_messages') <> 'error' THEN
        stale := streetgen._stale_axes(model);
    END IF;
    IF stale > 0 THEN
        RAISE WARNING '% axes of model "%" changed since their streets were computed: they are written as they were, '
            'or left out', stale, model
            USING HINT = format('SELECT * FROM streetgen.generate(%L, wait => true) brings them up to date.', model);
    END IF;
    IF known ->> 'junctions' = 'group' AND 'junction' <> ALL (streetgen._subjects(model)) THEN
        RAISE EXCEPTION 'model "%" has no junction, which option "junctions": "group" needs', model
            USING ERRCODE = '55000',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, ''junction'', true) computes it.', model);
    END IF;
    IF known ? 'junctions' THEN
        known := known || streetgen._joined_places(model, known);
    END IF;
    IF NOT EXISTS (SELECT FROM streetgen._written_edges(model, known)) THEN
        RAISE EXCEPTION 'model "%" has no street to write with options %', model, options USING ERRCODE = '22023',
            HINT = format('SELECT * FROM streetgen.generate(%L) computes the streets of a model; an extent is in its '
                'SRID.', model);
    END IF;
    IF current_setting('client_min_messages') <> 'error' THEN
        PERFORM streetgen._tell_left_out(model, format, known);
    END IF;
    RETURN known;
END $$;
COMMENT ON FUNCTION streetgen._begin_export(name, text, text, jsonb) IS
    'What each writer does first: its options as streetgen._export_options gives them, with what '
    'streetgen._joined_places adds, and a warning that counts what is stale, and others that count what the file '
    'leaves out, unless client_min_messages is error. A caller who may '
    'not read the model: 42501; a model without the subject that the format needs: 55000; no edge that the '
    'options take: 22023.';

-- Functions of each value that is written: bound when made, and thus inlined.
CREATE OR REPLACE FUNCTION streetgen._rounded_coordinates(line geometry, x float8, y float8, digits integer)
    RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME', 'streetgen_rounded_coordinates';
COMMENT ON FUNCTION streetgen._rounded_coordinates(geometry, float8, float8, integer) IS
    'The points of a LINESTRING as x,y x,y … from an origin, with so many digits and none twice in a row. NULL where '
    'one point is left.';

CREATE OR REPLACE FUNCTION streetgen._coordinates(line geometry, x float8, y float8, digits integer,
    tolerance float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._rounded_coordinates(ST_Simplify(line, tolerance, true), x, y, digits);
COMMENT ON FUNCTION streetgen._coordinates(geometry, float8, float8, integer, float8) IS
    'The same of a line that is simplified by a tolerance in metres.';

CREATE OR REPLACE FUNCTION streetgen._stretched(line geometry, metres float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_MakeLine(ST_Translate(middle, -east, -north), ST_Translate(middle, east, north))
    FROM (SELECT ST_LineInterpolatePoint(line, 0.5) AS middle,
        coalesce(ST_Azimuth(ST_StartPoint(line), ST_EndPoint(line)), 0) AS azimuth) m,
        LATERAL (SELECT metres / 2 * sin(azimuth) AS east, metres / 2 * cos(azimuth) AS north) d $$;
COMMENT ON FUNCTION streetgen._stretched(geometry, float8) IS
    'A straight line of that length, metres, about the middle of a line and in its direction.';

-- Few lines are short: the test alone is inlined.
CREATE OR REPLACE FUNCTION streetgen._at_least_long(line geometry, metres float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN ST_Length(line) >= metres THEN line ELSE streetgen._stretched(line, metres) END;
COMMENT ON FUNCTION streetgen._at_least_long(geometry, float8) IS
    'A line; a shorter one is stretched about its middle to that length, metres. netconvert draws lanes of less than '
    '0.1 m anew, which moves them by metres.';

CREATE OR REPLACE FUNCTION streetgen._few(ids bigint[]) RETURNS SETOF bigint
    LANGUAGE internal IMMUTABLE STRICT PARALLEL SAFE ROWS 2 AS 'array_unnest';
COMMENT ON FUNCTION streetgen._few(bigint[]) IS
    'unnest of an array of which the planner expects two elements, as of the lanes of a group. With the usual ten it '
    'parts a join of the lanes of a city into hundreds of files.';

CREATE OR REPLACE FUNCTION streetgen._lane_group_text(edge_id bigint, along_axis boolean, number integer) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- A number beside || makes a call of each row: its text is not immutable there, and the function is not inlined.
    RETURN CASE WHEN along_axis THEN '' ELSE '-' END || edge_id::text
        || CASE WHEN number > 1 THEN '.' || number::text ELSE '' END;
COMMENT ON FUNCTION streetgen._lane_group_text(bigint, boolean, integer) IS
    'The name of a lane group in files: the id of its edge, -id against the axis, with .2 for the second of a '
    'direction.';
