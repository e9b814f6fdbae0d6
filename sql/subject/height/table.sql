-- The table of heights along edges.

CREATE TABLE :"model".profile (
    edge_id bigint PRIMARY KEY REFERENCES :"model".edge ON DELETE CASCADE,
    geom geometry(LineStringZ, :srid) NOT NULL, grade_max float8 NOT NULL, method text NOT NULL,
    tied_from boolean NOT NULL, tied_to boolean NOT NULL);
CREATE INDEX profile_off_ground ON :"model".profile (edge_id)
    WHERE method <> 'ground' OR tied_from OR tied_to;
CREATE INDEX IF NOT EXISTS node_without_height ON :"model".node USING gist (geom)
    WHERE ST_Z(geom) NOT BETWEEN -500 AND 10000;
CREATE INDEX profile_geom ON :"model".profile USING gist (geom);
COMMENT ON TABLE :"model".profile IS
    'Heights along edges: those of the ground, or the least ones that keep clearances and grades where roads pass '
    'over and under each other';
COMMENT ON COLUMN :"model".profile.edge_id IS 'the edge';
COMMENT ON COLUMN :"model".profile.geom IS
    'the line of the edge with the heights of the roadway, metres, and further points where its grade changes';
COMMENT ON COLUMN :"model".profile.grade_max IS
    'greatest rise for each metre along it: setting grade_usual; where that leaves no heights, grade_maximal; more '
    'where its ground is steeper';
COMMENT ON COLUMN :"model".profile.method IS
    'how it came about: ground (as the ground), lifted (somewhere above it) or sunk (somewhere below it)';
COMMENT ON COLUMN :"model".profile.tied_from IS
    'are the heights of all edges at the node where it begins found together? They are where one of them left the '
    'ground there in any step, wherever it lies in the end';
COMMENT ON COLUMN :"model".profile.tied_to IS 'the same at the node where it ends';
