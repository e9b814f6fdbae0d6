\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Sidewalks: strips behind kerbs, live and by hand.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{sidewalk}');
  INSERT INTO town.axis (axis_id, geom, width, radius, sidewalk_left, sidewalk_right, importance) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 5, 2, 3, 4), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 5, 2, 3, 4),
    (3, pg_temp.line('LINESTRING(100 0,100 -90)'), 6, 5, NULL, 4, 4);
END $$;
SELECT 'a subject brings what it needs', streetgen._subjects('town') @> '{network,surface,kerb,sidewalk}';
SELECT 'every kerb of a width has a sidewalk', count(*) = 6 FROM town.sidewalk WHERE node_id IS NULL AND side IN ('left', 'right');
SELECT 'it is as wide as its axis says', bool_and(s.width = CASE s.side WHEN 'left' THEN e.sidewalk_left ELSE e.sidewalk_right END) FROM town.sidewalk s JOIN town.edge e USING (edge_id) WHERE s.side IN ('left', 'right');
SELECT 'what the axis lacks is estimated and said', sidewalk_left = 2 AND 'sidewalk_left' = ANY (estimated) AND 'sidewalk_right' <> ALL (estimated) FROM town.edge WHERE axis_id = 3;
SELECT 'the middle of a long straight sidewalk is its width', bool_and(abs(ST_Area(ST_Intersection(surface, ST_Expand(ST_Translate(ST_SetSRID(ST_MakePoint(50, 0), 2154), 650000, 6860000), 10))) / 20 - s.width) < 0.01)
  FROM town.sidewalk s JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND side IN ('left', 'right');
SELECT 'sidewalks lie on their kerbs', NOT EXISTS (SELECT FROM town.sidewalk s WHERE NOT EXISTS (SELECT FROM town.kerb k WHERE (k.edge_id, k.side, k.part) = (s.edge_id, s.side, s.part) AND ST_Distance(k.geom, s.surface) < 0.001));
SELECT 'none lies on a roadway', sum(ST_Area(ST_Intersection(s.surface, r.surface))) < 1e-4 FROM town.sidewalk s JOIN town.roadway r ON ST_Intersects(s.surface, r.surface);
SELECT 'none lies on another', coalesce(sum(ST_Area(ST_Intersection(a.surface, b.surface))), 0) < 1e-4 FROM town.sidewalk a JOIN town.sidewalk b ON a.sidewalk_id < b.sidewalk_id AND ST_Intersects(a.surface, b.surface);
SELECT 'a sidewalk leads around a corner from one width to the other', abs(s.width - (3 + 4) / 2.0) < 1e-9 FROM town.sidewalk s JOIN town.edge e USING (edge_id) WHERE s.side LIKE 'corner%' AND axis_id = 1;
SELECT 'nothing is wrong with them', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');

-- A street that is slanted by millimetres: kerbs of its corners have pieces as short before and behind their arcs.
DO $$ BEGIN
  PERFORM streetgen.create_model('slanted', 2154, subjects => '{sidewalk}');
  INSERT INTO slanted.axis (geom, width, sidewalk_left, sidewalk_right) VALUES
    (pg_temp.line('LINESTRING(0 0,100 0.01,200 0.02)'), 10, 2.5, 2.5),
    (pg_temp.line('LINESTRING(100 -100,100 0.01)'), 6, 0, 0), (pg_temp.line('LINESTRING(100 0.01,100 100)'), 6, 5, 5);
END $$;
SELECT 'each of the four corners of a street slanted by millimetres has a sidewalk', count(*) = 4
FROM slanted.sidewalk s JOIN slanted.kerb k USING (edge_id, side, part)
WHERE s.node_id IS NOT NULL AND ST_Length(k.geom) > 10 AND ST_Area(s.surface) > 10;

-- Drives that meet streets from opposite sides, so near to each other that no section lies between them.
DO $$ BEGIN
  PERFORM streetgen.create_model('drives', 2154, subjects => '{sidewalk}');
  INSERT INTO drives.axis (geom, width, radius, sidewalk_left, sidewalk_right, kind)
  SELECT ST_Translate(pg_temp.line(replace(l, '50+', (50 + 2 * n)::text)), 200 * n, 200 * road), coalesce(w, road),
    r, s, s, k
  FROM generate_series(1, 10) n, unnest(ARRAY[7, 14]) road, (VALUES
    ('LINESTRING(0 0,50 0,50+ 0,120 0)', NULL, 6, 3, 'residential'),
    ('LINESTRING(50 0,50 40)', 4, 3, 0, 'service'), ('LINESTRING(50+ 0,50+ -40)', 4, 3, 0, 'service')) v(l, w, r, s, k);
