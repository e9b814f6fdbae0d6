#!/usr/bin/python3
"""Saves styles and a project of a model in its database.

The layers are stored with CONNECTION as libpq writes it ("service=town" or "host=… port=… dbname=…"), without a user and a
password: QGIS asks for them, or libpq finds them (PGUSER, PGPASSWORD, ~/.pgpass). Table public.layer_styles gets a default style for
each layer of the model, table qgis_projects of its schema a project of its name; both replace those of an earlier run.
"""
import argparse
import sys

from headless import qgis

from qgis.core import QgsException, QgsMapLayerDependency, QgsProject, QgsReferencedRectangle, QgsSnappingConfig, QgsTolerance, QgsVectorLayer
from qgis.PyQt.QtCore import QUrl, QUrlQuery
from qgis.PyQt.QtGui import QColor

from database import Database, Refused, literal
from form import set_form
from layers import layers_of
from style import GROUND

STYLE = 'streetgen'


def vector_layer(database, model, srid, layer):
    vector = QgsVectorLayer(database.source(model, srid, layer), layer.relation, 'postgres')
    if not vector.isValid():
        raise Refused(f'{model}.{layer.relation} cannot be read: {vector.error().summary()}')
    if layer.renderer:
        vector.setRenderer(layer.renderer())
    if layer.scale:
        vector.setScaleBasedVisibility(True)
        vector.setMinimumScale(layer.scale)
    vector.setReadOnly(layer.writable is None)
    return vector


def snap(project):
    """Axes meet at shared vertices: the pointer catches those of others, and one that is moved moves all."""
    config = QgsSnappingConfig(project)
    config.setEnabled(True)
    config.setMode(QgsSnappingConfig.ActiveLayer)
    config.setTypeFlag(QgsSnappingConfig.VertexFlag | QgsSnappingConfig.SegmentFlag)
    config.setTolerance(12)
    config.setUnits(QgsTolerance.Pixels)
    project.setSnappingConfig(config)
    project.setTopologicalEditing(True)


def follow(model, layers, vectors):
    """What is computed is drawn anew after each commit of this QGIS, and on NOTIFY qgis, to which one layer listens for all."""
    axis = vectors['axis']
    axis.setRefreshOnNotifyEnabled(True)
    axis.setRefreshOnNofifyMessage(model)
    for layer in layers:
        if layer.geometry and layer.relation != 'axis':
            vectors[layer.relation].setDependencies([QgsMapLayerDependency(axis.id())])


def make_project(database, model):
    srid, words = database.srid(model), database.words(model)
    layers = layers_of(database.relations(model), database.decisions(model))
    project = QgsProject.instance()
    project.clear()
    project.setTitle(model)
    project.setBackgroundColor(QColor(GROUND))
    vectors = {layer.relation: vector_layer(database, model, srid, layer) for layer in layers}
    tree = project.layerTreeRoot()
    for layer in layers:
        vector = vectors[layer.relation]
        set_form(vector, layer, words, vectors)
        project.addMapLayer(vector, False)
        (tree.findGroup(layer.group) or tree.addGroup(layer.group)).addLayer(vector).setItemVisibilityChecked(layer.shown)
    axis = vectors['axis']
    project.setCrs(axis.crs())
    if not axis.extent().isEmpty():
        project.viewSettings().setDefaultViewExtent(QgsReferencedRectangle(axis.extent(), axis.crs()))
    snap(project)
    follow(model, layers, vectors)
    return project, layers, vectors


def save_styles(database, model, layers, vectors):
    if database.ask("SELECT to_regclass('public.layer_styles') IS NOT NULL")[0][0]:
        # QGIS would ask whether to replace them.
        database.ask(f"DELETE FROM public.layer_styles WHERE f_table_catalog = current_database() AND f_table_schema = {literal(model)} AND stylename = '{STYLE}'")
    for layer in layers:
        if layer.renderer and not layer.query:
            failure = vectors[layer.relation].saveStyleToDatabase(STYLE, f'{model}.{layer.relation}', True, '')
            if failure:
                raise Refused(f'the style of {layer.relation} cannot be saved: {failure}')


def project_uri(database, model):
    """Where the project of a model is, as QGIS writes it."""
    uri, url, query = database.uri, QUrl('postgresql:'), QUrlQuery()
    if uri.service():
        query.addQueryItem('service', uri.service())
    else:
        url.setHost(uri.host())
        url.setPort(int(uri.port() or -1))
        query.addQueryItem('dbname', uri.database())
    query.addQueryItem('schema', model)
    query.addQueryItem('project', model)
    url.setQuery(query)
    return url.toEncoded().data().decode()


def save(connection, model):
    database = Database(connection)
    project, layers, vectors = make_project(database, model)
    save_styles(database, model, layers, vectors)
    if not project.write(project_uri(database, model)):
        raise Refused(f'the project cannot be saved: {project.error()}')


if __name__ == '__main__':
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('connection')
    parser.add_argument('model')
    arguments = parser.parse_args()
    with qgis():
        try:
            save(arguments.connection, arguments.model)
        except (Refused, QgsException) as refused:
            sys.exit(f'streetgen: {refused}')
