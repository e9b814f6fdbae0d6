-- argument movements: what asks for green; conflicts are numbers in this array, from 1
-- argument cycle: the longest cycle, s
-- argument all_red: the longest all red of a change, s
-- argument step: each state lasts a number of these, s
-- argument walk: people on foot step on within this time, s
-- argument importance: approaches of lower importance have no phase of their own
-- argument turn_phases: do turns across others have a phase of their own? NULL: as lanes and speed say
-- see signal_phases
SELECT ordinality, duration, kind, lane_in, lane_out, right_of_way FROM streetgen.signal_pairs(ARRAY[
    (1, 4, true, true, 10, 20, 'through', 20, 50, 1, 2, NULL, 1, '{2}', '{12}', NULL, NULL, NULL), (2, 5, true, true, 30, 40, 'through', 20, 50, 1, 3, NULL, 2, '{1}', '{8}', NULL, NULL, NULL)]::streetgen.signal_request[]);
