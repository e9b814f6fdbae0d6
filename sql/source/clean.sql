-- Axes of a source before they are written: cleaned, in the reference of the model, told from doubles.

CREATE OR REPLACE FUNCTION streetgen._clean_network(lines bytea[], beside bytea[], tolerance float8, epsilon float8,
    r_min float8) RETURNS bytea[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 AS 'MODULE_PATHNAME', 'streetgen_clean_network';
COMMENT ON FUNCTION streetgen._clean_network(bytea[], bytea[], float8, float8, float8) IS
    'Lines (EWKB of a LINESTRING each, of one reference and dimension) cleaned by the filters of streetgen.clean, '
    'with every point kept that another of them, or a line beside, has within the tolerance (0 to 10 m): a node may '
    'be there. NULL for what stays as it is. NULL in a list: 22004; bad geometry or number: 22023.';

CREATE OR REPLACE FUNCTION streetgen._clean_parts(model name, source text) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    cleaned bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    -- A line that its source drew as before stays as it is.
    WITH filter AS MATERIALIZED (
        SELECT (v ->> 'tolerance')::float8 AS tolerance, (v ->> 'clean_epsilon')::float8 AS epsilon,
            (v ->> 'clean_r_min')::float8 AS r_min FROM (SELECT jsonb_object_agg(name, value) AS v FROM setting) s),
    drawn AS MATERIALIZED (
        SELECT p.ctid AS id, p.source_ref, p.source_geom FROM pg_temp._import_part p LEFT JOIN delivered d
            ON (d.relation, d.source, d.source_ref) = ('axis', origin, p.source_ref)
        WHERE d.source_geom::bytea IS DISTINCT FROM p.source_geom::bytea),
    neighbour AS (
        SELECT DISTINCT ON (a.axis_id) a.geom FROM drawn p CROSS JOIN LATERAL (
            SELECT * FROM axis WHERE geom && ST_Expand(p.source_geom, (SELECT tolerance FROM filter)) OFFSET 0) a
        WHERE NOT EXISTS (SELECT FROM drawn r WHERE a.source = origin AND r.source_ref = a.source_ref)),
    part AS (SELECT array_agg(id) AS ids, array_agg(source_geom::bytea) AS lines FROM drawn)
    UPDATE pg_temp._import_part p SET cleaned = c.geom::geometry
    FROM (SELECT unnest(ids) AS id, unnest(streetgen._clean_network(lines,
            coalesce((SELECT array_agg(geom::bytea) FROM neighbour), '{}'), tolerance, epsilon, r_min)) AS geom
        FROM part, filter) c
    WHERE p.ctid = c.id AND c.geom IS NOT NULL;
    GET DIAGNOSTICS cleaned = ROW_COUNT;
    RETURN cleaned;
END $$;
COMMENT ON FUNCTION streetgen._clean_parts(name, text) IS
    'Cleans the parts of the import by the filters of streetgen.clean, keeping every vertex that another part shares, '
    'or an axis that stays; returns how many changed.';

CREATE OR REPLACE FUNCTION streetgen._chords(what text, curve geometry, srid integer, tolerance float8)
    RETURNS geometry
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- The length of the curve in both references tells how many units of its own a metre is.
    SELECT ST_CurveToLine(curve, greatest(1e-8 * length, tolerance * coalesce(length / nullif(ST_Length(
            streetgen._transformed(what, curve, srid)), 0), 1)), 1, 1)
        FROM ST_Length(curve) AS length
    $$;
COMMENT ON FUNCTION streetgen._chords(text, geometry, integer, float8) IS
    'A curve as lines that leave it by at most the tolerance, metres of the reference srid, and that are the same from '
    'either end; what names it in an error. Curves over 1,000 km get coarser chords.';

CREATE OR REPLACE FUNCTION streetgen._take_lines(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    target_srid constant integer := (SELECT srid FROM streetgen.model m WHERE m.name = model);
    tolerance float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value::float8 INTO tolerance FROM setting WHERE name = 'curve_tolerance';
    UPDATE pg_temp._import i SET geom = streetgen._chords('source row ' || i.label, i.geom, target_srid, tolerance)
        WHERE GeometryType(i.geom) ~ '^(CIRCULARSTRING|COMPOUNDCURVE|MULTICURVE|GEOMETRYCOLLECTION)';
    RETURN QUERY SELECT 'other than lines in a collection, left out', NULL::text, count(*), array_agg(i.label
        ORDER BY i.label) FROM pg_temp._import i, ST_Dump(i.geom) d
        WHERE GeometryType(i.geom) ~ '^GEOMETRYCOLLECTION' AND ST_Dimension(d.geom) <> 1 AND NOT ST_IsEmpty(d.geom)
            AND NOT ST_IsEmpty(ST_CollectionExtract(i.geom, 2)) HAVING count(*) > 0;
    UPDATE pg_temp._import i SET geom = ST_CollectionExtract(i.geom, 2)
        WHERE GeometryType(i.geom) ~ '^GEOMETRYCOLLECTION' AND NOT ST_IsEmpty(ST_CollectionExtract(i.geom, 2));
END $$;
COMMENT ON FUNCTION streetgen._take_lines(name) IS
    'Makes lines of what rows of the import have instead: chords of curves, the lines of a collection; reports what '
    'else a collection has.';

CREATE OR REPLACE FUNCTION streetgen._mend_heights()
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE sql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
WITH point AS MATERIALIZED (
    SELECT i.ctid AS id, CASE cardinality(d.path) WHEN 2 THEN d.path[1] ELSE 1 END AS part,
        d.path[cardinality(d.path)] AS nth, d.geom,
           -- NaN is greater than every number, so that it fails here too.
           CASE WHEN ST_Z(d.geom) > -500 AND ST_Z(d.geom) < 9000 THEN ST_Z(d.geom) WHEN ST_Z(d.geom) IS NULL
               THEN 0 END AS z
    FROM pg_temp._import i, ST_DumpPoints(i.geom) d),
broken AS (SELECT * FROM point WHERE id IN (SELECT id FROM point WHERE z IS NULL)),
counted AS (
    SELECT *, count(z) OVER (PARTITION BY id ORDER BY part, nth) AS before, count(z) OVER (PARTITION BY id
        ORDER BY part DESC, nth DESC) AS after FROM broken),
filled AS (
    SELECT *, max(z) OVER (PARTITION BY id, before) AS z_before, max(z) OVER (PARTITION BY id, after) AS z_after
        FROM counted),
line AS (
    SELECT id, part, ST_MakeLine(ST_SetSRID(ST_MakePoint(ST_X(geom), ST_Y(geom),
        coalesce((z_before + z_after) / 2, z_before, z_after, 0)), ST_SRID(geom)) ORDER BY nth) AS geom
    FROM filled GROUP BY id, part),
mended AS (
    UPDATE pg_temp._import i SET geom = l.geom FROM (SELECT id, ST_Collect(geom ORDER BY part) AS geom FROM line
        GROUP BY id) l WHERE i.ctid = l.id RETURNING i.source_ref)
SELECT 'height without data, taken from the same line or 0', NULL::text, count(*), array_agg(source_ref
    ORDER BY source_ref) FROM mended HAVING count(*) > 0
$$;
COMMENT ON FUNCTION streetgen._mend_heights() IS
    'Gives vertices of the import whose height is no data (NaN, -1000 and the like) the height of their neighbours '
    'along the line, or 0; reports the lines.';

CREATE OR REPLACE FUNCTION streetgen._suspects(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET jit = off SET enable_nestloop = off
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT c.rule, NULL::text, count(DISTINCT c.id), array_agg(DISTINCT coalesce(a.source_ref,
            'axis ' || c.id))
        FROM streetgen._contradictions(model, origin) c JOIN axis a ON a.axis_id = c.id GROUP BY c.rule ORDER BY c.rule;
    RETURN QUERY SELECT 'odd number of lanes, the last one in the middle for both directions', NULL::text, count(*),
        array_agg(coalesce(a.source_ref, 'axis ' || a.axis_id) ORDER BY a.source_ref)
        FROM axis a JOIN axis_used u USING (axis_id)
        WHERE u.axis_id = ANY (ARRAY(SELECT o.axis_id FROM axis o WHERE o.source = origin AND o.direction = 'both'
                AND o.lane_count > 1 AND o.lane_count % 2 = 1 AND o.lanes_both IS NULL))
            AND u.lanes_both = 1 HAVING count(*) > 0;
    RETURN QUERY WITH network AS MATERIALIZED (
        -- Without the radius, so that a predictor of the user's is not asked.
        SELECT streetgen._network(Find_SRID(model::text, 'axis', 'geom'),
            (SELECT jsonb_object_agg(name, value) || '{"trajectory": "arcs"}' FROM setting),
            array_agg(ROW (axis_id, ST_Force2D(geom)::bytea, level, width, width_end, roadway_offset, 0, importance,
                speed, lanes_forward, lanes_backward, lanes_both, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL,
                false, 0,
                true, false, NULL)::streetgen.street_axis ORDER BY axis_id)) AS number FROM axis_used),
    -- An axis of another source is known by its number.
    missed AS (SELECT r.issue, r.measure, coalesce(CASE WHEN a.source = origin THEN a.source_ref END,
            'axis ' || a.axis_id) AS source_ref
        FROM streetgen._computed_report((SELECT number FROM network)) r JOIN axis a ON a.axis_id = r.axis_a)
    SELECT attribute || CASE WHEN too_small THEN format(' too small: %s m, taken as %s m', u.width, taken)
            ELSE ' not believed' END, NULL::text, count(*), array_agg(coalesce(u.source_ref, 'axis ' || u.axis_id)
            ORDER BY u.source_ref)
        FROM streetgen._unbelieved(model) u JOIN axis a USING (axis_id) WHERE a.source = origin GROUP BY 1
    UNION ALL SELECT 'crosses or touches itself', NULL, count(*), array_agg(coalesce(a.source_ref, 'axis ' || a.axis_id)
        ORDER BY a.source_ref) FROM axis a
    WHERE a.source = origin AND NOT ST_IsSimple(a.geom) HAVING count(*) > 0
    UNION ALL SELECT issue, NULL, count(DISTINCT source_ref), array_agg(DISTINCT source_ref ORDER BY source_ref)
        FROM missed WHERE issue = 'axis lies on another' GROUP BY issue
    UNION ALL SELECT format('%s: tolerance %s would join them all', issue, ceil(10 * max(measure) - 0.001) / 10), NULL,
        count(*), array_agg(source_ref ORDER BY source_ref)
        FROM missed WHERE issue LIKE 'end of an axis%' GROUP BY issue;
EXCEPTION WHEN internal_error THEN
    -- PostGIS' name for a computation that was interrupted. The interrupt still waits, and is taken before RAISE: the
    -- call ends as 57014.
    RAISE;
END $$;
COMMENT ON FUNCTION streetgen._suspects(name, text) IS
    'Axes of a source that importers report: columns that contradict each other, an odd lane of no direction, a width '
    'that is not believed, a line that meets itself, and what the network of all axes tells: lines upon lines, and '
    'ends that miss.';
