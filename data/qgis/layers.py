"""The layers of a model in QGIS, from the top of the map down."""
import dataclasses
import typing

from style import (ARC, ASPHALT, AXIS, CONTROL, HAND, IMPLAUSIBLE, JUNCTION, KERB, LIMIT, PAINT, PATH, REPORT, fill, line, point, rules, single, with_arrow)


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
    # Of a layer that no relation holds: its rows, @ being the model, and the type of its geometry.
    query: typing.Optional[str] = None
    kind: typing.Optional[str] = None

    @property
    def name(self):
        return f'{self.relation} {self.geometry}' if self.geometry in ('centre', 'border_line') else self.relation


# What the layer roadway shows of each relation.
ROADWAY = {
    'section': "SELECT edge_id * 4 AS roadway_id, 'section' AS kind, edge_id AS id, level, method, surface FROM @.section",
    'intersection': "SELECT node_id * 4 + 1, 'intersection', node_id, level, method, surface FROM @.intersection",
    'lane_separator': "SELECT lane_separator_id * 4 + 2, 'lane_separator', lane_separator_id, level, NULL, surface "
                      'FROM @.lane_separator JOIN @.edge USING (edge_id)',
    'marking': "SELECT marking_id * 4 + 3, 'marking', marking_id, level, NULL, surface FROM @.marking JOIN @.edge USING (edge_id)",
}
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


def axis():
    return single(with_arrow(line(AXIS, 0.5), AXIS, 2.6, "CASE WHEN direction = 'direct' THEN 0 WHEN direction = 'reverse' THEN 180 END"))


def handle(shape, size, colour):
    """A point to drag; one that a user placed has the colour of what is by hand."""
    return lambda: rules(('computed', 'NOT by_hand', point(shape, colour, size)), ('by hand', 'by_hand', point(shape, HAND, size)))


def handle_line(colour, seldom='false'):
    """A line to redraw; what one seldom needs is thin."""
    return lambda: rules(('seldom', f'NOT by_hand AND {seldom}', line(colour, 0.1, dash='1;2')), ('computed', f'NOT by_hand AND NOT {seldom}', line(colour, 0.3, dash='2;2')),
                         ('by hand', 'by_hand', line(HAND, 0.5)))


def by_hand(relation, *columns):
    """What users decided; here also that which fits nowhere can be seen and deleted."""
    return Layer('overrides', relation, f'{relation}_id', 'geom', lambda: single(point('star', HAND, 3)), columns)


LAYERS = (
    Layer('edit', 'node_editing', 'node_id', 'geom', lambda: single(point('circle', AXIS, 2.6)), ()),
    Layer('edit', 'section_limit_editing', 'section_limit_id', 'geom', handle('diamond', 2.6, LIMIT), ('abscissa', 'by_hand'), scale=2500),
    Layer('edit', 'corner_editing', 'corner_id', 'geom', handle('circle', 2.2, ARC), ('radius', 'by_hand'), scale=2500),
    Layer('edit', 'kerb_point_editing', 'kerb_point_id', 'geom', lambda: single(point('square', HAND, 2.2)), ('axis_id', 'width'), scale=2500),
    Layer('edit', 'interconnection_editing', 'interconnection_id', 'geom', handle_line(CONTROL, 'NOT connecting'), ('connecting', 'by_hand'), scale=1000),
    Layer('edit', 'lane_editing', 'lane_id', 'geom', handle_line('#ffffff'), ('along_axis', 'both_ways', 'width', 'by_hand'), scale=2500),
    Layer('edit', 'edge_editing', 'edge_id', 'geom', lambda: single(line(AXIS, 0.5, dash='3;1')), ()),
    Layer('edit', 'axis_editing', 'axis_id', 'geom', axis, ('width', 'lane_count', 'direction', 'speed', 'importance', 'name', 'level')),
    Layer('edit', 'edit_log', 'edit_log_id', 'extent', lambda: single(fill('#00000000', HAND, 0.3))),
    Layer('input', 'turn_restriction', 'turn_restriction_id', 'geom', lambda: single(point('octagon', REPORT, 3)),
          ('from_axis', 'to_axis', 'kind', 'turn', 'except_kinds', 'source', 'source_ref'), scale=2500),
    Layer('input', 'axis', 'axis_id', 'geom', axis,
          ('width', 'width_end', 'lane_count', 'direction', 'speed', 'importance', 'name', 'level', 'kind', 'radius', 'lanes_forward', 'lanes_backward', 'lanes_both',
           'kind_forward', 'kind_backward', 'lane_width_forward', 'lane_width_backward', 'turn_forward', 'turn_backward', 'source', 'source_ref'), shown=True),
    by_hand('transition_override', 'axis_id', 'which', 'kind', 'length'),
    by_hand('section_limit_override', 'axis_id', 'which', 'abscissa'),
    by_hand('corner_override', 'axis_a', 'axis_b', 'radius'),
    by_hand('kerb_point_override', 'axis_id', 'abscissa', 'width'),
    by_hand('lane_override', 'axis_id', 'abscissa', 'ordinality', 'along_axis', 'both_ways', 'width'),
    by_hand('interconnection_override', 'axis_in', 'lane_in', 'axis_out', 'lane_out', 'along_in', 'along_out', 'connecting'),
    Layer('input', 'axis_class', 'class', writable=('taken', 'width', 'speed', 'importance')),
    Layer('input', 'setting', 'name'),
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
    Layer('streets', 'kerb', 'kerb_id', 'geom',
          lambda: rules(('kerb', "method <> 'level_change'", line(KERB, 0.3, 'MapUnit')), ('level change', "method = 'level_change'", line(LIMIT, 0.3, dash='1;1'))), scale=2500),
    Layer('streets', 'roadway', 'roadway_id', 'surface', roadway, query=' UNION ALL '.join(ROADWAY.values()), kind='MultiPolygon', shown=True),
    Layer('streets', 'intersection', 'node_id', 'surface', surface_by_method(JUNCTION)),
    Layer('streets', 'section', 'edge_id', 'surface', surface_by_method(ASPHALT)),
)


def layers_of(relations):
    """The layers of a model that has these relations: a subject that it does not compute has none."""
    shown = ' UNION ALL '.join(rows for relation, rows in ROADWAY.items() if relation in relations)
    return [dataclasses.replace(layer, query=shown) if layer.relation == 'roadway' else layer for layer in LAYERS if layer.relation in relations]
