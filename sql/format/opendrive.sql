-- ASAM OpenDRIVE 1.7: roads of lines and arcs with lanes across them, and a road for each movement.

CREATE OR REPLACE FUNCTION streetgen._opendrive_lane_type(kind text, both_ways boolean, turn text DEFAULT NULL)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN kind = 'closed' THEN 'restricted' WHEN both_ways THEN 'bidirectional'
        WHEN kind = 'general' THEN 'driving'
        WHEN kind = 'merging' THEN CASE WHEN turn LIKE 'merge%' THEN 'entry' ELSE 'exit' END
        WHEN kind = 'cycle' THEN 'biking' WHEN kind = 'carpool' THEN 'HOV' ELSE kind END;
COMMENT ON FUNCTION streetgen._opendrive_lane_type(text, boolean, text) IS
    'The type that a lane has in OpenDRIVE, by its kind, whether both directions use it, and where it leads.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_open(element xml) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN left(element::text, -2) || '>';
COMMENT ON FUNCTION streetgen._opendrive_open(xml) IS 'The opening tag of an empty element.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_plan(s float8[], x float8[], y float8[], heading float8[],
    length float8[], curvature float8[], curvature_end float8[], x0 float8, y0 float8, digits integer) RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_opendrive_plan';
COMMENT ON FUNCTION streetgen._opendrive_plan(float8[], float8[], float8[], float8[], float8[], float8[], float8[],
    float8, float8, integer) IS 'The element planView of a chain, from an origin x0, y0.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_change(element text, place text, station float8[], value float8[])
    RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME', 'streetgen_opendrive_change';
COMMENT ON FUNCTION streetgen._opendrive_change(text, text, float8[], float8[]) IS
    'Elements of polynomials that are straight from station to station; place is the attribute that says where.';

-- Most roads are of one stretch: no arrays are made for these.
CREATE OR REPLACE FUNCTION streetgen._opendrive_step(element text, place text, length float8, "from" float8,
    "to" float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN '<' || element || ' ' || place || '="0.0000000" a="' || streetgen._decimal("from", 5)
        || '" b="' || streetgen._decimal(("to" - "from") / length, 9) || '" c="0" d="0"/>';
COMMENT ON FUNCTION streetgen._opendrive_step(text, text, float8, float8, float8) IS
    'The element of a polynomial that is straight over a whole road of that length.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_cubics(element text, place text, s float8[], a float8[], b float8[],
    c float8[], d float8[]) RETURNS text
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME', 'streetgen_opendrive_cubics';
COMMENT ON FUNCTION streetgen._opendrive_cubics(text, text, float8[], float8[], float8[], float8[], float8[]) IS
    'Elements of polynomials; place is the attribute that says where each begins.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_lean(length float8, "from" float8, "to" float8, lean_in float8,
    lean_out float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN (SELECT CASE WHEN lean_in = 0 AND lean_out = 0
            THEN streetgen._opendrive_step('laneOffset', 's', length, "from", "to")
            WHEN lean_in = 0 THEN streetgen._opendrive_cubics('laneOffset', 's', ARRAY[0, length - over],
                ARRAY["from", "to" - slope * over], ARRAY[slope, slope], ARRAY[0, -lean_out / over],
                ARRAY[0, lean_out / over ^ 2])
            WHEN lean_out = 0 THEN streetgen._opendrive_cubics('laneOffset', 's', ARRAY[0, over],
                ARRAY["from", "from" + slope * over], ARRAY[slope + lean_in, slope], ARRAY[-2 * lean_in / over, 0],
                ARRAY[lean_in / over ^ 2, 0])
            ELSE streetgen._opendrive_cubics('laneOffset', 's', ARRAY[0, over, length - over],
                ARRAY["from", "from" + slope * over, "to" - slope * over], ARRAY[slope + lean_in, slope, slope],
                ARRAY[-2 * lean_in / over, 0, -lean_out / over], ARRAY[lean_in / over ^ 2, 0, lean_out / over ^ 2]) END
        FROM (SELECT least(4, length / 3) AS over, ("to" - "from") / length AS slope) e);
COMMENT ON FUNCTION streetgen._opendrive_lean(float8, float8, float8, float8, float8) IS
    'The offsets of lanes along a road of that length, whose lanes lead aside at its ends, over four metres at most, '
    'by lean_in and lean_out: metres to the left by metre of the road.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_station(station float8, total float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN streetgen._decimal(floor(greatest(least(station, total), 0) * 10000) / 10000, 4);
