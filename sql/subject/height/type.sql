-- Heights of roads are found from these types.

CREATE TYPE streetgen.profile_edge AS (edge_id bigint, from_node bigint, to_node bigint, line bytea, grade float8,
    grade_greatest float8, speed float8, rise float8, ends_from boolean, ends_to boolean);
COMMENT ON TYPE streetgen.profile_edge IS 'An edge whose height is asked for.';
COMMENT ON COLUMN streetgen.profile_edge.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.profile_edge.from_node IS 'the node where it begins';
COMMENT ON COLUMN streetgen.profile_edge.to_node IS 'the node where it ends';
COMMENT ON COLUMN streetgen.profile_edge.line IS 'LINESTRING, EWKB: Z is the ground, without Z that is 0 m';
COMMENT ON COLUMN streetgen.profile_edge.grade IS 'usual rise for each metre along the road';
COMMENT ON COLUMN streetgen.profile_edge.grade_greatest IS 'its rise where the usual one leaves no heights';
COMMENT ON COLUMN streetgen.profile_edge.speed IS 'km/h';
COMMENT ON COLUMN streetgen.profile_edge.rise IS
    'm over the ground that a bridge without heights of its own lies, negative: under it, a tunnel; 0: neither';
COMMENT ON COLUMN streetgen.profile_edge.ends_from IS 'does the bridge end where it begins? Else others lead it on';
COMMENT ON COLUMN streetgen.profile_edge.ends_to IS 'does the bridge end where it ends?';

CREATE TYPE streetgen.solved_profile AS (edge_id bigint, line bytea, grade_max float8, method text, tied_from boolean,
    tied_to boolean);
COMMENT ON TYPE streetgen.solved_profile IS 'The height of an edge, as a row of table profile.';
COMMENT ON COLUMN streetgen.solved_profile.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.solved_profile.line IS 'LINESTRING Z, EWKB: its line with the heights of the road';
COMMENT ON COLUMN streetgen.solved_profile.grade_max IS 'greatest rise for each metre along it';
COMMENT ON COLUMN streetgen.solved_profile.method IS 'ground, lifted or sunk';
COMMENT ON COLUMN streetgen.solved_profile.tied_from IS 'are the edges where it begins solved together?';
COMMENT ON COLUMN streetgen.solved_profile.tied_to IS 'are the edges where it ends solved together?';

CREATE TYPE streetgen.profile_lift AS (edge_above bigint, abscissa_above float8, edge_below bigint,
    abscissa_below float8, clearance float8, sinks boolean);
COMMENT ON TYPE streetgen.profile_lift IS 'A crossing without a node, as heights see it.';
COMMENT ON COLUMN streetgen.profile_lift.edge_above IS 'the edge that passes over';
COMMENT ON COLUMN streetgen.profile_lift.abscissa_above IS 'where it does, m along the edge';
COMMENT ON COLUMN streetgen.profile_lift.edge_below IS 'the edge below';
COMMENT ON COLUMN streetgen.profile_lift.abscissa_below IS 'where it passes below, m along the edge';
COMMENT ON COLUMN streetgen.profile_lift.clearance IS 'm from roadway to roadway';
COMMENT ON COLUMN streetgen.profile_lift.sinks IS 'does the road below sink? Else the one above is lifted';

CREATE TYPE streetgen.profile_height AS (edge_id bigint, abscissa float8, height float8);
COMMENT ON TYPE streetgen.profile_height IS 'A height by hand: the road lies at least so high there.';
COMMENT ON COLUMN streetgen.profile_height.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.profile_height.abscissa IS 'm along the edge';
COMMENT ON COLUMN streetgen.profile_height.height IS 'm';
