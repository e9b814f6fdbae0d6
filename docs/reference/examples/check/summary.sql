-- see check_model
SELECT * FROM streetgen.summary('town') WHERE subject LIKE 'corners%' OR unit = 'km';
