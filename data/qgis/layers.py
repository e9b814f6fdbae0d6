"""The layers of a model in QGIS, from the top of the map down."""
import dataclasses
import typing

from style import (ARC, ASPHALT, AXIS, BLOCK, CONTROL, HAND, IMPLAUSIBLE, ISLAND, JUNCTION, KERB, LIMIT, PAINT, PATH, REPORT, STRIP, WALK, fill, line, point, rules, shaded, single, turned, with_arrow)


@dataclasses.dataclass(frozen=True)
class Layer:
    group: str
    relation: str
    key: str
    geometry: typing.Optional[str] = None  # column; None: a table of values
    renderer: typing.Optional[typing.Callable] = None
    # Columns that one may type in; () where only the geometry may be changed, None for what is read only.
    writable: typing.Optional[tuple] = None
    shown: bool = False
    scale: int = 0  # drawn only when nearer than 1 : scale
    # A layer that no relation holds has these rows, @ being the model, and this type of geometry.
    query: typing.Optional[str] = None
    kind: typing.Optional[str] = None

    @property
    def name(self):
        return f'{self.relation} {self.geometry}' if self.geometry in ('centre', 'border_line') else self.relation


# The layer roadway shows this of each relation.
ROADWAY = {
    'section': "SELECT edge_id * 4 AS roadway_id, 'section' AS kind, edge_id AS id, level, method, surface FROM @.section",
    'intersection': "SELECT node_id * 4 + 1, 'intersection', node_id, level, method, surface FROM @.intersection",
    'lane_separator': "SELECT lane_separator_id * 4 + 2, 'lane_separator', lane_separator_id, level, NULL, surface "
                      'FROM @.lane_separator JOIN @.edge USING (edge_id)',
    'marking': "SELECT marking_id * 4 + 3, 'marking', marking_id, level, NULL, surface FROM @.marking JOIN @.edge USING (edge_id)",
}
BRIDGE_ROWS = 'SELECT b.*, level FROM @.bridge b JOIN @.edge USING (edge_id)'
REPORT_ROWS = 'SELECT row_number() OVER (ORDER BY axis_a, axis_b, issue, geom) AS report_id, * FROM @.report'


def roadway():
    """Level by level, and the kerbs of all rows below the asphalt of all, so that none runs across a street."""
    rows = []
    for level in (-1, 0, 1, 2):
        at = f'clamp(-1, level, 2) = {level}'
        rows += [(f'kerb, level {level}', f"{at} AND kind IN ('section', 'intersection')", fill(KERB, KERB, 0.6, 'MapUnit')),
                 (f'section, level {level}', f"{at} AND kind = 'section'", fill(ASPHALT, ASPHALT, 0.02, 'MapUnit')),
                 (f'intersection, level {level}', f"{at} AND kind = 'intersection'", fill(JUNCTION, JUNCTION, 0.02, 'MapUnit')),
                 (f'paint, level {level}', f"{at} AND kind IN ('lane_separator', 'marking')", fill(PAINT))]
    return rules(*rows)


OBJECT_LINES = 'SELECT * FROM @.street_object WHERE ST_Dimension(geom) = 1'


def bridge():
    """Level by level, so that the higher deck hides the lower one."""
    return rules(*((f'bridge, level {level}', f'clamp(0, level, 3) = {level}', fill(ASPHALT, LIMIT, 0.5)) for level in (0, 1, 2, 3)))


def surface_by_method(colour):
    return lambda: rules(('kerb', '', fill(KERB, KERB, 0.6, 'MapUnit')), ('roadway', 'ELSE', fill(colour)),
                         ('contested', "method IN ('contested', 'crowded')", fill('#8a7748')), ('transition', "method = 'transition'", fill('#6d6287')))


def lane():
    return single(with_arrow(line('#ffffff', 0.25, dash='1;1.5', opacity=0.8), '#ffffff', 2.2, "CASE WHEN both_ways THEN NULL WHEN along_axis THEN 0 ELSE 180 END"))


def interconnection():
    return rules(('implausible', 'NOT connecting AND NOT plausible', line(IMPLAUSIBLE, 0.15, dash='1;1.5', opacity=0.5)),
                 ('plausible, not connecting', 'plausible AND NOT connecting', line(REPORT, 0.5, dash='1.5;1')),
                 ('connecting', "connecting AND method <> 'by_hand'", with_arrow(line(PATH, 0.35), PATH, 1.6)),
                 ('by hand', "connecting AND method = 'by_hand'", with_arrow(line(HAND, 0.45), HAND, 1.8)))


