-- The quickest way from link to link, by pgRouting.

CREATE OR REPLACE FUNCTION streetgen._require_routing() RETURNS name
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    schema constant name := (SELECT n.nspname FROM pg_extension e JOIN pg_namespace n ON n.oid = e.extnamespace
        WHERE e.extname = 'pgrouting');
BEGIN
    IF schema IS NULL THEN
        RAISE EXCEPTION 'a route needs extension pgrouting' USING ERRCODE = '0A000',
            HINT = CASE WHEN EXISTS (SELECT FROM pg_available_extensions a WHERE a.name = 'pgrouting') THEN ''
                ELSE format('On the server: apt-get install postgresql-%s-pgrouting. ',
                    current_setting('server_version_num')::integer / 10000) END
                || 'In this database: CREATE EXTENSION pgrouting.';
    END IF;
    RETURN schema;
END $$;
COMMENT ON FUNCTION streetgen._require_routing() IS
    'The schema of extension pgrouting. Raises 0A000 with the commands that install it where it is missing.';

CREATE OR REPLACE FUNCTION streetgen._route_of(model name, from_link bigint, to_link bigint, kind text)
    RETURNS TABLE(ordinality integer, link_id bigint, seconds float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 50 SET search_path = pg_catalog, public
    AS $$
DECLARE
    schema name;
    unknown bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('from_link', from_link::text, 'to_link',
        to_link::text, 'kind', kind), streetgen._require_subject(model, 'interconnection');
    IF kind NOT IN ('car', 'bus', 'carpool', 'cycle') THEN
        RAISE EXCEPTION 'kind is "%", expected car, bus, carpool or cycle', kind USING ERRCODE = '22023',
            HINT = 'Lanes are for all, or for some of these alone.';
    END IF;
    unknown := (SELECT asked FROM unnest(ARRAY[from_link, to_link]) asked
        WHERE asked <> ALL (streetgen._links_there(model, ARRAY[from_link, to_link])) LIMIT 1);
    IF unknown IS NOT NULL THEN
        RAISE EXCEPTION 'there is no link %', unknown USING ERRCODE = '22023',
            HINT = 'View link of the model lists them.';
    END IF;
    schema := streetgen._require_routing();
    -- Functions of pgRouting call each other without a schema.
    PERFORM set_config('search_path', current_setting('search_path') || ', ' || quote_ident(schema), true);
    IF from_link = to_link THEN
        RETURN QUERY SELECT 1, from_link, 0::float8;
        RETURN;
    END IF;
    RETURN QUERY EXECUTE concat('SELECT path_seq, node, agg_cost FROM ', quote_ident(schema),
            '.pgr_dijkstra($1, $2, $3)')
        USING streetgen._fill_template(streetgen._part('route_way'),
            jsonb_build_object('kind', quote_literal(kind), 'from_link', from_link)), from_link, to_link;
END $$;
COMMENT ON FUNCTION streetgen._route_of(name, bigint, bigint, text) IS 'What streetgen.route gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.route(model name, from_link bigint, to_link bigint, kind text DEFAULT 'car')
    RETURNS TABLE(ordinality integer, link_id bigint, seconds float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 50 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._route_of($1, $2, $3, $4) $$;
COMMENT ON FUNCTION streetgen.route(name, bigint, bigint, text) IS
    'The quickest way from the start of a link to another one at the speed limits, both included: each link follows '
    'the one before, or lies beside it where one may change lanes, which counts as 5 seconds. seconds: until one '
    'comes to the link. kind: car, bus, carpool or cycle, which keeps to links where it may drive. No way: no row. '
    'Extension pgrouting finds it; without it 0A000 with the commands that install it. An unknown link or kind: '
    '22023; NULL: 22004; a model without subject interconnection: 55000; an unknown model: 3F000; not a reader of '
    'the model: 42501. Dijkstra 1959.';
