-- A quarter drawn by hand: every kind of junction that StreetGen must build, once each, and named.
-- Metres, SRID 2154, about (650000, 6860000); the numbers below are offsets from there.
-- Variable subjects: what is computed, parted by commas; default where it is not set.
\if :{?subjects}
\else
\set subjects default
\endif
SELECT streetgen.create_model('quarter', 2154, subjects => string_to_array(:'subjects', ','));
WITH drawn(name, wkt, width, width_end, lane_count, importance, level, kind, direction) AS (VALUES
    -- The grid: avenues and residential streets; squares of degree four.
    ('avenue west', 'LINESTRING(0 0, 120 0)', 14, NULL::float8, 4, 2, 0, NULL, 'both'),
    ('avenue middle', 'LINESTRING(120 0, 260 6)', 14, NULL, 4, 2, 0, NULL, 'both'),
    ('avenue east', 'LINESTRING(260 6, 420 0)', 14, NULL, 4, 2, 0, NULL, 'both'),
    ('cross street one, south', 'LINESTRING(120 0, 118 -90)', 8, NULL, 2, 4, 0, NULL, 'both'),
    ('cross street one, north', 'LINESTRING(120 0, 122 100)', 8, NULL, 2, 4, 0, NULL, 'both'),
    ('cross street two, south', 'LINESTRING(260 6, 258 -90)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('cross street two, north', 'LINESTRING(260 6, 262 40, 258 104)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('back street west', 'LINESTRING(122 100, 190 102)', 5.5, NULL, 1, 5, 0, NULL, 'direct'),
    ('back street east', 'LINESTRING(190 102, 258 104)', 5.5, NULL, 1, 5, 0, NULL, 'direct'),
    ('south street', 'LINESTRING(118 -90, 258 -90)', 6, NULL, 2, 5, 0, NULL, 'both'),
    -- T of a wide street with a narrow one (failure 2), the street straight on.
    ('wide street, south', 'LINESTRING(0 0, 0 -80)', 18, NULL, 4, 2, 0, NULL, 'both'),
    ('wide street, far south', 'LINESTRING(0 -80, 0 -170)', 18, NULL, 4, 2, 0, NULL, 'both'),
    ('narrow lane', 'LINESTRING(0 -80, -70 -82)', 4, NULL, 1, 6, 0, NULL, 'both'),
    -- A dead end, and one with a bend.
    ('blind alley', 'LINESTRING(190 102, 191 150)', 5, NULL, 1, 6, 0, NULL, 'both'),
    ('blind alley with a bend', 'LINESTRING(258 104, 259 140, 290 142)', 5, NULL, 1, 6, 0, NULL, 'both'),
    -- Very acute and nearly straight pairs.
    ('acute branch', 'LINESTRING(420 0, 560 22)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('avenue, on', 'LINESTRING(420 0, 580 -6)', 14, NULL, 4, 2, 0, NULL, 'both'),
    ('nearly straight, west', 'LINESTRING(580 -6, 660 -12)', 14, NULL, 4, 2, 0, NULL, 'both'),
    ('nearly straight, east', 'LINESTRING(660 -12, 740 -15)', 14, NULL, 4, 2, 0, NULL, 'both'),
    ('nearly straight, side', 'LINESTRING(660 -12, 664 -90)', 6, NULL, 2, 5, 0, NULL, 'both'),
    -- Width changes: a step with its transition, and linear widening.
    ('narrowing street', 'LINESTRING(740 -15, 800 -16)', 8, NULL, 2, 3, 0, NULL, 'both'),
    ('widening street', 'LINESTRING(800 -16, 900 -18)', 8, NULL, 2, 3, 0, NULL, 'both'),
    ('widened street', 'LINESTRING(900 -18, 980 -18)', 15, NULL, 4, 3, 0, NULL, 'both'),
    -- Bends of degree two, one near a U-turn.
    ('bend, in', 'LINESTRING(118 -90, 60 -140)', 7, NULL, 2, 5, 0, NULL, 'both'),
    ('bend, out', 'LINESTRING(60 -140, 100 -200)', 7, NULL, 2, 5, 0, NULL, 'both'),
    ('hairpin, in', 'LINESTRING(258 -90, 330 -150)', 6, NULL, 2, 5, 0, NULL, 'both'),
    ('hairpin, out', 'LINESTRING(330 -150, 262 -130)', 6, NULL, 2, 5, 0, NULL, 'both'),
    -- A loop (failure 1) and a closed axis that meets nothing.
    ('loop', 'LINESTRING(664 -90, 640 -120, 640 -150, 664 -170, 688 -150, 688 -120, 664 -90)', 5.5, NULL, 1, 5, 0, NULL, 'direct'),
    ('ring alone', 'LINESTRING(760 -120, 800 -120, 800 -160, 760 -160, 760 -120)', 5.5, NULL, 1, 5, 0, NULL, 'direct'),
    -- Short axes between two junctions (failure 3): crossed limits.
    ('staggered, short', 'LINESTRING(0 -170, 9 -171)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('staggered, west', 'LINESTRING(0 -170, -60 -172)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('staggered, east', 'LINESTRING(9 -171, 60 -140)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('staggered, south', 'LINESTRING(9 -171, 12 -240)', 7, NULL, 2, 4, 0, NULL, 'both'),
    -- Stars of degree five and six.
    ('star one', 'LINESTRING(420 0, 440 90)', 8, NULL, 2, 3, 0, NULL, 'both'),
    ('star two', 'LINESTRING(440 90, 530 110)', 8, NULL, 2, 3, 0, NULL, 'both'),
    ('star three', 'LINESTRING(440 90, 470 170)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('star four', 'LINESTRING(440 90, 390 160)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('star five', 'LINESTRING(440 90, 350 80)', 7, NULL, 2, 4, 0, NULL, 'both'),
    ('star six', 'LINESTRING(440 90, 370 40)', 5.5, NULL, 1, 5, 0, NULL, 'both'),
    ('five, south', 'LINESTRING(258 -90, 250 -160)', 6, NULL, 2, 5, 0, NULL, 'both'),
    ('five, west', 'LINESTRING(258 -90, 190 -150)', 6, NULL, 2, 5, 0, NULL, 'both'),
    -- An axis inside another's width.
    ('broad square', 'LINESTRING(530 110, 640 120)', 30, NULL, NULL, 3, 0, NULL, 'both'),
    ('service lane within it', 'LINESTRING(530 110, 560 117, 620 124)', 4, NULL, 1, 6, 0, NULL, 'both'),
    -- A dual carriageway: two lines 12 m apart, crossed by one street.
    ('carriageway east, one', 'LINESTRING(-60 240, 120 240)', 11, NULL, 3, 1, 0, NULL, 'direct'),
    ('carriageway east, two', 'LINESTRING(120 240, 420 240)', 11, NULL, 3, 1, 0, NULL, 'direct'),
    ('carriageway west, one', 'LINESTRING(420 252, 120 252)', 11, NULL, 3, 1, 0, NULL, 'direct'),
    ('carriageway west, two', 'LINESTRING(120 252, -60 252)', 11, NULL, 3, 1, 0, NULL, 'direct'),
    ('crossing street, south', 'LINESTRING(122 100, 120 240)', 9, NULL, 2, 3, 0, NULL, 'both'),
    ('crossing street, between', 'LINESTRING(120 240, 120 252)', 9, NULL, 2, 3, 0, NULL, 'both'),
    ('crossing street, north', 'LINESTRING(120 252, 121 330)', 9, NULL, 2, 3, 0, NULL, 'both'),
    -- Levels: a bridge that crosses over, and one that comes down at a shared end.
    ('bridge over the carriageways', 'LINESTRING(300 200, 300 290)', 8, NULL, 2, 3, 1, NULL, 'both'),
    ('ramp south', 'LINESTRING(300 200, 320 150, 390 160)', 8, NULL, 2, 3, 0, NULL, 'both'),
    ('ramp north', 'LINESTRING(300 290, 300 350)', 8, NULL, 2, 3, 0, NULL, 'both'),
    -- Two axes between the same nodes, and nearly parallel ones.
    ('split street, upper', 'LINESTRING(121 330, 160 345, 230 352, 300 350)', 5.5, NULL, 1, 5, 0, NULL, 'direct'),
    ('split street, lower', 'LINESTRING(300 350, 230 320, 160 318, 121 330)', 5.5, NULL, 1, 5, 0, NULL, 'direct'),
    -- An airport by settings of its classes alone.
    ('runway', 'LINESTRING(560 240, 1160 300)', NULL, NULL, NULL, NULL, 0, 'runway', 'both'),
    ('taxiway', 'LINESTRING(560 240, 600 200, 980 236, 1040 288)', NULL, NULL, NULL, NULL, 0, 'taxiway', 'both'),
    ('taxiway, stand', 'LINESTRING(800 218.94736842, 806 160)', NULL, NULL, NULL, NULL, 0, 'taxiway', 'both'))
INSERT INTO quarter.axis (name, geom, width, width_end, lane_count, importance, level, kind, direction, source, source_ref)
SELECT name, ST_Translate(ST_GeomFromText(wkt, 2154), 650000, 6860000), width, width_end, lane_count, importance, level, kind, direction, 'quarter', name FROM drawn;
-- Single lanes: three and one, a bus and a cycle lane with turns, parking, a cycle lane against the traffic.
UPDATE quarter.axis SET lanes_forward = 3, lanes_backward = 1 WHERE name = 'avenue middle';
UPDATE quarter.axis SET lane_count = 5, kind_forward = 'general|general|bus|cycle', turn_forward = 'left|through|through;right', kind_backward = 'general|general' WHERE name = 'avenue west';
UPDATE quarter.axis SET kind_forward = 'general|parking', kind_backward = 'general' WHERE name = 'cross street one, north';
UPDATE quarter.axis SET kind_forward = 'general', kind_backward = 'cycle' WHERE name = 'back street east';
-- Two lanes from 8 to 15 m are believed where they are put by hand.
UPDATE quarter.axis SET width_end = 15 WHERE name = 'widening street';
