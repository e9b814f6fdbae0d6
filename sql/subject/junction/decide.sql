-- Junctions by hand: their kinds (junction_editing), and the edges that lie in one (junction_edge_editing).

CREATE OR REPLACE FUNCTION streetgen._overrides_at_junction(model name, relation name, junction bigint)
    RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known bigint[];
BEGIN
    EXECUTE streetgen._fill_template(streetgen._part('overrides_at_junction'),
            jsonb_build_object('model', quote_ident(model), 'override', quote_ident(relation)))
        INTO known USING junction;
    RETURN known;
END $$;
COMMENT ON FUNCTION streetgen._overrides_at_junction(name, name, bigint) IS
    'The rows of an override table whose nearest node on their axis lies in a junction, no farther than '
    'control_distance, the one that holds first.';

CREATE OR REPLACE FUNCTION streetgen._lock_junctions(model name, junctions bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._lock_axes(model, format('SELECT e.axis_id FROM %1$I.junction_node m JOIN %1$I.edge e '
        'ON m.node_id IN (e.from_node, e.to_node) WHERE m.junction_id = ANY (%2$L)', model, junctions));
END $$;
COMMENT ON FUNCTION streetgen._lock_junctions(name, bigint[]) IS 'Locks the axes at junctions.';

CREATE OR REPLACE FUNCTION streetgen._nodes_to_decide(model name, junction bigint, OUT axes bigint[],
    OUT places geometry[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT array_agg(axis_id ORDER BY node_id), array_agg(geom ORDER BY node_id)
    FROM (SELECT n.node_id, ST_Force2D(n.geom) AS geom, (array_agg(e.axis_id ORDER BY e.edge_id))[1] AS axis_id,
            count(*) >= 3 AS meets, bool_or(count(*) >= 3) OVER () AS any_meets
        FROM junction_node m JOIN node n USING (node_id)
            JOIN edge e CROSS JOIN LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id) ON v.node_id = n.node_id
        WHERE m.junction_id = junction GROUP BY n.node_id, n.geom) n
    WHERE meets OR NOT any_meets INTO axes, places;
END $$;
COMMENT ON FUNCTION streetgen._nodes_to_decide(name, bigint) IS
    'The nodes of a junction where its kind by hand is written: all of three and more edges, where it has any; of each '
    'an axis and the place. NULL where the junction is gone.';

CREATE OR REPLACE FUNCTION streetgen._decide_junction(model name, known bigint[], axes bigint[], places geometry[],
    inside boolean, kind text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
    kept bigint[];
    missing integer[];
BEGIN
    PERFORM streetgen._use_model(model);
    -- The first of the rows that stand at a place stays.
    SELECT coalesce(array_agg(o.id) FILTER (WHERE o.id IS NOT NULL), '{}'),
        coalesce(array_agg(p.i) FILTER (WHERE o.id IS NULL), '{}')
    FROM unnest(places) WITH ORDINALITY p(geom, i) LEFT JOIN LATERAL (
        SELECT junction_override_id AS id FROM junction_override v JOIN unnest(known) WITH ORDINALITY k(id, turn)
            ON v.junction_override_id = k.id
        WHERE cardinality(places) = 1 OR ST_DWithin(v.geom, p.geom, 3 * tolerance)
            ORDER BY turn LIMIT 1) o ON true
    WHERE num_nonnulls(inside, kind) = 1 INTO kept, missing;
    DELETE FROM junction_override WHERE junction_override_id = ANY (known) AND junction_override_id <> ALL (kept);
    UPDATE junction_override SET inside = _decide_junction.inside, kind = _decide_junction.kind
        WHERE junction_override_id = ANY (kept);
    INSERT INTO junction_override (axis_id, geom, inside, kind) SELECT (axes)[i], (places)[i], inside, kind
        FROM unnest(missing) i;
END $$;
COMMENT ON FUNCTION streetgen._decide_junction(name, bigint[], bigint[], geometry[], boolean, text) IS
    'Writes a decision on a junction, a row at each place on its axis: known are the rows that decided before, of '
    'which one stays at each place. Neither inside nor kind: it is taken back.';

CREATE OR REPLACE FUNCTION streetgen._check_junction_kind(model name, subject text, nodes bigint[], kind text)
    RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    found record;
    hint text;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT count(*) FILTER (WHERE i.edge_id IS NULL) AS arms,
        streetgen._edges_on_rings(model, coalesce(array_agg(e.edge_id), '{}')) <> '{}' AS on_ring
    FROM (SELECT edge_id FROM edge WHERE from_node = ANY (nodes)
            UNION ALL SELECT edge_id FROM edge WHERE to_node = ANY (nodes)) e
        LEFT JOIN junction_edge i ON i.edge_id = e.edge_id INTO found;
    hint := CASE WHEN kind = 'end' AND found.arms <> 1 THEN 'An end has one arm.'
        WHEN kind = 'continuation' AND found.arms <> 2 THEN 'A continuation has two arms.'
        WHEN kind = 'roundabout' AND NOT found.on_ring THEN
            'A roundabout comes of axes that go round; put a control point of kind mini_roundabout for a small one.'
        WHEN kind IN ('fork', 'merge') AND found.arms < 3 THEN 'Where a street parts or streets come together are '
            'three arms.'
        WHEN kind IN ('ramp', 'priority', 'right_before_left') AND found.arms = 1 THEN 'Where one arm ends is an end.'
        END;
    IF hint IS NOT NULL THEN
        PERFORM streetgen._refuse('22023', format('%s cannot be of kind %s', subject, kind),
            detail => format('It has %s arms.', found.arms), hint => hint);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_junction_kind(name, text, bigint[], text) IS
    'Refuses (22023) a kind by hand that does not fit the arms of the nodes of a junction: end, continuation, '
    'roundabout where no axis goes round, fork and merge of less than three arms, and what needs several arms at an '
    'end.';

CREATE OR REPLACE FUNCTION streetgen._refuse_unfit_kind() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    at record;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    IF to_regclass(format('%I.junction', TG_TABLE_SCHEMA)) IS NULL OR NOT streetgen._live(TG_TABLE_SCHEMA)
        -- A decision goes with its axis.
        OR TG_OP = 'UPDATE' AND NEW.kind IS NOT DISTINCT FROM OLD.kind AND (pg_trigger_depth() > 1
            OR (NEW.axis_id, NEW.geom::bytea) IS NOT DISTINCT FROM (OLD.axis_id, OLD.geom::bytea)) THEN
        RETURN NEW;
    END IF;
    -- A node that joins two edges alone is no junction yet.
    SELECT j.kind, coalesce('junction ' || j.junction_id, 'node ' || p.node_id) AS subject,
        coalesce((SELECT array_agg(o.node_id) FROM junction_node o WHERE o.junction_id = j.junction_id),
            ARRAY[p.node_id]) AS nodes
    FROM (SELECT v.node_id FROM edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id)
            JOIN node n USING (node_id)
        WHERE e.axis_id = NEW.axis_id ORDER BY ST_Distance(n.geom, NEW.geom), v.node_id LIMIT 1) p
        LEFT JOIN junction_node m USING (node_id) LEFT JOIN junction j USING (junction_id) INTO at;
    IF at.kind IS DISTINCT FROM NEW.kind AND at.nodes IS NOT NULL THEN
        PERFORM streetgen._check_junction_kind(TG_TABLE_SCHEMA, at.subject, at.nodes, NEW.kind);
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._refuse_unfit_kind() IS
    'Trigger of junction_override: refuses (22023) a kind by hand that does not fit the arms of the junction, or of '
    'the node that is none yet, at its place. Where streets do not follow, and where no junction is computed, every '
    'kind is taken.';

CREATE OR REPLACE FUNCTION streetgen._edit_junction() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known bigint[];
    nodes record;
    decided text;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'A junction is where axes meet: draw these, or say in junction_edge_editing which edges lie inside.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{kind,by_hand}',
            'A junction moves with its axes.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
        decided := CASE WHEN NOT OLD.by_hand OR NEW.by_hand THEN NEW.kind END;
        PERFORM streetgen._check_edit_word('junction ' || OLD.junction_id, decided,
            format('%I.junction_override', TG_TABLE_SCHEMA), 'kind');
        NEW.by_hand := decided IS NOT NULL;
    END IF;
    PERFORM streetgen._lock_junctions(TG_TABLE_SCHEMA, ARRAY[OLD.junction_id]);
    known := streetgen._overrides_at_junction(TG_TABLE_SCHEMA, 'junction_override', OLD.junction_id);
    known := ARRAY(SELECT o.junction_override_id FROM junction_override o
        WHERE o.kind IS NOT NULL AND o.junction_override_id = ANY (known) ORDER BY o.junction_override_id DESC);
    nodes := streetgen._nodes_to_decide(TG_TABLE_SCHEMA, OLD.junction_id);
    IF nodes.axes IS NULL THEN
        PERFORM streetgen._refuse('22023', format('junction %s is gone', OLD.junction_id),
            detail => 'Somebody else changed its axes.', hint => 'Refresh the layer, and edit what is there now.');
    END IF;
    PERFORM streetgen._decide_junction(TG_TABLE_SCHEMA, known, nodes.axes, nodes.places, NULL, decided);
    RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
END $$;
COMMENT ON FUNCTION streetgen._edit_junction() IS
    'Trigger of junction_editing: writes the kind to junction_override, at each node of the junction where three and '
    'more edges meet; kind NULL, or DELETE, takes it back. An unknown kind: 23514; one that does not fit its arms, '
    'or a junction that is gone: 22023; INSERT, another key or place: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._edit_junction_edge() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known bigint[];
    edge record;
    decided boolean;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'Edges come from axes: draw these in axis_editing.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{inside,by_hand}',
            'An edge moves with its axis.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
        decided := CASE WHEN NOT OLD.by_hand OR NEW.by_hand THEN NEW.inside END;
        NEW.by_hand := decided IS NOT NULL;
    END IF;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge WHERE edge_id = %s',
        TG_TABLE_SCHEMA, OLD.edge_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, format('edge %s', OLD.edge_id), OLD.edge_id);
    SELECT coalesce(array_agg(o.junction_override_id ORDER BY o.junction_override_id DESC), '{}')
        FROM junction_override o WHERE o.axis_id = edge.axis_id AND o.inside IS NOT NULL
            AND streetgen._edge_at(TG_TABLE_SCHEMA, o.axis_id, o.geom) = OLD.edge_id INTO known;
    PERFORM streetgen._decide_junction(TG_TABLE_SCHEMA, known,
        ARRAY[edge.axis_id], ARRAY[ST_LineInterpolatePoint(ST_Force2D(edge.geom), 0.5)], decided, NULL);
    RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
END $$;
COMMENT ON FUNCTION streetgen._edit_junction_edge() IS
    'Trigger of junction_edge_editing: writes to junction_override, in the middle of the edge, whether the edge lies '
    'inside a junction, which merges or parts what is at its ends; inside NULL, or DELETE, takes it back. An edge '
    'whose axis is gone: 22023; INSERT, another key or line: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._junction_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('junction_editing', 'Edit layer: say what kind of junction a place is; DELETE takes back what was decided by hand',
        ARRAY['key', 'ramp, fork, merge, signals, stop, priority, right_before_left, roundabout, continuation or '
            'end; NULL takes it back', 'decided by hand; false takes it back', 'the middle of its nodes'],
        $sql$SELECT j.junction_id, j.kind, j.method = 'by_hand' AS by_hand, j.geom
        FROM {model}.junction j$sql$, 'junction'),
    ('junction_edge_editing', 'Edit layer: say whether an edge lies inside a junction: what is at its ends is one '
        'junction, or two; DELETE takes back what was decided by hand',
        ARRAY['key', 'does it lie inside a junction; NULL takes it back',
            'decided by hand; false takes it back', 'the edge'],
        streetgen._part('junction_edge_editing'), 'junction') $$;
COMMENT ON FUNCTION streetgen._junction_edit_view() IS 'The views in which junctions are edited.';

CREATE OR REPLACE FUNCTION streetgen._junction_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('junction_override'::name, 'vertex', '{axis_id}'::name[], '3 * {tolerance}', '{}'::jsonb, true, 7,
        'ROW(o.geom::bytea, o.inside, o.kind)') $$;
COMMENT ON FUNCTION streetgen._junction_decision() IS
    'The anchors of decisions about junctions, and which of their columns follow the axes.';