END $$;
SELECT 'the kerb across the street from a drive has a sidewalk, wherever the next drive is',
    count(*) = 40 AND count(*) FILTER (WHERE s.width = 3) = 40
FROM drives.corner c
    JOIN drives.kerb k ON (k.edge_id, k.node_id, k.side) = (c.edge_a, c.node_id, 'corner_at_' || c.end_a)
    LEFT JOIN drives.sidewalk s USING (edge_id, side, part)
WHERE c.method = 'no_arc';

-- What they leave of blocks.
DO $$ BEGIN
  PERFORM streetgen.create_model('quad', 2154, subjects => '{sidewalk,block}');
  INSERT INTO quad.axis (geom, width, radius, sidewalk_left, sidewalk_right) SELECT pg_temp.line(l), 8, 5, 2, 3 FROM unnest(ARRAY['LINESTRING(0 0,100 0)', 'LINESTRING(100 0,100 60)', 'LINESTRING(100 60,0 60)', 'LINESTRING(0 60,0 0)', 'LINESTRING(40 0,40 25)']) l;
END $$;
SELECT 'sidewalks of the left sides lie on the block, the others on none', count(b.block_id) FILTER (WHERE s.side = 'left') = 6 AND count(b.block_id) FILTER (WHERE s.side = 'right' AND axis_id <> 5) = 0 FROM quad.sidewalk s JOIN quad.sidewalk_block b USING (sidewalk_id) JOIN quad.edge USING (edge_id);
SELECT 'the interior of a block is its ground less its sidewalks', count(*) = 1 AND bool_and(abs(ST_Area(b.surface) - ST_Area(i.geom) - w.area) < 1e-6) FROM quad.block b JOIN quad.block_interior i USING (block_id)
  JOIN (SELECT block_id, sum(ST_Area(surface)) AS area FROM quad.sidewalk JOIN quad.sidewalk_block USING (sidewalk_id) GROUP BY 1) w USING (block_id);

-- A wide street reaches over a narrow one beside it: its kerb there lies in a block that its edge is not about.
DO $$ BEGIN
  PERFORM streetgen.create_model('over', 2154, subjects => '{sidewalk,block}');
  INSERT INTO over.axis (axis_id, geom, width, radius, sidewalk_left, sidewalk_right) SELECT n, pg_temp.line(l), w, 2, 2, 2
  FROM (VALUES (1, 'LINESTRING(0 0,100 0)', 24), (2, 'LINESTRING(0 6,100 6)', 4), (3, 'LINESTRING(0 0,0 6)', 4), (4, 'LINESTRING(100 0,100 6)', 4),
    (5, 'LINESTRING(0 6,0 60)', 4), (6, 'LINESTRING(100 6,100 60)', 4), (7, 'LINESTRING(0 60,100 60)', 4)) v(n, l, w);
END $$;
CREATE TEMP VIEW over_block AS SELECT b.* FROM over.sidewalk s JOIN over.kerb k USING (edge_id, side, part) JOIN over.edge e USING (edge_id) LEFT JOIN over.sidewalk_block b USING (sidewalk_id)
  WHERE e.axis_id = 1 AND s.side = 'left' AND ST_Length(k.geom) > 20;
SELECT 'its sidewalk belongs to the block that it lies in', count(*) = 1 AND bool_and(ST_Area(b.surface) > 3000 AND ST_Contains(ST_Buffer(b.surface, 1e-6), s.surface))
  FROM over_block JOIN over.sidewalk s USING (sidewalk_id) JOIN over.block b USING (block_id);
SELECT 'the edge of the kerb is not about that block', count(*) = 0 FROM over_block JOIN over.block_edge USING (block_id) JOIN over.edge USING (edge_id) WHERE axis_id = 1;
DELETE FROM over.axis WHERE axis_id = 7;
SELECT 'where no block lies there it belongs to none', count(*) = 1 AND bool_and(block_id IS NULL) FROM over_block;

