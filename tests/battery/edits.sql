-- Random towns, which tests/battery/edits runs, edited statement by statement, against the same axes and overrides generated from scratch.
CREATE SCHEMA edits;

-- A script: settings, the rows that the town begins with, the statements that edit it.
CREATE TYPE edits.script AS (settings text[], axes text[], statements text[]);

CREATE TABLE edits.town (name text PRIMARY KEY);
COMMENT ON TABLE edits.town IS 'Models whose axes, about a random place, begin scripts too';

CREATE FUNCTION edits.chance(likely float8) RETURNS boolean LANGUAGE sql VOLATILE RETURN random() < likely;

CREATE FUNCTION edits.between(low float8, high float8) RETURNS float8 LANGUAGE sql VOLATILE RETURN round((low + (high - low) * random())::numeric, 2)::float8;

CREATE FUNCTION edits.one_of(VARIADIC words text[]) RETURNS text LANGUAGE sql VOLATILE RETURN words[1 + floor(random() * cardinality(words))::integer];

-- Axis by its place in the order of keys: nothing else of a table is the same twice.
CREATE FUNCTION edits.axis() RETURNS edited.axis LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  found edited.axis;
BEGIN
  SELECT * INTO found FROM edited.axis ORDER BY axis_id OFFSET floor(random() * (SELECT count(*) FROM edited.axis)) LIMIT 1;
  RETURN found;
END $$;

-- A place to draw to: a vertex that is there, one near it, or anywhere about.
CREATE FUNCTION edits.place() RETURNS geometry LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  near geometry := (edits.axis()).geom;
  vertex geometry := coalesce(ST_PointN(near, 1 + floor(random() * ST_NPoints(near))::integer), 'SRID=2154;POINT(650000 6860000)');
  off float8 := CASE floor(random() * 6)::integer WHEN 0 THEN 0 WHEN 1 THEN 0 WHEN 2 THEN 0.3 WHEN 3 THEN 1.5 WHEN 4 THEN 12 ELSE 60 END;
BEGIN
  RETURN ST_Translate(vertex, edits.between(-off, off), edits.between(-off, off));
END $$;

-- A place on a street or beside it.
CREATE FUNCTION edits.place_beside(line geometry) RETURNS geometry LANGUAGE sql VOLATILE
  RETURN ST_Translate(ST_LineInterpolatePoint(line, edits.between(0, 1)), edits.between(-9, 9), edits.between(-9, 9));

CREATE FUNCTION edits.value_of(attribute text) RETURNS text LANGUAGE sql VOLATILE AS $$
  SELECT CASE attribute
    WHEN 'width' THEN quote_nullable(CASE WHEN edits.chance(0.9) THEN edits.between(2.5, 22) END)
    WHEN 'width_end' THEN quote_nullable(CASE WHEN edits.chance(0.7) THEN edits.between(3, 20) END)
    WHEN 'roadway_offset' THEN edits.one_of('NULL', '0', '-1.5', '2', '5', '-8')
    WHEN 'level' THEN edits.one_of('0', '0', '0', '1', '-1')
    WHEN 'direction' THEN quote_literal(edits.one_of('both', 'direct', 'reverse'))
    WHEN 'importance' THEN edits.one_of('NULL', '1', '2', '3', '4', '5')
    WHEN 'speed' THEN edits.one_of('NULL', '30', '50', '90')
    WHEN 'lane_count' THEN edits.one_of('NULL', '1', '2', '3', '4')
    WHEN 'lanes_both' THEN edits.one_of('NULL', '1', '2')
    WHEN 'radius' THEN edits.one_of('NULL', '0', '4', '15')
    WHEN 'kind' THEN quote_nullable(edits.one_of('residential', 'primary', 'service', 'motorway', 'motorway_link', NULL))
    WHEN 'change_forward' THEN quote_nullable(edits.one_of('no|yes', 'yes|not_left', 'only_right', 'not_right||no', NULL))
    WHEN 'change_backward' THEN quote_nullable(edits.one_of('no|no', 'only_left|', 'yes|only_right|no', NULL))
    WHEN 'kind_forward' THEN quote_nullable(edits.one_of('general', 'general|cycle', 'bus|general|parking', NULL))
    WHEN 'access' THEN quote_nullable(edits.one_of('bus', 'no', '|cycle', 'private', NULL, NULL))
    WHEN 'lane_markings' THEN edits.one_of('NULL', $q$'no'$q$, $q$'yes'$q$)
    WHEN 'parking_right' THEN quote_nullable(edits.one_of('street_side', 'on_kerb|diagonal', 'half_on_kerb||2.4|5', 'no', NULL))
    WHEN 'turn_forward' THEN quote_nullable(edits.one_of('left|through', 'through;right', NULL))
    WHEN 'roundabout_tag' THEN edits.one_of('NULL', 'NULL', $q$'roundabout'$q$, $q$'circular'$q$)
    WHEN 'sidewalk_left' THEN edits.one_of('NULL', '0', '1.5', '4')
    WHEN 'sidewalk_right' THEN edits.one_of('NULL', '0', '1.5', '4')
    WHEN 'sidewalk_apart' THEN edits.one_of('NULL', $q$'left'$q$, $q$'both'$q$)
    WHEN 'strips_right' THEN edits.one_of('NULL', $q$'verge 1.5|cycle_track 2'$q$, $q$'two_way_cycle_track'$q$)
    WHEN 'paved' THEN edits.one_of('NULL', $q$'sett'$q$)
    WHEN 'name' THEN quote_literal(edits.between(0, 9)) END $$;

CREATE FUNCTION edits.attribute() RETURNS text LANGUAGE sql VOLATILE
  RETURN edits.one_of('width', 'width', 'width', 'width_end', 'roadway_offset', 'roadway_offset', 'level', 'direction', 'importance', 'speed', 'lane_count', 'lanes_both', 'radius', 'roundabout_tag', 'sidewalk_left', 'sidewalk_right', 'kind', 'kind_forward', 'access', 'parking_right', 'lane_markings', 'sidewalk_apart', 'strips_right', 'paved', 'turn_forward', 'change_forward', 'change_backward', 'name');

CREATE FUNCTION edits.drawn_row(axis_id bigint, geom geometry) RETURNS text LANGUAGE sql VOLATILE AS $$
  SELECT format('(%s, %L, %s, %s, %s, %s)', axis_id, ST_AsEWKT(geom), edits.value_of('width'), edits.value_of('level'), edits.value_of('direction'), edits.value_of('importance')) $$;

CREATE FUNCTION edits.inserted(rows text) RETURNS text LANGUAGE sql VOLATILE RETURN 'INSERT INTO edited.axis (axis_id, geom, width, level, direction, importance) VALUES ' || rows;

