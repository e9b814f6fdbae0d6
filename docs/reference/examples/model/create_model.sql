-- argument dimension: 2, or 3 where axes, nodes, edges and limits carry Z
-- see drop_model, adopt_model, setting
SELECT streetgen.create_model('village', srid => 32631);
SELECT name, srid, dimension FROM streetgen.model ORDER BY name;
