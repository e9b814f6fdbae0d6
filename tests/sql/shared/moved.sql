-- A model once more on moved paper: turned, shifted, mirrored with the other driving side; axes drawn backwards, or numbered otherwise.
-- test.move makes it from all input of a model and generates it; test.moved_difference holds every computed row against the rows of the model.

-- The movement of the last test.move. centre is what the paper turns about; mirrored swaps west and east before it turns.
CREATE TABLE test.movement (model name, moved name, turn float8, shift_x float8, shift_y float8, mirrored boolean, reversed boolean, renumbered boolean,
  centre_x float8, centre_y float8);
CREATE TABLE test.axis_pair (axis_id bigint PRIMARY KEY, moved_id bigint UNIQUE, reversed boolean, length float8);
CREATE TABLE test.edge_pair (edge_id bigint PRIMARY KEY, moved_id bigint UNIQUE, reversed boolean, axis_length float8, length float8, lanes integer);
CREATE TABLE test.node_pair (node_id bigint PRIMARY KEY, moved_id bigint UNIQUE);
CREATE TABLE test.lane_pair (lane_id bigint PRIMARY KEY, moved_id bigint UNIQUE, reversed boolean);
-- What has no axis, node, edge or lane for a name, in both models by the least edge or node in it.
CREATE TABLE test.thing (kind text, is_moved boolean, id bigint, name text, PRIMARY KEY (kind, is_moved, id));

-- An affine map as the last arguments of ST_Affine; back: from the moved paper.
CREATE FUNCTION test.affine(back boolean) RETURNS text LANGUAGE sql STABLE AS $$
  SELECT format('%s, %s, %s, %s, %s, %s', a, b, d, e, CASE WHEN back THEN centre_x - a * x - b * y ELSE x - a * centre_x - b * centre_y END,
    CASE WHEN back THEN centre_y - d * x - e * y ELSE y - d * centre_x - e * centre_y END)
  FROM (SELECT centre_x, centre_y, centre_x + shift_x AS x, centre_y + shift_y AS y, CASE WHEN back THEN m * c ELSE m * c END AS a, CASE WHEN back THEN m * s ELSE -s END AS b,
      CASE WHEN back THEN -s ELSE m * s END AS d, c AS e
    FROM (SELECT *, CASE WHEN mirrored THEN -1 ELSE 1 END AS m, CASE turn::integer WHEN 90 THEN 0 ELSE cosd(turn) END AS c, sind(turn) AS s FROM test.movement) v) v $$;

-- Words with left and right exchanged, and start and end, forward and backward.
CREATE FUNCTION test.exchanged(words text, a text, b text) RETURNS text LANGUAGE sql IMMUTABLE AS $$ SELECT replace(replace(replace(words, a, '~'), b, a), '~', b) $$;
-- A list with | from right to left.
CREATE FUNCTION test.backwards(list text) RETURNS text LANGUAGE sql IMMUTABLE AS $$
  SELECT string_agg(word, '|' ORDER BY place DESC) FROM string_to_table(list, '|') WITH ORDINALITY w(word, place) $$;
-- The number, from the middle outwards, of a lane of n seen from the other end of its street.
CREATE FUNCTION test.ordinality_backwards(ordinality integer, n integer) RETURNS integer LANGUAGE sql IMMUTABLE AS $$
  SELECT CASE WHEN ordinality > n OR n % 2 = 1 AND ordinality = 1 THEN ordinality WHEN (ordinality + n) % 2 = 1 THEN ordinality + 1 ELSE ordinality - 1 END $$;

-- The expression of a column of row t on the other paper. back: from the moved paper; else onto it.
-- The object that the column speaks of decides whether it runs backwards there.
CREATE FUNCTION test.moved_column(relation name, col name, type text, columns name[], back boolean) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
  m constant test.movement := (SELECT movement FROM test.movement);
  model constant name := CASE WHEN back THEN m.moved ELSE m.model END;
  here constant text := CASE WHEN back THEN 'p.moved_id' ELSE 'p.%1$s_id' END;
  there constant text := CASE WHEN back THEN 'p.%1$s_id' ELSE 'p.moved_id' END;
  -- An axis, an edge, a node or a lane of the other paper; one without a pair is told by its negative number.
  pair constant text := '(SELECT coalesce((SELECT ' || there || ' FROM test.%1$s_pair p WHERE ' || here || ' = %2$s), -%2$s))';
  asks constant text := '(SELECT %3$s FROM test.%1$s_pair p WHERE ' || here || ' = %2$s)';
  -- What the row lies on.
  kind text := CASE WHEN 'edge_id' = ANY (columns) THEN 'edge' WHEN 'lane_id' = ANY (columns) THEN 'lane' ELSE 'axis' END;
  id text := 't.' || kind || '_id';
  other text := CASE WHEN col ~ '^start_|^from_|^end_|^to_' AND relation NOT IN ('turn_restriction', 'controller', 'controller_override', 'road', 'lane_adjacency_override')
      THEN regexp_replace(regexp_replace(regexp_replace(col, '^(start|end)_', '~\1_'), '~start_|~end_', CASE WHEN col LIKE 'start%' THEN 'end_' ELSE 'start_' END), '^(from|to)_',
        CASE WHEN col LIKE 'from%' THEN 'to_' ELSE 'from_' END)
    WHEN col ~ '^width(_end)?$|^source_width' AND 'width_end' = ANY (columns) THEN CASE WHEN col LIKE '%_end' THEN left(col, -4) ELSE col || '_end' END
    WHEN col ~ '_(forward|backward)$' THEN test.exchanged(col, 'forward', 'backward')
    WHEN col ~ '^tied_(from|to)$' THEN test.exchanged(col, 'from', 'to') END;
  backwards text;
  flipped text;
  plain text;
