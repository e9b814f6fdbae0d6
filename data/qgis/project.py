#!/usr/bin/python3
"""Saves styles and a project of a model in its database.

The layers are stored with CONNECTION as libpq writes it ("service=town" or "host=… port=… dbname=…"), without a user and a
password: QGIS asks for them, or libpq finds them (PGUSER, PGPASSWORD, ~/.pgpass). Table public.layer_styles gets a default style for
each layer of the model, table qgis_projects of its schema a project of its name; both replace those of an earlier run.
"""
import argparse
import math
import sys

from headless import qgis

from qgis.core import Qgis, QgsDateTimeRange, QgsException, QgsMapLayerDependency, QgsProject, QgsRectangle, QgsReferencedRectangle, QgsRuleBasedRenderer, QgsSnappingConfig, QgsTolerance, QgsUnitTypes, QgsVectorLayer
from qgis.PyQt.QtCore import QDateTime, Qt, QUrl, QUrlQuery
from qgis.PyQt.QtXml import QDomDocument

from database import Database, Refused, identifier, literal
from form import set_form
from layers import layers_of
from look import Look
from shape import RUN_DAY
from sheet import add_sheet
from style import colour
from theme import arrange, remember, tell_once

STYLE = 'streetgen'


def farthest(rule):
    """The scale up to which a rule of QGIS draws, or one below it."""
    return min(rule.minimumScale() or math.inf, max(map(farthest, rule.children()), default=math.inf))


def see_up_to(vector, drawing):
    """Nothing is read of the server beyond the scale up to which the rules of a renderer or of labels draw."""
    scale = farthest(drawing.rootRule())
    vector.setScaleBasedVisibility(scale < math.inf)
    if scale < math.inf:
        vector.setMinimumScale(scale)


def draw_by(vector, renderer):
    vector.setRenderer(renderer)
    if isinstance(renderer, QgsRuleBasedRenderer):
        see_up_to(vector, renderer)


def set_times(vector, begins, ends):
    """The temporal controller shows what is there at its time."""
    times = vector.temporalProperties()
    times.setIsActive(True)
    times.setMode(Qgis.VectorTemporalMode.FeatureDateTimeStartAndEndFromFields)
    times.setLimitMode(Qgis.VectorTemporalLimitMode.IncludeBeginExcludeEnd)
    times.setStartField(begins)
    times.setEndField(ends)


def play(project, seconds):
    """The temporal controller goes through the runs, second by second."""
    first = QDateTime.fromString(RUN_DAY, Qt.ISODate)
    project.timeSettings().setTemporalRange(QgsDateTimeRange(first, first.addMSecs(int(1000 * seconds))))
    project.timeSettings().setTimeStep(1)
    project.timeSettings().setTimeStepUnit(QgsUnitTypes.TemporalSeconds)


def vector_layer(database, model, srid, layer, looks):
    vector = QgsVectorLayer(database.source(model, srid, layer), layer.name, 'postgres', QgsVectorLayer.LayerOptions(False))  # no style of a run before
    if not vector.isValid():
        raise Refused(f'{model}.{layer.relation} cannot be read: {vector.error().summary()}')
    look = looks[layer.theme]
    if layer.renderer:
        draw_by(vector, layer.renderer(look))
    if layer.labels:
        labels = layer.labels(look)
        see_up_to(vector, labels)
        vector.setLabeling(labels)
        vector.setLabelsEnabled(True)
    if layer.scale:
        vector.setScaleBasedVisibility(True)
        vector.setMinimumScale(layer.scale)
    if layer.when:
        set_times(vector, *layer.when)
    vector.setMapTipTemplate(layer.tip)
    vector.setReadOnly(layer.writable is None)
    return vector