CREATE FUNCTION edits.drawn(axis_id bigint, geom geometry) RETURNS text LANGUAGE sql VOLATILE RETURN edits.inserted(edits.drawn_row(axis_id, geom));

-- A line over an axis.
CREATE FUNCTION edits.way_across(axis geometry) RETURNS geometry LANGUAGE sql VOLATILE AS $$
  SELECT ST_MakeLine(ST_Translate(place, -x, -y), ST_Translate(place, x, y)) FROM (SELECT ST_LineInterpolatePoint(axis, edits.between(0, 1)) AS place, edits.between(-12, 12) AS x, edits.between(3, 12) AS y) v $$;

-- One edit of what stands at streets.
CREATE FUNCTION edits.object_edit(a edited.axis) RETURNS text[] LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  edit text := edits.one_of('object', 'object', 'object', 'stretch', 'move object', 'no object', 'crossing',
      'crossing', 'bay', 'rule', 'rule', 'rule', 'other rule', 'distance', 'footway', 'footway', 'footway',
      'move footway', 'no footway', 'footway kerb', 'footway kerb', 'other footway kerb', 'area', 'area',
      'area of roadway', 'area of roadway', 'other area', 'track', 'track', 'track', 'move track', 'no track',
      'fit', 'fit', 'fit corners', 'fit corners');
  other record;