BEGIN
  IF relation IN ('signal_head') THEN
    kind := 'lane';
    id := 't.lane_id';
  ELSIF col ~ '_(a|b|in|out|above|below)$' THEN
    kind := CASE WHEN 'lane_in' = ANY (columns) AND back THEN 'lane' WHEN back THEN 'edge' ELSE 'axis' END;
    id := 't.' || kind || '_' || substring(col FROM '[a-z]+$');
  END IF;
  IF NOT (replace(id, 't.', '') = ANY (columns)) THEN
    backwards := 'false';
  ELSE
    backwards := format('coalesce(' || asks || ', false)', kind, id, 'reversed');
  END IF;
  IF NOT m.reversed THEN
    backwards := 'false';
  END IF;
  flipped := CASE WHEN m.mirrored THEN 'NOT ' ELSE '' END || backwards;
  plain := format('t.%I', col);
  IF type LIKE 'geometry%' THEN
    plain := format('ST_Affine(t.%I, %s)', col, test.affine(back));
    RETURN CASE WHEN NOT back AND (relation, col) IN (('axis', 'geom'), ('axis', 'source_geom'), ('lane_override', 'line')) THEN format('CASE WHEN %s THEN ST_Reverse(%s) ELSE %2$s END', backwards, plain) ELSE plain END;
  ELSIF col = 'via_axes' THEN
    RETURN format('CASE WHEN t.via_axes IS NOT NULL THEN ARRAY(SELECT %s FROM unnest(t.via_axes) WITH ORDINALITY v(id, place) ORDER BY place) END', format(pair, 'axis', 'v.id'));
  ELSIF relation = 'report' AND col IN ('axis_a', 'axis_b') THEN
    -- Of a crossing the two in either order; a cluster is named by one of many.
    RETURN format('CASE t.issue WHEN ''wide_cluster'' THEN NULL ELSE %s(%s, %s) END', CASE col WHEN 'axis_a' THEN 'least' ELSE 'greatest' END, format(pair, 'axis', 't.axis_a'), format(pair, 'axis', 't.axis_b'));
  ELSIF relation = 'corner' AND col ~ '^(edge|end)_[ab]$' THEN
    col := CASE WHEN m.mirrored THEN left(col, -1) || translate(right(col, 1), 'ab', 'ba') ELSE col END;
    RETURN CASE WHEN col LIKE 'edge%' THEN format(pair, 'edge', 't.' || col)
      ELSE format('CASE WHEN %s THEN test.exchanged(t.%I, ''start'', ''end'') ELSE t.%2$I END', CASE WHEN m.reversed THEN format(asks, 'edge', 't.edge_' || right(col, 1), 'reversed') ELSE 'false' END, col) END;
  ELSIF relation = 'corner_override' AND col ~ '^axis_[ab]$' THEN
    RETURN format(pair, 'axis', 't.axis_' || CASE WHEN m.mirrored THEN translate(right(col, 1), 'ab', 'ba') ELSE right(col, 1) END);
  ELSIF type = 'bigint' AND col ~ 'axis' THEN
    RETURN format(pair, 'axis', plain);
  ELSIF type = 'bigint' AND col ~ 'lane' AND col NOT LIKE 'lane_override%' AND col NOT LIKE 'lane_adj%' AND col <> 'lane_separator_id' THEN
    RETURN format(pair, 'lane', plain);
  ELSIF type = 'bigint' AND (col IN ('from_node', 'to_node') AND relation = 'edge') THEN
    RETURN format('CASE WHEN %s THEN %s ELSE %s END', backwards, format(pair, 'node', 't.' || other), format(pair, 'node', plain));
  ELSIF type = 'bigint' AND col ~ '^(node_id|from_node|to_node)$' THEN
    RETURN format(pair, 'node', plain);
  ELSIF type = 'bigint' AND col ~ '^edge_' AND back THEN
    RETURN format(pair, 'edge', plain);
  ELSIF type = 'bigint' AND back AND col ~ '^(junction|controller|road|block|roundabout)_id$' THEN
    RETURN format('(SELECT name FROM test.thing WHERE kind = %L AND is_moved AND id = %s)', CASE col WHEN 'controller_id' THEN 'junction' ELSE regexp_replace(col, '_id$', '') END, plain);
  ELSIF col IN ('start_abscissa', 'end_abscissa') AND relation NOT IN ('road_edge') THEN
    -- Along the edge, or along the axis.
    RETURN format('CASE WHEN %s THEN %s - t.%I ELSE %s END', backwards,
      CASE WHEN back THEN format('(SELECT %s FROM test.edge_pair WHERE moved_id = %s)', CASE WHEN relation IN ('edge', 'lane') THEN 'axis_length' ELSE 'length' END, id) ELSE format(asks, kind, id, 'length') END,
      other, plain);
  ELSIF col ~ 'abscissa' AND relation <> 'road_edge' THEN
    RETURN format('CASE WHEN %s THEN %s - %s ELSE %3$s END', backwards, format(asks, kind, id, 'length'), plain);
  ELSIF col ~ '^(which|end_a|end_b)$' THEN
    RETURN format('CASE WHEN %s THEN test.exchanged(%s, ''start'', ''end'') ELSE %2$s END', backwards, plain);
  ELSIF col IN ('leftwards', 'rightwards') OR col ~ '_(left|right)$' AND test.exchanged(col, 'left', 'right')::name = ANY (columns) THEN
    RETURN format('CASE WHEN %s THEN t.%s ELSE %s END', flipped, test.exchanged(col, 'left', 'right'), plain);
  ELSIF col = 'side' OR relation = 'transition_override' AND col = 'kind' THEN
    RETURN format('CASE WHEN %s THEN test.exchanged(%s, ''left'', ''right'') ELSE %2$s END', CASE WHEN relation = 'ramp' OR relation = 'placement_rule' THEN m.mirrored::text ELSE flipped END, plain);
  ELSIF col IN ('roadway_offset') OR col = 'axis_offset' AND relation NOT IN ('placement_rule', 'street_object') THEN
    RETURN format('CASE WHEN %s THEN -%s ELSE %2$s END', flipped, plain);
  ELSIF col = 'axis_offset' THEN
    RETURN format('CASE WHEN %s AND %s THEN -%s ELSE %3$s END', CASE WHEN relation = 'placement_rule' THEN m.mirrored::text ELSE flipped END,
      CASE relation WHEN 'placement_rule' THEN 't.along = ''axis''' ELSE 't.placement = ''axis''' END, plain);
  ELSIF col IN ('along_axis', 'along_in', 'along_out') THEN
    RETURN format('%s <> (%s%s)', plain, backwards, CASE WHEN relation IN ('lane', 'lane_override') THEN ' AND NOT coalesce(t.both_ways, false)' ELSE '' END);
  ELSIF col IN ('ordinality', 'lane_from', 'lane_to') AND relation IN ('lane', 'lane_override', 'lane_adjacency_override') THEN
    RETURN format('CASE WHEN %s THEN test.ordinality_backwards(%s, (SELECT count(*)::integer FROM %I.lane l JOIN %3$I.edge e USING (edge_id) WHERE l.kind <> ''merging'' AND %s)) ELSE %2$s END', backwards, plain, model,
      CASE relation WHEN 'lane' THEN 'e.edge_id = t.edge_id' ELSE 'e.axis_id = t.axis_id AND t.abscissa BETWEEN e.start_abscissa AND e.end_abscissa' END);
  ELSIF relation = 'interconnection_override' AND col IN ('lane_in', 'lane_out') THEN
    RETURN format('CASE WHEN %s THEN test.ordinality_backwards(%s, (SELECT count(*)::integer FROM %I.lane l WHERE l.kind <> ''merging'' AND l.edge_id = (SELECT edge_id FROM %3$I.edge e WHERE e.axis_id = %s ORDER BY ST_Distance(e.geom, t.geom) LIMIT 1))) ELSE %2$s END',
      backwards, plain, model, id);
  ELSIF col = 'lane_position' AND back THEN
    -- Of a line between lanes, that of the lane to its left.
    RETURN format('CASE WHEN %s THEN (SELECT lanes FROM test.edge_pair WHERE moved_id = t.edge_id) + %s - %s ELSE %3$s END', flipped, CASE relation WHEN 'lane_separator' THEN 0 ELSE 1 END, plain);
  ELSIF col = 'direction' THEN
    RETURN format('CASE WHEN %s THEN test.exchanged(%s, ''direct'', ''reverse'') ELSE %2$s END', backwards, plain);
  ELSIF col ~ '^(kind|lane_width|turn|change)_(forward|backward)$' THEN
    plain := format('CASE WHEN %s THEN t.%I ELSE t.%I END', backwards, other, col);
    RETURN CASE WHEN m.mirrored THEN format('test.backwards(test.exchanged(%s, ''left'', ''right''))', plain) ELSE plain END;
  ELSIF col = 'turn' THEN
    -- Marks of a lane in any order.
    plain := CASE WHEN m.mirrored THEN format('test.exchanged(%s, ''left'', ''right'')', plain) ELSE plain END;
    RETURN CASE relation WHEN 'lane' THEN format('ARRAY(SELECT string_to_table(%s, '';'') ORDER BY 1)', plain) ELSE plain END;
  ELSIF col = 'angle' AND relation IN ('interconnection', 'junction_movement', 'parking_bay', 'pedestrian_crossing') OR relation = 'placement_rule' AND col = 'orientation' THEN
    RETURN CASE WHEN m.mirrored THEN '-' ELSE '' END || plain;
  ELSIF col = 'angle' OR relation = 'street_object' AND col = 'orientation' THEN
    -- Degrees clockwise from the north, or from the axis.
    RETURN format('CASE WHEN %s THEN %s ELSE %s END', CASE col WHEN 'angle' THEN 'true' ELSE 't.orientation_kind = ''absolute''' END,
      CASE WHEN back AND m.mirrored THEN format('-(%s + %s)', plain, m.turn) WHEN back THEN format('%s + %s', plain, m.turn) ELSE format('%s%s - %s', CASE WHEN m.mirrored THEN '-' ELSE '' END, plain, m.turn) END,
      format('CASE WHEN %s THEN 180 ELSE 0 END %s %s', backwards, CASE WHEN m.mirrored THEN '-' ELSE '+' END, plain));
  ELSIF col = 'estimated' THEN
    RETURN format('ARRAY(SELECT CASE WHEN %s THEN test.exchanged(w, ''forward'', ''backward'') ELSE w END AS w FROM (SELECT CASE WHEN %s THEN test.exchanged(w, ''left'', ''right'') ELSE w END AS w FROM unnest(%s) w) w ORDER BY 1)', backwards, flipped, plain);
  ELSIF col = 'interconnections' THEN
    RETURN format('cardinality(%s)', plain);
  ELSIF col ~ '^source_width' OR col = 'width_end' AND relation = 'axis' OR col = 'width' AND relation = 'axis' THEN
    RETURN format('CASE WHEN %s AND t.%s IS NOT NULL THEN t.%I ELSE %s END', backwards, CASE WHEN col LIKE 'source%' THEN 'source_width_end' ELSE 'width_end' END, other, plain);
  ELSIF other IS NOT NULL AND other = ANY (columns) THEN
    RETURN format('CASE WHEN %s THEN t.%I ELSE %s END', backwards, other, plain);
  END IF;
  RETURN plain;
