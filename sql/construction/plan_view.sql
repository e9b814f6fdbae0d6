-- Chains of lines, arcs and clothoids along a line: what OpenDRIVE calls a plan view.

CREATE OR REPLACE FUNCTION streetgen._plan_view(line bytea, tolerance float8)
    RETURNS TABLE(s float8, x float8, y float8, heading float8, length float8, curvature float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 10 AS 'MODULE_PATHNAME', 'streetgen_plan_view';
COMMENT ON FUNCTION streetgen._plan_view(bytea, float8) IS 'EWKB twin of streetgen.plan_view';

CREATE OR REPLACE FUNCTION streetgen.plan_view(line geometry, tolerance float8 DEFAULT 0.05)
    RETURNS TABLE(s float8, x float8, y float8, heading float8, length float8, curvature float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 10
    SET search_path = pg_catalog, public
    AS $$ SELECT p.s, p.x, p.y, p.heading, p.length, p.curvature
          FROM streetgen._plan_view(line::bytea, tolerance) p $$;
COMMENT ON FUNCTION streetgen.plan_view(geometry, float8) IS
    'A chain of lines and arcs along a line (LINESTRING, metres), in its order, as the planView of OpenDRIVE has it: s '
    '(metres along the chain), x and y where a piece begins, heading there (radians, counter-clockwise from east), '
    'length (metres) and curvature (1/m, positive to the left; 0: a line). Each piece goes on in place and heading '
    'where the one before ends. The chain begins and ends where the line does, as its first and last side lead, and '
    'lies within tolerance of it (metres, 0.0001 to 1000): points that matter less are left out, and an arc is put '
    'into each kink that stays. A line that turns back on itself goes about in two arcs. A line that is no '
    'LINESTRING or has no length, a number out of range: 22023. NULL for anything: no row. ASAM OpenDRIVE 1.7, '
    'section 8.';

CREATE OR REPLACE FUNCTION streetgen._path_view(path bytea, place_from float8[], place_to float8[], tolerance float8,
    lane_width float8)
    RETURNS TABLE(s float8[], x float8[], y float8[], heading float8[], length float8[], curvature float8[],
        curvature_end float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_path_view';
COMMENT ON FUNCTION streetgen._path_view(bytea, float8[], float8[], float8, float8) IS
    'The curve of a path (EWKB) in one row of arrays, from one place to another: x, y and heading. It begins and '
    'ends there, also where the ends of the path lie beside them, and is wider than half the lane.';

CREATE OR REPLACE FUNCTION streetgen.path_view(path geometry, heading_from float8, heading_to float8,
    lane_width float8 DEFAULT 3.5, tolerance float8 DEFAULT 0.05)
    RETURNS TABLE(s float8, x float8, y float8, heading float8, length float8, curvature float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 3
    SET search_path = pg_catalog, public
    AS $$ SELECT u.*
        -- A path that is no line has no ends, and is refused.
        FROM (SELECT CASE GeometryType(path) WHEN 'LINESTRING' THEN path END AS line) l,
          streetgen._path_view(path::bytea,
              ARRAY[coalesce(ST_X(ST_StartPoint(line)), 0), coalesce(ST_Y(ST_StartPoint(line)), 0), heading_from],
              ARRAY[coalesce(ST_X(ST_EndPoint(line)), 0), coalesce(ST_Y(ST_EndPoint(line)), 0), heading_to],
              tolerance, lane_width) v,
          unnest(v.s, v.x, v.y, v.heading, v.length, v.curvature) u $$;
COMMENT ON FUNCTION streetgen.path_view(geometry, float8, float8, float8, float8) IS
    'The curve of a path from lane to lane (LINESTRING, metres), as streetgen.plan_view gives a chain: as few lines '
    'and arcs as stay within tolerance of the path (metres, 0.0001 to 1000), or a little more where more of them '
    'come no nearer. It begins and ends where the path does, in the headings of its lanes (radians, counter-clockwise '
    'from east). No arc is tighter than 3.1 m or half of lane_width (metres, 0.001 to 1000), but where the path turns '
    'as far itself within 2 m. Where its end leads elsewhere than the lane, the curve leaves the path beside that '
    'end. A path that ends where it begins: no row. A line that is no LINESTRING, a number out of range: 22023. NULL '
    'for anything: no row.';

CREATE OR REPLACE FUNCTION streetgen._road_lanes(axis bytea, alignment float8[], reach float8, lines bytea[],
    surfaces bytea[], widths float8[], parts integer[], tolerance float8)
    RETURNS TABLE(s float8[], x float8[], y float8[], heading float8[], length float8[], curvature float8[],
        curvature_end float8[], station float8[], border float8[], starts float8[], ends float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_road_lanes';
COMMENT ON FUNCTION streetgen._road_lanes(bytea, float8[], float8, bytea[], bytea[], float8[], integer[], float8) IS
    'The plan view of an axis (EWKB) in one row of arrays, and the lanes across it. It is the part of the alignment '
    '(seven numbers for each element) beside the axis, where all of the axis lies within reach of that; else a chain '
    'of lines and arcs within tolerance of the axis. Lanes are given from the left by line, surface (MULTIPOLYGON, '
    'empty: so wide about the line), width (0: it lies on its surface alone) and part (0: it is all of that, 1: its '
    'left half, 2: its right half). station: metres along the chain. '
    'border: metres to the left of the chain, by border from the left, then by station, and straight between '
    'stations. starts and ends: x, y, heading and width of each lane at the first and the last station.';

CREATE OR REPLACE FUNCTION streetgen._road_part(of_s float8[], of_x float8[], of_y float8[], of_heading float8[],
    of_length float8[], of_curvature float8[], of_curvature_end float8[], of_station float8[], of_border float8[],
    since float8, until float8)
    RETURNS TABLE(s float8[], x float8[], y float8[], heading float8[], length float8[], curvature float8[],
        curvature_end float8[], station float8[], border float8[], starts float8[], ends float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_road_part';
COMMENT ON FUNCTION streetgen._road_part(float8[], float8[], float8[], float8[], float8[], float8[], float8[],
    float8[], float8[], float8, float8) IS
    'The part of what streetgen._road_lanes gives between two stations (metres), which count from its beginning then. '
    'Arrays that do not fit, or a part without length: 22023.';

CREATE OR REPLACE FUNCTION streetgen._chain_station(s float8[], x float8[], y float8[], heading float8[],
    length float8[], curvature float8[], curvature_end float8[], place_x float8, place_y float8)
    RETURNS TABLE(station float8, aside float8, direction float8, beyond float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_chain_station';
COMMENT ON FUNCTION streetgen._chain_station(float8[], float8[], float8[], float8[], float8[], float8[], float8[],
    float8, float8) IS
    'Where a place lies beside a plan view of arrays: station (metres along it, of the nearest place), aside (metres '
    'to its left), direction (its heading there, radians) and beyond (metres straight on behind its end, negative '
    'before it begins, else 0). Arrays of different length, or empty: 22023.';

CREATE OR REPLACE FUNCTION streetgen._chain_borders(s float8[], x float8[], y float8[], heading float8[],
    length float8[], curvature float8[], curvature_end float8[], station float8[], border float8[], ends float8[],
    height_station float8[], height float8[], tolerance float8)
    RETURNS TABLE(number integer, nth integer, last boolean, x1 float8, y1 float8, z1 float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 20 AS 'MODULE_PATHNAME', 'streetgen_chain_borders';
COMMENT ON FUNCTION streetgen._chain_borders(float8[], float8[], float8[], float8[], float8[], float8[], float8[],
    float8[], float8[], float8[], float8[], float8[], float8) IS
    'The points of borders along a plan view of arrays. station and border are those of streetgen._road_lanes; ends: '
    'where each border begins and ends, x, y, x, y, or empty. height is the height at height_station, metres along '
    'the plan view; both are empty where there are no heights. A row has the number of the border from the left, that '
    'of the point along the chain, both from 1, and whether it is the last one. Borders never fold. Chords leave them '
    'by tolerance, metres. Arrays that do not fit: 22023.';
