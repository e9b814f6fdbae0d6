-- Stages vertical and structures: crossings, grade points, bridges and tunnels.

CREATE OR REPLACE FUNCTION streetgen._network_rank(network text) RETURNS integer
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_position(ARRAY['highway', 'secondary', 'rural'], network) $$;
COMMENT ON FUNCTION streetgen._network_rank(text) IS 'The rank of a network: 1 of highways, 3 of rural roads.';

CREATE OR REPLACE FUNCTION streetgen._plan_line(model name, link bigint) RETURNS geometry
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._alignment_line(e, NULL, (SELECT m.srid FROM streetgen.model m WHERE m.name = model), 0,
        1e12, 0.01)::geometry FROM streetgen._link_elements(model, link) e WHERE e <> '{}' $$;
COMMENT ON FUNCTION streetgen._plan_line(name, bigint) IS 'The alignment of a link in the plan, as chords.';

CREATE OR REPLACE FUNCTION streetgen._find_crossings(model name, link bigint) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    line constant geometry := streetgen._plan_line(model, link);
BEGIN
    PERFORM streetgen._use_model(model);
    -- With the links that are built before it: those of higher networks, and of its own with a smaller key.
    CREATE TEMPORARY TABLE _crossing ON COMMIT DROP AS
    SELECT row_number() OVER () AS nth, o.design_link_id AS other, p.geom,
        ST_LineLocatePoint(line, p.geom) * ST_Length(line) AS abscissa,
        ST_LineLocatePoint(other_line, p.geom) * ST_Length(other_line) AS other_abscissa,
        CASE WHEN l.network = o.network OR 'highway' NOT IN (l.network, o.network) THEN 'level' END AS kind
    FROM design_link l JOIN design_link o ON o.geom && line AND NOT o.rejected
        AND (streetgen._network_rank(o.network), o.design_link_id)
            < (streetgen._network_rank(l.network), l.design_link_id),
        LATERAL (SELECT ST_Force2D(o.geom) AS other_line OFFSET 0) g,
        LATERAL ST_Dump(ST_CollectionExtract(ST_Intersection(line, other_line), 1)) p
    WHERE l.design_link_id = link
        -- Links touch where they leave a common node, and do not cross.
        AND NOT EXISTS (SELECT FROM design_node n WHERE n.design_node_id IN (l.node_a, l.node_b, o.node_a, o.node_b)
            AND ST_DWithin(n.geom, p.geom, 60));
    CREATE TEMPORARY TABLE _near ON COMMIT DROP AS SELECT nth AS found, c.design_crossing_id AS known,
        ST_Distance(f.geom, c.geom) AS apart FROM pg_temp._crossing f JOIN design_crossing c
            ON c.other_link_id = f.other
        AND (c.by_hand OR ST_DWithin(f.geom, c.geom, 100)) WHERE c.design_link_id = link;
    PERFORM streetgen._match_nearest();
    DELETE FROM design_crossing WHERE design_link_id = link AND NOT by_hand
        AND design_crossing_id NOT IN (SELECT m.known FROM pg_temp._match m);
    UPDATE design_crossing SET abscissa = -1, other_abscissa = -1 WHERE design_link_id = link AND abscissa >= 0
        AND design_crossing_id NOT IN (SELECT m.known FROM pg_temp._match m);
    UPDATE design_crossing c SET abscissa = f.abscissa, other_abscissa = f.other_abscissa, geom = f.geom
        FROM pg_temp._match m JOIN pg_temp._crossing f ON f.nth = m.found WHERE c.design_crossing_id = m.known
        AND (c.abscissa, c.other_abscissa) IS DISTINCT FROM (f.abscissa, f.other_abscissa);
    INSERT INTO design_crossing (design_link_id, other_link_id, abscissa, other_abscissa, kind, geom)
    SELECT link, other, abscissa, other_abscissa, coalesce(kind, 'over'), geom FROM pg_temp._crossing
        WHERE nth NOT IN (SELECT m.found FROM pg_temp._match m);
    DROP TABLE pg_temp._crossing, pg_temp._match;
END $$;
COMMENT ON FUNCTION streetgen._find_crossings(name, bigint) IS
    'Finds where a link crosses links that are built before it. A decision by hand stays with the crossing of the same '
    'links that is nearest to it; where they cross no more it waits, at abscissa -1.';

