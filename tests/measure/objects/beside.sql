-- What bays beside the roadway and on the kerb lie on and what they leave, where each side of each street says how cars stand: psql -v model=MODEL. Extracts of OpenStreetMap say that of few
-- streets, so that a number of the axis and the side chooses. A row a measure: how many break it, and of how many. Surfaces and axes alone tell. The model changes.
SET search_path = :"model", public;
UPDATE axis SET parking_left = words[1 + abs(hashint8(axis_id)) % 9], parking_right = words[1 + abs(hashint8(-axis_id)) % 9]
    FROM (SELECT '{street_side,on_kerb,half_on_kerb,street_side|perpendicular,on_kerb|diagonal,no,on_kerb|parallel|2.2|6,street_side|diagonal,half_on_kerb|parallel||4}'::text[] AS words) w
    WHERE kind = ANY ('{residential,unclassified,tertiary,secondary,living_street,primary}') AND level = 0;
DELETE FROM placement_rule;
INSERT INTO placement_rule (type, along) VALUES ('parking_bay', 'lane');
SELECT streetgen.generate(:'model', wait => true) \g /dev/null
CREATE TEMP TABLE bay AS SELECT o.street_object_id AS id, o.axis_id, o.side, e.edge_id, e.level, b.surface, o.axis_offset, split_part(CASE o.side WHEN 'left' THEN a.parking_left ELSE a.parking_right END, '|', 1) AS place,
    CASE b.angle WHEN 0 THEN b.width ELSE b.length * sind(b.angle) END AS depth FROM parking_bay b JOIN street_object o USING (street_object_id) JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id)
    JOIN axis a ON a.axis_id = o.axis_id WHERE b.surface IS NOT NULL AND o.axis_offset > 0;
CREATE INDEX ON bay USING gist (surface);
ANALYZE bay;
CREATE TEMP TABLE broken AS
SELECT 'on the roadway of its own street, over 2 % of what lies behind the kerb' AS measure, b.id FROM bay b JOIN section s USING (edge_id)
    WHERE ST_Area(ST_Intersection(s.surface, b.surface)) > ST_Area(b.surface) * (greatest(0, depth - axis_offset) / depth + 0.02)
UNION SELECT 'on the roadway of another street', b.id FROM bay b JOIN section s ON s.surface && b.surface AND s.edge_id <> b.edge_id JOIN edge e ON e.edge_id = s.edge_id AND e.level = b.level WHERE ST_Area(ST_Intersection(s.surface, b.surface)) > 0.1
UNION SELECT 'on an intersection', b.id FROM bay b JOIN intersection i ON i.surface && b.surface AND i.level = b.level WHERE ST_Area(ST_Intersection(i.surface, b.surface)) > 0.1
UNION SELECT 'within two metres of a crossing', b.id FROM bay b JOIN pedestrian_crossing c ON ST_DWithin(c.surface, b.surface, 0.9)
UNION SELECT 'on another bay', b.id FROM bay b JOIN bay c ON c.surface && b.surface AND c.id < b.id AND c.level = b.level WHERE ST_Area(ST_Intersection(c.surface, b.surface)) > 0.1
UNION SELECT 'on the sidewalk of another street', b.id FROM bay b JOIN sidewalk w ON w.surface && b.surface JOIN edge e ON e.edge_id = w.edge_id AND e.level = b.level AND e.axis_id <> b.axis_id WHERE ST_Area(ST_Intersection(w.surface, b.surface)) > 0.1;
SELECT place, measure, count(*) AS broken, (SELECT count(*) FROM bay o WHERE o.place = b.place) AS bays FROM broken JOIN bay b USING (id) GROUP BY place, measure ORDER BY 1, 2;
SELECT place, 'bays that break none', count(*) FILTER (WHERE id NOT IN (SELECT id FROM broken)) AS bays, count(*) AS of FROM bay GROUP BY place ORDER BY place;
-- Sidewalks behind bays beside the roadway keep their width, and those under bays on the kerb lose that.
SELECT 'sides with a sidewalk behind bays beside the roadway, of sides with these', count(*) FILTER (WHERE EXISTS (SELECT FROM sidewalk w WHERE w.edge_id = b.edge_id AND w.side = b.side AND w.node_id IS NULL AND w.width > deep + 0.5)) AS sides, count(*) AS of
    FROM (SELECT edge_id, side, max(axis_offset) AS deep FROM bay WHERE place = 'street_side' GROUP BY 1, 2) b;
SELECT rule, count(*), round(min(measure)::numeric, 2) AS least FROM streetgen.check_model(:'model') WHERE rule ~ 'bay' OR severity = 'error' GROUP BY rule ORDER BY rule;