BEGIN
  CASE edit
    WHEN 'object' THEN
      RETURN ARRAY[format('INSERT INTO edited.street_object_editing (type, geom, orientation) VALUES (%L, %L, %s)', edits.one_of('lamp', 'tree', 'bench', 'manhole', 'crossing', 'parking_bay'), ST_AsEWKT(edits.place_beside(a.geom)), edits.one_of('NULL', '0', '45', '-90'))];
    WHEN 'stretch' THEN
      RETURN ARRAY[format('INSERT INTO edited.street_object (type, placement, axis_id, abscissa, abscissa_end, side, axis_offset) VALUES (%L, %L, %s, %s, %s, %L, %s)', edits.one_of('hedge', 'guard_rail'), edits.one_of('axis', 'border'),
                          a.axis_id, edits.between(0, 0.4) * ST_Length(a.geom), edits.between(0.5, 1) * ST_Length(a.geom), edits.one_of('left', 'right'), edits.one_of('0', '0.5', '-1', '2'))];
    WHEN 'move object', 'no object' THEN
      SELECT o.geom, o.type INTO other FROM edited.street_object_editing o ORDER BY ST_X(o.geom), ST_Y(o.geom), o.type OFFSET floor(random() * (SELECT count(*) FROM edited.street_object_editing)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format(CASE edit WHEN 'no object' THEN 'DELETE FROM edited.street_object_editing' ELSE 'UPDATE edited.street_object_editing SET geom = %3$L' END || ' WHERE type = %2$L AND ST_DWithin(geom, %1$L, 0.001)',
                            ST_AsEWKT(other.geom), other.type, ST_AsEWKT(CASE WHEN edits.chance(0.5) THEN edits.place_beside(a.geom) ELSE ST_Translate(other.geom, edits.between(-5, 5), edits.between(-5, 5)) END))];
      END IF;
    WHEN 'footway' THEN
      RETURN ARRAY[format('INSERT INTO edited.footway (geom, kind, role, marking, width, level) VALUES (%L, %L, %s, %s, %s, %s)', ST_AsEWKT(CASE WHEN edits.chance(0.2) THEN ST_MakeLine(edits.place(), edits.place_beside(a.geom))
        WHEN edits.chance(0.4) THEN edits.way_across(a.geom) ELSE ST_Translate(ST_LineSubstring(a.geom, edits.between(0, 0.4),
        edits.between(0.5, 1)), edits.between(-12, 12), edits.between(-12, 12)) END), edits.one_of('footway', 'footway', 'cycleway', 'steps'), edits.one_of($q$'sidewalk'$q$, $q$'sidewalk'$q$, $q$'crossing'$q$, 'NULL'), edits.one_of('NULL', $q$'ladder'$q$, $q$'no'$q$), edits.one_of('NULL', 'NULL', '1.8'), edits.one_of('0', '0', '0', '1'))];
    WHEN 'footway kerb' THEN
      RETURN ARRAY[format('INSERT INTO edited.footway_kerb (geom, kerb) VALUES (%L, %L)', ST_AsEWKT(edits.place_beside(a.geom)), edits.one_of('raised', 'lowered', 'no'))];
    WHEN 'area' THEN
      RETURN ARRAY[format('INSERT INTO edited.street_area (geom, kind, level) VALUES (%L, %L, %s)',
        ST_AsEWKT(ST_Multi(ST_Expand(edits.place_beside(a.geom), edits.between(1, 25), edits.between(1, 25)))),
        edits.one_of('square', 'square', 'parking_area', 'walk', 'roadway'), edits.one_of('0', '0', '1'))];
    WHEN 'area of roadway' THEN
      -- A width by hand stays.
      RETURN ARRAY[format('UPDATE edited.axis SET width = NULL, width_end = NULL, roadway_offset = NULL WHERE axis_id = %s', a.axis_id),
        format('INSERT INTO edited.street_area (geom, kind, level) VALUES (%L, ''roadway'', %s)', ST_AsEWKT(
          ST_Multi(ST_Buffer(ST_Translate(ST_Force2D(ST_LineSubstring(a.geom, edits.between(0, 0.4),
          edits.between(0.5, 1))), edits.between(-3, 3), edits.between(-3, 3)), edits.between(2, 9), 'endcap=flat'))),
        edits.one_of('0', '0', '0', '1'))];
    WHEN 'other area' THEN
      RETURN ARRAY[edits.one_of($q$UPDATE edited.street_area SET kind = 'platform', geom = ST_Translate(geom, 2, 1)$q$,
        'DELETE FROM edited.street_area')];
    WHEN 'other footway kerb' THEN
      RETURN ARRAY[edits.one_of($q$UPDATE edited.footway_kerb SET kerb = 'rolled', geom = ST_Translate(geom, 1, 1)$q$, 'DELETE FROM edited.footway_kerb')];
    WHEN 'move footway', 'no footway' THEN
      SELECT f.geom INTO other FROM edited.footway f ORDER BY ST_X(ST_StartPoint(f.geom)), ST_Y(ST_StartPoint(f.geom)), ST_Length(f.geom) OFFSET floor(random() * (SELECT count(*) FROM edited.footway)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format(CASE edit WHEN 'no footway' THEN 'DELETE FROM edited.footway' ELSE edits.one_of('UPDATE edited.footway SET geom = ST_Translate(geom, 1.5, -0.7)', $q$UPDATE edited.footway SET role = 'sidewalk'$q$) END
                            || ' WHERE ST_Equals(geom, %L)', ST_AsEWKT(other.geom))];
      END IF;
    WHEN 'fit' THEN
      -- Observed kerbs, accepted and perhaps undone; distances to those that stay follow later edits.
      RETURN ARRAY[format('INSERT INTO edited.observation (geom) VALUES (%L), (%L)', ST_AsEWKT(ST_Translate(ST_Force2D(
          a.geom), edits.between(-7, 7), edits.between(-7, 7))), ST_AsEWKT(ST_Translate(ST_Force2D(a.geom),
          edits.between(-5, 5), edits.between(-5, 5)))), format('SELECT streetgen.accept_fit(%L, fit_run) FROM '
          'streetgen.fit(%1$L, options => %2$L)', 'edited', format('{"moves": "%s"}', edits.one_of('roadway', 'axis')))]
        || CASE WHEN edits.chance(0.4) THEN ARRAY['SELECT streetgen.undo_fit(''edited'', max(fit_run)) FROM '
          'edited.fit_run'] ELSE '{}' END
        || CASE WHEN edits.chance(0.3) THEN ARRAY['DELETE FROM edited.observation'] ELSE '{}' END;
    WHEN 'fit corners' THEN
      -- Arcs of other radii, near corners of the axis.
      RETURN ARRAY[format('INSERT INTO edited.observation (geom) SELECT ST_Scale(ST_CurveToLine(c.arc), '
          'ST_MakePoint(%s, %1$s), c.centre) FROM edited.corner c JOIN edited.edge e ON e.edge_id IN (c.edge_a, '
          'c.edge_b) WHERE e.axis_id = %s AND c.arc IS NOT NULL', edits.between(0.7, 1.4), a.axis_id),
        format('SELECT streetgen.accept_fit(%L, fit_run) FROM streetgen.fit(%1$L, options => %L)', 'edited',
          '{"moves": "corner"}')]
        || CASE WHEN edits.chance(0.4) THEN ARRAY['SELECT streetgen.undo_fit(''edited'', max(fit_run)) FROM '
          'edited.fit_run'] ELSE '{}' END
        || CASE WHEN edits.chance(0.3) THEN ARRAY['DELETE FROM edited.observation'] ELSE '{}' END;
    WHEN 'track' THEN
      RETURN ARRAY[format('INSERT INTO edited.rail_track (geom, tracks, level) VALUES (%L, %s, %s)', ST_AsEWKT(CASE
          WHEN edits.chance(0.3) THEN ST_MakeLine(ARRAY[edits.place(), edits.place_beside(a.geom), edits.place()])
        WHEN edits.chance(0.3) THEN edits.way_across(a.geom) ELSE ST_Translate(a.geom, edits.between(-9, 9),
            edits.between(-9, 9)) END), edits.one_of('1', '1', '2'), edits.one_of('0', '0', '0', '1'))];
    WHEN 'move track', 'no track' THEN
      SELECT t.geom INTO other FROM edited.rail_track t ORDER BY ST_X(ST_StartPoint(t.geom)),
          ST_Y(ST_StartPoint(t.geom)), ST_Length(t.geom) OFFSET floor(random() * (SELECT count(*) FROM
          edited.rail_track)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format(CASE edit WHEN 'no track' THEN 'DELETE FROM edited.rail_track' ELSE
            edits.one_of('UPDATE edited.rail_track SET geom = ST_Translate(geom, 1.5, -0.7)',
            'UPDATE edited.rail_track SET tracks = 2') END || ' WHERE ST_Equals(geom, %L)', ST_AsEWKT(other.geom))];
      END IF;
    WHEN 'crossing' THEN
      RETURN ARRAY[format('INSERT INTO edited.pedestrian_crossing_editing (geom, width, angle, refuge) '
          'VALUES (%L, %s, %s, %s)', ST_AsEWKT(ST_LineInterpolatePoint(a.geom, edits.between(0, 1))), edits.between(2, 6), edits.one_of('90', '90', '60', '125'), edits.one_of('NULL', '1.2', '2'))];
    WHEN 'bay' THEN
      RETURN ARRAY[format('INSERT INTO edited.parking_bay_editing (geom, angle) VALUES (%L, %s)', ST_AsEWKT(edits.place_beside(a.geom)), edits.one_of('0', '60', '90'))];
    WHEN 'rule' THEN
      RETURN ARRAY[format('INSERT INTO edited.placement_rule (type, along, side, every, phase, axis_offset, orientation, distance_from_limit, importance_from, density) VALUES (%s, %L, %s, %s, %s, %s, %s, %s, %s)',
                          CASE WHEN edits.chance(0.2) THEN $q$'parking_bay', 'lane'$q$
                            ELSE format('%L, %L', edits.one_of('lamp', 'tree', 'bollard', 'crossing', 'parking_bay'), edits.one_of('border', 'border', 'axis', 'arm', 'corner')) END, edits.one_of('left', 'right', 'both', 'alternating'), edits.one_of('6', '9', '25'),
                          edits.between(0, 9), edits.one_of('0', '0.8', '-1'), edits.one_of('0', '60', '90'), edits.one_of('0', '2.5', '5'), edits.one_of('NULL', 'NULL', '3'), edits.one_of('1', '1', '0.5'))];
    WHEN 'other rule' THEN
      RETURN ARRAY[edits.one_of('UPDATE edited.placement_rule SET phase = phase + 1', 'UPDATE edited.placement_rule SET every = every + 2', 'UPDATE edited.placement_rule SET active = NOT active', $q$DELETE FROM edited.placement_rule WHERE type = 'lamp'$q$, 'DELETE FROM edited.free_place')];
    WHEN 'distance' THEN
      RETURN ARRAY[format('UPDATE edited.object_type SET distance_least = %s WHERE type = %L', edits.one_of('0', '3', '8'), edits.one_of('lamp', 'tree', 'bollard'))];
  END CASE;
  RETURN '{}';
END $$;

-- One edit about junctions: what stands before them, what somebody decides of them, carriageways and ramps that make them.
CREATE FUNCTION edits.junction_edit(a edited.axis) RETURNS text[] LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  edit text := edits.one_of('control', 'control', 'move control', 'no control', 'kind', 'kind', 'inside', 'inside', 'no decision', 'carriageway', 'ramp', 'ramp', 'decide ramp', 'decide ramp', 'change', 'change', 'no change',
    'duration', 'duration');
  fresh bigint := coalesce((SELECT max(axis_id) FROM edited.axis), 0) + 1;
  other record;
  beside geometry;
