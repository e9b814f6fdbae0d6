-- Pedestrian crossings: their ground between the borders of the roadway, and their stripes.

CREATE OR REPLACE FUNCTION streetgen._on_roadway(ground geometry, surfaces geometry[]) RETURNS geometry
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Its border lies on that of a section but for rounding.
    inner_ground constant geometry := ST_Scale(ground, ST_MakePoint(0.999, 0.999), ST_Centroid(ground));
    roadway geometry;
BEGIN
    -- Its borders cross where the axis turns back beside it.
    IF NOT (ST_IsValidDetail(ground)).valid THEN
        RETURN NULL;
    ELSIF EXISTS (SELECT FROM unnest(surfaces) s WHERE ST_Covers(s, inner_ground)) THEN
        RETURN ground;
    END IF;
    roadway := ST_Union(surfaces);
    IF ST_Covers(roadway, inner_ground) THEN
        RETURN ground;
    END IF;
    RETURN (SELECT geom FROM ST_Dump(ST_CollectionExtract(ST_Intersection(ground, roadway), 3))
        ORDER BY ST_Area(geom) DESC, path LIMIT 1);
END $$;
COMMENT ON FUNCTION streetgen._on_roadway(geometry, geometry[]) IS
    'The ground (POLYGON) of a crossing as far as it lies on roadway, given as surfaces: the largest piece, NULL where '
    'there is none; as it is where less than a thousandth of its size lies beside the roadway.';

CREATE OR REPLACE FUNCTION streetgen._make_crossing_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _renew_crossings(objects bigint[], told boolean DEFAULT false, OUT moved geometry[])
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off SET streetgen.computes = 'on'
        AS $body$
    BEGIN
        IF objects = '{}' THEN
            RETURN;
        END IF;
        WITH drawn AS MATERIALIZED (
            SELECT c.street_object_id, c.surface AS was, c.stripes AS stripes_were, c.painted_as AS painted_was,
                c.footway_id AS footway_was, f.footway_id, ARRAY[c.kerb_left, c.kerb_right] AS kerbs_were, k.kerbs,
                l.painted_as, a.level, g.ground, c.island AS island_was, i.island,
                CASE WHEN g.ground IS NOT NULL AND l.painted_as NOT IN ('surface', 'no')
                    THEN streetgen._crossing_stripes(a.line::bytea, w.borders, o.abscissa, c.width, c.angle,
                        l.painted_as)::geometry END AS stripes
            FROM pedestrian_crossing c JOIN street_object o USING (street_object_id)
                LEFT JOIN _street_of_objects(objects) a ON a.axis_id = o.axis_id AND o.method = 'relative'
                LEFT JOIN footway f ON f.footway_id = _footway_over(o.geom, a.level)
                LEFT JOIN LATERAL (SELECT p.* FROM control_point p WHERE p.control_point_id = o.control_point_id
                    UNION ALL (SELECT p.* FROM control_point p
                        WHERE o.control_point_id IS NULL AND p.kind = 'pedestrian_crossing'
                        AND ST_DWithin(p.geom, o.geom, 1) ORDER BY ST_Distance(p.geom, o.geom), control_point_id
                        LIMIT 1)) p ON true
                CROSS JOIN LATERAL (SELECT coalesce(c.marking, nullif(f.marking, 'yes'), p.marking, f.marking,
                    -- Nothing is painted where nobody says that people cross, nor over a drive.
                    CASE WHEN o.rule_id = -1 AND p.geom IS NULL AND (f.role IS DISTINCT FROM 'crossing' OR EXISTS (
                        SELECT FROM axis x JOIN axis_class k ON k.class = x.kind
                        WHERE x.axis_id = o.axis_id AND NOT k.crossed_on_foot)) THEN 'no' END) AS said) s
                CROSS JOIN LATERAL (SELECT coalesce(nullif(s.said, 'yes'), (
                    -- A cycle track goes on between dashes.
                    SELECT 'dashes' FROM axis_class k WHERE o.rule_id = -1 AND k.class = f.kind AND k.use = 'cycle'), (
                    SELECT value FROM setting WHERE name = CASE WHEN p.geom IS NOT NULL AND EXISTS (
                        SELECT FROM control_point s WHERE s.kind = 'signals' AND ST_DWithin(s.geom, p.geom, 1))
                        THEN 'crossing_marking_at_signals' ELSE 'crossing_marking' END)) AS painted_as OFFSET 0) l
                LEFT JOIN LATERAL (SELECT coalesce(a.borders, streetgen._even_borders(a.width, a.width_end,
                    ST_Length2D(a.line), a.roadway_offset)) AS borders OFFSET 0) w ON a.line IS NOT NULL
                LEFT JOIN LATERAL (SELECT streetgen._crossing_ground(a.line::bytea, w.borders, o.abscissa, c.width,
                    c.angle)::geometry AS ground OFFSET 0) g ON true
                CROSS JOIN LATERAL (SELECT array_agg(coalesce(c.kerb, _footway_kerb_at(foot, across), p.kerb)
                    ORDER BY side) AS kerbs FROM (
                        SELECT side, foot, coalesce(lead(foot) OVER by_side, lag(foot) OVER by_side) AS across
                        FROM (VALUES ('left', 1), ('right', -1)) v(side, outwards),
                            LATERAL (SELECT outwards * streetgen._border_at(w.borders, o.abscissa, side) AS aside) b,
                            LATERAL (SELECT streetgen._place_on(a.line::bytea, o.abscissa + aside * cotd(c.angle),
                                aside)::geometry AS foot) e
                        WINDOW by_side AS (ORDER BY side)) e) k
                LEFT JOIN LATERAL (SELECT _refuge(o.axis_id, a.line, o.abscissa, c.width, c.angle, coalesce(c.refuge,
                    CASE p.refuge WHEN 'yes' THEN (SELECT value::float8 FROM setting WHERE name = 'refuge_width')
                        END)) AS island) i ON g.ground IS NOT NULL
            WHERE c.street_object_id = ANY (objects)),
        -- A kerb may lie within the border that the width of the axis gives, as where a street tapers.
        clipped AS MATERIALIZED (
            SELECT d.*, k.kept FROM drawn d LEFT JOIN LATERAL (
                SELECT streetgen._on_roadway(d.ground, ARRAY(
                    SELECT surface FROM section WHERE surface && d.ground
                        AND (SELECT e.level FROM edge e WHERE e.edge_id = section.edge_id) = d.level
                    UNION ALL SELECT surface FROM intersection WHERE surface && d.ground AND level = d.level))
                    AS kept) k ON d.ground IS NOT NULL),
        new AS MATERIALIZED (
            -- Stripe by stripe, since they may touch in a bend.
            SELECT street_object_id, was, stripes_were, painted_was, painted_as, footway_was, footway_id,
                kerbs_were, kerbs, kept AS ground, island_was, island, CASE WHEN island IS NULL THEN paint
                    ELSE (SELECT ST_Multi(ST_CollectionExtract(ST_Collect(ST_Difference(s.geom, island)
                        ORDER BY path), 3)) FROM ST_Dump(paint) s) END AS stripes
            FROM clipped, LATERAL (SELECT CASE WHEN painted_as = 'surface' THEN ST_Multi(kept)
                WHEN kept = ground THEN stripes ELSE (
                    SELECT ST_Multi(ST_CollectionExtract(ST_Collect(ST_Intersection(s.geom, kept) ORDER BY path), 3))
                    FROM ST_Dump(stripes) s) END AS paint) l),
        drawn_anew AS (
            UPDATE pedestrian_crossing c SET surface = n.ground, stripes = n.stripes, painted_as = n.painted_as,
                footway_id = n.footway_id, kerb_left = n.kerbs[1], kerb_right = n.kerbs[2], island = n.island
            FROM new n WHERE n.street_object_id = c.street_object_id
                AND (n.was::bytea, n.stripes_were::bytea, n.painted_was, n.footway_was, n.kerbs_were,
                    n.island_was::bytea) IS DISTINCT FROM (n.ground::bytea, n.stripes::bytea, n.painted_as,
                    n.footway_id, n.kerbs, n.island::bytea)
            RETURNING n.was, n.ground)
        SELECT array_agg(was) FILTER (WHERE told) || array_agg(ground) FILTER (WHERE told) FROM drawn_anew INTO moved;
    END $body$;
    PERFORM streetgen._own_function(model, '_renew_crossings(bigint[], boolean)',
        'Draws ground and stripes of crossings anew; moved, where it is to be told: what changed, as it was and as it '
        'is');