-- The sidewalk of a corner has the level of its node, whatever the level of its edge.
DO $$ BEGIN
  PERFORM streetgen.create_model('ramp', 2154, subjects => '{sidewalk,block}');
  INSERT INTO ramp.axis (axis_id, geom, width, level, sidewalk_left, sidewalk_right) SELECT n, pg_temp.line(l), 8, level, 2, 2
  FROM (VALUES (1, 'LINESTRING(0 0,30 0)', 1), (2, 'LINESTRING(0 9,24 9)', 1), (3, 'LINESTRING(24 9,100 40)', 0),
    (4, 'LINESTRING(-50 -50,150 -50,150 100,-50 100,-50 -50)', 0)) v(n, l, level);
END $$;
CREATE TEMP VIEW lowered AS SELECT s.* FROM ramp.sidewalk s JOIN ramp.kerb k USING (edge_id, side, part) JOIN ramp.edge e USING (edge_id) WHERE k.level = 0 AND e.level = 1;
SELECT 'a corner on the ground, of an edge above it, lies on a block', count(*) > 0 AND count(b.block_id) = count(*) FROM lowered LEFT JOIN ramp.sidewalk_block b USING (sidewalk_id);
SELECT 'and takes ground of it', bool_and(NOT ST_Intersects(i.geom, ST_PointOnSurface(l.surface))) FROM lowered l, ramp.block_interior i;
SELECT 'a picture shows it below the streets', regexp_count(substring(drawing, 'class="sidewalk[^>]*>((?:\s*<path [^>]*>)*).*class="section'), '<path') = (SELECT count(*) FROM ramp.sidewalk JOIN ramp.kerb USING (edge_id, side, part) WHERE level = 0) FROM streetgen.svg('ramp') drawing;

-- The island of a roundabout that the source names. Ring 1 runs with the traffic, counter-clockwise, ring 2 against it; 3 is a loop.
DO $$ BEGIN
  PERFORM streetgen.create_model('rings', 2154, subjects => '{sidewalk}');
  INSERT INTO rings.axis (axis_id, geom, width, direction, roundabout_tag)
    SELECT i, pg_temp.line(CASE i WHEN 2 THEN 'LINESTRING(425 0,400 -25,375 0,400 25,425 0)' ELSE format('LINESTRING(%1$s 0,%2$s -25,%3$s 0,%2$s 25,%1$s 0)', 200 * i - 25, 200 * i, 200 * i + 25) END), 6,
      CASE i WHEN 2 THEN 'reverse' ELSE 'direct' END, CASE WHEN i < 3 THEN 'roundabout' END FROM generate_series(1, 3) i;
END $$;
CREATE FUNCTION pg_temp.sides(axis bigint) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(DISTINCT side, ' ' ORDER BY side) FROM rings.sidewalk JOIN rings.edge USING (edge_id) WHERE axis_id = axis AND side IN ('left', 'right') $$;
SELECT 'the island of a roundabout has no sidewalk', (pg_temp.sides(1), pg_temp.sides(2), pg_temp.sides(3)) = ('right', 'left', 'left right');
UPDATE rings.axis SET sidewalk_left = 1.5 WHERE axis_id = 1;
SELECT 'but where its axis says so', pg_temp.sides(1) = 'left right';
UPDATE rings.axis SET roundabout_tag = NULL WHERE axis_id = 2;
SELECT 'a loop that is called a roundabout no more has one', pg_temp.sides(2) = 'left right';
SELECT FROM streetgen.set('rings', 'driving_side', 'left'), streetgen.generate('rings', wait => true);
UPDATE rings.axis SET sidewalk_left = NULL, roundabout_tag = 'circular' WHERE axis_id = 3;
SELECT 'the island lies within the ring, whichever side traffic keeps to', pg_temp.sides(3) = 'right';

