"""Groups of layers, each a map theme of QGIS too."""
from qgis.core import QgsMapLayerLegendUtils, QgsMapThemeCollection

from layers import GROUPS


def group_of(tree, path):
    """A group by its path; one within another one is shut."""
    for name in path.split('/'):
        tree = tree.findGroup(name) or tree.addGroup(name)
    tree.setExpanded(path in GROUPS)
    return tree


def arrange(project, layers, vectors):
    """Layers into their groups: map first, drawn below all others."""
    tree = project.layerTreeRoot()
    for group in GROUPS:
        tree.addGroup(group)
    for layer in layers:
        group_of(tree, layer.group).addLayer(vectors[layer.relation])
    tree.setCustomLayerOrder([vectors[layer.relation] for layer in layers])
    tree.setHasCustomLayerOrder(True)
    for node in tree.findLayers():
        node.setExpanded(False)


def tell_once(tree, vector):
    """The legend tells each meaning once, whatever the level."""
    told, items = {}, vector.renderer().legendSymbolItems()
    for number, item in enumerate(items):
        if item.symbol() is not None:
            told.setdefault(item.label(), number)
    if 0 < len(told) < len(items):
        QgsMapLayerLegendUtils.setLegendNodeOrder(tree.findLayer(vector.id()), list(told.values()))


def remember(project, layers, vectors):
    """A map theme for each group: its own layers, over the streets as one sees them or as they were computed."""
    themes = project.mapThemeCollection()
    for group, look in GROUPS.items():
        record = QgsMapThemeCollection.MapThemeRecord()
        for layer in layers:
            if layer.shown and layer.group.split('/')[0] == group or layer.group == 'map' and (group == 'map' or layer.relation == 'street'):
                part = QgsMapThemeCollection.MapThemeLayerRecord(vectors[layer.relation])
                part.isVisible = True
                part.usingCurrentStyle = True
                part.currentStyle = look if layer.relation == 'street' else vectors[layer.relation].styleManager().currentStyle()
                record.addLayerRecord(part)
        themes.insert(group, record)
    # Visible are those of the map.
    for layer in layers:
        project.layerTreeRoot().findLayer(vectors[layer.relation].id()).setItemVisibilityChecked(layer.group == 'map')
