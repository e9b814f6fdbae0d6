-- Decisions by hand find their axes again after a split, merge, reversal or redraw.

-- Every statement begins so; $1: the changed axes, $2, $3: their lines before and after, NULL where there was or is
-- none.
CREATE OR REPLACE FUNCTION streetgen._remap_places(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format($sql$
WITH changed AS MATERIALIZED (SELECT axis_id, ST_Force2D(before) AS before, ST_Force2D(after) AS after
    FROM unnest($1, $2, $3) c(axis_id, before, after)),
tolerance AS MATERIALIZED (SELECT value::float8 AS value FROM %1$I.setting WHERE name = 'tolerance'),
place AS MATERIALIZED (
    SELECT p.*, c.before, c.after, c.axis_id IS NOT NULL AS named, r.via_axes,
        p.relation IN ('interconnection_override', 'turn_restriction', 'corner_override', 'overpass_override')
            AND p.role NOT LIKE 'via_axis %%' AS at_node,
        CASE WHEN p.role = 'to_axis' AND r.via_axes IS NOT NULL THEN 'to_geom' ELSE 'geom' END AS node,
           (SELECT ST_Force2D(a.geom) FROM %1$I.axis a WHERE a.axis_id = p.axis_id) AS line
    FROM %1$I.override_place p LEFT JOIN changed c USING (axis_id) LEFT JOIN %1$I.turn_restriction r
        ON p.relation = 'turn_restriction' AND r.turn_restriction_id = p.override_id
    WHERE p.geom && ST_Expand((SELECT ST_Extent(line)::geometry FROM unnest($2 || $3) line), CASE p.relation
        WHEN 'kerb_point_override' THEN 110 ELSE 30 END)),
-- The axes that meet at each node of a decision. A restriction via axes has two nodes, at either end of these axes.
meeting AS MATERIALIZED (
    SELECT relation, override_id, node, role, axis_id, before, after, geom, reach FROM place WHERE at_node
    UNION ALL SELECT p.relation, p.override_id, p.node, p.role, v.axis_id, c.before, c.after, p.geom, p.reach
    FROM place p CROSS JOIN LATERAL (SELECT p.via_axes[CASE p.node WHEN 'geom' THEN 1
            ELSE cardinality(p.via_axes) END]) v(axis_id) LEFT JOIN changed c ON c.axis_id = v.axis_id
    WHERE p.at_node AND p.via_axes IS NOT NULL),
-- The node was moved: the axes that met there no longer do, and all meet at the new place of a vertex that was there.
moved AS MATERIALIZED (
    SELECT DISTINCT ON (relation, override_id, node) relation, override_id, node, v.geom AS new_place,
           (SELECT d.geom FROM ST_DumpPoints(p.before) d ORDER BY ST_Distance(d.geom, p.geom), d.path LIMIT 1)
               AS old_place
    FROM meeting p CROSS JOIN tolerance t CROSS JOIN LATERAL streetgen._moved_vertex(p.before, p.after, p.geom,
        p.reach) v(geom)
    WHERE EXISTS (SELECT FROM meeting o WHERE (o.relation, o.override_id, o.node) = (p.relation, p.override_id, p.node)
            AND NOT EXISTS (SELECT FROM %1$I.axis a WHERE a.axis_id = o.axis_id
                AND ST_DWithin(a.geom, p.geom, p.reach)))
        AND NOT streetgen._remap_is_cut_back(p.before, p.after, t.value)
        AND NOT EXISTS (SELECT FROM meeting o
            WHERE (o.relation, o.override_id, o.node) = (p.relation, p.override_id, p.node)
                        AND NOT EXISTS (SELECT FROM %1$I.axis a WHERE a.axis_id = o.axis_id
                            AND ST_DWithin(a.geom, v.geom, o.reach)))
    ORDER BY relation, override_id, node, role, axis_id),
-- Which axis each is on now: its own, if that still lies there (1); one that came by (2); the one that took its line
-- over (3); its own, redrawn and
-- neither cut back nor, for an end, made longer (4).
heir AS (
    SELECT p.*, a.axis_id AS heir, ST_Force2D(a.geom) AS heir_line,
           CASE WHEN a.axis_id = p.axis_id THEN 1 WHEN c.axis_id IS NOT NULL
               AND streetgen._remap_comes_by(p.relation, c.before, c.after, p.geom, p.reach) THEN 2
                -- A control point on a node stands on all the axes that meet there.
                WHEN p.before IS NOT NULL AND p.line IS NULL AND (p.relation = 'control_point'
                    OR ST_DWithin(a.geom, streetgen._remap_point_beside(p.before, p.geom), t.value)) THEN 3 END AS turn
    FROM place p CROSS JOIN tolerance t JOIN %1$I.axis a ON ST_DWithin(a.geom, p.geom, p.reach)
        LEFT JOIN changed c ON c.axis_id = a.axis_id
    WHERE ST_DWithin(streetgen._remap_part_of_axis(p.relation, ST_Force2D(a.geom)), p.geom, p.reach)
    UNION ALL SELECT p.*, p.axis_id, p.after, 4 FROM place p CROSS JOIN tolerance t
    WHERE NOT p.at_node AND ST_DWithin(streetgen._remap_part_of_axis(p.relation, p.before), p.geom, p.reach)
        AND NOT streetgen._remap_is_cut_back(p.before, p.after, t.value)
        AND CASE p.relation WHEN 'transition_override' THEN NOT streetgen._remap_is_cut_back(p.after, p.before, t.value)
            WHEN 'turn_restriction' THEN true ELSE streetgen._remap_lies_beside(p.after, p.geom) END),
found AS MATERIALIZED (
    SELECT relation, override_id, role, geom, heir AS axis_id, heir_line AS line, turn = 4 AS redrawn, before,
        streetgen._remap_runs_against(before, heir_line, geom) AS turned FROM (
        SELECT DISTINCT ON (relation, override_id, role) * FROM heir h
        WHERE turn IN (1, 4) OR turn IS NOT NULL
            AND NOT EXISTS (SELECT FROM place o
            WHERE (o.relation, o.override_id, o.axis_id) = (h.relation, h.override_id, h.heir) AND o.role <> h.role)
        ORDER BY relation, override_id, role, turn, ST_Distance(heir_line, geom), heir) h
    WHERE (named OR turn > 1) AND NOT (at_node AND EXISTS (SELECT FROM moved m
        WHERE (m.relation, m.override_id, m.node) = (h.relation, h.override_id, h.node))))
$sql$, model) $$;
COMMENT ON FUNCTION streetgen._remap_places(name) IS
    'The beginning of the statements of _remap_statement: the CTEs moved (nodes of overrides that are elsewhere) and '
    'found (which axis each override near changed axes is on).';

CREATE OR REPLACE FUNCTION streetgen._remap_statement(model name, relation name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._remap_places(model) || format(CASE relation
        WHEN 'transition_override' THEN $sql$,
new AS (
    SELECT o.transition_override_id AS id, f.axis_id, w.which, ST_SetSRID(streetgen._end_of(f.line, w.which),
        ST_SRID(f.line)) AS geom,
           CASE WHEN w.which = o.which THEN o.kind ELSE CASE o.kind WHEN 'left' THEN 'right' WHEN 'right' THEN 'left'
               ELSE o.kind END END AS kind
    FROM found f JOIN %1$I.transition_override o ON o.transition_override_id = f.override_id
    CROSS JOIN LATERAL (SELECT ST_Distance(streetgen._end_of(f.line, 'start'),
        f.geom) - ST_Distance(streetgen._end_of(f.line, 'end'), f.geom) AS nearer_end) d
    CROSS JOIN LATERAL (SELECT CASE WHEN f.redrawn OR nearer_end = 0 AND NOT f.turned THEN o.which WHEN nearer_end = 0
        THEN CASE o.which WHEN 'start' THEN 'end' ELSE 'start' END
                                    WHEN nearer_end < 0 THEN 'start' ELSE 'end' END AS which) w
    WHERE f.relation = 'transition_override')
UPDATE %1$I.transition_override o SET axis_id = n.axis_id, which = n.which, kind = n.kind, geom = n.geom FROM new n
WHERE o.transition_override_id = n.id AND (o.axis_id, o.which, o.geom) IS DISTINCT FROM (n.axis_id, n.which,
    n.geom)$sql$
        WHEN 'lane_override' THEN $sql$,
new AS (
    SELECT o.lane_override_id AS id, f.axis_id, at.abscissa, at.geom,
        o.along_axis <> (f.turned AND o.both_ways IS NOT TRUE) AS along_axis, CASE WHEN f.turned
        THEN ST_Reverse(o.line) ELSE o.line END AS line,
           CASE WHEN f.turned THEN streetgen._mirrored_ordinality(o.ordinality,
               streetgen._lanes_at(%1$L, o.axis_id, o.abscissa)) ELSE o.ordinality END AS ordinality
    FROM found f JOIN %1$I.lane_override o ON o.lane_override_id = f.override_id
        CROSS JOIN LATERAL streetgen._projected(f.line, f.geom, f.redrawn, o.abscissa) at
    WHERE f.relation = 'lane_override')
UPDATE %1$I.lane_override o SET axis_id = n.axis_id, abscissa = n.abscissa, ordinality = n.ordinality,
    along_axis = n.along_axis, line = n.line, geom = n.geom FROM new n
WHERE o.lane_override_id = n.id AND (o.axis_id, o.abscissa, o.ordinality, o.along_axis, o.line,
    o.geom) IS DISTINCT FROM (n.axis_id, n.abscissa, n.ordinality, n.along_axis, n.line, n.geom)$sql$
        WHEN 'section_limit_override' THEN $sql$,
new AS (
    SELECT o.section_limit_override_id AS id, f.axis_id, at.abscissa, at.geom, CASE WHEN NOT f.turned THEN o.which
        WHEN o.which = 'start' THEN 'end' ELSE 'start' END AS which
    FROM found f JOIN %1$I.section_limit_override o ON o.section_limit_override_id = f.override_id
        CROSS JOIN LATERAL streetgen._projected(f.line, f.geom, f.redrawn, o.abscissa) at
    WHERE f.relation = 'section_limit_override')
UPDATE %1$I.section_limit_override o SET axis_id = n.axis_id, abscissa = n.abscissa, which = n.which, geom = n.geom
    FROM new n
WHERE o.section_limit_override_id = n.id AND (o.axis_id, o.abscissa, o.which, o.geom) IS DISTINCT FROM (n.axis_id,
    n.abscissa, n.which, n.geom)$sql$
        WHEN 'sidewalk_override' THEN $sql$,
new AS (
    SELECT o.sidewalk_override_id AS id, f.axis_id, at.abscissa, at.geom, CASE WHEN NOT f.turned THEN o.side
        WHEN o.side = 'left' THEN 'right' ELSE 'left' END AS side
    FROM found f JOIN %1$I.sidewalk_override o ON o.sidewalk_override_id = f.override_id
        CROSS JOIN LATERAL streetgen._projected(f.line, f.geom, f.redrawn, o.abscissa) at
    WHERE f.relation = 'sidewalk_override')
UPDATE %1$I.sidewalk_override o SET axis_id = n.axis_id, abscissa = n.abscissa, side = n.side, geom = n.geom FROM new n
WHERE o.sidewalk_override_id = n.id AND (o.axis_id, o.abscissa, o.side, o.geom) IS DISTINCT FROM (n.axis_id,
    n.abscissa, n.side, n.geom)$sql$
        WHEN 'kerb_point_override' THEN $sql$,
new AS (
    SELECT f.override_id AS id, f.axis_id, at.abscissa, 2 * ST_Distance(f.line, f.geom) AS width
    FROM found f JOIN %1$I.kerb_point_override o ON o.kerb_point_override_id = f.override_id
        CROSS JOIN LATERAL streetgen._projected(f.line, f.geom, true, o.abscissa) at
    WHERE f.relation = 'kerb_point_override')
UPDATE %1$I.kerb_point_override o SET axis_id = n.axis_id, abscissa = n.abscissa, width = n.width FROM new n
WHERE o.kerb_point_override_id = n.id AND (o.axis_id, o.abscissa, o.width) IS DISTINCT FROM (n.axis_id, n.abscissa,
    n.width)$sql$
        WHEN 'road_override' THEN $sql$,
new AS (
    -- With its vertex, where that moved.
    SELECT f.override_id AS id, f.axis_id, at.abscissa, at.geom
    FROM found f JOIN %1$I.road_override o ON o.road_override_id = f.override_id
        LEFT JOIN changed c ON c.axis_id = f.axis_id
        CROSS JOIN LATERAL (SELECT streetgen._moved_vertex(c.before, c.after, f.geom, (SELECT value FROM tolerance))
            AS vertex) v
        CROSS JOIN LATERAL streetgen._projected(f.line, coalesce(v.vertex, f.geom), f.redrawn OR v.vertex IS NOT NULL,
            o.abscissa) at
    WHERE f.relation = 'road_override')
UPDATE %1$I.road_override o SET axis_id = n.axis_id, abscissa = n.abscissa, geom = n.geom FROM new n
WHERE o.road_override_id = n.id AND (o.axis_id, o.abscissa, o.geom) IS DISTINCT FROM (n.axis_id, n.abscissa,
    n.geom)$sql$
        WHEN 'ramp_override' THEN streetgen._remap_by_abscissa()
        WHEN 'height_override' THEN streetgen._remap_by_abscissa()
        WHEN 'control_point' THEN $sql$,
new AS (
    SELECT f.override_id AS id, f.axis_id, at.abscissa, CASE WHEN f.turned THEN CASE o.direction WHEN 'direct'
        THEN 'reverse' WHEN 'reverse' THEN 'direct' ELSE o.direction END ELSE o.direction END AS direction
    FROM found f JOIN %1$I.control_point o ON o.control_point_id = f.override_id
        CROSS JOIN LATERAL streetgen._projected(f.line, f.geom, true, o.abscissa) at
    WHERE f.relation = 'control_point')
UPDATE %1$I.control_point o SET axis_id = n.axis_id, abscissa = n.abscissa, direction = n.direction FROM new n
WHERE o.control_point_id = n.id AND (o.axis_id, o.abscissa, o.direction) IS DISTINCT FROM (n.axis_id, n.abscissa,
    n.direction)$sql$
        WHEN 'lane_adjacency_override' THEN $sql$,
new AS (
    SELECT o.lane_adjacency_override_id AS id, f.axis_id, at.abscissa, at.geom, CASE WHEN f.turned
        THEN streetgen._mirrored_ordinality(o.lane_from, l.lanes) ELSE o.lane_from END AS lane_from, CASE WHEN f.turned
        THEN streetgen._mirrored_ordinality(o.lane_to, l.lanes) ELSE o.lane_to END AS lane_to
    FROM found f JOIN %1$I.lane_adjacency_override o ON o.lane_adjacency_override_id = f.override_id
        CROSS JOIN LATERAL streetgen._projected(f.line, f.geom, f.redrawn, o.abscissa) at
        CROSS JOIN LATERAL (SELECT CASE WHEN f.turned THEN streetgen._lanes_at(%1$L, o.axis_id, o.abscissa) END
            AS lanes) l
    WHERE f.relation = 'lane_adjacency_override')
UPDATE %1$I.lane_adjacency_override o SET axis_id = n.axis_id, abscissa = n.abscissa, lane_from = n.lane_from,
    lane_to = n.lane_to, geom = n.geom FROM new n
WHERE o.lane_adjacency_override_id = n.id AND (o.axis_id, o.abscissa, o.lane_from, o.lane_to, o.geom)
    IS DISTINCT FROM (n.axis_id, n.abscissa, n.lane_from, n.lane_to, n.geom)$sql$
        WHEN 'junction_override' THEN streetgen._remap_by_place()
        WHEN 'controller_override' THEN streetgen._remap_by_place()
        WHEN 'interconnection_override' THEN $sql$,
new AS (
    SELECT o.interconnection_override_id AS id, coalesce(m.new_place, o.geom) AS geom,
        coalesce(ST_Translate(o.control, ST_X(m.new_place) - ST_X(m.old_place), ST_Y(m.new_place) - ST_Y(m.old_place)),
        o.control) AS control,
           coalesce(i.axis_id, o.axis_in) AS axis_in, CASE WHEN i.turned
               THEN streetgen._mirrored_ordinality(o.lane_in, streetgen._lanes_by(%1$L, o.axis_in, o.geom))
               ELSE o.lane_in END AS lane_in,
           coalesce(u.axis_id, o.axis_out) AS axis_out, CASE WHEN u.turned
               THEN streetgen._mirrored_ordinality(o.lane_out, streetgen._lanes_by(%1$L, o.axis_out, o.geom))
               ELSE o.lane_out END AS lane_out,
           o.along_in <> coalesce(i.turned, false) AS along_in, o.along_out <> coalesce(u.turned, false) AS along_out
    FROM %1$I.interconnection_override o
    LEFT JOIN moved m ON (m.relation, m.override_id) = ('interconnection_override', o.interconnection_override_id)
    LEFT JOIN found i ON (i.relation, i.override_id, i.role) = ('interconnection_override',
        o.interconnection_override_id, 'axis_in')
    LEFT JOIN found u ON (u.relation, u.override_id, u.role) = ('interconnection_override',
        o.interconnection_override_id, 'axis_out')
    WHERE m.override_id IS NOT NULL OR i.override_id IS NOT NULL OR u.override_id IS NOT NULL)
UPDATE %1$I.interconnection_override o SET geom = n.geom, control = n.control, axis_in = n.axis_in,
    lane_in = n.lane_in, axis_out = n.axis_out, lane_out = n.lane_out,
    along_in = n.along_in, along_out = n.along_out FROM new n
WHERE o.interconnection_override_id = n.id AND (o.geom, o.axis_in, o.lane_in, o.axis_out, o.lane_out, o.along_in,
    o.along_out)
    IS DISTINCT FROM (n.geom, n.axis_in, n.lane_in, n.axis_out, n.lane_out, n.along_in, n.along_out)$sql$
        WHEN 'turn_restriction' THEN $sql$,
new AS (
    SELECT o.turn_restriction_id AS id,
        coalesce(ST_Translate(o.geom, ST_X(m.new_place) - ST_X(m.old_place), ST_Y(m.new_place) - ST_Y(m.old_place)),
        o.geom) AS geom,
        coalesce(ST_Translate(o.to_geom, ST_X(n.new_place) - ST_X(n.old_place),
            ST_Y(n.new_place) - ST_Y(n.old_place)), o.to_geom) AS to_geom,
        coalesce(a.axis_id, o.from_axis) AS from_axis, coalesce(b.axis_id, o.to_axis) AS to_axis,
        v.axes AS via_axes, v.geom AS via_geom
    FROM %1$I.turn_restriction o
    LEFT JOIN moved m ON (m.relation, m.override_id, m.node) = ('turn_restriction', o.turn_restriction_id, 'geom')
    LEFT JOIN moved n ON (n.relation, n.override_id, n.node) = ('turn_restriction', o.turn_restriction_id, 'to_geom')
    LEFT JOIN found a ON (a.relation, a.override_id, a.role) = ('turn_restriction', o.turn_restriction_id, 'from_axis')
    LEFT JOIN found b ON (b.relation, b.override_id, b.role) = ('turn_restriction', o.turn_restriction_id, 'to_axis')
    LEFT JOIN LATERAL (
        SELECT array_agg(coalesce(f.axis_id, u.axis_id) ORDER BY u.i) AS axes,
            -- On its axis redrawn: beside where it was, else as far along the line as before.
            ST_Collect(CASE WHEN f.redrawn IS NOT TRUE THEN p.geom
                WHEN streetgen._remap_lies_beside(f.line, p.geom) THEN ST_ClosestPoint(f.line, p.geom)
                ELSE ST_LineInterpolatePoint(f.line, ST_LineLocatePoint(f.before, p.geom)) END ORDER BY u.i) AS geom
        FROM unnest(o.via_axes) WITH ORDINALITY u(axis_id, i)
            CROSS JOIN LATERAL ST_GeometryN(o.via_geom, u.i::integer) p(geom) LEFT JOIN found f
            ON (f.relation, f.override_id, f.role) = ('turn_restriction', o.turn_restriction_id, 'via_axis ' || u.i)
        ) v ON o.via_axes IS NOT NULL
    WHERE o.turn_restriction_id IN (SELECT override_id FROM moved WHERE relation = 'turn_restriction'
        UNION ALL SELECT override_id FROM found WHERE relation = 'turn_restriction'))
UPDATE %1$I.turn_restriction o SET geom = n.geom, from_axis = n.from_axis, to_axis = n.to_axis,
    via_axes = n.via_axes, via_geom = n.via_geom, to_geom = n.to_geom FROM new n
WHERE o.turn_restriction_id = n.id
    AND (o.geom::bytea, o.from_axis, o.to_axis, o.via_axes, o.via_geom::bytea, o.to_geom::bytea)
    IS DISTINCT FROM (n.geom::bytea, n.from_axis, n.to_axis, n.via_axes, n.via_geom::bytea, n.to_geom::bytea)$sql$
        ELSE $sql$,
new AS (
    SELECT o.%2$I_id AS id,
        coalesce(ST_Translate(o.geom, ST_X(m.new_place) - ST_X(m.old_place), ST_Y(m.new_place) - ST_Y(m.old_place)),
        o.geom) AS geom, coalesce(a.axis_id, o.%3$I) AS axis_a, coalesce(b.axis_id, o.%4$I) AS axis_b
    FROM %1$I.%2$I o
    LEFT JOIN moved m ON (m.relation, m.override_id) = (%2$L, o.%2$I_id)
    LEFT JOIN found a ON (a.relation, a.override_id, a.role) = (%2$L, o.%2$I_id, %3$L)
    LEFT JOIN found b ON (b.relation, b.override_id, b.role) = (%2$L, o.%2$I_id, %4$L)
    WHERE m.override_id IS NOT NULL OR a.override_id IS NOT NULL OR b.override_id IS NOT NULL)
UPDATE %1$I.%2$I o SET geom = n.geom, %3$I = n.axis_a, %4$I = n.axis_b FROM new n
WHERE o.%2$I_id = n.id AND (o.geom, o.%3$I, o.%4$I) IS DISTINCT FROM (n.geom, n.axis_a, n.axis_b)$sql$ END, model,
    relation, CASE relation WHEN 'corner_override' THEN 'axis_a' ELSE 'axis_above' END,
    CASE relation WHEN 'corner_override' THEN 'axis_b' ELSE 'axis_below' END)
    $$;
COMMENT ON FUNCTION streetgen._remap_statement(name, name) IS
    'The statement that puts the overrides of one relation near changed axes on the axis that they lie on now. What '
    'fits nowhere stays as it is, until an axis comes by.';

CREATE OR REPLACE FUNCTION streetgen._remap_window(relation name) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE relation WHEN 'turn_restriction' THEN '(geom && ST_Expand(extent, 110) '
        'OR coalesce(to_geom, geom) && ST_Expand(extent, 110) '
        'OR via_axes IS NOT NULL AND via_geom && ST_Expand(extent, 110))' ELSE 'geom && ST_Expand(extent, 110)' END $$;
COMMENT ON FUNCTION streetgen._remap_window(name) IS
    'Whether a row of overrides has a place near the extent of changed axes, as SQL.';

CREATE OR REPLACE FUNCTION streetgen._projected(line geometry, place geometry, onto boolean, former float8,
    OUT abscissa float8, OUT geom geometry)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN abs(at - former) < 1e-6 THEN former ELSE at END, CASE WHEN onto THEN ST_ClosestPoint(line, place)
        ELSE place END
    FROM (SELECT ST_LineLocatePoint(line, place) * ST_Length2D(line) AS at) p
    $$;
COMMENT ON FUNCTION streetgen._projected(geometry, geometry, boolean, float8) IS
    'Abscissa (metres) of a line nearest to a place, the former one where it is the same within a micrometre; and the '
    'place, put onto the line where asked.';

CREATE OR REPLACE FUNCTION streetgen._lanes_at(model name, axis bigint, abscissa float8) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        RETURN 0;
    END IF;
    SELECT count(*) FROM lane l JOIN edge e USING (edge_id) WHERE axis_id = axis AND abscissa >= e.start_abscissa
        AND abscissa < e.end_abscissa AND l.kind <> 'merging' INTO lanes;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_at(name, bigint, float8) IS
    'Number of lanes of an axis at an abscissa, without merging lanes, as generated last; 0 where there are none.';

CREATE OR REPLACE FUNCTION streetgen._lanes_by(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        RETURN 0;
    END IF;
    SELECT count(*) FROM lane WHERE edge_id = (SELECT edge_id FROM edge WHERE axis_id = axis
        ORDER BY ST_Distance(geom, place), edge_id LIMIT 1) INTO lanes;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_by(name, bigint, geometry) IS
    'Number of lanes of an axis at its edge nearest to a place, as generated last.';

CREATE OR REPLACE FUNCTION streetgen._remapped(model name) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL RESTRICTED SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN nullif(current_setting('streetgen.remapped', true), '')::jsonb ->> model;
END $$;
COMMENT ON FUNCTION streetgen._remapped(name) IS
    'Axes of a model whose overrides have moved with axes that are not followed yet; NULL where none move.';

CREATE OR REPLACE FUNCTION streetgen._note_remapped(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    others constant jsonb := coalesce(nullif(current_setting('streetgen.remapped', true), '')::jsonb,
        '{}') - model::text;
BEGIN
    PERFORM set_config('streetgen.remapped',
        (others || jsonb_strip_nulls(jsonb_build_object(model, axes::text)))::text, true);
END $$;
COMMENT ON FUNCTION streetgen._note_remapped(name, bigint[]) IS
    'Sets what _remapped of a model tells until its axes are followed; NULL: they are.';

CREATE OR REPLACE FUNCTION streetgen._make_remap(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    overrides constant name[] :=
        '{transition_override,lane_override,section_limit_override,sidewalk_override,kerb_point_override,'
        'corner_override,'
        'interconnection_override,turn_restriction,control_point,overpass_override,junction_override,'
        'controller_override,road_override,ramp_override,height_override,lane_adjacency_override}';
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW override_place WITH (security_invoker = true) AS
    SELECT 'transition_override' AS relation, transition_override_id AS override_id, 'axis_id' AS role, axis_id AS
        axis_id,
        geom, (SELECT value::float8 FROM setting WHERE name = 'tolerance') AS reach FROM transition_override
    UNION ALL SELECT 'lane_override', lane_override_id, 'axis_id', axis_id, geom, (SELECT value::float8 FROM setting
        WHERE name = 'tolerance') FROM lane_override
    UNION ALL SELECT 'lane_adjacency_override', lane_adjacency_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance') FROM lane_adjacency_override
    UNION ALL SELECT 'section_limit_override', section_limit_override_id, 'axis_id', axis_id, geom, (SELECT
        value::float8
        FROM setting WHERE name = 'tolerance') FROM section_limit_override
    UNION ALL SELECT 'road_override', road_override_id, 'axis_id', axis_id, geom, (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM road_override
    UNION ALL SELECT 'ramp_override', ramp_override_id, 'axis_id', axis_id, geom, (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM ramp_override
    UNION ALL SELECT 'height_override', height_override_id, 'axis_id', axis_id, geom, (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM height_override
    UNION ALL SELECT 'sidewalk_override', sidewalk_override_id, 'axis_id', axis_id, geom, (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM sidewalk_override
    UNION ALL SELECT 'kerb_point_override', kerb_point_override_id, 'axis_id', axis_id, geom,
        width / 2 + (SELECT value::float8 FROM setting WHERE name = 'tolerance') FROM kerb_point_override
    UNION ALL SELECT 'control_point', control_point_id, 'axis_id', axis_id, geom,
        coalesce(axis_distance, 0) + (SELECT value::float8 FROM setting WHERE name = 'tolerance')
        FROM control_point
    UNION ALL SELECT 'junction_override', junction_override_id, 'axis_id', axis_id, geom, 3 * (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM junction_override
    UNION ALL SELECT 'controller_override', controller_override_id, 'axis_id', axis_id, geom, 3 * (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM controller_override
    UNION ALL SELECT 'corner_override', corner_override_id, 'axis_a', axis_a, geom, 3 * (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM corner_override
    UNION ALL SELECT 'corner_override', corner_override_id, 'axis_b', axis_b, geom, 3 * (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM corner_override
    UNION ALL SELECT 'interconnection_override', interconnection_override_id, 'axis_in', axis_in, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance') FROM interconnection_override
    UNION ALL SELECT 'interconnection_override', interconnection_override_id, 'axis_out', axis_out, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance') FROM interconnection_override
    UNION ALL SELECT 'turn_restriction', turn_restriction_id, 'from_axis', from_axis, geom, 3 * (SELECT value::float8
        FROM setting WHERE name = 'tolerance') FROM turn_restriction
    UNION ALL SELECT 'turn_restriction', turn_restriction_id, 'to_axis', to_axis, coalesce(to_geom, geom),
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance') FROM turn_restriction
    UNION ALL SELECT 'turn_restriction', turn_restriction_id, 'via_axis ' || v.i, v.axis_id,
        ST_GeometryN(via_geom, v.i::integer), 3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance')
        FROM turn_restriction, unnest(via_axes) WITH ORDINALITY v(axis_id, i) WHERE via_axes IS NOT NULL
    UNION ALL SELECT 'overpass_override', overpass_override_id, 'axis_above', axis_above, geom, 20
        FROM overpass_override
    UNION ALL SELECT 'overpass_override', overpass_override_id, 'axis_below', axis_below, geom, 20
        FROM overpass_override;
    COMMENT ON VIEW override_place IS
        'Where each decision by hand lies, and the axes that it names, a row for each of them';
    COMMENT ON COLUMN override_place.relation IS 'table of the override';
    COMMENT ON COLUMN override_place.override_id IS 'its key there';
    COMMENT ON COLUMN override_place.role IS 'column that names the axis';
    COMMENT ON COLUMN override_place.axis_id IS 'the axis';
    COMMENT ON COLUMN override_place.geom IS 'place on the axis or of the node; of a kerb point, beside the axis';
    COMMENT ON COLUMN override_place.reach IS 'an axis within this distance lies at the place, metres';
    -- Static SQL, whose plans a session keeps: most models have few overrides, most edits none near.
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._remap(bigint[], geometry[], geometry[]) RETURNS void
    LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off SET enable_seqscan = off
        SET plan_cache_mode = force_generic_plan
    AS $body$
DECLARE
    extent constant geometry := (SELECT ST_Extent(line)::geometry FROM unnest($2 || $3) line);
    concerned bigint[];
    held text[];
BEGIN
    LOOP
        BEGIN
            -- Their rows first, and by one lock all their places, so that none waits for more while it holds some.
            held := '{}';
            %2$s
            IF streetgen._live(%3$L) THEN
                -- Control points are many, and only those on a changed axis move. One off all axes names none.
                concerned := ARRAY(SELECT o.axis_id FROM %1$I.override_place o WHERE o.geom && ST_Expand(extent, 110)
                                       AND (relation <> 'control_point' OR o.geom && ST_Expand(extent, o.reach))
                                   UNION SELECT a.axis_id FROM %1$I.override_place o
                                       JOIN %1$I.axis a ON ST_DWithin(a.geom, o.geom, o.reach)
                                       WHERE o.geom && ST_Expand(extent, 110)
                                       AND (relation <> 'control_point' OR o.geom && ST_Expand(extent, o.reach)));
                IF concerned <> '{}' THEN
                    PERFORM FROM streetgen._lock_places(%3$L, concerned || $1, wait => true);
                END IF;
            END IF;
            EXIT WHEN NOT EXISTS (SELECT FROM %1$I.override_place WHERE geom && ST_Expand(extent, 110)
                AND concat(relation, override_id) <> ALL (held));
            -- One that came while this waited may be held by who waits for this one's: all is given back.
            RAISE SQLSTATE 'SG001';
        EXCEPTION WHEN SQLSTATE 'SG001' THEN
            NULL;
        END;
    END LOOP;
    IF concerned <> '{}' THEN
        -- Streets follow the changes below with the axes, and not on their own.
        PERFORM streetgen._note_remapped(%3$L, coalesce(streetgen._remapped(%3$L), '{}'));
    END IF;
    %4$s
END $body$ $sql$, model,
        -- No kerb lies farther from its axis than 100 m, and three tolerances are 30 m at most.
        (SELECT string_agg(format('held := held || ARRAY(SELECT concat(%2$L, id) FROM (SELECT %2$I_id AS id FROM '
            '%1$I.%2$I WHERE %3$s ORDER BY id FOR UPDATE) r);', model, relation, streetgen._remap_window(relation)),
            E'\n            ' ORDER BY n)
         FROM unnest(overrides) WITH ORDINALITY r(relation, n)), model,
        (SELECT string_agg(format('IF EXISTS (SELECT FROM %1$I.%2$I WHERE %4$s) THEN%3$s;' || E'\n    END IF;', model,
            relation, streetgen._remap_statement(model, relation), streetgen._remap_window(relation)),
            E'\n    ' ORDER BY n)
         FROM unnest(overrides) WITH ORDINALITY r(relation, n)));
    PERFORM streetgen._own_function(model, '_remap(bigint[], geometry[], geometry[])',
        'Puts the overrides near changed axes on the axis that they lie on now: axes with their lines before and '
        'after, NULL where there was or is none');
    PERFORM streetgen._follow_axes(model, 'remap', 'override_place', '_remap',
        'overrides stay on the piece of road where they lie');
END $$;
COMMENT ON FUNCTION streetgen._make_remap(name) IS
    'Makes the view override_place of a model and the triggers on its axes that keep overrides where they lie.';
