-- argument mode: paper, or setra: the law that it comes from
-- see wanted_radius, corner_arc
SELECT speed, round(streetgen.turning_radius(speed, 7)::numeric, 2) AS paper, round(streetgen.turning_radius(speed, 7, 'setra')::numeric, 2) AS setra
FROM unnest(ARRAY[20, 30, 50]) speed;