END $$;

-- All columns of a table of a model, with their types.
CREATE FUNCTION test.columns(model name, relation name) RETURNS TABLE (col name, type text) LANGUAGE sql STABLE AS $$
  SELECT attname, format_type(atttypid, atttypmod) FROM pg_attribute
  WHERE attrelid = to_regclass(format('%I.%I', model, relation)) AND attnum > 0 AND NOT attisdropped AND attgenerated = '' ORDER BY attnum $$;

-- The rows of a table on the other paper, as a query.
CREATE FUNCTION test.moved_rows(of_model name, relation name, back boolean) RETURNS text LANGUAGE sql AS $$
  SELECT format('SELECT %s FROM %I.%I t', string_agg(format('%s AS %I', test.moved_column(relation, col, type, all_columns, back), col), ', '), of_model, relation)
  FROM (SELECT *, array_agg(col) OVER () AS all_columns FROM test.columns(of_model, relation)) c $$;

-- Makes another model of all input of a model, on moved paper, and generates it.
CREATE PROCEDURE test.move(of_model name, to_model name, turn float8 DEFAULT 0, shift_x float8 DEFAULT 0, shift_y float8 DEFAULT 0, mirrored boolean DEFAULT false,
  reversed boolean DEFAULT false, renumbered boolean DEFAULT false)
