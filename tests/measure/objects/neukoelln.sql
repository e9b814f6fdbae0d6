-- The named streets of Neukölln as lines that import_osm reads.
CREATE TABLE neukoelln_line AS
SELECT row_number() OVER (ORDER BY s.fid, path) AS way_id, highway::text AS class, name::text, NULL::text AS lanes, NULL::text AS lanes_forward, NULL::text AS lanes_backward, NULL::text AS width,
    NULL::text AS oneway, NULL::text AS junction, NULL::text AS layer, NULL::text AS bridge, NULL::text AS tunnel, NULL::text AS maxspeed, d.geom
FROM neukoelln_street s, ST_Dump(s.geom) d WHERE highway IS NOT NULL;
