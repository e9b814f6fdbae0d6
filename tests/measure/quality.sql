-- The tables of docs/figures/streets.md for one model, a row per table and the failures: psql -v model=NAME -f tests/measure/quality.sql
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
CREATE TEMPORARY TABLE surface AS SELECT 'section' AS kind, s.edge_id AS id, s.level, s.surface, s.method, from_node AS node_a, to_node AS node_b FROM :"model".section s JOIN :"model".edge USING (edge_id) WHERE NOT ST_IsEmpty(surface)
    UNION ALL SELECT 'intersection', node_id, level, surface, method, node_id, node_id FROM :"model".intersection WHERE NOT ST_IsEmpty(surface);
CREATE INDEX ON surface USING gist (surface);
ANALYZE surface;
-- The rest of ground or a line once surfaces are taken away, one by one: a union of them costs six times as much, and GEOS loses whole streets of one
-- whose surfaces touch in points. Noded at a grid, m, where one is given; where GEOS cannot do without, at a micrometre.
CREATE FUNCTION pg_temp.remainder(geom geometry, taken geometry[], grid float8 DEFAULT -1) RETURNS geometry LANGUAGE plpgsql AS $$
DECLARE
    part geometry;
BEGIN
    FOREACH part IN ARRAY taken LOOP
        CONTINUE WHEN NOT geom && part;
        BEGIN
            geom := ST_CollectionExtract(ST_Difference(geom, part, grid), ST_Dimension(geom) + 1);
        EXCEPTION WHEN internal_error THEN
            geom := ST_CollectionExtract(ST_Difference(geom, part, 1e-6), ST_Dimension(geom) + 1);
        END;
    END LOOP;
    RETURN geom;
END $$;
CREATE TEMPORARY TABLE degree AS SELECT node_id, count(*) AS degree FROM (SELECT from_node AS node_id FROM :"model".edge UNION ALL SELECT to_node FROM :"model".edge) e GROUP BY node_id;
SELECT 'figures | ' || :'model', (SELECT count(*) FROM :"model".axis),
    (SELECT round(100.0 * count(*) FILTER (WHERE NOT ST_IsEmpty(i.surface) AND ST_IsValid(i.surface)) / nullif(count(*), 0), 2) FROM degree d LEFT JOIN :"model".intersection i USING (node_id) WHERE degree >= 3),
    (SELECT round(100.0 * count(*) FILTER (WHERE ST_IsValid(surface)) / count(*), 2) FROM surface),
    (SELECT round((100 * coalesce(sum(ST_Area(ST_Intersection(a.surface, b.surface))), 0) / (SELECT sum(ST_Area(surface)) FROM surface))::numeric, 5)
        FROM surface a JOIN surface b ON a.surface && b.surface AND (a.level = b.level OR a.kind <> b.kind AND b.id IN (a.node_a, a.node_b)) AND (a.kind, a.id) > (b.kind, b.id)),
    (SELECT round((100 - 100 * sum(ST_Length(pg_temp.remainder(e.geom, ARRAY(SELECT s.surface FROM surface s
            WHERE s.surface && e.geom AND (s.level = e.level OR s.kind = 'intersection' AND s.id IN (e.from_node, e.to_node))), 1e-6))) / sum(ST_Length(e.geom)))::numeric, 3)
        FROM (SELECT edge_id, from_node, to_node, ST_Force2D(geom) AS geom, level FROM :"model".edge) e),
    (SELECT round((100.0 * count(*) FILTER (WHERE method = 'contested') / count(*))::numeric, 2) FROM surface) || ' |';

\ir kerbs.sql
SELECT 'kerbs | ' || :'model', (SELECT count(*) FROM lawful),
    coalesce((SELECT round(100 - 100.0 * (SELECT count(*) FROM finding WHERE measure = 'arc') / nullif(count(*), 0), 2)::text FROM lawful), '-'),
    (SELECT round((100 - 100 * sum(missing_area) / sum(area))::numeric, 4) FROM uncovered),
    (SELECT round((100 * sum(excess_area) / sum(area))::numeric, 4) FROM excess),
    coalesce((SELECT round(100 - 100.0 * (SELECT count(*) FROM finding WHERE measure = 'border line off a boundary') / nullif(count(*), 0), 2)::text FROM border), '-'),
    (SELECT count(*) FROM finding WHERE measure = 'hole'),
    (SELECT count(*) FROM departure), coalesce((SELECT round((100 * max(departure))::numeric, 2)::text FROM departure), '-'),
    (SELECT count(*) FROM filled), coalesce((SELECT round(sum(ST_Area(filled))::numeric, 2)::text FROM filled), '-') || ' |';
SELECT 'corners | ' || :'model', total, (SELECT string_agg(round(coalesce(100.0 * c.count / total, 0), 2)::text, ' | ' ORDER BY i)
        FROM unnest(ARRAY['hypothesis', 'radius_reduced', 'radius_minimal', 'followed', 'nose', 'no_arc']) WITH ORDINALITY AS m(method, i) LEFT JOIN (SELECT method, count(*) FROM :"model".corner GROUP BY method) c USING (method)),
    (SELECT coalesce(round(100.0 * count(measure) / nullif(below, 0), 2)::text, '-') || ' | ' || coalesce(round(100.0 * count(measure) FILTER (WHERE measure <> 'no arc: no ground between') / nullif(below, 0), 2)::text, '-')
        FROM (SELECT count(*) AS below FROM pair WHERE phi < radians(160)) b LEFT JOIN finding ON measure LIKE 'no arc:%' GROUP BY below),
    (SELECT string_agg((SELECT count(*) FROM finding WHERE measure = 'no arc: ' || reason)::text, ' | ' ORDER BY i)
        FROM unnest(ARRAY['none wanted', 'no ground between', 'borders do not meet', 'under 1 mm fits', 'borders meet in one point']) WITH ORDINALITY AS r(reason, i)) || ' |'
