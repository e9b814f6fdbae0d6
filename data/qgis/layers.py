"""The layers of a model in QGIS, from the top of the map down.  Their colours are those of the rules of a theme."""
import dataclasses
import typing

from shape import CORNER_KIND, INTERSECTION_KIND, NAMES, NUMBERS, OBJECT_LINES, OBJECT_POINTS, PATH_KIND, REPORT, RING_KIND, SECTION_KIND, SIGNALS, SIMULATED_CARS, SIMULATED_DENSITIES, STREETS, grounds, shown_of
from style import along_lines, as_wide_as, at_true_size, boxes_on_lines, by_rule, fill, level_by_level, line, nothing, outline, point, rules, shaded, single, turned, with_arrow


@dataclasses.dataclass(frozen=True)
class Layer:
    group: str  # one of GROUPS, and after a stroke a group within it
    relation: str
    key: str
    geometry: typing.Optional[str] = None  # column; None: a table of values
    renderer: typing.Optional[typing.Callable] = None  # of the rules of a theme
    # Columns that one may type in; () where only the geometry may be changed, None for what is read only.
    writable: typing.Optional[tuple] = None
    shown: bool = False  # in the map theme of its group
    scale: int = 0  # drawn only when nearer than 1 : scale
    # A layer that no relation holds has these rows, @ being the model and @name its name as a value; it is there with a relation.
    query: typing.Optional[str] = None
    kind: typing.Optional[str] = None  # the type of geometry, of such a layer, and of a relation that holds several
    srid: typing.Optional[int] = None  # where it is not that of the model
    needs: typing.Optional[str] = None
    labels: typing.Optional[typing.Callable] = None  # of the rules of a theme
    tip: str = ''  # what is told where the pointer rests
    theme: str = 'construction'
    when: typing.Optional[tuple] = None  # columns of the time from which on it is there, and of that when it is gone

    @property
    def name(self):
        return self.relation.replace('_', ' ') if self.group == 'map' else self.relation


# Each is a map theme too, with the theme of the rules by which it shows the streets below.
GROUPS = {'map': 'street', 'edit': 'construction', 'traffic': 'construction', 'construction': 'construction', 'checks': 'construction'}


def drawn(layer, made, kind="''", where=''):
    """What streetgen.svg draws too, by the same rules."""
    return lambda look: by_rule(look.of(layer), made, kind, where)


def dot(symbol):
    """A point of the map, in metres."""
    return at_true_size(symbol, '"shape"', '"size"', '"turn"')


def lane(look):
    lane = look.handle('lane')
    return single(with_arrow(line(lane, 0.25, '1;1.5'), 2.2, 'CASE WHEN both_ways THEN NULL WHEN along_axis THEN 0 ELSE 180 END'))


def interconnection(look):
    path = look.one('path')
    return rules(('implausible', 'NOT connecting AND NOT plausible', line(look.one('path', 'implausible'), 0.15, '1;1.5')),
                 ('plausible, not connecting', 'plausible AND NOT connecting', line(look.handle('forbidden'), 0.5, '1.5;1')),
                 ('connecting', "connecting AND method <> 'by_hand'", with_arrow(line(path, 0.35), 1.6)),
                 ('by hand', "connecting AND method = 'by_hand'", with_arrow(line(look.handle('by_hand'), 0.45), 1.8)))


def junction_movement(look):
    return rules(('implausible', 'NOT connecting', line(look.one('movement', 'implausible'), 0.15, '1;1.5')),
                 ('connecting', 'connecting', with_arrow(line(look.one('movement'), 0.35), 1.6)))


def junction(look):
    return rules(*((kind.replace('_', ' '), f"kind = '{kind}'", fill(look.handle(kind)))
                   for kind in ('signals', 'stop', 'priority', 'right_before_left', 'ramp', 'fork', 'merge', 'roundabout', 'continuation', 'end')))


def control_point(look):
    return rules(*((kind.replace('_', ' '), f"kind = '{kind}'", point(look.knob(kind), shape, size)) for kind, shape, size in (
        ('signals', 'circle', 3), ('stop', 'octagon', 3), ('yield', 'triangle', 3), ('mini_roundabout', 'circle', 3), ('pedestrian_crossing', 'square', 2.4))))


