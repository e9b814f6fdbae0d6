-- see create_traffic
SELECT streetgen.create_model('emptied', 2154, driving_side => 'right'), streetgen.create_traffic('emptied');
SELECT streetgen.drop_traffic('emptied');
