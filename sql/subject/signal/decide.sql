-- Signals by hand: the edit view of controllers, and green waves.

CREATE OR REPLACE FUNCTION streetgen._decide_controller(model name, controller bigint, decided jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known constant bigint[] := streetgen._overrides_at_junction(model, 'controller_override', controller);
BEGIN
    PERFORM streetgen._use_model(model);
    DELETE FROM controller_override WHERE controller_override_id = ANY (known[2:]);
    IF known = '{}' AND jsonb_strip_nulls(decided) <> '{}' THEN
        INSERT INTO controller_override (axis_id, geom, program, cycle, start_offset, durations, turn_phases, phases,
            approaches)
        SELECT e.axis_id, ST_Force2D(n.geom), d.program, d.cycle, d.start_offset, d.durations, d.turn_phases, d.phases,
            d.approaches
        FROM junction_node m JOIN node n USING (node_id) JOIN edge e ON n.node_id IN (e.from_node, e.to_node),
            jsonb_populate_record(NULL::controller_override, decided) d
        WHERE m.junction_id = controller ORDER BY e.edge_id LIMIT 1;
    ELSE
        UPDATE controller_override o SET (program, cycle, start_offset, durations, turn_phases, phases, approaches)
            = ROW (d.program, d.cycle, d.start_offset, d.durations, d.turn_phases, d.phases, d.approaches)
        FROM controller_override k, jsonb_populate_record(k, decided) d
        WHERE o.controller_override_id = known[1] AND k.controller_override_id = known[1];
        DELETE FROM controller_override WHERE controller_override_id = known[1]
            AND num_nonnulls(program, cycle, start_offset, durations, turn_phases) = 0;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._decide_controller(name, bigint, jsonb) IS
    'Writes what is decided of a controller (columns of controller_override; others stay as decided before; NULL takes '
    'back).';

CREATE OR REPLACE FUNCTION streetgen._edit_controller() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Another program has other states.
    none constant jsonb := streetgen._typed_durations(TG_TABLE_SCHEMA, NULL, NULL);
    subject text;
    taken_back boolean := TG_OP = 'DELETE';
    decided jsonb := '{}';
    known bigint[];
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse('0A000', 'a controller cannot be drawn',
            hint => 'Put a row of kind signals into control_point, or give the junction that kind.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{program,cycle,start_offset,durations,turn_phases,by_hand}',
            'A controller moves with its junction.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := 'controller ' || OLD.controller_id;
    PERFORM streetgen._lock_junctions(TG_TABLE_SCHEMA, ARRAY[OLD.controller_id]);
    IF NOT taken_back THEN
        taken_back := OLD.by_hand AND NEW.by_hand IS NOT TRUE;
    END IF;
    IF taken_back THEN
        known := streetgen._overrides_at_junction(TG_TABLE_SCHEMA, 'controller_override', OLD.controller_id);
        DELETE FROM controller_override WHERE controller_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    IF NEW.program IS DISTINCT FROM OLD.program THEN
        IF NEW.program NOT IN ('phases', 'paper') THEN
            PERFORM streetgen._refuse('22023', format('the program of %s is "%s"', subject, NEW.program),
                hint => 'phases or paper; a function of your own is for setting signal_program. NULL takes back what '
                    'was decided by hand.');
        END IF;
        decided := decided || jsonb_build_object('program', NEW.program) || none;
    END IF;
    IF NEW.turn_phases IS DISTINCT FROM OLD.turn_phases THEN
        decided := decided || jsonb_build_object('turn_phases', NEW.turn_phases) || none;
    END IF;
    IF NEW.cycle IS DISTINCT FROM OLD.cycle THEN
        PERFORM streetgen._check_edit_number('the cycle of ' || subject, NEW.cycle, 10, 3600, 's',
            'Delete the row to take back what was decided by hand.');
        decided := decided || jsonb_build_object('cycle', NEW.cycle);
    END IF;
    IF NEW.start_offset IS DISTINCT FROM OLD.start_offset THEN
        PERFORM streetgen._check_edit_number('the offset of ' || subject, NEW.start_offset, 0, 3600, 's',
            'Delete the row to take back what was decided by hand.');
        decided := decided || jsonb_build_object('start_offset', NEW.start_offset);
    END IF;
    IF NEW.durations IS DISTINCT FROM OLD.durations THEN
        IF cardinality(NEW.durations) <> cardinality(OLD.durations)
            OR NEW.durations IS NOT NULL
                AND NOT coalesce(0.1 <= ALL (NEW.durations) AND 3600 >= ALL (NEW.durations), false)
        THEN
            PERFORM streetgen._refuse('22023', format('the durations of %s are %s', subject, NEW.durations::text),
                hint => format('It has %s states of 0.1 to 3600 s each.', cardinality(OLD.durations)));
        END IF;
        decided := decided || streetgen._typed_durations(TG_TABLE_SCHEMA, OLD.controller_id, NEW.durations);
    END IF;
    IF decided <> '{}' THEN
        PERFORM streetgen._decide_controller(TG_TABLE_SCHEMA, OLD.controller_id, decided);
    ELSIF NOT OLD.by_hand THEN
        PERFORM streetgen._refuse('22023', format('nothing is decided by hand of %s', subject),
            hint => 'Type program, cycle, start_offset, durations or turn_phases, and by_hand follows.');
    END IF;
    NEW.by_hand := streetgen._overrides_at_junction(TG_TABLE_SCHEMA, 'controller_override', OLD.controller_id) <> '{}';
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_controller() IS
    'Trigger of controller_editing: writes controller_override. An unknown program, a cycle, offset or duration out of '
    'range: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._route_controllers(model name, axes bigint[])
    RETURNS TABLE(controller_id bigint, metres float8, start float8, lane_in bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH street AS (SELECT a.axis_id, k, ST_Force2D(a.geom) AS geom FROM unnest(axes) WITH ORDINALITY u(axis_id, k)
        JOIN axis a USING (axis_id)),
    driven AS (SELECT s.*, CASE WHEN p.geom IS NOT NULL THEN ST_Distance(ST_StartPoint(s.geom), p.geom)
            <= ST_Distance(ST_EndPoint(s.geom), p.geom) WHEN n.geom IS NOT NULL THEN ST_Distance(ST_EndPoint(s.geom),
            n.geom) <= ST_Distance(ST_StartPoint(s.geom), n.geom) ELSE true END AS along
        FROM street s LEFT JOIN street p ON p.k = s.k - 1 LEFT JOIN street n ON n.k = s.k + 1),
    part AS (SELECT e.edge_id, d.along, CASE WHEN d.along THEN e.to_node ELSE e.from_node END AS node_id, e.geom,
            j.edge_id IS NOT NULL AS inside,
            row_number() OVER (ORDER BY d.k, CASE WHEN d.along THEN e.start_abscissa ELSE -e.start_abscissa END) AS nth,
            sum(ST_Length(e.geom)) OVER (ORDER BY d.k, CASE WHEN d.along THEN e.start_abscissa ELSE -e.start_abscissa
                END)
                - ST_Length(e.geom) AS before
        FROM driven d JOIN edge e USING (axis_id) LEFT JOIN junction_edge j USING (edge_id)),
    step AS (SELECT p.*, n.edge_id AS next_edge FROM part p CROSS JOIN LATERAL (SELECT q.edge_id FROM part q
        WHERE q.nth > p.nth AND NOT q.inside ORDER BY q.nth LIMIT 1) n WHERE NOT p.inside),
    green AS (SELECT DISTINCT ON (s.nth) s.nth, m.controller_id, m.ordinality, m.lane_in, s.before + ST_Length(s.geom)
            * abs(CASE WHEN s.along THEN 0 ELSE 1 END - ST_LineLocatePoint(s.geom, h.geom)) AS metres
        FROM step s JOIN lane i ON i.edge_id = s.edge_id JOIN signal_movement m ON m.lane_in = i.lane_id
            AND m.along_in = s.along JOIN lane o ON o.lane_id = m.lane_out AND o.edge_id = s.next_edge
            JOIN signal_head h ON (h.lane_id, h.along_axis) = (m.lane_in, m.along_in)
        ORDER BY s.nth, m.right_of_way = 'permitted', m.ordinality, m.lane_in)
    SELECT g.controller_id, g.metres, coalesce((SELECT sum(t.duration) FROM signal_state t
        WHERE t.controller_id = g.controller_id AND t.ordinality < g.ordinality), 0), g.lane_in
    FROM green g ORDER BY g.nth;
END $$;
COMMENT ON FUNCTION streetgen._route_controllers(name, bigint[]) IS
    'The controllers that one passes along axes, in order: metres from the start to where one waits, seconds from the '
    'start of the cycle to the green of whoever goes on along the axes, and the lane that it is for.';

CREATE OR REPLACE FUNCTION streetgen.coordinate(model name, axes bigint[], speed float8)
    RETURNS TABLE(controller_id bigint, metres float8, cycle float8, start_offset float8)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    passed bigint[];
    common float8;
    step float8;
    missing bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('axes', axes::text, 'speed', speed::text);
    IF 'signal' <> ALL (streetgen._subjects(model)) THEN
        RAISE EXCEPTION 'model "%" computes no signals', model USING ERRCODE = '55000',
            HINT = format('SELECT * FROM streetgen.switch_subject(%L, ''signal'', true) computes them.', model);
    ELSIF NOT speed BETWEEN 5 AND 200 THEN
        RAISE EXCEPTION 'speed is % km/h', speed USING ERRCODE = '22023', HINT = 'Expected 5 to 200 km/h.';
    END IF;
    SELECT min(u.axis_id) FROM unnest(axes) u(axis_id) WHERE NOT EXISTS (SELECT FROM axis a
        WHERE a.axis_id = u.axis_id) INTO missing;
    IF missing IS NOT NULL THEN
        RAISE EXCEPTION 'there is no axis %', missing USING ERRCODE = '22023', HINT = 'Name axes in driving order.';
    END IF;
    passed := ARRAY(SELECT DISTINCT r.controller_id FROM streetgen._route_controllers(model, axes) r ORDER BY 1);
    PERFORM streetgen._lock_junctions(model, passed);
    SELECT value::float8 FROM setting WHERE name = 'signal_step' INTO step;
    SELECT max(c.cycle) FROM controller c WHERE c.controller_id = ANY (passed) INTO common;
    -- One cycle for all; then the starts of green are known.
    PERFORM streetgen._decide_controller(model, c, jsonb_build_object('cycle', common)) FROM unnest(passed) c;
    -- A car at that speed comes two seconds after the start of each green.
    PERFORM streetgen._decide_controller(model, r.controller_id, jsonb_build_object('start_offset',
            mod(mod(o.seconds, common::numeric) + common::numeric, common::numeric)))
        FROM (SELECT DISTINCT ON (p.controller_id) p.* FROM streetgen._route_controllers(model, axes) p
            ORDER BY p.controller_id, p.metres) r,
            LATERAL (SELECT (round((r.metres / (speed / 3.6) - r.start - 2) / step) * step)::numeric AS seconds) o;
    RETURN QUERY SELECT c.controller_id, r.metres, c.cycle, c.start_offset FROM controller c
        JOIN streetgen._route_controllers(model, axes) r USING (controller_id) ORDER BY r.metres;
END $$;
COMMENT ON FUNCTION streetgen.coordinate(name, bigint[], float8) IS
    'A green wave along axes in driving order, for who drives at a speed (km/h, 5 to 200): all controllers on the way '
    'get the longest of their cycles and offsets, as decided by hand, so that he comes two seconds after each green '
    'begins. Returns the controllers with the metres from the start to where one waits, cycle and offset, seconds. An '
    'unknown axis, another speed: 22023; NULL: 22004; a model without signals: 55000.';

CREATE OR REPLACE FUNCTION streetgen._signal_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('controller_editing', 'Edit layer: type program, cycle, offset, durations or phases of turns; DELETE takes back '
        'what was decided by hand',
        ARRAY['key', 'phases, paper, or a function; NULL takes it back', 'seconds; NULL takes it back',
            'seconds after which a cycle begins; NULL takes it back', 'seconds of each state; NULL takes them back',
            'do turns across others have a phase of their own? NULL: as lanes and speed say',
            'decided by hand; false takes it back', 'the junction'],
        $sql$SELECT c.controller_id, c.program, c.cycle, c.start_offset,
            ARRAY(SELECT s.duration FROM {model}.signal_state s WHERE s.controller_id = c.controller_id
                ORDER BY s.ordinality) AS durations, c.turn_phases, c.method = 'by_hand' AS by_hand, c.geom
        FROM {model}.controller c$sql$, 'signal') $$;
COMMENT ON FUNCTION streetgen._signal_edit_view() IS 'The views in which signals are edited.';

CREATE OR REPLACE FUNCTION streetgen._signal_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('controller_override'::name, 'vertex', '{axis_id}'::name[], '3 * {tolerance}', jsonb_build_object(
        'approaches', 'ST_Translate(o.approaches, ST_X(n.geom) - ST_X(o.geom), ST_Y(n.geom) - ST_Y(o.geom))'), true, 9,
        'ROW(o.geom::bytea, o.program, o.cycle, o.start_offset, o.durations, o.turn_phases, o.phases, '
            'o.approaches::bytea)') $$;
COMMENT ON FUNCTION streetgen._signal_decision() IS
    'The anchors of decisions about signals, and which of their columns follow the axes.';