def axis(look):
    return single(with_arrow(line(look.handle('axis'), 0.3), 2, "CASE WHEN direction = 'direct' THEN 0 WHEN direction = 'reverse' THEN 180 END"))


def handle(shape, size, kind=''):
    """A point to drag; one that a user placed has the colour of what is by hand."""
    return lambda look: rules(('computed', 'NOT by_hand', point(look.knob(kind), shape, size)), ('by hand', 'by_hand', point(look.knob('by_hand'), shape, size)))


def handle_line(kind, seldom='false'):
    """A line to redraw; what one seldom needs is thin."""
    return lambda look: rules(('seldom', f'NOT by_hand AND {seldom}', line(look.handle(kind), 0.1, '1;2')),
                              ('computed', f'NOT by_hand AND NOT {seldom}', line(look.handle(kind), 0.3, '2;2')), ('by hand', 'by_hand', line(look.handle('by_hand'), 0.5)))


def mark(shape, size, kind='by_hand'):
    return lambda look: single(point(look.knob(kind), shape, size))


def border(kind='by_hand'):
    return lambda look: single(outline(look.handle(kind)))


def lane_adjacency(look):
    """A line on the side of the lane that one leaves: thin where one may not change."""
    return rules(*((f'{label}, to the {side}', f"{condition} AND side = '{side}'", line(look.handle(kind), width, offset=offset))
                   for side, offset in (('left', 0.6), ('right', -0.6))
                   for label, condition, kind, width in (
                       ('allowed', "NOT by_hand AND change = 'allowed'", 'allowed', 0.4), ('forbidden', "NOT by_hand AND change = 'forbidden'", 'forbidden', 0.2),
                       ('opposite', "change = 'opposite'", 'opposite', 0.1), ('allowed by hand', "by_hand AND change = 'allowed'", 'by_hand', 0.6),
                       ('forbidden by hand', "by_hand AND change = 'forbidden'", 'by_hand', 0.3))))


def junction_edge(look):
    """Edges inside junctions, and the others that could be."""
    inside, by_hand = look.handle('inside'), look.handle('by_hand')
    return rules(('outside', 'NOT inside AND NOT by_hand', line(inside, 0.2, '1;2')), ('inside', 'inside AND NOT by_hand', line(inside, 1)),
                 ('outside by hand', 'NOT inside AND by_hand', line(by_hand, 0.4, '2;2')), ('inside by hand', 'inside AND by_hand', line(by_hand, 1)))


def roundabout(look):
    """Rings to look through: those decided by hand, accepted and refused by their score."""
    by_hand = look.handle('by_hand')
    return rules(('confirmed', 'confirmed', line(by_hand, 0.8)), ('refused by hand', 'NOT confirmed', line(by_hand, 0.4, '2;2')),
                 ('accepted', 'confirmed IS NULL AND accepted', line(look.one('ring'), 0.8)), ('not accepted', 'ELSE', line(look.one('ring', 'refused'), 0.4, '2;2')))


def street_object(look):
    """Symbols turned as the objects stand."""
    return rules(*((kind, f"type = '{kind}'", turned(point(look.knob(kind), shape, size), 'angle')) for kind, shape, size in (
        ('lamp', 'star', 3), ('tree', 'circle', 4), ('sign', 'triangle', 3), ('traffic_light', 'diamond', 3),
        ('bench', 'rectangle', 3), ('bollard', 'circle', 1.4), ('bus_stop', 'square', 3), ('arrow', 'arrow', 4))),
        ('other', 'ELSE', turned(point(look.knob('object'), 'diamond', 2.4), 'angle')))


def finding(look):
    """Flags, by how bad it is."""
    return rules(*((severity, f"severity = '{severity}'", point(look.knob(severity), 'triangle', size)) for severity, size in (('notice', 3), ('warning', 3.6), ('error', 4.2))))


def off_its_kerb(look):
    """Kerbs, by how far from them theirs were observed."""
    return rules(*((label, condition, line(look.handle(severity), width)) for label, condition, severity, width in (
        ('within 0.2 m', 'median <= 0.2', 'proposed', 0.4), ('within 1 m', 'median > 0.2 AND median <= 1', 'warning', 0.6), ('farther', 'median > 1', 'error', 0.8))))


