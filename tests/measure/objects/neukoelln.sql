-- The named streets of Neukölln as lines that import_osm reads.
CREATE TABLE neukoelln_line AS
SELECT row_number() OVER (ORDER BY s.fid, path) AS way_id, highway::text AS class, name::text, NULL::text AS ref,
    '{}'::jsonb AS tags, d.geom
FROM neukoelln_street s, ST_Dump(s.geom) d WHERE highway IS NOT NULL;
