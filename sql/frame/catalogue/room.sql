-- Rooms give to the lists of the frame by functions that are found by their names: the settings of lanes come from
-- streetgen._lane_setting(), the checks from streetgen._check_lane(model).

CREATE OR REPLACE FUNCTION streetgen._traffic_rooms() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog RETURN '{simulation,driving}'::text[];
COMMENT ON FUNCTION streetgen._traffic_rooms() IS 'The rooms whose tables a model with traffic has.';

CREATE OR REPLACE FUNCTION streetgen._rooms() RETURNS text[]
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT '{frame,axis}'::text[] || array_agg(s.subject ORDER BY s.place)
        || '{cross_section,design,source,format}'::text[] || streetgen._traffic_rooms() FROM streetgen._subject() s $$;
COMMENT ON FUNCTION streetgen._rooms() IS
    'The rooms that give something to lists of the frame, in their order: the frame itself, axes, all subjects, '
    'cross-sections, designs, sources, formats, simulation and driving.';

CREATE OR REPLACE FUNCTION streetgen._rooms_of(model name) RETURNS text[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN streetgen._subjects(model) || CASE WHEN streetgen._has_design(model) THEN '{design}'::text[] ELSE '{}' END
        || CASE WHEN streetgen._has_traffic(model) THEN streetgen._traffic_rooms() ELSE '{}' END;
END $$;
COMMENT ON FUNCTION streetgen._rooms_of(name) IS
    'The rooms of which a model has rows: the subjects that it computes, design where it has one, and those of traffic '
    'where it has that.';

CREATE OR REPLACE FUNCTION streetgen._queries_of_rooms(rooms text[], called text, arguments text) RETURNS SETOF text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$ SELECT format('SELECT * FROM streetgen.%I(%s)', name, (SELECT string_agg('$' || a, ', ' ORDER BY a)
            FROM generate_series(1, cardinality(string_to_array(arguments, ', '))) a))
        FROM unnest(rooms) WITH ORDINALITY u(room, n), format(called, room) name
        WHERE to_regprocedure(format('streetgen.%I(%s)', name, arguments)) IS NOT NULL ORDER BY n $$;
COMMENT ON FUNCTION streetgen._queries_of_rooms(text[], text, text) IS
    'The query of the rows that each of some rooms gives by its function of a name such as _%s_named, with $1 and so '
    'on for its arguments, whose types are listed.';

CREATE OR REPLACE FUNCTION streetgen._rows_of_rooms(list text) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT string_agg(query, ' UNION ALL ' ORDER BY n)
        FROM streetgen._queries_of_rooms(streetgen._rooms(), '_%s_' || list, '') WITH ORDINALITY q(query, n) $$;
COMMENT ON FUNCTION streetgen._rows_of_rooms(text) IS
    'The query of all rows that rooms give to a list, by their functions _ROOM_<list>().';

CREATE OR REPLACE FUNCTION streetgen._has_design(model name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT to_regclass(format('%I.design_link', model)) IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._has_design(name) IS 'Does a model have the tables of a design?';

CREATE OR REPLACE FUNCTION streetgen._has_traffic(model name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    RETURN to_regclass(format('%I.car', model)) IS NOT NULL;
COMMENT ON FUNCTION streetgen._has_traffic(name) IS 'Does a model have the tables of traffic?';

CREATE OR REPLACE FUNCTION streetgen._call_rooms(called text, model name, rooms text[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    name name;
BEGIN
    FOR name IN SELECT format(called, room) FROM unnest(rooms) WITH ORDINALITY u(room, n) ORDER BY n LOOP
        IF to_regprocedure(format('streetgen.%I(name)', name)) IS NOT NULL THEN
            EXECUTE format('SELECT streetgen.%I($1)', name) USING model;
        ELSIF to_regprocedure(format('streetgen.%I(name, integer)', name)) IS NOT NULL THEN
            EXECUTE format('SELECT streetgen.%I($1, $2)', name) USING model, srid;
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._call_rooms(text, name, text[]) IS
    'Calls a function of each of some rooms for a model, such as _make_%s_views (model) or _mend_%s_tables (model, '
    'srid), where the room has it.';

CREATE OR REPLACE FUNCTION streetgen._parts_of_rooms(called text, places jsonb) RETURNS text[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    parts text[] := '{}';
    part text;
    name name;
BEGIN
    FOR name IN SELECT format(called, room) FROM unnest(streetgen._rooms()) WITH ORDINALITY u(room, n) ORDER BY n LOOP
        IF to_regprocedure(format('streetgen.%I(jsonb)', name)) IS NOT NULL THEN
            EXECUTE format('SELECT streetgen.%I($1)', name) INTO part USING places;
            parts := parts || part;
        END IF;
    END LOOP;
    RETURN array_remove(parts, NULL);
END $$;
COMMENT ON FUNCTION streetgen._parts_of_rooms(text, jsonb) IS
    'The pieces of the one statement that rooms give by their functions of a name such as _%s_arguments (places), in '
    'the order of the rooms; NULL is none.';
