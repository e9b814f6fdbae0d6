-- What a model holds: equal content, rows untouched.

-- All that is derived, by axis and place, without surrogate keys.
CREATE FUNCTION test.content(model name) RETURNS TABLE (content text) LANGUAGE plpgsql SET jit = off AS $$
BEGIN
  RETURN QUERY EXECUTE replace($q$
    SELECT concat_ws(' ', 'node', geom::text) FROM @.node
    UNION ALL SELECT concat_ws(' ', 'edge', e.axis_id, e.start_abscissa, e.end_abscissa, e.level, e.width, e.width_end, e.lanes_both, e.beside_left, e.beside_right, e.geom::text) FROM @.edge e
    UNION ALL SELECT concat_ws(' ', 'limit', e.axis_id, e.start_abscissa, l.which, l.wanted_abscissa, l.abscissa, l.method, l.border_line::text)
      FROM @.section_limit l JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'section', e.axis_id, e.start_abscissa, s.method, s.contested_area, s.surface::text) FROM @.section s JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'corner', a.axis_id, a.start_abscissa, k.end_a, b.axis_id, b.start_abscissa, k.end_b, k.radius_wanted, k.radius, k.method, k.arc::text)
      FROM @.corner k JOIN @.edge a ON a.edge_id = k.edge_a JOIN @.edge b ON b.edge_id = k.edge_b
    UNION ALL SELECT concat_ws(' ', 'lane', e.axis_id, e.start_abscissa, l.ordinality, l.lane_position, l.side, l.along_axis, l.both_ways, l.kind, l.width, l.axis_offset, l.turn, l.method, l.start_abscissa, l.end_abscissa, l.geom::text, l.surface::text)
      FROM @.lane l JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'separator', e.axis_id, e.start_abscissa, p.lane_position, p.kind, p.dashed, p.leftwards, p.rightwards, p.axis_offset, p.geom::text, p.surface::text)
      FROM @.lane_separator p JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'marking', e.axis_id, e.start_abscissa, m.lane_position, m.along_axis, m.kind, n.geom::text, m.geom::text, m.surface::text)
      FROM @.marking m JOIN @.edge e USING (edge_id) JOIN @.node n USING (node_id)
    UNION ALL SELECT concat_ws(' ', 'interconnection', n.geom::text, a.axis_id, a.start_abscissa, i.ordinality, c.along_in, b.axis_id, b.start_abscissa, o.ordinality, c.along_out, c.turn, c.angle, c.plausible, c.reason, c.connecting, c.method, c.control::text, c.geom::text)
      FROM @.interconnection c LEFT JOIN @.node n USING (node_id) JOIN @.lane i ON i.lane_id = c.lane_in JOIN @.edge a ON a.edge_id = i.edge_id JOIN @.lane o ON o.lane_id = c.lane_out JOIN @.edge b ON b.edge_id = o.edge_id
    UNION ALL SELECT concat_ws(' ', 'report', issue, axis_a, axis_b, measure, geom::text) FROM @.report
    UNION ALL SELECT concat_ws(' ', 'intersection', n.geom::text, i.method, i.contested_area, i.surface::text) FROM @.intersection i JOIN @.node n USING (node_id)$q$
    || CASE WHEN to_regclass(format('%I.lane_adjacency', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'adjacency', e.axis_id, e.start_abscissa, a.side, l.lane_position, a.change, a.by_hand)
      FROM @.lane_adjacency a JOIN @.lane l ON l.lane_id = a.lane_a JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.kerb', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'kerb', e.axis_id, e.start_abscissa, n.geom::text, k.level, k.side, k.part, k.method, k.beside, k.geom::text, k.curve IS NOT NULL, k.surface::text)
      FROM @.kerb k JOIN @.edge e USING (edge_id) LEFT JOIN @.node n USING (node_id)$q$ END
    || CASE WHEN to_regclass(format('%I.sidewalk', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'sidewalk', e.axis_id, e.start_abscissa, n.geom::text, s.side, s.part, s.width, s.method, s.surface::text)
      FROM @.sidewalk s JOIN @.edge e USING (edge_id) LEFT JOIN @.node n USING (node_id)$q$ END
    || CASE WHEN to_regclass(format('%I.sidewalk_source', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'sidewalk source', e.axis_id, e.start_abscissa, s.side, s.part, s.start_abscissa,
        s.end_abscissa, s.distance, s.width, array_to_string(s.places, ' '), array_to_string(s.widths, ' '), s.widest)
      FROM @.sidewalk_source s JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.street_area', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'area', a.kind, a.level, a.surface, a.geom::text) FROM @.street_area a$q$ END
    || CASE WHEN to_regclass(format('%I.area_surface', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'ground of area', a.kind, a.level, a.surface::text) FROM @.area_surface a$q$ END
    || CASE WHEN to_regclass(format('%I.street_track', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'track', e.axis_id, e.start_abscissa, t.part, t.start_abscissa, t.end_abscissa,
        t.borders)
      FROM @.street_track t JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.block', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'block', e.axis_id, e.start_abscissa, s.side, s.start_abscissa, b.kind, b.method, b.surface::text)
      FROM @.block b JOIN @.block_edge s ON (s.block_id, s.ordinality) = (b.block_id, 1) JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'block side', e.axis_id, e.start_abscissa, s.side, s.start_abscissa, s.end_abscissa, s.ring, s.ordinality, s.block_id IS NULL)
      FROM @.block_edge s JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.road', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'road', a.geom::text, b.geom::text, r.closed, r.length, ST_AsText(r.geom, 6))
      FROM @.road r JOIN @.node a ON a.node_id = r.from_node JOIN @.node b ON b.node_id = r.to_node
    UNION ALL SELECT concat_ws(' ', 'road_edge', e.axis_id, e.start_abscissa, f.axis_id, f.start_abscissa, m.position, m.along_road, m.start_abscissa)
      FROM @.road_edge m JOIN @.edge e USING (edge_id) JOIN @.road_edge first ON first.road_id = m.road_id AND first.position = 1 JOIN @.edge f ON f.edge_id = first.edge_id$q$ END
    || CASE WHEN to_regclass(format('%I.junction', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'junction', j.kind, j.method, j.geom::text, j.surface::text) FROM @.junction j
    UNION ALL SELECT concat_ws(' ', 'junction_node', n.geom::text, j.geom::text) FROM @.junction_node k JOIN @.node n USING (node_id) JOIN @.junction j USING (junction_id)
    UNION ALL SELECT concat_ws(' ', 'junction_edge', e.axis_id, e.start_abscissa, k.role, j.geom::text) FROM @.junction_edge k JOIN @.edge e USING (edge_id) JOIN @.junction j USING (junction_id)
    UNION ALL SELECT concat_ws(' ', 'junction_movement', a.axis_id, a.start_abscissa, i.ordinality, m.along_in, b.axis_id, b.start_abscissa, o.ordinality, m.along_out, m.turn, m.angle, m.plausible, m.reason, m.connecting, cardinality(m.interconnections), m.geom::text)
      FROM @.junction_movement m JOIN @.lane i ON i.lane_id = m.lane_in JOIN @.edge a ON a.edge_id = i.edge_id JOIN @.lane o ON o.lane_id = m.lane_out JOIN @.edge b ON b.edge_id = o.edge_id$q$ END
    || CASE WHEN to_regclass(format('%I.roundabout', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'roundabout', e.axis_id, e.start_abscissa, r.along_axis, r.level, r.kind, r.radius, r.score, r.term_shape, r.term_name, r.term_network, r.accepted, r.method, r.centre::text, r.geom::text, r.island::text)
      FROM @.roundabout r JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'roundabout_edge', e.axis_id, e.start_abscissa, x.along_axis, x.face, x.ordinality, r.centre::text) FROM @.roundabout_edge x JOIN @.edge e USING (edge_id) JOIN @.roundabout r USING (roundabout_id)
    UNION ALL SELECT concat_ws(' ', 'roundabout_arm', e.axis_id, e.start_abscissa, x.along_axis, n.geom::text, r.centre::text)
      FROM @.roundabout_arm x JOIN @.edge e USING (edge_id) JOIN @.node n USING (node_id) JOIN @.roundabout r USING (roundabout_id)$q$ END
    || CASE WHEN to_regclass(format('%I.ramp', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'ramp', n.geom::text, e.axis_id, e.start_abscissa, r.kind, r.side, lanes_before, lanes_ramp, lanes_after, lanes_missing, lanes_merging, r.length, taper, tangent, auxiliary, cut, short_link, r.method, r.geom::text)
      FROM @.ramp r JOIN @.edge e USING (edge_id) JOIN @.node n USING (node_id)$q$ END
    || CASE WHEN to_regclass(format('%I.overpass', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'overpass', a.axis_id, a.start_abscissa, o.abscissa_above, b.axis_id, b.start_abscissa, o.abscissa_below, o.ordinality, o.clearance, o.method, o.geom::text)
      FROM @.overpass o JOIN @.edge a ON a.edge_id = o.edge_above JOIN @.edge b ON b.edge_id = o.edge_below$q$ END
    || CASE WHEN to_regclass(format('%I.profile', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'profile', e.axis_id, e.start_abscissa, p.grade_max, p.method, p.geom::text) FROM @.profile p JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.controller', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'controller', program, cycle, start_offset, method, geom::text) FROM @.controller
    UNION ALL SELECT concat_ws(' ', 'signal_state', c.geom::text, ordinality, duration, kind) FROM @.signal_state JOIN @.controller c USING (controller_id)
    UNION ALL SELECT concat_ws(' ', 'signal_movement', c.geom::text, m.ordinality, a.axis_id, a.start_abscissa, i.ordinality, m.along_in, b.axis_id, b.start_abscissa, o.ordinality, m.along_out, m.right_of_way, m.precedence, m.signal_group)
      FROM @.signal_movement m JOIN @.controller c USING (controller_id) JOIN @.lane i ON i.lane_id = m.lane_in JOIN @.edge a ON a.edge_id = i.edge_id JOIN @.lane o ON o.lane_id = m.lane_out JOIN @.edge b ON b.edge_id = o.edge_id
    UNION ALL SELECT concat_ws(' ', 'signal_group', c.geom::text, signal_group, g.kind, a.axis_id, a.start_abscissa, control_point_id, clear) FROM @.signal_group g JOIN @.controller c USING (controller_id) JOIN @.edge a USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'intergreen', c.geom::text, ends, begins, seconds) FROM @.intergreen JOIN @.controller c USING (controller_id)
    UNION ALL SELECT concat_ws(' ', 'signal_head', e.axis_id, e.start_abscissa, l.ordinality, h.along_axis, h.angle, h.geom::text) FROM @.signal_head h JOIN @.lane l USING (lane_id) JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.street_object', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'object', type, placement, axis_id, abscissa, side, axis_offset, o.angle, method,
        placed_by, o.rule_id, o.rule_place, o.geom::text, c.width, c.angle, c.painted_as, c.kerb_left, c.kerb_right,
        c.surface::text, c.stripes::text, c.island::text, b.angle, b.surface::text) FROM @.street_object o LEFT JOIN
        @.pedestrian_crossing c USING (street_object_id)
      LEFT JOIN @.parking_bay b USING (street_object_id)$q$ END
    || CASE WHEN to_regclass(format('%I.kerb_distance', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'kerb distance', e.axis_id, e.start_abscissa, k.side, k.observations, k.mean,
        k.median, k.geom::text) FROM @.kerb_distance k JOIN @.edge e USING (edge_id)$q$ END
    || CASE WHEN to_regclass(format('%I.bridge', model)) IS NULL THEN '' ELSE $q$
    UNION ALL SELECT concat_ws(' ', 'bridge', e.axis_id, e.start_abscissa, b.start_abscissa, b.end_abscissa, b.method, b.surface::text) FROM @.bridge b JOIN @.edge e USING (edge_id)
    UNION ALL SELECT concat_ws(' ', 'tunnel', e.axis_id, e.start_abscissa, b.start_abscissa, b.end_abscissa, b.method, b.surface::text) FROM @.tunnel b JOIN @.edge e USING (edge_id)$q$ END,
    '@', quote_ident(model));
END $$;

-- Whether two models hold equal content.
CREATE FUNCTION test.same(a name, b name) RETURNS boolean LANGUAGE sql SET jit = off AS $$
  SELECT NOT EXISTS ((SELECT test.content(a) EXCEPT ALL SELECT test.content(b))
                     UNION ALL (SELECT test.content(b) EXCEPT ALL SELECT test.content(a)))
$$;

-- Whether two rows of content are equal within a millimetre: numbers, lines and, times its perimeter, surfaces.
CREATE FUNCTION test.alike(a text, b text) RETURNS boolean LANGUAGE sql IMMUTABLE AS $$
  SELECT cardinality(p) = cardinality(q) AND (
    SELECT bool_and(CASE WHEN x = y THEN true
      WHEN x ~ '^-?[0-9.]+(e-?[0-9]+)?$' AND y ~ '^-?[0-9.]+(e-?[0-9]+)?$' AND length(x) < 30 THEN abs(x::float8 - y::float8) <= 1e-3
      WHEN NOT (x ~ '^[0-9A-F]{40,}$' AND y ~ '^[0-9A-F]{40,}$') THEN false
      WHEN ST_Dimension(x::geometry) = 2 THEN ST_Area(ST_SymDifference(x::geometry, y::geometry)) <= 1e-3 * ST_Perimeter(y::geometry)
      ELSE ST_HausdorffDistance(x::geometry, y::geometry) <= 1e-3 END)
    FROM unnest(p, q) u(x, y))
  FROM (SELECT string_to_array(a, ' '), string_to_array(b, ' ')) s(p, q)
$$;

-- Fills another model with the settings, axes, overrides and objects of a model, and generates it from scratch: what rules place is not copied.
CREATE FUNCTION test.generate_anew(model name, anew name) RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  -- Axes first: those that come by take overrides along.
  inputs name[] := ARRAY(SELECT relname FROM pg_class WHERE relnamespace = quote_ident(model)::regnamespace AND
      relkind = 'r' AND (relname IN ('setting', 'axis', 'turn_restriction', 'control_point', 'footway',
      'footway_kerb', 'rail_track', 'street_area', 'observation') OR relname LIKE '%\_override')
      AND to_regclass(format('%I.%I', anew, relname)) IS NOT NULL ORDER BY relname = 'axis' DESC);
  input name;
  with_objects constant boolean := to_regclass(format('%I.street_object', anew)) IS NOT NULL;
BEGIN
  PERFORM set_config('streetgen.live', 'off', true), set_config('streetgen.computes', 'on', true);
  IF with_objects THEN
    EXECUTE format('DELETE FROM %1$I.street_object; DELETE FROM %1$I.placement_rule; DELETE FROM %1$I.free_place', anew);
  END IF;
  PERFORM set_config('streetgen.computes', '', true);
  FOR i IN REVERSE cardinality(inputs) .. 1 LOOP
    EXECUTE format('DELETE FROM %I.%I', anew, inputs[i]);
  END LOOP;
  FOREACH input IN ARRAY inputs LOOP
    EXECUTE format('INSERT INTO %2$I.%3$I SELECT * FROM %1$I.%3$I', model, anew, input);
  END LOOP;
  IF with_objects THEN
    PERFORM set_config('streetgen.computes', 'on', true);
    EXECUTE format($sql$INSERT INTO %2$I.object_type SELECT * FROM %1$I.object_type ON CONFLICT (type) DO UPDATE SET distance_least = excluded.distance_least;
      INSERT INTO %2$I.placement_rule SELECT * FROM %1$I.placement_rule;
      INSERT INTO %2$I.free_place SELECT * FROM %1$I.free_place;
      INSERT INTO %2$I.street_object SELECT * FROM %1$I.street_object WHERE placed_by <> 'rule';
      INSERT INTO %2$I.pedestrian_crossing SELECT c.* FROM %1$I.pedestrian_crossing c JOIN %1$I.street_object USING (street_object_id) WHERE placed_by <> 'rule';
      INSERT INTO %2$I.parking_bay SELECT b.* FROM %1$I.parking_bay b JOIN %1$I.street_object USING (street_object_id) WHERE placed_by <> 'rule';
      SELECT setval(pg_get_serial_sequence('%2$I.street_object', 'street_object_id'), max(street_object_id)) FROM %1$I.street_object$sql$, model, anew);
    PERFORM set_config('streetgen.computes', '', true);
  END IF;
  PERFORM set_config('streetgen.live', '', true);
  EXECUTE format('SELECT FROM streetgen.generate(%L, ARRAY(SELECT axis_id FROM %I.axis), wait => true)', anew, anew);
END $$;

-- What check_model finds of a model that is no error of its input, as roads that cross in turn too near for the clearance are.
-- Without notices: a slow machine is told how far check_model is.
CREATE FUNCTION test.faults(model name) RETURNS SETOF text LANGUAGE plpgsql SET client_min_messages = warning AS $$
BEGIN
  RETURN QUERY SELECT concat_ws(' ', rule, relation_of, id) FROM streetgen.check_model(model) c(severity, rule, relation_of, id)
    WHERE severity = 'error' AND rule <> 'clearance not kept, m' OR rule LIKE 'stale%' OR rule = 'not_generated';
END $$;

-- Are the streets of a model those that a run from scratch over the same input gives, with nothing left to do?
CREATE FUNCTION test.followed(model name, anew name) RETURNS boolean LANGUAGE plpgsql AS $$
BEGIN
  PERFORM test.generate_anew(model, anew);
  RETURN test.same(model, anew) AND NOT EXISTS (SELECT FROM test.faults(model));
END $$;

-- The same within a millimetre, as after many edits: where the far end of a side moved, what crosses it may lie a step of the grid aside. NULL: yes; else what differs.
CREATE FUNCTION test.difference(model name, anew name) RETURNS text LANGUAGE plpgsql VOLATILE SET jit = off AS $$
DECLARE
  differs text;
BEGIN
  PERFORM test.generate_anew(model, anew);
  WITH all_edited AS MATERIALIZED (SELECT test.content(model) AS content), all_scratch AS MATERIALIZED (SELECT test.content(anew) AS content),
    edited AS (TABLE all_edited EXCEPT ALL TABLE all_scratch), scratch AS (TABLE all_scratch EXCEPT ALL TABLE all_edited)
  SELECT string_agg(format('%s: %s', side, left(content, 300)), E'\n') INTO differs FROM (
    (SELECT 'only edited' AS side, content FROM edited e WHERE NOT EXISTS (SELECT FROM scratch s WHERE test.alike(e.content, s.content)) ORDER BY content LIMIT 3)
    UNION ALL (SELECT 'only from scratch', content FROM scratch s WHERE NOT EXISTS (SELECT FROM edited e WHERE test.alike(e.content, s.content)) ORDER BY content LIMIT 3)
    UNION ALL (SELECT 'check_model', fault FROM test.faults(model) fault LIMIT 3)) d;
  RETURN differs;
END $$;

-- Place and writer of every row of a model: equal as long as nothing was written.
CREATE FUNCTION test.rows(model name) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  result text := '';
  part text;
  t text;
BEGIN
  FOREACH t IN ARRAY ARRAY['node', 'edge', 'section_limit', 'section', 'corner', 'intersection', 'lane', 'lane_separator', 'marking', 'report'] LOOP
    EXECUTE format('SELECT md5(string_agg(concat(ctid, xmin), '','' ORDER BY ctid)) FROM %I.%I', model, t) INTO part;
    result := result || t || coalesce(part, '-');
  END LOOP;
  RETURN result;
END $$;
