-- Decisions that follow their axes are written back: one UPDATE for each table, which its anchor and its room compose.

CREATE OR REPLACE FUNCTION streetgen._end_now(former text, line geometry, place geometry, redrawn boolean,
    turned boolean, OUT which text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN redrawn OR nearer_end = 0 AND NOT turned THEN former
        WHEN nearer_end = 0 THEN streetgen._swapped(former, 'start', 'end', true)
        WHEN nearer_end < 0 THEN 'start' ELSE 'end' END
    FROM (SELECT ST_Distance(streetgen._end_of(line, 'start'), place)
        - ST_Distance(streetgen._end_of(line, 'end'), place) AS nearer_end) d
    $$;
COMMENT ON FUNCTION streetgen._end_now(text, geometry, geometry, boolean, boolean) IS
    'The end of a line, start or end, that a decision is about: the nearer one, the same where the line was redrawn, '
    'and where both are as near the same along the line as it was.';

CREATE OR REPLACE FUNCTION streetgen._via_now(decisions streetgen.placed_decision[], relation text, id bigint,
    via_axes bigint[], via_geom geometry, OUT axes bigint[], OUT geom geometry)
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT array_agg(coalesce(f.axis_id, u.axis_id) ORDER BY u.i),
        -- On its axis redrawn: beside where it was, else as far along the line as before.
        ST_Collect(CASE WHEN f.redrawn IS NOT TRUE THEN p.geom
            WHEN streetgen._remap_lies_beside(f.line, p.geom) THEN ST_ClosestPoint(f.line, p.geom)
            ELSE ST_LineInterpolatePoint(f.line, ST_LineLocatePoint(f.before, p.geom)) END ORDER BY u.i)
    FROM unnest(via_axes) WITH ORDINALITY u(axis_id, i) CROSS JOIN LATERAL ST_GeometryN(via_geom, u.i::integer) p(geom)
        LEFT JOIN unnest(decisions) f ON (f.relation, f.override_id, f.role)
            = (_via_now.relation, id, 'via_axis ' || u.i)
    $$;
COMMENT ON FUNCTION streetgen._via_now(streetgen.placed_decision[], text, bigint, bigint[], geometry) IS
    'The axes via which a turn leads now, and a place on each; NULL where it leads via none.';

CREATE OR REPLACE FUNCTION streetgen._anchor_follows(anchor text, axes name[], attributes name[]) RETURNS jsonb
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN anchor IN ('node', 'route') THEN jsonb_build_object(
            'geom', 'ST_Translate(o.geom, n.east, n.north)',
            axes[1], format('coalesce(n.first_axis, o.%I)', axes[1]),
            axes[2], format('coalesce(n.second_axis, o.%I)', axes[2]))
        ELSE jsonb_build_object(axes[1], 'n.axis_id')
            || CASE WHEN 'abscissa' = ANY (attributes) THEN '{"abscissa": "n.abscissa"}'::jsonb ELSE '{}' END
            || CASE WHEN anchor IN ('along', 'vertex') THEN '{"geom": "n.geom"}'::jsonb ELSE '{}' END END
        || CASE anchor
            WHEN 'end' THEN '{"which": "e.which",
                "geom": "ST_SetSRID(streetgen._end_of(n.line, e.which), ST_SRID(n.line))"}'::jsonb
            WHEN 'route' THEN '{"to_geom": "ST_Translate(o.to_geom, n.to_east, n.to_north)", "via_axes": "v.axes",
                "via_geom": "v.geom"}' ELSE '{}' END $$;
COMMENT ON FUNCTION streetgen._anchor_follows(text, name[], name[]) IS
    'The columns of a table of decisions that follow its axes by their anchor, with their new values as SQL.';

CREATE OR REPLACE FUNCTION streetgen._anchor_rows(anchor text, relation name) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN anchor IN ('node', 'route') THEN 'unnest(node_decisions) n' ELSE 'unnest(decisions) n' END
        || format(' JOIN %I o ON o.%I = n.override_id', relation, relation || '_id')
        -- An axis that is drawn over the place, or far away from it, leaves the decision as it is.
        || CASE anchor WHEN 'beside' THEN ' AND ST_Distance(n.line, n.place) BETWEEN 0.0005 AND 100'
            WHEN 'end' THEN ' CROSS JOIN LATERAL streetgen._end_now(o.which, n.line, n.place, n.redrawn, '
                'n.turned) e'
            WHEN 'route' THEN format(' CROSS JOIN LATERAL streetgen._via_now(decisions, %L, n.override_id, o.via_axes, '
                'o.via_geom) v', relation) ELSE '' END $$;
COMMENT ON FUNCTION streetgen._anchor_rows(text, name) IS
    'The rows of a table of decisions with where they are now, as SQL.';

CREATE OR REPLACE FUNCTION streetgen._write_decisions_of(relation name, key name, anchor text, follows jsonb)
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT format('IF %1$L = ANY (relations) THEN UPDATE %1$I o SET %2$s FROM (SELECT o.%3$I, %4$s FROM %5$s '
        'WHERE n.relation = %1$L) n WHERE o.%3$I = n.%3$I AND (%6$s) IS DISTINCT FROM (%7$s); END IF;', relation,
        string_agg(format('%I = n.%1$I', attribute), ', '), key,
        string_agg(format('%s AS %I', value, attribute), ', '), streetgen._anchor_rows(anchor, relation),
        string_agg(format('o.%I', attribute), ', '), string_agg(format('n.%I', attribute), ', '))
    FROM jsonb_each_text(follows) f(attribute, value) $$;
COMMENT ON FUNCTION streetgen._write_decisions_of(name, name, text, jsonb) IS
    'The statement that writes the decisions of a table back, where it is among relations.';

CREATE OR REPLACE FUNCTION streetgen._make_written_decisions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._compose_function(model, '_write_decisions(decisions streetgen.placed_decision[], '
        'node_decisions streetgen.node_decision[])', 'void', (SELECT format('DECLARE relations constant text[] := '
            'ARRAY(SELECT relation FROM unnest(decisions) UNION SELECT relation FROM unnest(node_decisions)); '
            'BEGIN %s END',
            string_agg(streetgen._write_decisions_of(relation, key, anchor,
                streetgen._anchor_follows(anchor, axes, attributes) || follows), ' ' ORDER BY n))
        FROM streetgen._decisions_of(model) WHERE axes <> '{}'),
        '_write_decisions(streetgen.placed_decision[], streetgen.node_decision[])',
        'Writes decisions by hand with the axes and places that they have now');
END $$;
COMMENT ON FUNCTION streetgen._make_written_decisions(name) IS
    'Makes the function of a model that writes decisions by hand where they lie now.';