-- Two carriageways of one street, parted by a median: axes 1 and 2 far, 3 and 4 within 20 m.
DO $$ BEGIN
  PERFORM streetgen.create_model('dual', 2154, subjects => '{sidewalk,interconnection}'), streetgen.create_model('anew', 2154, subjects => '{sidewalk,interconnection}');
  INSERT INTO dual.axis (axis_id, geom, width, direction, importance, name) VALUES
    (1, pg_temp.line('LINESTRING(0 0,200 0)'), 7, 'direct', 4, 'Ring'), (2, pg_temp.line('LINESTRING(0 40,200 40)'), 7, 'reverse', 4, 'ring'),
    (3, pg_temp.line('LINESTRING(0 200,200 200)'), 7, 'direct', 4, 'Quay'), (4, pg_temp.line('LINESTRING(0 215,200 215)'), 7, 'reverse', 4, 'quay'),
    (5, pg_temp.line('LINESTRING(0 300,200 300)'), 7, 'direct', 4, 'North bank'), (6, pg_temp.line('LINESTRING(0 315,200 315)'), 7, 'reverse', 4, 'South bank');
END $$;
CREATE FUNCTION pg_temp.walks(axes bigint[]) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(format('%s%s', axis_id, left(side, 1)), ' ' ORDER BY axis_id, side) FROM dual.sidewalk JOIN dual.edge USING (edge_id) WHERE axis_id = ANY (axes) AND side IN ('left', 'right') $$;
SELECT 'no sidewalk is estimated on a median', pg_temp.walks('{3,4}') = '3r 4l';
SELECT 'kerbs there say so', bool_and(k.beside = CASE WHEN (axis_id, side) IN ((3, 'left'), (4, 'right')) THEN 'median' ELSE 'outer' END) AND count(*) = 12 FROM dual.kerb k JOIN dual.edge USING (edge_id) WHERE side IN ('left', 'right');
SELECT 'and so do edges, whose widths are those that hold', (SELECT (sidewalk_left, beside_left, beside_right) = (0, 'median', 'outer') AND sidewalk_right > 0 FROM dual.edge WHERE axis_id = 3);
INSERT INTO dual.sidewalk_override (axis_id, abscissa, side, width) VALUES (3, 5, 'right', 2);
SELECT 'a width by hand is no estimate', sidewalk_right = 2 AND 'sidewalk_right' <> ALL (estimated) AND 'sidewalk_left' = ANY (estimated) FROM dual.edge WHERE axis_id = 3;
DELETE FROM dual.sidewalk_override;
SELECT 'taken back it is one again', 'sidewalk_right' = ANY (estimated) FROM dual.edge WHERE axis_id = 3;
SELECT 'ground between streets of two names is none, nor is wide ground', pg_temp.walks('{1,2,5,6}') = '1l 1r 2l 2r 5l 5r 6l 6r';
UPDATE dual.axis SET geom = ST_Translate(geom, 0, -25) WHERE axis_id = 2;
SELECT 'a carriageway that comes near takes the sidewalk off the other', pg_temp.walks('{1,2}') = '1r 2l' AND test.followed('dual', 'anew');
UPDATE dual.axis SET geom = pg_temp.line('LINESTRING(50 215,150 215)') WHERE axis_id = 4;
SELECT 'a median along a part of a street takes the sidewalk off that part', test.followed('dual', 'anew') AND string_agg(format('%s %s %s', part, k.beside, coalesce(trunc(ST_Area(s.surface) / nullif(s.width, 0)), 0)), ', ' ORDER BY part) = '1 outer 50, 2 median 0, 3 outer 50'
  FROM dual.kerb k JOIN dual.edge e USING (edge_id) LEFT JOIN dual.sidewalk s USING (edge_id, side, part) WHERE axis_id = 3 AND side = 'left';
SELECT 'the edge says where', (SELECT median_left = '{50,150}' AND sidewalk_left > 0 FROM dual.edge WHERE axis_id = 3);
UPDATE dual.axis SET geom = pg_temp.line('LINESTRING(0 215,200 215)') WHERE axis_id = 4;
SELECT 'and off all of it, where it lies along all', pg_temp.walks('{3}') = '3r' AND (SELECT median_left = '{}' AND sidewalk_left = 0 FROM dual.edge WHERE axis_id = 3) AND test.followed('dual', 'anew');
UPDATE dual.axis SET name = 'South Bank' WHERE axis_id = 5;
SELECT 'and so does a name', pg_temp.walks('{5,6}') = '5r 6l' AND test.followed('dual', 'anew');
UPDATE dual.axis SET sidewalk_left = 1 WHERE axis_id = 3;
SELECT 'what an axis says holds', pg_temp.walks('{3,4}') = '3l 3r 4l' AND test.followed('dual', 'anew');
SELECT 'and is told', array_agg(relation) = '{sidewalk}' AND bool_and(severity = 'notice' AND abs(measure - 200) < 1) FROM streetgen.check_model('dual') WHERE rule = 'sidewalk beside a kerb of a median, splitter or island, m2';
UPDATE dual.axis SET direction = 'both' WHERE axis_id = 4;
SELECT 'a street of both directions is no carriageway of another', pg_temp.walks('{4}') = '4l 4r' AND (SELECT beside_left = 'outer' FROM dual.edge WHERE axis_id = 3) AND test.followed('dual', 'anew');
DELETE FROM dual.axis WHERE axis_id = 2;
SELECT 'nor is one that is gone', pg_temp.walks('{1}') = '1l 1r' AND test.followed('dual', 'anew');

