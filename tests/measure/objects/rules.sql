-- The rules by which measures of objects place things: psql -v model=MODEL.
INSERT INTO :"model".placement_rule (type, along, side, every, phase, axis_offset, distance_from_limit, importance_to) VALUES
    ('crossing', 'arm', 'both', 25, 0, 0, 2.5, NULL), ('parking_bay', 'border', 'right', 6, 3, 0, 5, NULL),
    ('lamp', 'border', 'alternating', 25, 10, 0.8, 2, NULL), ('tree', 'border', 'both', 8, 0, 1.2, 5, NULL),
    ('bollard', 'corner', 'both', 3, 0, 0.5, 0, NULL), ('bench', 'border', 'right', 40, 20, 2, 5, NULL);
