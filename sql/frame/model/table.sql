-- The settings of a model, as they are by default.

CREATE TABLE :"model".setting (
    name text PRIMARY KEY,
    value text, unit text, description text NOT NULL, minimum float8, maximum float8, choice text[]);
INSERT INTO :"model".setting SELECT * FROM streetgen._default_setting();
COMMENT ON TABLE :"model".setting IS 'Settings of the model; streetgen.set changes one, within its range';
COMMENT ON COLUMN :"model".setting.name IS 'name of the setting';
COMMENT ON COLUMN :"model".setting.value IS 'its value as text';
COMMENT ON COLUMN :"model".setting.unit IS 'unit of the value';
COMMENT ON COLUMN :"model".setting.description IS 'what it decides';
COMMENT ON COLUMN :"model".setting.minimum IS 'smallest value of a number; NULL: the value is no number';
COMMENT ON COLUMN :"model".setting.maximum IS 'greatest value of a number';
COMMENT ON COLUMN :"model".setting.choice IS 'the words that the value may be';
