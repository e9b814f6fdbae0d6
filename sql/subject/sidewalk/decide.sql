-- Edits of sidewalks: sidewalk_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_sidewalk() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    edge record;
    known bigint[];
    middle float8;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Sidewalks come from sidewalk_left and sidewalk_right of their axis.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{width,by_hand}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := format('sidewalk %s (%s of edge %s)', OLD.sidewalk_id, OLD.side, OLD.edge_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge WHERE edge_id = %s',
        TG_TABLE_SCHEMA, OLD.edge_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, subject, OLD.edge_id);
    SELECT coalesce(array_agg(sidewalk_override_id ORDER BY sidewalk_override_id DESC), '{}')
        FROM sidewalk_override WHERE axis_id = edge.axis_id AND side = OLD.side AND abscissa >= edge.start_abscissa
        AND abscissa < edge.end_abscissa INTO known;
    IF TG_OP = 'DELETE' OR NEW.width IS NULL OR OLD.by_hand AND NOT NEW.by_hand THEN
        DELETE FROM sidewalk_override WHERE sidewalk_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    PERFORM streetgen._check_edit_number('the width of ' || subject, NEW.width, 0, 50, 'm', '0 takes it away.');
    IF known = '{}' THEN
        middle := (edge.start_abscissa + edge.end_abscissa) / 2;
        INSERT INTO sidewalk_override (axis_id, abscissa, side, width, geom)
            VALUES (edge.axis_id, middle, OLD.side, NEW.width, ST_LineInterpolatePoint(edge.axis, least(middle /
            ST_Length2D(edge.axis), 1)));
    ELSE
        UPDATE sidewalk_override SET width = NEW.width WHERE sidewalk_override_id = known[1];
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_sidewalk() IS
    'Trigger of sidewalk_editing: writes sidewalk_override for the side of an edge. A width beyond 0 to 50 m: 22023; '
    'INSERT and other changes: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('sidewalk_editing',
        'Edit layer: type the width of the sidewalk on one side of an edge, which has a row for each piece of its '
        'kerb: the width is that of all; DELETE takes back what was decided by hand',
        ARRAY['key', 'the edge', 'left or right', 'width, metres; 0: none; NULL takes it back',
            'decided by hand; false takes it back',
            'its ground'],
        $sql$SELECT s.sidewalk_id, s.edge_id, s.side, s.width,
            EXISTS (SELECT FROM {model}.sidewalk_override o WHERE (o.axis_id, o.side) = (e.axis_id, s.side)
                AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa) AS by_hand, s.surface AS geom
        FROM {model}.sidewalk s JOIN {model}.edge e USING (edge_id) WHERE s.side IN ('left', 'right')$sql$,
        'sidewalk') $$;
COMMENT ON FUNCTION streetgen._sidewalk_edit_view() IS 'The views in which sidewalks are edited.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('sidewalk_override'::name, 'along', '{axis_id}'::name[], '{tolerance}', jsonb_build_object(
        'side', 'streetgen._swapped(o.side, ''left'', ''right'', n.turned)'), true, 8,
        'ROW(o.abscissa, o.side, o.width)') $$;
COMMENT ON FUNCTION streetgen._sidewalk_decision() IS
    'The anchors of decisions about sidewalks, and which of their columns follow the axes.';
