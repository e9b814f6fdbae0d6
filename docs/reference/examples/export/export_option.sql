-- see export_sumo, export_symuvia
SELECT name, formats, kind, value, unit FROM streetgen.export_option() WHERE 'sumo' = ANY (formats);
