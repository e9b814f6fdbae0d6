-- argument axes: LINESTRINGs, metres, each from the node outwards
-- argument widths: width of each axis kerb to kerb, metres, up to 200
-- argument radii: radius of the corner from each axis to the next counter-clockwise, metres
-- argument curved: true arcs in a CURVEPOLYGON, where the outline can be built piece by piece
-- see corner_arc, section_surface
SELECT round(ST_Area(streetgen.intersection_surface(ARRAY['LINESTRING(0 0, 60 0)', 'LINESTRING(0 0, 0 60)', 'LINESTRING(0 0, -60 0)']::geometry[],
    ARRAY[8, 6, 8], ARRAY[7, 7, 7]))::numeric, 2) AS m2;
-- drawing
WITH given AS (SELECT ARRAY['LINESTRING(0 0, 32 0)', 'LINESTRING(0 0, 8 30)', 'LINESTRING(0 0, -30 4)']::geometry[] AS axes)
SELECT streetgen.section_surface(axis, width, 0, 32), 'section', NULL FROM given, unnest(axes, ARRAY[8, 6, 8]) t(axis, width)
UNION ALL SELECT streetgen.intersection_surface(axes, ARRAY[8, 6, 8], ARRAY[7, 7, 7]), 'result', NULL FROM given
UNION ALL SELECT axis, 'axis', NULL FROM given, unnest(axes) axis
