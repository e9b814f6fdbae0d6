\set ECHO none
\ir shared/truths.sql
-- Every construction from SQL. Each test is a row (name, holds).

SELECT 'arc_centre: a square corner', ST_DWithin(streetgen.arc_centre('LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 6, 6, 4), 'POINT(7 7)', 1e-9);
SELECT 'corner_arc: a true arc of the wanted radius', abs(ST_Length(streetgen.corner_arc('LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 6, 6, 4)) - 2 * pi()) < 1e-9;
SELECT 'corner_arc: none where one axis lies within the other', streetgen.corner_arc('LINESTRING(0 0,30 0)', 'LINESTRING(0 0,10 0.3)', 20, 4, 5) IS NULL;
SELECT 'max_corner_radius: the derived one', abs(streetgen.max_corner_radius('LINESTRING(0 0,30 0)', 'LINESTRING(0 0,0 300)', 6, 8) - 26) < 1e-5;
SELECT 'border_line: from the left kerb to the right', ST_Equals(streetgen.border_line('LINESTRING(0 0,10 0)', 4, 6), 'LINESTRING(4 3,4 -3)');
SELECT 'section_surface: length times width', abs(ST_Area(streetgen.section_surface('LINESTRING(0 0,50 0)', 7, 10, 40)) - 210) < 1e-9;
SELECT 'intersection_surface: curved equals the straight one but for its chords', abs(ST_Area(streetgen.intersection_surface(a, '{6,6,6}', '{4,4,4}', true)) - ST_Area(streetgen.intersection_surface(a, '{6,6,6}', '{4,4,4}'))) < 0.2
    FROM (SELECT ARRAY['LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 'LINESTRING(0 0,-50 0)']::geometry[] AS a) s;
SELECT 'intersection_surface: curved is a curve polygon', ST_HasArc(streetgen.intersection_surface(ARRAY['LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 'LINESTRING(0 0,-50 0)']::geometry[], '{6,6,6}', '{4,4,4}', true));
SELECT 'variable_buffer: a trapezoid', abs(ST_Area(streetgen.variable_buffer('LINESTRING(0 0,20 0)', '{2,5}')) - 140) < 1e-9;
SELECT 'variable_buffer: one side', abs(ST_Area(streetgen.variable_buffer('LINESTRING(0 0,20 0)', '{2,5}', 'left')) - 70) < 1e-9;
SELECT 'offset_strip: a trapezoid', abs(ST_Area(streetgen.offset_strip('LINESTRING(0 0,20 0)', 2, 5)) - 70) < 1e-9;
SELECT 'offset_strip: on the left', ST_Contains(streetgen.offset_strip('LINESTRING(0 0,20 0)', 2, 2), 'POINT(10 1)');
SELECT 'offset_strip: a quarter of a ring behind an arc', abs(ST_Area(streetgen.offset_strip('COMPOUNDCURVE(CIRCULARSTRING(-5 0,-3.5355339 3.5355339,0 5),(0 5,10 5))', 2, 2)) - (pi() / 4 * 24 + 20)) < 24 * acos(1 - 0.001 / 5);
SELECT 'offset_strip: empty without a width', ST_IsEmpty(streetgen.offset_strip('LINESTRING(0 0,20 0)', 0, 0));
SELECT 'crossing_surface: width times distance through the sine, at ' || angle, abs(ST_Area(streetgen.crossing_surface('LINESTRING(0 0,99 0)', 'LINESTRING(0 4,99 4)', 'LINESTRING(99 -3,0 -3)', 50, 3, angle)) - 3 * 7 / sin(radians(angle))) < 1e-9
    FROM unnest(ARRAY[20, 60, 90, 150]) angle;
SELECT 'crossing_surface: a curved kerb is followed', abs(ST_Area(streetgen.crossing_surface('LINESTRING(0 0,99 0)', 'CIRCULARSTRING(40 14,50 4,60 14)', 'LINESTRING(0 -3,99 -3)', 50, 4)) - (68 - 2 * sqrt(96.0::float8) - 100 * asin(0.2))) < 0.01;
SELECT 'crossing_surface: NULL without a kerb within ten widths', streetgen.crossing_surface('LINESTRING(0 0,99 0)', 'LINESTRING(0 31,99 31)', 'LINESTRING(0 -3,99 -3)', 50, 3) IS NULL;
SELECT 'turning_radius: equation 1', abs(streetgen.turning_radius(20, 7) - 18.6 * sqrt(20.0 / (10 * 3.5 + 65 - 20))) < 0.01;
SELECT 'turning_radius: never beyond 15 m', streetgen.turning_radius(130, 7) = 15;
SELECT 'clean: drops what is collinear, keeps what is kept', ST_AsText(streetgen.clean('LINESTRING(0 0,10 0,20 0,40 0)', '{f,f,t,f}', 0.3, 3)) = 'LINESTRING(0 0,20 0,40 0)';
SELECT 'interconnection: its ends are exact: ' || rule, ST_StartPoint(path) = 'POINT(2 -10)'::geometry AND ST_EndPoint(path) = 'POINT(10 -2)'::geometry
    FROM unnest(ARRAY['bezier', 'arcs', 'control']) rule, streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT(0 0)', rule) path;
SELECT 'interconnection: the middle of the Bezier curve', ST_DWithin(streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT(0 0)', 'bezier', 0.001), 'POINT(3.5 -3.5)', 0.001);
SELECT 'interconnection: the middle of the curve with a given control point', ST_DWithin(streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT(2 -2)', 'control', 0.001), 'POINT(4 -4)', 0.001);
SELECT 'interconnection: arcs of the radius that fits', ST_DWithin(streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT(0 0)', 'arcs', 0.001), ST_MakePoint(10 - 8 * sqrt(0.5), -10 + 8 * sqrt(0.5)), 0.001);
SELECT 'the SRID stays', ST_SRID(streetgen.section_surface('SRID=2154;LINESTRING(0 0,50 0)', 7, 10, 40)) = 2154;

SELECT 'bad input is 22023: ' || statement, test.state(statement) = '22023' FROM (VALUES
    ($$SELECT streetgen.section_surface('LINESTRING(0 0,50 0)', 'NaN', 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING(0 0,50 0)', 'infinity', 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING(0 0,50 0)', -1, 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING(0 0,50 0)', 0, 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING(0 0,50 0)', 201, 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING(0 0,50 0)', 7, 'NaN', 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING EMPTY', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING(5 5,5 5)', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface('POINT(5 5)', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface('POLYGON((0 0,1 0,1 1,0 0))', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface('CIRCULARSTRING(0 0,1 1,2 0)', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface('LINESTRING M(0 0 1,50 0 2)', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface('MULTILINESTRING((0 0,50 0),(0 9,5 9))', 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface(ST_MakeLine(ST_MakePoint(0, 0), ST_MakePoint('NaN', 1)), 7, 0, 10)$$),
    ($$SELECT streetgen.section_surface(ST_MakeLine(ST_MakePoint(0, 0), ST_MakePoint('Infinity', 1)), 7, 0, 10)$$),
    ($$SELECT streetgen.arc_centre('SRID=2154;LINESTRING(0 0,50 0)', 'SRID=32631;LINESTRING(0 0,0 50)', 6, 6, 4)$$),
    ($$SELECT streetgen.arc_centre('LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 6, 6, 'NaN')$$),
    ($$SELECT streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT EMPTY')$$),
    ($$SELECT streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'LINESTRING(0 0,1 1)')$$),
    ($$SELECT streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,10 -2)', 'POINT(0 0)')$$),
    ($$SELECT streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT(0 0)', 'spline')$$),
    ($$SELECT streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'POINT(0 0)', 'arcs', 'NaN')$$),
    ($$SELECT streetgen.interconnection('LINESTRING(2 -50,2 -10)', 'LINESTRING(10 -2,50 -2)', 'SRID=2154;POINT(0 0)')$$),
    ($$SELECT streetgen.offset_strip('POINT(0 0)', 2, 2)$$), ($$SELECT streetgen.offset_strip('LINESTRING(0 0,20 0)', 'NaN', 2)$$),
    ($$SELECT streetgen.offset_strip('LINESTRING(0 0,20 0)', 2, -1)$$), ($$SELECT streetgen.offset_strip('LINESTRING(5 5,5 5)', 2, 2)$$),
    ($$SELECT streetgen.crossing_surface('LINESTRING(0 0,99 0)', 'LINESTRING(0 4,99 4)', 'LINESTRING(0 -3,99 -3)', 50, 'NaN')$$),
    ($$SELECT streetgen.crossing_surface('LINESTRING(0 0,99 0)', 'LINESTRING(0 4,99 4)', 'LINESTRING(0 -3,99 -3)', 50, 3, 5)$$),
    ($$SELECT streetgen.crossing_surface('LINESTRING(0 0,99 0)', 'SRID=2154;LINESTRING(0 4,99 4)', 'LINESTRING(0 -3,99 -3)', 50, 3)$$),
    ($$SELECT streetgen.turning_radius('NaN', 7)$$), ($$SELECT streetgen.turning_radius(30, 7, 'guess')$$),
    ($$SELECT streetgen.variable_buffer('LINESTRING(0 0,20 0)', '{2}')$$), ($$SELECT streetgen.variable_buffer('LINESTRING(0 0,20 0)', '{2,5}', 'top')$$),
    ($$SELECT streetgen.intersection_surface(ARRAY['LINESTRING(0 0,50 0)']::geometry[], '{6,6}', '{4}')$$)) s(statement);
SELECT 'coordinates of 1e9 give a result', abs(ST_Area(streetgen.section_surface('LINESTRING(1000000000 1000000000,1000000050 1000000000)', 7, 10, 40)) - 210) < 1e-3;
SELECT 'a NULL in a list is 22004', test.state($$SELECT streetgen.variable_buffer('LINESTRING(0 0,20 0)', ARRAY[2, NULL]::float8[])$$) = '22004';

-- The catalogue.
SELECT 'every function has a comment: ' || coalesce(string_agg(p.oid::regprocedure::text, ', '), 'all'), count(*) = 0
    FROM pg_proc p WHERE pronamespace = 'streetgen'::regnamespace AND obj_description(p.oid, 'pg_proc') IS NULL;
SELECT 'every function pins its search_path or is bound when made: ' || coalesce(string_agg(p.oid::regprocedure::text, ', '), 'all'), count(*) = 0
    FROM pg_proc p JOIN pg_language l ON l.oid = p.prolang
    WHERE pronamespace = 'streetgen'::regnamespace AND lanname IN ('plpgsql', 'sql') AND prosqlbody IS NULL AND NOT coalesce(array_to_string(proconfig, ',') ~ 'search_path', false)
      AND p.oid <> 'streetgen._use_model'::regproc -- which sets that of its caller
      AND NOT (prokind = 'p' AND prosrc ~ 'COMMIT'); -- which PostgreSQL refuses under a pinned one: all that it names is qualified
SELECT 'of which the temporary schema is last: ' || coalesce(string_agg(p.oid::regprocedure::text, ', '), 'all'), count(*) = 0
  FROM pg_proc p, unnest(proconfig) said WHERE pronamespace = 'streetgen'::regnamespace AND said LIKE 'search_path=%' AND said NOT LIKE '%, pg_temp';
-- A procedure that commits has no SET: it calls functions that do.
SELECT format('%s: %s', CASE WHEN takes_model THEN 'queries of a model are run, not compiled' ELSE 'what computes with its arguments says nothing of compiling' END,
    coalesce(string_agg(signature, ', ' ORDER BY signature) FILTER (WHERE takes_model <> says_so), 'all')), bool_and(takes_model = says_so) AND count(*) > 40
  FROM (SELECT oid::regprocedure::text AS signature, coalesce(proargtypes[0] = 'name'::regtype, false) AS takes_model, coalesce('jit=off' = ANY (proconfig), false) AS says_so FROM pg_proc
      WHERE pronamespace = 'streetgen'::regnamespace AND proname !~ '^_' AND prokind = 'f' AND prorettype <> 'trigger'::regtype) f GROUP BY takes_model ORDER BY 1;
SELECT 'version is that of the extension', streetgen.version() = (SELECT extversion FROM pg_extension WHERE extname = 'streetgen');

-- Nothing leaks: ten thousand calls, errors included.
CREATE FUNCTION pg_temp.resident_kb() RETURNS bigint LANGUAGE sql AS $$ SELECT substring(pg_read_file('/proc/self/status') FROM 'VmRSS:\s+(\d+)')::bigint $$;
CREATE TEMPORARY TABLE memory AS SELECT 0::bigint AS kb;
DO $$
BEGIN
    FOR i IN 1..2000 LOOP
        PERFORM streetgen.intersection_surface(ARRAY['LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 'LINESTRING(0 0,-50 0)']::geometry[], '{6,6,6}', '{4,4,4}');
    END LOOP;
    UPDATE memory SET kb = pg_temp.resident_kb();
    FOR i IN 1..10000 LOOP
        PERFORM streetgen.intersection_surface(ARRAY['LINESTRING(0 0,50 0)', 'LINESTRING(0 0,0 50)', 'LINESTRING(0 0,-50 0)']::geometry[], '{6,6,6}', '{4,4,4}');
        BEGIN
            PERFORM streetgen.section_surface('LINESTRING(0 0,50 0)', 'NaN', 0, 10);
        EXCEPTION WHEN invalid_parameter_value THEN NULL;
        END;
    END LOOP;
END $$;
SELECT 'ten thousand calls and errors grow the backend by less than 5 MB', pg_temp.resident_kb() - kb < 5 * 1024 FROM memory;

