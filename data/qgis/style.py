"""Symbols and renderers of QGIS.  Colours are those of rules; widths are metres of ground, or millimetres of map."""
import dataclasses

from qgis.core import (QgsFillSymbol, QgsLabeling, QgsLineSymbol, QgsMarkerLineSymbolLayer, QgsMarkerSymbol, QgsNullSymbolRenderer, QgsPalLayerSettings, QgsProperty,
                       QgsRuleBasedLabeling, QgsRuleBasedRenderer, QgsSimpleLineSymbolLayer,
                       QgsSingleSymbolRenderer, QgsSymbolLayer, QgsTemplatedLineSymbolLayerBase, QgsTextBackgroundSettings, QgsTextBufferSettings, QgsTextFormat, QgsUnitTypes)
from qgis.PyQt.QtCore import QPointF, QSizeF
from qgis.PyQt.QtGui import QColor, QFont

# A pixel of a rule stands for so many millimetres of map.
PIXEL = 0.28
# A name stands again along its street, and a number on its road, after so many pixels.
NAME_AGAIN, NUMBER_AGAIN = 450, 700


def colour(code):
    """Of #rrggbb or #rrggbbaa."""
    return QColor(*bytes.fromhex(code[1:]))


def as_text(code):
    return ','.join(str(part) for part in colour(code).getRgb())


def length(symbol, of=None):
    """The width of a rule, or so many of its units, with the unit that QGIS calls it by."""
    value = symbol.width if of is None else of
    return (value, 'MapUnit') if symbol.unit == 'metre' else (value * PIXEL, 'MM')


def stroke(symbol):
    """Properties of the line of a rule."""
    width, unit = length(symbol)
    properties = {'line_color': as_text(symbol.line), 'line_width': str(width), 'line_width_unit': unit, 'capstyle': 'flat', 'joinstyle': 'miter'}
    if symbol.dash:
        dashes = [length(symbol, float(dash)) for dash in symbol.dash.split()]
        dashes *= 1 + len(dashes) % 2
        properties.update({'use_custom_dash': '1', 'customdash': ';'.join(str(dash) for dash, _ in dashes), 'customdash_unit': unit})
    return properties


def fill(symbol):
    """A ground as a rule has it."""
    properties = {'style': 'solid' if symbol.fill else 'no', 'outline_style': 'no'}
    if symbol.fill:
        properties['color'] = as_text(symbol.fill)
    if symbol.marker == 'shadow':
        far, unit = length(symbol)
        properties.update({'offset': f'{far},{far}', 'offset_unit': unit})
    elif symbol.line and not symbol.dash:
        width, unit = length(symbol)
        properties.update({'outline_style': 'solid', 'outline_color': as_text(symbol.line), 'outline_width': str(width), 'outline_width_unit': unit, 'joinstyle': 'miter'})
    ground = QgsFillSymbol.createSimple(properties)
    if symbol.line and symbol.dash and symbol.marker is None:
        ground.appendSymbolLayer(QgsSimpleLineSymbolLayer.create(stroke(symbol)))
    return ground


def line(symbol, width=None, dash=None, offset=0):
    """A line as a rule has it, or so many millimetres wide; dash and offset (to the right) in millimetres too."""
    if not symbol.line:
        return QgsLineSymbol.createSimple({'line_style': 'no'})
    properties = stroke(symbol)
    if width:
        properties.update({'line_width': str(width), 'line_width_unit': 'MM', 'joinstyle': 'round'})
    if dash:
        properties.update({'use_custom_dash': '1', 'customdash': dash, 'customdash_unit': 'MM'})
    if offset:
        properties.update({'offset': str(offset), 'offset_unit': 'MM'})
    return QgsLineSymbol.createSimple(properties)


def outline(symbol, width=0.3):
    """A ground of which one sees the border alone."""
    border = QgsFillSymbol.createSimple({'style': 'no', 'outline_style': 'no'})
    if symbol.line:
        border.appendSymbolLayer(QgsSimpleLineSymbolLayer.create({**stroke(symbol), 'line_width': str(width), 'line_width_unit': 'MM'}))
    return border


def point(symbol, shape, size):
    """A point so many millimetres wide."""
    properties = {'name': shape, 'size': str(size), 'outline_style': 'no'}
    if symbol.fill:
        properties['color'] = as_text(symbol.fill)
    if symbol.line:
        width, unit = length(symbol)
        properties.update({'outline_style': 'solid', 'outline_color': as_text(symbol.line), 'outline_width': str(width), 'outline_width_unit': unit})
    marker = QgsMarkerSymbol.createSimple(properties)
    if not symbol.fill:
        marker.setOpacity(0)
    return marker


