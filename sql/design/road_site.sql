-- The core's part of designed roads: private twins, which take numbers, EWKB and a site.

CREATE OR REPLACE FUNCTION streetgen._road_path(site streetgen.road_site, places bytea, straight float8[])
    RETURNS TABLE(x float8, y float8, z float8, by_hand boolean, barrier text)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000 ROWS 50 AS 'MODULE_PATHNAME', 'streetgen_road_path';
COMMENT ON FUNCTION streetgen._road_path(streetgen.road_site, bytea, float8[]) IS
    'Vertices of the road of least cost through places (LINESTRING, EWKB); by_hand says which of them were given. '
    'straight: 1 for a place where the side before it is taken as it is. Without a way one row says what bars it: '
    'terrain, zone, grade or turn.';

CREATE OR REPLACE FUNCTION streetgen._road_curves(site streetgen.road_site, path bytea, curves float8[])
    RETURNS TABLE(radius float8, clothoid_in float8, clothoid_out float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 50 AS 'MODULE_PATHNAME', 'streetgen_road_curves';
COMMENT ON FUNCTION streetgen._road_curves(streetgen.road_site, bytea, float8[]) IS
    'The curve at each vertex of a path (LINESTRING, EWKB). curves: radius and both clothoids of each vertex, as given '
    'by hand; radius 0: free.';

CREATE OR REPLACE FUNCTION streetgen._road_profile(site streetgen.road_site, elements float8[], ends float8[],
    fixed float8[], rejected float8[], limits float8[])
    RETURNS TABLE(abscissa float8, height float8, radius float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_road_profile';
COMMENT ON FUNCTION streetgen._road_profile(streetgen.road_site, float8[], float8[], float8[], float8[], float8[]) IS
    'Grade points of least cost along an alignment. ends: heights of both ends; fixed: abscissa, height and radius of '
    'points that stay; rejected: abscissas without a point; limits: abscissa, least and greatest height.';

CREATE OR REPLACE FUNCTION streetgen._road_estimate(site streetgen.road_site, elements float8[], grades float8[])
    RETURNS TABLE(what text, start_abscissa float8, end_abscissa float8, cost float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 10 AS 'MODULE_PATHNAME', 'streetgen_road_estimate';
COMMENT ON FUNCTION streetgen._road_estimate(streetgen.road_site, float8[], float8[]) IS
    'Structures of a road, a row each called "is bridge" or "is tunnel", then the terms of its cost.';

CREATE OR REPLACE FUNCTION streetgen._link_towns(towns float8[], by_hand float8[], rejected float8[], factor float8,
    of_network boolean)
    RETURNS TABLE(a integer, b integer, network integer, length float8, utilisation float8, benefit float8,
        cost float8, by_hand_row boolean)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000 ROWS 50 AS 'MODULE_PATHNAME', 'streetgen_link_towns';
COMMENT ON FUNCTION streetgen._link_towns(float8[], float8[], float8[], float8, boolean) IS
    'Links between towns. towns: kind (0 city, 1 town, 2 village, 3 interchange), importance, x and y of each. '
    'by_hand: two towns (numbers from 0) and the network (0 highway, 1 secondary, 2 rural) of links that stay; '
    'rejected: pairs that never come.';

CREATE OR REPLACE FUNCTION streetgen._link_crossings(towns float8[], links float8[])
    RETURNS TABLE(x float8, y float8, first integer, second integer)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 20 AS 'MODULE_PATHNAME', 'streetgen_link_crossings';
COMMENT ON FUNCTION streetgen._link_crossings(float8[], float8[]) IS
    'Where straight links of one network cross, with the numbers of both links, from 0.';

CREATE OR REPLACE FUNCTION streetgen._rank_size_towns(site streetgen.road_site, area bytea, wishes float8[],
    there float8[], seed bigint)
    RETURNS TABLE(kind integer, importance float8, x float8, y float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 50 AS 'MODULE_PATHNAME', 'streetgen_rank_size_towns';
COMMENT ON FUNCTION streetgen._rank_size_towns(streetgen.road_site, bytea, float8[], float8[], bigint) IS
    'Towns by rank and size. wishes: count, cities, towns, largest, exponent, spacing, steepest; there: towns that are '
    'there, as _link_towns takes them.';
