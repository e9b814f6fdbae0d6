"""The database of a model, by the connection that its layers are stored with."""
import re

from qgis.core import NULL, QgsDataSourceUri, QgsException, QgsProviderRegistry, QgsWkbTypes


class Refused(Exception):
    """What a user can put right, in a line or two."""


def identifier(name):
    return '"%s"' % name.replace('"', '""')


def literal(value):
    return "'%s'" % value.replace("'", "''")


def of_model(query, model):
    """A query of a model: @ stands for its schema, @name for its name as a value, and @@ for the letter."""
    return re.sub('@@|@name|@', lambda place: {'@@': '@', '@name': literal(model)}.get(place[0], identifier(model)), query)


class Database:
    def __init__(self, connection):
        self.uri = QgsDataSourceUri(connection)
        if self.uri.username() or self.uri.password():
            raise Refused('the connection holds a user or a password, which would be stored: leave them to PGUSER, PGPASSWORD and ~/.pgpass')
        self.connection = QgsProviderRegistry.instance().providerMetadata('postgres').createConnection(self.uri.uri(False), {})

    def ask(self, sql):
        try:
            return [[None if value == NULL else value for value in row] for row in self.connection.executeSql(sql)]
        except QgsException as failed:
            # Message and hint, of the statement and the server's answer.
            answer = re.search(r'ERROR:\s*(.*?)\s*(CONTEXT:|LINE \d+:|\]$)', str(failed), re.DOTALL)
            raise Refused(answer[1] if answer else str(failed)) from failed

    def srid(self, model):
        self.ask(f'SELECT count(*) FROM streetgen.setting({literal(model)})')  # An unknown model is an error.
        return self.ask(f'SELECT srid FROM streetgen.model WHERE name = {literal(model)}')[0][0]

    def relations(self, model):
        """The names of the tables and views of a model."""
        return {name for name, in self.ask(f'SELECT relname FROM pg_class WHERE relnamespace = {literal(identifier(model))}::regnamespace')}

    def extent(self, model):
        """The corners of all axes and 10 m about them, or None."""
        corners = self.ask(f'SELECT ST_XMin(box), ST_YMin(box), ST_XMax(box), ST_YMax(box) FROM streetgen._model_extent({literal(model)}) box')[0]
        return corners if corners[0] is not None else None

    def run_seconds(self, model):
        """How long the longest run is that a model kept, or None."""
        return self.ask(f'SELECT max(t) FROM {identifier(model)}.simulated')[0][0]

    def attribution(self, model):
        """Whose data the model shows, where a setting says so."""
        return ''.join(value or '' for value, in self.ask(f"SELECT value FROM streetgen.setting({literal(model)}) WHERE name = 'attribution'"))

    def levels(self, model):
        """The levels that the map tells apart: those that there are, and two to spare."""
        least, most = self.ask(f'SELECT least(-1, min(level) - 1), greatest(2, max(level) + 1) FROM {identifier(model)}.axis')[0]
        return range(max(least, -10), min(most, 10) + 1)

    def buildings(self, model):
        """What the layer of buildings reads, where a setting names a table that one may read and pictures show: a row or none."""
        rows = self.ask(f'''
            SELECT n.nspname, c.relname, p.name, nullif(p.srid, 0), (
                SELECT attname FROM pg_index JOIN pg_attribute ON attrelid = indrelid AND attnum = indkey[0] WHERE indrelid = c.oid AND indisprimary AND indnkeyatts = 1)
            FROM streetgen._building_table({literal(model)}) relation JOIN pg_class c ON c.oid = relation JOIN pg_namespace n ON n.oid = relnamespace,
                streetgen._polygon_column(relation) p''')
        for schema, table, column, srid, key in rows:
            # Rows without a key are numbered as they come.
            keyed = (f'{identifier(key)}, ', key) if key else ('row_number() OVER () AS building_id, ', 'building_id')
            query = f'SELECT {keyed[0]}{identifier(column)} FROM {identifier(schema)}.{identifier(table)}'
            yield query.replace('@', '@@'), keyed[1], column, 'MultiPolygon', srid

    def symbols(self, model, theme):
        """The rules of a theme, from scale to scale."""
        return self.ask(f'''
            WITH rule AS (SELECT theme, from_scale, to_scale FROM streetgen.symbol_rule UNION ALL SELECT theme, from_scale, to_scale FROM {identifier(model)}.symbol_rule),
                border AS (SELECT DISTINCT scale FROM rule, unnest(ARRAY[from_scale, to_scale]) scale WHERE theme = {literal(theme)}),
                span AS (SELECT lag(scale) OVER (ORDER BY scale) AS from_scale, scale AS to_scale FROM border)
            SELECT from_scale, nullif(to_scale, 'Infinity'), layer, kind, place, fill, line, width, unit, dash, marker, meaning
            FROM span, streetgen._symbols({literal(model)}, {literal(theme)}, to_scale) WHERE from_scale IS NOT NULL ORDER BY from_scale, symbol''')

    def decisions(self, model):
        """The tables of decisions by hand that a model has, and the columns of each that one may type in."""
        rows = self.ask(f'''
            SELECT relation, attname FROM streetgen._decisions_of({literal(model)}) d JOIN streetgen.template t USING (relation)
                JOIN pg_attribute ON attrelid = format('%I.%I', {literal(model)}, relation)::regclass AND attname = ANY (t.attributes)
                JOIN pg_type y ON y.oid = atttypid
            WHERE attname <> d.key AND typname <> 'geometry' ORDER BY d.n, attnum''')
        found = {}
        for relation, column in rows:
            found[relation] = (*found.get(relation, ()), column)
        return found

    def source(self, model, srid, layer):
        """Where a layer comes from. The key is named, since a view tells none."""
        uri = QgsDataSourceUri(self.uri)
        if layer.query:
            uri.setDataSource('', '(%s)' % of_model(layer.query, model), layer.geometry, '', layer.key)
        else:
            uri.setDataSource(model, layer.relation, layer.geometry, '', layer.key)
        if layer.kind:
            uri.setWkbType(QgsWkbTypes.parseType(layer.kind))
        if layer.geometry:
            uri.setSrid(str(layer.srid or srid))
            uri.setUseEstimatedMetadata(True)
        # Keys are known, and looking through all rows for them takes long.
        uri.setParam('checkPrimaryKeyUnicity', '0')
        return uri.uri(False)

    def words(self, model):
        """The words that a column may be, by relation and column: those of its CHECK."""
        rows = self.ask(f'''
            SELECT relname, attname, word[1] FROM pg_constraint k JOIN pg_class c ON c.oid = conrelid JOIN pg_attribute ON attrelid = c.oid AND attnum = conkey[1],
                regexp_matches(pg_get_constraintdef(k.oid), '\\x27(\\w+)\\x27::text', 'g') WITH ORDINALITY m(word, number)
            WHERE relnamespace = {literal(identifier(model))}::regnamespace AND pg_get_constraintdef(k.oid) LIKE '%= ANY (ARRAY[%' ORDER BY 1, 2, number''')
        found = {}
        for relation, column, word in rows:
            found.setdefault((relation, column), []).append(word)
        return found
