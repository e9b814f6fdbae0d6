-- see subject, set
SELECT streetgen.junction_kind(ARRAY[
    (1, 'primary', 2, 50, 9, 1, 1, 0, 'signals', false, NULL), (2, 'primary', 2, 50, 9, 1, 1, 180, 'signals', false, NULL),
    (3, 'residential', 5, 30, 6, 1, 1, 90, NULL, false, NULL)]::streetgen.junction_arm[]);