def at_true_size(symbol, shape, size, angle):
    """A point of a shape that an expression names, as many metres wide as one says, turned as one says (clockwise)."""
    marker = point(symbol, 'diamond', 1)
    layer = marker.symbolLayer(0)
    layer.setSizeUnit(QgsUnitTypes.RenderMapUnits)
    for of, expression in ((QgsSymbolLayer.PropertyName, shape), (QgsSymbolLayer.PropertySize, size), (QgsSymbolLayer.PropertyAngle, angle)):
        layer.setDataDefinedProperty(of, QgsProperty.fromExpression(expression))
    if symbol.marker == 'shadow':
        far, unit = length(symbol)
        layer.setOffset(QPointF(far, far))
        layer.setOffsetUnit(QgsUnitTypes.decodeRenderUnit(unit)[0])
    return marker


def as_wide_as(symbol, width):
    """A line in the colour of a ground, as many metres wide as an expression says."""
    stretch = QgsLineSymbol.createSimple({'line_color': as_text(symbol.fill or symbol.line), 'line_width': '1', 'line_width_unit': 'MapUnit', 'capstyle': 'flat', 'joinstyle': 'round'})
    stretch.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyStrokeWidth, QgsProperty.fromExpression(width))
    return stretch


def turned(symbol, angle):
    """A marker turned by an expression (degrees clockwise from the north)."""
    symbol.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyAngle, QgsProperty.fromExpression(angle))
    return symbol


def shaded(grey):
    """A ground of the grey (0 to 255) that an expression gives, a little warm."""
    symbol = QgsFillSymbol.createSimple({'outline_style': 'no'})
    symbol.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyFillColor, QgsProperty.fromExpression(f'color_rgb({grey}, {grey}, {grey} - 6)'))
    return symbol


def with_arrow(symbol, size, angle='0'):
    """An arrow in the middle of the line, turned by an expression (degrees; NULL: none)."""
    arrow = QgsMarkerSymbol.createSimple({'name': 'filled_arrowhead', 'size': str(size), 'outline_style': 'no'})
    arrow.setColor(symbol.color())
    arrow.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyAngle, QgsProperty.fromExpression(angle))
    arrow.symbolLayer(0).setDataDefinedProperty(QgsSymbolLayer.PropertyLayerEnabled, QgsProperty.fromExpression(f'({angle}) IS NOT NULL'))
    arrows = QgsMarkerLineSymbolLayer(True)
    arrows.setPlacement(QgsTemplatedLineSymbolLayerBase.CentralPoint)
    arrows.setSubSymbol(arrow)
    symbol.appendSymbolLayer(arrows)
    return symbol


def single(symbol):
    return QgsSingleSymbolRenderer(symbol)


def nothing():
    return QgsNullSymbolRenderer()


def between(rule, symbol):
    """The rule of QGIS holds at the scales of one of ours.  QGIS keeps whole numbers, and draws at both ends of its spans."""
    rule.setMaximumScale(symbol.from_scale and symbol.from_scale + 1)
    rule.setMinimumScale(symbol.to_scale + 1 if symbol.to_scale else 0)
    return rule


def at_pass(symbol, number):
    for layer in symbol.symbolLayers():
        layer.setRenderingPass(number)
    return symbol


def rule_based(root):
    renderer = QgsRuleBasedRenderer(root)
    renderer.setUsingSymbolLevels(True)
    return renderer


def rules(*rows):
    """Rules of (label, expression, symbol), from the ground up."""
    root = QgsRuleBasedRenderer.Rule(None)
    for number, (label, expression, symbol) in enumerate(rows):
        root.appendChild(QgsRuleBasedRenderer.Rule(at_pass(symbol, number), 0, 0, expression, label))
    return rule_based(root)


def by_rule(symbols, made, kind="''", where=''):
    """Rules as those of a theme, in their order; made gives the symbol of each, kind and where are expressions."""
    root = QgsRuleBasedRenderer.Rule(None)
    for number, symbol in enumerate(sorted(symbols, key=lambda symbol: symbol.place)):
        holds = ' AND '.join(f'({part})' for part in (where, symbol.holds_of(kind)) if part)
        root.appendChild(between(QgsRuleBasedRenderer.Rule(at_pass(made(symbol), number), 0, 0, holds, symbol.label), symbol))
    return rule_based(root)


