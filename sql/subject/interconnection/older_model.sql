-- Columns that models of older builds lack.

CREATE OR REPLACE FUNCTION streetgen._mend_interconnection_tables(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'turn_restriction', 'via_axes') THEN
        RETURN;
    END IF;
    ALTER TABLE turn_restriction ADD via_axes bigint[];
    EXECUTE format('ALTER TABLE turn_restriction ADD via_geom geometry(MultiPoint, %1$s), '
        'ADD to_geom geometry(Point, %1$s)', srid);
    ALTER TABLE turn_restriction
        ADD CONSTRAINT via_geom_is_finite CHECK (NOT ST_IsEmpty(via_geom)
            AND ST_XMin(via_geom) BETWEEN -1e12 AND 1e12 AND ST_XMax(via_geom) BETWEEN -1e12 AND 1e12
            AND ST_YMin(via_geom) BETWEEN -1e12 AND 1e12 AND ST_YMax(via_geom) BETWEEN -1e12 AND 1e12),
        ADD CONSTRAINT to_geom_is_a_finite_point CHECK (NOT ST_IsEmpty(to_geom)
            AND ST_XMin(to_geom) BETWEEN -1e12 AND 1e12 AND ST_XMax(to_geom) BETWEEN -1e12 AND 1e12
            AND ST_YMin(to_geom) BETWEEN -1e12 AND 1e12 AND ST_YMax(to_geom) BETWEEN -1e12 AND 1e12),
        ADD CONSTRAINT each_via_axis_has_a_place CHECK (num_nulls(via_axes, via_geom, to_geom) = 3
            OR num_nulls(via_axes, via_geom, to_geom) = 0 AND cardinality(via_axes) = ST_NumGeometries(via_geom));
END $$;
COMMENT ON FUNCTION streetgen._mend_interconnection_tables(name, integer) IS
    'Adds to table turn_restriction of a model what leads via axes, where that is missing.';
