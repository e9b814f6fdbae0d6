-- see import_osm, import_bdtopo
SELECT tag, becomes FROM streetgen.tag_use() WHERE tag LIKE 'turn:lanes%';
