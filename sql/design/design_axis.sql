-- Stage axes: links become axes of the model, by the machinery of the importers.

CREATE OR REPLACE FUNCTION streetgen._axis_cuts(model name, link bigint) RETURNS TABLE(part integer, low float8,
    high float8, level integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog
    AS $$
#variable_conflict use_column
DECLARE
    piece constant float8 := streetgen._setting_number(model, 'design_axis_length');
    elements constant float8[] := streetgen._link_elements(model, link);
    length constant float8 := elements[cardinality(elements) - 6] + elements[cardinality(elements) - 2];
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH cut AS (
        SELECT 0::float8 AS at UNION SELECT length
        -- Counted from the start, so that a bend moves the pieces behind it alone.
        UNION SELECT piece * k FROM generate_series(1, round(length / piece)::integer - 1) k
        UNION SELECT unnest(ARRAY[start_abscissa, end_abscissa]) FROM structure
            WHERE design_link_id = link AND NOT rejected
        UNION SELECT abscissa FROM design_crossing WHERE design_link_id = link AND kind = 'level' AND NOT rejected
        UNION SELECT other_abscissa FROM design_crossing WHERE other_link_id = link AND kind = 'level'
            AND NOT rejected),
    -- Cuts nearer than two metres are one, but for the ends and crossings.
    kept AS (SELECT at FROM cut c WHERE at BETWEEN 0 AND length AND (at IN (0, length) OR NOT EXISTS (SELECT FROM cut o
        WHERE o.at < c.at AND o.at > c.at - 2) AND at < length - 2)),
    piece AS (SELECT at AS low, lead(at) OVER (ORDER BY at) AS high, row_number() OVER (ORDER BY at) AS nth FROM kept)
    SELECT nth::integer, low, high, coalesce((SELECT CASE kind WHEN 'bridge' THEN 1 ELSE -1 END FROM structure s
        WHERE design_link_id = link AND NOT rejected AND (low + high) / 2 BETWEEN start_abscissa AND end_abscissa
        ORDER BY by_hand DESC LIMIT 1), 0)
    FROM piece WHERE high IS NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._axis_cuts(name, bigint) IS
    'The pieces in which a link becomes axes: cut at structures, at level crossings, and about every '
    'design_axis_length.';

CREATE OR REPLACE FUNCTION streetgen._design_axes(model name, links bigint[]) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    left_hand constant boolean := streetgen._setting_text(model, 'driving_side') = 'left';
    former text[];
    written bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TEMPORARY TABLE _import ON COMMIT DROP AS
    WITH link AS MATERIALIZED (SELECT l.design_link_id, c.*, concat_ws(' - ', a.name, b.name) AS link_name,
        streetgen._link_elements(model, l.design_link_id) AS elements,
        streetgen._link_grades(model, l.design_link_id) AS grades
        FROM design_link l JOIN design_class c USING (network)
        JOIN design_node a ON a.design_node_id = node_a
        JOIN design_node b ON b.design_node_id = node_b
        WHERE l.design_link_id = ANY (links) AND NOT l.rejected AND NOT c.rejected
            AND coalesce(l.method, '') NOT LIKE 'no_path%'),
    side AS (SELECT * FROM (VALUES (1, 0, 'both', ''), (2, 1, 'reverse', '/left'), (2, -1, 'direct', '/right'))
        s(carriageways, side, direction, suffix))
    SELECT streetgen._alignment_line(elements, grades, srid, low, high, 0.01,
            side * (roadway_width + median_width) / 2, taper)::geometry AS geom,
        roadway_width AS width, NULL::float8 AS width_end, lane_count,
        CASE WHEN left_hand AND direction <> 'both' THEN CASE direction WHEN 'direct' THEN 'reverse' ELSE 'direct' END
            ELSE direction END AS direction,
        speed, importance, nullif(link_name, '') AS name, level, NULL::text AS class, NULL::float8 AS radius,
        design_link_id || '/' || part || suffix AS source_ref, design_link_id || '/' || part || suffix AS label,
        NULL::text AS left_out, NULL::text[] AS unread
    FROM link JOIN side USING (carriageways), LATERAL streetgen._axis_cuts(model, design_link_id)
    WHERE elements <> '{}' AND grades <> '{}';
    SELECT count(*) INTO written FROM pg_temp._import;
    SELECT coalesce(array_agg(source_ref), '{}') FROM axis WHERE source = 'design'
        AND (split_part(source_ref, '/', 1)::bigint = ANY (links)
            OR NOT EXISTS (SELECT FROM design_link l WHERE NOT l.rejected
                AND coalesce(l.method, '') NOT LIKE 'no_path%'
                AND l.design_link_id = split_part(source_ref, '/', 1)::bigint)) INTO former;
    PERFORM streetgen._import_change(model, 'design', former, clean => false);
    -- A link that comes back as it was is built anew.
    DELETE FROM design_input i USING design_link l WHERE i.stage = 'axes' AND l.design_link_id = i.design_link_id
        AND (l.rejected OR l.method LIKE 'no_path%');
    RETURN written;
END $$;
COMMENT ON FUNCTION streetgen._design_axes(name, bigint[]) IS
    'Stage axes of links: writes their axes (source design), and takes away those of links that are gone or have no '
    'way; returns how many stand.';