BEGIN
  CASE edit
    WHEN 'control' THEN
      RETURN ARRAY[format('INSERT INTO edited.control_point (geom, kind, direction) VALUES (%L, %L, %s)', ST_AsEWKT(CASE floor(random() * 3)::integer WHEN 0 THEN ST_StartPoint(a.geom) WHEN 1 THEN ST_EndPoint(a.geom) ELSE edits.place_beside(a.geom) END),
                          edits.one_of('signals', 'signals', 'stop', 'yield', 'mini_roundabout', 'pedestrian_crossing'), edits.one_of('NULL', 'NULL', $q$'direct'$q$, $q$'reverse'$q$, $q$'both'$q$))];
    WHEN 'move control', 'no control' THEN
      SELECT control_point_id, geom INTO other FROM edited.control_point ORDER BY ST_X(geom), ST_Y(geom), kind, direction OFFSET floor(random() * (SELECT count(*) FROM edited.control_point)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format(CASE edit WHEN 'no control' THEN 'DELETE FROM edited.control_point' ELSE 'UPDATE edited.control_point SET geom = %2$L' END || ' WHERE ST_DWithin(geom, %1$L, 0.001)', ST_AsEWKT(other.geom), ST_AsEWKT(edits.place_beside(a.geom)))];
      END IF;
    WHEN 'kind' THEN
      SELECT geom INTO other FROM edited.junction ORDER BY ST_X(geom), ST_Y(geom) OFFSET floor(random() * (SELECT count(*) FROM edited.junction)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('UPDATE edited.junction_editing SET kind = %L WHERE ST_DWithin(geom, %L, 0.001)', edits.one_of('signals', 'stop', 'priority', 'right_before_left', 'end'), ST_AsEWKT(other.geom))];
      END IF;
    WHEN 'inside' THEN
      RETURN ARRAY[format('UPDATE edited.junction_edge_editing SET inside = %s WHERE edge_id IN (SELECT edge_id FROM edited.edge WHERE axis_id = %s ORDER BY start_abscissa LIMIT 1)', edits.one_of('true', 'false'), a.axis_id)];
    WHEN 'no decision' THEN
      RETURN ARRAY[edits.one_of('DELETE FROM edited.junction_editing WHERE by_hand', 'UPDATE edited.junction_edge_editing SET by_hand = false WHERE by_hand', format('DELETE FROM edited.junction_override WHERE axis_id = %s', a.axis_id))];
    WHEN 'carriageway' THEN
      beside := ST_OffsetCurve(a.geom, edits.between(9, 25));
      IF ST_GeometryType(beside) = 'ST_LineString' AND NOT ST_IsEmpty(beside) THEN
        RETURN ARRAY[format($q$UPDATE edited.axis SET direction = 'direct', name = 'avenue' WHERE axis_id = %s$q$, a.axis_id),
                     format($q$INSERT INTO edited.axis (axis_id, geom, width, direction, name, importance) VALUES (%s, %L, 7, 'direct', 'avenue', %s)$q$, fresh, ST_AsEWKT(ST_Reverse(beside)), coalesce(a.importance::text, 'NULL'))];
      END IF;
    WHEN 'ramp' THEN
      -- A link that comes upon the street, or leaves it, at an acute angle.
      beside := ST_LineInterpolatePoint(a.geom, edits.between(0.3, 0.7));
      beside := ST_MakeLine(ST_Translate(ST_LineInterpolatePoint(a.geom, 0), edits.between(-20, 20), edits.between(-20, 20)), beside);
      RETURN ARRAY[format($q$UPDATE edited.axis SET direction = 'direct', kind = 'motorway', lane_count = %s, speed = 100 WHERE axis_id = %s$q$, edits.one_of('2', '3'), a.axis_id),
                   format($q$INSERT INTO edited.axis (axis_id, geom, width, direction, kind, lane_count, speed) VALUES (%s, %L, 4, %L, 'motorway_link', 1, 50)$q$, fresh,
                          ST_AsEWKT(CASE WHEN edits.chance(0.5) THEN beside ELSE ST_Reverse(beside) END), 'direct')];
    WHEN 'decide ramp' THEN
      RETURN ARRAY[edits.one_of(format('UPDATE edited.ramp_editing SET length = %s', edits.one_of('0', '20', '90', 'NULL')), format('UPDATE edited.ramp_editing SET tangent = %s', edits.one_of('5', '25', 'NULL')),
                                'DELETE FROM edited.ramp_editing WHERE by_hand', format('INSERT INTO edited.ramp_override (axis_id, abscissa, tangent) VALUES (%s, %s, 9)', a.axis_id, edits.between(0, ST_Length(a.geom))))];
    WHEN 'change' THEN
      RETURN ARRAY[format('INSERT INTO edited.lane_adjacency_override (axis_id, abscissa, lane_from, lane_to, change) VALUES (%s, %s, %s, %s, %L)',
                          a.axis_id, edits.between(0, ST_Length(a.geom)), edits.one_of('1', '2', '3'), edits.one_of('1', '2', '3', '4'), edits.one_of('allowed', 'forbidden'))];
    WHEN 'duration' THEN
      RETURN ARRAY[edits.one_of(format('UPDATE edited.controller_editing SET durations[1] = %s, durations[cardinality(durations)] = 4', edits.one_of('31', '17')), 'UPDATE edited.controller_editing SET durations = NULL',
                                'DELETE FROM edited.controller_editing WHERE by_hand')];
    WHEN 'no change' THEN
      RETURN ARRAY[edits.one_of('DELETE FROM edited.lane_adjacency_editing WHERE by_hand', format('DELETE FROM edited.lane_adjacency_override WHERE axis_id = %s', a.axis_id), $q$UPDATE edited.lane_adjacency_editing SET change = 'forbidden' WHERE change = 'allowed'$q$)];
  END CASE;
  RETURN '{}';
END $$;

-- One edit of rings, of what somebody decides of them, and of the ground about streets.
CREATE FUNCTION edits.ring_edit(a edited.axis) RETURNS text[] LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  edit text := edits.one_of('ring', 'ring', 'arm', 'arm', 'arm across', 'arm across', 'street across', 'make', 'confirm', 'confirm', 'override', 'no override', 'tag', 'sidewalk', 'sidewalk', 'block');
  fresh bigint := coalesce((SELECT max(axis_id) FROM edited.axis), 0) + 1;
  circle geometry;
  middle geometry;
  size float8 := edits.between(6, 40);
  turn float8 := edits.between(0, 6.28);
  other record;
