-- Whether mapped sidewalks are as wide as they state: psql -v model=NAME -f tests/measure/stated_sidewalks.sql Of
-- stretches of sides along footways of role sidewalk that state a width, where no axis and nobody by hand says another
-- one, prints model, their number, those with one width along their side, and of these those within 0.1 m of it in the
-- middle of the stretch by cross_section. A sidewalk without a verge counts from the kerb, stones with it.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
CREATE TEMPORARY TABLE stretch AS
SELECT s.*, f.width AS stated, e.axis_id, e.start_abscissa + (s.start_abscissa + s.end_abscissa) / 2 AS middle,
    min(f.width) OVER side = max(f.width) OVER side AND count(f.width) OVER side = count(*) OVER side AS even
FROM :"model".sidewalk_source s JOIN :"model".footway f USING (footway_id) JOIN :"model".edge e USING (edge_id)
    JOIN :"model".axis a USING (axis_id)
WHERE CASE s.side WHEN 'left' THEN a.sidewalk_left ELSE a.sidewalk_right END IS NULL AND NOT EXISTS (
    SELECT FROM :"model".sidewalk_override o WHERE o.axis_id = e.axis_id AND o.side = s.side)
WINDOW side AS (PARTITION BY s.edge_id, s.side);
SELECT :'model', count(*), count(*) FILTER (WHERE even), count(*) FILTER (WHERE even AND abs(w.width - stated) <= 0.1)
FROM stretch s LEFT JOIN LATERAL (SELECT sum(offset_to - offset_from) FILTER (WHERE kind <> 'kerb' OR NOT verge)
        AS width FROM (SELECT *, bool_or(kind = 'verge') OVER () AS verge FROM :"model".cross_section x
    WHERE x.axis_id = s.axis_id AND x.side = s.side AND s.middle BETWEEN x.start_abscissa AND x.end_abscissa
        AND x.kind IN ('sidewalk', 'furnishing', 'kerb', 'verge')) x WHERE kind <> 'verge') w ON true
WHERE stated IS NOT NULL;
