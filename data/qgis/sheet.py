"""The print layout of a project: the map at 1:500 on A3, with what a sheet to hand over needs."""
from qgis.core import (QgsExpressionContextUtils, QgsLayoutItemLabel, QgsLayoutItemLegend, QgsLayoutItemMap, QgsLayoutItemMapGrid, QgsLayoutItemPage, QgsLayoutItemPicture, QgsLayoutItemScaleBar,
                       QgsLayoutPoint, QgsLayoutSize, QgsLegendRenderer, QgsLegendStyle, QgsPrintLayout, QgsRectangle, QgsTextFormat, QgsUnitTypes)
from qgis.PyQt.QtGui import QFont

from style import colour

SCALE = 500
# Millimetres of A3: the paper, its margin, and the column beside the map.
WIDE, HIGH, MARGIN, COLUMN = 420, 297, 10, 68
# QGIS fills in what stands in brackets when the sheet is drawn.
WORDS = """[% upper(substr(@project_title, 1, 1)) || substr(@project_title, 2) %]
Streets, theme {theme}
1:[% round(map_get(item_variables('map'), 'map_scale')) %]   SRID {srid}
[% format_date(now(), 'yyyy-MM-dd') %]
[% @attribution %]"""


def letters(points, ink):
    text = QgsTextFormat()
    text.setFont(QFont('DejaVu Sans'))
    text.setSize(points)
    text.setSizeUnit(QgsUnitTypes.RenderPoints)
    if ink:
        text.setColor(colour(ink))
    return text


def place(layout, item, x, y, wide, high):
    item.attemptMove(QgsLayoutPoint(x, y))
    item.attemptResize(QgsLayoutSize(wide, high))
    layout.addLayoutItem(item)
    return item


def frame_map(layout, centre):
    """About a place, at the scale of the sheet."""
    item = place(layout, QgsLayoutItemMap(layout), MARGIN, MARGIN, WIDE - 3 * MARGIN - COLUMN, HIGH - 2 * MARGIN)
    item.setId('map')
    half_wide, half_high = (side * SCALE / 2000 for side in (item.rect().width(), item.rect().height()))
    item.setExtent(QgsRectangle(centre.x() - half_wide, centre.y() - half_high, centre.x() + half_wide, centre.y() + half_high))
    item.setScale(SCALE)
    item.setFollowVisibilityPreset(True)
    item.setFollowVisibilityPresetName('map')
    item.setFrameEnabled(True)
    item.setBackgroundColor(layout.project().backgroundColor())
    return item


def tell_coordinates(item, ink):
    """Crosses each 100 mm of the sheet, with their coordinates at the left and below."""
    grid = item.grid()
    grid.setEnabled(True)
    grid.setIntervalX(SCALE / 10)
    grid.setIntervalY(SCALE / 10)
    grid.setStyle(QgsLayoutItemMapGrid.Cross)
    grid.setCrossLength(2)
    grid.setAnnotationEnabled(True)
    grid.setAnnotationPrecision(0)
    grid.setAnnotationTextFormat(letters(6, ink))
    for side in (QgsLayoutItemMapGrid.Top, QgsLayoutItemMapGrid.Right):
        grid.setAnnotationDisplay(QgsLayoutItemMapGrid.HideAll, side)
    grid.setAnnotationDirection(QgsLayoutItemMapGrid.Vertical, QgsLayoutItemMapGrid.Left)


def tell_meanings(layout, item, ink):
    """A legend of what is seen on the map, and nothing else."""
    legend = QgsLayoutItemLegend(layout)
    legend.setId('legend')
    legend.setResizeToContents(True)
    for part, points in ((QgsLegendStyle.Group, 9), (QgsLegendStyle.Subgroup, 8), (QgsLegendStyle.SymbolLabel, 8)):
        style = legend.style(part)
        style.setFont(QFont('DejaVu Sans', points))
        legend.setStyle(part, style)
    if ink:
        legend.setFontColor(colour(ink))
    legend.setAutoUpdateModel(False)
    root = legend.model().rootGroup()
    for group in list(root.children()):
        if group.name() != 'map':
            root.removeChildNode(group)
    for node in (*root.children(), *root.findLayers()):
        QgsLegendRenderer.setNodeLegendStyle(node, QgsLegendStyle.Hidden)
    # Last, as each change of a legend that is filtered looks through all that the map shows.
    legend.setLegendFilterByMapEnabled(True)
    legend.setLinkedMap(item)
    return place(layout, legend, WIDE - MARGIN - COLUMN, MARGIN + 24, COLUMN, HIGH - 110)


def add_sheet(project, look, centre, srid, attribution):
    ink = look.one('ink').fill
    # As a variable: what stands in brackets in it is no expression.
    QgsExpressionContextUtils.setProjectVariable(project, 'attribution', attribution)
    layout = QgsPrintLayout(project)
    layout.initializeDefaults()
    layout.setName('sheet')
    layout.pageCollection().page(0).setPageSize('A3', QgsLayoutItemPage.Landscape)
    item = frame_map(layout, centre)
    tell_coordinates(item, ink)
    left = WIDE - MARGIN - COLUMN
    arrow = QgsLayoutItemPicture(layout)
    arrow.setPicturePath(':/images/north_arrows/layout_default_north_arrow.svg')
    arrow.setLinkedMap(item)
    place(layout, arrow, left, MARGIN, 18, 20)
    tell_meanings(layout, item, ink)
    bar = QgsLayoutItemScaleBar(layout)
    bar.setStyle('Single Box')
    bar.setLinkedMap(item)
    bar.setUnits(QgsUnitTypes.DistanceMeters)
    bar.setUnitLabel('m')
    bar.setUnitsPerSegment(10)
    bar.setNumberOfSegments(2)
    bar.setNumberOfSegmentsLeft(0)
    bar.setHeight(2)
    bar.setTextFormat(letters(8, ink))
    place(layout, bar, left, HIGH - MARGIN - 62, COLUMN, 14)
    title = QgsLayoutItemLabel(layout)
    title.setId('title block')
    title.setText(WORDS.format(theme='street', srid=srid))
    title.setFont(QFont('DejaVu Sans', 9))
    if ink:
        title.setFontColor(colour(ink))
    title.setMargin(3)
    title.setFrameEnabled(True)
    place(layout, title, left, HIGH - MARGIN - 44, COLUMN, 44)
    project.layoutManager().addLayout(layout)
    return layout
