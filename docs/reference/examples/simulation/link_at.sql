-- argument link: key of a row of view link
-- argument metres: along the link, in the direction of its traffic
-- argument wheelbase: between the axles of the car, metres
-- see lane_beside
SELECT round(heading) AS heading, round(curvature::numeric, 3) AS curvature, round(steering::numeric, 1) AS steering
FROM streetgen.link_at('town', (SELECT min(link_id) FROM town.link WHERE kind = 'movement'), 3);
-- drawing
WITH box AS (SELECT ST_Expand(n.geom, 25) AS geom FROM town.intersection i JOIN town.node n USING (node_id) ORDER BY ST_Area(surface) DESC LIMIT 1),
movement AS (SELECT m.* FROM town.link m, box WHERE m.kind = 'movement' AND ST_Intersects(m.geom, box.geom))
SELECT ST_Intersection(s.surface, box.geom), 'section', NULL FROM town.roadway s, box WHERE s.surface && box.geom
    UNION ALL SELECT m.geom, 'input', NULL FROM movement m
    UNION ALL SELECT ST_MakeLine(p.geom, ST_Translate(p.geom, 1.4 * cosd(heading), 1.4 * sind(heading))), 'result', NULL
        FROM movement m, generate_series(0, m.length::integer, 3) metres, streetgen.link_at('town', m.link_id, least(metres, m.length)) p
