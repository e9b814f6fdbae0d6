-- Parts of the views of the fit, by name: streetgen._part gives each.

--{observation_unused
CREATE OR REPLACE VIEW observation_unused WITH (security_invoker = true) AS
SELECT observation_id, kind, why, points, source, source_ref, geom::geometry(MultiPoint, {srid})
FROM streetgen._unused_observations({model})

--{fit_change
CREATE OR REPLACE VIEW fit_change WITH (security_invoker = true) AS
SELECT p.fit_proposal_id, p.fit_run, p.axis_id, (n.width + n.width_end - u.width - u.width_end) / 2 AS wider,
    streetgen._fit_arrows(ST_Force2D(a.geom), ST_Force2D(p.geom),
        ARRAY[u.roadway_offset + u.width / 2, u.roadway_offset + u.width_end / 2, u.roadway_offset - u.width / 2,
            u.roadway_offset - u.width_end / 2],
        ARRAY[n.roadway_offset + n.width / 2, n.roadway_offset + n.width_end / 2, n.roadway_offset - n.width / 2,
            n.roadway_offset - n.width_end / 2])::geometry(MultiLineString, {srid}) AS geom
FROM fit_proposal p JOIN axis a USING (axis_id) JOIN axis_used u USING (axis_id), LATERAL (
    SELECT coalesce(p.width, u.width) AS width, coalesce(p.width_end, p.width, u.width_end) AS width_end,
        coalesce(p.roadway_offset, u.roadway_offset) AS roadway_offset) n
WHERE p.state = 'proposed'

--{trained_radius
CREATE OR REPLACE FUNCTION {function}(width float8, speed float8, importance integer, lane_count integer, kind text)
    RETURNS float8 LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE COST 1000 SET search_path = pg_catalog
    AS {body}

--{trained_radius_body
DECLARE
    forest constant float8[] := {forest};
    kinds constant text[] := {kinds};
BEGIN
    IF num_nulls(width, speed, importance, lane_count) > 0 THEN
        RETURN NULL;
    END IF;
    RETURN streetgen.forest_value(forest, ARRAY[width, speed, importance, lane_count,
        coalesce(array_position(kinds, kind), 0)]);
END