def level_by_level(symbols, levels):
    """Grounds as the rules of a theme say, of features with deck (their level), layer and kind: what lies higher is drawn later."""
    heights = sorted({(10 * level + symbol.place, symbol.layer, symbol.kind) for level in levels for symbol in symbols})
    passes = {height: number for number, height in enumerate(heights)}
    root = QgsRuleBasedRenderer.Rule(None)
    for layer in dict.fromkeys(symbol.layer for symbol in symbols):
        part = QgsRuleBasedRenderer.Rule(None, 0, 0, f"\"layer\" = '{layer}'", layer.replace('_', ' '))
        root.appendChild(part)
        for symbol in symbols:
            if symbol.layer == layer:
                rule = between(QgsRuleBasedRenderer.Rule(None, 0, 0, symbol.holds_of('"kind"'), symbol.label), symbol)
                part.appendChild(rule)
                for level in levels:
                    drawn = at_pass(fill(symbol), passes[10 * level + symbol.place, layer, symbol.kind])
                    rule.appendChild(QgsRuleBasedRenderer.Rule(drawn, 0, 0, f'"deck" = {level}', f'level {level}'))
    return rule_based(root)


def text(symbol):
    """Letters as a rule has them."""
    size, unit = length(symbol)
    unit = QgsUnitTypes.decodeRenderUnit(unit)[0]
    letters = QgsTextFormat()
    letters.setFont(QFont('DejaVu Sans'))
    letters.setSize(size)
    letters.setSizeUnit(unit)
    letters.setColor(colour(symbol.fill))
    if symbol.line:
        border = QgsTextBufferSettings()
        border.setEnabled(True)
        border.setSize(size / 4)
        border.setSizeUnit(unit)
        border.setColor(colour(symbol.line))
        letters.setBuffer(border)
    return letters


def in_a_box(symbol):
    """Letters in a box: the fill of a rule is its ground, the line its border and the letters."""
    letters = text(dataclasses.replace(symbol, fill=symbol.line, line=None))
    box = QgsTextBackgroundSettings()
    box.setEnabled(True)
    box.setType(QgsTextBackgroundSettings.ShapeRectangle)
    box.setSizeType(QgsTextBackgroundSettings.SizeBuffer)
    box.setSize(QSizeF(letters.size() / 3, letters.size() / 6))
    box.setSizeUnit(letters.sizeUnit())
    box.setFillColor(colour(symbol.fill))
    box.setStrokeColor(colour(symbol.line))
    box.setStrokeWidth(PIXEL)
    box.setStrokeWidthUnit(QgsUnitTypes.RenderMillimeters)
    letters.setBackground(box)
    return letters


def label_lines(symbols, column, kind, priority, placement, letters, again):
    """Labels on lines, one for lines that meet and bear the same, and again after so many pixels; kind and priority (0 to 10) are expressions."""
    root = QgsRuleBasedLabeling.Rule(None)
    for symbol in symbols:
        settings = QgsPalLayerSettings()
        settings.fieldName = column
        settings.placement = placement
        lines = settings.lineSettings()
        lines.setMergeLines(True)
        lines.setPlacementFlags(QgsLabeling.LinePlacementFlags(QgsLabeling.OnLine))
        settings.setLineSettings(lines)
        settings.upsidedownLabels = QgsPalLayerSettings.Upright
        settings.repeatDistance, settings.repeatDistanceUnit = again * PIXEL, QgsUnitTypes.RenderMillimeters
        properties = settings.dataDefinedProperties()
        properties.setProperty(QgsPalLayerSettings.Priority, QgsProperty.fromExpression(priority))
        settings.setDataDefinedProperties(properties)
        settings.setFormat(letters(symbol))
        root.appendChild(between(QgsRuleBasedLabeling.Rule(settings, 0, 0, symbol.holds_of(kind), symbol.label), symbol))
    return QgsRuleBasedLabeling(root)


def along_lines(symbols, column, kind, priority):
    """Names that follow their lines."""
    return label_lines(symbols, column, kind, priority, QgsPalLayerSettings.Curved, text, NAME_AGAIN)


def boxes_on_lines(symbols, column, kind, priority):
    """Numbers in boxes that stand upright on their lines."""
    return label_lines(symbols, column, kind, priority, QgsPalLayerSettings.Horizontal, in_a_box, NUMBER_AGAIN)
