-- Axes that lie on others, ends that miss: what would mend them, and the edit that does.

CREATE OR REPLACE FUNCTION streetgen._joined(line geometry, place geometry, other geometry, nodes geometry,
    half_width float8) RETURNS geometry
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    at_start constant boolean := ST_Distance(ST_StartPoint(line), place) < ST_Distance(ST_EndPoint(line), place);
    -- Drawn towards that end.
    own geometry := CASE WHEN at_start THEN ST_Reverse(line) ELSE line END;
    length constant float8 := ST_Length2D(line);
    tail geometry := ST_Force2D(ST_LineSubstring(own, greatest(0, 1 - 2 * half_width / length), 1));
    last geometry := ST_Force2D(ST_EndPoint(own));
    before geometry := ST_Force2D(ST_PointN(own, -2));
    straight boolean := true;
    target geometry;
    node geometry;
    ahead float8;
BEGIN
    IF other IS NULL THEN
        RETURN line;
    END IF;
    target := ST_ClosestPoint(ST_Intersection(tail, other), last);
    IF NOT ST_IsEmpty(target) THEN
        -- It goes beyond.
        own := ST_LineSubstring(own, 0, ST_LineLocatePoint(own, target));
        IF ST_GeometryType(own) <> 'ST_LineString' THEN
            RETURN NULL;
        END IF;
        last := ST_Force2D(ST_EndPoint(own));
        before := ST_Force2D(ST_PointN(own, -2));
    ELSE
        -- Two last vertices at one place tell no direction.
        ahead := 2 * half_width / nullif(ST_Distance(before, last), 0);
        target := ST_ClosestPoint(ST_Intersection(ST_MakeLine(last, ST_Translate(last,
            ahead * (ST_X(last) - ST_X(before)), ahead * (ST_Y(last) - ST_Y(before)))), other), last);
        straight := coalesce(NOT ST_IsEmpty(target), false);
        IF NOT straight THEN
            target := ST_ClosestPoint(other, last);
        END IF;
    END IF;
    node := ST_ClosestPoint(nodes, target);
    IF ST_DWithin(node, target, half_width / 2) THEN
        straight := straight AND ST_Equals(node, target);
        target := node;
    END IF;
    IF NOT ST_Equals(target, last) THEN
        -- A long piece turns a little; after a short one the line goes on.
        target := CASE ST_NDims(own) WHEN 3 THEN ST_SetSRID(ST_MakePoint(ST_X(target), ST_Y(target),
            ST_Z(ST_EndPoint(own))), ST_SRID(own)) ELSE target END;
        own := CASE WHEN straight OR ST_Distance(before, last) >= 4 * ST_Distance(last, target)
            THEN ST_SetPoint(own, ST_NPoints(own) - 1, target) ELSE ST_AddPoint(own, target) END;
    END IF;
    RETURN CASE WHEN at_start THEN ST_Reverse(own) ELSE own END;
END $$;
COMMENT ON FUNCTION streetgen._joined(geometry, geometry, geometry, geometry, float8) IS
    'A line whose end at a place is led to another line: cut where it crosses that, else led on straight as far as the '
    'roadway goes, else to the nearest place; to a node (MULTIPOINT) within half of half_width of there. No other '
    'line: as it is; nothing left of it: NULL.';

CREATE OR REPLACE FUNCTION streetgen._off_twins(line geometry, starts float8[], ends float8[], places geometry[])
    RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH street AS (SELECT s, e, ST_Length2D(line) AS length FROM unnest(starts, ends) u(s, e)),
    between AS (
        SELECT lag(e, 1, 0::float8) OVER (ORDER BY s) AS low, s AS high, length FROM street
        UNION ALL SELECT max(e), max(length), max(length) FROM street),
    gap AS (
        SELECT low, high FROM between WHERE high > low AND EXISTS (SELECT FROM unnest(places) place
            WHERE ST_LineLocatePoint(ST_Force2D(line), place) * length BETWEEN low AND high)),
    piece AS (
        SELECT min(s) AS low, max(e) AS high, max(length) AS length
        FROM (SELECT *, (SELECT count(*) FROM gap WHERE gap.high <= street.s) AS nth FROM street) n GROUP BY nth)
    -- A part of an axis that is too short for an edge stays with the next one.
    SELECT ST_Collect(ST_LineSubstring(line,
        CASE WHEN EXISTS (SELECT FROM gap WHERE gap.high <= piece.low) THEN least(low / length, 1) ELSE 0 END,
        CASE WHEN EXISTS (SELECT FROM gap WHERE gap.low >= piece.high) THEN least(high / length, 1) ELSE 1 END)
        ORDER BY low)
    FROM piece WHERE EXISTS (SELECT FROM gap)
    $$;
COMMENT ON FUNCTION streetgen._off_twins(geometry, float8[], float8[], geometry[]) IS
    'The pieces of an axis that are streets (abscissas of its edges), without those between at these places; NULL '
    'where there is none between.';

