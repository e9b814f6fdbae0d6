-- The table of heights along edges.
CREATE OR REPLACE FUNCTION streetgen._make_height_tables(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    statement text;
BEGIN
    FOREACH statement IN ARRAY ARRAY[
        $t$CREATE TABLE %1$I.profile (
            edge_id bigint PRIMARY KEY REFERENCES %1$I.edge ON DELETE CASCADE,
            geom geometry(LineStringZ, %2$s) NOT NULL, grade_max float8 NOT NULL, method text NOT NULL)$t$,
        $t$CREATE INDEX profile_off_ground ON %1$I.profile (edge_id) WHERE method <> 'ground'$t$,
        $t$CREATE INDEX profile_geom ON %1$I.profile USING gist (geom)$t$,
        $t$COMMENT ON TABLE %1$I.profile
            IS 'Heights along edges: those of the ground, or the least ones that keep clearances and grades where '
            'roads pass over and under each other'$t$
    ] LOOP
        EXECUTE format(statement, model, srid);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_height_tables(name, integer) IS 'Makes the table profile of a model.';
