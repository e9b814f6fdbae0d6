-- Objects stand at the streets of the sample, where their subject is computed: signals on the avenue, crossings, trees, lamps, benches.
SELECT 'object' = ANY (streetgen._subjects('quarter')) AS stands \gset
\if :stands
INSERT INTO quarter.control_point (geom, kind) SELECT ST_Translate(geom, 650000, 6860000), 'signals'
    FROM (VALUES ('SRID=2154;POINT(120 0)'::geometry), ('SRID=2154;POINT(260 6)')) v(geom);
INSERT INTO quarter.placement_rule (type, along, distance_from_limit, importance_to) VALUES ('crossing', 'arm', 2.5, 5);
INSERT INTO quarter.placement_rule (type, side, every, phase, axis_offset, distance_from_limit, importance_from, importance_to) VALUES
    ('tree', 'both', 12, 4, 1.2, 10, 2, 2), ('lamp', 'alternating', 24, 10, 0.6, 4, 2, 5), ('bench', 'right', 48, 22, 2, 12, 2, 2);
\endif