def proposed(look):
    """Axes as they would be."""
    return rules(*((proposal, f"proposal = '{proposal}'", line(look.handle('proposed'), width, dashes)) for proposal, width, dashes in (
        ('delete', 0.5, '1;1'), ('split', 0.8, '3;1'), ('join', 0.8, None))))


def by_hand(relation, columns):
    """What users decided; here also that which fits nowhere can be seen and deleted."""
    return Layer('edit/by hand', relation, f'{relation}_id', 'geom', mark('star', 3), columns)


# The map, as streetgen.svg draws it; below it the streets themselves.
MAP = (
    Layer('map', 'route_number', 'edge_id', 'geom', lambda look: nothing(), query=NUMBERS, kind='LineString', needs='edge', theme='street',
          labels=lambda look: boxes_on_lines(look.of('ref'), 'ref', '"kind"', '10 - "importance"')),
    Layer('map', 'street_name', 'edge_id', 'geom', lambda look: nothing(), query=NAMES, kind='LineString', needs='edge', theme='street',
          labels=lambda look: along_lines(look.of('name'), 'name', '"kind"', '9 - "importance"')),
    Layer('map', 'street_object', 'street_object_id', 'geom', drawn('object', dot, '"kind"'), query=OBJECT_POINTS, kind='Point', needs='street_object', theme='street'),
    Layer('map', 'street_object_line', 'street_object_id', 'geom', drawn('object', lambda symbol: as_wide_as(symbol, '"size"'), '"kind"'), query=OBJECT_LINES, kind='LineString',
          needs='street_object', theme='street'),
    Layer('map', 'signal', 'signal_head_id', 'geom', drawn('signal_head', lambda symbol: at_true_size(symbol, "'circle'", '"size"', '0'), '"kind"'), query=SIGNALS, kind='Point',
          needs='signal_head', theme='street'),
    Layer('map', 'street_line', 'edge_id', 'geom', drawn('street', line, '"kind"'), query=STREETS, kind='LineString', needs='edge', theme='street'),
)


def street(relations, levels):
    layers = {shape.layer for _, shape in shown_of(relations)}
    return Layer('map', 'street', 'street_id', 'surface', lambda look: level_by_level([symbol for symbol in look.symbols if symbol.layer in layers], levels),
                 query=grounds(relations, levels), kind='MultiPolygon', needs='edge', theme='street')


def building(source):
    """The polygons of the table that setting building_table names: its query, key, column, type and SRID."""
    query, key, column, kind, srid = source
    return Layer('map', 'building', key, column, drawn('building', fill), query=query, kind=kind, srid=srid, needs='edge', theme='street')


HILL_SHADE = Layer('map', 'terrain', 'hill_shade_id', 'geom', lambda look: single(shaded('grey')), query="SELECT * FROM streetgen.hill_shade(@name)", kind='Polygon',
                   needs='terrain_tile')

