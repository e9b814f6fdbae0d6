-- The one statement, what it reads: axes with what is decided by hand, and what was there before the change.

CREATE OR REPLACE FUNCTION streetgen._numbers_sent(numbers float8[]) RETURNS bytea
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT string_agg(float8send(number), '' ORDER BY place) FROM unnest(numbers) WITH ORDINALITY
        n(number, place) $$;
COMMENT ON FUNCTION streetgen._numbers_sent(float8[]) IS 'The bytes of numbers, as a former edge has them.';

CREATE OR REPLACE FUNCTION streetgen._upsert_former(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('former'), places) $$;
COMMENT ON FUNCTION streetgen._upsert_former(jsonb) IS
    'Part of the one statement: former_edge and former_node, the written edges, their nodes and the surfaces of '
    'both before the change.';

CREATE OR REPLACE FUNCTION streetgen._upsert_input(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._upsert_former(places), streetgen._fill_template(streetgen._part('input'),
            places || jsonb_build_object('subjects', (SELECT string_agg(s, ',')
                FROM jsonb_array_elements_text(places -> 'subjects') s),
            'arguments', array_to_string(streetgen._parts_of_rooms('_%s_arguments', places), E',\n        ')))) $$;
COMMENT ON FUNCTION streetgen._upsert_input(jsonb) IS
    'Part of the one statement: settings, the axes used, and the streets computed from them (computed.streets).';
