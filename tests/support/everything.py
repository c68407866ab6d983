"""A small table with every part a table can have."""

from __future__ import annotations

from kurbel.exact.numerals import Number
from kurbel.page.table import DITTO, Cell, Column, Field, Group, Note, Panel, Records, Row, Table

AWKWARD = r"50 % & \$, a|b, #_{}~^\, <script>alert(1)</script>, [x] *y* `z` -- ,, " + '"q"'
"""Prose with the special characters of every format, as a label."""
AWKWARD_TEXT = AWKWARD.replace(r"\$", "$")


def n(scaled: int, decimals: int = 3) -> Cell:
    return Cell(Number(scaled, decimals))


def everything(key: str = "everything", lang: str = "de", caption: str = "") -> Table:
    stub = (Column("ratio", ("$R:L$",)), Column("phi", ("$φ$", "Grad")))
    paths = (
        Column("x", ("Hingang", "$x/R$"), ("Genaue Werte[^a]", "Kolbenweg")),
        Column("x_return", ("Rückgang", "$x/R$"), ("Genaue Werte[^a]", "Kolbenweg")),
        Column("c", ("$c/v$",), ("Genaue Werte[^a]", "Geschwindigkeit")),
        Column("psi", ("Ausschlag", "$ψ$"), ("Genaue Werte[^a]",)),
        Column("remark", ("Formel",)),
    )
    forces = (Column("t", ("0", "360")), Column("u", ("10", "350")))
    formula = Cell("$(sin(φ±ψ))/(cos ψ)$")
    first = Group(
        (
            Row((Cell("$1:5$"), n(0, 0)), (n(0), n(0), n(0), Cell("0°0'"), Cell("$1 - cos φ$"))),
            Row(
                (Cell(DITTO), n(60, 0)),
                (n(576), n(424, 3), Cell(Number(-954, 3), ("b",)), Cell("9°58'"), formula),
            ),
            Row((Cell(DITTO), n(180, 0)), (n(2, 0), Cell(None), n(-12500), Cell(None, ("b",)), Cell(""))),
        ),
        r"Erste Gruppe, $λ = 1/5$ & 100 %",
    )
    second = Group(
        (
            Row((Cell("$1:4.5$"), n(60, 0)), (n(584), n(-416), n(964), Cell("11°6'"), Cell("a|b_c"))),
            Row((Cell(DITTO), n(90, 0)), (n(1113), n(888), n(1000), Cell("12°50'"), Cell(None))),
        ),
        "Zweite Gruppe[^b]",
    )
    below = Group(
        (
            Row((Cell("$1:5$"), n(60, 0)), (n(1200), n(1173))),
            Row((Cell(DITTO), n(90, 0)), (n(-14), Cell(None))),
        )
    )
    return Table(
        key,
        lang,
        caption or f"Jeder Teil einer Tafel: {AWKWARD}",
        (Panel(stub, paths, (first, second)), Panel(stub, forces, (below,))),
        Records(
            (
                Field("ratio", "Kurbelverhältnis", "$R:L$"),
                Field("phi", "Kurbelwinkel", "$φ$", "°", 0),
                Field("x", "Kolbenweg", "$x/R$", "", 3),
                Field("remark", "Bemerkung"),
            ),
            (
                ("1:5", Number(60, 0), Number(500, 3), 'sagt "a;b", c'),
                ("1:4,5", Number(-90, 0), Number(-5, 3), None),
                ("1:4", Number(0, 0), None, ""),
            ),
        ),
        (
            Note("Das obere Zeichen gilt für den Hingang, das untere für den Rückgang."),
            Note(r"Auf $v = 2.5 \"m/s\"$ bezogen; $x_m$, $x_(max)$.".replace("\\", ""), "a"),
            Note("Nach Gl. (285), 50 % & mehr.", "b"),
        ),
        "F. Rötscher, Die Maschinenelemente, § 14",
    )


def wide(decimals: int) -> Table:
    """Twelve columns of figures, each of them with its sign."""
    columns = tuple(
        Column(str(place), ("Kopf", f"$x_{place % 10}$"), (f"Gruppe {place // 4}",)) for place in range(12)
    )
    rows = tuple(
        Row(
            (Cell(Number(10 * line, 0)),),
            tuple(Cell(Number(-(10**decimals) - 7 * line - place, decimals)) for place in range(12)),
        )
        for line in range(4)
    )
    panel = Panel((Column("phi", ("$φ$",)),), columns, (Group(rows),))
    return Table("wide", "de", "Breit", (panel,), Records((), ()))


def tall(rows: int = 90) -> Table:
    body = tuple(Row((Cell(Number(line, 0)),), (Cell(Number(line, 3)),)) for line in range(rows))
    panel = Panel((Column("phi", ("$φ$",)),), (Column("x", ("$x/R$",)),), (Group(body, "Gruppe"),))
    return Table("tall", "en", "Tall", (panel, panel), Records((), ()), source="Nowhere")
