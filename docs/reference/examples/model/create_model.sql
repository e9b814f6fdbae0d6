-- argument dimension: 2, or 3 where axes, nodes, edges and limits carry Z
-- argument subjects: what to compute besides network and surface, as [subject](#subject) lists; NULL: lane and interconnection
-- argument driving_side: right, left, or auto: right until the one-way axes of an import say otherwise
-- see subject, drop_model, adopt_model, setting, driving_side
SELECT streetgen.create_model('village', srid => 32631);
SELECT streetgen.create_model('hamlet', srid => 2154, subjects => '{lane}');
SELECT name, srid, dimension FROM streetgen.model ORDER BY name;
