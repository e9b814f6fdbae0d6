CREATE TYPE streetgen.road_site AS (
    tiles bytea[], zone_surfaces bytea[], zone_classes float8[], class_costs float8[], class_passages float8[],
    rule_names text[], rule_values float8[]
);
COMMENT ON TYPE streetgen.road_site IS 'What a road is designed on and by, as the private functions of roads take it.';
COMMENT ON COLUMN streetgen.road_site.tiles IS 'tiles of heights, raster WKB';
COMMENT ON COLUMN streetgen.road_site.zone_surfaces IS 'zones: MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.road_site.zone_classes IS 'the number of the class of each zone, from 0';
COMMENT ON COLUMN streetgen.road_site.class_costs IS 'of each class, for a square metre';
COMMENT ON COLUMN streetgen.road_site.class_passages IS 'of each class: 0 free, 1 bridge, 2 forbidden';
COMMENT ON COLUMN streetgen.road_site.rule_names IS 'names of rules of the road, see DesignRules';
COMMENT ON COLUMN streetgen.road_site.rule_values IS 'their values';
