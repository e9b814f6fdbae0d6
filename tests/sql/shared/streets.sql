-- A call of streetgen._streets on two axes, with other arguments than these by name, as SQL.
CREATE FUNCTION test.streets(given text) RETURNS text LANGUAGE sql AS $$
    SELECT 'SELECT count(*) FROM streetgen._streets(' || string_agg(name || ' => ' || coalesce(given::jsonb ->> name, value), ', ') || ')' FROM (VALUES
        ('axis_id', '''{7,8}'''), ('geom', 'ARRAY[''LINESTRING(0 0,50 0)''::geometry::bytea, ''LINESTRING(0 0,0 50)''::geometry::bytea]'),
        ('width', '''{7,6}'''), ('width_end', '''{7,6}'''), ('radius', '''{3,3}'''), ('importance', '''{4,4}'''), ('level', '''{0,0}'''), ('srid', '0'),
        ('tolerance', '0.5'), ('crossing', '''over'''), ('max_arc_distance', '60'), ('radius_minimal', '0.15'), ('transition_length', '10'), ('transition_kind', '''left'''),
        ('radius_rule', '''mean'''), ('round_dead_ends', 'true'), ('max_hole_area', '0.5'), ('reach', '60'), ('short_axis', '''reduce'''),
        ('transition_axis', '''{7}'''), ('transition_which', '''{start}'''), ('transition_kind_of', '''{right}'''), ('transition_length_of', '''{9}'''),
        ('lanes_forward', '''{1,2}'''), ('lanes_backward', '''{1,0}'''), ('kind_forward', '''{"",general|bus}'''), ('kind_backward', '''{"",""}'''),
        ('lane_width_forward', '''{"",3|}'''), ('lane_width_backward', '''{"",""}'''), ('turn_forward', '''{left;through,""}'''), ('turn_backward', '''{"",""}'''),
        ('override_axis', '''{7}'''), ('override_abscissa', '''{1}'''), ('override_ordinality', '''{1}'''), ('override_direction', '''{along}'''), ('override_width', '''{3}'''),
        ('lane_order', '''right_first'''), ('driving_side', '''left'''), ('lane_width_minimal', '2'), ('cycle_lane_width', '1.5'), ('parking_lane_width', '2'), ('edge_lines', 'true'),
        ('speed', '''{50,30}'''), ('restriction_from', '''{7}'''), ('restriction_to', '''{8}'''), ('restriction_x', '''{0}'''), ('restriction_y', '''{0}'''), ('restriction_kind', '''{only}'''), ('restriction_turn', '''{""}'''),
        ('u_turn', 'true'), ('trajectory', '''arcs'''), ('trajectory_tolerance', '0.05'), ('trajectory_radius', '3'),
        ('changed', '''{t,t}'''), ('beside', '''{f,f}'''), ('former_axis', '''{7}'''), ('former_geom', 'ARRAY[''LINESTRING(0 0,50 0)''::geometry::bytea]'), ('former_wanted_start', '''{0}'''), ('former_start', '''{0}'''), ('former_wanted_end', '''{50}'''), ('former_end', '''{50}'''), ('former_x', '''{}'''), ('former_y', '''{}'''), ('former_met', '''{}'''),
        ('override_line', 'ARRAY[''LINESTRING(0 1,50 1)''::geometry::bytea]'), ('limit_axis', '''{7}'''), ('limit_abscissa', '''{9}'''), ('limit_which', '''{start}'''),
        ('corner_a', '''{7}'''), ('corner_b', '''{8}'''), ('corner_x', '''{0}'''), ('corner_y', '''{0}'''), ('corner_radius', '''{4}'''), ('outer_axis', '''{f,f}''')) v(name, value) $$;