BEGIN
  SELECT geom INTO circle FROM edited.axis WHERE ST_IsClosed(geom) AND ST_NPoints(geom) > 12 ORDER BY axis_id OFFSET floor(random() * (SELECT count(*) FROM edited.axis WHERE ST_IsClosed(geom) AND ST_NPoints(geom) > 12)) LIMIT 1;
  middle := ST_Centroid(circle);
  IF edit IN ('arm', 'arm across', 'street across') AND circle IS NULL THEN
    edit := 'ring';
  END IF;
  CASE edit
    WHEN 'ring' THEN
      -- Arms begin at its vertices, or miss them.
      middle := edits.place();
      circle := ST_Reverse(ST_ExteriorRing(ST_Buffer(middle, size, 5)));
      RETURN ARRAY[format('INSERT INTO edited.axis (axis_id, geom, width, direction, roundabout_tag) VALUES (%s, %L, %s, %s, %s)', fresh, ST_AsEWKT(circle), edits.between(4, 9), edits.one_of($q$'direct'$q$, $q$'both'$q$),
                          edits.value_of('roundabout_tag')),
                   edits.inserted((SELECT string_agg(edits.drawn_row(fresh + n, ST_MakeLine(ST_PointN(circle, 1 + 5 * n), ST_Translate(middle, 60 * cos(turn + 1.57 * n), 60 * sin(turn + 1.57 * n)))), ', ')
                                   FROM generate_series(1, 1 + floor(random() * 4)::integer) n))];
    WHEN 'arm' THEN
      RETURN ARRAY[edits.drawn(fresh, ST_MakeLine(ST_PointN(circle, 1 + floor(random() * ST_NPoints(circle))::integer), edits.place()))];
    WHEN 'arm across' THEN
      -- It ends on the far side, and has no node where it comes in.
      RETURN ARRAY[edits.drawn(fresh, ST_MakeLine(edits.place(), ST_PointN(circle, 1 + floor(random() * ST_NPoints(circle))::integer)))];
    WHEN 'street across' THEN
      RETURN ARRAY[edits.drawn(fresh, ST_MakeLine(ARRAY[ST_Translate(middle, 70 * cos(turn), 70 * sin(turn)), ST_PointN(circle, 3), middle, ST_PointN(circle, 12), ST_Translate(middle, -70 * cos(turn), -70 * sin(turn))]))];
    WHEN 'make' THEN
      SELECT ST_AsEWKT(n.geom) AS geom INTO other FROM edited.node n JOIN edited.edge e ON n.node_id IN (e.from_node, e.to_node) GROUP BY n.node_id HAVING count(*) > 2
        ORDER BY ST_X(n.geom), ST_Y(n.geom) OFFSET floor(random() * 5) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('SELECT streetgen.make_roundabout(''edited'', (SELECT node_id FROM edited.node ORDER BY geom <-> %L LIMIT 1), %s)', other.geom, edits.between(8, 25))];
      END IF;
    WHEN 'confirm' THEN
      SELECT ST_AsEWKT(centre) AS geom INTO other FROM edited.roundabout ORDER BY ST_X(centre), ST_Y(centre) OFFSET floor(random() * (SELECT count(*) FROM edited.roundabout)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('UPDATE edited.roundabout_editing SET confirmed = %s WHERE roundabout_id = (SELECT roundabout_id FROM edited.roundabout ORDER BY centre <-> %L LIMIT 1)', edits.one_of('true', 'true', 'false', 'NULL'), other.geom)];
      END IF;
    WHEN 'override' THEN
      RETURN ARRAY[format('INSERT INTO edited.roundabout_override (geom, confirmed) VALUES (%L, %s)', ST_AsEWKT(edits.place()), edits.one_of('true', 'false'))];
    WHEN 'no override' THEN
      RETURN ARRAY[edits.one_of('DELETE FROM edited.roundabout_override', 'DELETE FROM edited.block_override', 'DELETE FROM edited.sidewalk_override')];
    WHEN 'tag' THEN
      RETURN ARRAY[format('UPDATE edited.axis SET roundabout_tag = %s WHERE ST_IsClosed(geom) OR axis_id = %s', edits.value_of('roundabout_tag'), a.axis_id)];
    WHEN 'sidewalk' THEN
      RETURN ARRAY[format('INSERT INTO edited.sidewalk_override (axis_id, abscissa, side, width) VALUES (%s, %s, %L, %s)', a.axis_id, edits.between(0, ST_Length(a.geom)), edits.one_of('left', 'right'), edits.one_of('0', '1.2', '3', '6'))];
    WHEN 'block' THEN
      SELECT ST_AsEWKT(ST_PointOnSurface(surface)) AS geom INTO other FROM edited.block ORDER BY ST_XMin(surface), ST_YMin(surface), ST_Area(surface) OFFSET floor(random() * (SELECT count(*) FROM edited.block)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('INSERT INTO edited.block_override (geom, kind) VALUES (%L, %L)', other.geom, edits.one_of('block', 'island', 'strip'))];
      END IF;
  END CASE;
  RETURN '{}';
END $$;

-- One edit of the town as it is: a statement, or the two of a split or merge.
CREATE FUNCTION edits.edit() RETURNS text[] LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  edit text := edits.one_of('move vertex', 'move vertex', 'move vertex', 'move node', 'attribute', 'attribute', 'attribute', 'several', 'insert', 'insert', 'delete', 'split', 'merge', 'reverse',
                            'number anew', 'transition', 'lane', 'limit', 'kerb point', 'corner', 'interconnection', 'restriction', 'bend', 'no override', 'paused',
                            'junction', 'junction', 'junction', 'junction', 'junction', 'junction', 'junction', 'junction',
                            'object', 'object', 'object', 'object', 'object', 'object', 'object', 'object', 'ring', 'ring', 'ring', 'ring');
  a edited.axis := edits.axis();
  fresh bigint := coalesce((SELECT max(axis_id) FROM edited.axis), 0) + 1;
  attribute text := edits.attribute();
  vertex integer;
  place geometry;
  other record;
