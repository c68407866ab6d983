"""Made of the template by scripts/made_ahead.py, by the checksums of their files; not to be edited."""

# mypy: ignore-errors
from kurbel.formats.filling import LoopContext, Macro, Markup, Undefined, identity, missing, str_join


def root(context, environment):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_typst = resolve('typst')
    l_0_page = resolve('page')
    l_0_cell = l_0_head_cell = l_0_filled = l_0_row = l_0_head = l_0_body = l_0_spaces = l_0_places = missing
    t_1 = environment.filters['dictsort']
    t_2 = environment.filters['format']
    t_3 = environment.filters['join']
    t_4 = environment.filters['length']
    t_5 = environment.filters['list']
    t_6 = environment.filters['rejectattr']
    t_7 = environment.filters['trim']
    pass
    def macro(l_1_cell, l_1_align, l_1_name):
        t_8 = []
        if l_1_cell is missing:
            l_1_cell = undefined("parameter 'cell' was not provided", name='cell')
        if l_1_align is missing:
            l_1_align = undefined("parameter 'align' was not provided", name='align')
        if l_1_name is missing:
            l_1_name = undefined("parameter 'name' was not provided", name='name')
        pass
        t_8.extend((
            str(('table.cell(align: center)' if ((environment.getattr(l_1_cell, 'kind') == 'missing') and (l_1_align == 'right')) else cond_expr_undefined("the inline if-expression on line 2 in 'base/typst.jinja' evaluated to false and no else section was defined."))),
            str(('name' if (((l_1_name and environment.getattr(l_1_cell, 'down')) and environment.getattr(l_1_cell, 'text')) and (environment.getattr(l_1_cell, 'kind') != 'missing')) else cond_expr_undefined("the inline if-expression on line 2 in 'base/typst.jinja' evaluated to false and no else section was defined."))),
            '[',
        ))
        if environment.getattr(l_1_cell, 'down'):
            pass
            t_8.append(
                str(environment.getattr(l_1_cell, 'text')),
            )
            if environment.getattr(l_1_cell, 'tail'):
                pass
                t_8.extend((
                    '#hide[',
                    str(environment.getattr(l_1_cell, 'tail')),
                    '];',
                ))
            if (environment.getattr(l_1_cell, 'marks') and (l_1_align == 'right')):
                pass
                t_8.extend((
                    '#beside[',
                    str(environment.getattr(l_1_cell, 'marks')),
                    '];',
                ))
            else:
                pass
                t_8.append(
                    str(environment.getattr(l_1_cell, 'marks')),
                )
        t_8.append(
            '], ',
        )
        return concat(t_8)
    context.exported_vars.add('cell')
    context.vars['cell'] = l_0_cell = Macro(environment, macro, 'cell', ('cell', 'align', 'name'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_cell, l_1_panel, l_1_stacked):
        t_9 = []
        l_1_places = l_0_places
        l_1_left = missing
        if l_1_cell is missing:
            l_1_cell = undefined("parameter 'cell' was not provided", name='cell')
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        if l_1_stacked is missing:
            l_1_stacked = undefined("parameter 'stacked' was not provided", name='stacked')
        pass
        l_1_left = ((environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), environment.getattr(l_1_cell, 'first')), 'align') == 'left') and (environment.getattr(l_1_cell, 'kind') != 'spanner'))
        l_1_places = ([t_2('colspan: %s', environment.getattr(l_1_cell, 'across'))] if (environment.getattr(l_1_cell, 'across') > 1) else [])
        l_1_places = ((undefined(name='places') if l_1_places is missing else l_1_places) + ([t_2('rowspan: %s', environment.getattr(l_1_cell, 'down'))] if (environment.getattr(l_1_cell, 'down') > 1) else []))
        t_9.extend((
            'head(',
            str(t_3(((undefined(name='places') if l_1_places is missing else l_1_places) + (['align: left + bottom'] if (undefined(name='left') if l_1_left is missing else l_1_left) else [])), ', ')),
            ')[',
        ))
        if ((environment.getattr(l_1_cell, 'kind') == 'spanner') and (not l_1_stacked)):
            pass
            t_9.append(
                str(environment.getattr(l_1_cell, 'text')),
            )
        else:
            pass
            t_9.append(
                str(t_3(environment.getattr(l_1_cell, 'lines'), ' \\ ')),
            )
        t_9.append(
            '], ',
        )
        return concat(t_9)
    context.exported_vars.add('head_cell')
    context.vars['head_cell'] = l_0_head_cell = Macro(environment, macro, 'head_cell', ('cell', 'panel', 'stacked'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_cells, l_1_panel, l_1_span):
        t_10 = []
        l_1_lacking = missing
        if l_1_cells is missing:
            l_1_cells = undefined("parameter 'cells' was not provided", name='cells')
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        if l_1_span is missing:
            l_1_span = 1
        pass
        l_1_lacking = (t_4(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'columns')) - t_4(environment.getattr(l_1_panel, 'columns')))
        t_10.extend((
            '      ',
            str(t_7(l_1_cells)),
            str((t_2(' table.cell(colspan: %s%s)[],', (undefined(name='lacking') if l_1_lacking is missing else l_1_lacking), (t_2(', rowspan: %s, breakable: false', l_1_span) if (l_1_span > 1) else '')) if ((undefined(name='lacking') if l_1_lacking is missing else l_1_lacking) and l_1_span) else cond_expr_undefined("the inline if-expression on line 20 in 'base/typst.jinja' evaluated to false and no else section was defined."))),
        ))
        return concat(t_10)
    context.exported_vars.add('filled')
    context.vars['filled'] = l_0_filled = Macro(environment, macro, 'filled', ('cells', 'panel', 'span'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_cells, l_1_panel):
        t_11 = []
        if l_1_cells is missing:
            l_1_cells = undefined("parameter 'cells' was not provided", name='cells')
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        pass
        l_2_loop = missing
        for l_2_one, l_2_loop in LoopContext(l_1_cells, undefined):
            _loop_vars = {}
            pass
            t_11.append(
                str(context.call((undefined(name='cell') if l_0_cell is missing else l_0_cell), l_2_one, environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), environment.getattr(l_2_loop, 'index0')), 'align'), (environment.getattr(l_2_loop, 'index0') < environment.getattr(l_1_panel, 'stubs')), _loop_vars=_loop_vars)),
            )
        l_2_loop = l_2_one = missing
        return concat(t_11)
    context.exported_vars.add('row')
    context.vars['row'] = l_0_row = Macro(environment, macro, 'row', ('cells', 'panel'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_panel, l_1_number):
        t_12 = []
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        if l_1_number is missing:
            l_1_number = undefined("parameter 'number' was not provided", name='number')
        pass
        t_12.append(
            '      table.header(\n',
        )
        if l_1_number:
            pass
            t_12.append(
                '      across(inset: (x: 0pt, top: 1.5em), goes-on),\n',
            )
        else:
            pass
            t_12.append(
                '      ..again,\n',
            )
        t_12.append(
            '      table.hline(stroke: heavy),\n',
        )
        for l_2_cells in environment.getattr(l_1_panel, 'head'):
            l_2_line = missing
            _loop_vars = {}
            pass
            t_13 = []
            pass
            for l_4_one in l_2_cells:
                _loop_vars = {}
                pass
                t_13.append(
                    str(context.call((undefined(name='head_cell') if l_0_head_cell is missing else l_0_head_cell), l_4_one, l_1_panel, ((l_1_number, environment.getattr(l_4_one, 'level'), environment.getattr(l_4_one, 'first')) in environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'stacked')), _loop_vars=_loop_vars)),
                )
            l_4_one = missing
            l_2_line = (Markup if context.eval_ctx.autoescape else identity)(concat(t_13))
            _loop_vars['line'] = l_2_line
            t_12.extend((
                str(context.call((undefined(name='filled') if l_0_filled is missing else l_0_filled), (undefined(name='line') if l_2_line is missing else l_2_line), l_1_panel, _loop_vars=_loop_vars)),
                '\n',
            ))
            def t_14(fiter):
                for l_3_cell in fiter:
                    if ((environment.getattr(l_3_cell, 'kind') == 'spanner') and environment.getattr(l_3_cell, 'text')):
                        yield l_3_cell
            for l_3_cell in t_14(l_2_cells):
                _loop_vars = {}
                pass
                t_12.extend((
                    '      table.hline(start: ',
                    str(environment.getattr(l_3_cell, 'first')),
                    ', end: ',
                    str((environment.getattr(l_3_cell, 'last') + 1)),
                    ', stroke: light),\n',
                ))
            l_3_cell = missing
        l_2_cells = l_2_line = missing
        t_12.append(
            '      table.hline(stroke: middle),\n      ),\n',
        )
        return concat(t_12)
    context.exported_vars.add('head')
    context.vars['head'] = l_0_head = Macro(environment, macro, 'head', ('panel', 'number'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_panel):
        t_15 = []
        l_1_labelled = missing
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        pass
        l_1_labelled = (t_5(t_6(environment.getattr(l_1_panel, 'groups'), 'label')) == [])
        for l_2_group in environment.getattr(l_1_panel, 'groups'):
            _loop_vars = {}
            pass
            if environment.getattr(l_2_group, 'label'):
                pass
                t_15.extend((
                    '      table.header(level: 2, repeat: ',
                    str(('true' if (undefined(name='labelled') if l_1_labelled is missing else l_1_labelled) else 'false')),
                    ', across(inset: (x: 0pt, top: .9em, bottom: .4em))[',
                    str(environment.getattr(l_2_group, 'label')),
                    ']),\n',
                ))
            for (l_3_cells, l_3_span) in environment.getattr(l_2_group, 'spanned_rows'):
                _loop_vars = {}
                pass
                t_15.extend((
                    str(context.call((undefined(name='filled') if l_0_filled is missing else l_0_filled), context.call((undefined(name='row') if l_0_row is missing else l_0_row), l_3_cells, l_1_panel, _loop_vars=_loop_vars), l_1_panel, l_3_span, _loop_vars=_loop_vars)),
                    '\n',
                ))
            l_3_cells = l_3_span = missing
        l_2_group = missing
        return concat(t_15)
    context.exported_vars.add('body')
    context.vars['body'] = l_0_body = Macro(environment, macro, 'body', ('panel',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_rows):
        t_16 = []
        if l_1_rows is missing:
            l_1_rows = undefined("parameter 'rows' was not provided", name='rows')
        pass
        t_16.append(
            '(',
        )
        for (l_2_row, l_2_space) in t_1(l_1_rows):
            _loop_vars = {}
            pass
            t_16.extend((
                '"',
                str(l_2_row),
                '": ',
                str(l_2_space),
                'em, ',
            ))
        l_2_row = l_2_space = missing
        t_16.extend((
            str((':' if (not l_1_rows) else cond_expr_undefined("the inline if-expression on line 55 in 'base/typst.jinja' evaluated to false and no else section was defined."))),
            ')',
        ))
        return concat(t_16)
    context.exported_vars.add('spaces')
    context.vars['spaces'] = l_0_spaces = Macro(environment, macro, 'spaces', ('rows',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_numbers):
        t_17 = []
        if l_1_numbers is missing:
            l_1_numbers = undefined("parameter 'numbers' was not provided", name='numbers')
        pass
        t_17.extend((
            '(',
            str(t_3(l_1_numbers, ', ')),
            str((',' if (t_4(l_1_numbers) == 1) else cond_expr_undefined("the inline if-expression on line 58 in 'base/typst.jinja' evaluated to false and no else section was defined."))),
            ')',
        ))
        return concat(t_17)
    context.exported_vars.add('places')
    context.vars['places'] = l_0_places = Macro(environment, macro, 'places', ('numbers',), False, False, False, context.eval_ctx.autoescape)
    yield '// For #include; sets nothing outside itself. At most '
    yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'width'))
    yield 'em wide, with narrow gaps '
    yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'narrow'))
    yield 'em.\n#[\n#set super(typographic: false, size: .7em)\n#show figure: set block(breakable: true)\n#show figure.caption: set block(sticky: true)\n#let ours(body) = {\n  set text(lang: "'
    yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'lang'))
    yield '", number-type: "lining", number-width: "tabular")\n  set par(leading: .5em, justify: false)\n  body\n}\n#let (heavy, middle, light) = (.08em, .05em, .03em)\n#let sides = '
    yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'sides')))
    yield '\n#let head(first: none, ..places) = {\n  let side = if first == none { (x: 0pt) } else { sides.at(first) }\n  table.cell(align: center + bottom, ..places.named(), inset: (..side, y: .35em), ..places.pos())\n}\n#let across = table.cell.with(colspan: '
    yield str(t_4(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'columns')))
    yield ', align: left)\n// The label of a row: a dotted line without thickness, which is not drawn, tells kurbel\'s PDF so.\n#let name = table.cell.with(stroke: (left: (paint: black, thickness: 0pt, dash: "dotted")))\n// A mark hangs beside its figure, so that the figures stay in line.\n#let beside(mark) = box(width: 0pt, align(left, box(width: 9em, mark)))\n#let (gaps, margins) = ('
    yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'gaps')))
    yield ', '
    yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'margins')))
    yield ')\n#let (above, below) = ('
    yield str(context.call((undefined(name='spaces') if l_0_spaces is missing else l_0_spaces), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'above')))
    yield ', '
    yield str(context.call((undefined(name='spaces') if l_0_spaces is missing else l_0_spaces), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'below')))
    yield ')\n#let space(x, y) = (\n  ..margins.at(x), top: above.at(str(y), default: .27em), bottom: below.at(str(y), default: .27em),\n)\n#let sheet(share, first, ..rows) = ours(table(\n  columns: '
    yield str(t_4(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'columns')))
    yield ',\n  align: '
    yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'columns')))
    yield '.map(side => side + horizon),\n  column-gutter: gaps.map(gap => gap * share), stroke: none, inset: (x, y) => space(x, y - first),\n  ..rows,\n))\n// The heads and the widest cells are measured alone, for measuring all costs more than setting it.\n#let wide(share) = {\n  let (again, goes-on) = ((), none)\n  measure(sheet(share, 0,\n'
    l_1_loop = missing
    for l_1_panel, l_1_loop in LoopContext(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'), undefined):
        _loop_vars = {}
        pass
        yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, environment.getattr(l_1_loop, 'index0'), _loop_vars=_loop_vars))
        for l_2_cells in environment.getitem(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'widest'), environment.getattr(l_1_loop, 'index0')):
            _loop_vars = {}
            pass
            yield str(context.call((undefined(name='filled') if l_0_filled is missing else l_0_filled), context.call((undefined(name='row') if l_0_row is missing else l_0_row), l_2_cells, l_1_panel, _loop_vars=_loop_vars), l_1_panel, _loop_vars=_loop_vars))
            yield '\n'
        l_2_cells = missing
    l_1_loop = l_1_panel = missing
    yield '  )).width\n}\n'
    if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption'):
        pass
        yield '// The lines of a caption are of like length, none is longer than the table.\n#show figure.caption: it => layout(line => {\n'
        if environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'long_caption'):
            pass
            yield '  show math.equation: it => if measure(it).width <= .85 * line.width { box(it) } else { it }\n'
        else:
            pass
            yield '  show math.equation: box\n'
        yield '  let (alone, least, most) = (measure(it).width, 24em.to-absolute(), .85 * line.width)\n  if alone <= least { return it }\n  let widest = calc.max(calc.min(.97 * '
        yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'width'))
        yield 'em.to-absolute(), most), least)\n  if alone <= widest { return it }\n  let height(width) = measure(block(width: width, it)).height\n  let (even, tallest) = (alone / calc.ceil(alone / widest), height(widest) + 4pt)\n  let fits(width) = width < widest and height(width) <= tallest\n  let found = (1.04, 1.1, 1.2).map(more => even * more).find(fits)\n  align(center, block(width: if found == none { widest } else { found }, it))\n})\n'
    yield '#figure(\n  kind: table,\n  gap: .8em,\n'
    if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption'):
        pass
        yield '  caption: figure.caption(position: top, text(lang: "'
        yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'lang'))
        yield '")['
        yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption'))
        yield ']),\n'
    yield '  layout(line => {\n'
    if (environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes') or environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source')):
        pass
        yield '    let natural = wide(1)\n'
    else:
        pass
        yield '    let most = '
        yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'width'))
        yield 'em.to-absolute()\n    let natural = if most <= line.width { most } else { wide(1) }\n'
    yield '    let room = if float.is-infinite(line.width.pt()) { natural } else { line.width }\n    // Where the line is too short the gaps shrink first, then the type.\n    let between = gaps.sum(default: 0em).to-absolute()\n    let share = if natural <= room { 1 } else { calc.max('
    yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'least'))
    yield ', 1 - (natural - room) / between) }\n    let scale = if natural <= room { 1 } else { calc.min(1, room / wide(share)) }\n'
    if (environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes') or environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source')):
        pass
        yield '    let small = calc.min(.85, scale) * 1em\n    let notes = (\n'
        for l_1_note in environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
            _loop_vars = {}
            pass
            yield '      ['
            yield str((str_join((environment.getattr(l_1_note, 'mark'), '~', )) if environment.getattr(l_1_note, 'mark') else cond_expr_undefined("the inline if-expression on line 145 in 'base/typst.jinja' evaluated to false and no else section was defined.")))
            yield str(environment.getattr(l_1_note, 'text'))
            yield '],\n'
        l_1_note = missing
        if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'):
            pass
            yield '      ['
            yield str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'source'))
            yield ': '
            yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'))
            yield '],\n'
        yield '    )\n    // No formula breaks that fits the line: the notes are as wide as the widest.\n'
        if environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'long'):
            pass
            yield '    let formulas(it) = if it.func() == math.equation { (it,) } else { it.at("children", default: ()).map(formulas).flatten() }\n    let length(it) = measure(ours(text(size: small, it))).width\n    let lengths = '
            yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'long')))
            yield '.map(place => formulas(notes.at(place))).flatten().map(length)\n    let breadth = calc.min(calc.max(natural, 24em.to-absolute(), ..lengths.filter(one => one <= room)), room)\n'
        else:
            pass
            yield '    let breadth = calc.min(calc.max(natural, 24em.to-absolute()), room)\n'
        yield '    let legend = block(width: breadth, above: .8em, ours({\n      set align(left)\n      set text(size: small)\n      set block(spacing: .55em)\n      set par(hanging-indent: 1em)\n'
        if environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'long'):
            pass
            yield '      show math.equation: it => if measure(it).width <= breadth { box(it) } else { it }\n'
        else:
            pass
            yield '      show math.equation: box\n'
        yield '      for note in notes { block(note) }\n    }))\n'
    else:
        pass
        yield '    let legend = []\n'
    yield '    let panels(again, goes-on) = {\n      set text(size: scale * 1em)\n      sheet(share, again.len(),\n'
    l_1_loop = missing
    for l_1_panel, l_1_loop in LoopContext(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'), undefined):
        _loop_vars = {}
        pass
        yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, environment.getattr(l_1_loop, 'index0'), _loop_vars=_loop_vars))
        yield str(context.call((undefined(name='body') if l_0_body is missing else l_0_body), l_1_panel, _loop_vars=_loop_vars))
        if environment.getattr(l_1_loop, 'last'):
            pass
            yield '      table.footer(table.hline(stroke: heavy)),\n'
        else:
            pass
            yield '      table.hline(stroke: heavy),\n'
    l_1_loop = l_1_panel = missing
    yield '      )\n    }\n    // Only a table longer than a page breaks; from the second page on its head says which table goes on.\n    let (low, high) = '
    yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'rows')))
    yield '.map(one => one * scale * 1em.to-absolute())\n    let (least, most) = '
    yield str(context.call((undefined(name='places') if l_0_places is missing else l_0_places), environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'notes')))
    yield '.map(one => one * 1em.to-absolute())\n    let tall = if low + least > line.height or high + most < line.height { most } else { measure(legend).height + 1em.to-absolute() }\n    let whole = panels((), none) + legend\n    if high + tall < line.height or low + tall < line.height and measure(whole, width: room).height < line.height {\n      block(breakable: false, whole)\n    } else {\n      let start = here().page()\n      let goes-on = context if here().page() > start {\n        let number = ['
    yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'table'))
    yield '~#counter(figure.where(kind: table)).display()]\n        pad(bottom: .5em)[#[#number <kurbel-number>] ('
    yield str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'continued'))
    yield ')]\n      }\n      panels((across(inset: 0pt, goes-on),), goes-on) + legend\n    }\n  }),\n) #label('
    yield str(environment.getattr((undefined(name='typst') if l_0_typst is missing else l_0_typst), 'label'))
    yield ')]\n'


TEMPLATES = {3399593310: root}
