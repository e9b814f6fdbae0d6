"""What the map has of each relation of a model.  tests/qgis holds that grounds are the shapes that streetgen.svg draws.

QGIS asks for a box at each move, and an index must find the rows.  Decks from wall to wall, and junctions cut by importance, are computed of many
rows: here stretches with their borders, and whole junctions, stand for them.
"""
import dataclasses
import typing


@dataclasses.dataclass(frozen=True)
class Shape:
    layer: str  # of streetgen.symbol_rule
    relations: tuple  # those that it reads beside edge, the one that has the geometry first; @ is the model, @name its name as a value
    key: str
    kind: str = "''"
    level: str = 'level'
    geometry: str = 'surface'
    where: str = 'true'
    rows: typing.Optional[str] = None  # where not the first relation alone
    # A layer that shows more stands for it where a model has this relation.
    instead: typing.Optional[str] = None


EDGE = 'JOIN @.edge e USING (edge_id)'
OF_AXIS = 'JOIN @.street_object USING (street_object_id) LEFT JOIN @.axis a USING (axis_id)'
# Kinds, as PostgreSQL and QGIS both read them.
SECTION_KIND = "CASE WHEN method IN ('contested', 'crowded') THEN 'contested' ELSE '' END"
INTERSECTION_KIND = "CASE WHEN method IN ('contested', 'crowded') THEN 'contested' WHEN method = 'transition' THEN 'transition' ELSE '' END"
SIDEWALK_KIND = ("streetgen._paving_kind(CASE side WHEN 'left' THEN sidewalk_left WHEN 'right' THEN sidewalk_right "
                 'ELSE CASE sidewalk_left WHEN sidewalk_right THEN sidewalk_left END END)')
PAVING_AT_NODE = ("(SELECT CASE WHEN min(k) = max(k) THEN min(k) ELSE '' END FROM (SELECT streetgen._paving_kind(roadway) FROM @.paving JOIN @.edge e USING (edge_id) "
                  'WHERE node_id IN (e.from_node, e.to_node)) p(k))')
CORNER_KIND = "CASE WHEN method = 'hypothesis' THEN '' ELSE 'fallback' END"
PATH_KIND = "CASE WHEN plausible THEN '' ELSE 'implausible' END"
RING_KIND = "CASE WHEN accepted THEN '' ELSE 'refused' END"
GROUND_LEVEL = "(SELECT value::integer FROM @.setting WHERE name = 'ground_level')"
LEAST_IMPORTANCE = '(SELECT min(importance)::text FROM @.edge WHERE node_id IN (from_node, to_node))'
BRIDGE = dict(relations=('bridge',), key='bridge_id', kind='b.method', geometry='b.surface', rows='@.bridge b ' + EDGE)
TUNNEL = dict(relations=('tunnel',), key='tunnel_id', geometry='t.surface', rows='@.tunnel t ' + EDGE)
DECK = "@.bridge b JOIN @.edge e USING (edge_id) JOIN @.{0} p USING (edge_id)"
# The ends of a stretch: its street beyond it, and the limits of its section.
ENDING = dict(relations=('bridge', 'section'), key='bridge_id', kind='b.method', rows='@.bridge b JOIN @.section s USING (edge_id)')
ENDS = ("ST_Collect(ST_Buffer(ST_Difference(s.surface, b.surface), -0.1), (SELECT ST_Collect(border_line) FROM @.section_limit l WHERE l.edge_id = b.edge_id))")
# A deck is as high as the ground there, and has no parapet across.
DECK_SHADOW = f'ST_Difference(b.surface, ST_Buffer({ENDS}, 4, 2))'
PARAPET = f"ST_Buffer(ST_Difference(ST_Boundary(b.surface), ST_Buffer({ENDS}, 0.4, 2)), 0.25, 'endcap=flat join=mitre')"
ON_DECK = dict(layer='deck_paint', geometry='ST_CollectionExtract(ST_Intersection(p.surface, b.surface), 3)', where="b.method = 'overpass'")

