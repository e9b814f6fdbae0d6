-- The view override_place of a model: where each decision lies, and the axes that it names.

CREATE OR REPLACE FUNCTION streetgen._override_places(relation name, key name, anchor text, axes name[], reach text,
    abscissa text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT string_agg(format('SELECT %L::text AS relation, %I AS override_id, %s AS role, %s AS axis_id, %s AS geom, '
        '(%s)::float8 AS reach, %s::float8 AS abscissa, %L::text AS anchor, %s::integer AS ordinality, '
        '%s AS next_axis FROM %s', relation, key, p.role, p.axis, p.geom, streetgen._fill_template(reach,
            '{"tolerance": "(SELECT value::float8 FROM setting WHERE name = ''tolerance'')"}'), abscissa,
        p.anchor, p.place, p.next_axis, p.rows), ' UNION ALL ' ORDER BY p.turn)
    FROM (SELECT i AS turn, quote_literal(axis) || '::text' AS role, quote_ident(axis) AS axis,
            CASE WHEN anchor = 'route' AND i = 2 THEN 'coalesce(to_geom, geom)' ELSE 'geom' END AS geom,
            CASE anchor WHEN 'route' THEN 'node' ELSE anchor END AS anchor, i::text AS place,
            CASE WHEN anchor <> 'route' THEN 'NULL::bigint' WHEN i = 1 THEN 'via_axes[1]'
                ELSE 'via_axes[cardinality(via_axes)]' END AS next_axis, quote_ident(relation) AS rows
        FROM unnest(axes) WITH ORDINALITY u(axis, i)
        UNION ALL SELECT 3, '''via_axis '' || v.i', 'v.axis_id', 'ST_GeometryN(via_geom, v.i::integer)', 'via', 'v.i',
            'NULL::bigint', format('%I, unnest(via_axes) WITH ORDINALITY v(axis_id, i) WHERE via_axes IS NOT NULL',
                relation)
        WHERE anchor = 'route') p $$;
COMMENT ON FUNCTION streetgen._override_places(name, name, text, name[], text, text) IS
    'The query of the places of the decisions of a table: a row for each column that names an axis. abscissa: that of '
    'the row, as SQL. Nodes of a route have anchor node, the axes between them via.';

CREATE OR REPLACE FUNCTION streetgen._make_override_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE 'CREATE OR REPLACE VIEW override_place WITH (security_invoker = true) AS ' || (
        SELECT string_agg(streetgen._override_places(relation, key, anchor, axes, reach,
            CASE WHEN 'abscissa' = ANY (attributes) THEN 'abscissa' ELSE 'NULL' END), ' UNION ALL ' ORDER BY n)
        FROM streetgen._decisions_of(model) WHERE axes <> '{}');
    COMMENT ON VIEW override_place IS
        'Where each decision by hand lies, and the axes that it names, a row for each of them';
    COMMENT ON COLUMN override_place.relation IS 'table of the override';
    COMMENT ON COLUMN override_place.override_id IS 'its key there';
    COMMENT ON COLUMN override_place.role IS 'column that names the axis';
    COMMENT ON COLUMN override_place.axis_id IS 'the axis';
    COMMENT ON COLUMN override_place.geom IS 'place on the axis, beside it or of the node';
    COMMENT ON COLUMN override_place.reach IS 'an axis within this distance lies at the place, metres';
    COMMENT ON COLUMN override_place.abscissa IS 'metres along the axis; NULL for what lies at an end or a node';
    COMMENT ON COLUMN override_place.anchor IS 'along, vertex, end or beside an axis; node or via of a turn; or ground';
    COMMENT ON COLUMN override_place.ordinality IS 'of axes that meet at a node: first or second; of those via: which';
    COMMENT ON COLUMN override_place.next_axis IS 'axis via which a turn goes on from the node; NULL: there is none';
END $$;
COMMENT ON FUNCTION streetgen._make_override_view(name) IS
    'Makes the view override_place of a model from its tables of decisions.';