FROM (SELECT count(*) AS total FROM :"model".corner) k;
-- Surfaces where nothing was contested; 0.1 m as the importers' epsilon.
CREATE TEMPORARY TABLE whole AS SELECT edge_id, surface FROM :"model".section WHERE contested_area = 0 AND NOT ST_IsEmpty(surface);
SELECT 'lanes | ' || :'model', count(*), round((sum(ST_Length(l.geom)) / 1000)::numeric, 1),
    (SELECT round((100 * sum(ST_Length(ST_Intersection(l.geom, ST_Buffer(w.surface, 0.1)))) / sum(ST_Length(l.geom)))::numeric, 3) FROM :"model".lane l JOIN whole w USING (edge_id)),
    (SELECT round((100 * sum(ST_Area(ST_SymDifference(l.surface, w.surface))) / sum(ST_Area(w.surface)))::numeric, 4) FROM (SELECT edge_id, ST_Union(surface) AS surface FROM :"model".lane GROUP BY edge_id) l JOIN whole w USING (edge_id)),
    round(100.0 * count(*) FILTER (WHERE kind IN ('general', 'bus') AND l.width < 2 - 1e-6) / count(*), 2), round(100.0 * count(*) FILTER (WHERE 'lane_count' = ANY (estimated)) / count(*), 1) || ' |'
FROM :"model".lane l JOIN :"model".edge USING (edge_id);
-- The marks of lanes are taken away for the last of these, and kerbs are made: all is put back.
BEGIN;
\ir traffic.sql
\ir shapes.sql
SELECT 'traffic | ' || :'model', (SELECT count(*) FROM :"model".interconnection), (SELECT round(100.0 * count(*) FILTER (WHERE plausible) / nullif(count(*), 0), 1) FROM :"model".interconnection),
    count(*) FILTER (WHERE abs(angle) > 20), round(100.0 * (SELECT count(*) FROM tight) / nullif(count(*) FILTER (WHERE abs(angle) > 20), 0), 2), round(100.0 * (SELECT count(*) FROM tight WHERE allowed) / nullif(count(*) FILTER (WHERE abs(angle) > 20), 0), 2),
    (SELECT round(100.0 * count(*) FILTER (WHERE radius < 3) / nullif(count(*), 0), 2) FROM path WHERE abs(angle) > 20 AND NOT crossed),
    (SELECT lanes_in - sinks || ' of ' || lanes_in FROM dead), (SELECT lanes_out - sources || ' of ' || lanes_out FROM dead),
    (SELECT concat_ws(' | ', coalesce(round((100 * sum(inside) FILTER (WHERE plausible) / sum(length) FILTER (WHERE plausible))::numeric, 3)::text, '-'), coalesce(round((100 * sum(inside) / sum(length))::numeric, 3)::text, '-')) FROM inside WHERE length > 0) || ' |'
FROM path;
SELECT 'turns | ' || :'model', count(DISTINCT lane_in), count(*) FILTER (WHERE marked), count(*) FILTER (WHERE guessed),
    coalesce(round(100.0 * count(*) FILTER (WHERE marked AND guessed) / nullif(count(*) FILTER (WHERE guessed), 0), 1)::text, '-'),
    coalesce(round(100.0 * count(*) FILTER (WHERE marked AND guessed) / nullif(count(*) FILTER (WHERE marked), 0), 1)::text, '-') || ' |'
FROM guess;
SELECT 'shapes | ' || :'model', (SELECT string_agg((SELECT count(*) FROM finding WHERE measure = m)::text, ' | ' ORDER BY i)
        FROM unnest(ARRAY['surface under 0.01 m2', 'slit', 'step of a kerb', 'kink of the outline']) WITH ORDINALITY AS w(m, i)),
    (SELECT round((1000 * (SELECT count(*) FROM finding WHERE measure = 'kink of the outline') / sum(ST_Length(geom)))::numeric, 3) FROM outline),
    (SELECT count(DISTINCT id) FROM finding WHERE measure = 'median paved') || ' of ' || (SELECT count(DISTINCT edge_id) FROM median), (SELECT count(*) FROM finding WHERE measure = 'island gone') || ' of ' || (SELECT count(*) FROM traffic_island),
    (SELECT count(*) FROM finding WHERE measure = 'corner of a path over 30 degrees'),
    round(100.0 * count(*) FILTER (WHERE radius < 3) / nullif(count(*), 0), 2), round(100.0 * count(*) FILTER (WHERE radius < 4) / nullif(count(*), 0), 2),
    (SELECT round(100.0 * count(*) / nullif((SELECT count(*) FROM path) + count(*) FILTER (WHERE NOT plausible), 0), 2) FROM :"model".interconnection WHERE reason = 'not_drivable') || ' |'
FROM path WHERE abs(angle) > 20;
SELECT 'worst | ' || :'model', measure, relation, id, round(value::numeric, 4), format('%s %s', round(ST_X(place)::numeric, 1), round(ST_Y(place)::numeric, 1)) || ' |'
FROM (SELECT *, ST_PointOnSurface(geom) AS place, row_number() OVER (PARTITION BY measure ORDER BY value DESC, relation, id) AS rank FROM finding) f WHERE rank <= 10 ORDER BY measure, rank;
ROLLBACK;
