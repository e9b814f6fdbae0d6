-- One cut across a street.

CREATE OR REPLACE FUNCTION streetgen._cross_section(model name, axis_id bigint, place float8)
    RETURNS TABLE(side text, "order" integer, kind text, offset_from float8, offset_to float8, height float8,
        kerb text, lane_id bigint)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    length float8;
    edge bigint;
    pieces bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('axis', axis_id::text, 'metres', place::text);
    SELECT ST_Length2D(a.geom) FROM axis a WHERE a.axis_id = _cross_section.axis_id INTO length;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no axis %', axis_id USING ERRCODE = '22023',
            HINT = format('SELECT axis_id FROM %I.axis lists them.', model);
    ELSIF place NOT BETWEEN 0 AND length + 1e-6 THEN
        RAISE EXCEPTION 'axis % has no place at % m', axis_id, place USING ERRCODE = '22023',
            DETAIL = format('It is %s m long.', round(length::numeric, 3)), HINT = 'Metres count along the axis.';
    END IF;
    SELECT e.edge_id FROM edge e WHERE e.axis_id = _cross_section.axis_id AND e.start_abscissa <= place
        ORDER BY e.start_abscissa DESC LIMIT 1 INTO edge;
    RETURN QUERY
    SELECT side, row_number() OVER (PARTITION BY side ORDER BY "order")::integer, kind,
        round((offset_from + (offset_from_end - offset_from) * share)::numeric, 9)::float8,
        round((offset_to + (offset_to_end - offset_to) * share)::numeric, 9)::float8, NULL::float8, kerb, lane_id
    FROM (SELECT c.*, (place - start_abscissa) / (end_abscissa - start_abscissa) AS share,
            rank() OVER (ORDER BY start_abscissa DESC) AS turn
        FROM cross_section c WHERE c.edge_id = edge AND place BETWEEN start_abscissa AND end_abscissa) c
    WHERE turn = 1 AND (offset_to IS NULL OR kerb IS NOT NULL
        OR (offset_to - offset_from) * (1 - share) + (offset_to_end - offset_from_end) * share > 1e-9)
    ORDER BY side, "order";
    GET DIAGNOSTICS pieces = ROW_COUNT;
    IF pieces = 0 THEN
        RAISE NOTICE 'axis % has no cross-section at % m', axis_id, place USING
            DETAIL = 'The place lies in a junction, or its street is not computed.',
            HINT = format('SELECT DISTINCT start_abscissa, end_abscissa FROM %I.cross_section WHERE axis_id = %s says '
                'where it has one.', model, axis_id);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._cross_section(name, bigint, float8) IS 'What streetgen.cross_section gives.';

-- PL/pgSQL would take the argument for the table axis.
CREATE OR REPLACE FUNCTION streetgen.cross_section(model name, axis bigint, metres float8)
    RETURNS TABLE(side text, "order" integer, kind text, offset_from float8, offset_to float8, height float8,
        kerb text, lane_id bigint)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._cross_section($1, $2, $3) $$;
COMMENT ON FUNCTION streetgen.cross_section(name, bigint, float8) IS
    'One cut across a street, metres along an axis: its pieces outwards from the axis on each side, with their kind '
    'and, in metres from the axis, where they begin and end, as view cross_section of the model has them. offset_to '
    'NULL: the ground goes on. height: metres above the axis, NULL where it is unknown. In a junction: no row, and a '
    'notice. An unknown axis, a place off it, NaN: 22023; NULL: 22004; an unknown model: 3F000.';