-- Sidewalks about the corners of a median, which a link between the carriageways ends. The link runs north, and a sidewalk on its left lies on the median in the west.
DO $$ BEGIN
  PERFORM streetgen.create_model('avenue', 2154, subjects => '{sidewalk}');
  INSERT INTO avenue.axis (axis_id, geom, width, direction, importance, name) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 7, 'direct', 4, 'Quay'), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 7, 'direct', 4, 'Quay'),
    (3, pg_temp.line('LINESTRING(200 15,100 15)'), 7, 'direct', 4, 'Quay'), (4, pg_temp.line('LINESTRING(100 15,0 15)'), 7, 'direct', 4, 'Quay'),
    (5, pg_temp.line('LINESTRING(100 0,100 15)'), 6, 'both', 4, 'Link');
END $$;
CREATE FUNCTION pg_temp.on_median() RETURNS text LANGUAGE sql AS $$ SELECT concat(count(*) FILTER (WHERE s.node_id IS NULL), ' ', count(*) FILTER (WHERE s.node_id IS NOT NULL))
  FROM avenue.sidewalk s JOIN avenue.kerb USING (edge_id, side, part) WHERE beside <> 'outer' $$;
SELECT 'no sidewalk lies on the median', pg_temp.on_median() = '0 0';
UPDATE avenue.axis SET sidewalk_left = 2 WHERE axis_id = 5;
SELECT 'one that is stated leads on to none', pg_temp.on_median() = '1 0';
UPDATE avenue.axis SET sidewalk_left = 2 WHERE axis_id = 1;
SELECT 'but about a corner with one on both sides', pg_temp.on_median() = '2 1';

-- Without kerbs too.
SELECT streetgen.create_model('bare', 2154) \g /dev/null
INSERT INTO bare.axis (axis_id, geom, width, direction) VALUES (1, pg_temp.line('LINESTRING(0 0,200 0)'), 7, 'direct');
INSERT INTO bare.axis (axis_id, geom, width, direction) VALUES (2, pg_temp.line('LINESTRING(0 15,200 15)'), 7, 'reverse');
SELECT 'an edge that stays learns of a carriageway that came', beside_left = 'median' FROM bare.edge WHERE axis_id = 1;

-- Edits: as from scratch, and no row without need.
CREATE FUNCTION pg_temp.sidewalks(model name) RETURNS SETOF text LANGUAGE plpgsql AS $$ BEGIN
  RETURN QUERY EXECUTE format('SELECT concat_ws('' '', axis_id, round(start_abscissa::numeric, 3), side, part, s.width, method, ST_AsText(ST_Normalize(ST_SnapToGrid(surface, 0.0001)))) FROM %1$I.sidewalk s JOIN %1$I.edge USING (edge_id)', model);
END $$;
CREATE FUNCTION pg_temp.follows(statement text) RETURNS TABLE(name text, holds boolean) LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE statement;
  PERFORM streetgen.create_model('scratch', 2154, subjects => '{sidewalk}');
  INSERT INTO scratch.sidewalk_override SELECT * FROM town.sidewalk_override;
  INSERT INTO scratch.axis SELECT * FROM town.axis;
  RETURN QUERY SELECT 'edges as from scratch: ' || statement, count(*) > 0 AND bool_and((e.sidewalk_left, e.sidewalk_right) = (s.sidewalk_left, s.sidewalk_right))
    FROM town.edge e FULL JOIN scratch.edge s ON e.axis_id = s.axis_id AND abs(e.start_abscissa - s.start_abscissa) < 1e-6;
  RETURN QUERY SELECT 'as from scratch: ' || statement, NOT EXISTS ((SELECT pg_temp.sidewalks('town') EXCEPT SELECT pg_temp.sidewalks('scratch')) UNION ALL (SELECT pg_temp.sidewalks('scratch') EXCEPT SELECT pg_temp.sidewalks('town')))
    AND (SELECT count(*) > 0 FROM town.sidewalk);
  PERFORM streetgen.drop_model('scratch');