LANGUAGE plpgsql AS $$
DECLARE
  input name;
  side constant text := (SELECT value FROM streetgen.setting(of_model) WHERE name = 'driving_side');
BEGIN
  PERFORM streetgen.drop_model(to_model) WHERE EXISTS (SELECT FROM streetgen.model WHERE name = to_model);
  PERFORM streetgen.create_model(to_model, (SELECT srid FROM streetgen.model WHERE name = of_model), subjects => streetgen._subjects(of_model));
  PERFORM streetgen.live(to_model, false);
  PERFORM streetgen.set(to_model, s.name, s.value) FROM streetgen.setting(of_model) s JOIN streetgen.setting(to_model) t USING (name) WHERE s.value IS DISTINCT FROM t.value;
  IF mirrored THEN
    PERFORM streetgen.set(to_model, 'driving_side', CASE side WHEN 'left' THEN 'right' ELSE 'left' END),
      streetgen.set(to_model, s.name, test.exchanged(s.value, 'left', 'right')) FROM streetgen.setting(of_model) s WHERE s.name IN ('lane_order', 'transition_kind');
  END IF;
  DELETE FROM test.movement;
  EXECUTE format('INSERT INTO test.movement SELECT $1, $2, $3, $4, $5, $6, $7, $8, floor(ST_XMin(e) + ST_XMax(e)) / 2, floor(ST_YMin(e) + ST_YMax(e)) / 2 FROM (SELECT ST_Extent(geom) AS e FROM %I.axis) e', of_model)
    USING of_model, to_model, turn, shift_x, shift_y, mirrored, reversed, renumbered;
  TRUNCATE test.axis_pair;
  -- Other numbers: in an order that has nothing to do with the former one. Every second axis is drawn backwards, but where a tag says that one drives along it, and where
  -- an odd number of lanes is shared out by its direction.
  EXECUTE format('INSERT INTO test.axis_pair SELECT axis_id, CASE WHEN $1 THEN row_number() OVER (ORDER BY md5(axis_id::text)) ELSE axis_id END,
      $2 AND row_number() OVER (ORDER BY axis_id) %% 2 = 0 AND a.roundabout_tag IS NULL AND (a.direction <> ''both'' OR u.lanes_forward = u.lanes_backward OR (a.lanes_forward, a.lanes_backward) IS NOT NULL), ST_Length(ST_Force2D(a.geom))
    FROM %1$I.axis a JOIN %1$I.axis_used u USING (axis_id)', of_model)
    USING renumbered, reversed;
  ANALYZE test.axis_pair;
  PERFORM set_config('streetgen.computes', 'on', false);
  FOR input IN SELECT relname FROM pg_class WHERE relnamespace = quote_ident(of_model)::regnamespace AND relkind = 'r'
      AND (relname IN ('axis', 'axis_class', 'turn_restriction', 'control_point', 'roundabout_pattern', 'object_type', 'placement_rule', 'street_object') OR relname LIKE '%\_override')
      ORDER BY array_position('{axis_class,axis,object_type,placement_rule,control_point,street_object}'::name[], relname) LOOP
    EXECUTE format('DELETE FROM %I.%I', to_model, input);
    EXECUTE format('INSERT INTO %I.%I (%s) %s%s', to_model, input, (SELECT string_agg(quote_ident(col), ', ') FROM test.columns(of_model, input)), test.moved_rows(of_model, input, false),
      CASE input WHEN 'street_object' THEN ' WHERE t.placed_by <> ''rule''' ELSE '' END);
  END LOOP;
  PERFORM set_config('streetgen.computes', '', false);
  PERFORM streetgen.generate(to_model);
  CALL test.pair_up();
END $$;

-- Which edges, nodes, lanes and things of both papers are the same.
CREATE PROCEDURE test.pair_up() LANGUAGE plpgsql AS $$
DECLARE
  m constant test.movement := (SELECT movement FROM test.movement);
  kind text;
  is_moved boolean;
BEGIN
  TRUNCATE test.edge_pair, test.node_pair, test.lane_pair, test.thing;
  EXECUTE format($q$INSERT INTO test.edge_pair SELECT DISTINCT ON (m.edge_id) e.edge_id, m.edge_id, p.reversed, p.length, ST_Length(e.geom), n.lanes
    FROM test.axis_pair p JOIN %1$I.edge e USING (axis_id) JOIN %2$I.edge m ON m.axis_id = p.moved_id
    LEFT JOIN LATERAL (SELECT max(lane_position) AS lanes FROM %1$I.lane l WHERE l.edge_id = e.edge_id) n ON true
    WHERE abs(CASE WHEN p.reversed THEN p.length - m.end_abscissa ELSE m.start_abscissa END - e.start_abscissa) < 0.1
      AND abs(CASE WHEN p.reversed THEN p.length - m.start_abscissa ELSE m.end_abscissa END - e.end_abscissa) < 0.1 ON CONFLICT DO NOTHING$q$,
    m.model, m.moved);
  ANALYZE test.edge_pair;
  EXECUTE format($q$INSERT INTO test.node_pair SELECT DISTINCT ON (moved) node, moved FROM (
      SELECT e.from_node AS node, CASE WHEN p.reversed THEN m.to_node ELSE m.from_node END AS moved FROM test.edge_pair p JOIN %1$I.edge e USING (edge_id) JOIN %2$I.edge m ON m.edge_id = p.moved_id
      UNION SELECT e.to_node, CASE WHEN p.reversed THEN m.from_node ELSE m.to_node END FROM test.edge_pair p JOIN %1$I.edge e USING (edge_id) JOIN %2$I.edge m ON m.edge_id = p.moved_id) n
    ORDER BY moved, node ON CONFLICT DO NOTHING$q$, m.model, m.moved);
  ANALYZE test.node_pair;
  IF to_regclass(format('%I.lane', m.model)) IS NOT NULL THEN
    EXECUTE format($q$INSERT INTO test.lane_pair SELECT DISTINCT ON (m.lane_id) l.lane_id, m.lane_id, p.reversed FROM test.edge_pair p JOIN %1$I.lane l USING (edge_id)
      JOIN %2$I.lane m ON m.edge_id = p.moved_id AND m.lane_position = CASE WHEN p.reversed <> %3$L THEN p.lanes + 1 - l.lane_position ELSE l.lane_position END$q$, m.model, m.moved, m.mirrored);
    ANALYZE test.lane_pair;
  END IF;
  FOR kind, is_moved IN SELECT k, b FROM unnest('{junction_node,road_edge,roundabout_edge,block_edge}'::text[]) k, unnest('{false,true}'::boolean[]) b
      WHERE to_regclass(format('%I.%I', m.model, k)) IS NOT NULL LOOP
    EXECUTE format('INSERT INTO test.thing SELECT %L, %L, t.%I, min(%s) FROM %I.%I t WHERE t.%3$I IS NOT NULL GROUP BY t.%3$I', split_part(kind, '_', 1), is_moved, split_part(kind, '_', 1) || '_id',
      CASE WHEN is_moved THEN test.moved_column(kind, split_part(kind, '_', 2) || '_id', 'bigint', ARRAY[split_part(kind, '_', 2) || '_id']::name[], true) ELSE 't.' || split_part(kind, '_', 2) || '_id' END
      || '::text' || CASE kind WHEN 'block_edge' THEN ' || ' || CASE WHEN is_moved THEN test.moved_column(kind, 'side', 'text', '{edge_id,side}', true) ELSE 't.side' END ELSE '' END,
      CASE WHEN is_moved THEN m.moved ELSE m.model END, kind);
  END LOOP;
  ANALYZE test.thing;
END $$;

-- A column of a row of the model itself, as test.moved_column gives it back.
CREATE FUNCTION test.plain_column(relation name, col name) RETURNS text LANGUAGE sql IMMUTABLE AS $$
  SELECT CASE WHEN col ~ '^(junction|controller|road|block|roundabout)_id$'
      THEN format('(SELECT name FROM test.thing WHERE kind = %L AND NOT is_moved AND id = t.%I)', CASE col WHEN 'controller_id' THEN 'junction' ELSE regexp_replace(col, '_id$', '') END, col)
    WHEN relation = 'report' AND col IN ('axis_a', 'axis_b') THEN format('CASE t.issue WHEN ''wide_cluster'' THEN NULL ELSE %s(t.axis_a, t.axis_b) END', CASE col WHEN 'axis_a' THEN 'least' ELSE 'greatest' END)
    WHEN col = 'interconnections' THEN 'cardinality(t.interconnections)'
    WHEN col = 'estimated' THEN 'ARRAY(SELECT unnest(t.estimated) ORDER BY 1)'
    WHEN relation = 'lane' AND col = 'turn' THEN 'ARRAY(SELECT string_to_table(t.turn, '';'') ORDER BY 1)'
    ELSE format('t.%I', col) END $$;

-- How far apart two geometries are, metres; of surfaces the area between them for each metre of border.
CREATE FUNCTION test.apart(a geometry, b geometry) RETURNS float8 LANGUAGE plpgsql IMMUTABLE AS $$
DECLARE
  off float8;
BEGIN
  IF a IS NULL AND b IS NULL OR ST_IsEmpty(a) AND ST_IsEmpty(b) THEN
    RETURN 0;
  ELSIF a IS NULL OR b IS NULL OR ST_IsEmpty(a) OR ST_IsEmpty(b) OR ST_Dimension(a) <> ST_Dimension(b) THEN
    RETURN 'Infinity';
  END IF;
  off := CASE WHEN ST_HasArc(a) OR ST_HasArc(b) THEN ST_HausdorffDistance(ST_Points(a), ST_Points(b)) ELSE ST_HausdorffDistance(a, b) END;
  RETURN CASE WHEN off > 1e-7 AND ST_Dimension(a) = 2 THEN ST_Area(ST_SymDifference(a, b)) / greatest(ST_Perimeter(a), ST_Perimeter(b)) ELSE off END;
END $$;

-- What tells the rows of a table: columns, and where these do not suffice the place.
CREATE FUNCTION test.moved_key(relation name) RETURNS text[] LANGUAGE sql IMMUTABLE AS $$
  SELECT CASE relation
    WHEN 'section_limit' THEN '{edge_id,which}' WHEN 'corner' THEN '{node_id,edge_a,end_a,edge_b,end_b}' WHEN 'lane' THEN '{edge_id,lane_position}'
    WHEN 'lane_separator' THEN '{edge_id,lane_position}' WHEN 'marking' THEN '{edge_id,kind,lane_position,along_axis}'
    WHEN 'interconnection' THEN '{lane_in,lane_out,along_in,along_out}' WHEN 'junction_movement' THEN '{lane_in,lane_out,along_in,along_out}'
    WHEN 'kerb' THEN '{on_edge,node_id}' WHEN 'sidewalk' THEN '{on_edge,node_id}' WHEN 'block_edge' THEN '{edge_id,side}' WHEN 'roundabout_arm' THEN '{roundabout_id,edge_id,along_axis}'
    WHEN 'overpass' THEN '{edge_above,edge_below}' WHEN 'bridge' THEN '{edge_id}' WHEN 'tunnel' THEN '{edge_id}' WHEN 'report' THEN '{issue}' WHEN 'signal_state' THEN '{controller_id,ordinality}'
    WHEN 'signal_movement' THEN '{controller_id,lane_in,lane_out,along_in,along_out,ordinality}' WHEN 'signal_group' THEN '{controller_id,signal_group}' WHEN 'intergreen' THEN '{controller_id,ends,begins}'
    WHEN 'signal_head' THEN '{lane_id,along_axis}' WHEN 'ramp' THEN '{node_id}'
    WHEN 'roundabout_edge' THEN '{edge_id,along_axis}' WHEN 'node' THEN '{node_id}' WHEN 'intersection' THEN '{node_id}' WHEN 'junction_node' THEN '{node_id}'
    WHEN 'road' THEN '{road_id}' WHEN 'block' THEN '{block_id}' WHEN 'junction' THEN '{junction_id}' WHEN 'controller' THEN '{controller_id}' WHEN 'roundabout' THEN '{roundabout_id}'
    WHEN 'street_object' THEN '{type}' WHEN 'object_edge' THEN '{edge_id}' ELSE '{edge_id}' END::text[] $$;

-- Columns that say nothing of the place: keys that count, hashes; what is counted from the axis or edge that has the smallest number, or from one end of an axis.
CREATE FUNCTION test.left_out(relation name, col name) RETURNS boolean LANGUAGE sql STABLE AS $$
  SELECT col ~ '_hash$|^(kerb|sidewalk|lane|lane_separator|marking|corner|section_limit|interconnection|junction_movement|overpass|bridge|tunnel|ramp|roundabout_edge|roundabout_arm|street_object|rule|rule_place|control_point)_id$|^borders$'
      AND NOT (relation = 'signal_head' AND col = 'lane_id') AND NOT (relation = 'ramp' AND col = 'ramp_id' AND false)
    OR (relation, col) IN (('kerb', 'part'), ('sidewalk', 'part'), ('kerb', 'edge_id'), ('sidewalk', 'edge_id'), ('kerb', 'side'), ('sidewalk', 'side'),
      ('block_edge', 'ring'), ('block_edge', 'ordinality'), ('overpass', 'ordinality'), ('road', 'from_node'), ('road', 'to_node'), ('road_edge', 'position'), ('road_edge', 'along_road'), ('road_edge', 'start_abscissa'),
      ('roundabout', 'edge_id'), ('roundabout', 'along_axis'), ('roundabout_edge', 'ordinality'), ('roundabout_edge', 'face'))
    OR reversed AND (relation, col) IN (('lane', 'width'), ('lane', 'axis_offset'), ('lane_separator', 'axis_offset'))
  FROM test.movement $$;

-- Table by table: rows of both models; rows of one alone; rows that differ by over a micrometre (of a surface for each metre of border, of an angle a metre away) or in what they say; the widest of these; square metres
-- that differ; where the largest is, on the paper of the model; and the columns that differ.
CREATE FUNCTION test.moved_difference(only_relation name DEFAULT NULL) RETURNS TABLE (relation name, rows bigint, rows_moved bigint, alone bigint, differ bigint, widest float8, area float8, place text, cols text) LANGUAGE plpgsql AS $$
DECLARE
  m constant test.movement := (SELECT movement FROM test.movement);
  all_cols name[];
  scalars name[];
  numbers name[];
  geometries name[];
  key_columns text;
  said text;
  part text;
  order_by text;
  geometry_of text;
  place_of text;
BEGIN
  FOR relation IN SELECT t.relation FROM streetgen._computed_table() t WHERE to_regclass(format('%I.%I', m.model, t.relation)) IS NOT NULL AND t.relation <> 'object_edge' AND t.relation = coalesce(only_relation, t.relation) ORDER BY t.place LOOP
    SELECT array_agg(col), array_agg(col) FILTER (WHERE type NOT LIKE 'geometry%' AND type <> 'double precision' AND NOT test.left_out(relation, col)),
        array_agg(col) FILTER (WHERE type = 'double precision' AND NOT test.left_out(relation, col)), array_agg(col) FILTER (WHERE type LIKE 'geometry%')
      INTO all_cols, scalars, numbers, geometries FROM test.columns(m.model, relation);
    key_columns := (SELECT string_agg(CASE WHEN k = 'on_edge' THEN 'CASE WHEN node_id IS NULL THEN edge_id END' ELSE k END, ', ') FROM unnest(test.moved_key(relation)) k);
    -- A row of an edge and one of a node may have one number.
    said := (SELECT string_agg(format('coalesce((%s)::text, ''-'')', CASE WHEN k = 'on_edge' THEN 'CASE WHEN node_id IS NULL THEN edge_id END' ELSE k END), ', ') FROM unnest(test.moved_key(relation)) k);
    geometry_of := (SELECT g FROM unnest(geometries) g ORDER BY g <> 'geom' LIMIT 1);
    place_of := CASE WHEN geometry_of IS NOT NULL THEN format('ST_Centroid(%I)', geometry_of) ELSE 'NULL::geometry' END;
    order_by := CASE WHEN geometry_of IS NOT NULL THEN format('0.8 * ST_X(%1$s) + 0.6 * ST_Y(%1$s)', place_of) WHEN 'start_abscissa' = ANY (all_cols) THEN 'start_abscissa' ELSE '1' END;
    EXECUTE 'DROP TABLE IF EXISTS pg_temp.here, pg_temp.there, pg_temp.met';
    EXECUTE format('CREATE TEMP TABLE here AS SELECT *, concat_ws('' '', %s) AS key, row_number() OVER (PARTITION BY %s ORDER BY %s) AS ordinal, count(*) OVER (PARTITION BY %2$s) AS of_key, %4$s AS place
        FROM (SELECT %5$s FROM %6$I.%7$I t) t', said, key_columns, order_by, place_of, (SELECT string_agg(format('%s AS %I', test.plain_column(relation, col), col), ', ') FROM unnest(all_cols) col), m.model, relation);
    EXECUTE format('CREATE TEMP TABLE there AS SELECT *, concat_ws('' '', %s) AS key, row_number() OVER (PARTITION BY %s ORDER BY %s) AS ordinal, count(*) OVER (PARTITION BY %2$s) AS of_key, %4$s AS place
        FROM (%5$s) t', said, key_columns, order_by, place_of, test.moved_rows(m.moved, relation, true));
    CREATE TEMP TABLE met AS SELECT key, a.ordinal AS ordinal_a, b.ordinal AS ordinal_b FROM here a JOIN there b USING (key) WHERE a.of_key = 1 AND b.of_key = 1;
    IF geometry_of IS NOT NULL THEN
      CREATE INDEX ON here USING gist (place);
      CREATE INDEX ON there USING gist (place);
      -- Two of one key that are each other's nearest.
      INSERT INTO met SELECT a.key, a.ordinal, b.ordinal FROM here a
        CROSS JOIN LATERAL (SELECT * FROM there b WHERE b.key = a.key ORDER BY b.place <-> a.place, b.ordinal LIMIT 1) b
        CROSS JOIN LATERAL (SELECT * FROM here c WHERE c.key = b.key ORDER BY c.place <-> b.place, c.ordinal LIMIT 1) c
        WHERE (a.of_key > 1 OR b.of_key > 1) AND a.ordinal = c.ordinal;
    END IF;
    -- The rest in their order across the paper.
    INSERT INTO met SELECT key, a.ordinal, b.ordinal
      FROM (SELECT *, row_number() OVER (PARTITION BY key ORDER BY ordinal) AS n FROM here a WHERE NOT EXISTS (SELECT FROM met WHERE met.key = a.key AND ordinal_a = a.ordinal)) a
      JOIN (SELECT *, row_number() OVER (PARTITION BY key ORDER BY ordinal) AS n FROM there b WHERE NOT EXISTS (SELECT FROM met WHERE met.key = b.key AND ordinal_b = b.ordinal)) b USING (key, n);
    -- Angles of a circle are the same a whole turn on. A part of an edge's side ends at a whole millimetre from the start of the edge.
    part := (SELECT coalesce(string_agg(format('CASE WHEN ' || CASE n WHEN 'angle' THEN 'abs(a.%1$I - b.%1$I - 360 * round(((a.%1$I - b.%1$I) / 360)::numeric))' ELSE 'abs(a.%1$I - b.%1$I)' END || ' > ' || CASE WHEN n = 'contested_area' THEN '1e-6 * greatest(1, ST_Perimeter(a.surface))' WHEN n = 'angle' THEN 'degrees(1e-6)'
      WHEN m.reversed AND relation = 'block_edge' THEN '1.001e-3' ELSE '1e-6 + 1e-9 * abs(a.%1$I)' END || ' OR (a.%1$I IS NULL) <> (b.%1$I IS NULL) THEN %1$L END', n), ', '), 'NULL') FROM unnest(numbers) n)
      || (SELECT coalesce(string_agg(format(', CASE WHEN a.%1$I IS DISTINCT FROM b.%1$I THEN %1$L END', n), ''), '') FROM unnest(scalars) n);
    EXECUTE format($q$WITH both_sides AS MATERIALIZED (SELECT a.key AS a_key, b.key AS b_key, concat_ws(' ', %s%s) AS cols, greatest(0%s) AS apart, %s AS area, %s AS place
        FROM (here a LEFT JOIN met ON met.key = a.key AND ordinal_a = a.ordinal) FULL JOIN there b ON b.key = met.key AND b.ordinal = ordinal_b),
        told AS (SELECT *, a_key IS NULL OR b_key IS NULL AS is_alone FROM both_sides)
      SELECT (SELECT count(*) FROM here), (SELECT count(*) FROM there), count(*) FILTER (WHERE is_alone), count(*) FILTER (WHERE NOT is_alone AND (cols <> '' OR apart > 1e-6)),
        max(apart) FILTER (WHERE NOT is_alone), sum(area) FILTER (WHERE NOT is_alone), (array_agg(ST_AsText(ST_Centroid(place), 1) ORDER BY is_alone DESC, apart DESC, area DESC) FILTER (WHERE is_alone OR cols <> '' OR apart > 1e-6))[1],
        (SELECT string_agg(w || ' ' || n, ' ' ORDER BY n DESC) FROM (SELECT w, count(*) AS n FROM told t2, string_to_table(t2.cols, ' ') w WHERE NOT t2.is_alone AND w <> '' GROUP BY w) w)
      FROM told$q$, part, (SELECT coalesce(string_agg(format(', CASE WHEN test.apart(a.%1$I, b.%1$I) > 1e-6 THEN %1$L END', g), ''), '') FROM unnest(geometries) g),
      (SELECT coalesce(string_agg(format(', test.apart(a.%1$I, b.%1$I)', g), ''), '') FROM unnest(geometries) g),
      CASE WHEN 'surface' = ANY (geometries) THEN 'CASE WHEN test.apart(a.surface, b.surface) > 1e-7 AND NOT ST_IsEmpty(a.surface) AND NOT ST_IsEmpty(b.surface) THEN ST_Area(ST_SymDifference(a.surface, b.surface)) ELSE abs(ST_Area(a.surface) - ST_Area(b.surface)) END' ELSE '0::float8' END,
      CASE WHEN geometry_of IS NULL THEN 'NULL::geometry' ELSE format('coalesce(a.%1$I, b.%1$I)', geometry_of) END)
      INTO rows, rows_moved, alone, differ, widest, area, place, cols;
    RETURN NEXT;
  END LOOP;
END $$;
