\set ECHO none
\ir shared/truths.sql
-- Arc roads from SQL. Each test is a row (name, holds).

CREATE TEMPORARY TABLE simple AS SELECT streetgen.arc_road('LINESTRING(0 0,100 0,100 60)') AS road;
SELECT 'arc_road: straight, then a quarter circle', ST_AsText(road, 6) = 'COMPOUNDCURVE((0 0,40 0),CIRCULARSTRING(40 0,82.426407 17.573593,100 60))' FROM simple;
SELECT 'arc_road: under a cap', ST_AsText(streetgen.arc_road('LINESTRING(0 0,100 0,100 60)', 10), 3) = 'COMPOUNDCURVE((0 0,90 0),CIRCULARSTRING(90 0,97.071 2.929,100 10),(100 10,100 60))';
SELECT 'arc_road: a cap of 0 is the line', ST_AsText(streetgen.arc_road('LINESTRING(0 0,100 0,100 60)', 0)) = 'COMPOUNDCURVE((0 0,100 0,100 60))';
SELECT 'arc_road: leaves a point by the shift', abs(ST_Distance(streetgen.arc_road('LINESTRING(0 0,100 0,100 60)', shift => 0.5), 'POINT(100 0)') - 0.5) < 1e-6;
SELECT 'arc_road: a radius by hand', abs(radius - 12.5) < 1e-9 FROM streetgen.arc_road_arcs('LINESTRING(0 0,100 0,100 60)', 4000, 0.1, '{NULL,12.5,NULL}');
SELECT 'arc_road: a radius by hand makes room for the next', array_agg(round(radius::numeric, 6) ORDER BY vertex) = '{5,35}' FROM streetgen.arc_road_arcs('LINESTRING(0 0,100 0,100 40,200 40)', radii => '{NULL,5,NULL,NULL}');
SELECT 'arc_road: the same for the line backwards', bool_and(ST_DWithin(p.geom, q.geom, 1e-9)) FROM (SELECT streetgen.arc_road(l) AS there, streetgen.arc_road(ST_Reverse(l)) AS back FROM (VALUES ('LINESTRING(0 0,100 0,130 60,210 40)'::geometry)) v(l)) r,
    generate_series(0, 20) k, streetgen.arc_road_point(there, streetgen.arc_road_length(there) * k / 20) p, streetgen.arc_road_point(back, streetgen.arc_road_length(there) * (20 - k) / 20) q;
SELECT 'arc_road: points on a segment and repeated ones change nothing', ST_AsText(streetgen.arc_road('LINESTRING(0 0,30 0,30 0,100 0,100 0,100 60)'), 9) = ST_AsText(road, 9) FROM simple;
SELECT 'arc_road: two points are a straight road', ST_AsText(streetgen.arc_road('LINESTRING(0 0,9 0)')) = 'COMPOUNDCURVE((0 0,9 0))';
SELECT 'arc_road: a turn straight back stays sharp', ST_AsText(streetgen.arc_road('LINESTRING(0 0,50 0,20 0)')) = 'COMPOUNDCURVE((0 0,50 0,20 0))';
SELECT 'arc_road: a closed line keeps its seam', ST_IsClosed(r) AND ST_NumPoints(ST_CurveToLine(r)) > 4 AND ST_StartPoint(r) = 'POINT(0 0)'::geometry FROM streetgen.arc_road('LINESTRING(0 0,40 0,40 40,0 40,0 0)') r;
SELECT 'arc_road: one metre beside a kilometre', abs(radius - 1) < 1e-9 FROM streetgen.arc_road_arcs('LINESTRING(0 0,1 0,1 1000)');
SELECT 'arc_road: the SRID stays', ST_SRID(streetgen.arc_road('SRID=2154;LINESTRING(0 0,50 0,60 9)')) = 2154;
SELECT 'arc_road: PostGIS finds the same length', abs(ST_Length(road) - streetgen.arc_road_length(road)) < 1e-6 FROM simple;

