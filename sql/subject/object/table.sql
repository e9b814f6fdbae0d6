-- The edges of objects. Foreign keys took half of the time of a run with many objects, and its rows come from
-- both tables.

CREATE TABLE :"model".object_edge (
    street_object_id bigint PRIMARY KEY,
    edge_id bigint NOT NULL);
CREATE INDEX object_edge_edge ON :"model".object_edge (edge_id);
COMMENT ON TABLE :"model".object_edge IS 'The edge at which each object that is placed by an axis stands';
COMMENT ON COLUMN :"model".object_edge.street_object_id IS 'the object';
COMMENT ON COLUMN :"model".object_edge.edge_id IS 'the edge at its abscissa';
