"""Groups of layers, each a map theme of QGIS too."""
import dataclasses

from qgis.core import QgsMapLayerLegendUtils, QgsMapThemeCollection, QgsMarkerSymbol

from layers import GROUPS
from style import fill, point


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


def rimmed(symbol, look):
    """White on white is seen by its rim."""
    return dataclasses.replace(symbol, line=look.one('ink').fill, width=0.4, unit='pixel')


def tell_once(node, look):
    """The legend of a layer of the map: each meaning once, whatever the level, and nothing without one."""
    meanings = {symbol.meaning: symbol for symbol in reversed(look.symbols) if symbol.meaning}
    told = {}
    for number, item in enumerate(node.layer().renderer().legendSymbolItems()):
        if item.label() in meanings and item.label() not in told:
            told[item.label()] = number
            symbol = meanings[item.label()]
            if item.symbol() is None:
                QgsMapLayerLegendUtils.setLegendNodeCustomSymbol(node, number, fill(symbol if symbol.dash else rimmed(symbol, look)))
            elif isinstance(item.symbol(), QgsMarkerSymbol):
                QgsMapLayerLegendUtils.setLegendNodeCustomSymbol(node, number, point(symbol, 'circle', 3))
    if told:
        QgsMapLayerLegendUtils.setLegendNodeOrder(node, list(told.values()))


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
