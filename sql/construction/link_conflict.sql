-- Movements of junctions that need the same ground, and who waits for whom.

CREATE OR REPLACE FUNCTION streetgen._link_conflicts(junctions bigint[], lanes_in bigint[], lanes_out bigint[],
    along_in boolean[], along_out boolean[], lengths float8[], widths float8[], turns integer[], ranks integer[],
    importances integer[], precedences integer[], protected_states bigint[], permitted_states bigint[],
    pieces integer[], s float8[], x float8[], y float8[], heading float8[], curvature float8[], left_hand boolean)
    RETURNS TABLE(first integer, second integer, kind text, precedence text, first_from float8, first_to float8,
        second_from float8, second_to float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000 ROWS 10000
    AS 'MODULE_PATHNAME', 'streetgen_link_conflicts';
COMMENT ON FUNCTION streetgen._link_conflicts(bigint[], bigint[], bigint[], boolean[], boolean[], float8[], float8[],
    integer[], integer[], integer[], integer[], bigint[], bigint[], integer[], float8[], float8[], float8[], float8[],
    float8[], boolean) IS
    'The pairs of movements of a junction that need the same ground, by their numbers from 1. An element a movement: '
    'its junction or node, whose movements stand together; lanes, and whether one drives along their axes; metres; '
    'metres of its lane; turns 0 through, 1 left, 2 right, 3 back; who has the smaller rank, importance or precedence '
    'goes first, as include/streetgen/link_conflict.hpp says; a bit for each state of a signal program in which it has '
    'green, none without a signal; how many pieces its course has. The pieces of all follow: metres along the '
    'movement, place, heading (radians), curvature (1/m). A row has the kind (crossing, merging, opposing), what the '
    'first does (goes_first, gives_way, by_arrival, by_signal), and metres along each where a car stands on ground '
    'that the other needs. Numbers out of range: 22023; lists of different length: 2202E; NULL in one: 22004.';
