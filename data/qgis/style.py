"""Symbols and renderers of QGIS that the layers of a model share. Widths are metres of ground (unit MapUnit) or millimetres of map (MM)."""
from qgis.core import (QgsFillSymbol, QgsLineSymbol, QgsMarkerLineSymbolLayer, QgsMarkerSymbol, QgsProperty, QgsRuleBasedRenderer,
                       QgsSingleSymbolRenderer, QgsSymbolLayer, QgsTemplatedLineSymbolLayerBase)

GROUND = '#e9e7df'
ASPHALT = '#5b6068'
JUNCTION = '#52575f'
KERB = '#b7b1a1'
WALK = '#d8ccb0'
PAINT = '#fafaf5'
BLOCK = '#dfe6d3'
ISLAND = '#bcd3a5'
STRIP = '#cfdcb4'
AXIS = '#2b6cb0'
LIMIT = '#0f766e'
ARC = '#1d4ed8'
PATH = '#5fd07a'
CONTROL = '#f2d15c'
IMPLAUSIBLE = '#c3c8cf'
HAND = '#d9480f'
REPORT = '#dc2626'


def fill(colour, outline=None, width=0.4, unit='MM', opacity=1.0):
    symbol = QgsFillSymbol.createSimple({'color': colour, 'outline_style': 'solid' if outline else 'no', 'outline_color': outline or colour,
                                         'outline_width': str(width), 'outline_width_unit': unit, 'joinstyle': 'round'})
    symbol.setOpacity(opacity)
    return symbol


def shaded(grey):
    """A fill of the grey (0 to 255) that an expression gives, a little warm."""
    symbol = fill('#ffffff')
    symbol.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyFillColor, QgsProperty.fromExpression(f'color_rgb({grey}, {grey}, {grey} - 6)'))
    return symbol


def line(colour, width, unit='MM', dash=None, opacity=1.0, offset=0):
    """offset: millimetres to the right of the line."""
    properties = {'line_color': colour, 'line_width': str(width), 'line_width_unit': unit, 'capstyle': 'flat', 'joinstyle': 'round'}
    if dash:
        properties.update({'use_custom_dash': '1', 'customdash': dash, 'customdash_unit': 'MM'})
    if offset:
        properties.update({'offset': str(offset), 'offset_unit': 'MM'})
    symbol = QgsLineSymbol.createSimple(properties)
    symbol.setOpacity(opacity)
    return symbol


def point(shape, colour, size):
    return QgsMarkerSymbol.createSimple({'name': shape, 'color': colour, 'size': str(size), 'outline_color': '#ffffff', 'outline_width': '0.3'})


def turned(symbol, angle):
    """A marker turned by an expression (degrees clockwise from the north)."""
    symbol.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyAngle, QgsProperty.fromExpression(angle))
    return symbol


def with_arrow(symbol, colour, size, angle='0'):
    """An arrow in the middle of the line, turned by an expression (degrees; NULL: none)."""
    arrow = QgsMarkerSymbol.createSimple({'name': 'filled_arrowhead', 'color': colour, 'size': str(size), 'outline_style': 'no'})
    arrow.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyAngle, QgsProperty.fromExpression(angle))
    arrow.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyLayerEnabled, QgsProperty.fromExpression(f'({angle}) IS NOT NULL'))
    arrows = QgsMarkerLineSymbolLayer(True)
    arrows.setPlacement(QgsTemplatedLineSymbolLayerBase.CentralPoint)
    arrows.setSubSymbol(arrow)
    symbol.appendSymbolLayer(arrows)
    return symbol


def single(symbol):
    return QgsSingleSymbolRenderer(symbol)


def rules(*rows):
    """Rules of (label, expression, symbol), from the ground up."""
    root = QgsRuleBasedRenderer.Rule(None)
    passes = 0
    for label, expression, symbol in rows:
        for layer in symbol.symbolLayers():
            layer.setRenderingPass(passes)
            passes += 1
        root.appendChild(QgsRuleBasedRenderer.Rule(symbol, 0, 0, expression, label))
    renderer = QgsRuleBasedRenderer(root)
    renderer.setUsingSymbolLevels(True)
    return renderer
