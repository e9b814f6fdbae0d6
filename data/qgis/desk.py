"""One QGIS with the project of a model open: what an editor does, as calls."""
import contextlib

from qgis.core import QgsGeometry, QgsLayoutExporter, QgsMapRendererParallelJob, QgsMapSettings, QgsPointXY, QgsProject, QgsRectangle, QgsVectorLayerUtils
from qgis.PyQt.QtCore import QSize

from database import Refused


class Desk:
    def __init__(self, uri):
        self.project = QgsProject.instance()
        if not self.project.read(uri):
            raise Refused(f'{uri} cannot be opened: {self.project.error()}')

    def layer(self, name):
        return self.project.mapLayersByName(name)[0]

    @contextlib.contextmanager
    def editing(self, name):
        """Toggle editing, work, save."""
        layer = self.layer(name)
        layer.startEditing()
        yield layer
        if not layer.commitChanges():
            errors = layer.commitErrors()
            layer.rollBack()
            raise Refused('; '.join(errors))

    def draw(self, layer_name, wkt, **values):
        """A new feature with the values typed in its form."""
        with self.editing(layer_name) as layer:
            layer.addFeature(QgsVectorLayerUtils.createFeature(layer, QgsGeometry.fromWkt(wkt), {layer.fields().indexFromName(column): value for column, value in values.items()}))

    def find(self, name, where):
        """The one feature for which an expression holds."""
        found = list(self.layer(name).getFeatures(where))
        if len(found) != 1:
            raise Refused(f'{len(found)} features of {name} where {where}')
        return found[0]

    def nearest(self, name, x, y, where='true'):
        """Of the features for which an expression holds the one next to a place, as an expression."""
        place = QgsGeometry.fromPointXY(QgsPointXY(x, y))
        return f'$id = {min(self.layer(name).getFeatures(where), key=lambda feature: feature.geometry().distance(place)).id()}'

    def type_in(self, layer_name, where, **values):
        with self.editing(layer_name) as layer:
            feature = self.find(layer_name, where)
            for column, value in values.items():
                layer.changeAttributeValue(feature.id(), layer.fields().indexFromName(column), value)

    def put(self, name, where, wkt):
        """Drag or redraw: the feature gets another geometry."""
        with self.editing(name) as layer:
            layer.changeGeometry(self.find(name, where).id(), QgsGeometry.fromWkt(wkt))

    def drag_vertex(self, name, where, number, x, y):
        with self.editing(name) as layer:
            layer.moveVertex(x, y, self.find(name, where).id(), number)

    def split(self, name, where, points):
        """Cut the feature along a line of points."""
        with self.editing(name) as layer:
            layer.selectByIds([self.find(name, where).id()])
            layer.splitFeatures(points, False)
            layer.removeSelection()

    def delete(self, name, where):
        with self.editing(name) as layer:
            layer.deleteFeature(self.find(name, where).id())

    def picture(self, west, south, east, north, width, also=(), theme='map', dpi=96):
        """The layers of a map theme, and some others; a QImage."""
        themes = self.project.mapThemeCollection()
        shown = {*themes.mapThemeVisibleLayerIds(theme), *(self.layer(name).id() for name in also)}
        settings = QgsMapSettings()
        settings.setDestinationCrs(self.project.crs())
        settings.setTransformContext(self.project.transformContext())
        settings.setLayers([layer for layer in self.project.layerTreeRoot().layerOrder() if layer.id() in shown])
        settings.setLayerStyleOverrides(themes.mapThemeStyleOverrides(theme))
        settings.setOutputSize(QSize(width, round(width * (north - south) / (east - west))))
        settings.setOutputDpi(dpi)
        settings.setExtent(QgsRectangle(west, south, east, north))
        settings.setBackgroundColor(self.project.backgroundColor())
        settings.setFlag(QgsMapSettings.Antialiasing)
        job = QgsMapRendererParallelJob(settings)
        job.start()
        job.waitForFinished()
        if job.errors():
            raise Refused('; '.join(f'{error.layerID}: {error.message}' for error in job.errors()))
        self.labels = job.takeLabelingResults()
        return job.renderedImage()

    def written(self, layer):
        """The labels of a layer in the last picture: text and turn, in degrees."""
        return [(label.labelText, label.rotation) for label in self.labels.allLabels() if label.layerID == layer.id()]

    def sheet(self, layout, dpi=60):
        """A print layout as a QImage."""
        return QgsLayoutExporter(layout).renderPageToImage(0, dpi=dpi)