# What is edited, above what is computed.
EDITED = (
    Layer('edit', 'node_editing', 'node_id', 'geom', mark('circle', 2.2, 'node'), (), shown=True, scale=5000),
    Layer('edit', 'section_limit_editing', 'section_limit_id', 'geom', handle('diamond', 2.6, 'limit'), ('abscissa', 'by_hand'), shown=True, scale=2500),
    Layer('edit', 'corner_editing', 'corner_id', 'geom', handle('circle', 2.2), ('radius', 'by_hand'), shown=True, scale=2500),
    Layer('edit', 'road_arc_editing', 'road_arc_id', 'geom', handle('pentagon', 2.2), ('radius', 'by_hand'), scale=2500),
    Layer('edit', 'kerb_point_editing', 'kerb_point_id', 'geom', mark('square', 2.2), ('axis_id', 'width'), shown=True, scale=2500),
    Layer('edit', 'junction_editing', 'junction_id', 'geom', handle('hexagon', 3, 'limit'), ('kind', 'by_hand'), scale=5000),
    Layer('edit', 'controller_editing', 'controller_id', 'geom', handle('circle', 3, 'signals'), ('program', 'cycle', 'start_offset', 'durations', 'by_hand'), scale=5000),
    Layer('edit', 'ramp_editing', 'ramp_id', 'geom', handle('arrow', 2.4), ('tangent', 'length', 'by_hand'), scale=5000),
    Layer('edit', 'overpass_editing', 'overpass_id', 'geom', handle('triangle', 2.4), ('axis_above', 'clearance', 'by_hand'), scale=5000),
    Layer('edit', 'height_editing', 'height_id', 'geom', mark('triangle', 2.2), ('axis_id', 'height'), scale=5000),
    Layer('edit', 'street_object_editing', 'street_object_id', 'geom', street_object, ('type', 'placement', 'axis_id', 'abscissa', 'side', 'axis_offset', 'orientation', 'orientation_kind'), scale=2500),
    Layer('edit', 'parking_bay_editing', 'street_object_id', 'geom', mark('square', 2.4), ('axis_id', 'abscissa', 'side', 'axis_offset', 'length', 'width', 'angle'), scale=2500),
    Layer('edit', 'pedestrian_crossing_editing', 'street_object_id', 'geom', mark('square', 2.4), ('axis_id', 'abscissa', 'width', 'angle', 'marking', 'kerb', 'refuge'), scale=2500),
    Layer('edit', 'roundabout_editing', 'roundabout_id', 'geom', roundabout, ('confirmed',), scale=10000),
    Layer('edit', 'interconnection_editing', 'interconnection_id', 'geom', handle_line('path', 'NOT connecting'), ('connecting', 'by_hand'), scale=1000),
    Layer('edit', 'sidewalk_editing', 'sidewalk_id', 'geom', border(), ('width', 'by_hand'), scale=2500),
    Layer('edit', 'lane_adjacency_editing', 'lane_adjacency_id', 'geom', lane_adjacency, ('change', 'by_hand'), scale=1000),
    Layer('edit', 'lane_editing', 'lane_id', 'geom', handle_line('lane'), ('along_axis', 'both_ways', 'width', 'by_hand'), scale=2500),
    Layer('edit', 'block_editing', 'block_id', 'geom', border(), ('kind', 'by_hand'), scale=5000),
    Layer('edit', 'junction_edge_editing', 'edge_id', 'geom', junction_edge, ('inside', 'by_hand'), scale=2500),
    Layer('edit', 'edge_editing', 'edge_id', 'geom', lambda look: single(line(look.handle('axis'), 0.3, '3;1')), (), scale=5000),
    Layer('edit', 'axis_editing', 'axis_id', 'geom', axis,
          ('width', 'lane_count', 'direction', 'speed', 'importance', 'name', 'level', 'ref', 'lanes_forward', 'lanes_backward', 'lanes_both', 'kind_forward', 'kind_backward',
           'lane_width_forward', 'lane_width_backward', 'turn_forward', 'turn_backward', 'change_forward', 'change_backward', 'lane_markings'), scale=5000),
    Layer('edit', 'turn_restriction', 'turn_restriction_id', 'geom', mark('octagon', 3, 'forbidden'),
          ('from_axis', 'to_axis', 'kind', 'turn', 'except_kinds', 'source', 'source_ref'), scale=2500),
    Layer('edit', 'control_point', 'control_point_id', 'geom', control_point, ('kind', 'direction', 'marking', 'kerb', 'refuge', 'axis_id', 'source', 'source_ref'), scale=5000),
    Layer('edit', 'footway_kerb', 'footway_kerb_id', 'geom', mark('diamond', 2), ('kerb', 'source', 'source_ref'), scale=1000),
    Layer('edit', 'footway', 'footway_id', 'geom', lambda look: single(line(look.handle(), 0.5, '2;1')), ('kind', 'role', 'marking', 'width', 'level', 'name', 'source', 'source_ref'), shown=True, scale=2500),
    Layer('edit', 'street_area', 'street_area_id', 'geom', drawn('area', outline, 'kind'), ('kind', 'level', 'name', 'surface', 'foot', 'source', 'source_ref'), shown=True, scale=5000),
    Layer('edit', 'observation', 'observation_id', 'geom', mark('cross2', 3), ('kind', 'confidence', 'weight', 'relation', 'source', 'source_ref'), kind='Point', scale=5000),
    Layer('edit', 'rail_track', 'rail_track_id', 'geom', lambda look: single(line(look.handle(), 0.6, '3;1')), ('kind', 'gauge', 'tracks', 'level', 'name', 'source', 'source_ref'), shown=True, scale=2500),
    Layer('edit', 'axis', 'axis_id', 'geom', axis,
          ('width', 'width_end', 'roadway_offset', 'lane_count', 'direction', 'speed', 'importance', 'name', 'ref', 'level', 'kind', 'radius', 'lanes_forward', 'lanes_backward', 'lanes_both',
           'kind_forward', 'kind_backward', 'lane_width_forward', 'lane_width_backward', 'turn_forward', 'turn_backward', 'change_forward', 'change_backward', 'lane_markings', 'access', 'sidewalk_left', 'sidewalk_right', 'sidewalk_apart', 'strips_left', 'strips_right', 'paved', 'sidewalk_paved_left', 'sidewalk_paved_right', 'cycle_paved_left', 'cycle_paved_right', 'parking_left', 'parking_right', 'height_limit', 'flow', 'roundabout_tag', 'source', 'source_ref'), shown=True, scale=5000),
    Layer('edit/tables', 'object_type', 'type', writable=('type', 'category', 'parent', 'geometry', 'symbol', 'size', 'description', 'distance_least')),
    Layer('edit/tables', 'object_distance', '"type_a","type_b"', writable=('type_a', 'type_b', 'metres')),
    Layer('edit/tables', 'placement_rule', 'rule_id', writable=('type', 'along', 'side', 'every', 'phase', 'axis_offset', 'orientation', 'distance_from_limit', 'importance_from', 'importance_to', 'kind', 'turn', 'density', 'active')),
    Layer('edit/tables', 'axis_class', 'class', writable=('taken', 'use', 'width', 'speed', 'importance', 'highway_role', 'walked_along', 'crossed_on_foot', 'lanes_by_width', 'lanes_one_way', 'width_one_way', 'lanes_each_way', 'parking_left', 'parking_right')),
    Layer('edit/tables', 'roundabout_pattern', 'pattern', writable=('pattern', 'language')),
    Layer('edit/tables', 'setting', 'name'),
    by_hand('free_place', ('rule_id',)),
)
COMPUTED = (
    Layer('traffic', 'junction_movement', 'junction_movement_id', 'geom', junction_movement, shown=True, scale=1500),
    Layer('traffic', 'interconnection', 'interconnection_id', 'geom', interconnection, shown=True, scale=1500),
    Layer('traffic', 'lane', 'lane_id', 'geom', lane, shown=True, scale=2500),
    Layer('traffic', 'lane_separator', 'lane_separator_id', 'surface', drawn('lane_separator', fill)),
    Layer('traffic', 'marking', 'marking_id', 'surface', drawn('marking', fill)),
    Layer('traffic', 'signal_head', 'lane_id', 'geom', mark('circle', 1.6, 'signals'), scale=2500),
    Layer('traffic', 'parking_bay', 'street_object_id', 'surface', drawn('bay', fill)),
    Layer('traffic', 'bus_stop_box', 'street_object_id', 'paint', drawn('bus_stop_box', fill), scale=2500),
    Layer('traffic', 'pedestrian_crossing', 'street_object_id', 'stripes', drawn('crossing', fill, 'painted_as')),
    Layer('construction', 'rail', 'rail_track_id', 'rails', lambda look: single(line(look.handle('limit'), 0.2)), scale=5000),
    Layer('construction', 'node', 'node_id', 'geom', mark('circle', 1.4, 'node'), shown=True, scale=5000),
    Layer('construction', 'section_limit', 'section_limit_id', 'border_line', drawn('limit', line, where="method = 'hypothesis'"), shown=True),
    Layer('construction', 'corner', 'corner_id', 'arc', drawn('arc', line, CORNER_KIND), shown=True),
    Layer('construction', 'road', 'road_id', 'geom', drawn('road', line)),
    Layer('construction', 'profile', 'edge_id', 'geom',
          lambda look: rules(('lifted', "method = 'lifted'", line(look.handle('limit'), 0.6)), ('sunk', "method = 'sunk'", line(look.handle('limit'), 0.6, '2;1'))), scale=10000),
    Layer('construction', 'ramp', 'ramp_id', 'geom',
          lambda look: rules(('cut', 'cut', point(look.knob('warning'), 'arrow', 2)), ('ramp', 'ELSE', point(look.knob(), 'arrow', 2))), scale=10000),
    Layer('construction', 'overpass', 'overpass_id', 'geom', mark('triangle', 2, ''), scale=10000),
    Layer('construction', 'underpass', 'overpass_id', 'geom', mark('triangle', 1.4, ''), scale=10000,
          tip='clearance [% round("clearance", 2) %] m[% coalesce(\', limit \' || "height_limit" || \' m\', \'\') %]'),
    Layer('construction', 'roundabout', 'roundabout_id', 'geom', drawn('ring', line, RING_KIND), shown=True),
    Layer('construction', 'edge', 'edge_id', 'geom', drawn('axis', line), shown=True),
    Layer('construction', 'kerb', 'kerb_id', 'geom',
          lambda look: rules(('kerb', "method <> 'level_change'", line(look.handle('limit'), 0.2)), ('level change', "method = 'level_change'", line(look.handle('warning'), 0.3, '1;1'))), scale=2500),
    Layer('construction', 'tunnel', 'tunnel_id', 'surface', drawn('tunnel_wall', fill)),
    Layer('construction', 'bridge', 'bridge_id', 'surface', drawn('bridge', fill, 'method')),
    Layer('construction', 'junction', 'junction_id', 'surface', junction),
    Layer('construction', 'intersection', 'node_id', 'surface', drawn('intersection', fill, INTERSECTION_KIND)),
    Layer('construction', 'section', 'edge_id', 'surface', drawn('section', fill, SECTION_KIND)),
    Layer('construction', 'sidewalk', 'sidewalk_id', 'surface', drawn('sidewalk', fill)),
    Layer('construction', 'crossover', 'crossover_id', 'surface', drawn('crossover', fill), scale=5000),
    Layer('construction', 'side_strip', 'side_strip_id', 'surface', drawn('side_strip', fill), scale=5000),
    Layer('construction', 'footway_surface', 'footway_id', 'surface', drawn('footway', fill, 'use'), scale=5000),
    Layer('construction', 'area_surface', 'street_area_id', 'surface', drawn('area', fill, 'kind'), scale=5000),
    Layer('construction', 'rail_crossing', 'rail_crossing_id', 'surface', drawn('rail_crossing', fill), scale=5000),
    Layer('construction', 'track_bed', 'rail_track_id', 'surface', drawn('track_bed', fill), scale=5000),
    Layer('construction', 'block', 'block_id', 'surface', drawn('block', fill, 'kind')),
)


