-- argument setting: name of the setting, see [settings.md](settings.md)
-- argument value: its new value as text
-- see setting, generate
SELECT streetgen.set('town', 'dead_end', 'round');
SELECT value FROM streetgen.setting('town') WHERE name = 'dead_end';
SELECT relation, updated FROM streetgen.generate('town') WHERE updated > 0;
