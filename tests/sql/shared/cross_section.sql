-- What the cross-sections of any model must hold, one truth a row.
CREATE FUNCTION test.cross_section(model name) RETURNS TABLE (name text, holds boolean) LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE replace($q$
    CREATE TEMPORARY TABLE piece AS SELECT * FROM @.cross_section;
    CREATE TEMPORARY TABLE stretch AS SELECT DISTINCT edge_id, start_abscissa, end_abscissa FROM piece;
    CREATE TEMPORARY TABLE course AS
      SELECT edge_id, e.start_abscissa AS first, ST_Force2D(e.geom) AS line, a.abscissa AS low, b.abscissa AS high,
        coalesce(s.borders, streetgen._even_borders(e.width, e.width_end, e.end_abscissa - e.start_abscissa, e.roadway_offset)) AS borders
      FROM @.edge e JOIN @.section s USING (edge_id) JOIN @.section_limit a USING (edge_id) JOIN @.section_limit b USING (edge_id)
      WHERE (a.which, b.which) = ('start', 'end');
    -- Each place in the middle of a stretch, off bends, beside which it is not clear what is across. A line that parts two streets is straight
    -- on the ground, and borders are straight along their axes: these differ by some millimetres.
    CREATE TEMPORARY TABLE place AS
      SELECT p.*, c.line, (start_abscissa + end_abscissa) / 2 - first AS middle, (offset_from + offset_from_end) / 2 AS low, (offset_to + offset_to_end) / 2 AS high,
        CASE side WHEN 'left' THEN 1 ELSE -1 END AS outwards
      FROM piece p JOIN course c USING (edge_id) WHERE NOT EXISTS (SELECT FROM ST_DumpPoints(line) d WHERE path[1] BETWEEN 2 AND ST_NPoints(line) - 1
        AND abs(ST_LineLocatePoint(line, d.geom) * ST_Length(line) - ((start_abscissa + end_abscissa) / 2 - first)) < 10)$q$, '@', quote_ident(model));
  RETURN QUERY EXECUTE replace($q$
    SELECT 'each section has its cross-section from limit to limit', count(*) > 0 AND bool_and(abs(first + low - start_abscissa) + abs(first + high - end_abscissa) + abs(high - low - long) < 1e-5) IS TRUE
      FROM course LEFT JOIN (SELECT edge_id, min(start_abscissa) AS start_abscissa, max(end_abscissa) AS end_abscissa, sum(end_abscissa - start_abscissa) AS long FROM stretch GROUP BY edge_id) s USING (edge_id)
      WHERE high - low > 1e-6
    UNION ALL SELECT 'pieces of a side follow each other outwards without gap or overlap', bool_and(abs(offset_from - before) < 1e-6 AND abs(offset_from_end - before_end) < 1e-6
        AND offset_to > offset_from - 1e-6 AND offset_to_end > offset_from_end - 1e-6 IS NOT FALSE AND "order" = number AND (offset_to IS NULL) = last AND (offset_to_end IS NULL) = last)
      FROM (SELECT *, coalesce(lag(offset_to) OVER w, 0) AS before, coalesce(lag(offset_to_end) OVER w, 0) AS before_end, row_number() OVER w AS number, lead(true) OVER w IS NULL AS last
        FROM piece WINDOW w AS (PARTITION BY edge_id, start_abscissa, side ORDER BY "order")) s
    UNION ALL SELECT 'on both sides of each stretch', (SELECT 2 * count(*) FROM stretch) = count(*) FROM (SELECT DISTINCT edge_id, start_abscissa, side FROM piece) s
    UNION ALL SELECT 'lanes and what they leave are as wide as the roadway', bool_and(abs(wide - streetgen._border_at(borders, start_abscissa - first, 'left') - streetgen._border_at(borders, start_abscissa - first, 'right')) < 1e-6
        AND abs(wide_end - streetgen._border_at(borders, end_abscissa - first, 'left') - streetgen._border_at(borders, end_abscissa - first, 'right')) < 1e-6)
      FROM (SELECT edge_id, start_abscissa, end_abscissa, sum(offset_to - offset_from) AS wide, sum(offset_to_end - offset_from_end) AS wide_end
        FROM piece p WHERE lane_id IS NOT NULL OR kind IN ('shoulder', 'bay', 'gutter') AND NOT EXISTS (SELECT FROM piece k WHERE (k.edge_id, k.start_abscissa, k.side, k.kind)
          = (p.edge_id, p.start_abscissa, p.side, 'kerb') AND k."order" < p."order") GROUP BY 1, 2, 3) s JOIN course USING (edge_id)
    UNION ALL SELECT 'each lane lies on its ground', bool_and(abs(cut - most + least) < 5e-3)
      FROM (SELECT (SELECT ST_Length(d.geom) FROM ST_Dump(ST_Intersection(l.surface, ST_MakeLine(streetgen._place_on(line::bytea, middle, least - 1)::geometry,
          streetgen._place_on(line::bytea, middle, most + 1)::geometry))) d ORDER BY ST_Distance(d.geom, streetgen._place_on(line::bytea, middle, (least + most) / 2)::geometry) LIMIT 1) AS cut, least, most
        FROM (SELECT lane_id, edge_id, start_abscissa, line, middle, min(least(outwards * low, outwards * high)) AS least, max(greatest(outwards * low, outwards * high)) AS most
            FROM place WHERE lane_id IS NOT NULL AND end_abscissa - start_abscissa > 1 GROUP BY lane_id, edge_id, start_abscissa, line, middle) p JOIN @.lane l USING (edge_id, lane_id)
        WHERE l.method = 'hypothesis' AND NOT EXISTS (SELECT FROM piece b WHERE (b.edge_id, b.start_abscissa, b.kind) = (p.edge_id, p.start_abscissa, 'bay'))) s
    UNION ALL SELECT 'a standing or flush kerb begins on a kerb, and no other border does', bool_and((kerb <> 'none') = EXISTS (SELECT FROM @.kerb k WHERE (k.edge_id, k.side) = (p.edge_id, p.side)
        AND k.method <> 'level_change' AND ST_DWithin(k.geom, streetgen._place_on(line::bytea, middle, outwards * low)::geometry, 5e-3))) FROM place p
      WHERE kind = 'kerb' AND end_abscissa - start_abscissa > 1
        -- The stone behind a bay is of no kerb of the roadway.
        AND NOT EXISTS (SELECT FROM piece b WHERE (b.edge_id, b.start_abscissa, b.side, b.kind, b."order") = (p.edge_id, p.start_abscissa, p.side, 'bay', p."order" - 1)
          AND EXISTS (SELECT FROM piece f WHERE (f.edge_id, f.start_abscissa, f.side, f.kind, f."order") = (p.edge_id, p.start_abscissa, p.side, 'kerb', p."order" - 2)))
        -- Beside the arc of a nose the border runs straight, as the guide says.
        AND NOT EXISTS (SELECT FROM @.corner c WHERE p.edge_id IN (c.edge_a, c.edge_b) AND ST_DWithin(c.arc, streetgen._place_on(line::bytea, middle, outwards * low)::geometry, 0.5))
    UNION ALL SELECT 'sidewalks lie on theirs', bool_and(EXISTS (SELECT FROM @.sidewalk s WHERE (s.edge_id, s.side) = (p.edge_id, p.side)
        AND ST_DWithin(coalesce(s.strip, s.surface), streetgen._place_on(line::bytea, middle, outwards * (low + high) / 2)::geometry, 1e-3))) FROM place p WHERE kind = 'sidewalk' AND end_abscissa - start_abscissa > 1
    UNION ALL SELECT 'and none is left out', bool_and(EXISTS (SELECT FROM piece p WHERE (p.edge_id, p.side) = (s.edge_id, s.side) AND p.kind IN ('sidewalk', 'verge', 'buffer', 'cycle_track')))
      FROM @.sidewalk s JOIN course USING (edge_id) WHERE node_id IS NULL AND side IN ('left', 'right') AND s.width > 0.31 AND s.method <> 'contested' AND high - low > 1e-6$q$, '@', quote_ident(model));
  DROP TABLE piece, stretch, course, place;
END $$;
