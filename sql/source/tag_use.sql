-- What becomes of each tag and column that importers of known sources look at.

CREATE OR REPLACE FUNCTION streetgen.tag_use() RETURNS TABLE(source text, tag text, becomes text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 100 SET search_path = pg_catalog
    AS $$
    SELECT 'OpenStreetMap, ' || of, u.tag, u.becomes FROM streetgen._osm_tag_use() u
    UNION ALL VALUES
    ('OpenStreetMap, ways', 'footway',
        'Of what is walked or cycled on: sidewalk is the sidewalk of the street beside it, crossing leads over one.'),
    ('OpenStreetMap, ways', 'surface, incline, wheelchair, tactile_paving',
        'Of what is walked or cycled on: columns of its footway; incline as percent, or up and down.'),
    ('OpenStreetMap, ways', 'foot',
        'Of what is walked or cycled on: column foot of its footway, as tag access where that says nothing.'),
    ('OpenStreetMap, ways', 'cycleway, path',
        'Of what is walked or cycled on: crossing leads over a street, as footway=crossing does.'),
    ('OpenStreetMap, ways', 'crossing, crossing:markings',
        'Of what leads over a street: how the crossing is painted, column marking of its footway, as of nodes.'),
    ('OpenStreetMap, ways', 'indoor, level, location',
        'Of what is walked or cycled on: within a building, or on another floor than 0, it is left out.'),
    ('OpenStreetMap, areas', 'area:highway',
        'A row of street_area, by what a line of that class is used for; pedestrian is a square, parking a car park.'),
    ('OpenStreetMap, areas', 'highway, area',
        'With area=yes, or of a multipolygon: a row of street_area, in the same way.'),
    ('OpenStreetMap, areas', 'amenity, place, public_transport, railway',
        'A row of street_area: parking is a car park, square a square, platform (highway too) a platform.'),
    ('OpenStreetMap, areas', 'parking',
        'Car parks within buildings and bays of streets (street_side, lane, on_kerb, half_on_kerb, shoulder, layby) '
        'are left out.'),
    ('OpenStreetMap, areas', 'footway', 'Of an area to walk on: sidewalk is its kind.'),
    ('OpenStreetMap, areas', 'name, surface, foot, access', 'Columns name, surface and foot of street_area.'),
    ('OpenStreetMap, areas', 'indoor, level, location',
        'Within a building, or on another floor than 0, an area is left out.'),
    ('OpenStreetMap, ways', 'railway',
        'Values tram and light_rail are tracks, rows of rail_track; of a street, too.'),
    ('OpenStreetMap, ways', 'embedded_rails',
        'Values tram and light_rail of a street: a track along its line, where none is mapped within 12 m.'),
    ('OpenStreetMap, ways', 'gauge, tracks',
        'Of what has rails: columns of its row of rail_track; of several gauges the first.'),
    ('OpenStreetMap, nodes', 'highway',
        'A control point: traffic_signals, stop, give_way, mini_roundabout, crossing; an object: these, street_lamp '
        'and bus_stop.'),
    ('OpenStreetMap, nodes', 'traffic_calming',
        'An object: bump, hump, table, cushion, rumble_strip, choker, chicane and island are types below '
        'traffic_calming.'),
    ('OpenStreetMap, nodes', 'crossing',
        'Of a crossing: traffic_signals are signals beside it; no: there is none. Of traffic_signals: the same word is '
        'a crossing beside them. How it is painted, where crossing:markings does not say: zebra; unmarked or informal: '
        'not at all; other words: as is usual.'),
    ('OpenStreetMap, nodes', 'crossing:markings',
        'How a crossing is painted, column marking of its control point: zebra, ladder, lines, dashes, dots, surface, '
        'yes (as is usual) or no; of zebra:double and the like the first word; rainbow is surface.'),
    ('OpenStreetMap, nodes', 'kerb, kerb:height',
        'Of a crossing: the kerbs at both of its ends, column kerb of its control point; by height flush under 1 cm, '
        'lowered up to 3 cm, else raised.'),
    ('OpenStreetMap, nodes', 'crossing:island',
        'Of a crossing: yes is a refuge in the middle of the roadway between both directions, column refuge of its '
        'control point, as crossing=island is; on a one-way carriageway the median is it.'),
    ('OpenStreetMap, nodes', 'crossing:signals',
        'Of a crossing: yes is signals beside it. Of traffic_signals: yes is a crossing beside them.'),
    ('OpenStreetMap, nodes', 'direction', 'The direction of the traffic that a sign or an object is for.'),
    ('OpenStreetMap, nodes', 'stop, give_way',
        'Of a sign on the node of a junction: all binds all who come, minor those who wait for others.'),
    ('OpenStreetMap, nodes', 'traffic_signals:direction', 'The direction of the traffic that signals are for.'),
    ('OpenStreetMap, nodes', 'railway, public_transport, tram, light_rail',
        'Value tram_stop is an object, and so is a platform of trams (railway; or public_transport with tram=yes or '
        'light_rail=yes), in the middle of it where that is a line.'),
    ('OpenStreetMap, nodes', 'natural', 'Value tree is an object.'),
    ('OpenStreetMap, nodes', 'amenity', 'Value bench is an object.'),
    ('OpenStreetMap, nodes', 'barrier',
        'Value bollard is an object; kerb on a footway, with kerb or kerb:height, is a row of footway_kerb.'),
    ('OpenStreetMap, crossings', 'footway, path, cycleway',
        'Of a way, value crossing: it says how crossings on it are painted.'),
    ('OpenStreetMap, crossings', 'crossing, crossing:markings',
        'The same as of nodes. Of a way and a node that both say it, the way counts.'),
    ('OpenStreetMap, relations', 'type',
        'Value restriction is a turn restriction, route a route. One such as restriction:hgv is left out and told.'),
    ('OpenStreetMap, relations', 'day_on, day_off, hour_on, hour_off',
        'Nothing: the restriction holds at all times, and is told.'),
    ('OpenStreetMap, relations', 'restriction', 'The turns that are forbidden, or the only one that is not.'),
    ('OpenStreetMap, relations', 'except', 'Whom the restriction does not bind: psv, bus, bicycle, hov.'),
    ('OpenStreetMap, relations', 'route',
        'Whose route it is: bus, trolleybus, tram, bicycle, truck, hgv; of several values, parted by ;, each.'),
    ('OpenStreetMap, relations', '[ref|name]', 'The number and the name of the route.')
    UNION ALL SELECT 'BD TOPO', array_to_string(columns, ', '), becomes FROM streetgen._bdtopo_column() $$;
COMMENT ON FUNCTION streetgen.tag_use() IS
    'What becomes of each tag of OpenStreetMap and each column of BD TOPO that importers look at; alternatives of a '
    'key stand in brackets.';
