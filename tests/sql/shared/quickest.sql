-- pg_temp.quickest(MODEL, ORIGINS): seconds from some links to all that one comes to, as streetgen.route
-- counts them, by a search in plain SQL on the same ways.
CREATE FUNCTION pg_temp.quickest(model name, origins bigint[])
    RETURNS TABLE(origin bigint, link bigint, seconds float8) LANGUAGE plpgsql AS $f$
BEGIN
    PERFORM set_config('search_path', quote_ident(model) || ', public', true);
    EXECUTE 'CREATE TEMPORARY TABLE way AS ' || streetgen._fill_template(streetgen._part('route_way'),
        '{"kind": "''car''", "from_link": 0}');
    CREATE INDEX ON way (source);
    CREATE TEMPORARY TABLE reached (origin bigint, link bigint, cost float8, fresh boolean, PRIMARY KEY (origin, link));
    INSERT INTO reached SELECT o, o, 0, true FROM unnest(origins) o;
    -- Whoever got nearer tells those behind, until nobody does.
    WHILE EXISTS (SELECT FROM reached WHERE fresh) LOOP
        CREATE TEMPORARY TABLE nearer AS SELECT r.origin, w.target AS link, min(r.cost + w.cost) AS cost
            FROM reached r JOIN way w ON w.source = r.link WHERE r.fresh GROUP BY 1, 2;
        UPDATE reached SET fresh = false WHERE fresh;
        INSERT INTO reached AS r SELECT n.origin, n.link, n.cost, true FROM nearer n
            ON CONFLICT ON CONSTRAINT reached_pkey DO UPDATE SET cost = excluded.cost, fresh = true WHERE r.cost > excluded.cost;
        DROP TABLE nearer;
    END LOOP;
    RETURN QUERY SELECT r.origin, r.link, r.cost FROM reached r;
    DROP TABLE reached, way;
END $f$;
