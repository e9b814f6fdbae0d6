-- A regression forest: a number that is learnt from samples of several features.

CREATE OR REPLACE FUNCTION streetgen._grow_forest(features float8[], sample_values float8[]) RETURNS float8[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 AS 'MODULE_PATHNAME', 'streetgen_grow_forest';
COMMENT ON FUNCTION streetgen._grow_forest(float8[], float8[]) IS
    'The forest that samples grow, as streetgen.forest_value takes it: the features of all samples one after the '
    'other, and the value of each. The order of the samples does not matter. No sample, or numbers that do not fit: '
    '22023.';

CREATE OR REPLACE FUNCTION streetgen.forest_value(forest float8[], features float8[]) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_forest_value';
COMMENT ON FUNCTION streetgen.forest_value(float8[], float8[]) IS
    'The value that a regression forest gives features, the median of its trees. forest: how many features and trees, '
    'and of each tree how many nodes, then four numbers a node: feature (from 0), threshold, the node for values below '
    'it and that for others; a leaf has -1 and its value. streetgen.train_radius writes such. Numbers that are no '
    'forest, or other features: 22023. NULL for NULL. StreetGen paper, 3.1.';
