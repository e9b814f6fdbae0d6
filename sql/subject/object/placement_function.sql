-- A rule of placement of one's own: the function that setting placement_function names.

CREATE OR REPLACE FUNCTION streetgen._own_placements(model name, edges bigint[]) RETURNS SETOF streetgen.placement
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    value constant text := streetgen._setting_text(model, 'placement_function');
    called text;
    placed streetgen.placement;
    known boolean;
    length float8;
BEGIN
    IF value = 'none' THEN
        RETURN;
    END IF;
    called := streetgen._called_function(model, 'placement_function', value);
    FOR placed IN EXECUTE format('SELECT * FROM %s($1, $2)', called) USING model, edges LOOP
        EXECUTE format('SELECT EXISTS (SELECT FROM %1$I.object_type WHERE type = $1), (SELECT ST_Length2D(geom)
            FROM %1$I.axis WHERE axis_id = $2)', model) INTO known, length USING placed.type, placed.axis_id;
        IF NOT known OR length IS NULL OR placed.side NOT IN ('left', 'right')
            OR (placed.abscissa BETWEEN 0 AND length) IS NOT TRUE
            OR (placed.axis_offset BETWEEN -200 AND 200) IS NOT TRUE
            OR coalesce(placed.orientation, 0) NOT BETWEEN -360 AND 360 THEN
            PERFORM streetgen._refuse('22023', format('function %s places %s where nothing can stand', called, placed),
                hint => 'Type and axis are those of the model, the abscissa lies on the axis, '
                    'side is left, right or NULL, and the offset goes up to 200 m.');
        END IF;
        RETURN NEXT placed;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._own_placements(name, bigint[]) IS
    'What the function that setting placement_function names places along edges. One that gives a place where nothing '
    'can stand: 22023; one that may not be called, as _called_function has it.';
