-- Nodes: which towns there are.

CREATE OR REPLACE FUNCTION streetgen._town_numbers(model name) RETURNS float8[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    numbers float8[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT coalesce(array_agg(v ORDER BY design_node_id, k), '{}') FROM (SELECT * FROM design_node
        WHERE NOT rejected AND (by_hand OR kind <> 'interchange')) n,
        unnest(ARRAY[array_position(ARRAY['city', 'town', 'village', 'interchange'], kind) - 1, importance, ST_X(geom),
            ST_Y(geom)]) WITH ORDINALITY u(v, k) INTO numbers;
    RETURN numbers;
END $$;
COMMENT ON FUNCTION streetgen._town_numbers(name) IS
    'The nodes of a design as _link_towns takes them, in the order of their keys, without computed interchanges.';

CREATE OR REPLACE FUNCTION streetgen.design_nodes(model name, area geometry, count integer, seed bigint,
    options jsonb DEFAULT '{}') RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    ground geometry;
    wrong text;
    site streetgen.road_site;
    wishes float8[];
    made bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._check_given('area', area::text, 'count', count::text, 'seed',
        seed::text, 'options', options::text), streetgen._require_design(model);
    ground := streetgen._in_model(model, area, 'the area', '{POLYGON,MULTIPOLYGON}',
        'ST_CurveToLine makes chords of curves, ST_Multi one area of several.');
    IF NOT ST_IsValid(ground) THEN
        RAISE EXCEPTION 'the area is no sound polygon: %', ST_IsValidReason(ground) USING ERRCODE = '22023',
            HINT = 'ST_MakeValid repairs it.';
    END IF;
    SELECT key INTO wrong FROM jsonb_each(options) WHERE key NOT IN ('cities', 'towns', 'largest', 'exponent',
        'spacing', 'steepest') OR jsonb_typeof(value) <> 'number' LIMIT 1;
    IF wrong IS NOT NULL THEN
        RAISE EXCEPTION 'option "%" of nodes is unknown, or no number', wrong USING ERRCODE = '22023',
            HINT = 'The options are cities, towns, largest, exponent, spacing and steepest.';
    END IF;
    wishes := ARRAY[count, coalesce((options ->> 'cities')::float8, ceil(count * 0.15)),
        coalesce((options ->> 'towns')::float8, ceil(count * 0.3)), coalesce((options ->> 'largest')::float8, 500000),
        coalesce((options ->> 'exponent')::float8, 1), coalesce((options ->> 'spacing')::float8, 0.6),
        coalesce((options ->> 'steepest')::float8, 0.15)];
    site := streetgen._road_site(model, ground, streetgen._road_rules(model, 'rural'));
    -- Towns drawn before wait for those drawn now: one at the same place is the same town.
    UPDATE design_node SET rejected = true WHERE NOT by_hand AND NOT rejected
        AND kind <> 'interchange' AND ST_Covers(ground, geom);
    CREATE TEMPORARY TABLE _drawn ON COMMIT DROP AS SELECT d.kind, d.importance, d.geom, n.design_node_id FROM (
        SELECT (ARRAY['city', 'town', 'village'])[kind + 1] AS kind, importance,
            ST_SetSRID(ST_Point(x, y), ST_SRID(ground)) AS geom
        FROM streetgen._rank_size_towns(site, ST_Multi(ST_Force2D(ground))::bytea, wishes,
            streetgen._town_numbers(model), seed)) d
        LEFT JOIN LATERAL (SELECT design_node_id FROM design_node w WHERE rejected AND NOT by_hand
            AND w.kind <> 'interchange' AND ST_DWithin(w.geom, d.geom, 1) ORDER BY ST_Distance(w.geom, d.geom),
            design_node_id LIMIT 1) n ON true;
    UPDATE design_node n SET kind = d.kind, importance = d.importance, geom = d.geom, rejected = false
        FROM pg_temp._drawn d WHERE d.design_node_id = n.design_node_id;
    DELETE FROM design_node n WHERE rejected AND NOT by_hand
        AND NOT EXISTS (SELECT FROM design_link l WHERE n.design_node_id IN (l.node_a, l.node_b));
    INSERT INTO design_node (kind, importance, geom) SELECT kind, importance, geom FROM pg_temp._drawn
        WHERE design_node_id IS NULL ORDER BY importance DESC, geom;
    SELECT count(*) INTO made FROM pg_temp._drawn;
    DROP TABLE pg_temp._drawn;
    RETURN made;
END $$;
COMMENT ON FUNCTION streetgen.design_nodes(name, geometry, integer, bigint, jsonb) IS
    'Draws towns in an area (POLYGON) in place of those drawn there before; returns how many found a place. A town '
    'drawn where one was, within a metre, is that town, and its roads stay. Importance falls with the rank: largest / '
    'rank^exponent. Towns keep off zones and ground steeper than steepest, and keep spacing times the distance of an '
    'even spread. options: cities and towns (how many; the rest are villages), largest (500000), exponent '
    '(1), spacing (0.6), steepest (0.15). Equal arguments give equal towns. Nodes by hand stay. '
    'Another option or geometry, a count beyond 1 to 1000: 22023; no design: 55000; not the owner of the model: 42501.';

CREATE OR REPLACE FUNCTION streetgen._check_design_nodes(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wrong record;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT design_node_id AS a, name FROM design_node WHERE NOT rejected
        AND NOT coalesce(ST_X(geom) BETWEEN -1e12 AND 1e12 AND ST_Y(geom) BETWEEN -1e12 AND 1e12, false) LIMIT 1
            INTO wrong;
    IF wrong.a IS NOT NULL THEN
        PERFORM streetgen._refuse('22023',
            format('node %s of the design has a coordinate that is no place', concat_ws(' ', wrong.a, wrong.name)),
            detail => 'A coordinate is NaN, infinite, beyond 1e12, or missing.',
            hint => 'Move the node, or delete it.');
    END IF;
    SELECT a.design_node_id AS a, b.design_node_id AS b FROM design_node a JOIN design_node b
        ON ST_DWithin(a.geom, b.geom, 1) AND a.design_node_id < b.design_node_id WHERE NOT a.rejected AND NOT b.rejected
        LIMIT 1 INTO wrong;
    IF wrong.a IS NOT NULL THEN
        PERFORM streetgen._refuse('22023', format('nodes %s and %s of the design lie at one place', wrong.a, wrong.b),
            hint => 'Delete one of both, or move it by more than a metre.');
    END IF;
    SELECT design_node_id AS a, name, streetgen.terrain_height(model, geom) AS height FROM design_node
    WHERE NOT rejected AND streetgen.terrain_height(model, geom) IS NULL LIMIT 1 INTO wrong;
    IF wrong.a IS NOT NULL THEN
        PERFORM streetgen._refuse('22023',
            format('node %s of the design has no terrain under it', concat_ws(' ', wrong.a, wrong.name)),
            hint => 'data/streetgen terrain FILE MODEL loads heights; or move the node.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_design_nodes(name) IS
    'Raises 22023 where a node lies nowhere, two lie at one place, or one has no terrain under it.';