END $$;
SELECT * FROM pg_temp.follows('UPDATE town.axis SET sidewalk_left = 5 WHERE axis_id = 1');
SELECT * FROM pg_temp.follows('UPDATE town.axis SET sidewalk_right = 0 WHERE axis_id = 2');
SELECT * FROM pg_temp.follows($$INSERT INTO town.axis (axis_id, geom, width, sidewalk_left, sidewalk_right) VALUES (4, pg_temp.line('LINESTRING(0 -14,96 -12)'), 6, 3, 3)$$);
SELECT * FROM pg_temp.follows($$INSERT INTO town.axis (axis_id, geom, width, level) VALUES (5, pg_temp.line('LINESTRING(150 -60,150 60)'), 7, 1)$$);
SELECT * FROM pg_temp.follows($$UPDATE town.axis SET geom = pg_temp.line('LINESTRING(0 -11,96 -10)') WHERE axis_id = 4$$);
SELECT * FROM pg_temp.follows('UPDATE town.axis SET geom = ST_Reverse(geom), sidewalk_left = sidewalk_right, sidewalk_right = sidewalk_left WHERE axis_id = 1');
SELECT * FROM pg_temp.follows('DELETE FROM town.axis WHERE axis_id = 3');
SELECT 'two of a narrow block share it', count(*) > 0 FROM town.sidewalk WHERE method = 'contested';
SELECT 'a run over nothing changed writes no row', inserted + updated + deleted = 0 AND unchanged > 0 FROM streetgen.generate('town') WHERE relation = 'sidewalk';
SELECT 'a part over nothing changed writes no row', inserted + updated + deleted = 0 FROM streetgen.generate('town', '{2}') WHERE relation = 'sidewalk';

-- By hand.
UPDATE town.sidewalk_editing SET width = 1.25 WHERE sidewalk_id = (SELECT sidewalk_id FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'left');
SELECT 'a width typed holds', (s.width, s.method) = (1.25, 'by_hand') FROM town.sidewalk s JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'left';
SELECT 'so does that of the edge', (sidewalk_left, sidewalk_right) = (1.25, 0) FROM town.edge WHERE axis_id = 2;
SELECT 'the view says so', by_hand FROM town.sidewalk_editing JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'left';
SELECT * FROM pg_temp.follows('UPDATE town.sidewalk_override SET width = 1.5');
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 2;
SELECT 'it keeps its place when the axis is turned', (SELECT side = 'right' FROM town.sidewalk_override) AND (SELECT method = 'by_hand' FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'right');
UPDATE town.sidewalk_override SET width = 0;
SELECT 'a width of 0 takes it away', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'right');
DELETE FROM town.sidewalk_override;
SELECT 'taken back it is as before', method <> 'by_hand' FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'right';
INSERT INTO town.sidewalk_override (axis_id, abscissa, side, width) VALUES (77, 5, 'left', 2);
SELECT 'an override on no edge is told', count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'sidewalk override without its edge';
DELETE FROM town.sidewalk_override;

-- Kinds that have none.
UPDATE town.axis SET kind = 'motorway', sidewalk_left = NULL, sidewalk_right = NULL WHERE axis_id = 2;
SELECT 'a motorway has none', NOT EXISTS (SELECT FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND node_id IS NULL AND side IN ('left', 'right'));
UPDATE town.axis SET sidewalk_left = 2 WHERE axis_id = 2;
SELECT 'unless it says so', count(*) = 1 FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'left';
UPDATE town.axis SET kind = 'Bretelle' WHERE axis_id = 2;
SELECT 'nor has a ramp of BD TOPO but where it says so', count(*) FILTER (WHERE side = 'left') = 1 AND count(*) FILTER (WHERE side = 'right') = 0 FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND node_id IS NULL;
SELECT 'motorways of BD TOPO and their links have none', count(*) FILTER (WHERE walked_along) = 1 AND bool_and(walked_along = (class = 'Route à 1 chaussée')) AND count(*) = 5
  FROM town.axis_class WHERE class IN ('Autoroute', 'Quasi-autoroute', 'Type autoroutier', 'Bretelle', 'Route à 1 chaussée');
