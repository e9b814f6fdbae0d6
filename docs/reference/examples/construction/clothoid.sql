-- argument start: POINT where it starts
-- argument heading: heading at the start, radians counter-clockwise from the x axis
-- argument length: metres
-- argument curvature_start: curvature at the start, 1/m, positive on left bends
-- argument curvature_end: curvature at the end, 1/m
-- argument tolerance: chords leave the clothoid by at most this, metres
-- see horizontal_alignment
SELECT ST_AsText(streetgen.clothoid('POINT(0 0)', 0, 60, 0, 0.02, 0.5), 2);
-- drawing
SELECT streetgen.clothoid('POINT(0 0)', 0, 200, 0, 0.03), 'result', NULL
UNION ALL SELECT 'POINT(0 0)'::geometry, 'point', 'start'