GROUNDS = (
    Shape('block', ('block',), 'block_id', 'kind', GROUND_LEVEL),
    Shape('sidewalk', ('sidewalk', 'kerb', 'paving'), 'sidewalk_id', SIDEWALK_KIND, geometry='w.surface', rows='@.sidewalk w JOIN @.kerb USING (edge_id, side, part) JOIN @.paving USING (edge_id)'),
    Shape('kerb', ('kerb',), 'kerb_id', where="method <> 'level_change'"),
    Shape('section', ('section', 'paving'), 'edge_id', SECTION_KIND.replace("''", 'streetgen._paving_kind(roadway)'), rows='@.section JOIN @.paving USING (edge_id)'),
    Shape('intersection', ('intersection', 'paving'), 'node_id', INTERSECTION_KIND.replace("ELSE ''", 'ELSE ' + PAVING_AT_NODE)),
    Shape('roadway', ('section',), 'edge_id', 'importance::text', 's.level', rows='@.section s ' + EDGE),
    Shape('roadway', ('intersection',), 'node_id', LEAST_IMPORTANCE),
    Shape('junction', ('junction', 'intersection'), 'junction_id', level='i.level', geometry='j.surface', where="j.method <> 'hypothesis'",
          rows='@.junction j JOIN @.intersection i ON node_id = junction_id'),
    Shape('rail', ('rail',), 'rail_track_id', geometry='streetgen._rail_heads(rails)'),
    Shape('lane', ('lane',), 'lane_id', 'kind', geometry='l.surface', where="kind IN ('bus', 'carpool', 'cycle')", rows='@.lane l ' + EDGE),
    Shape('bay', ('parking_bay', 'street_object'), 'street_object_id', level='coalesce(a.level, 0)', geometry='p.surface', rows='@.parking_bay p ' + OF_AXIS),
    Shape('lane_separator', ('lane_separator',), 'lane_separator_id', 'kind', geometry='p.surface', rows='@.lane_separator p ' + EDGE),
    Shape('marking', ('marking',), 'marking_id', 'kind', geometry='m.surface', rows='@.marking m ' + EDGE, instead='rim_marking'),
    Shape('rim_marking', ('rim_marking',), 'marking_id', 'm.kind', geometry='m.surface', rows='@.rim_marking m ' + EDGE),
    Shape('crossing', ('pedestrian_crossing', 'street_object'), 'street_object_id', "coalesce(p.painted_as, '')", level='coalesce(a.level, 0)', geometry='p.stripes', rows='@.pedestrian_crossing p ' + OF_AXIS),
    Shape('refuge', ('pedestrian_crossing', 'street_object'), 'street_object_id', level='coalesce(a.level, 0)', geometry='p.island', rows='@.pedestrian_crossing p ' + OF_AXIS),
    Shape('bus_stop_box', ('bus_stop_box',), 'street_object_id', 'kind', geometry='p.paint', rows='@.bus_stop_box p'),
    Shape('bridge_shadow', geometry=DECK_SHADOW, **ENDING),
    Shape('bridge', **BRIDGE),
    Shape('parapet', geometry=PARAPET, **ENDING),
    Shape('tunnel', **TUNNEL),
    Shape('tunnel_wall', level=f'greatest(level, {GROUND_LEVEL})', **TUNNEL),
    Shape(key='lane_separator_id', relations=('bridge', 'lane_separator'), rows=DECK.format('lane_separator'), **ON_DECK),
    Shape(key='marking_id', relations=('bridge', 'marking'), rows=DECK.format('marking'), **ON_DECK),
)


def shown_of(relations):
    """The grounds of a model that has these relations, each with its number."""
    return [(number, shape) for number, shape in enumerate(GROUNDS) if relations.issuperset(shape.relations) and shape.instead not in relations]


