-- see set
SELECT name, value, unit, minimum, maximum FROM streetgen.setting('town') WHERE unit = 'm2';
