-- The place of a decision by hand, filled from its axis where it is left out.

CREATE OR REPLACE FUNCTION streetgen._fill_place() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    axis geometry;
    place geometry;
    moved boolean;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    SELECT ST_Force2D(geom) FROM axis WHERE axis_id = NEW.axis_id INTO axis;
    IF axis IS NULL THEN
        RETURN NEW;
    END IF;
    IF TG_ARGV[0] = 'end' THEN
        moved := (NEW.axis_id, NEW.which) IS DISTINCT FROM (OLD.axis_id, OLD.which);
        place := streetgen._end_of(axis, NEW.which);
    ELSE
        moved := (NEW.axis_id, NEW.abscissa) IS DISTINCT FROM (OLD.axis_id, OLD.abscissa);
        place := CASE WHEN NEW.abscissa BETWEEN 0 AND ST_Length(axis)
            THEN ST_LineInterpolatePoint(axis, NEW.abscissa / ST_Length(axis)) END;
    END IF;
    IF NEW.geom IS NULL OR moved AND NEW.geom::bytea = OLD.geom::bytea THEN
        NEW.geom := place;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._fill_place() IS
    'Trigger of override tables: the place (geom) from axis and abscissa, or axis and end, where none is given or '
    'these change without it; NULL beyond the axis.';
