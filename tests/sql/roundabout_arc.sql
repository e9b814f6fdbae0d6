\set ECHO none
\ir shared/truths.sql
-- Arcs in lines, and candidates by the method of the paper.
CREATE TEMP TABLE ring AS SELECT ST_ExteriorRing(ST_Buffer('SRID=2154;POINT(650000 6860000)'::geometry, 15, 8)) AS geom;
SELECT 'a ring is one arc about its centre', count(*) = 1 AND bool_and(ST_DWithin(centre, 'SRID=2154;POINT(650000 6860000)', 1e-6)
    AND abs(radius - 15) < 1e-6 AND support = 32 AND GeometryType(arc) = 'CIRCULARSTRING' AND ST_IsClosed(arc))
    FROM ring, streetgen.detect_arcs(geom, tolerance => 0.5) d;
SELECT 'an arc keeps the SRID', bool_and(ST_SRID(arc) = 2154 AND ST_SRID(centre) = 2154) FROM ring, streetgen.detect_arcs(geom) d;
SELECT 'corners of blocks are no arcs', NOT EXISTS (SELECT FROM streetgen.detect_arcs('LINESTRING(0 0,40 0,40 40,0 40,0 0)'));
SELECT 'a radius beyond the bounds is none', NOT EXISTS (SELECT FROM ring, streetgen.detect_arcs(geom, 20, 80, 0.5));
SELECT 'bad input is 22023: ' || statement, test.state(statement) = '22023' FROM (VALUES
    ($$SELECT * FROM streetgen.detect_arcs('POINT(0 0)')$$),
    ($$SELECT * FROM streetgen.detect_arcs('LINESTRING(0 0,1 0)', 'NaN')$$),
    ($$SELECT * FROM streetgen.detect_arcs('LINESTRING(0 0,1 0)', 3, 2)$$),
    ($$SELECT * FROM streetgen.detect_arcs('LINESTRING(0 0,1 0)', tolerance => 0)$$),
    ($$SELECT * FROM streetgen.detect_arcs('LINESTRING(0 0,1 0)', turn_least => 361)$$)) v(statement);
SELECT 'NULL has no arc', NOT EXISTS (SELECT FROM streetgen.detect_arcs(NULL));

SELECT streetgen.create_model('town', 2154, driving_side => 'right') \gset
INSERT INTO town.axis (geom) SELECT ST_Translate(geom, x, 0) FROM ring, unnest(ARRAY[0, 300]) x;
INSERT INTO town.axis (geom) SELECT ST_Translate(ST_Scale(ST_Translate(geom, -650000, -6860000), 2, 2), 650000, 6860000) FROM ring;
INSERT INTO town.axis (geom) VALUES ('SRID=2154;LINESTRING(650015 6860000,650100 6860000,650100 6860100)');
SELECT 'each ring is a candidate, rings about one centre are two', count(*) = 3 AND bool_and(radius BETWEEN 14.9 AND 30.1)
    FROM streetgen.roundabout_candidates('town');
SELECT 'the best supported is the first', count(*) FILTER (WHERE number = 1) = 1 AND min(support) > 3 FROM streetgen.roundabout_candidates('town');
SELECT 'more circles are asked for than there are', NOT EXISTS (SELECT FROM streetgen.roundabout_candidates('town', "least" => 1000));
SELECT 'candidates come in one order', array_agg(c ORDER BY c.number) = (SELECT array_agg(d ORDER BY d.number) FROM streetgen.roundabout_candidates('town') d)
    FROM streetgen.roundabout_candidates('town') c;
SELECT 'bad bounds are 22023: ' || statement, test.state(statement) = '22023' FROM (VALUES
    ($$SELECT * FROM streetgen.roundabout_candidates('town', 0)$$), ($$SELECT * FROM streetgen.roundabout_candidates('town', 'NaN')$$),
    ($$SELECT * FROM streetgen.roundabout_candidates('town', "least" => 0)$$)) v(statement);
SELECT 'an unknown model is 3F000', test.state($$SELECT * FROM streetgen.roundabout_candidates('nowhere')$$) = '3F000';