BEGIN
  IF a.axis_id IS NULL THEN
    edit := 'insert';
  END IF;
  CASE edit
    WHEN 'move vertex' THEN
      RETURN ARRAY[format('UPDATE edited.axis SET geom = %L WHERE axis_id = %s', ST_AsEWKT(ST_SetPoint(a.geom, floor(random() * ST_NPoints(a.geom))::integer, edits.place())), a.axis_id)];
    WHEN 'move node' THEN
      vertex := floor(random() * ST_NPoints(a.geom));
      place := edits.place();
      RETURN ARRAY[format('UPDATE edited.axis a SET geom = (SELECT ST_MakeLine(CASE WHEN ST_Equals(p.geom, %L) THEN %L ELSE p.geom END ORDER BY path) FROM ST_DumpPoints(a.geom) p) WHERE ST_DWithin(geom, %1$L, 0)',
                          ST_AsEWKT(ST_PointN(a.geom, vertex + 1)), ST_AsEWKT(place))];
    WHEN 'attribute' THEN
      RETURN ARRAY[format('UPDATE edited.axis SET %I = %s WHERE axis_id = %s', attribute, edits.value_of(attribute), a.axis_id)];
    WHEN 'several' THEN
      RETURN ARRAY[format('UPDATE edited.axis SET %I = %s WHERE axis_id %% %s = 0', attribute, edits.value_of(attribute), 2 + floor(random() * 5))];
    WHEN 'insert' THEN
      RETURN ARRAY[edits.drawn(fresh, CASE WHEN edits.chance(0.2) THEN ST_MakeLine(ARRAY[edits.place(), edits.place(), edits.place()]) ELSE ST_MakeLine(edits.place(), edits.place()) END)];
    WHEN 'delete' THEN
      RETURN ARRAY[format('DELETE FROM edited.axis WHERE axis_id IN (%s, %s)', a.axis_id, (edits.axis()).axis_id)];
    WHEN 'split' THEN
      place := ST_LineInterpolatePoint(a.geom, edits.between(0.1, 0.9));
      RETURN ARRAY[format('UPDATE edited.axis SET geom = %L WHERE axis_id = %s', ST_AsEWKT(ST_SetPoint(ST_LineSubstring(a.geom, 0, ST_LineLocatePoint(a.geom, place)), -1, place)), a.axis_id),
                   edits.drawn(fresh, ST_SetPoint(ST_LineSubstring(a.geom, ST_LineLocatePoint(a.geom, place), 1), 0, place))];
    WHEN 'merge' THEN
      SELECT b.axis_id, ST_LineMerge(ST_Collect(a.geom, b.geom)) AS geom INTO other FROM edited.axis b WHERE b.axis_id <> a.axis_id
        AND ST_GeometryType(ST_LineMerge(ST_Collect(a.geom, b.geom))) = 'ST_LineString' ORDER BY b.axis_id LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('UPDATE edited.axis SET geom = %L WHERE axis_id = %s', ST_AsEWKT(other.geom), a.axis_id), format('DELETE FROM edited.axis WHERE axis_id = %s', other.axis_id)];
      END IF;
    WHEN 'reverse' THEN
      RETURN ARRAY[format('UPDATE edited.axis SET geom = ST_Reverse(geom) WHERE axis_id = %s', a.axis_id)];
    WHEN 'number anew' THEN
      RETURN ARRAY[format('UPDATE edited.axis SET axis_id = %s WHERE axis_id = %s', fresh + 1, a.axis_id)];
    WHEN 'transition' THEN
      RETURN ARRAY[format('INSERT INTO edited.transition_override (axis_id, which, kind, length) VALUES (%s, %L, %L, %s)',
                          a.axis_id, edits.one_of('start', 'end'), edits.one_of('symmetric', 'left', 'right'), edits.between(0, 30))];
    WHEN 'lane' THEN
      RETURN ARRAY[format('INSERT INTO edited.lane_override (axis_id, abscissa, ordinality, along_axis, both_ways, width) VALUES (%s, %s, %s, %s, %s, %s)',
                          a.axis_id, edits.between(0, ST_Length(a.geom)), edits.one_of('1', '2', '3'), edits.one_of('true', 'false', 'NULL'), edits.one_of('true', 'false', 'NULL'), edits.one_of('NULL', '2.2', '4.1'))];
    WHEN 'interconnection' THEN
      SELECT e.axis_id AS axis_in, f.axis_id AS axis_out, i.ordinality AS lane_in, o.ordinality AS lane_out, n.geom INTO other
        FROM edited.interconnection c JOIN edited.lane i ON i.lane_id = c.lane_in JOIN edited.edge e ON e.edge_id = i.edge_id
        JOIN edited.lane o ON o.lane_id = c.lane_out JOIN edited.edge f ON f.edge_id = o.edge_id JOIN edited.node n USING (node_id)
        ORDER BY e.axis_id, e.start_abscissa, lane_in, f.axis_id, f.start_abscissa, lane_out OFFSET floor(random() * (SELECT count(*) FROM edited.interconnection)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('INSERT INTO edited.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting, control) VALUES (%L, %s, %s, %s, %s, %s, %L)', ST_AsEWKT(other.geom),
                            other.axis_in, other.lane_in, other.axis_out, other.lane_out, edits.one_of('true', 'false', 'NULL'), CASE WHEN edits.chance(0.5) THEN ST_AsEWKT(ST_Translate(other.geom, 2, 1)) END)];
      END IF;
    WHEN 'restriction' THEN
      RETURN ARRAY[format('INSERT INTO edited.turn_restriction (from_axis, to_axis, geom, kind) VALUES (%s, %s, %L, %L)', a.axis_id, (edits.axis()).axis_id,
                          ST_AsEWKT(CASE WHEN edits.chance(0.5) THEN ST_StartPoint(a.geom) ELSE ST_EndPoint(a.geom) END), edits.one_of('no', 'only'))];
    WHEN 'limit' THEN
      RETURN ARRAY[format('INSERT INTO edited.section_limit_override (axis_id, abscissa, which) VALUES (%s, %s, %L)', a.axis_id, edits.between(0, ST_Length(a.geom)), edits.one_of('start', 'end'))];
    WHEN 'kerb point' THEN
      place := ST_LineInterpolatePoint(a.geom, edits.between(0, 1));
      RETURN ARRAY[format('INSERT INTO edited.kerb_point_override (axis_id, geom) VALUES (%s, %L)', a.axis_id, ST_AsEWKT(ST_Translate(place, edits.between(1, 6), edits.between(1, 6))))];
    WHEN 'corner' THEN
      SELECT n.geom, e.axis_id AS axis_a, f.axis_id AS axis_b INTO other FROM edited.corner c JOIN edited.node n USING (node_id) JOIN edited.edge e ON e.edge_id = c.edge_a JOIN edited.edge f ON f.edge_id = c.edge_b
        ORDER BY e.axis_id, e.start_abscissa, end_a, f.axis_id, f.start_abscissa, end_b OFFSET floor(random() * (SELECT count(*) FROM edited.corner)) LIMIT 1;
      IF FOUND THEN
        RETURN ARRAY[format('INSERT INTO edited.corner_override (geom, axis_a, axis_b, radius) VALUES (%L, %s, %s, %s)', ST_AsEWKT(other.geom), other.axis_a, other.axis_b, edits.one_of('0', '1.5', '9', '40'))];
      END IF;
    WHEN 'bend' THEN
      vertex := 2 + floor(random() * greatest(ST_NPoints(a.geom) - 2, 1));
      RETURN ARRAY[format('INSERT INTO edited.road_override (axis_id, abscissa, radius) VALUES (%s, %s, %s)', a.axis_id,
                          edits.one_of(ST_Length(ST_MakeLine(ARRAY(SELECT geom FROM ST_DumpPoints(a.geom) WHERE path[1] <= vertex ORDER BY path)))::text, edits.between(0, ST_Length(a.geom))::text), edits.one_of('0', '6', '15', '60'))];
    WHEN 'no override' THEN
      RETURN ARRAY[format('DELETE FROM edited.%I WHERE %s = %s', t, k, a.axis_id)]
        FROM (VALUES ('transition_override', 'axis_id'), ('lane_override', 'axis_id'), ('interconnection_override', 'axis_in'), ('turn_restriction', 'from_axis'),
                      ('section_limit_override', 'axis_id'), ('kerb_point_override', 'axis_id'), ('corner_override', 'axis_a'), ('road_override', 'axis_id'), ('ramp_override', 'axis_id')) v(t, k) OFFSET floor(random() * 9) LIMIT 1;
    WHEN 'object' THEN
      RETURN edits.object_edit(a);
    WHEN 'junction' THEN
      RETURN edits.junction_edit(a);
    WHEN 'ring' THEN
      RETURN edits.ring_edit(a);
    WHEN 'paused' THEN
      -- As an importer: what it changed is generated by itself.
      RETURN ARRAY[$q$SET LOCAL streetgen.live = 'off'$q$, format('UPDATE edited.axis SET width = %s WHERE axis_id = %s', edits.between(3, 20), a.axis_id), 'SET LOCAL streetgen.live TO DEFAULT',
                   format($q$SELECT FROM streetgen.generate('edited', ARRAY[%s])$q$, a.axis_id)];
  END CASE;
  RETURN '{}';
