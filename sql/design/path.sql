-- Stages paths and horizontal: vertices of the straight alignments, and the elements along them.

CREATE OR REPLACE FUNCTION streetgen._link_area(model name, link bigint) RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    area geometry;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_Expand(ST_Envelope(place), 0.6 * ST_Length(ST_BoundingDiagonal(place)) + 4000) FROM (
        SELECT ST_Collect(geom) AS place FROM (
            SELECT n.geom FROM design_link l JOIN design_node n ON n.design_node_id IN (node_a, node_b)
                WHERE l.design_link_id = link
            UNION ALL SELECT geom FROM design_vertex WHERE design_link_id = link AND by_hand AND NOT rejected) p) c
                INTO area;
    RETURN area;
END $$;
COMMENT ON FUNCTION streetgen._link_area(name, bigint) IS 'Where the terrain and the zones of a link are looked for.';

CREATE OR REPLACE FUNCTION streetgen._link_places(model name, link bigint, only_by_hand boolean)
    RETURNS TABLE(ordinality float8, geom geometry, curve float8[], straight boolean)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 50 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH vertex AS (SELECT ordinality, geom, CASE WHEN by_hand AND radius > 0 THEN ARRAY[radius, coalesce(clothoid_in,
        0),
            coalesce(clothoid_out, 0)] ELSE '{0,0,0}' END AS curve, straight_in, straight_out
        FROM design_vertex WHERE design_link_id = link AND NOT rejected AND (by_hand OR NOT only_by_hand)),
    bound AS (SELECT coalesce(min(ordinality) - 1, 0) AS low, coalesce(max(ordinality) + 1, 1) AS high,
        count(*) > 0 OR EXISTS (SELECT FROM design_vertex WHERE design_link_id = link AND rejected) AS any FROM vertex),
    place AS (SELECT * FROM vertex
        UNION ALL SELECT b.low, n.geom, '{0,0,0}', b.any, b.any FROM bound b, design_link l
            JOIN design_node n ON n.design_node_id = node_a WHERE l.design_link_id = link
        UNION ALL SELECT b.high, n.geom, '{0,0,0}', b.any, b.any FROM bound b, design_link l
            JOIN design_node n ON n.design_node_id = node_b WHERE l.design_link_id = link)
    SELECT ordinality, geom, curve, coalesce(lag(straight_out) OVER (ORDER BY ordinality) AND straight_in, false)
    FROM place ORDER BY ordinality;
END $$;
COMMENT ON FUNCTION streetgen._link_places(name, bigint, boolean) IS
    'Both nodes of a link and the vertices between them, in order: place, the curve by hand (radius, clothoids; 0: '
    'free), and whether the side before it is straight by hand.';

CREATE OR REPLACE FUNCTION streetgen._design_path(model name, link bigint) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    places geometry;
    sides float8[];
    known float8[];
    barred text;
    written bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_MakeLine(p.geom ORDER BY p.ordinality), array_agg(p.straight::integer::float8 ORDER BY p.ordinality),
        array_agg(p.ordinality ORDER BY p.ordinality)
        INTO places, sides, known FROM streetgen._link_places(model, link, true) p;
    CREATE TEMPORARY TABLE _found ON COMMIT DROP AS SELECT f.*, ordinality AS nth, count(*) FILTER (WHERE f.by_hand)
        OVER (ORDER BY ordinality) AS leg FROM streetgen._road_path(
            streetgen._road_site(model, streetgen._link_area(model, link), streetgen._link_rules(model, link)),
            places::bytea, sides)
        WITH ORDINALITY f;
    SELECT f.barrier INTO barred FROM pg_temp._found f WHERE f.barrier IS NOT NULL;
    UPDATE design_link SET method = CASE WHEN barred IS NOT NULL THEN 'no_path: ' || barred END
        WHERE design_link_id = link AND method IS DISTINCT FROM CASE WHEN barred IS NOT NULL THEN 'no_path: ' || barred
        END;
    IF barred IS NOT NULL THEN
        PERFORM streetgen._clear_links(model, ARRAY[link]);
    END IF;
    DELETE FROM design_vertex WHERE design_link_id = link AND NOT by_hand;
    INSERT INTO design_vertex (design_link_id, ordinality, geom)
    SELECT link, CASE WHEN cardinality(known) = 2 THEN k
            ELSE known[leg] + (known[leg + 1] - known[leg]) * k / (n + 1) END, ST_SetSRID(ST_Point(x, y),
                ST_SRID(places))
    FROM (SELECT *, row_number() OVER (PARTITION BY leg ORDER BY nth) AS k, count(*) OVER (PARTITION BY leg) AS n
        FROM pg_temp._found WHERE NOT by_hand) f;
    GET DIAGNOSTICS written = ROW_COUNT;
    DROP TABLE pg_temp._found;
    RETURN written;
END $$;
COMMENT ON FUNCTION streetgen._design_path(name, bigint) IS
    'Stage paths of a link: searches its vertices anew, through those by hand; returns how many it found. Without a '
    'way the method of the link is no_path and what bars it, and what was computed of it goes.';

