-- Objects observed on the wrong side of the kerb of their street, those on the border over 0.25 m from it:
-- psql -v model=MODEL -v points=TABLE -v what=WORDS.
SELECT :'model', :'what', count(*) AS objects, round(100.0 * count(*) FILTER (WHERE CASE relation WHEN 'in'
    THEN beyond > 0 WHEN 'out' THEN beyond < 0 ELSE abs(beyond) > 0.25 END) / count(*), 1) AS violated
FROM (SELECT o.relation, ST_Distance(k.geom, o.geom) * CASE WHEN EXISTS (SELECT FROM :model.roadway r
        WHERE ST_Intersects(r.surface, o.geom)) THEN -1 ELSE 1 END AS beyond
    FROM :points o, LATERAL (SELECT geom FROM :model.kerb k ORDER BY k.geom <-> o.geom LIMIT 1) k) o;
