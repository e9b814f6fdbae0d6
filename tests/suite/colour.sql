-- Pixels of a picture that lie well inside one surface, each with the colour that symbol_rule gives what lies uppermost there: rows "x,y,colour,class".
-- Variables: model, theme, scale, number; xmin, ymin, xmax, ymax of the picture. Places are drawn with a seed, as many of one class as of another.
SELECT ST_MakeEnvelope(:xmin, :ymin, :xmax, :ymax, srid) AS box, :scale * streetgen._pixel_on_paper() AS pixel, 'EPSG:' || srid AS reference FROM streetgen.model WHERE name = :'model' \gset
CREATE TEMPORARY TABLE symbol AS SELECT * FROM streetgen._symbols(:'model', :'theme', :scale);
CREATE TEMPORARY TABLE shape AS SELECT h.id, coalesce(h.level * 10, 1e6) + s.place AS height, s.*, -- A shadow falls to the south-east.
    CASE s.marker WHEN 'shadow' THEN ST_Translate(h.geom, o.aside, -o.aside) ELSE h.geom END AS seen, CASE WHEN s.line IS NULL OR s.line = s.fill OR s.marker IS NOT NULL THEN 0 ELSE o.aside / 2 END AS border
  FROM streetgen._shapes(:'model', :'box', ARRAY(SELECT DISTINCT layer FROM symbol)) h
      LEFT JOIN streetgen._drawn_kinds(:'model', :'theme', :scale) k USING (layer, kind) JOIN symbol s ON (s.layer, s.kind) = (h.layer, coalesce(k.drawn_as, '')),
    LATERAL (SELECT coalesce(streetgen._drawn_metres(s.width, s.unit, :pixel), 0) AS aside) o;
CREATE INDEX ON shape USING gist (seen);
ANALYZE shape;
-- Two pixels and a half from every border there is one colour alone.
CREATE TEMPORARY TABLE place AS
SELECT concat_ws(' ', layer, nullif(kind, '')) AS class, fill, height, symbol, id, d.geom AS place
FROM shape, LATERAL (SELECT ST_Buffer(ST_Intersection(seen, :'box'), -(border + 2.5 * :pixel)) AS within OFFSET 0) w, LATERAL ST_Dump(ST_GeneratePoints(within, 10, 1 + (id % 1000)::integer)) d
WHERE ST_Area(within) > 20 * :pixel ^ 2 AND fill ~ '^#.{6}$' AND ST_Dimension(seen) = 2 AND marker IS NULL
UNION ALL SELECT 'ground', fill, -1e9, -1, -1, d.geom FROM symbol, ST_Dump(ST_GeneratePoints(ST_Buffer(:'box'::geometry, -3 * :pixel), 4000, 7)) d WHERE layer = 'ground';
SELECT floor((ST_X(place) - :xmin) / :pixel) || ',' || floor((:ymax - ST_Y(place)) / :pixel) || ',' || fill || ',' || class FROM (
  SELECT *, row_number() OVER (PARTITION BY class ORDER BY md5(id::text || ST_AsText(place, 2))) AS turn FROM place p
  WHERE NOT EXISTS (SELECT FROM shape o WHERE ST_DWithin(o.seen, p.place, o.border + 2.5 * :pixel) AND (o.height, o.symbol) >= (p.height, p.symbol)
    AND NOT (o.symbol = p.symbol AND (o.id = p.id OR o.border = 0) AND o.fill = p.fill))) s
ORDER BY turn, class LIMIT :number;
