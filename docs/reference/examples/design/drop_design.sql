-- see create_design
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
SELECT streetgen.drop_design('valley');
