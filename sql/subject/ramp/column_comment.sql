-- This says what each column of ramps means.
CREATE OR REPLACE FUNCTION streetgen._ramp_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$ VALUES
    ('ramp_override'::name, 'ramp_override_id'::name, 'key'),
    ('ramp_override', 'axis_id', 'the link'),
    ('ramp_override', 'abscissa', 'a place on the link, metres along the axis; the nearer end of its edge is meant'),
    ('ramp_override', 'tangent', 'metres before and behind the bend into the lane; NULL: setting ramp_tangent'),
    ('ramp_override', 'length', 'metres that a merging lane keeps its width; 0: none; NULL: setting merging_length'),
    ('ramp_override', 'geom', 'its place: that of the axis at the abscissa; filled where left out'),
    ('ramp', 'ramp_id', 'key; kept while a ramp is at the node'),
    ('ramp', 'node_id', 'the node'),
    ('ramp', 'edge_id', 'the link'),
    ('ramp', 'edge_before', 'the highway before the node, in the direction of the ramp''s traffic'),
    ('ramp', 'edge_after', 'the highway behind it'),
    ('ramp', 'kind', 'on: traffic comes upon the highway; off: it leaves'),
    ('ramp', 'side', 'on which the ramp lies, left or right of the highway with its traffic'),
    ('ramp', 'lanes_before', 'lanes of the highway before the node in the direction of the ramp''s traffic, general '
        'and bus lanes'),
    ('ramp', 'lanes_ramp', 'lanes of the link'),
    ('ramp', 'lanes_after', 'lanes of the highway behind the node'),
    ('ramp', 'lanes_missing', 'merging lanes that are due: lanes that do not add up, at most those of the link; 0 '
        'where a number of lanes is estimated or merging lanes shall have no length'),
    ('ramp', 'lanes_merging', 'merging lanes that are there'),
    ('ramp', 'length', 'metres that they keep their width, from the limit on; 0: none'),
    ('ramp', 'taper', 'metres of taper wanted, by setting taper_ratio; 0: none'),
    ('ramp', 'tangent', 'metres before and behind the bend of the link into its lane, at least'),
    ('ramp', 'auxiliary', 'do they go on to those of the next ramp'),
    ('ramp', 'cut', 'does the next junction leave them less room than length and taper want'),
    ('ramp', 'short_link', 'is the link too short for its tangent'),
    ('ramp', 'geom', 'the node'),
    ('ramp', 'method', 'hypothesis: by settings; by_hand: by ramp_override'),
    ('ramp_path', 'interconnection_id', 'the interconnection'),
    ('ramp_path', 'ramp_id', 'the ramp'),
    ('ramp_path', 'kind', 'on or off the highway'),
    ('ramp_path', 'lane_in', 'lane that traffic comes by'),
    ('ramp_path', 'lane_out', 'lane that it goes on'),
    ('ramp_path', 'geom', 'the path') $$;
COMMENT ON FUNCTION streetgen._ramp_column() IS 'The columns of ramps, and what each is.';