SELECT 'arc_road_arcs: a row for each bend', array_agg(vertex ORDER BY vertex) = '{2,3}' AND array_agg(orientation ORDER BY vertex) = '{left,right}' FROM streetgen.arc_road_arcs('LINESTRING(0 0,100 0,100 60,200 60)');
SELECT 'arc_road_arcs: centre, angle, abscissas, directions', ST_DWithin(centre, 'POINT(40 60)', 1e-9) AND abs(angle - 90) < 1e-9 AND abs(start_abscissa - 40) < 1e-9 AND abs(end_abscissa - 40 - 30 * pi()) < 1e-9
    AND abs(start_direction[2] + 1) < 1e-12 AND normal = '{0,0,1}' FROM streetgen.arc_road_arcs('LINESTRING(0 0,100 0,100 60)');
SELECT 'arc_road_arcs: a crest is straight', orientation = 'straight' AND abs(normal[3]) < 1e-12 FROM streetgen.arc_road_arcs('LINESTRING Z(0 0 0,100 0 6,200 0 0)');
SELECT 'arc_road_arcs: a bend that stays sharp has radius 0', radius = 0 AND angle = 180 FROM streetgen.arc_road_arcs('LINESTRING(0 0,50 0,20 0)');
SELECT 'arc_road_arcs: no bend, no row', count(*) = 0 FROM streetgen.arc_road_arcs('LINESTRING(0 0,50 0,70 0)');

SELECT 'arc_road_length: in closed form', abs(streetgen.arc_road_length(road) - 40 - 30 * pi()) < 1e-9 FROM simple;
SELECT 'arc_road_length: of a line as it is', streetgen.arc_road_length('LINESTRING(0 0,3 0,3 4)') = 7;
SELECT 'arc_road_length: of arcs of PostGIS', abs(streetgen.arc_road_length('CIRCULARSTRING(0 0,5 5,10 0,15 -5,20 0)') - 10 * pi()) < 1e-9;
SELECT 'arc_road_length: of a whole circle', abs(streetgen.arc_road_length('CIRCULARSTRING(0 0,10 0,0 0)') - 10 * pi()) < 1e-9;
SELECT 'arc_road_length: in space', abs(streetgen.arc_road_length('LINESTRING Z(0 0 0,3 0 4)') - 5) < 1e-12;

SELECT 'arc_road_point: on the arc', ST_DWithin(geom, ST_Point(40 + 60 * sin(1), 60 - 60 * cos(1)), 1e-9) AND abs(heading - (90 - degrees(1))) < 1e-9 AND abs(curvature - 1 / 60.0) < 1e-12
    AND abs(steering_angle - degrees(atan(2.7 / 60))) < 1e-9 FROM simple, streetgen.arc_road_point(road, 100);
SELECT 'arc_road_point: straight', ST_Equals(geom, 'POINT(20 0)') AND heading = 90 AND curvature = 0 AND steering_angle = 0 AND forward = '{1,0,0}' AND rightward = '{0,-1,0}' AND upward = '{0,0,1}' FROM simple, streetgen.arc_road_point(road, 20);
SELECT 'arc_road_point: clamped to the road', ST_DWithin(a.geom, 'POINT(0 0)', 1e-9) AND ST_DWithin(b.geom, 'POINT(100 60)', 1e-9) FROM simple, streetgen.arc_road_point(road, -5) a, streetgen.arc_road_point(road, 1e9) b;
SELECT 'arc_road_point: right is horizontal on a crest', bool_and(rightward[3] = 0 AND abs(rightward[2] + 1) < 1e-12 AND upward[3] > 0.9) FROM streetgen.arc_road('LINESTRING Z(0 0 0,100 0 6,200 0 0)') r, generate_series(0, 200, 10) m, streetgen.arc_road_point(r, m);
SELECT 'arc_road_point: a car of another wheelbase steers more', b.steering_angle > a.steering_angle FROM simple, streetgen.arc_road_point(road, 100) a, streetgen.arc_road_point(road, 100, 6) b;

