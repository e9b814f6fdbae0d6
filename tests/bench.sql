-- What tests/bench measures; each time is the least of three.
CREATE SCHEMA bench;
CREATE TABLE bench.taken (copies integer, what text, seconds float8);

-- Seconds that a statement takes.
CREATE FUNCTION bench.seconds(statement text) RETURNS float8 LANGUAGE plpgsql AS $$
DECLARE began timestamptz := clock_timestamp();
BEGIN
    EXECUTE statement;
    RETURN extract(epoch FROM clock_timestamp() - began);
END $$;

-- A model of so many quarters beside each other: first run, second run, one axis anew.
CREATE PROCEDURE bench.quarters(copies integer) LANGUAGE plpgsql AS $$
BEGIN
    FOR turn IN 1..3 LOOP
        PERFORM streetgen.create_model('town', 2154);
        INSERT INTO town.axis (geom, width, width_end, lane_count, importance, level, kind, direction, name)
            SELECT ST_Translate(geom, 1500 * (i % 4), 1000 * (i / 4)), width, width_end, lane_count, importance, level, kind, direction, name
            FROM quarter.axis, generate_series(0, copies - 1) i ORDER BY i, axis_id;
        INSERT INTO bench.taken VALUES (copies, 'first', bench.seconds($q$SELECT count(*) FROM streetgen.generate('town')$q$));
        COMMIT;
        ANALYZE;
        INSERT INTO bench.taken VALUES (copies, 'second', bench.seconds($q$SELECT count(*) FROM streetgen.generate('town')$q$));
        COMMIT;
        UPDATE town.axis SET width = width + 0.5 WHERE axis_id = 5;
        INSERT INTO bench.taken VALUES (copies, 'one axis', bench.seconds($q$SELECT count(*) FROM streetgen.generate('town', ARRAY[5])$q$));
        PERFORM streetgen.drop_model('town');
        COMMIT;
    END LOOP;
END $$;

-- 2,000 corners by the primitive, and as the papers' query finds them with PostGIS alone: the buffers' borders meet in the centre.
CREATE PROCEDURE bench.corners() LANGUAGE plpgsql AS $$
BEGIN
    CREATE TEMPORARY TABLE pair AS
    SELECT ST_MakeLine(ARRAY[ST_Point(0, 0), ST_Point(40, i % 7), ST_Point(80, i % 5)]) AS a,
           ST_MakeLine(ARRAY[ST_Point(0, 0), ST_Point(i % 30, 40), ST_Point(i % 20, 80)]) AS b, 6 + i % 5 AS width_a, 6 + i % 3 AS width_b, 3 + i % 4 AS radius
    FROM generate_series(1, 2000) i;
    FOR turn IN 1..3 LOOP
        INSERT INTO bench.taken VALUES
            (0, 'primitive', bench.seconds('SELECT count(streetgen.arc_centre(a, b, width_a, width_b, radius)) FROM pair')),
            (0, 'buffers', bench.seconds('SELECT count(centre) FROM pair CROSS JOIN LATERAL (
                SELECT d.geom AS centre FROM ST_Dump(ST_Intersection(ST_Boundary(ST_Buffer(a, width_a / 2.0 + radius, 16)), ST_Boundary(ST_Buffer(b, width_b / 2.0 + radius, 16)))) d
                ORDER BY ST_Distance(d.geom, ST_Point(10, 10)) LIMIT 1) c'));
    END LOOP;
END $$;

CREATE VIEW bench.ratio AS
WITH best AS (SELECT copies, what, min(seconds) AS seconds FROM bench.taken GROUP BY copies, what)
SELECT format('generate, seconds an axis: %s quarters against %s', t.copies, o.copies) AS measure, t.seconds / t.copies / (o.seconds / o.copies) AS ratio, t.copies AS place
FROM best t JOIN best o ON t.what = 'first' AND o.what = 'first' AND o.copies = (SELECT min(copies) FROM best WHERE what = 'first') AND t.copies > o.copies
UNION ALL SELECT format('second run against first, %s quarters', s.copies), s.seconds / f.seconds, 1000 + s.copies FROM best s JOIN best f USING (copies) WHERE s.what = 'second' AND f.what = 'first'
UNION ALL SELECT format('one axis of %s quarters against all', o.copies), o.seconds / f.seconds, 2000 + o.copies FROM best o JOIN best f USING (copies) WHERE o.what = 'one axis' AND f.what = 'first'
UNION ALL SELECT 'corner: arc_centre against PostGIS buffers', p.seconds / b.seconds, 3000 FROM best p, best b WHERE p.what = 'primitive' AND b.what = 'buffers'
ORDER BY place;
