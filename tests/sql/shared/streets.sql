-- A call of streetgen._streets on two axes, as SQL: given names settings, srid, or columns of a list (axes.width) with their values, one a row.
CREATE FUNCTION test.streets(given jsonb) RETURNS text LANGUAGE sql AS $$
    WITH list(name, type, columns) AS (VALUES
        ('axes', 'street_axis', '{"axis_id": "{7,8}", "level": "{0,0}", "width": "{7,6}", "width_end": "{7,6}", "roadway_offset": "{0,1}", "radius": "{3,3}", "importance": "{4,4}", "speed": "{50,30}",
            "geom": ["LINESTRING(0 0,50 0)", "LINESTRING(0 0,0 50)"], "lanes_forward": "{1,2}", "lanes_backward": "{1,0}", "lanes_both": "{0,1}", "kind_forward": "{NULL,general|bus}", "kind_backward": "{NULL,NULL}",
            "lane_width_forward": "{NULL,3|}", "lane_width_backward": "{NULL,NULL}", "lane_width_maximal": "{NULL,4}", "turn_forward": "{left;through,NULL}", "turn_backward": "{NULL,NULL}", "access": "{NULL,NULL}",
            "on_ring": "{f,f}", "street": "{0,5}", "changed": "{t,t}", "outer_axis": "{f,f}"}'::jsonb),
        ('transitions', 'street_transition', '{"axis_id": "{7}", "which": "{start}", "kind": "{right}", "length": "{9}"}'),
        ('limits', 'street_limit', '{"axis_id": "{7}", "abscissa": "{9}", "which": "{start}"}'),
        ('corners', 'street_corner', '{"axis_a": "{7}", "axis_b": "{8}", "x": "{0}", "y": "{0}", "radius": "{4}"}'),
        ('lanes', 'street_lane', '{"axis_id": "{7}", "abscissa": "{1}", "ordinality": "{1}", "along_axis": "{t}", "both_ways": "{NULL}", "width": "{3}", "line": ["LINESTRING(0 1,50 1)"]}'),
        ('restrictions', 'street_restriction', '{"from_axis": "{7}", "to_axis": "{8}", "x": "{0}", "y": "{0}", "kind": "{only}", "turn": "{NULL}", "except_kinds": "{bus|cycle}"}'),
        ('former_edges', 'former_edge', '{"axis_id": "{7}", "start_abscissa": "{0}", "end_abscissa": "{50}", "geom": ["LINESTRING(0 0,50 0)"], "wanted_start": "{0}", "start": "{0}", "border_start": ["LINESTRING(0 3,0 -3)"],
            "wanted_end": "{50}", "end": "{50}", "border_end": ["LINESTRING(50 3,50 -3)"], "surface": ["MULTIPOLYGON(((0 3,0 -3,50 -3,50 3,0 3)))"], "contested": "{f}", "level": "{0}", "borders": "{\"\"}", "beside_left": "{outer}", "beside_right": "{median}", "median_left": "{\"\"}", "median_right": "{\"\"}"}'),
        ('former_nodes', 'former_node', '{"x": "{1}", "y": "{2}", "surface": ["MULTIPOLYGON EMPTY"], "contested": "{f}", "level": "{0}"}'),
        ('neighbours', 'street_neighbour', '{"x": "{9}", "y": "{9}", "x_end": "{NULL}", "y_end": "{NULL}", "surface": ["MULTIPOLYGON(((9 9,9 11,11 9,9 9)))"], "level": "{0}"}')),
    given_list AS (
        SELECT name, type, columns || coalesce((SELECT jsonb_object_agg(substr(key, length(name) + 2), value) FROM jsonb_each(given) WHERE starts_with(key, name || '.')), '{}') AS columns FROM list),
    argument AS (
        SELECT format('%s => (SELECT array_agg(ROW (%s)::streetgen.%s) FROM ROWS FROM (%s) t(%s))', name, string_agg(quote_ident(attname), ', ' ORDER BY attnum), type,
            string_agg(CASE jsonb_typeof(columns -> attname) WHEN 'array' THEN format('unnest(ARRAY(SELECT w::geometry::bytea FROM unnest(%L::text[]) w))', ARRAY(SELECT jsonb_array_elements_text(columns -> attname)))
                       ELSE format('unnest(%L::%s[])', columns ->> attname, format_type(atttypid, atttypmod)) END, ', ' ORDER BY attnum), string_agg(quote_ident(attname), ', ' ORDER BY attnum)) AS text
        FROM given_list JOIN pg_attribute ON attrelid = ('streetgen.' || type)::regclass GROUP BY name, type)
    SELECT format('SELECT count(*) FROM streetgen._streets(srid => %s, settings => %L, %s)', coalesce(given ->> 'srid', '0'),
        (SELECT jsonb_object_agg(name, value) FROM streetgen._default_setting()) || given, string_agg(text, ', ')) FROM argument $$;