SELECT 'arc_road_locate: left is positive', metres = 20 AND axis_offset = 5 AND distance = 5 FROM simple, streetgen.arc_road_locate(road, 'POINT(20 5)');
SELECT 'arc_road_locate: beyond an end', metres = 0 AND axis_offset = 3 AND distance = 5 FROM simple, streetgen.arc_road_locate(road, 'POINT(-4 3)');
SELECT 'arc_road_distance: along the road, with a sign', abs(streetgen.arc_road_distance(road, 'POINT(10 1)', 'POINT(30 -2)') - 20) < 1e-9 AND abs(streetgen.arc_road_distance(road, 'POINT(30 -2)', 'POINT(10 1)') + 20) < 1e-9 FROM simple;

SELECT 'arc_road_offset: left bends are tighter to the left', ST_AsText(streetgen.arc_road_offset(road, 10), 6) = 'COMPOUNDCURVE((0 10,40 10),CIRCULARSTRING(40 10,75.355339 24.644661,90 60))' FROM simple;
SELECT 'arc_road_offset: a vanished arc is cut out', ST_AsText(streetgen.arc_road_offset(streetgen.arc_road('LINESTRING(0 0,100 0,100 60)', 10), 15), 6) = 'COMPOUNDCURVE((0 15,85 15,85 60))';
SELECT 'arc_road_offset: sharp bends are round outside', abs(streetgen.arc_road_length(streetgen.arc_road_offset('LINESTRING(0 0,50 0,50 50)', -4)) - 100 - 2 * pi()) < 1e-9;
SELECT 'arc_road_offset: nothing left', streetgen.arc_road_offset('CIRCULARSTRING(0 0,5 5,10 0)', -5) IS NULL;
SELECT 'arc_road_offset: in space, near', abs(distance - 3) < 0.2 FROM streetgen.arc_road('LINESTRING Z(0 0 0,100 0 6,100 60 3)') r, streetgen.arc_road_point(streetgen.arc_road_offset(r, 3), 70) p, streetgen.arc_road_locate(r, p.geom);

SELECT 'arc_road_speed_limit: equation 7', abs(streetgen.arc_road_speed_limit(30) - 51.67) < 0.01 AND abs(streetgen.arc_road_speed_limit(100, 0.7, 0.06, 0.8) - 0.8 * 3.6 * sqrt(9.81 * 100 * 0.76 / 0.958)) < 1e-9;
SELECT 'arc_road_speed_profile: pieces follow each other', count(*) = 5 AND count(speed_limit) = 2 AND bool_and(start_abscissa = coalesce(before, 0)) FROM (
    SELECT *, lag(end_abscissa) OVER (ORDER BY start_abscissa) AS before FROM streetgen.arc_road_speed_profile(streetgen.arc_road('LINESTRING(0 0,100 0,100 60,200 60)', 20))) s;

SELECT 'arc_road_line: within the tolerance', ST_HausdorffDistance(streetgen.arc_road_line(road, 0.5), ST_CurveToLine(road, 0.0001, 1)) BETWEEN 0.3 AND 0.5 FROM simple;
SELECT 'arc_road_mesh: a strip of the width', GeometryType(m) = 'TIN' AND ST_NDims(m) = 3 AND abs((SELECT sum(ST_Area(ST_MakePolygon(ST_ExteriorRing(ST_Force2D(t.geom))))) FROM ST_Dump(m) t) - 6 * streetgen.arc_road_length(road)) < 0.1
    FROM simple, streetgen.arc_road_mesh(road, 3, -3, 0.001) m;
SELECT 'arc_road_mesh: each inner edge has two triangles', count(*) FILTER (WHERE uses = 2) = t - 1 AND max(uses) = 2 FROM (SELECT count(*) AS uses, max(of_all) AS t FROM (
    SELECT least(a, b) AS a, greatest(a, b) AS b, of_all FROM (SELECT ST_AsText(ST_PointN(e, k)) AS a, ST_AsText(ST_PointN(e, k + 1)) AS b, of_all FROM generate_series(1, 3) k,
        (SELECT ST_ExteriorRing(t.geom) AS e, count(*) OVER () AS of_all FROM ST_Dump(streetgen.arc_road_mesh(streetgen.arc_road('LINESTRING(0 0,100 0,100 60)', 5), 8, -2, 0.01)) t) s) g) h GROUP BY a, b) u GROUP BY t;
