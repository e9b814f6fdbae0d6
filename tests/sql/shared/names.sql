-- The names that a picture has, read from it: schema test.

-- Each name with its size, the ground of its letters in pixels of the picture's own coordinates (y down), its middle, and whether one reads it upright:
-- from left to right, no letter turned by more than 60 degrees from the others.
CREATE FUNCTION test.written(svg text) RETURNS TABLE(n bigint, words text, size float8, ground geometry, middle geometry, upright boolean) LANGUAGE sql STABLE AS $$
    WITH name AS (SELECT n, m[1]::float8 AS size, m[2] AS letters FROM regexp_matches(svg, '<g class="name[^"]*" style="[^"]*font:[a-z0-9 ]*?([0-9.]+)px[^"]*">([^\n]*)</g>', 'g') WITH ORDINALITY g(m, n)),
    letter AS (
        SELECT n, size, k, m[4] AS letter, m[3]::float8 AS turned, ST_MakePoint(m[1]::float8, m[2]::float8) AS place,
            size * greatest(0.3, (SELECT sum(streetgen._letter_width(l)) FROM string_to_table(m[4], NULL) l)) AS wide
        FROM name, regexp_matches(letters, '<text transform="translate\(([-0-9.]+) ([-0-9.]+)\)rotate\(([-0-9.]+)\)">([^<]*)</text>', 'g') WITH ORDINALITY t(m, k))
    SELECT n, string_agg(letter, '' ORDER BY k), size,
        ST_UnaryUnion(ST_Collect(ST_Translate(ST_Rotate(ST_MakeEnvelope(0.05 * wide, -0.72 * size, 0.95 * wide, 0.15 * size), radians(turned)), ST_X(place), ST_Y(place)))),
        ST_Centroid(ST_Collect(place)), min(across) >= -0.05 AND bool_and(cosd(turned) * across + sind(turned) * down >= 0.5 * sqrt(across ^ 2 + down ^ 2))
    FROM (SELECT *, avg(cosd(turned)) OVER name AS across, avg(sind(turned)) OVER name AS down FROM letter WINDOW name AS (PARTITION BY n)) l GROUP BY n, size $$;

-- Pairs of names of which one stands over the other.
CREATE FUNCTION test.collisions(svg text) RETURNS bigint LANGUAGE sql STABLE AS $$
    WITH name AS MATERIALIZED (SELECT * FROM test.written(svg))
    SELECT count(*) FROM name a JOIN name b ON a.n < b.n AND ST_Intersects(a.ground, b.ground)
    WHERE ST_Area(ST_Intersection(a.ground, b.ground)) > 0.02 * a.size * b.size $$;

-- The streets of a box that go on for so many metres in it, and whether a picture of the box has their name: at the street, in words of which one is the same.
CREATE FUNCTION test.streets_written(model name, box geometry, svg text, long float8) RETURNS TABLE(name text, length float8, written boolean) LANGUAGE plpgsql STABLE SET search_path = pg_catalog, public AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH line AS (
        SELECT a.name, d.geom FROM (SELECT a.name, ST_LineMerge(ST_Collect(ST_Intersection(ST_Force2D(e.geom), box))) AS lines FROM edge e JOIN axis a USING (axis_id)
            WHERE e.geom && box AND a.name ~ '\S' GROUP BY a.name) a, ST_Dump(ST_CollectionExtract(lines, 2)) d),
    street AS (SELECT name, ST_Collect(geom) AS geom, max(ST_Length(geom)) AS length
        FROM (SELECT *, ST_ClusterDBSCAN(geom, 30, 1) OVER (PARTITION BY name) AS part FROM line) l GROUP BY name, part),
    written AS MATERIALIZED (SELECT lower(words) AS words, size, ST_SetSRID(ST_MakePoint(ST_XMin(box) + ST_X(middle), ST_YMax(box) - ST_Y(middle)), ST_SRID(box)) AS place FROM test.written(svg))
    SELECT name, length, EXISTS (SELECT FROM written w WHERE ST_DWithin(w.place, geom, 3 * w.size)
        AND (left(words, 3) = left(lower(regexp_replace(name, '\s', '', 'g')), 3) OR right(words, 3) = right(lower(regexp_replace(name, '\s', '', 'g')), 3)
            OR EXISTS (SELECT FROM regexp_split_to_table(lower(name), '\s+') part WHERE length(part) > 2 AND strpos(words, part) > 0)))
    FROM street WHERE length >= long;
END $$;
