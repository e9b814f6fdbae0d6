-- argument options: options of [export_option](#export_option) that differ from their default
-- see export_option, svg, sheet
SELECT replace(line, E'\n', ' ') AS entity FROM streetgen.export_dxf('town')
    WHERE line LIKE E'0\nARC%' ORDER BY ordinality LIMIT 1;
