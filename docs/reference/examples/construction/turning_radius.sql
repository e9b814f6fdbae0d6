-- argument mode: paper, or setra: the law that it comes from
-- argument minimal: the least radius, metres
-- argument maximal: the greatest radius, metres
-- see wanted_radius, corner_arc
SELECT speed, round(streetgen.turning_radius(speed, 7)::numeric, 2) AS paper, round(streetgen.turning_radius(speed, 7, 'setra')::numeric, 2) AS setra,
    round(streetgen.turning_radius(speed, 7, maximal => 30)::numeric, 2) AS paper_up_to_30
FROM unnest(ARRAY[20, 30, 50]) speed;
