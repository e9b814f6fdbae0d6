-- Parking bays: their ground along a border of the roadway.

CREATE OR REPLACE FUNCTION streetgen._usual_bay(OUT length float8, OUT width float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 5.0::float8, 2.3::float8 $$;
COMMENT ON FUNCTION streetgen._usual_bay() IS
    'Length and width (m) of a bay of which nothing is said, such as one that a rule places.';

CREATE OR REPLACE FUNCTION streetgen._bay_run(length float8, width float8, angle float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    RETURN CASE angle WHEN 0 THEN length ELSE width / sind(angle) END;
COMMENT ON FUNCTION streetgen._bay_run(float8, float8, float8) IS
    'What a bay takes of its border, metres: bays beside each other lie no closer.';

CREATE OR REPLACE FUNCTION streetgen._bay_depth(length float8, width float8, angle float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE angle WHEN 0 THEN width ELSE length * sind(angle) END;
COMMENT ON FUNCTION streetgen._bay_depth(float8, float8, float8) IS
    'How far a bay reaches from its border towards the roadway, metres.';

CREATE OR REPLACE FUNCTION streetgen._bay_ground(axis geometry, beside float8, side text, abscissa float8,
    length float8, width float8, angle float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN ST_IsSimple(ring) THEN ST_MakePolygon(ring) END
    FROM (SELECT CASE side WHEN 'left' THEN 1 ELSE -1 END AS outwards,
            streetgen._bay_run(length, width, angle) AS run,
            streetgen._bay_depth(length, width, angle) AS deep OFFSET 0) d,
        -- Who drives past on this side drives into it, and so the end at the border lies ahead.
        LATERAL (SELECT CASE angle WHEN 0 THEN 0 ELSE length * cosd(angle) * outwards END AS lean,
            abscissa - run / 2 AS low, abscissa + run / 2 AS high OFFSET 0) r,
        LATERAL (SELECT streetgen._place_on(axis::bytea, low, beside)::geometry AS p1,
            streetgen._place_on(axis::bytea, high, beside)::geometry AS p2,
            streetgen._place_on(axis::bytea, high + lean, beside - outwards * deep)::geometry AS p3,
            streetgen._place_on(axis::bytea, low + lean, beside - outwards * deep)::geometry AS p4) q,
        LATERAL (SELECT ST_MakeLine(ARRAY[p1, p2, p3, p4, p1]) AS ring OFFSET 0) g
    WHERE low + least(lean, 0) >= 0 AND high + greatest(lean, 0) <= ST_Length2D(axis) $$;
COMMENT ON FUNCTION streetgen._bay_ground(geometry, float8, text, float8, float8, float8, float8) IS
    'The ground (POLYGON) of a bay whose end at the border lies so many metres to the left of an axis, about an '
    'abscissa, and reaches from there towards the roadway; angle 0: beside the border. NULL where the axis ends before '
    'the bay does, or bends too sharply.';

CREATE OR REPLACE FUNCTION streetgen._bay_angle(orientation float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN orientation - 180 * floor(orientation / 180) < 10
            OR orientation - 180 * floor(orientation / 180) > 170 THEN 0
        ELSE greatest(20, least(160, orientation - 180 * floor(orientation / 180))) END;
COMMENT ON FUNCTION streetgen._bay_angle(float8) IS
    'The angle of a bay, degrees, that the orientation of a rule means: parallel within 10 degrees.';

CREATE OR REPLACE FUNCTION streetgen._bay_reach(length float8, width float8, angle float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE angle WHEN 0 THEN length / 2 ELSE width / sind(angle) / 2 + length * abs(cosd(angle)) END;
COMMENT ON FUNCTION streetgen._bay_reach(float8, float8, float8) IS
    'How far a bay reaches along the axis on either side of its abscissa, at most, metres.';

CREATE OR REPLACE FUNCTION streetgen._takes_ground(surface geometry, ground geometry) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_Intersects(surface, ground) AND ST_Area(ST_Intersection(surface, ground)) > 0.01 $$;
COMMENT ON FUNCTION streetgen._takes_ground(geometry, geometry) IS
    'Whether a surface takes more than a square decimetre of the ground of a bay.';

CREATE OR REPLACE FUNCTION streetgen._make_type_function(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _types_below(type text) RETURNS text[]
        LANGUAGE sql STABLE SET search_path FROM CURRENT
        AS $body$
        WITH RECURSIVE below AS (SELECT t.type FROM object_type t WHERE t.type = $1
            UNION SELECT t.type FROM below b JOIN object_type t ON t.parent = b.type)
        SELECT coalesce(array_agg(b.type), '{}') FROM below b $body$;
    PERFORM streetgen._own_function(model, '_types_below(text)', 'A type of objects and those below it');
END $$;
COMMENT ON FUNCTION streetgen._make_type_function(name) IS
    'Makes the function of a model that walks through the hierarchy of types.';

CREATE OR REPLACE FUNCTION streetgen._make_bay_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _renew_bays(objects bigint[], told boolean DEFAULT false, OUT moved geometry[])
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off SET streetgen.computes = 'on'
        AS $body$
    BEGIN
        IF objects = '{}' THEN
            RETURN;
        END IF;
        WITH new AS MATERIALIZED (
            SELECT b.street_object_id, b.surface AS was, streetgen._bay_ground(a.line,
                streetgen._border_offset(streetgen._to_border(a.width,
                    a.width_end, ST_Length2D(a.line), a.roadway_offset, a.borders, o.abscissa, o.side), o.axis_offset,
                    o.side),
                streetgen._side_of_street(o.side, o.axis_offset, a.roadway_offset), o.abscissa,
                b.length, b.width, b.angle) AS ground
            FROM parking_bay b JOIN street_object o USING (street_object_id)
                LEFT JOIN _street_of_objects(objects) a ON a.axis_id = o.axis_id AND o.method = 'relative'
            WHERE b.street_object_id = ANY (objects)),
        drawn AS (
            UPDATE parking_bay b SET surface = n.ground FROM new n
            WHERE n.street_object_id = b.street_object_id AND n.was::bytea IS DISTINCT FROM n.ground::bytea
            RETURNING n.was, n.ground)
        SELECT array_agg(was) FILTER (WHERE told) || array_agg(ground) FILTER (WHERE told) FROM drawn INTO moved;
    END $body$;
    PERFORM streetgen._own_function(model, '_renew_bays(bigint[], boolean)',
        'Draws the ground of parking bays anew; moved, where it is to be told: what changed, as it was and as it is');
END $$;
COMMENT ON FUNCTION streetgen._make_bay_functions(name) IS
    'Makes the function of a model by which parking bays follow their objects.';

CREATE OR REPLACE FUNCTION streetgen._edit_parking_bay() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text := CASE TG_OP WHEN 'INSERT' THEN 'the new bay' ELSE 'bay ' || OLD.street_object_id END;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{geom,axis_id,abscissa,side,axis_offset,length,width,angle}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    IF TG_OP <> 'INSERT' THEN
        PERFORM streetgen._enter_object_edit(TG_TABLE_SCHEMA, OLD.street_object_id, ARRAY[OLD.axis_id],
            ARRAY[OLD.geom]);
    END IF;
    IF TG_OP = 'DELETE' THEN
        DELETE FROM street_object WHERE street_object_id = OLD.street_object_id;
        RETURN OLD;
    END IF;
    PERFORM streetgen._check_edit_number('the length of ' || subject, NEW.length, 1, 30, 'm',
            (streetgen._usual_bay()).length || ' is usual.'),
        streetgen._check_edit_number('the width of ' || subject, NEW.width, 1, 10, 'm',
            (streetgen._usual_bay()).width || ' is usual.');
    IF NEW.angle <> 0 AND NOT NEW.angle BETWEEN 20 AND 160 THEN
        PERFORM streetgen._refuse('22023', format('the angle of %s cannot be %s', subject, NEW.angle),
            detail => 'Expected 0, or 20 to 160 degrees.',
            hint => '0 is parallel to the border, 90 perpendicular; beyond 90 it leans against the traffic.');
    END IF;
    IF TG_OP = 'INSERT' THEN
        INSERT INTO street_object_editing (type, geom, placement, axis_id, abscissa, side, axis_offset)
            VALUES ('parking_bay', NEW.geom, 'border', NEW.axis_id, NEW.abscissa, NEW.side, NEW.axis_offset)
            RETURNING street_object_id INTO NEW.street_object_id;
    ELSIF (NEW.geom, NEW.axis_id, NEW.abscissa, NEW.side, NEW.axis_offset)
        IS DISTINCT FROM (OLD.geom, OLD.axis_id, OLD.abscissa, OLD.side, OLD.axis_offset) THEN
        UPDATE street_object_editing SET geom = NEW.geom, axis_id = NEW.axis_id, abscissa = NEW.abscissa, side =
            NEW.side,
            axis_offset = NEW.axis_offset WHERE street_object_id = OLD.street_object_id;
    END IF;
    SELECT coalesce(NEW.length, u.length), coalesce(NEW.width, u.width), coalesce(NEW.angle, 0)
        FROM streetgen._usual_bay() u INTO NEW.length, NEW.width, NEW.angle;
    UPDATE parking_bay SET length = NEW.length, width = NEW.width, angle = NEW.angle
        WHERE street_object_id = NEW.street_object_id AND (length, width, angle) IS DISTINCT FROM (NEW.length,
            NEW.width, NEW.angle);
    SELECT * FROM parking_bay_editing WHERE street_object_id = NEW.street_object_id INTO NEW;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_parking_bay() IS
    'Trigger of parking_bay_editing: writes the object and its bay; a size or angle that is left empty is as usual. '
    'One without a street, a size or an angle out of its range: 22023. RETURNING gives the row as it is then.';

CREATE OR REPLACE FUNCTION streetgen._object_told_others(model name, computed text[]) RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (computed) THEN
        RETURN false;
    END IF;
    RETURN EXISTS (SELECT FROM sidewalk WHERE strip IS NOT NULL)
        OR EXISTS (SELECT FROM axis WHERE parking_left LIKE 'street\_side%' OR parking_right LIKE 'street\_side%');
END $$;
COMMENT ON FUNCTION streetgen._object_told_others(name, text[]) IS
    'Did bays cut or widen sidewalks of a model before objects were switched off? Then it is computed anew.';