def escaped(column):
    """A text in a map tip, which is HTML."""
    return f'[% replace(replace("{column}", \'&\', \'&amp;\'), \'<\', \'&lt;\') %]'


CHECKED = (
    Layer('checks', 'check_result', 'check_result_id', 'place', finding, shown=True,
          tip=f'<b>{escaped("severity")}: {escaped("rule")}[% coalesce(\', \' || round("measure", 2), \'\') %]</b><br>{escaped("relation")} [% "id" %]<br>{escaped("hint")}'),
    Layer('checks', 'axis_to_mend', 'id', 'geom', proposed, shown=True,
          tip=f'<b>[% "proposal" %]: {escaped("rule")}, [% round("measure", 2) %] m</b><br>id [% "id" %]'),
    Layer('checks', 'fit_change', 'fit_proposal_id', 'geom', lambda look: single(with_arrow(line(look.handle('proposed'), 0.4), 1.8)), scale=5000),
    Layer('checks', 'corner_proposal', 'corner_proposal_id', 'geom', lambda look: single(line(look.handle('proposed'), 0.6)), scale=5000,
          tip='[% round("radius", 2) %] m, before [% round("before", 2) %] m, [% "state" %]'),
    Layer('checks', 'kerb_distance', 'kerb_distance_id', 'geom', off_its_kerb, tip='[% round("median", 2) %] m of [% "observations" %] points'),
    Layer('checks', 'report', 'report_id', 'geom', mark('cross2', 3, 'error'), query=REPORT, kind='Point', shown=True),
    Layer('checks', 'activity', 'activity_id', 'extent', border(), shown=True),
    Layer('checks', 'edit_log', 'edit_log_id', 'extent', border(), shown=True),
)


