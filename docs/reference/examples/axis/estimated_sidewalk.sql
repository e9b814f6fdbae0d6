-- argument kind: class of the axis
-- argument widths: widths from importance 1 on, metres
-- see estimated_width
SELECT streetgen.estimated_sidewalk(3, 'secondary', ARRAY[3, 3, 2.5, 2]) AS street, streetgen.estimated_sidewalk(1, 'motorway', ARRAY[3, 3, 2.5, 2]) AS motorway;
