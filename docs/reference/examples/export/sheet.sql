-- argument scale: 500 for 1:500
-- argument paper: A0 to A5
-- argument centre: POINT about which one sheet is drawn; NULL: the whole model
-- argument theme: one of `symbol_rule.theme`
-- argument upright: the paper stands upright
-- see svg
SELECT streetgen.set('town', 'attribution', '© town of Example');
SELECT number, length(svg) > 1000 AS drawn FROM streetgen.sheet('town', 1000, 'A4');
