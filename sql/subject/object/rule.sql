-- Objects that rules place: where, and which of them stand.

CREATE OR REPLACE FUNCTION streetgen._check_placement_rule() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject constant text := CASE TG_OP WHEN 'INSERT' THEN 'the new rule' ELSE 'rule ' || OLD.rule_id END;
    length float8;
    run float8;
    least float8;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    IF NOT EXISTS (SELECT FROM object_type WHERE type = NEW.type) THEN
        PERFORM streetgen._refuse_type(TG_TABLE_SCHEMA, subject, NEW.type);
    END IF;
    IF NEW.turn IS DISTINCT FROM OLD.turn AND NEW.turn <> ALL (string_to_array(streetgen._turn_words(), '|')) THEN
        PERFORM streetgen._refuse('23514', format('the turn of %s cannot be "%s"', subject, NEW.turn),
            detail => format('Expected %s.', replace(streetgen._turn_words(), '|', ', ')),
            hint => 'Leave it empty for all arms.');
    END IF;
    IF NEW.every < 0.5 THEN
        SELECT coalesce(sum(ST_Length2D(geom)), 0) FROM axis INTO length;
        PERFORM streetgen._refuse('22023', format('%s cannot place an object every %s m', subject, NEW.every),
            detail => CASE WHEN NEW.every > 0 THEN format('It would place up to %s objects.',
                ceil(2 * length / NEW.every)) ELSE 'It would never end.' END,
            hint => 'At least 0.5 m lie between two objects of a rule.');
    END IF;
    PERFORM streetgen._check_edit_number('the distance between objects of ' || subject, NEW.every, 0.5, 10000, 'm',
            'At most ten kilometres.'),
        streetgen._check_edit_number('the phase of ' || subject, NEW.phase, 0, 10000, 'm', '0 begins with the axis.'),
        streetgen._check_edit_number('the density of ' || subject, NEW.density, 0, 1, NULL, '1 takes all places.'),
        streetgen._check_edit_number('the offset of ' || subject, NEW.axis_offset, -200, 200, 'm', 'Try 1 m.');
    IF NEW.along = 'lane' AND NOT streetgen._is_below(TG_TABLE_SCHEMA, NEW.type, 'parking_bay') THEN
        PERFORM streetgen._refuse('22023', format('%s cannot place objects of type "%s" on lanes', subject, NEW.type),
            detail => 'On a parking lane lie parking bays, and types below these.',
            hint => 'Set along to border, or type to parking_bay.');
    END IF;
    IF streetgen._is_below(TG_TABLE_SCHEMA, NEW.type, 'parking_bay') AND NEW.along = 'border' THEN
        run := streetgen._bay_run((streetgen._usual_bay()).length, (streetgen._usual_bay()).width,
            streetgen._bay_angle(NEW.orientation));
        least := CASE NEW.side WHEN 'alternating' THEN run / 2 ELSE run END;
        IF NEW.every < least THEN
            PERFORM streetgen._refuse('22023', format('%s cannot place a bay every %s m', subject, NEW.every),
                detail => format('A bay at %s degrees takes %s m of its border.',
                    streetgen._bay_angle(NEW.orientation), round(run::numeric, 2)),
                hint => format('Set every to %s m or more.', ceil(10 * least) / 10));
        END IF;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._check_placement_rule() IS
    'Trigger of placement_rule: a distance under 0.5 m or under what a bay takes of its border, a number out of its '
    'range, or a type that is none: 22023; a turn that is none: 23514.';