SELECT 'arc_road_mesh: heights are those of the road', ST_ZMax(m) BETWEEN 5.9 AND 6 AND ST_ZMin(m) = 0 FROM streetgen.arc_road_mesh(streetgen.arc_road('LINESTRING Z(0 0 0,100 0 6,200 0 0)', 20), 3, -3) m;

-- Random lines at the coordinates of a city.
CREATE TEMPORARY TABLE random_road AS
SELECT i, geom, streetgen.arc_road(geom) AS road FROM (
    SELECT i, ST_MakeLine(ST_SetSRID(ST_Point(652000 + 40 * k + 15 * sin(7.0 * i + 3.1 * k), 6862000 + 25 * sin(1.3 * i * k)), 2154) ORDER BY k) AS geom
    FROM generate_series(1, 100) i, generate_series(0, 8) k GROUP BY i) s;
SELECT 'random: locate of point is the place', bool_and(abs(l.metres - m.at) < 1e-6 AND l.distance < 1e-8) FROM random_road, generate_series(0, 10) k, LATERAL (SELECT k / 10.0 * streetgen.arc_road_length(road)) m(at),
    streetgen.arc_road_point(road, m.at) p, streetgen.arc_road_locate(road, p.geom) l;
SELECT 'random: no jump of heading', bool_and(abs(sin(radians(b.heading - a.heading))) < greatest(1e-9, 4e-9 / least(s.end_abscissa - s.start_abscissa, s.start_abscissa - before)) + 1e-9)
    FROM random_road, LATERAL (SELECT *, lag(start_abscissa) OVER (ORDER BY start_abscissa) AS before FROM streetgen.arc_road_speed_profile(road)) s,
    streetgen.arc_road_point(road, s.start_abscissa - 1e-9) a, streetgen.arc_road_point(road, s.start_abscissa + 1e-9) b WHERE before IS NOT NULL;
SELECT 'random: rows of arcs are those of the curve', bool_and(abs(a.radius - s.radius) < 1e-5 * s.radius) FROM random_road,
    LATERAL (SELECT *, row_number() OVER () AS n FROM streetgen.arc_road_arcs(geom)) a, LATERAL (SELECT *, row_number() OVER () AS n FROM streetgen.arc_road_speed_profile(road) WHERE radius IS NOT NULL) s WHERE a.n = s.n AND a.radius > 0.1;
SELECT 'random: chords leave the road by the tolerance', max(l.distance) BETWEEN 0.005 AND 0.02 FROM random_road, LATERAL (SELECT streetgen.arc_road_line(road, 0.02)) c(line), generate_series(0, 300) k, streetgen.arc_road_locate(road, ST_LineInterpolatePoint(line, k / 300.0)) l;
SELECT 'random: a query asks one road many times', count(*) = 5000 FROM (SELECT road FROM random_road WHERE i = 1) r, generate_series(1, 5000) k, streetgen.arc_road_point(road, k / 20.0);