END $$;
COMMENT ON FUNCTION streetgen._make_crossing_functions(name) IS
    'Makes the function of a model by which crossings follow their objects.';

CREATE OR REPLACE FUNCTION streetgen._edit_pedestrian_crossing() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text := CASE TG_OP WHEN 'INSERT' THEN 'the new crossing' ELSE 'crossing ' || OLD.street_object_id END;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{geom,axis_id,abscissa,width,angle,marking,kerb,refuge}');
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
    PERFORM streetgen._check_edit_number('the width of ' || subject, NEW.width, 0.5, 20, 'm',
            (streetgen._usual_crossing()).width || ' is usual.'),
        streetgen._check_edit_number('the angle of ' || subject, NEW.angle, 20, 160, 'degrees', '90 is square.');
    IF TG_OP = 'INSERT' THEN
        INSERT INTO street_object_editing (type, geom, placement, axis_id, abscissa)
            VALUES ('crossing', NEW.geom, 'axis', NEW.axis_id, NEW.abscissa) RETURNING street_object_id
                INTO NEW.street_object_id;
    ELSIF (NEW.geom, NEW.axis_id, NEW.abscissa) IS DISTINCT FROM (OLD.geom, OLD.axis_id, OLD.abscissa) THEN
        UPDATE street_object_editing SET geom = NEW.geom, axis_id = NEW.axis_id, abscissa = NEW.abscissa
            WHERE street_object_id = OLD.street_object_id;
        -- A crossing that a footway made has the paint by hand now that it had.
        IF NEW.marking IS NOT DISTINCT FROM OLD.marking THEN
            SELECT c.marking FROM pedestrian_crossing c WHERE c.street_object_id = OLD.street_object_id
                INTO NEW.marking;
        END IF;
    END IF;
    SELECT coalesce(NEW.width, u.width), coalesce(NEW.angle, u.angle) FROM streetgen._usual_crossing() u
        INTO NEW.width, NEW.angle;
    UPDATE pedestrian_crossing SET width = NEW.width, angle = NEW.angle, marking = NEW.marking, kerb = NEW.kerb,
            refuge = NEW.refuge
        WHERE street_object_id = NEW.street_object_id AND (width, angle, marking, kerb, refuge)
            IS DISTINCT FROM (NEW.width, NEW.angle, NEW.marking, NEW.kerb, NEW.refuge);
    SELECT * FROM pedestrian_crossing_editing WHERE street_object_id = NEW.street_object_id INTO NEW;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_pedestrian_crossing() IS
    'Trigger of pedestrian_crossing_editing: writes the object and its crossing; a width or angle that is left empty '
    'is as usual. One without a street, a width or an angle out of its range: 22023. RETURNING gives the row as it is '
    'then.';
