"""The database of a model, by the connection that its layers are stored with."""
import re

from qgis.core import QgsDataSourceUri, QgsException, QgsProviderRegistry, QgsWkbTypes


class Refused(Exception):
    """What a user can put right, in a line or two."""


def identifier(name):
    return '"%s"' % name.replace('"', '""')


def literal(value):
    return "'%s'" % value.replace("'", "''")


class Database:
    def __init__(self, connection):
        self.uri = QgsDataSourceUri(connection)
        if self.uri.username() or self.uri.password():
            raise Refused('the connection holds a user or a password, which would be stored: leave them to PGUSER, PGPASSWORD and ~/.pgpass')
        self.connection = QgsProviderRegistry.instance().providerMetadata('postgres').createConnection(self.uri.uri(False), {})

    def ask(self, sql):
        try:
            return self.connection.executeSql(sql)
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
            uri.setDataSource('', '(%s)' % layer.query.replace('@', identifier(model)), layer.geometry, '', layer.key)
            uri.setWkbType(QgsWkbTypes.parseType(layer.kind))
        else:
            uri.setDataSource(model, layer.relation, layer.geometry, '', layer.key)
        if layer.geometry:
            uri.setSrid(str(srid))
            uri.setUseEstimatedMetadata(True)
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