SELECT 'bad input is 22023: ' || statement, test.state(statement) = '22023' FROM (VALUES
    ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', 'NaN')$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', 'infinity')$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', -1)$$),
    ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', shift => -1)$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', shift => 'NaN')$$),
    ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', radii => '{1,2}')$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', radii => '{}')$$),
    ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', radii => '{0,-2,0}')$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', radii => '{0,NaN,0}')$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,50 0,60 9)', radii => '{0,4000,0}')$$),
    ($$SELECT streetgen.arc_road('LINESTRING(5 5,5 5)')$$), ($$SELECT streetgen.arc_road('LINESTRING(0 0,1e-12 0)')$$), ($$SELECT streetgen.arc_road('LINESTRING EMPTY')$$), ($$SELECT streetgen.arc_road('POINT(5 5)')$$),
    ($$SELECT streetgen.arc_road('COMPOUNDCURVE((0 0,40 0))')$$), ($$SELECT streetgen.arc_road('CIRCULARSTRING(0 0,1 1,2 0)')$$), ($$SELECT streetgen.arc_road('LINESTRING M(0 0 1,50 0 2)')$$),
    ($$SELECT streetgen.arc_road('LINESTRING Z(0 0 0,50 0 0,50 0 9)')$$), ($$SELECT streetgen.arc_road(ST_MakeLine(ST_MakePoint(0, 0), ST_MakePoint('NaN', 1)))$$), ($$SELECT streetgen.arc_road(ST_MakeLine(ST_MakePoint(0, 0), ST_MakePoint('Infinity', 1)))$$),
    ($$SELECT streetgen.arc_road_arcs('LINESTRING(0 0,50 0,60 9)', radii => '{1,2}')$$),
    ($$SELECT streetgen.arc_road_length('POINT(0 0)')$$), ($$SELECT streetgen.arc_road_length('LINESTRING EMPTY')$$), ($$SELECT streetgen.arc_road_length('COMPOUNDCURVE EMPTY')$$), ($$SELECT streetgen.arc_road_length('LINESTRING(3 3,3 3)')$$),
    ($$SELECT streetgen.arc_road_point('LINESTRING(0 0,50 0)', 'NaN')$$), ($$SELECT streetgen.arc_road_point('LINESTRING(0 0,50 0)', 1, 0)$$), ($$SELECT streetgen.arc_road_point('LINESTRING(0 0,50 0)', 1, 'NaN')$$),
    ($$SELECT streetgen.arc_road_locate('LINESTRING(0 0,50 0)', 'LINESTRING(0 0,50 0)')$$), ($$SELECT streetgen.arc_road_locate('LINESTRING(0 0,50 0)', 'POINT EMPTY')$$), ($$SELECT streetgen.arc_road_locate('LINESTRING(0 0,50 0)', 'SRID=2154;POINT(0 0)')$$),
    ($$SELECT streetgen.arc_road_locate('LINESTRING Z(0 0 0,50 0 9)', 'POINT(0 0)')$$), ($$SELECT streetgen.arc_road_distance('LINESTRING(0 0,50 0)', 'POINT(0 0)', 'POINT EMPTY')$$),
    ($$SELECT streetgen.arc_road_offset('LINESTRING(0 0,50 0)', 'NaN')$$), ($$SELECT streetgen.arc_road_offset('LINESTRING(0 0,50 0)', 201)$$),
    ($$SELECT streetgen.arc_road_speed_limit(-1)$$), ($$SELECT streetgen.arc_road_speed_limit('NaN')$$), ($$SELECT streetgen.arc_road_speed_limit(30, 3)$$), ($$SELECT streetgen.arc_road_speed_limit(30, 0.7, 1)$$), ($$SELECT streetgen.arc_road_speed_limit(30, 0.7, 0, -1)$$),
    ($$SELECT streetgen.arc_road_line('LINESTRING(0 0,50 0)', 0)$$), ($$SELECT streetgen.arc_road_line('LINESTRING(0 0,50 0)', 'NaN')$$),
    ($$SELECT streetgen.arc_road_mesh('LINESTRING(0 0,50 0)', -2, 2)$$), ($$SELECT streetgen.arc_road_mesh('LINESTRING(0 0,50 0)', 'NaN', 2)$$), ($$SELECT streetgen.arc_road_mesh('LINESTRING(0 0,50 0)', 2, -2, 0)$$)) s(statement);
SELECT 'a bend in space that is tighter than the offset is 0A000', test.state($$SELECT streetgen.arc_road_offset(streetgen.arc_road('LINESTRING Z(0 0 0,50 0 2,50 50 0)', 5), 8)$$) = '0A000';
SELECT 'an error names vertex, value and what fits', test.said($$SELECT streetgen.arc_road('LINESTRING(0 0,100 0,100 60)', radii => '{NULL,70,NULL}')$$) = 'the radius of vertex 2 is 70, but the bend has room for 60 at most';
SELECT 'a million vertices are a road', streetgen.arc_road_length(streetgen.arc_road(ST_MakeLine(ST_Point(i, i % 2 * 0.5) ORDER BY i))) BETWEEN 1e6 AND 1.2e6 FROM generate_series(0, 1000000) i;
