-- see adopt_model
SELECT streetgen.version() ~ '^\d+\.\d+\.\d+$' AS has_three_numbers;
