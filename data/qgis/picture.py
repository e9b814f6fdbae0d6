"""A map as QGIS draws it, without a window."""
from qgis.core import QgsMapRendererParallelJob, QgsMapSettings
from qgis.PyQt.QtCore import QSize


def picture(project, layers, extent, width, height):
    """The layers, top first, that are shown at the picture's scale; a QImage."""
    settings = QgsMapSettings()
    settings.setDestinationCrs(project.crs())
    settings.setTransformContext(project.transformContext())
    settings.setLayers(layers)
    settings.setOutputSize(QSize(width, height))
    settings.setOutputDpi(96)
    settings.setExtent(extent)
    settings.setBackgroundColor(project.backgroundColor())
    settings.setFlag(QgsMapSettings.Antialiasing)
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    failures = [f'{error.layerID}: {error.message}' for error in job.errors()]
    if failures:
        raise RuntimeError('; '.join(failures))
    return job.renderedImage()
