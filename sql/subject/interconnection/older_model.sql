-- Columns that models of older builds lack.

CREATE OR REPLACE FUNCTION streetgen._mend_interconnection_tables(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'turn_restriction', 'via_axes') THEN
        RETURN;
    END IF;
    EXECUTE format($sql$
ALTER TABLE %1$I.turn_restriction ADD via_axes bigint[], ADD via_geom geometry(MultiPoint, %2$s)
    CONSTRAINT via_geom_is_finite CHECK (%3$s), ADD to_geom geometry(Point, %2$s)
    CONSTRAINT to_geom_is_a_finite_point CHECK (%4$s), ADD CONSTRAINT each_via_axis_has_a_place
    CHECK (num_nulls(via_axes, via_geom, to_geom) = 3 OR num_nulls(via_axes, via_geom, to_geom) = 0
        AND cardinality(via_axes) = ST_NumGeometries(via_geom));
CREATE INDEX turn_restriction_to_geom ON %1$I.turn_restriction USING gist (coalesce(to_geom, geom));
CREATE INDEX turn_restriction_via_geom ON %1$I.turn_restriction USING gist (via_geom) WHERE via_axes IS NOT NULL
$sql$, model, srid, streetgen._finite('via_geom'), streetgen._finite('to_geom'));
END $$;
COMMENT ON FUNCTION streetgen._mend_interconnection_tables(name, integer) IS
    'Adds to table turn_restriction of a model what leads via axes, where that is missing.';
