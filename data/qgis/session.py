#!/usr/bin/python3
"""An editing session: a quarter of fast roads drawn in QGIS from an empty model, step by step, with a picture of each step.

It makes model MODEL anew in the database of CONNECTION and puts the pictures into FOLDER; docs/guide/qgis.md shows them.
"""
import argparse
import pathlib
import sys

from headless import qgis

from qgis.core import QgsException, QgsPointXY

from database import Database, Refused, literal
from desk import Desk
from project import project_uri, save

# Metres of Lambert-93 (SRID 2154); all places below are offsets from here.
ORIGIN = (704000, 7060000)


def place(x, y):
    return ORIGIN[0] + x, ORIGIN[1] + y


def line(*places):
    return 'LINESTRING(%s)' % ', '.join('%r %r' % place(x, y) for x, y in places)


def point(x, y):
    return 'POINT(%r %r)' % place(x, y)


def named(name):
    return f"name = '{name}'"


def draw(desk, name, *places, **values):
    desk.draw('axis', line(*places), name=name, **values)


def motorway(desk):
    fast = dict(direction='direct', lane_count=2, width=9, speed=110, importance=1)
    draw(desk, 'motorway east', (-260, -8), (-150, -8), (150, -8), (260, -8), **fast)
    draw(desk, 'motorway west', (260, 8), (150, 8), (-150, 8), (-260, 8), **fast)


def boulevard(desk):
    wide = dict(lane_count=4, width=14, speed=70, importance=2)
    draw(desk, 'boulevard south', (0, -130), (0, -52), **wide)
    draw(desk, 'bridge', (0, -52), (0, 52), level=1, **wide)
    draw(desk, 'boulevard north', (0, 52), (0, 130), **wide)


def ramps(desk):
    ramp = dict(direction='direct', lane_count=1, width=5, speed=50, importance=2)
    for name, side, out in (('exit east', (-1, -1), True), ('entry east', (1, -1), False), ('exit west', (1, 1), True), ('entry west', (-1, 1), False)):
        places = [(side[0] * x, side[1] * y) for x, y in ((150, 8), (105, 12), (70, 28), (35, 46), (0, 52))]
        draw(desk, name, *(places if out else reversed(places)), **ramp)


def avenue(desk):
    draw(desk, 'avenue', (-260, -125), (-90, -135), (0, -130), (110, -120), (260, -125), lane_count=2, width=8, speed=50, importance=3)


def drag(desk):
    """The avenue's bend follows the pointer, and the avenue with it."""
    desk.drag_vertex('axis', named('avenue'), 3, *place(110, -90))


def cut(desk):
    """Cut in two where it bends, and the eastern half becomes one-way."""
    desk.split('axis', named('avenue'), [QgsPointXY(*place(110, -60)), QgsPointXY(*place(110, -150))])
    desk.type_in('axis', named('avenue') + f' AND x_max($geometry) > {place(200, 0)[0]}', name='avenue east', direction='direct', lane_count=1, width=5)


def clear(desk):
    """A ramp that nobody needs goes, and its junctions with it."""
    desk.delete('axis', named('entry west'))


def move_node(desk):
    """All that meets at the node follows."""
    desk.put('node_editing', desk.nearest('node_editing', *place(0, -130)), point(0, -124))


def decide(desk):
    """A limit is dragged along the avenue, one radius typed, the centre of another corner dragged, a kerb point dropped, a lane flipped, a path cut off."""
    desk.put('section_limit_editing', desk.nearest('section_limit_editing', *place(-12, -125)), point(-28, -126))
    desk.type_in('corner_editing', desk.nearest('corner_editing', *place(13, -109)), radius=12.0)
    desk.put('corner_editing', desk.nearest('corner_editing', *place(-13, -115)), point(-17, -112))
    desk.draw('kerb_point_editing', point(-8.5, -92))
    desk.type_in('lane_editing', desk.nearest('lane_editing', *place(-2, -85)), along_axis=True)
    desk.type_in('interconnection_editing', desk.nearest('interconnection_editing', *place(7, -114), 'connecting'), connecting=False)


# Step, what is done, frame of its picture (west, south, east, north), layers that are shown beside those of theme edit.
WHOLE = (-270, -175, 270, 145)
JUNCTION = (-48, -146, 48, -86)
FURTHER = ('interconnection_editing', 'lane_editing')
STEPS = (
    ('motorway', (motorway, boulevard), WHOLE, ()),
    ('ramps', (ramps, avenue), WHOLE, ()),
    ('split', (drag, cut, clear), WHOLE, ()),
    ('junction', (move_node,), JUNCTION, FURTHER),
    ('decided', (decide,), JUNCTION, FURTHER),
)


def make(database, connection, model):
    """The model, empty, and its project."""
    for there, in database.ask(f'SELECT name FROM streetgen.model WHERE name = {literal(model)}'):
        database.ask(f'SELECT streetgen.drop_model({literal(there)})')
    database.ask(f'SELECT streetgen.create_model({literal(model)}, 2154)')
    save(connection, model)
    return Desk(project_uri(database, model))


def run(connection, model, folder):
    desk = make(Database(connection), connection, model)
    for name, works, (west, south, east, north), also in STEPS:
        for work in works:
            work(desk)
        desk.picture(*place(west, south), *place(east, north), 960, also, 'edit').save(str(folder / f'live_{name}.png'))
    return desk


if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('connection')
    parser.add_argument('model')
    parser.add_argument('folder', type=pathlib.Path)
    arguments = parser.parse_args()
    with qgis():
        try:
            run(arguments.connection, arguments.model, arguments.folder)
        except (Refused, QgsException) as refused:
            sys.exit(f'streetgen: {refused}')
