\set ECHO none
\ir shared/truths.sql
-- Axes cut at junctions: the streets stay, each piece has its values, and belongs to its source.  Each SELECT is one
-- truth: (name, holds).
CREATE FUNCTION pg_temp.line(line text) RETURNS geometry LANGUAGE sql
    AS $$ SELECT ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000) $$;
CREATE TABLE roads (id text, wide float8, wide_end float8, label text, geom geometry);
INSERT INTO roads VALUES ('main', 6, 12, 'Main', pg_temp.line('LINESTRING(0 0,100 0,150 20,300 20)')),
    ('side', 6, NULL, 'Side', pg_temp.line('LINESTRING(100 0,100 90)')),
    ('cross', 5, NULL, 'Cross', pg_temp.line('LINESTRING(200 -80,200 90)')),
    ('ring', 6, NULL, 'Ring', pg_temp.line('LINESTRING(300 20,320 40,340 20,320 0,300 20)')),
    ('out', 6, NULL, 'Out', pg_temp.line('LINESTRING(340 20,400 20)'));
SELECT streetgen.create_model('town', 2154, subjects => '{lane,sidewalk,kerb,interconnection,junction}') \g /dev/null
SELECT streetgen.set('town', 'crossing', 'split') \g /dev/null
\set mapping '''{"source_ref": "id", "width": "wide", "width_end": "wide_end", "name": "label"}'''
SELECT FROM streetgen.import_axes('town', 'roads', :mapping) \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
CREATE FUNCTION pg_temp.streets() RETURNS TABLE (counted text, ground geometry) LANGUAGE sql AS $$ SELECT
    (SELECT string_agg(kind || n, ' ' ORDER BY kind) FROM (SELECT kind, count(*) n FROM town.lane GROUP BY 1
        UNION ALL SELECT turn, count(*) FROM town.interconnection GROUP BY 1 UNION ALL SELECT kind, count(*)
        FROM town.junction GROUP BY 1 UNION ALL SELECT 'node', count(*) FROM town.node) c),
    (SELECT ST_Union(surface) FROM town.roadway) $$;
INSERT INTO town.sidewalk_override (axis_id, abscissa, side, width) SELECT axis_id, 250, 'left', 4 FROM town.axis
    WHERE name = 'Main';
CREATE TABLE place_before AS SELECT ST_LineInterpolatePoint(a.geom, o.abscissa / ST_Length(a.geom)) AS geom, o.axis_id
    FROM town.sidewalk_override o JOIN town.axis a USING (axis_id);
CREATE TABLE before AS SELECT * FROM pg_temp.streets();

CREATE ROLE pieces_reader; CREATE ROLE pieces_editor;
SELECT streetgen.grant('town', 'pieces_reader', 'reader'), streetgen.grant('town', 'pieces_editor', 'editor')
\g /dev/null
SET ROLE pieces_reader;
SELECT 'a reader cuts nothing', test.state($$SELECT streetgen.cut_at_junctions('town')$$) = '42501';
SET ROLE pieces_editor;
SELECT 'an axis that is none: 22023', test.state($$SELECT streetgen.cut_at_junctions('town', '{7, 99}')$$) = '22023';
SELECT 'one that passes no node stays', streetgen.cut_at_junctions('town', ARRAY[(SELECT axis_id FROM town.axis
    WHERE name = 'Side')]) = 0;
SELECT 'two pass nodes', streetgen.cut_at_junctions('town') = 2;
RESET ROLE;
SELECT 'each edge has an axis of its own, but on the ring', count(*) = count(DISTINCT axis_id) FROM town.edge
    JOIN town.axis a USING (axis_id) WHERE a.name <> 'Ring';
SELECT 'streets are as before', b.counted = s.counted AND ST_Area(ST_SymDifference(b.ground, s.ground)) < 0.01
    FROM before b, pg_temp.streets() s;
SELECT 'pieces make the whole', ST_Equals(ST_LineMerge(ST_Collect(a.geom)), r.geom)
    AND count(*) = 3 FROM town.axis a JOIN roads r ON r.label = a.name WHERE r.id = 'main' GROUP BY r.geom;
SELECT 'a taper goes on where it was cut', bool_and(abs(width - (6 + 6 * ST_LineLocatePoint(r.geom,
    ST_StartPoint(a.geom)))) < 1e-6 AND abs(width_end - (6 + 6 * ST_LineLocatePoint(r.geom, ST_EndPoint(a.geom))))
    < 1e-6) FROM town.axis a JOIN roads r ON r.label = a.name WHERE r.id = 'main';
SELECT 'others have none', bool_and(width_end IS NULL) FROM town.axis WHERE name <> 'Main';
SELECT 'one has the key of its source, the others are its pieces', array_agg(source_ref ORDER BY axis_id)
    = '{main,NULL,NULL}' AND count(DISTINCT source) = 1 FROM town.axis WHERE name = 'Main';
SELECT 'a width by hand stays where it is, on the piece that lies there', o.axis_id <> p.axis_id AND ST_DWithin(p.geom,
    ST_LineInterpolatePoint(a.geom, o.abscissa / ST_Length(a.geom)), 0.01)
    FROM place_before p, town.sidewalk_override o JOIN town.axis a USING (axis_id);
SELECT 'a second time cuts nothing', streetgen.cut_at_junctions('town') = 0;
SELECT 'nothing is stale', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule LIKE 'stale%'
    OR severity = 'error');

-- A delivery brings all pieces what it changed, and a width by hand holds.
UPDATE town.axis SET width = 9 WHERE axis_id = (SELECT max(axis_id) FROM town.axis WHERE name = 'Cross');
UPDATE roads SET label = 'Cross Road', wide = 4 WHERE id = 'cross';
SELECT FROM streetgen.import_axes('town', 'roads', :mapping) \g /dev/null
SELECT 'a delivery reaches each piece', array_agg(width ORDER BY axis_id) = '{4,9}' FROM town.axis
    WHERE name = 'Cross Road';
SELECT 'and brings no axis back', count(*) = 8 FROM town.axis;

-- What lies on another axis is no street, and stays with the piece before it.
SELECT streetgen.create_model('twin', 2154) \g /dev/null
INSERT INTO twin.axis (axis_id, geom, width, name) VALUES
    (1, pg_temp.line('LINESTRING(-50 0,0 0,60 0,160 0)'), 9, 'Long'), (2, pg_temp.line('LINESTRING(0 0,60 0)'), 12, 'Wide'),
    (3, pg_temp.line('LINESTRING(0 0,0 70)'), 6, 'North'), (4, pg_temp.line('LINESTRING(60 0,60 70)'), 6, 'South');
UPDATE twin.axis SET importance = 1 WHERE axis_id = 2;
SELECT 'a twin has no edge between', count(*) = 2 FROM twin.edge WHERE axis_id = 1;
SELECT streetgen.cut_at_junctions('twin') \g /dev/null
SELECT 'no metre of an axis is lost', round(sum(ST_Length(geom))) = 210 FROM twin.axis WHERE name = 'Long';
DROP OWNED BY pieces_reader, pieces_editor;
DROP ROLE pieces_reader, pieces_editor;
