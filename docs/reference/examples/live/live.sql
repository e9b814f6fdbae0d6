-- argument live: follow each edit (true), or leave the streets to generate
-- see generate
SELECT streetgen.live('town', false) AS stale;
UPDATE town.axis SET width = 8 WHERE name = 'mill lane';
SELECT streetgen.live('town', true) AS stale;
