"""How a model looks: the rules of a theme at every scale, of table streetgen.symbol_rule and of the model's own."""
import dataclasses
import typing

from database import literal


@dataclasses.dataclass(frozen=True)
class Symbol:
    """A rule as it holds from one scale to another; others: the kinds that have rules of their own there."""
    layer: str
    kind: str
    place: float
    fill: typing.Optional[str] = None
    line: typing.Optional[str] = None
    width: typing.Optional[float] = None
    unit: typing.Optional[str] = None
    dash: typing.Optional[str] = None
    marker: typing.Optional[str] = None
    meaning: typing.Optional[str] = None
    others: tuple = ()
    from_scale: float = 0
    to_scale: typing.Optional[float] = None

    @property
    def label(self):
        return self.meaning or ' '.join(filter(None, (self.layer, self.kind))).replace('_', ' ')

    def holds_of(self, kind):
        """The expression of QGIS that says which features it draws, by the expression of their kind."""
        if self.kind:
            return f'{kind} = {literal(self.kind)}'
        return '%s NOT IN (%s)' % (kind, ', '.join(map(literal, self.others))) if self.others else ''


class Look:
    def __init__(self, database, model, theme):
        """The rules hold between any two scales at which one begins or ends; those that go on are one."""
        last, self.symbols = {}, []
        spans = {}
        for from_scale, to_scale, *rule in database.symbols(model, theme):
            spans.setdefault((from_scale, to_scale), []).append(Symbol(*rule))
        for (from_scale, to_scale), symbols in spans.items():
            for symbol in symbols:
                others = () if symbol.kind else tuple(sorted({other.kind for other in symbols if other.layer == symbol.layer and other.kind}))
                symbol = dataclasses.replace(symbol, others=others)
                goes_on = last.get(symbol)
                if goes_on is not None and self.symbols[goes_on].to_scale == from_scale:
                    self.symbols[goes_on] = dataclasses.replace(self.symbols[goes_on], to_scale=to_scale)
                else:
                    last[symbol] = len(self.symbols)
                    self.symbols.append(dataclasses.replace(symbol, from_scale=from_scale, to_scale=to_scale))

    def of(self, *layers):
        return [symbol for symbol in self.symbols if symbol.layer in layers]

    def one(self, layer, kind=''):
        """The symbol of a kind where one looks from near; without a colour where the model hides it."""
        for wanted in (kind, ''):
            for symbol in self.symbols:
                if (symbol.layer, symbol.kind) == (layer, wanted):
                    return symbol
        return Symbol(layer, kind, 0)

    def handle(self, kind=''):
        """What one drags, types in or looks through."""
        return self.one('handle', kind)

    def knob(self, kind=''):
        """The same as a point, with a rim like paper."""
        return dataclasses.replace(self.handle(kind), line=self.one('paper').fill)