COMMENT ON FUNCTION streetgen._opendrive_station(float8, float8) IS
    'The text of a station, metres, no less than 0 and no more than the length of its road, whatever the digits.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_link(element text, road bigint, road_end boolean, junction bigint)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN road IS NOT NULL THEN '<' || element || ' elementType="road" elementId="' || road
            || '" contactPoint="' || CASE WHEN road_end THEN 'end' ELSE 'start' END || '"/>'
        WHEN junction IS NOT NULL THEN '<' || element || ' elementType="junction" elementId="' || junction || '"/>' END;
COMMENT ON FUNCTION streetgen._opendrive_link(text, bigint, boolean, bigint) IS
    'To what a road is joined: the end of a road, else a junction; NULL: to nothing.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_mark(paint text, leftwards boolean, rightwards boolean,
    inside_left boolean DEFAULT true) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN '<roadMark sOffset="0" type="' || CASE WHEN paint IS NULL THEN 'none' WHEN paint = 'dashed' THEN 'broken'
        WHEN paint = 'solid' THEN 'solid' WHEN leftwards = inside_left THEN 'solid broken' ELSE 'broken solid' END
        || '" color="standard" laneChange="' || CASE WHEN leftwards AND rightwards THEN 'both'
        WHEN leftwards THEN 'increase' WHEN rightwards THEN 'decrease' ELSE 'none' END || '"/>';
COMMENT ON FUNCTION streetgen._opendrive_mark(text, boolean, boolean, boolean) IS
    'The line between two lanes: solid, dashed, mixed (a solid one beside a dashed one) or none (NULL); whether one '
    'may cross it to the left and to the right; inside_left: towards the centre lane is left.';

CREATE OR REPLACE FUNCTION streetgen.export_opendrive(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'opendrive', 'interconnection', options);
BEGIN
    RETURN QUERY SELECT row_number() OVER (ORDER BY rank, ref, text), text
        FROM (SELECT rank, ref, ('    ' || markup) COLLATE "C" AS text
            FROM streetgen._opendrive_elements(model, known)
            UNION ALL SELECT rank, ref, markup COLLATE "C"
            FROM streetgen._xml_frame('<OpenDRIVE>', '</OpenDRIVE>')) l
        ORDER BY rank, ref, text;
END $$;
COMMENT ON FUNCTION streetgen.export_opendrive(name, jsonb) IS
    'A file of ASAM OpenDRIVE 1.7 (or 1.6), line by line. An edge is a road, its reference line a chain of lines and '
    'arcs (streetgen.plan_view) along the axis between its section limits. That of a designed road has the elements '
    'of its alignment, clothoids as spirals, and that of a smoothed edge the arcs of the edge. Its lanes have the '
    'borders of the model as polynomials, parking lanes too; those against the axis lie left of the centre lane '
    'where one drives on the right. A lane that lies among those of the other direction is a road of its own. An '
    'interconnection that connects is a connecting road with one lane, which begins and ends where the lanes do, in '
    'their direction. A node with such is a junction, and nodes whose limits cross are one, without the edges '
    'between them. Sidewalks are the outermost lanes, 0.15 m above the others. A signal stands at the end of each '
    'lane that has one, lanes with the same green have one controller, and the program of the model is userData of '
    'the junction. Stop and yield lines are objects, and have signs where no signal is (206 and 205 of country DE); '
    'so has the beginning of a speed (274). Objects have their '
    'type, place and direction, crossings, bays and lines their outline. Roads have their type, fast ones solid lines '
    'at their edges, and bridges and tunnels. The junctions of an accepted roundabout are '
    'a junctionGroup. All ids are integers, and userData names the edge and the interconnection. Lines between lanes '
    'are road marks, laneChange as view lane_adjacency says. Heights are those of profiles where the model computes '
    'them, else of axes that have any. '
    'Coordinates are counted from the whole metres of offset, and geoReference is the text of PROJ. Lanes that meet '
    'at one place are cut back by 0.05 m for the road that connects them. options as streetgen.export_option() lists '
    'them: an unknown one, or no edge that they take: 22023. A caller who may not read the model: 42501; a model '
    'without interconnections, or junctions that are asked for: 55000; an id beyond 33,554,431: 22003. What is stale '
    'is written as it was, with a warning.';