def junction():
    return rules(*((kind.replace('_', ' '), f"kind = '{kind}'", fill(colour, opacity=0.6)) for kind, colour in (
        ('signals', '#1a9641'), ('stop', '#d7191c'), ('priority', '#fdae61'), ('right_before_left', '#abd9e9'), ('ramp', '#7b3294'),
        ('roundabout', '#2c7bb6'), ('continuation', '#bababa'), ('end', '#e0e0e0'))))


def junction_movement():
    return rules(('implausible', 'NOT connecting', line(IMPLAUSIBLE, 0.15, dash='1;1.5', opacity=0.5)), ('connecting', 'connecting', with_arrow(line(PATH, 0.35), PATH, 1.6)))


def control_point():
    return rules(('signals', "kind = 'signals'", point('circle', '#1a9641', 3)), ('stop', "kind = 'stop'", point('octagon', REPORT, 3)),
                 ('yield', "kind = 'yield'", point('triangle', LIMIT, 3)), ('mini-roundabout', "kind = 'mini_roundabout'", point('circle', LIMIT, 3)), ('pedestrian crossing', "kind = 'pedestrian_crossing'", point('square', AXIS, 2.4)))


def axis():
    return single(with_arrow(line(AXIS, 0.5), AXIS, 2.6, "CASE WHEN direction = 'direct' THEN 0 WHEN direction = 'reverse' THEN 180 END"))


def handle(shape, size, colour):
    """A point to drag; one that a user placed has the colour of what is by hand."""
    return lambda: rules(('computed', 'NOT by_hand', point(shape, colour, size)), ('by hand', 'by_hand', point(shape, HAND, size)))


def handle_line(colour, seldom='false'):
    """A line to redraw; what one seldom needs is thin."""
    return lambda: rules(('seldom', f'NOT by_hand AND {seldom}', line(colour, 0.1, dash='1;2')), ('computed', f'NOT by_hand AND NOT {seldom}', line(colour, 0.3, dash='2;2')),
                         ('by hand', 'by_hand', line(HAND, 0.5)))


def lane_adjacency():
    """A line on the side of the lane that one leaves: thin where one may not change."""
    return rules(*((f'{label}, to the {side}', f"{condition} AND side = '{side}'", line(colour, width, offset=offset))
                   for side, offset in (('left', 0.6), ('right', -0.6))
                   for label, condition, colour, width in (
                       ('allowed', "NOT by_hand AND change = 'allowed'", PATH, 0.4), ('forbidden', "NOT by_hand AND change = 'forbidden'", REPORT, 0.2),
                       ('opposite', "change = 'opposite'", IMPLAUSIBLE, 0.1), ('allowed by hand', "by_hand AND change = 'allowed'", HAND, 0.6),
                       ('forbidden by hand', "by_hand AND change = 'forbidden'", HAND, 0.3))))


def junction_edge():
    """Edges inside junctions, and the others that could be."""
    return rules(('outside', 'NOT inside AND NOT by_hand', line(LIMIT, 0.2, dash='1;2')), ('inside', 'inside AND NOT by_hand', line(LIMIT, 1)),
                 ('outside by hand', 'NOT inside AND by_hand', line(HAND, 0.4, dash='2;2')), ('inside by hand', 'inside AND by_hand', line(HAND, 1)))


def roundabout():
    """Rings to look through: those decided by hand, accepted and refused by their score."""
    return rules(('confirmed', 'confirmed', line(HAND, 0.8)), ('refused by hand', 'NOT confirmed', line(HAND, 0.4, dash='2;2')),
                 ('accepted', 'confirmed IS NULL AND accepted', line(ARC, 0.8)), ('not accepted', 'ELSE', line(LIMIT, 0.4, dash='2;2')))


def street_object():
    """Symbols turned as the objects stand."""
    return rules(*((kind, f"type = '{kind}'", turned(point(shape, colour, size), 'angle')) for kind, shape, colour, size in (
        ('lamp', 'star', '#f59f00', 3), ('tree', 'circle', '#4d7c0f', 4), ('sign', 'triangle', REPORT, 3), ('traffic_light', 'diamond', '#1a9641', 3),
        ('bench', 'rectangle', '#7c4a1e', 3), ('bollard', 'circle', AXIS, 1.4), ('bus_stop', 'square', LIMIT, 3), ('arrow', 'arrow', PAINT, 4))),
        ('other', 'ELSE', turned(point('diamond', HAND, 2.4), 'angle')))


def by_hand(relation, columns):
    """What users decided; here also that which fits nowhere can be seen and deleted."""
    return Layer('overrides', relation, f'{relation}_id', 'geom', lambda: single(point('star', HAND, 3)), columns)