CREATE OR REPLACE FUNCTION streetgen._design_horizontal(model name, link bigint) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    path geometry;
    given float8[];
    site streetgen.road_site;
    written bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_MakeLine(p.geom ORDER BY p.ordinality) INTO path FROM streetgen._link_places(model, link, false) p;
    given := ARRAY(SELECT v FROM streetgen._link_places(model, link, false) p,
        unnest(p.curve) WITH ORDINALITY u(v, k) ORDER BY p.ordinality, k);
    SELECT array_agg(key ORDER BY key), array_agg(value::float8 ORDER BY key) INTO site.rule_names, site.rule_values
        FROM jsonb_each_text(streetgen._link_rules(model, link));
    -- An element that keeps its number keeps its key: an editor may hold it.
    WITH curve AS MATERIALIZED (SELECT array_agg(radius ORDER BY nth) AS radii, array_agg(clothoid_in
        ORDER BY nth) AS a,
        array_agg(clothoid_out ORDER BY nth) AS b FROM streetgen._road_curves(site, path::bytea, given)
        WITH ORDINALITY c(radius, clothoid_in, clothoid_out, nth)),
    wanted AS MATERIALIZED (
        SELECT e.nth, e.kind, e.abscissa, ST_SetSRID(ST_Point(x, y), ST_SRID(path)) AS start, heading, length,
            curvature_start, curvature_end
        FROM curve, streetgen._horizontal_alignment(path::bytea, radii, a, b) WITH ORDINALITY
            e(kind, abscissa, x, y, heading, length, curvature_start, curvature_end, nth)
        WHERE NOT EXISTS (SELECT FROM alignment_element o WHERE o.design_link_id = link AND o.by_hand
            AND o.ordinality = e.nth)),
    kept AS MATERIALIZED (SELECT DISTINCT ON (w.nth) w.*, e.alignment_element_id FROM wanted w
        JOIN alignment_element e ON e.design_link_id = link AND NOT e.by_hand AND e.ordinality = w.nth
        ORDER BY w.nth, alignment_element_id),
    dropped AS (DELETE FROM alignment_element WHERE design_link_id = link AND NOT by_hand
        AND alignment_element_id NOT IN (SELECT alignment_element_id FROM kept)),
    moved AS (UPDATE alignment_element e SET (kind, abscissa, start, heading, length, curvature_start, curvature_end)
            = (k.kind, k.abscissa, k.start, k.heading, k.length, k.curvature_start, k.curvature_end)
        FROM kept k WHERE e.alignment_element_id = k.alignment_element_id),
    put AS (INSERT INTO alignment_element (design_link_id, ordinality, kind, abscissa, start, heading, length,
            curvature_start, curvature_end)
        SELECT link, nth, kind, abscissa, start, heading, length, curvature_start, curvature_end FROM wanted
            WHERE nth NOT IN (SELECT nth FROM kept) ORDER BY nth)
    SELECT count(*) FROM wanted INTO written;
    RETURN written;
EXCEPTION WHEN invalid_parameter_value THEN
    RAISE EXCEPTION 'link % of the design: %', link, SQLERRM USING ERRCODE = '22023',
        HINT = 'Its vertices count from 2, after the node; make their radii smaller, or move them apart.';
END $$;
COMMENT ON FUNCTION streetgen._design_horizontal(name, bigint) IS
    'Stage horizontal of a link: lays the elements along its vertices; returns how many. Curves by hand that do not '
    'fit: 22023.';

CREATE OR REPLACE FUNCTION streetgen._link_elements(model name, link bigint) RETURNS float8[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    numbers float8[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT coalesce(array_agg(v ORDER BY ordinality, k), '{}') FROM alignment_element e,
        unnest(ARRAY[abscissa, ST_X(start), ST_Y(start), heading, length, curvature_start, curvature_end])
            WITH ORDINALITY u(v, k) WHERE design_link_id = link AND NOT rejected INTO numbers;
    RETURN numbers;
END $$;
COMMENT ON FUNCTION streetgen._link_elements(name, bigint) IS
    'The elements of a link as the core takes them, seven numbers each.';

CREATE OR REPLACE FUNCTION streetgen._link_grade_points(model name, link bigint)
    RETURNS TABLE(grade_point_id bigint, abscissa float8, height float8, radius float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH point AS (SELECT *, abscissa - lag(abscissa) OVER along AS before,
            lead(abscissa) OVER along - abscissa AS after, lag(height) OVER along AS last_height,
            lead(height) OVER along AS next_height
        FROM grade_point WHERE design_link_id = link AND NOT rejected WINDOW along AS (ORDER BY abscissa)),
    -- The widest parabola that half of both sides has room for.
    room AS (SELECT *, coalesce(abs((next_height - height) / after - (height - last_height) / before), 0) AS turn,
            least(before, after) / nullif(abs((next_height - height) / after - (height - last_height) / before), 0)
                AS room FROM point),
    wish AS (SELECT *, coalesce(radius, least(10000, room), 0) AS wanted FROM room),
    tangent AS (SELECT *, coalesce(lag(wanted * turn / 2) OVER along, 0) + wanted * turn / 2 > before + 1e-6
            OR coalesce(lead(wanted * turn / 2) OVER along, 0) + wanted * turn / 2 > after + 1e-6 AS tight
        FROM wish WINDOW along AS (ORDER BY abscissa))
    SELECT grade_point_id, abscissa, height, CASE WHEN tight THEN least(wanted, room) ELSE wanted END
    FROM tangent ORDER BY abscissa;
END $$;
COMMENT ON FUNCTION streetgen._link_grade_points(name, bigint) IS
    'The grade points of a link in order. A point without a radius has the widest parabola that there is room for, and '
    'so have two by hand that would overlap where the road beside them moved.';

CREATE OR REPLACE FUNCTION streetgen._link_grades(model name, link bigint) RETURNS float8[]
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$ SELECT coalesce(array_agg(v ORDER BY abscissa, k), '{}')
        FROM streetgen._link_grade_points(model, link),
            unnest(ARRAY[abscissa, height, radius]) WITH ORDINALITY u(v, k) $$;
COMMENT ON FUNCTION streetgen._link_grades(name, bigint) IS
    'The grade points of a link as the core takes them, three numbers each.';
