-- see drop_design, design, import_terrain
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
SELECT network, speed, width, carriageways FROM valley.design_class;