UPDATE town.axis SET sidewalk_left = NULL, sidewalk_right = NULL WHERE axis_id = 2;
UPDATE town.axis_class SET walked_along = true WHERE class = 'Bretelle';
SELECT 'a class that means something else is computed anew', count(*) > 0 FROM streetgen.generate('town');
SELECT 'one that people walk along has sidewalks', count(*) > 0 FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND node_id IS NULL AND side IN ('left', 'right');
UPDATE town.axis SET sidewalk_left = 50, sidewalk_right = 50;
SELECT 'sidewalks wider than their blocks are what the roadways leave', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error')
  AND (SELECT coalesce(sum(ST_Area(ST_Intersection(s.surface, r.surface))), 0) < 1e-3 FROM town.sidewalk s JOIN town.roadway r ON ST_Intersects(s.surface, r.surface) AND r.level = 0 JOIN town.edge e ON e.edge_id = s.edge_id AND e.level = 0);

-- The node at the far end of the axis is known by this axis alone: turned, the axis has another node there.
DO $$ BEGIN
  PERFORM streetgen.create_model('turned', 2154, subjects => '{sidewalk}');
  INSERT INTO turned.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0,120 0)'), 14), (2, pg_temp.line('LINESTRING(120 0,260 6)'), 14), (4, pg_temp.line('LINESTRING(120 0,118 -90)'), 8),
    (5, pg_temp.line('LINESTRING(120 0,122 100)'), 8), (8, pg_temp.line('LINESTRING(122 100,190 102)'), 5.5), (48, pg_temp.line('LINESTRING(122 100,120 240)'), 9);
  CREATE TABLE before_turn AS SELECT ST_Union(surface) AS surface, count(*) AS many FROM turned.sidewalk;
  UPDATE turned.axis SET geom = ST_Reverse(geom) WHERE axis_id = 5;
END $$;
SELECT 'a turned axis between two crosses keeps its sidewalks', (SELECT count(*) FROM turned.sidewalk) = many AND ST_HausdorffDistance((SELECT ST_Union(s.surface) FROM turned.sidewalk s), surface) < 1e-6 FROM before_turn;

-- Bad input.
SELECT 'refused: ' || said, test.state(format('UPDATE town.axis SET sidewalk_left = %s WHERE axis_id = 1', said)) = '23514' FROM unnest('{''NaN'',-1,100,''Infinity''}'::text[]) said;
SELECT 'refused by hand: ' || said, test.state(format('UPDATE town.sidewalk_editing SET width = %s WHERE side = ''left''', said)) = '22023' FROM unnest('{''NaN'',-1,100}'::text[]) said;
SELECT 'no sidewalk is drawn', test.state('INSERT INTO town.sidewalk_editing (width) VALUES (2)') = '0A000';
SELECT 'a setting is refused: ' || said, test.state(format('SELECT streetgen.set(''town'', ''sidewalk_by_importance'', %L)', said)) = '22023' FROM unnest(ARRAY['{"1": -1}', '{"1": 51}', '{"one": 2}', '3']) said;

-- A table of widths.
CREATE TABLE survey (arc text, odd float8, even float8);
INSERT INTO town.axis (axis_id, geom, width, source, source_ref) SELECT 100 + n, pg_temp.line(format('LINESTRING(1000 %s,1200 %s)', 100 * n, 100 * n)), 8, 'survey', 's' || n FROM generate_series(1, 6) n;
INSERT INTO survey VALUES ('s1', 1.5, 2.5), ('s2', 0, 3), ('s3', 160, 2), ('s4', 0.2, NULL), ('nowhere', 1, 1), ('s5', 'NaN', 2);
CREATE TABLE told AS SELECT * FROM streetgen.import_sidewalk_widths('town', 'survey', '{"source_ref": "arc", "odd": "odd", "even": "even"}');
SELECT 'odd numbers stand on the left', (sidewalk_left, sidewalk_right) = (1.5, 2.5) FROM town.axis WHERE source_ref = 's1';
SELECT 'zero is no sidewalk', (sidewalk_left, sidewalk_right) = (0, 3) FROM town.axis WHERE source_ref = 's2';
SELECT 'every width is taken or told', (SELECT sum(count) FROM told) = 11 AND (SELECT array_agg(what || ': ' || array_to_string(source_refs, ',') ORDER BY what, class) FROM told WHERE source_refs IS NOT NULL) =
  '{"narrower than sidewalk_width_minimal, left out: s4","no axis of this source_ref, left out: nowhere","no axis of this source_ref, left out: nowhere","no width, left out: s5","wider than sidewalk_width_maximal, left out: s3"}';
