"""What one types in: word lists where a column has few words, and nothing where it is not written."""
from qgis.core import QgsEditorWidgetSetup, QgsFieldConstraints


# Columns that hold the key of another layer, which is of one word.
LISTED = {('axis', 'kind'): ('axis_class', 'class'), ('street_object', 'type'): ('object_type', 'type'), ('placement_rule', 'type'): ('object_type', 'type'), ('object_distance', 'type_a'): ('object_type', 'type'), ('object_distance', 'type_b'): ('object_type', 'type'), ('object_type', 'parent'): ('object_type', 'type')}


def set_form(vector, layer, words, vectors):
    config = vector.editFormConfig()
    table = layer.relation.replace('_editing', '')
    for index, field in enumerate(vector.fields()):
        column = field.name()
        config.setReadOnly(index, column not in (layer.writable or ()))
        known = words.get((table, column)) or words.get((f'{table}_override', column))
        if known:
            widget = QgsEditorWidgetSetup('ValueMap', {'map': [{word: word} for word in known]})
        elif (table, column) in LISTED:
            relation, key = LISTED[table, column]
            widget = QgsEditorWidgetSetup('ValueRelation', {'Layer': vectors[relation].id(), 'LayerName': relation, 'LayerSource': vectors[relation].source(),
                                                            'LayerProviderName': 'postgres', 'Key': key, 'Value': key, 'AllowNull': True, 'OrderByValue': True})
        elif column in ('source_geom', 'source_hash'):
            widget = QgsEditorWidgetSetup('Hidden', {})
        else:
            continue
        vector.setEditorWidgetSetup(index, widget)
    vector.setEditFormConfig(config)
    if table == 'axis' and vector.fields().indexFromName('source_ref') >= 0:
        # QGIS copies what is unique to neither piece of a split where it knows of it, and of two columns together it does not.
        vector.setFieldConstraint(vector.fields().indexFromName('source_ref'), QgsFieldConstraints.ConstraintUnique, QgsFieldConstraints.ConstraintStrengthSoft)