END $$;

-- A grid that is not one: places jittered, streets missing, ends that miss each other by centimetres, levels, a ring: rows to insert.
CREATE FUNCTION edits.grid() RETURNS text[] LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  spacing float8 := edits.between(25, 90);
  many integer := 2 + floor(random() * 3);
  rows text[] := '{}';
  pair record;
BEGIN
  DROP TABLE IF EXISTS place;
  CREATE TEMPORARY TABLE place ON COMMIT DROP AS
    SELECT x, y, ST_SetSRID(ST_Point(650000 + spacing * x + edits.between(-0.3, 0.3) * spacing, 6860000 + spacing * y + edits.between(-0.3, 0.3) * spacing), 2154) AS geom
    FROM generate_series(0, many) x, generate_series(0, many) y;
  FOR pair IN SELECT a.geom AS a, b.geom AS b FROM place a JOIN place b ON (b.x, b.y) IN ((a.x + 1, a.y), (a.x, a.y + 1), (a.x + 1, a.y + 1)) ORDER BY a.x, a.y, b.x, b.y LOOP
    CONTINUE WHEN edits.chance(0.3);
    rows := rows || edits.drawn_row(cardinality(rows) + 1, CASE
      WHEN edits.chance(0.15) THEN ST_MakeLine(ST_Translate(pair.a, edits.between(-0.3, 0.3), edits.between(-0.3, 0.3)), pair.b)
      WHEN edits.chance(0.2) THEN ST_MakeLine(ARRAY[pair.a, ST_Translate(ST_Centroid(ST_MakeLine(pair.a, pair.b)), edits.between(-9, 9), edits.between(-9, 9)), pair.b])
      WHEN edits.chance(0.05) THEN ST_MakeLine(ARRAY[pair.a, ST_Translate(pair.a, 20, 5), ST_Translate(pair.a, 8, 22), pair.a])
      ELSE ST_MakeLine(pair.a, pair.b) END);
  END LOOP;
  RETURN rows;
END $$;

