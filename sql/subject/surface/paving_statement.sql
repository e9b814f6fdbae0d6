-- View paving, by name: streetgen._part gives each.

--{paving
CREATE OR REPLACE VIEW paving WITH (security_invoker = true) AS
SELECT e.edge_id, a.paved AS roadway, coalesce(a.cycle_paved_left, a.paved) AS cycle_left,
    coalesce(a.cycle_paved_right, a.paved) AS cycle_right,
    coalesce({left}, a.sidewalk_paved_left) AS sidewalk_left,
    coalesce({right}, a.sidewalk_paved_right) AS sidewalk_right
FROM edge e JOIN axis a USING (axis_id)

--{paving_of_footway
(SELECT f.surface FROM sidewalk_source s JOIN footway f USING (footway_id)
    WHERE (s.edge_id, s.side) = (e.edge_id, '{side}') AND f.surface IS NOT NULL
    GROUP BY f.surface ORDER BY sum(s.end_abscissa - s.start_abscissa) DESC, f.surface LIMIT 1)
