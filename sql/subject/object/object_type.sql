-- Types of objects, and the triggers that prove and place what users write.

CREATE OR REPLACE FUNCTION streetgen._default_object_type()
    RETURNS TABLE(type text, category text, parent text, geometry text, symbol text, size float8, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 28 SET search_path = pg_catalog
    AS $$ VALUES
    ('crossing', 'traffic', NULL, 'point', 'crossing', 4, 'a pedestrian crossing'),
    ('pole', 'furniture', NULL, 'point', 'circle', 0.3, 'a pole that carries something'),
    ('lamp', 'furniture', 'pole', 'point', 'star', 0.4, 'a street lamp'),
    ('traffic_light', 'traffic', 'pole', 'point', 'diamond', 0.4, 'a signal for traffic'),
    ('sign', 'traffic', 'pole', 'point', 'triangle', 0.6, 'a traffic sign'),
    ('arrow', 'traffic', NULL, 'point', 'arrow', 3, 'an arrow painted on the roadway'),
    ('tree', 'green', NULL, 'point', 'tree', 6, 'a tree; its size is that of the crown'),
    ('hedge', 'green', NULL, 'line', 'line', 1, 'a hedge along a street'),
    ('barrier', 'protection', NULL, 'line', 'line', 0.3, 'a barrier that keeps people or cars back'),
    ('guard_rail', 'protection', 'barrier', 'line', 'line', 0.4, 'a guard rail'),
    ('bollard', 'protection', NULL, 'point', 'circle', 0.2, 'a bollard'),
    ('bench', 'furniture', NULL, 'point', 'rectangle', 1.8, 'a bench'),
    ('kiosk', 'furniture', NULL, 'point', 'square', 3, 'a kiosk'),
    ('bus_stop', 'traffic', NULL, 'point', 'square', 1, 'where buses stop'),
    ('tram_stop', 'traffic', NULL, 'point', 'square', 1, 'where trams stop'),
    ('platform', 'traffic', NULL, 'point', 'rectangle', 2, 'where people wait for trams'),
    ('parking_bay', 'traffic', NULL, 'point', 'bay', 5, 'a place where a car parks'),
    ('traffic_calming', 'calming', NULL, 'point', 'rectangle', 5, 'what slows traffic'),
    ('speed_bump', 'calming', 'traffic_calming', 'point', 'rectangle', 5, 'a short bump across the roadway'),
    ('speed_hump', 'calming', 'traffic_calming', 'point', 'rectangle', 6, 'a hump across the roadway'),
    ('speed_table', 'calming', 'traffic_calming', 'point', 'rectangle', 8, 'a raised piece of roadway'),
    ('speed_cushion', 'calming', 'traffic_calming', 'point', 'rectangle', 3, 'a hump that wide vehicles straddle'),
    ('rumble_strip', 'calming', 'traffic_calming', 'point', 'rectangle', 5, 'strips that one hears and feels'),
    ('choker', 'calming', 'traffic_calming', 'point', 'rectangle', 3, 'a place where the roadway is narrow'),
    ('chicane', 'calming', 'traffic_calming', 'point', 'rectangle', 3, 'a place where one drives round obstacles'),
    ('traffic_island', 'calming', 'traffic_calming', 'point', 'rectangle', 3, 'an island in the roadway'),
    ('manhole', 'ground', NULL, 'point', 'circle', 0.7, 'a manhole'),
    ('runway_light', 'traffic', NULL, 'point', 'circle', 0.3, 'a light of a runway') $$;
COMMENT ON FUNCTION streetgen._default_object_type() IS 'The types of objects that a model starts with.';

CREATE OR REPLACE FUNCTION streetgen._make_object_triggers(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF to_regclass(format('%I.street_object', model)) IS NOT NULL THEN
        CREATE OR REPLACE TRIGGER place_object BEFORE INSERT OR UPDATE ON street_object FOR EACH ROW
            WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
            EXECUTE FUNCTION streetgen._place_object();
        COMMENT ON TRIGGER place_object ON street_object
            IS 'Computes place and direction of what an axis or border places';
        CREATE OR REPLACE TRIGGER check_rule BEFORE INSERT OR UPDATE ON placement_rule FOR EACH ROW
            EXECUTE FUNCTION streetgen._check_placement_rule();
        COMMENT ON TRIGGER check_rule ON placement_rule IS 'Says what a rule may hold';
        CREATE OR REPLACE TRIGGER check_hierarchy BEFORE INSERT OR UPDATE ON object_type FOR EACH ROW
            EXECUTE FUNCTION streetgen._check_object_type();
        COMMENT ON TRIGGER check_hierarchy ON object_type IS 'Refuses a type that would stand below itself';
        CREATE OR REPLACE TRIGGER carry_object AFTER UPDATE ON control_point FOR EACH ROW
            WHEN (NEW.geom::bytea IS DISTINCT FROM OLD.geom::bytea) EXECUTE FUNCTION
                streetgen._carry_controlled_object();
        CREATE OR REPLACE TRIGGER release_object AFTER DELETE ON control_point FOR EACH ROW
            EXECUTE FUNCTION streetgen._carry_controlled_object();
        COMMENT ON TRIGGER carry_object ON control_point IS 'The object of a control point goes with it';
        COMMENT ON TRIGGER release_object ON control_point IS 'The object of a control point stays without it';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_object_triggers(name) IS
    'Makes the triggers that prove and place objects, also where the subject is switched off.';

CREATE OR REPLACE FUNCTION streetgen._is_below(model name, type text, above text) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    at text COLLATE "default" := type;
BEGIN
    PERFORM streetgen._use_model(model);
    WHILE at IS NOT NULL AND at <> above LOOP
        at := (SELECT parent FROM object_type t WHERE t.type = at);
    END LOOP;
    RETURN at IS NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._is_below(name, text, text) IS
    'Whether a type of objects is another one, or stands below it.';

CREATE OR REPLACE FUNCTION streetgen._check_object_type() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF TG_OP = 'UPDATE' AND NEW.type <> OLD.type AND OLD.type IN ('crossing', 'parking_bay') THEN
        PERFORM streetgen._refuse('22023', format('object type "%s" cannot be renamed', OLD.type),
            detail => 'Its objects have rows of a table of their own.',
            hint => 'Add a type with this one as its parent: its objects have such rows too.');
    END IF;
    IF NEW.parent = NEW.type OR streetgen._is_below(TG_TABLE_SCHEMA, NEW.parent, coalesce(OLD.type, NEW.type)) THEN
        PERFORM streetgen._refuse('22023', format('object type "%s" cannot stand below "%s"', NEW.type, NEW.parent),
            detail => format('%I stands below %I itself.', NEW.parent, NEW.type),
            hint => 'Take another parent, or none.');
    ELSIF NEW.symbol IS DISTINCT FROM OLD.symbol AND NEW.symbol NOT IN ('arrow', 'bay', 'circle', 'crossing', 'diamond',
        'line', 'rectangle', 'square', 'star', 'tree', 'triangle') THEN
        PERFORM streetgen._refuse('23514', format('the symbol of object type "%s" cannot be "%s"', NEW.type,
                NEW.symbol),
            detail => 'Expected arrow, bay, circle, crossing, diamond, line, rectangle, square, star, tree or '
                'triangle.',
            hint => 'Leave it out for a circle.');
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._check_object_type() IS
    'Trigger of object_type: a type that would stand below itself, or another name for crossing or parking_bay, is '
    'refused, 22023; a symbol that is none: 23514.';

CREATE OR REPLACE FUNCTION streetgen._object_edited() RETURNS TABLE(relation name)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 6 SET search_path = pg_catalog
    -- That table names functions, which run with the rights of the owner.
    AS $$ SELECT t.relation FROM streetgen.template t
        WHERE (t.room, t.part) = ('object', 'kept_table') AND t.relation <> 'specialised_type' $$;
COMMENT ON FUNCTION streetgen._object_edited() IS 'The tables of objects that an editor may write.';
