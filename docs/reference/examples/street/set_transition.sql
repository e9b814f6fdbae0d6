-- argument node: node_id of a node of two edges
-- argument kind: symmetric, left or right; NULL: setting transition_kind
-- argument length: length of the change, metres; NULL: setting transition_length
-- see set
SELECT streetgen.set_transition('town', node_id, 'left', 20) FROM town.intersection WHERE method = 'transition';
SELECT axis_id, which, kind, length FROM town.transition_override;