def style_by_theme(layer, vector, looks):
    """A style for each theme of the rules; the layer has its own in the end."""
    styles = vector.styleManager()
    styles.renameStyle(styles.currentStyle(), layer.theme)
    for theme, look in looks.items():
        if theme != layer.theme:
            styles.addStyleFromLayer(theme)
            styles.setCurrentStyle(theme)
            draw_by(vector, layer.renderer(look))
    styles.setCurrentStyle(layer.theme)


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
    layers = layers_of(database.relations(model), database.decisions(model), database.levels(model), database.buildings(model))
    looks = {theme: Look(database, model, theme) for theme in ('street', 'construction')}
    project = QgsProject.instance()
    project.clear()
    project.setTitle(model)
    ground = looks['street'].one('ground').fill
    if ground:
        project.setBackgroundColor(colour(ground))
    vectors = {layer.relation: vector_layer(database, model, srid, layer, looks) for layer in layers}
    for layer in layers:
        vector = vectors[layer.relation]
        set_form(vector, layer, words, vectors)
        if layer.relation == 'street':
            style_by_theme(layer, vector, looks)
        project.addMapLayer(vector, False)
    arrange(project, layers, vectors)
    for layer in layers:
        if layer.group == 'map':
            tell_once(project.layerTreeRoot().findLayer(vectors[layer.relation].id()), looks[layer.theme])
    remember(project, layers, vectors)
    axis = vectors['axis']
    project.setCrs(axis.crs())
    extent = database.extent(model)
    if extent:
        extent = QgsRectangle(*extent)
        project.viewSettings().setDefaultViewExtent(QgsReferencedRectangle(extent, axis.crs()))
        add_sheet(project, looks['street'], extent.center(), srid, database.attribution(model))
    seconds = database.run_seconds(model) if 'simulated_car' in vectors else None
    if seconds:
        play(project, seconds)
    snap(project)
    follow(model, layers, vectors)
    return project, layers, vectors


def style_of(vector):
    """A style as QGIS keeps it."""
    document = QDomDocument()
    vector.exportNamedStyle(document)
    return document.toString()


def save_styles(database, model, layers, vectors):
    """All at once: QGIS itself asks some twenty questions for each."""
    styled = [layer for layer in layers if layer.renderer and not layer.query]
    if not database.ask("SELECT to_regclass('public.layer_styles') IS NOT NULL")[0][0]:
        failure = vectors[styled[0].relation].saveStyleToDatabase(STYLE, '', False, '')  # QGIS makes its table
        if failure:
            raise Refused(f'styles cannot be saved: {failure}')
    if not database.ask("SELECT has_table_privilege('public.layer_styles', 'SELECT') AND has_table_privilege('public.layer_styles', 'INSERT') AND has_table_privilege('public.layer_styles', 'DELETE')")[0][0]:
        print(f'streetgen: the project has its styles, but layers of {model} that are added by hand get none: '
              'GRANT SELECT, INSERT, DELETE ON public.layer_styles by its owner lets this role save them', file=sys.stderr)
        return
    database.ask(f"DELETE FROM public.layer_styles WHERE f_table_catalog = current_database() AND f_table_schema = {literal(model)} AND stylename = '{STYLE}'")
    rows = ', '.join(f"(current_database(), {literal(model)}, {literal(layer.relation)}, {literal(layer.geometry)}, '{STYLE}', "
                     f'xmlparse(DOCUMENT {literal(style_of(vectors[layer.relation]))}), true, {literal(f"{model}.{layer.relation}")}, current_user, current_timestamp)' for layer in styled)
    database.ask('INSERT INTO public.layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, stylename, styleqml, useasdefault, description, owner, update_time) '
                 f'VALUES {rows} RETURNING 1')


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
    # The table that QGIS made belongs to whoever saved the first project.
    projects = f'{identifier(model)}.qgis_projects'
    for owner, in database.ask(f"SELECT nspowner::regrole::text FROM pg_class c JOIN pg_namespace n ON n.oid = relnamespace "
                               f"WHERE c.oid = {literal(projects)}::regclass AND relowner <> nspowner AND pg_has_role(relowner, 'MEMBER') AND pg_has_role(nspowner, 'MEMBER')"):
        database.ask(f'ALTER TABLE {projects} OWNER TO {owner}')


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