CREATE OR REPLACE FUNCTION streetgen._rule_takes(axis bigint, rule bigint, place integer, density float8)
    RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC
        SELECT density >= 1
            OR ((hashint8extended(axis, rule) # hashint4extended(place, rule)) & 1048575) < density * 1048576;
    END;
COMMENT ON FUNCTION streetgen._rule_takes(bigint, bigint, integer, float8) IS
    'Whether a rule takes a place along an axis: the same share of all places, and the same places each time.';

CREATE OR REPLACE FUNCTION streetgen._rule_statement(whole boolean) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT streetgen._fill_template(streetgen._fill_template(streetgen._part('renew_rule_objects'), jsonb_build_object(
            'rule_objects', streetgen._part('rule_objects'), 'streets_beside', streetgen._part(CASE WHEN whole
                THEN 'rule_streets' ELSE 'rule_streets_beside' END), 'of_streets', '{of_streets}')), holes)
    FROM (SELECT CASE WHEN whole THEN jsonb_build_object('spread', '', 'beside', 'false', 'away', '', 'from_away', '',
            'of_edges', 'true', 'near_enough', '', 'fresh', 'true', 'away_from_ground', '',
            'places_near_enough', '', 'of_held', 'true', 'of_streets', 'true',
            'changed', streetgen._part('no_rule_changes'))
        ELSE jsonb_build_object('spread', streetgen._part('rule_spread'), 'beside', 'e.axis_id <> ALL (axes)',
            'away', ', w.away', 'from_away', streetgen._part('rules_looked_at'),
            'of_edges', streetgen._part('rule_edges'), 'near_enough', streetgen._part('rules_near_enough'),
            'fresh', streetgen._part('fresh_places'),
            'away_from_ground', streetgen._part('away_from_ground'),
            'places_near_enough', streetgen._part('places_near_enough'), 'of_held', streetgen._part('rule_held'),
            'of_streets', 'axis_id = ANY (axes)', 'changed', streetgen._part('rule_changes')) END AS holes) h $$;
COMMENT ON FUNCTION streetgen._rule_statement(boolean) IS
    'The body of the function of a model that brings the objects of rules up to date: of all axes (whole), or of some '
    'and of what stands near ground that changed.';

CREATE OR REPLACE FUNCTION streetgen._make_rule_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _has_rules() RETURNS boolean
        LANGUAGE sql STABLE SET search_path FROM CURRENT
        AS $body$
        SELECT EXISTS (SELECT FROM placement_rule WHERE active)
            OR EXISTS (SELECT FROM setting WHERE name = 'placement_function' AND value <> 'none')
            OR _has_crossing_footways() $body$;
    CREATE OR REPLACE FUNCTION _has_rules_at_kerbs() RETURNS boolean
        LANGUAGE sql STABLE SET search_path FROM CURRENT
        AS $body$ SELECT EXISTS (SELECT FROM placement_rule WHERE active AND along IN ('border', 'corner')) $body$;
    PERFORM streetgen._compose_function(model, format('%s(axes bigint[], lying boolean, ground geometry[], '
            'edges bigint[], OUT streets bigint[], OUT moved geometry[])', name), 'record',
        streetgen._rule_statement(whole),
        format('%s(bigint[], boolean, geometry[], bigint[])', name), description,
        'VOLATILE PARALLEL UNSAFE SET jit = off SET streetgen.computes = ''on''')
    FROM (VALUES ('_renew_rule_objects', false, 'Brings the objects that rules place along axes up to date: those that '
            'lie on the roadway, or those that stand beside it. ground: those near ground that changed alone, of other '
            'axes too, and all of edges, which are of these axes. streets: axes of objects that came, went or '
            'changed; moved: their places, as they were and as they are'),
        ('_renew_all_rule_objects', true, 'The same for all axes; the arguments axes, ground and edges are NULL'))
        made(name, whole, description);
    CREATE OR REPLACE FUNCTION _take_from_rules(objects bigint[]) RETURNS void
        LANGUAGE sql VOLATILE SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
        INSERT INTO free_place (rule_id, geom) SELECT rule_id, geom FROM street_object
            WHERE street_object_id = ANY (objects) AND placed_by = 'rule' ORDER BY street_object_id;
        SELECT streetgen._keep_paint(current_schema(), objects);
        UPDATE street_object SET placed_by = 'user', rule_id = NULL, rule_place = NULL
            WHERE street_object_id = ANY (objects) AND placed_by = 'rule' $body$;
    PERFORM streetgen._own_function(model, '_has_rules()',
        'Whether any rule places objects, or footways make crossings'),
        streetgen._own_function(model, '_has_rules_at_kerbs()', 'Whether any rule places objects beside kerbs'),
        streetgen._own_function(model, '_take_from_rules(bigint[])',
        'Makes objects of rules those of the user, and leaves their places free');
END $$;
COMMENT ON FUNCTION streetgen._make_rule_functions(name) IS
    'Makes the functions of a model by which rules place objects.';