-- The axes of a model about a random one of them, moved near the origin of the others.
CREATE FUNCTION edits.window(model name) RETURNS SETOF edited.axis LANGUAGE plpgsql VOLATILE AS $$
BEGIN
  RETURN QUERY EXECUTE format('SELECT a.* FROM %1$I.axis a, (SELECT ST_StartPoint(geom) AS geom FROM %1$I.axis ORDER BY axis_id OFFSET floor(random() * (SELECT count(*) FROM %1$I.axis)) LIMIT 1) c
    WHERE ST_DWithin(a.geom, c.geom, %2$s) ORDER BY axis_id', model, edits.between(60, 160));
END $$;

-- Makes the model that is edited what a script begins with.
CREATE FUNCTION edits.begin(script edits.script) RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  input regclass;
BEGIN
  FOR input IN SELECT oid FROM pg_class WHERE relnamespace = 'edited'::regnamespace AND relkind = 'r' AND (relname IN
      ('axis', 'turn_restriction', 'control_point', 'footway', 'footway_kerb', 'rail_track', 'street_area') OR
      relname LIKE '%\_override') LOOP
    EXECUTE format('DELETE FROM %s', input);
  END LOOP;
  DELETE FROM edited.placement_rule;
  DELETE FROM edited.fit_run;
  DELETE FROM edited.observation;
  DELETE FROM edited.street_object;
  DELETE FROM edited.free_place;
  UPDATE edited.object_type SET distance_least = 0 WHERE distance_least > 0;
  PERFORM streetgen.set('edited', name, wanted) FROM (SELECT name, coalesce(split_part(chosen, '=', 2), d.value) AS wanted FROM streetgen._default_setting() d
    LEFT JOIN unnest(script.settings) chosen ON split_part(chosen, '=', 1) = name) w JOIN edited.setting s USING (name) WHERE s.value <> wanted;
  INSERT INTO edited.axis SELECT (row::edited.axis).* FROM unnest(script.axes) row;
END $$;

-- Executes a statement; what the model refuses leaves it as it was.
CREATE FUNCTION edits.execute(statement text) RETURNS boolean LANGUAGE plpgsql VOLATILE AS $$
BEGIN
  EXECUTE statement;
  RETURN true;
EXCEPTION WHEN check_violation OR unique_violation OR invalid_parameter_value THEN
  RETURN false;
END $$;

-- Runs a script; NULL or what is wrong at its end.
CREATE FUNCTION edits.run(script edits.script) RETURNS text LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  statement text;
BEGIN
  PERFORM edits.begin(script);
  FOREACH statement IN ARRAY script.statements LOOP
    PERFORM edits.execute(statement);
  END LOOP;
  RETURN test.difference('edited', 'scratch');
EXCEPTION WHEN OTHERS THEN
  RETURN format('%s: %s', SQLSTATE, SQLERRM);
END $$;

-- The script of a seed, executed as it is drawn. Every fourth town of its own grows axis by axis.
CREATE FUNCTION edits.drawn_script(seed integer) RETURNS edits.script LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  script edits.script := ('{}', '{}', '{}');
  source text;
  rows text[];
  edit text[];
  statement text;
  -- So many edits of objects come first, then of junctions, then of rings.
  objects integer;
  junctions integer;
  rings integer;
BEGIN
  PERFORM setseed((seed::bigint * 7919 % 1000003) / 1000003.0);
  script.settings := ARRAY['crossing=' || edits.one_of('over', 'split'), 'short_axis=' || edits.one_of('reduce', 'follow'), 'dead_end=' || edits.one_of('flat', 'round'),
                           'u_turn=' || edits.one_of('true', 'false'), 'trajectory=' || edits.one_of('bezier', 'arcs'), 'reach=' || edits.one_of('60', '60', '25', '120'), 'edge_line=' || edits.one_of('none', 'solid'),
                           'smoothing=' || edits.one_of('none', 'none', 'arcs'), 'junction_gap=' || edits.one_of('35', '35', '12'), 'control_distance=' || edits.one_of('50', '20'),
                           'roundabout_untagged=' || edits.one_of('auto', 'offered'), 'area_wins=' || edits.one_of('', 'roadway', 'roadway,square')];
  PERFORM edits.begin(script);
  source := edits.one_of(VARIADIC ARRAY(SELECT NULL UNION ALL SELECT NULL UNION ALL (SELECT name FROM edits.town ORDER BY name)));
  IF source IS NULL THEN
    rows := edits.grid();
    IF seed % 4 = 0 THEN
      script.statements := ARRAY(SELECT edits.inserted(row) FROM unnest(rows) row);
    ELSE
      EXECUTE edits.inserted(array_to_string(rows, ', '));
      script.axes := ARRAY(SELECT a::text FROM edited.axis a ORDER BY axis_id);
    END IF;
    FOREACH statement IN ARRAY script.statements LOOP
      EXECUTE statement;
    END LOOP;
  ELSE
    SELECT array_agg(a::text) INTO script.axes FROM edits.window(source) a;
    INSERT INTO edited.axis SELECT (row::edited.axis).* FROM unnest(script.axes) row;
  END IF;
  objects := CASE WHEN edits.chance(0.5) THEN 8 ELSE 0 END;
  junctions := CASE WHEN edits.chance(0.5) THEN 8 ELSE 0 END;
  rings := CASE WHEN edits.chance(0.5) THEN 8 ELSE 0 END;
  FOR i IN 1 .. objects + junctions + rings + 2 + floor(random() * 9) LOOP
    edit := CASE WHEN i <= objects THEN edits.object_edit(edits.axis()) WHEN i <= objects + junctions THEN edits.junction_edit(edits.axis())
      WHEN i <= objects + junctions + rings THEN edits.ring_edit(edits.axis()) ELSE edits.edit() END;
    FOREACH statement IN ARRAY edit LOOP
      EXIT WHEN NOT edits.execute(statement);
      script.statements := script.statements || statement;
    END LOOP;
  END LOOP;
  RETURN script;
END $$;

CREATE TABLE edits.failure (seed integer, what text, script edits.script);

-- Takes out of the script of a failure whatever it does not need to fail.
CREATE PROCEDURE edits.reduce(failed integer) LANGUAGE plpgsql AS $$
DECLARE
  script edits.script;
  smaller edits.script;
  differs text;
  shrank boolean := true;
  part record;
BEGIN
  SELECT (f.script).* INTO script FROM edits.failure f WHERE seed = failed;
  WHILE shrank LOOP
    shrank := false;
    FOR part IN SELECT what, i FROM (VALUES ('statement', 1, cardinality(script.statements)), ('axis', 2, cardinality(script.axes)), ('setting', 3, cardinality(script.settings))) v(what, place, many),
                generate_series(many, 1, -1) i ORDER BY place, i DESC LOOP
      smaller := script;
      CASE part.what
        WHEN 'statement' THEN smaller.statements := script.statements[: part.i - 1] || script.statements[part.i + 1 :];
        WHEN 'axis' THEN smaller.axes := script.axes[: part.i - 1] || script.axes[part.i + 1 :];
        WHEN 'setting' THEN smaller.settings := script.settings[: part.i - 1] || script.settings[part.i + 1 :];
      END CASE;
      differs := edits.run(smaller);
      IF differs IS NOT NULL THEN
        script := smaller;
        shrank := true;
        UPDATE edits.failure f SET script = smaller, what = differs WHERE seed = failed;
      END IF;
    END LOOP;
  END LOOP;
END $$;

-- A script as SQL.
CREATE FUNCTION edits.told(script edits.script) RETURNS text LANGUAGE sql STABLE AS $$
  SELECT string_agg(line, E';\n' ORDER BY place, i) || ';' FROM (
    SELECT 1 AS place, i, format('SELECT streetgen.set(''edited'', %L, %L)', split_part(s, '=', 1), split_part(s, '=', 2)) AS line FROM unnest(script.settings) WITH ORDINALITY v(s, i)
    UNION ALL SELECT 2, 0, 'INSERT INTO edited.axis (axis_id, geom, width, width_end, lane_count, direction, speed, importance, level, kind, radius, kind_forward, turn_forward, roundabout_tag) VALUES '
      || string_agg(format('(%s, %L, %s, %s, %s, %L, %s, %s, %s, %L, %s, %L, %L, %L)', a.axis_id, ST_AsEWKT(a.geom), coalesce(a.width::text, 'NULL'), coalesce(a.width_end::text, 'NULL'), coalesce(a.lane_count::text, 'NULL'),
          a.direction, coalesce(a.speed::text, 'NULL'), coalesce(a.importance::text, 'NULL'), a.level, a.kind, coalesce(a.radius::text, 'NULL'), a.kind_forward, a.turn_forward, a.roundabout_tag), E',\n  ')
      FROM unnest(script.axes) row, LATERAL (SELECT (row::edited.axis).*) a
    UNION ALL SELECT 3, i, s FROM unnest(script.statements) WITH ORDINALITY v(s, i)) l $$;

-- So many scripts from a seed on; each that fails is a row of edits.failure.
CREATE PROCEDURE edits.scripts(many integer, seed integer) LANGUAGE plpgsql AS $$
DECLARE
  script edits.script;
  what text;
BEGIN
  FOR i IN seed .. seed + many - 1 LOOP
    BEGIN
      script := ('{}', '{}', '{}');
      script := edits.drawn_script(i);
      what := test.difference('edited', 'scratch');
    EXCEPTION WHEN OTHERS THEN
      what := format('%s: %s', SQLSTATE, SQLERRM);
    END;
    IF what IS NOT NULL THEN
      INSERT INTO edits.failure VALUES (i, what, script);
    END IF;
    COMMIT;
  END LOOP;
END $$;
