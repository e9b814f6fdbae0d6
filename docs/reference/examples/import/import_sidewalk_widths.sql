-- argument source: table of widths
-- argument mapping: columns of the table: `source_ref`, and `left` and `right` or `odd` and `even`; `odd_side`: left or right
-- see import_axes
CREATE TEMPORARY TABLE survey AS SELECT 'way 1' AS arc, 1.8 AS odd, 12.0 AS even;
UPDATE town.axis SET source = 'survey', source_ref = 'way ' || axis_id;
SELECT what, class, count, source_refs FROM streetgen.import_sidewalk_widths('town', 'survey', '{"source_ref": "arc", "odd": "odd", "even": "even"}');