def grounds(relations, levels):
    """The query of all grounds of a model that has these relations; deck is the level, but for levels beyond those named."""
    return ' UNION ALL '.join(
        f"SELECT {len(GROUNDS)} * {shape.key} + {number} AS street_id, '{shape.layer}' AS layer, {shape.kind} AS kind, "
        f'greatest({levels[0]}, least({levels[-1]}, {shape.level})) AS deck, {shape.geometry} AS surface FROM {shape.rows or "@." + shape.relations[0]} WHERE {shape.where}'
        for number, shape in shown_of(relations))


# Objects at true size: points with their shape, and stretches.
OBJECT = ("@.street_object o JOIN @.object_type t USING (type) LEFT JOIN streetgen._drawn_kinds(@name, 'street', 500) k "
          "ON (k.layer, k.kind) = ('object', type)")
OBJECT_POINTS = ("SELECT street_object_id, type, coalesce(k.drawn_as, '') AS kind, size, CASE WHEN symbol IN ('circle', 'tree') THEN 'circle' "
                 "WHEN symbol IN ('rectangle', 'square', 'triangle', 'arrow', 'star') THEN symbol ELSE 'diamond' END AS shape, "
                 "CASE WHEN symbol IN ('circle', 'tree') THEN 0 ELSE coalesce(angle, 0) END AS turn, o.geom "
                 f"FROM {OBJECT} WHERE symbol NOT IN ('crossing', 'bay') AND ST_Dimension(o.geom) = 0")
OBJECT_LINES = ("SELECT street_object_id, type, coalesce(k.drawn_as, '') AS kind, size, o.geom "
                f"FROM {OBJECT} WHERE symbol NOT IN ('crossing', 'bay') AND ST_Dimension(o.geom) = 1")
SIGNALS = "SELECT 2 * lane_id + along_axis::integer AS signal_head_id, lane_id, '' AS kind, 1.2 AS size, geom FROM @.signal_head"
# Streets as lines, and the names that stand along them.
STREETS = 'SELECT edge_id, importance::text AS kind, geom FROM @.edge'
NAMES = "SELECT e.edge_id, a.name, e.importance, e.importance::text AS kind, e.geom FROM @.edge e JOIN @.axis a USING (axis_id) WHERE btrim(a.name) <> ''"
# The number of a route; where there are several, the first.
NUMBERS = ("SELECT e.edge_id, btrim(split_part(a.ref, ';', 1)) AS ref, e.importance, e.importance::text AS kind, e.geom FROM @.edge e JOIN @.axis a USING (axis_id) "
           "WHERE btrim(split_part(a.ref, ';', 1)) <> ''")
# Lines of construction, by layer of streetgen.symbol_rule.
REPORT = 'SELECT row_number() OVER (ORDER BY axis_a, axis_b, issue, geom) AS report_id, * FROM @.report'
# Runs of simulations that were kept begin at midnight of this day.
RUN_DAY = '2000-01-01'
MOMENTS = (f"(SELECT run, t, timestamp '{RUN_DAY}' + make_interval(secs => t) AS begins, "
           f"timestamp '{RUN_DAY}' + make_interval(secs => coalesce(lead(t) OVER (PARTITION BY run ORDER BY t), t + 1)) AS ends "
           'FROM (SELECT DISTINCT run, t FROM @.simulated) moment)')
SIMULATED_CARS = ('SELECT simulated_id, run, t, begins, ends, car_id, kind, speed, link_id, metres, streetgen._standing_car(geom, heading, length, width) AS geom '
                  f'FROM @.simulated JOIN {MOMENTS} m USING (run, t) WHERE car_id IS NOT NULL')
SIMULATED_DENSITIES = ('SELECT simulated_id, run, t, begins, ends, density, streetgen._density_kind(density) AS kind, speed, link_id, ST_Force2D(geom) AS geom '
                       f'FROM @.simulated JOIN {MOMENTS} m USING (run, t) WHERE density >= 1')