CREATE OR REPLACE FUNCTION streetgen._crossing_limits(model name, link bigint, fixed float8[]) RETURNS float8[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    clearance constant float8 := streetgen._setting_number(model, 'clearance');
    numbers float8[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT coalesce(array_agg(v ORDER BY abscissa, k), '{}')
    FROM (SELECT c.abscissa, c.kind, p.z FROM design_crossing c,
        LATERAL streetgen._alignment_point(streetgen._link_elements(model, other_link_id),
            streetgen._link_grades(model, other_link_id), other_abscissa) p
        WHERE design_link_id = link AND NOT rejected AND c.abscissa >= 0 AND p.z IS NOT NULL) c,
        unnest(CASE kind WHEN 'over' THEN ARRAY[abscissa, z + clearance, 1e6] WHEN 'under' THEN ARRAY[abscissa, -1e6, z
            - clearance]
            ELSE ARRAY[abscissa, z, z] END) WITH ORDINALITY u(v, k) INTO numbers;
    RETURN numbers;
END $$;
COMMENT ON FUNCTION streetgen._crossing_limits(name, bigint, float8[]) IS
    'Heights that a link must keep at its crossings: abscissa, least and greatest height.';

CREATE OR REPLACE FUNCTION streetgen._decide_crossings(model name, link bigint, elements float8[], grades float8[])
    RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    UPDATE design_crossing c SET kind = side.kind FROM (SELECT design_crossing_id, CASE WHEN own.z >= other.z
            THEN 'over' ELSE 'under' END AS kind FROM design_crossing x,
        LATERAL streetgen._alignment_point(elements, grades, x.abscissa) own,
        LATERAL streetgen._alignment_point(streetgen._link_elements(model, x.other_link_id),
            streetgen._link_grades(model, x.other_link_id), x.other_abscissa) other
        WHERE x.design_link_id = link AND NOT x.by_hand AND x.kind <> 'level' AND other.z IS NOT NULL) side
    WHERE c.design_crossing_id = side.design_crossing_id AND c.kind <> side.kind;
END $$;
COMMENT ON FUNCTION streetgen._decide_crossings(name, bigint, float8[], float8[]) IS
    'Crossings of a link that nobody decided go over or under as the road lies that has these grades, which know of no '
    'crossing.';

CREATE OR REPLACE FUNCTION streetgen._design_vertical(model name, link bigint) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    elements constant float8[] := streetgen._link_elements(model, link);
    site streetgen.road_site;
    ends float8[];
    fixed float8[];
    gone float8[];
    undecided boolean;
    written bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._find_crossings(model, link);
    SELECT ARRAY[streetgen.terrain_height(model, a.geom), streetgen.terrain_height(model, b.geom)]
        FROM design_link JOIN design_node a ON a.design_node_id = node_a
        JOIN design_node b ON b.design_node_id = node_b WHERE design_link_id = link INTO ends;
    SELECT coalesce(array_agg(v ORDER BY abscissa, k), '{}') FROM grade_point,
        unnest(ARRAY[abscissa, height, coalesce(radius, 0)]) WITH ORDINALITY u(v, k)
        WHERE design_link_id = link AND by_hand AND NOT rejected INTO fixed;
    SELECT coalesce(array_agg(abscissa ORDER BY abscissa), '{}') FROM grade_point
        WHERE design_link_id = link AND rejected INTO gone;
    site := streetgen._road_site(model, streetgen._link_area(model, link), streetgen._link_rules(model, link));
    SELECT EXISTS (SELECT FROM design_crossing WHERE design_link_id = link AND NOT by_hand
        AND kind <> 'level') INTO undecided;
    IF undecided THEN
        PERFORM streetgen._decide_crossings(model, link, elements, ARRAY(SELECT v
            FROM streetgen._road_profile(site, elements, ends, fixed, gone, '{}') p,
                unnest(ARRAY[p.abscissa, p.height, p.radius]) WITH ORDINALITY u(v, k) ORDER BY p.abscissa, k));
    END IF;
    -- A point that stays at its place keeps its key: an editor may hold it.
    WITH wanted AS MATERIALIZED (
        SELECT p.abscissa, p.height, p.radius, ST_SetSRID(ST_MakePoint(a.x, a.y, p.height), (SELECT m.srid
            FROM streetgen.model m WHERE m.name = model)) AS geom
        FROM streetgen._road_profile(site, elements, ends, fixed, gone,
                streetgen._crossing_limits(model, link, fixed)) p,
            LATERAL streetgen._alignment_point(elements, NULL, p.abscissa) a
        WHERE NOT EXISTS (SELECT FROM grade_point o WHERE o.design_link_id = link AND o.by_hand AND NOT o.rejected
            AND abs(o.abscissa - p.abscissa) <= 1)),
    kept AS MATERIALIZED (
        SELECT DISTINCT ON (grade_point_id) * FROM (
            SELECT DISTINCT ON (w.abscissa) w.*, g.grade_point_id FROM wanted w JOIN grade_point g
                ON g.design_link_id = link AND NOT g.by_hand AND NOT g.rejected AND abs(g.abscissa - w.abscissa) <= 1
            ORDER BY w.abscissa, abs(g.abscissa - w.abscissa)) k ORDER BY grade_point_id),
    dropped AS (DELETE FROM grade_point WHERE design_link_id = link AND NOT by_hand AND NOT rejected
        AND grade_point_id NOT IN (SELECT grade_point_id FROM kept)),
    moved AS (UPDATE grade_point g SET (abscissa, height, radius, geom) = (k.abscissa, k.height, k.radius, k.geom)
        FROM kept k WHERE g.grade_point_id = k.grade_point_id),
    put AS (INSERT INTO grade_point (design_link_id, abscissa, height, radius, geom)
        SELECT link, abscissa, height, radius, geom FROM wanted
            WHERE abscissa NOT IN (SELECT abscissa FROM kept) ORDER BY abscissa)
    SELECT count(*) FROM wanted INTO written;
    UPDATE grade_point p SET geom = ST_SetSRID(ST_MakePoint(a.x, a.y, p.height), (SELECT m.srid
        FROM streetgen.model m WHERE m.name = model))
        FROM grade_point q, LATERAL streetgen._alignment_point(elements, NULL, q.abscissa) a
        WHERE q.grade_point_id = p.grade_point_id AND p.design_link_id = link AND p.by_hand;
    UPDATE design_link SET geom = streetgen._alignment_line(elements,
        streetgen._link_grades(model, link), (SELECT m.srid FROM streetgen.model m
            WHERE m.name = model), 0, 1e12, 0.01)::geometry WHERE design_link_id = link;
    RETURN written;
EXCEPTION WHEN invalid_parameter_value THEN
    RAISE EXCEPTION 'link % of the design: %', link, SQLERRM USING ERRCODE = '22023',
        HINT = 'Its grade points by hand stand in grade_point; make their radii smaller, or move them apart.';
END $$;
COMMENT ON FUNCTION streetgen._design_vertical(name, bigint) IS
    'Stage vertical of a link: finds its crossings and its grade points; returns how many. Grade points by hand that '
    'do not fit: 22023.';

CREATE OR REPLACE FUNCTION streetgen._broken_rules(model name, link bigint) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    rules constant jsonb := streetgen._link_rules(model, link);
    grades constant float8[] := streetgen._link_grades(model, link);
    broken text;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT string_agg(word, ', ' ORDER BY place) FROM (
        SELECT 1 AS place, 'radius' AS word WHERE EXISTS (SELECT FROM alignment_element WHERE design_link_id = link
            AND NOT rejected AND greatest(abs(curvature_start), abs(curvature_end)) > 1.001 / ((rules ->>
                'radius')::float8))
        UNION ALL SELECT 2, 'grade' WHERE EXISTS (SELECT FROM streetgen._vertical_alignment(grades)
            WHERE greatest(abs(grade_start), abs(grade_end)) > 1.005 * ((rules ->> 'grade')::float8))
        UNION ALL SELECT 3, 'crest' WHERE EXISTS (SELECT FROM streetgen._vertical_alignment(grades)
            WHERE kind = 'crest' AND radius < 0.995 * ((rules ->> 'crest')::float8))
        UNION ALL SELECT 4, 'sag' WHERE EXISTS (SELECT FROM streetgen._vertical_alignment(grades)
            WHERE kind = 'sag' AND radius < 0.995 * ((rules ->> 'sag')::float8))) w INTO broken;
    RETURN 'breaks ' || broken;
END $$;
COMMENT ON FUNCTION streetgen._broken_rules(name, bigint) IS
    'Which rules of its standard a link breaks: radius, grade, crest, sag; NULL: none.';

CREATE OR REPLACE FUNCTION streetgen._design_structures(model name, link bigint) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    elements constant float8[] := streetgen._link_elements(model, link);
    grades constant float8[] := streetgen._link_grades(model, link);
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    -- The last element begins at an abscissa and has a length.
    road_end constant float8 := elements[cardinality(elements) - 6] + elements[cardinality(elements) - 2];
    written bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    -- A road passes over or under another one on a structure as long as both are wide. One that stays where it was
    -- keeps its key: an editor may hold it.
    WITH found AS (
        SELECT substr(what, 4) AS kind, start_abscissa, end_abscissa FROM streetgen._road_estimate(
            streetgen._road_site(model, streetgen._link_area(model, link), streetgen._link_rules(model, link)),
                elements, grades)
            WHERE what LIKE 'is %'
        UNION ALL SELECT CASE c.kind WHEN 'over' THEN 'bridge' ELSE 'tunnel' END, c.abscissa - k.width / 2 - 10,
            c.abscissa + k.width / 2 + 10 FROM design_crossing c
            JOIN design_link o ON o.design_link_id = c.other_link_id JOIN design_class k ON k.network = o.network
            WHERE c.design_link_id = link AND c.kind <> 'level' AND NOT c.rejected AND c.abscissa >= 0),
    joined AS (SELECT kind, unnest(range_agg(numrange(greatest(start_abscissa, 0)::numeric, end_abscissa::numeric)))
        AS part FROM found GROUP BY kind),
    wanted AS MATERIALIZED (SELECT kind, low, high, streetgen._alignment_line(elements, grades, srid, low, high,
            0.01)::geometry AS geom
        FROM (SELECT kind, part, lower(part)::float8 AS low, upper(part)::float8 AS high FROM joined) j
        WHERE high > low AND NOT EXISTS (SELECT FROM structure o WHERE o.design_link_id = link AND o.by_hand
            AND numrange(o.start_abscissa::numeric, o.end_abscissa::numeric) && part)),
    kept AS MATERIALIZED (
        SELECT DISTINCT ON (structure_id) * FROM (
            SELECT DISTINCT ON (w.kind, w.low) w.*, s.structure_id FROM wanted w JOIN structure s
                ON s.design_link_id = link AND NOT s.by_hand AND s.kind = w.kind
                    AND s.start_abscissa < w.high AND s.end_abscissa > w.low
            ORDER BY w.kind, w.low, abs(s.start_abscissa - w.low)) k ORDER BY structure_id),
    dropped AS (DELETE FROM structure WHERE design_link_id = link AND NOT by_hand
        AND structure_id NOT IN (SELECT structure_id FROM kept)),
    moved AS (UPDATE structure s SET (start_abscissa, end_abscissa, geom) = (k.low, k.high, k.geom)
        FROM kept k WHERE s.structure_id = k.structure_id),
    put AS (INSERT INTO structure (design_link_id, kind, start_abscissa, end_abscissa, geom)
        SELECT link, kind, low, high, geom FROM wanted
            WHERE (kind, low) NOT IN (SELECT kind, low FROM kept) ORDER BY low)
    SELECT count(*) FROM wanted INTO written;
    UPDATE structure SET geom = CASE WHEN start_abscissa < road_end THEN streetgen._alignment_line(elements, grades,
            srid, start_abscissa, least(end_abscissa, road_end), 0.01)::geometry END
        WHERE design_link_id = link AND by_hand;
    UPDATE design_link SET method = streetgen._broken_rules(model, link) WHERE design_link_id = link
        AND method IS DISTINCT FROM streetgen._broken_rules(model, link);
    RETURN written;
END $$;
COMMENT ON FUNCTION streetgen._design_structures(name, bigint) IS
    'Stage structures of a link: its bridges and tunnels, none where one by hand, or a rejected one, stands; returns '
    'how many. The method of the link says which rules it breaks.';
