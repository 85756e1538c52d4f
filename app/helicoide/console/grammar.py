"""The grammar of a line, and its parser.

From weak to strong: `+ -`, then `>>`, then `* /`, then `^ | &`, then a sign or `~` in front, then `**`. `A >> B >> X`
moves X by B, then by A. One syntax serves both languages: numbers have a decimal point, arguments a comma between.
"""

from __future__ import annotations

from functools import cache, lru_cache
from typing import Any

from lark import Lark, Token, Transformer, UnexpectedCharacters, UnexpectedInput, UnexpectedToken, v_args

from helicoide.console.errors import ExpressionError
from helicoide.console.syntax import (
    Expression,
    FunctionCall,
    Literal,
    Operation,
    ParsedLine,
    Reference,
    Span,
    depth_over,
)
from helicoide.sheet import LONGEST_LINE, too_long_text
from helicoide.text import Text, join_texts, untranslated

GRAMMAR = r"""
start: [statement]
?statement: NAME "=" sum         -> definition
          | sum                  -> result
?sum: sandwich
    | sum (PLUS | MINUS) sandwich          -> binary
?sandwich: product
         | product SANDWICH sandwich       -> binary
?product: blend
        | product (TIMES | OVER) blend     -> binary
?blend: signed
      | blend (OUTER | INNER | REGRESSIVE) signed -> binary
?signed: power
       | (MINUS | REVERSE) signed          -> unary
?power: atom
      | atom POWER signed                  -> binary
?atom: NUMBER                    -> literal
     | NAME                      -> reference
     | NAME "(" [sum ("," sum)*] ")" -> call
     | "(" sum ")"

NUMBER: /(\d+(\.\d*)?|\.\d+)([eE][+-]\d+)?/
NAME: /[A-Za-z][A-Za-z0-9_]*/
PLUS: "+"
MINUS: "-"
TIMES: "*"
OVER: "/"
POWER: "**"
OUTER: "^"
INNER: "|"
REGRESSIVE: "&"
SANDWICH: ">>"
REVERSE: "~"
%ignore /[ \t]+/
%ignore /#.*/
"""

UNKNOWN = Text(
    en="the character “{character}” has no meaning here{hint}; valid are letters, digits and + - * / ^ | & >> ~ ** ( ) "
    ", = #",
    pt_BR="o caractere “{character}” não tem sentido aqui{hint}; valem letras, algarismos e + - * / ^ | & >> ~ ** ( ) "
    ", = #",
)
TYPE = Text(en=": type {plain}", pt_BR=": digite {plain}")
UNEXPECTED = Text(en="“{found}” cannot stand here; valid is {valid}", pt_BR="“{found}” não cabe aqui; vale {valid}")
ENDS = Text(en="the line ends too early; valid is {valid}", pt_BR="a linha acaba cedo demais; vale {valid}")
VALUE = Text(en="a number, a name or (", pt_BR="um número, um nome ou (")
OPERATOR = Text(
    en="an operator, as in 2*e12 (2e+12 is a power of ten)",
    pt_BR="um operador, como em 2*e12 (2e+12 é potência de dez)",
)
# What people type, or paste from a text, for characters of the language.
PLAIN = {
    "−": "-", "–": "-", "·": "*", "×": "*", "⋅": "*", "÷": "/", "∧": "^", "∨": "&", "⌋": "|", "⁎": "*", "π": "pi",
    "θ": "theta", "²": "**2", "³": "**3", ";": ",", "[": "(", "]": ")", "{": "(", "}": ")", "√": "sqrt", "≫": ">>",
}  # fmt: skip


@lru_cache(maxsize=256)
def parse_line(text: str) -> ParsedLine | None:
    """The parts of a line; None if it holds a comment at most. Raises ExpressionError."""
    if len(text) > LONGEST_LINE:
        raise ExpressionError(too_long_text(), LONGEST_LINE, LONGEST_LINE)
    statement: Any = _parser().parse(text, on_error=_refuse)  # the transformer has made it of the tree
    return statement if isinstance(statement, ParsedLine) else None


@cache
def _parser() -> Lark:
    return Lark(GRAMMAR, parser="lalr", lexer="contextual", transformer=_Build())


@v_args(inline=True)
class _Build(Transformer[Token, ParsedLine | None]):
    """Makes the parts of a line from the rules of the grammar, from the inside to the outside."""

    def start(self, statement: ParsedLine | None = None) -> ParsedLine | None:
        return statement

    def definition(self, name: Token, expression: Expression) -> ParsedLine:
        return ParsedLine(self.reference(name), expression)

    def result(self, expression: Expression) -> ParsedLine:
        return ParsedLine(None, expression)

    def literal(self, number: Token) -> Literal:
        return Literal(float(number), _place(number))

    def reference(self, name: Token) -> Reference:
        return Reference(str(name), _place(name))

    def unary(self, operator: Token, operand: Expression) -> Operation:
        place = _place(operator)
        return Operation(str(operator), (operand,), place, depth_over((operand,), place))

    def binary(self, left: Expression, operator: Token, right: Expression) -> Operation:
        place = _place(operator)
        return Operation(str(operator), (left, right), place, depth_over((left, right), place))

    def call(self, name: Token, *arguments: Expression | None) -> FunctionCall:
        given = tuple(argument for argument in arguments if argument is not None)
        return FunctionCall(str(name), given, _place(name), depth_over(given, _place(name)))


def _place(token: Token) -> Span:
    start = token.start_pos or 0
    return Span(start, start + len(token))


def _refuse(failure: UnexpectedInput) -> bool:
    """Raise the ExpressionError of what the parser could not read."""
    start = failure.pos_in_stream or 0
    if isinstance(failure, UnexpectedCharacters):
        plain = PLAIN.get(failure.char)
        hint = TYPE.format(plain=plain) if plain else untranslated("")
        raise ExpressionError(UNKNOWN.format(character=failure.char, hint=hint), start, start + 1)
    valid = _valid(failure)
    if isinstance(failure, UnexpectedToken) and failure.token.type != "$END":
        found = str(failure.token)
        raise ExpressionError(UNEXPECTED.format(found=found, valid=valid), start, start + len(found))
    end = _end(failure)
    raise ExpressionError(ENDS.format(valid=valid), end, end + 1)


def _valid(failure: UnexpectedInput) -> Text:
    """What could stand where the parser stopped."""
    accepted = failure.accepts if isinstance(failure, UnexpectedToken) else set()
    if "NUMBER" in accepted:
        return VALUE
    closing = [sign for terminal, sign in (("RPAR", "“)”"), ("COMMA", "“,”")) if terminal in accepted]
    return join_texts([*map(untranslated, closing), OPERATOR], by=", ")


def _end(failure: UnexpectedInput) -> int:
    """The character behind the last token of a line that ends too early."""
    last = failure.token if isinstance(failure, UnexpectedToken) else None
    return (last.end_pos or 0) if last is not None else 0