# What is edited, above what is computed.
EDITED = (
    Layer('edit', 'node_editing', 'node_id', 'geom', lambda: single(point('circle', AXIS, 2.6)), ()),
    Layer('edit', 'section_limit_editing', 'section_limit_id', 'geom', handle('diamond', 2.6, LIMIT), ('abscissa', 'by_hand'), scale=2500),
    Layer('edit', 'corner_editing', 'corner_id', 'geom', handle('circle', 2.2, ARC), ('radius', 'by_hand'), scale=2500),
    Layer('edit', 'road_arc_editing', 'road_arc_id', 'geom', handle('pentagon', 2.2, ARC), ('radius', 'by_hand'), scale=2500),
    Layer('edit', 'kerb_point_editing', 'kerb_point_id', 'geom', lambda: single(point('square', HAND, 2.2)), ('axis_id', 'width'), scale=2500),
    Layer('edit', 'junction_editing', 'junction_id', 'geom', handle('hexagon', 3, LIMIT), ('kind', 'by_hand'), scale=5000),
    Layer('edit', 'controller_editing', 'controller_id', 'geom', handle('circle', 3, '#c92a2a'), ('program', 'cycle', 'start_offset', 'durations', 'by_hand'), scale=5000),
    Layer('edit', 'ramp_editing', 'ramp_id', 'geom', handle('arrow', 2.4, AXIS), ('tangent', 'length', 'by_hand'), scale=5000),
    Layer('edit', 'overpass_editing', 'overpass_id', 'geom', handle('triangle', 2.4, AXIS), ('axis_above', 'clearance', 'by_hand'), scale=5000),
    Layer('edit', 'height_editing', 'height_id', 'geom', lambda: single(point('triangle', HAND, 2.2)), ('axis_id', 'height'), scale=5000),
    Layer('edit', 'street_object_editing', 'street_object_id', 'geom', street_object, ('type', 'placement', 'axis_id', 'abscissa', 'side', 'axis_offset', 'orientation', 'orientation_kind'), scale=2500),
    Layer('edit', 'parking_bay_editing', 'street_object_id', 'geom', lambda: single(point('square', HAND, 2.4)), ('axis_id', 'abscissa', 'side', 'axis_offset', 'length', 'width', 'angle'), scale=2500),
    Layer('edit', 'pedestrian_crossing_editing', 'street_object_id', 'geom', lambda: single(point('square', HAND, 2.4)), ('axis_id', 'abscissa', 'width', 'angle'), scale=2500),
    Layer('edit', 'roundabout_editing', 'roundabout_id', 'geom', roundabout, ('confirmed',), scale=10000),
    Layer('edit', 'interconnection_editing', 'interconnection_id', 'geom', handle_line(CONTROL, 'NOT connecting'), ('connecting', 'by_hand'), scale=1000),
    Layer('edit', 'sidewalk_editing', 'sidewalk_id', 'geom', lambda: single(fill('#00000000', HAND, 0.3)), ('width', 'by_hand'), scale=2500),
    Layer('edit', 'lane_adjacency_editing', 'lane_adjacency_id', 'geom', lane_adjacency, ('change', 'by_hand'), scale=1000),
    Layer('edit', 'lane_editing', 'lane_id', 'geom', handle_line('#ffffff'), ('along_axis', 'both_ways', 'width', 'by_hand'), scale=2500),
    Layer('edit', 'block_editing', 'block_id', 'geom', lambda: single(fill('#00000000', HAND, 0.3)), ('kind', 'by_hand'), scale=5000),
    Layer('edit', 'junction_edge_editing', 'edge_id', 'geom', junction_edge, ('inside', 'by_hand'), scale=2500),
    Layer('edit', 'edge_editing', 'edge_id', 'geom', lambda: single(line(AXIS, 0.5, dash='3;1')), ()),
    Layer('edit', 'axis_editing', 'axis_id', 'geom', axis, ('width', 'lane_count', 'direction', 'speed', 'importance', 'name', 'level')),
    Layer('edit', 'edit_log', 'edit_log_id', 'extent', lambda: single(fill('#00000000', HAND, 0.3))),
    Layer('input', 'turn_restriction', 'turn_restriction_id', 'geom', lambda: single(point('octagon', REPORT, 3)),
          ('from_axis', 'to_axis', 'kind', 'turn', 'except_kinds', 'source', 'source_ref'), scale=2500),
    Layer('input', 'control_point', 'control_point_id', 'geom', control_point, ('kind', 'direction', 'axis_id', 'source', 'source_ref'), scale=5000),
    Layer('input', 'axis', 'axis_id', 'geom', axis,
          ('width', 'width_end', 'roadway_offset', 'lane_count', 'direction', 'speed', 'importance', 'name', 'level', 'kind', 'radius', 'lanes_forward', 'lanes_backward', 'lanes_both',
           'kind_forward', 'kind_backward', 'lane_width_forward', 'lane_width_backward', 'turn_forward', 'turn_backward', 'change_forward', 'change_backward', 'sidewalk_left', 'sidewalk_right', 'flow', 'roundabout_tag', 'source', 'source_ref'), shown=True),
    Layer('input', 'object_type', 'type', writable=('type', 'category', 'parent', 'geometry', 'symbol', 'size', 'description', 'distance_least')),
    Layer('input', 'placement_rule', 'rule_id', writable=('type', 'along', 'side', 'every', 'phase', 'axis_offset', 'orientation', 'distance_from_limit', 'importance_from', 'importance_to', 'kind', 'turn', 'density', 'active')),
    Layer('input', 'axis_class', 'class', writable=('taken', 'width', 'speed', 'importance', 'highway_role', 'walked_along', 'crossed_on_foot', 'lanes_by_width')),
    Layer('input', 'roundabout_pattern', 'pattern', writable=('pattern', 'language')),
    Layer('input', 'setting', 'name'),
    by_hand('free_place', ('rule_id',)),
)
COMPUTED = (
    Layer('traffic', 'junction_movement', 'junction_movement_id', 'geom', junction_movement, scale=1500),
    Layer('traffic', 'interconnection', 'interconnection_id', 'geom', interconnection, scale=1500, shown=True),
    Layer('traffic', 'lane', 'lane_id', 'geom', lane, scale=2500),
    Layer('traffic', 'lane_separator', 'lane_separator_id', 'surface', lambda: single(fill(PAINT)), scale=2500),
    Layer('traffic', 'marking', 'marking_id', 'surface', lambda: single(fill(PAINT)), scale=2500),
    Layer('streets', 'report', 'report_id', 'geom', lambda: single(point('cross2', REPORT, 3)), query=REPORT_ROWS, kind='Point'),
    Layer('streets', 'node', 'node_id', 'geom', lambda: single(point('circle', AXIS, 1.8))),
    Layer('streets', 'edge', 'edge_id', 'geom', lambda: single(line(AXIS, 0.4))),
    Layer('streets', 'section_limit', 'section_limit_id', 'border_line', lambda: single(line(LIMIT, 0.4)), scale=2500),
    Layer('streets', 'corner', 'corner_id', 'arc',
          lambda: rules(('as wanted', "method IN ('hypothesis', 'by_hand')", line(ARC, 0.5)), ('otherwise', "method NOT IN ('hypothesis', 'by_hand')", line(HAND, 0.5))), scale=2500),
    Layer('streets', 'road', 'road_id', 'geom', lambda: single(line(ARC, 0.4))),
    Layer('streets', 'kerb', 'kerb_id', 'geom',
          lambda: rules(('kerb', "method <> 'level_change'", line(KERB, 0.3, 'MapUnit')), ('level change', "method = 'level_change'", line(LIMIT, 0.3, dash='1;1'))), scale=2500),
    Layer('streets', 'sidewalk', 'sidewalk_id', 'surface', lambda: single(fill(WALK)), scale=5000),
    Layer('streets', 'profile', 'edge_id', 'geom', lambda: rules(('lifted', "method = 'lifted'", line(LIMIT, 0.6)), ('sunk', "method = 'sunk'", line(LIMIT, 0.6, dash='2;1'))), scale=10000),
    Layer('streets', 'signal_head', 'lane_id', 'geom', lambda: single(point('circle', '#c92a2a', 1.6)), scale=2500),
    Layer('streets', 'ramp', 'ramp_id', 'geom', lambda: rules(('cut', 'cut', point('arrow', HAND, 2)), ('ramp', 'ELSE', point('arrow', AXIS, 2))), scale=10000),
    Layer('streets', 'overpass', 'overpass_id', 'geom', lambda: single(point('triangle', AXIS, 2)), scale=10000),
    Layer('streets', 'roundabout', 'roundabout_id', 'geom', roundabout, scale=10000),
    Layer('traffic', 'parking_bay', 'street_object_id', 'surface', lambda: single(fill('#00000000', PAINT, 0.3)), scale=2500),
    Layer('traffic', 'pedestrian_crossing', 'street_object_id', 'stripes', lambda: single(fill(PAINT)), scale=2500),
    Layer('streets', 'street_object', 'street_object_id', 'geom', lambda: single(line(HAND, 0.5)), query=OBJECT_LINES, kind='LineString', scale=5000),
    Layer('streets', 'bridge', 'bridge_id', 'surface', bridge, query=BRIDGE_ROWS, kind='MultiPolygon', scale=10000),
    Layer('streets', 'tunnel', 'tunnel_id', 'surface', lambda: single(fill('#00000000', LIMIT, 0.4)), scale=10000),
    Layer('streets', 'roadway', 'roadway_id', 'surface', roadway, query=' UNION ALL '.join(ROADWAY.values()), kind='MultiPolygon', shown=True),
    Layer('streets', 'junction', 'junction_id', 'surface', junction),
    Layer('streets', 'intersection', 'node_id', 'surface', surface_by_method(JUNCTION)),
    Layer('streets', 'section', 'edge_id', 'surface', surface_by_method(ASPHALT)),
    Layer('streets', 'block', 'block_id', 'surface', lambda: rules(('block', "kind = 'block'", fill(BLOCK)), ('island', "kind = 'island'", fill(ISLAND)), ('strip', "kind = 'strip'", fill(STRIP)))),
)


