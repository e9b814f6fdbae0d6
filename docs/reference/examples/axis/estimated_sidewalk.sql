-- argument walked_along: whether people walk along the class of the axis
-- argument widths: widths from importance 1 on, metres
-- see estimated_width
SELECT streetgen.estimated_sidewalk(3, true, ARRAY[3, 3, 2.5, 2]) AS street, streetgen.estimated_sidewalk(1, false, ARRAY[3, 3, 2.5, 2]) AS motorway;
