"""QGIS without a screen: settings and profile go to a folder that is removed at the end."""
import contextlib
import os
import tempfile

os.environ.setdefault('QT_QPA_PLATFORM', 'offscreen')

from qgis.core import QgsApplication  # noqa: E402  Qt reads its platform when it is loaded


@contextlib.contextmanager
def qgis():
    with tempfile.TemporaryDirectory() as folder:
        os.environ.setdefault('XDG_RUNTIME_DIR', folder)
        QgsApplication.setPrefixPath('/usr', True)
        application = QgsApplication([], True, folder)
        application.initQgis()
        try:
            yield application
        finally:
            application.exitQgis()