def design_node(look):
    return rules(*((kind, f"kind = '{kind}' AND NOT rejected", point(look.one('design_node', kind), 'circle', size))
                   for kind, size in (('city', 4), ('town', 3), ('village', 2), ('interchange', 2))))


def zone(look):
    """By how a road goes through it."""
    return rules(*((kind, f"class = '{kind}'", fill(look.one('zone', passage))) for kind, passage in (('water', 'bridge'), ('forest', 'free'), ('building', 'forbidden'))),
                 ('other', 'ELSE', outline(look.handle())))


def run(relation, query, kind, made):
    """What a simulation kept, by its time."""
    return Layer('traffic', relation, 'simulated_id', 'geom', made, query=query, kind=kind, needs='simulated', shown=True, when=('begins', 'ends'),
                 tip=f'<b>{escaped("run")}</b>, [% round("t", 1) %] s: [% round("speed") %] km/h')


SIMULATED = (
    run('simulated_car', SIMULATED_CARS, 'Polygon', drawn('car', fill, '"kind"')),
    run('simulated_density', SIMULATED_DENSITIES, 'LineString', drawn('density', lambda symbol: line(symbol, 1), '"kind"')),
)


def standing(made):
    """What is drawn of a design: not what was rejected."""
    return lambda look: rules(('by hand', 'by_hand AND NOT rejected', made(look, 'by_hand')), ('computed', 'NOT by_hand', made(look, '')))


