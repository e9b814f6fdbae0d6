-- The columns of the tables of roundabouts.

CREATE OR REPLACE FUNCTION streetgen._roundabout_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$ VALUES
    ('roundabout'::name, 'roundabout_id'::name, 'key; kept while the smallest place of its ring stays'),
    ('roundabout', 'edge_id', 'the edge of the smallest place of its ring'),
    ('roundabout', 'along_axis', 'does traffic that goes round drive along that edge?'),
    ('roundabout', 'level', 'level of the ring'),
    ('roundabout', 'kind',
        'ring; mini: without an island, since the roadway covers it; double: two faces with an edge between them; '
        'peanut: its ring has a waist'),
    ('roundabout', 'centre', 'centre of the circle of least squares'),
    ('roundabout', 'radius', 'radius of that circle, metres'),
    ('roundabout', 'geom', 'the ring along the axes, counter-clockwise, closed; about both faces of a double one'),
    ('roundabout', 'island', 'ground within, clear of the roadway; empty: none'),
    ('roundabout', 'score', '0 to 1, by setting roundabout_score; 1 where a tag of the source counts'),
    ('roundabout', 'term_shape', 'how round it is, 0 to 1: streetgen.roundabout_shape'),
    ('roundabout', 'term_name', 'what its edges are called, 0 to 1: streetgen.roundabout_name'),
    ('roundabout', 'term_network', 'what meets it and which way traffic runs, 0 to 1: streetgen.roundabout_network'),
    ('roundabout', 'accepted', 'does traffic go round: confirmed, else score against setting roundabout_accept'),
    ('roundabout', 'confirmed', 'decided by hand; NULL: not'),
    ('roundabout', 'method', 'hypothesis, or by_hand'),
    ('roundabout_edge', 'roundabout_edge_id', 'key'),
    ('roundabout_edge', 'edge_id', 'the edge'),
    ('roundabout_edge', 'along_axis', 'does traffic that goes round drive along the edge?'),
    ('roundabout_edge', 'roundabout_id', 'the ring'),
    ('roundabout_edge', 'face', 'number of the face that it bounds, from 1: a double roundabout has two'),
    ('roundabout_edge', 'ordinality', 'number from 1, face by face, counter-clockwise from the smallest place of each'),
    ('roundabout_arm', 'roundabout_arm_id', 'key'),
    ('roundabout_arm', 'roundabout_id', 'the ring'),
    ('roundabout_arm', 'edge_id', 'the edge that leaves it outwards'),
    ('roundabout_arm', 'along_axis', 'does traffic that comes to the ring drive along the edge?'),
    ('roundabout_arm', 'node_id', 'the node of the ring'),
    ('roundabout_block', 'roundabout_id', 'the ring'),
    ('roundabout_block', 'block_id', 'the block within; NULL: the ring lies on another level'),
    ('roundabout_override', 'roundabout_override_id', 'key'),
    ('roundabout_override', 'geom', 'a place within the ring'),
    ('roundabout_override', 'confirmed', 'is the ring a roundabout?'),
    ('roundabout_pattern', 'pattern', 'regular expression of a name; upper and lower case are alike'),
    ('roundabout_pattern', 'language', 'of which it is a word') $$;
COMMENT ON FUNCTION streetgen._roundabout_column() IS
    'The columns of the tables of roundabouts, and what each is: a part of streetgen._model_column.';
