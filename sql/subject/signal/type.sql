-- A signal program is computed from these types, and given as them.
CREATE TYPE streetgen.signal_request AS (lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
    approach bigint, exit bigint, turn text, length float8, speed float8, lanes integer, importance integer,
    flow float8, precedence integer, conflicts integer[], reaches float8[], walks integer[], walk_seconds float8[],
    walk_reaches float8[]);
COMMENT ON TYPE streetgen.signal_request IS 'A movement that asks a signal program for green.';
COMMENT ON COLUMN streetgen.signal_request.lane_in IS 'the lane that it comes from';
COMMENT ON COLUMN streetgen.signal_request.lane_out IS 'the lane that it leads to';
COMMENT ON COLUMN streetgen.signal_request.along_in IS 'does one drive along the axis of the first?';
COMMENT ON COLUMN streetgen.signal_request.along_out IS 'does one drive along the axis of the second?';
COMMENT ON COLUMN streetgen.signal_request.approach IS 'the edge that it comes by';
COMMENT ON COLUMN streetgen.signal_request.exit IS 'the edge that it leaves by';
COMMENT ON COLUMN streetgen.signal_request.turn IS 'through, left, right or u_turn';
COMMENT ON COLUMN streetgen.signal_request.length IS 'metres across the junction';
COMMENT ON COLUMN streetgen.signal_request.speed IS 'of the approach, km/h';
COMMENT ON COLUMN streetgen.signal_request.lanes IS 'of the approach that lead to the junction';
COMMENT ON COLUMN streetgen.signal_request.importance IS 'of the approach, 1 highest';
COMMENT ON COLUMN streetgen.signal_request.flow IS 'vehicles an hour that come by the approach; NULL: unknown';
COMMENT ON COLUMN streetgen.signal_request.precedence IS
    'place in the order of who goes first: of two that meet the greater number gives way; NULL: as they come';
COMMENT ON COLUMN streetgen.signal_request.conflicts IS
    'which of the movements cross it, merge with it or oppose it: their numbers in the array, from 1';
COMMENT ON COLUMN streetgen.signal_request.reaches IS
    'metres along it to where it meets each of them; NULL or empty: anywhere along it';
COMMENT ON COLUMN streetgen.signal_request.walks IS
    'crossings on foot, numbered from 1 in the junction, on which people wait for it: it comes in or goes straight on '
    'over them';
COMMENT ON COLUMN streetgen.signal_request.walk_seconds IS
    'seconds that people need at each of them: the shortest walk signal, and the way across';
COMMENT ON COLUMN streetgen.signal_request.walk_reaches IS 'metres along it to each of them';

CREATE TYPE streetgen.signal_asked AS (junction_id bigint, movements streetgen.signal_request[],
    control_points bigint[], crossed bigint[], clear float8[]);
COMMENT ON TYPE streetgen.signal_asked IS 'A junction that asks for a signal program.';
COMMENT ON COLUMN streetgen.signal_asked.junction_id IS 'the junction';
COMMENT ON COLUMN streetgen.signal_asked.movements IS 'its movements; NULL: there are none';
COMMENT ON COLUMN streetgen.signal_asked.control_points IS 'the crossings on foot, by their numbers';
COMMENT ON COLUMN streetgen.signal_asked.crossed IS 'the edges that they cross';
COMMENT ON COLUMN streetgen.signal_asked.clear IS 'seconds in which people who have stepped on are across';

CREATE TYPE streetgen.signal_answer AS (ordinality integer, duration float8, kind text, lane_in bigint,
    lane_out bigint, along_in boolean, along_out boolean, right_of_way text);
COMMENT ON TYPE streetgen.signal_answer IS
    'A state of a signal program: a row for each movement that has green in it, or one row without a movement.';
COMMENT ON COLUMN streetgen.signal_answer.ordinality IS 'number of the state in the cycle, from 1';
COMMENT ON COLUMN streetgen.signal_answer.duration IS 'seconds';
COMMENT ON COLUMN streetgen.signal_answer.kind IS 'green, amber, all_red or walk (nobody drives)';
COMMENT ON COLUMN streetgen.signal_answer.lane_in IS 'the lane that the movement comes from';
COMMENT ON COLUMN streetgen.signal_answer.lane_out IS 'the lane that it leads to';
COMMENT ON COLUMN streetgen.signal_answer.along_in IS 'does one drive along the axis of the first?';
COMMENT ON COLUMN streetgen.signal_answer.along_out IS 'does one drive along the axis of the second?';
COMMENT ON COLUMN streetgen.signal_answer.right_of_way IS 'protected, or permitted: it gives way to who is protected';

CREATE TYPE streetgen.signal_found AS (controller_id bigint, program text, start_offset float8, method text,
    ordinality integer, duration float8, kind text, lane_in bigint, lane_out bigint, along_in boolean,
    along_out boolean, right_of_way text, precedence integer, signal_group integer, turn_phases boolean);
COMMENT ON TYPE streetgen.signal_found IS 'A row of an answer with the controller that runs it.';
COMMENT ON COLUMN streetgen.signal_found.controller_id IS 'the controller';
COMMENT ON COLUMN streetgen.signal_found.program IS 'its program';
COMMENT ON COLUMN streetgen.signal_found.start_offset IS 'seconds by which its cycle starts late';
COMMENT ON COLUMN streetgen.signal_found.method IS 'how it is known that signals stand there';
COMMENT ON COLUMN streetgen.signal_found.ordinality IS 'number of the state; NULL: the junction has no movement';
COMMENT ON COLUMN streetgen.signal_found.duration IS 'seconds';
COMMENT ON COLUMN streetgen.signal_found.kind IS 'green, amber or all_red';
COMMENT ON COLUMN streetgen.signal_found.lane_in IS 'the lane that the movement comes from';
COMMENT ON COLUMN streetgen.signal_found.lane_out IS 'the lane that it leads to';
COMMENT ON COLUMN streetgen.signal_found.along_in IS 'does one drive along the axis of the first?';
COMMENT ON COLUMN streetgen.signal_found.along_out IS 'does one drive along the axis of the second?';
COMMENT ON COLUMN streetgen.signal_found.right_of_way IS 'protected or permitted';
COMMENT ON COLUMN streetgen.signal_found.precedence IS 'place in the order of who goes first';
COMMENT ON COLUMN streetgen.signal_found.signal_group IS 'the signal group of the movement';
COMMENT ON COLUMN streetgen.signal_found.turn_phases IS 'by hand: do turns across others have a phase of their own?';