CREATE OR REPLACE FUNCTION streetgen._make_network_views(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE streetgen._fill_template(streetgen._part('axis_to_mend'), jsonb_build_object('srid', srid,
        'z', (SELECT CASE m.dimension WHEN 3 THEN 'Z' ELSE '' END FROM streetgen.model m WHERE m.name = model)));
    COMMENT ON VIEW axis_to_mend IS
        'What would mend axes that lie on others and ends that miss, a proposal each, as the streets were computed; '
        'streetgen.accept_mend does it. One that alone leads in its direction, or from the other to a third street, '
        'has none';
    COMMENT ON COLUMN axis_to_mend.id IS 'names this proposal; another one has another id';
    COMMENT ON COLUMN axis_to_mend.rule IS
        'as in check_model: axis lies on another, or end of an axis in the roadway of another, without a node';
    COMMENT ON COLUMN axis_to_mend.axes IS 'the axis that would change, then those that it lies on or leads to';
    COMMENT ON COLUMN axis_to_mend.proposal IS
        'delete: the axis goes, the whole of which lies on others; split: what lies on others goes, the rest '
        'stays; join: its ends are led to the other axes';
    COMMENT ON COLUMN axis_to_mend.measure IS
        'metres that lie on others, or from the end to the other axis, the farther one of two ends';
    COMMENT ON COLUMN axis_to_mend.geom IS
        'what would be: the pieces or the joined axis; of delete the axis that stays there';
END $$;
COMMENT ON FUNCTION streetgen._make_network_views(name, integer) IS
    'Makes view axis_to_mend of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._refuse_mend(model name, id bigint) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._refuse('22023', format('axis_to_mend of model "%s" has no proposal %s', model, id),
        detail => 'It never had, or what it proposed is done or changed since.',
        hint => format('SELECT * FROM %I.axis_to_mend shows what is to be mended now.', model));
END $$;
COMMENT ON FUNCTION streetgen._refuse_mend(name, bigint) IS 'Raises 22023 for a proposal that is not there.';

CREATE OR REPLACE FUNCTION streetgen.accept_mend(model name, ids bigint[]) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    wanted bigint[];
    named bigint[];
    doubled bigint[];
    split bigint[];
    pieces geometry[];
    missed bigint[];
    joined bigint;
    unknown bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_axis_editor(model);
    wanted := ARRAY(SELECT DISTINCT unnest(ids));
    PERFORM streetgen._lock_axes(model,
        format('SELECT unnest(axes) FROM %I.axis_to_mend WHERE id = ANY (%L)', model, wanted));
    -- Under the locks: what another session changed meanwhile has other proposals.
    SELECT array_agg(id), array_agg(axes[1]) FILTER (WHERE proposal = 'delete'),
        array_agg(axes[1]) FILTER (WHERE proposal = 'split'), array_agg(geom) FILTER (WHERE proposal = 'split'),
        array_agg(axes[1]) FILTER (WHERE proposal = 'join')
        FROM axis_to_mend WHERE id = ANY (wanted) INTO named, doubled, split, pieces, missed;
    SELECT id INTO unknown FROM unnest(wanted) id WHERE id <> ALL (coalesce(named, '{}')) OR id IS NULL
        ORDER BY id LIMIT 1;
    IF FOUND THEN
        PERFORM streetgen._refuse_mend(model, unknown);
    END IF;
    DELETE FROM axis WHERE axis_id = ANY (doubled);
    PERFORM streetgen._cut_axes(model, split, pieces);
    -- The streets have followed: the end of one that was cut leads elsewhere, and may be that of another piece.
    WITH piece AS (
        SELECT cut, ST_GeometryN(piece, n) AS geom
        FROM unnest(split, pieces) p(cut, piece), generate_series(1, ST_NumGeometries(piece)) n),
    led AS (
        SELECT a.axis_id, coalesce(p.cut, a.axis_id) AS named, ST_GeometryN(m.geom, 1) AS geom
        FROM axis_to_mend m JOIN axis a ON a.axis_id = m.axes[1] LEFT JOIN piece p ON p.geom = a.geom
        WHERE m.proposal = 'join' AND coalesce(p.cut, a.axis_id) = ANY (missed)),
    written AS (UPDATE axis a SET geom = l.geom FROM led l WHERE l.axis_id = a.axis_id RETURNING l.named)
    SELECT count(DISTINCT named) INTO joined FROM written;
    RETURN coalesce(cardinality(doubled), 0) + coalesce(cardinality(split), 0) + joined;
END $$;
COMMENT ON FUNCTION streetgen.accept_mend(name, bigint[]) IS
    'Does what view axis_to_mend of a model proposes under these ids, as an edit by hand would: the streets follow, '
    'decisions by hand stay on what is left, and a delivery of the source keeps it. Returns how many it did: a join '
    'that the others made needless is none, and ids that are NULL are none. An unknown model: 3F000; a proposal that '
    'is not there, or no more: 22023; who may not edit the model: 42501.';