DO $$ BEGIN PERFORM FROM streetgen.import_sidewalk_widths('town', 'survey', '{"source_ref": "arc", "odd": "odd", "even": "even", "odd_side": "right"}'); END $$;
SELECT 'or on the right', (sidewalk_left, sidewalk_right) = (2.5, 1.5) FROM town.axis WHERE source_ref = 's1';
SELECT 'a mapping is checked: ' || mapping, test.state(format('SELECT streetgen.import_sidewalk_widths(''town'', ''survey'', %L)', mapping)) = state FROM (VALUES ('{"left": "odd"}', '22023'),
  ('{"source_ref": "arc", "left": "nothing"}', '42703'), ('{"source_ref": "arc", "left": "odd", "odd": "odd"}', '22023'), ('{"source_ref": "arc", "width": "odd"}', '22023'), ('{"source_ref": "arc", "odd": "odd", "odd_side": "top"}', '22023')) v(mapping, state);
INSERT INTO survey VALUES ('s1', 1, 1);
SELECT 'doubled ids are refused', test.state($$SELECT streetgen.import_sidewalk_widths('town', 'survey', '{"source_ref": "arc", "odd": "odd"}')$$) = '22023';
SELECT 'the tags of sidewalks: ' || said, streetgen._osm_sidewalk(of_side, of_way, width, 'left') IS NOT DISTINCT FROM wanted FROM (VALUES ('both', NULL, 'both', NULL, NULL::float8), ('no', NULL, 'no', NULL, 0),
  ('on the right', NULL, 'right', NULL, 0), ('on the left with a width', NULL, 'left', '2.5', 2.5), ('of the side', 'no', 'both', '2', 0), ('in feet', 'yes', NULL, '10 ft', 3.048), ('nonsense', 'yes', NULL, 'wide', NULL)) v(said, of_side, of_way, width, wanted);

-- By clusters as at once.
DO $$ BEGIN
  PERFORM streetgen.create_model('once', 2154, subjects => '{sidewalk}');
  PERFORM streetgen.live('once', false);
  INSERT INTO once.axis (axis_id, geom, width, importance) SELECT 100 * x + y, pg_temp.line(CASE d WHEN 0 THEN format('LINESTRING(%s %s,%s %s)', 60 * x, 50 * y, 60 * x + 60, 50 * y) ELSE format('LINESTRING(%s %s,%s %s)', 60 * x, 50 * y, 60 * x, 50 * y + 50) END), 6 + (x + y) % 3, 3 + (x * y) % 3
    FROM generate_series(1, 24) x, generate_series(1, 48) y, LATERAL (SELECT y % 2 AS d) d;
  PERFORM streetgen.create_model('parts', 2154, subjects => '{sidewalk}');
  PERFORM streetgen.live('parts', false);
  INSERT INTO parts.axis SELECT * FROM once.axis;
  PERFORM FROM streetgen.generate('once');
  PERFORM FROM streetgen.plan_clusters('parts', 8);
END $$;
DO $$ BEGIN
  WHILE EXISTS (SELECT FROM streetgen.generate_cluster('parts')) LOOP NULL; END LOOP;
  WHILE streetgen.finish_clusters('parts') IS NOT NULL LOOP NULL; END LOOP;
END $$;
SELECT 'clusters make the same sidewalks', (SELECT count(*) > 1000 FROM once.sidewalk) AND NOT EXISTS ((SELECT pg_temp.sidewalks('parts') EXCEPT SELECT pg_temp.sidewalks('once')) UNION ALL (SELECT pg_temp.sidewalks('once') EXCEPT SELECT pg_temp.sidewalks('parts')));
