-- Decisions by hand beside axes that changed.
CREATE TYPE streetgen.placed_decision AS (relation text, override_id bigint, role text, axis_id bigint, line geometry,
    before geometry, place geometry, redrawn boolean, turned boolean, abscissa float8, geom geometry);
COMMENT ON TYPE streetgen.placed_decision IS 'A place of a decision by hand, and the axis that it lies on now.';
COMMENT ON COLUMN streetgen.placed_decision.relation IS 'the table of the decision';
COMMENT ON COLUMN streetgen.placed_decision.override_id IS 'its key there';
COMMENT ON COLUMN streetgen.placed_decision.role IS 'the column that names the axis';
COMMENT ON COLUMN streetgen.placed_decision.axis_id IS 'the axis that it lies on now';
COMMENT ON COLUMN streetgen.placed_decision.line IS 'the line of that axis';
COMMENT ON COLUMN streetgen.placed_decision.before IS 'the line of the axis that it lay on';
COMMENT ON COLUMN streetgen.placed_decision.place IS 'where it lay';
COMMENT ON COLUMN streetgen.placed_decision.redrawn IS 'was its own axis redrawn?';
COMMENT ON COLUMN streetgen.placed_decision.turned IS 'does the axis run against the one that it lay on?';
COMMENT ON COLUMN streetgen.placed_decision.abscissa IS 'metres along the axis';
COMMENT ON COLUMN streetgen.placed_decision.geom IS 'where it lies now';
CREATE TYPE streetgen.node_decision AS (relation text, override_id bigint, first_axis bigint, second_axis bigint,
    first_turned boolean, second_turned boolean, east float8, north float8, to_east float8, to_north float8,
    new_place geometry);
COMMENT ON TYPE streetgen.node_decision IS 'A decision by hand at a node, with its axes now and the way of the node.';
COMMENT ON COLUMN streetgen.node_decision.relation IS 'the table of the decision';
COMMENT ON COLUMN streetgen.node_decision.override_id IS 'its key there';
COMMENT ON COLUMN streetgen.node_decision.first_axis IS 'the axis now in place of the first; NULL: as before';
COMMENT ON COLUMN streetgen.node_decision.second_axis IS 'the axis now in place of the second; NULL: as before';
COMMENT ON COLUMN streetgen.node_decision.first_turned IS 'does it run against the first?';
COMMENT ON COLUMN streetgen.node_decision.second_turned IS 'does it run against the second?';
COMMENT ON COLUMN streetgen.node_decision.east IS 'metres that the node moved to the east';
COMMENT ON COLUMN streetgen.node_decision.north IS 'metres that the node moved to the north';
COMMENT ON COLUMN streetgen.node_decision.to_east IS 'metres that the node of to_geom moved to the east';
COMMENT ON COLUMN streetgen.node_decision.to_north IS 'metres that the node of to_geom moved to the north';
COMMENT ON COLUMN streetgen.node_decision.new_place IS 'where the node is now; NULL: where it was';
