-- argument movements: what asks for green; conflicts are numbers in this array, from 1
-- see signal_phases
SELECT ordinality, duration, kind, lane_in, lane_out, right_of_way FROM streetgen.signal_pairs(ARRAY[
    (1, 4, true, true, 10, 20, 'through', 20, 50, 1, 2, NULL, NULL, NULL, '{2}'), (2, 5, true, true, 30, 40, 'through', 20, 50, 1, 3, NULL, NULL, NULL, '{1}')]::streetgen.signal_request[]);
