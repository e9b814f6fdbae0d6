-- Nodes and links: which towns there are, and which of them roads link.

CREATE OR REPLACE FUNCTION streetgen._town_numbers(model name) RETURNS float8[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    numbers float8[];
BEGIN
    EXECUTE format($sql$
SELECT coalesce(array_agg(v ORDER BY design_node_id, k), '{}') FROM (SELECT * FROM %I.design_node
    WHERE NOT rejected AND (by_hand OR kind <> 'interchange')) n,
    unnest(ARRAY[array_position(ARRAY['city', 'town', 'village', 'interchange'], kind) - 1, importance, ST_X(geom),
        ST_Y(geom)]) WITH ORDINALITY u(v, k) $sql$, model) INTO numbers;
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
    EXECUTE format('DELETE FROM %I.design_node WHERE NOT by_hand AND NOT rejected AND kind <> ''interchange'' AND '
        'ST_Covers($1, geom)', model) USING ground;
    EXECUTE format($sql$
INSERT INTO %I.design_node (kind, importance, geom)
SELECT (ARRAY['city', 'town', 'village'])[kind + 1], importance, ST_SetSRID(ST_Point(x, y), ST_SRID($2))
FROM streetgen._rank_size_towns($1, ST_Multi(ST_Force2D($2))::bytea, $3, $4, $5) $sql$, model)
        USING site, ground, wishes, streetgen._town_numbers(model), seed;
    GET DIAGNOSTICS made = ROW_COUNT;
    RETURN made;
END $$;
COMMENT ON FUNCTION streetgen.design_nodes(name, geometry, integer, bigint, jsonb) IS
    'Draws towns in an area (POLYGON) in place of those drawn there before; returns how many found a place. Importance '
    'falls with the rank: largest / rank^exponent. Towns keep off zones and ground steeper than steepest, and keep '
    'spacing times the distance of an even spread. options: cities and towns (how many; the rest are villages), '
    'largest (500000), exponent (1), spacing (0.6), steepest (0.15). Equal arguments give equal towns. Nodes by hand '
    'stay. Another option or geometry, a count beyond 1 to 1000: 22023; no design: 55000; not the owner of the '
    'model: 42501.';

CREATE OR REPLACE FUNCTION streetgen._check_design_nodes(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wrong record;
BEGIN
    EXECUTE format($sql$
SELECT a.design_node_id AS a, b.design_node_id AS b FROM %1$I.design_node a JOIN %1$I.design_node b
    ON ST_DWithin(a.geom, b.geom, 1) AND a.design_node_id < b.design_node_id WHERE NOT a.rejected AND NOT b.rejected
    LIMIT 1 $sql$, model) INTO wrong;
    IF wrong.a IS NOT NULL THEN
        RAISE EXCEPTION 'nodes % and % of the design lie at one place', wrong.a, wrong.b USING ERRCODE = '22023',
            HINT = 'Delete one of both, or move it by more than a metre.';
    END IF;
    EXECUTE format($sql$
SELECT design_node_id AS a, name, streetgen.terrain_height($1, geom) AS height FROM %1$I.design_node
WHERE NOT rejected AND streetgen.terrain_height($1, geom) IS NULL LIMIT 1 $sql$, model) INTO wrong USING model;
    IF wrong.a IS NOT NULL THEN
        RAISE EXCEPTION 'node % of the design has no terrain under it', concat_ws(' ', wrong.a, wrong.name)
            USING ERRCODE = '22023', HINT = 'data/streetgen terrain FILE MODEL loads heights; or move the node.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_design_nodes(name) IS
    'Raises 22023 where two nodes lie at one place, or one has no terrain under it.';

CREATE OR REPLACE FUNCTION streetgen._design_links(model name) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    target_srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    changed bigint;
BEGIN
    -- Pieces of links between interchanges are computed anew below; those that stay keep their keys.
    EXECUTE format($sql$
CREATE TEMPORARY TABLE _town ON COMMIT DROP AS SELECT design_node_id, row_number() OVER (ORDER BY design_node_id) - 1
    AS nth, geom FROM %1$I.design_node WHERE NOT rejected AND (by_hand OR kind <> 'interchange');
CREATE TEMPORARY TABLE _link ON COMMIT DROP AS
WITH given AS (SELECT l.*, a.nth AS a, b.nth AS b, array_position(ARRAY['highway', 'secondary', 'rural'], network) - 1
    AS rank FROM %1$I.design_link l JOIN _town a ON a.design_node_id = node_a
    JOIN _town b ON b.design_node_id = node_b WHERE by_hand)
SELECT row_number() OVER () - 1 AS nth, t.* FROM streetgen._link_towns(streetgen._town_numbers(%1$L),
    ARRAY(SELECT v FROM given, unnest(ARRAY[a, b, rank]::float8[]) WITH ORDINALITY u(v, k) WHERE NOT rejected
        ORDER BY design_link_id, k),
    ARRAY(SELECT v FROM given, unnest(ARRAY[a, b]::float8[]) WITH ORDINALITY u(v, k) WHERE rejected
        ORDER BY design_link_id, k),
    streetgen._design_number(%1$L, 'link_factor'), streetgen._design_text(%1$L, 'benefit') = 'network') t;
CREATE TEMPORARY TABLE _meeting ON COMMIT DROP AS
SELECT ST_SnapToGrid(ST_SetSRID(ST_Point(x, y), %2$s), 0.001) AS geom, first, second
    FROM streetgen._link_crossings(streetgen._town_numbers(%1$L),
    ARRAY(SELECT v FROM _link l, unnest(ARRAY[a, b, network]::float8[]) WITH ORDINALITY u(v, k) ORDER BY nth, k))
    -- A link by hand is not cut: it crosses the others as links of other networks do.
    WHERE NOT EXISTS (SELECT FROM _link l WHERE by_hand_row AND l.nth IN (first, second))
$sql$, model, target_srid);
    -- A crossing within a metre of a former interchange is that interchange.
    EXECUTE format($sql$
DELETE FROM %1$I.design_node n WHERE kind = 'interchange' AND NOT by_hand AND NOT rejected
    AND NOT EXISTS (SELECT FROM _meeting m WHERE ST_DWithin(m.geom, n.geom, 1));
INSERT INTO %1$I.design_node (kind, importance, geom) SELECT DISTINCT 'interchange', 0, m.geom FROM _meeting m
    WHERE NOT EXISTS (SELECT FROM %1$I.design_node n WHERE ST_DWithin(m.geom, n.geom, 1));
CREATE TEMPORARY TABLE _piece ON COMMIT DROP AS
WITH stop AS (
    SELECT l.nth, t.design_node_id, 0::float8 AS at FROM _link l JOIN _town t ON t.nth = l.a
    UNION ALL SELECT l.nth, t.design_node_id, 1 FROM _link l JOIN _town t ON t.nth = l.b
    UNION ALL SELECT l.nth, n.design_node_id, ST_LineLocatePoint(ST_MakeLine(a.geom, b.geom), n.geom)
        FROM _meeting m JOIN _link l ON l.nth IN (m.first, m.second) JOIN _town a ON a.nth = l.a
        JOIN _town b ON b.nth = l.b JOIN %1$I.design_node n ON ST_DWithin(m.geom, n.geom, 1)),
piece AS (SELECT nth, design_node_id AS node_a, lead(design_node_id) OVER (PARTITION BY nth ORDER BY at) AS node_b
    FROM stop)
SELECT least(node_a, node_b) AS node_a, greatest(node_a, node_b) AS node_b,
    (ARRAY['highway', 'secondary', 'rural'])[l.network + 1] AS network, l.length, l.utilisation, l.benefit, l.cost
FROM piece JOIN _link l USING (nth) WHERE node_b IS NOT NULL AND node_a <> node_b AND NOT l.by_hand_row $sql$, model);
    EXECUTE format($sql$
WITH gone AS (DELETE FROM %1$I.design_link l WHERE NOT by_hand AND NOT rejected AND NOT EXISTS (SELECT FROM _piece p
    WHERE (p.node_a, p.node_b, p.network) = (l.node_a, l.node_b, l.network)) RETURNING 1),
same AS (UPDATE %1$I.design_link l SET length = p.length, utilisation = p.utilisation, benefit = p.benefit,
    cost = p.cost FROM _piece p WHERE (p.node_a, p.node_b) = (least(l.node_a, l.node_b), greatest(l.node_a, l.node_b))
    AND p.network = l.network AND NOT l.rejected AND (l.length, l.utilisation, l.benefit, l.cost)
        IS DISTINCT FROM (p.length, p.utilisation, p.benefit, p.cost) RETURNING 1),
come AS (INSERT INTO %1$I.design_link (node_a, node_b, network, length, utilisation, benefit, cost)
    SELECT DISTINCT ON (node_a, node_b, network) * FROM _piece p WHERE NOT EXISTS (SELECT FROM %1$I.design_link l
        WHERE (p.node_a, p.node_b) = (least(l.node_a, l.node_b), greatest(l.node_a, l.node_b))
            AND p.network = l.network) ORDER BY node_a, node_b, network, benefit DESC RETURNING 1)
SELECT (SELECT count(*) FROM gone) + (SELECT count(*) FROM same) + (SELECT count(*) FROM come) $sql$, model)
        INTO changed;
    DROP TABLE pg_temp._town, pg_temp._link, pg_temp._meeting, pg_temp._piece;
    RETURN changed;
END $$;
COMMENT ON FUNCTION streetgen._design_links(name) IS
    'Stage links: computes interchanges and links anew; returns how many links came, went or changed.';