def design_node():
    return rules(*((kind, f"kind = '{kind}' AND NOT rejected", point('circle', colour, size)) for kind, colour, size in (
        ('city', '#facc15', 4), ('town', '#facc15', 3), ('village', '#facc15', 2), ('interchange', '#9ca3af', 2))))


def zone():
    return rules(('water', "class = 'water'", fill('#93c5fd')), ('forest', "class = 'forest'", fill('#86a97c')), ('building', "class = 'building'", fill('#7c2d12')),
                 ('other', 'ELSE', fill('#d6c7a1')))


def standing(renderer):
    """What is drawn of a design: not what was rejected."""
    return lambda: rules(('by hand', 'by_hand AND NOT rejected', renderer(HAND)), ('computed', 'NOT by_hand', renderer(AXIS)))


# The stages of a design, from structures down to the ground.
DESIGN = (
    Layer('design', 'structure_editing', 'structure_id', 'geom', standing(lambda colour: line(REPORT if colour == AXIS else colour, 1.2)), ('kind', 'start_abscissa', 'end_abscissa', 'by_hand', 'rejected')),
    Layer('design', 'design_crossing_editing', 'design_crossing_id', 'geom', standing(lambda colour: point('triangle', colour, 3)), ('kind', 'by_hand', 'rejected')),
    Layer('design', 'grade_point_editing', 'grade_point_id', 'geom', standing(lambda colour: point('diamond', colour, 2)), ('abscissa', 'height', 'radius', 'by_hand', 'rejected'), scale=25000),
    Layer('design', 'alignment_element_editing', 'alignment_element_id', 'start', standing(lambda colour: point('square', colour, 1.6)), ('by_hand', 'rejected'), scale=25000),
    Layer('design', 'design_vertex_editing', 'design_vertex_id', 'geom', standing(lambda colour: point('circle', colour, 2.4)),
          ('design_link_id', 'ordinality', 'radius', 'clothoid_in', 'clothoid_out', 'straight_in', 'straight_out', 'by_hand', 'rejected')),
    Layer('design', 'design_node_editing', 'design_node_id', 'geom', design_node, ('name', 'kind', 'importance', 'by_hand', 'rejected')),
    Layer('design', 'design_link_editing', 'design_link_id', 'geom', standing(lambda colour: line(colour, 0.6)), ('node_a', 'node_b', 'network', 'by_hand', 'rejected')),
    Layer('design', 'zone_editing', 'zone_id', 'geom', zone, ('class',)),
    Layer('design', 'terrain_tile', 'hill_shade_id', 'geom', lambda: single(shaded('grey')), query="SELECT * FROM streetgen.hill_shade((parse_ident('@'))[1])", kind='Polygon', shown=True),
)


def layers_of(relations, decisions):
    """The layers of a model that has these relations: a subject that it does not compute has none.

    A table of decisions, with the columns that one may type in, is one of overrides where it has no layer of its own.
    """
    shown = ' UNION ALL '.join(rows for relation, rows in ROADWAY.items() if relation in relations)
    own = {layer.relation for layer in EDITED}
    overrides = [by_hand(relation, columns) for relation, columns in decisions.items() if relation not in own]
    return [dataclasses.replace(layer, query=shown) if layer.relation == 'roadway' else layer
            for layer in (*EDITED, *overrides, *COMPUTED, *DESIGN) if layer.relation in relations]