def spot(shape, size):
    return lambda look, kind: point(look.knob(kind), shape, size)


# The stages of a design, from structures down to the ground.
DESIGN = (
    Layer('edit/design', 'structure_editing', 'structure_id', 'geom', standing(lambda look, kind: line(look.handle(kind) if kind else look.one('structure'), 1.2)), ('kind', 'start_abscissa', 'end_abscissa', 'by_hand', 'rejected')),
    Layer('edit/design', 'design_crossing_editing', 'design_crossing_id', 'geom', standing(spot('triangle', 3)), ('kind', 'by_hand', 'rejected')),
    Layer('edit/design', 'grade_point_editing', 'grade_point_id', 'geom', standing(spot('diamond', 2)), ('abscissa', 'height', 'radius', 'by_hand', 'rejected'), scale=25000),
    Layer('edit/design', 'alignment_element_editing', 'alignment_element_id', 'start', standing(spot('square', 1.6)), ('by_hand', 'rejected'), scale=25000),
    Layer('edit/design', 'design_vertex_editing', 'design_vertex_id', 'geom', standing(spot('circle', 2.4)),
          ('design_link_id', 'ordinality', 'radius', 'clothoid_in', 'clothoid_out', 'straight_in', 'straight_out', 'by_hand', 'rejected')),
    Layer('edit/design', 'design_node_editing', 'design_node_id', 'geom', design_node, ('name', 'kind', 'importance', 'by_hand', 'rejected')),
    Layer('edit/design', 'design_link_editing', 'design_link_id', 'geom', standing(lambda look, kind: line(look.handle(kind), 0.6)), ('node_a', 'node_b', 'network', 'by_hand', 'rejected')),
    Layer('edit/design', 'zone_editing', 'zone_id', 'geom', zone, ('class',)),
)


def layers_of(relations, decisions, levels, buildings):
    """The layers of a model that has these relations, from the top down: a subject that it does not compute has none.

    buildings: the sources of those, one or none. A table of decisions, with the columns that one may type in, is one of those by hand where it has no layer of its own.
    """
    own = {layer.relation for layer in EDITED}
    decided = [by_hand(relation, columns) for relation, columns in decisions.items() if relation not in own]
    return [layer for layer in (*CHECKED, *EDITED, *decided, *SIMULATED, *COMPUTED, *DESIGN, *MAP, *map(building, buildings), street(relations, levels), HILL_SHADE) if (layer.needs or layer.relation) in relations]
