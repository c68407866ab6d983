"""Made of the template by scripts/made_ahead.py, by the checksums of their files; not to be edited."""

# mypy: ignore-errors
from kurbel.formats.filling import LoopContext, Macro, Markup, Undefined, identity, missing, str_join


def root(context, environment):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_page = resolve('page')
    l_0_spans = l_0_named = l_0_classed = l_0_name = l_0_heading = l_0_head = l_0_content = l_0_body_cell = l_0_body = missing
    t_1 = environment.filters['blank']
    t_2 = environment.filters['format']
    t_3 = environment.filters['heads']
    t_4 = environment.filters['hyphenated']
    t_5 = environment.filters['join']
    t_6 = environment.filters['length']
    t_7 = environment.filters['list']
    t_8 = environment.filters['measures']
    t_9 = environment.filters['select']
    pass
    def macro(l_1_across, l_1_down):
        t_10 = []
        if l_1_across is missing:
            l_1_across = undefined("parameter 'across' was not provided", name='across')
        if l_1_down is missing:
            l_1_down = undefined("parameter 'down' was not provided", name='down')
        pass
        t_10.extend((
            str((str_join((' colspan="', l_1_across, '"', )) if (l_1_across > 1) else cond_expr_undefined("the inline if-expression on line 2 in 'base/html.jinja' evaluated to false and no else section was defined."))),
            str((str_join((' rowspan="', l_1_down, '"', )) if (l_1_down > 1) else cond_expr_undefined("the inline if-expression on line 2 in 'base/html.jinja' evaluated to false and no else section was defined."))),
        ))
        return concat(t_10)
    context.exported_vars.add('spans')
    context.vars['spans'] = l_0_spans = Macro(environment, macro, 'spans', ('across', 'down'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_name):
        t_11 = []
        if l_1_name is missing:
            l_1_name = undefined("parameter 'name' was not provided", name='name')
        pass
        t_11.append(
            str((str_join((' id="', l_1_name, '"', )) if l_1_name else cond_expr_undefined("the inline if-expression on line 4 in 'base/html.jinja' evaluated to false and no else section was defined."))),
        )
        return concat(t_11)
    context.exported_vars.add('named')
    context.vars['named'] = l_0_named = Macro(environment, macro, 'named', ('name',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_classes):
        t_12 = []
        l_1_all = missing
        if l_1_classes is missing:
            l_1_classes = undefined("parameter 'classes' was not provided", name='classes')
        pass
        l_1_all = t_5(t_9(l_1_classes), ' ')
        t_12.append(
            str((str_join((' class="', (undefined(name='all') if l_1_all is missing else l_1_all), '"', )) if (undefined(name='all') if l_1_all is missing else l_1_all) else cond_expr_undefined("the inline if-expression on line 5 in 'base/html.jinja' evaluated to false and no else section was defined."))),
        )
        return concat(t_12)
    context.exported_vars.add('classed')
    context.vars['classed'] = l_0_classed = Macro(environment, macro, 'classed', ('classes',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_spanner):
        t_13 = []
        if l_1_spanner is missing:
            l_1_spanner = undefined("parameter 'spanner' was not provided", name='spanner')
        pass
        t_13.append(
            str(environment.getitem(environment.getattr(l_1_spanner, 'lines'), 0)),
        )
        for l_2_symbol in environment.getattr(l_1_spanner, 'lines')[1:]:
            _loop_vars = {}
            pass
            t_13.extend((
                ' <span class="kept symbol">',
                str(l_2_symbol),
                '</span>',
            ))
        l_2_symbol = missing
        return concat(t_13)
    context.exported_vars.add('name')
    context.vars['name'] = l_0_name = Macro(environment, macro, 'name', ('spanner',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_cell, l_1_sizes):
        t_14 = []
        l_1_text = missing
        if l_1_cell is missing:
            l_1_cell = undefined("parameter 'cell' was not provided", name='cell')
        if l_1_sizes is missing:
            l_1_sizes = undefined("parameter 'sizes' was not provided", name='sizes')
        pass
        l_1_text = t_4(t_5(environment.getattr(l_1_cell, 'lines'), '<br>'), environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'lang'))
        if (environment.getattr(l_1_sizes, 'alike') and (environment.getattr(l_1_cell, 'kind') == 'heading')):
            pass
            t_14.extend((
                '<span class="alike">',
                str((undefined(name='text') if l_1_text is missing else l_1_text)),
                '</span>',
            ))
        else:
            pass
            t_14.append(
                str((undefined(name='text') if l_1_text is missing else l_1_text)),
            )
        return concat(t_14)
    context.exported_vars.add('heading')
    context.vars['heading'] = l_0_heading = Macro(environment, macro, 'heading', ('cell', 'sizes'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_panel, l_1_heads, l_1_sizes):
        t_15 = []
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        if l_1_heads is missing:
            l_1_heads = undefined("parameter 'heads' was not provided", name='heads')
        if l_1_sizes is missing:
            l_1_sizes = undefined("parameter 'sizes' was not provided", name='sizes')
        pass
        t_15.append(
            '<thead>\n',
        )
        for l_2_row in environment.getattr(l_1_panel, 'head'):
            _loop_vars = {}
            pass
            t_15.append(
                '<tr>\n',
            )
            for l_3_cell in l_2_row:
                l_3_scope = resolve('scope')
                l_3_class = resolve('class')
                _loop_vars = {}
                pass
                if environment.getattr(l_3_cell, 'text'):
                    pass
                    l_3_scope = ('colgroup' if ((environment.getattr(l_3_cell, 'kind') == 'spanner') and (environment.getattr(l_3_cell, 'level') == 0)) else 'col')
                    _loop_vars['scope'] = l_3_scope
                    l_3_class = ('spanner' if (environment.getattr(l_3_cell, 'kind') == 'spanner') else ('words' if (environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), environment.getattr(l_3_cell, 'first')), 'align') == 'left') else cond_expr_undefined("the inline if-expression on line 22 in 'base/html.jinja' evaluated to false and no else section was defined.")))
                    _loop_vars['class'] = l_3_class
                    t_15.extend((
                        '<th',
                        str(context.call((undefined(name='named') if l_0_named is missing else l_0_named), context.call(environment.getattr(l_1_heads, 'name'), l_3_cell, _loop_vars=_loop_vars), _loop_vars=_loop_vars)),
                        ' scope="',
                        str((undefined(name='scope') if l_3_scope is missing else l_3_scope)),
                        '"',
                        str(str_join((context.call((undefined(name='spans') if l_0_spans is missing else l_0_spans), environment.getattr(l_3_cell, 'across'), environment.getattr(l_3_cell, 'down'), _loop_vars=_loop_vars), context.call((undefined(name='classed') if l_0_classed is missing else l_0_classed), [(undefined(name='class') if l_3_class is missing else l_3_class), ('corner' if ((environment.getattr(l_3_cell, 'kind') == 'stub') and (environment.getattr(l_3_cell, 'first') == environment.getattr(l_1_panel, 'names'))) else cond_expr_undefined("the inline if-expression on line 23 in 'base/html.jinja' evaluated to false and no else section was defined."))], _loop_vars=_loop_vars), ))),
                        ' style="',
                        str(context.call(environment.getattr(l_1_sizes, 'head'), l_3_cell, _loop_vars=_loop_vars)),
                        '">',
                        str((t_4(context.call((undefined(name='name') if l_0_name is missing else l_0_name), l_3_cell, _loop_vars=_loop_vars), environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'lang')) if (environment.getattr(l_3_cell, 'kind') == 'spanner') else context.call((undefined(name='heading') if l_0_heading is missing else l_0_heading), l_3_cell, l_1_sizes, _loop_vars=_loop_vars))),
                        '</th>\n',
                    ))
                else:
                    pass
                    t_15.extend((
                        '<td',
                        str(context.call((undefined(name='spans') if l_0_spans is missing else l_0_spans), environment.getattr(l_3_cell, 'across'), environment.getattr(l_3_cell, 'down'), _loop_vars=_loop_vars)),
                        '></td>\n',
                    ))
            l_3_cell = l_3_scope = l_3_class = missing
            t_15.append(
                '</tr>\n',
            )
        l_2_row = missing
        t_15.append(
            '</thead>\n',
        )
        return concat(t_15)
    context.exported_vars.add('head')
    context.vars['head'] = l_0_head = Macro(environment, macro, 'head', ('panel', 'heads', 'sizes'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_cell):
        t_16 = []
        if l_1_cell is missing:
            l_1_cell = undefined("parameter 'cell' was not provided", name='cell')
        pass
        if (environment.getattr(l_1_cell, 'kind') == 'missing'):
            pass
            t_16.extend((
                '<span role="img" aria-label="',
                str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'missing')),
                '">',
                str(environment.getattr(l_1_cell, 'text')),
                '</span>',
            ))
        else:
            pass
            t_16.append(
                str(environment.getattr(l_1_cell, 'text')),
            )
        if environment.getattr(l_1_cell, 'tail'):
            pass
            t_16.extend((
                '<span class="tail" aria-hidden="true">',
                str(t_1(environment.getattr(l_1_cell, 'tail'))),
                '</span>',
            ))
        t_16.append(
            str(environment.getattr(l_1_cell, 'marks')),
        )
        return concat(t_16)
    context.exported_vars.add('content')
    context.vars['content'] = l_0_content = Macro(environment, macro, 'content', ('cell',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_cell, l_1_place, l_1_panel, l_1_ids, l_1_columns):
        t_17 = []
        l_1_look = l_1_class = missing
        if l_1_cell is missing:
            l_1_cell = undefined("parameter 'cell' was not provided", name='cell')
        if l_1_place is missing:
            l_1_place = undefined("parameter 'place' was not provided", name='place')
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        if l_1_ids is missing:
            l_1_ids = undefined("parameter 'ids' was not provided", name='ids')
        if l_1_columns is missing:
            l_1_columns = undefined("parameter 'columns' was not provided", name='columns')
        pass
        l_1_look = ('words' if (environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), l_1_place), 'align') == 'left') else ('missing' if (environment.getattr(l_1_cell, 'kind') == 'missing') else cond_expr_undefined("the inline if-expression on line 45 in 'base/html.jinja' evaluated to false and no else section was defined.")))
        l_1_class = context.call((undefined(name='classed') if l_0_classed is missing else l_0_classed), [(undefined(name='look') if l_1_look is missing else l_1_look), ('row' if (l_1_place == environment.getattr(l_1_panel, 'names')) else cond_expr_undefined("the inline if-expression on line 46 in 'base/html.jinja' evaluated to false and no else section was defined."))])
        if (l_1_place < environment.getattr(l_1_panel, 'stubs')):
            pass
            t_17.extend((
                '<th',
                str(context.call((undefined(name='named') if l_0_named is missing else l_0_named), (environment.getitem(environment.getattr(l_1_ids, 'names'), l_1_place) if l_1_ids else cond_expr_undefined("the inline if-expression on line 48 in 'base/html.jinja' evaluated to false and no else section was defined.")))),
                ' scope="row"',
                str(str_join((context.call((undefined(name='spans') if l_0_spans is missing else l_0_spans), 1, environment.getattr(l_1_cell, 'down')), (undefined(name='class') if l_1_class is missing else l_1_class), ))),
                '>',
                str(context.call((undefined(name='content') if l_0_content is missing else l_0_content), l_1_cell)),
                '</th>',
            ))
        else:
            pass
            t_17.extend((
                '<td',
                str((str_join((' headers="', environment.getitem(l_1_columns, l_1_place), ' ', environment.getattr(l_1_ids, 'heads'), '"', )) if l_1_ids else cond_expr_undefined("the inline if-expression on line 50 in 'base/html.jinja' evaluated to false and no else section was defined."))),
                str((undefined(name='class') if l_1_class is missing else l_1_class)),
                '>',
                str(context.call((undefined(name='content') if l_0_content is missing else l_0_content), l_1_cell)),
                '</td>',
            ))
        return concat(t_17)
    context.exported_vars.add('body_cell')
    context.vars['body_cell'] = l_0_body_cell = Macro(environment, macro, 'body_cell', ('cell', 'place', 'panel', 'ids', 'columns'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_panel, l_1_heads):
        t_18 = []
        l_1_columns = l_1_rows = missing
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        if l_1_heads is missing:
            l_1_heads = undefined("parameter 'heads' was not provided", name='heads')
        pass
        (l_1_columns, l_1_rows) = (environment.getattr(l_1_heads, 'columns'), t_7(context.call(environment.getattr(l_1_heads, 'rows'))))
        l_2_loop = missing
        for l_2_group, l_2_loop in LoopContext(environment.getattr(l_1_panel, 'groups'), undefined):
            l_2_ids = missing
            _loop_vars = {}
            pass
            l_2_ids = environment.getitem((undefined(name='rows') if l_1_rows is missing else l_1_rows), environment.getattr(l_2_loop, 'index0'))
            _loop_vars['ids'] = l_2_ids
            t_18.append(
                '<tbody>\n',
            )
            if environment.getattr(l_2_group, 'label'):
                pass
                t_18.extend((
                    '<tr class="group"><th id="',
                    str(context.call(environment.getattr(l_1_heads, 'group'), environment.getattr(l_2_loop, 'index'), _loop_vars=_loop_vars)),
                    '" scope="rowgroup" colspan="',
                    str(t_6(environment.getattr(l_1_panel, 'columns'))),
                    '"',
                    str((' tabindex="0"' if environment.getattr(l_1_heads, 'reached') else cond_expr_undefined("the inline if-expression on line 59 in 'base/html.jinja' evaluated to false and no else section was defined."))),
                    '><span>',
                    str(environment.getattr(l_2_group, 'label')),
                    '</span></th></tr>\n',
                ))
            l_3_loop = missing
            for l_3_row, l_3_loop in LoopContext(environment.getattr(l_2_group, 'rows'), undefined):
                l_3_own = missing
                _loop_vars = {}
                pass
                l_3_own = (environment.getitem((undefined(name='ids') if l_2_ids is missing else l_2_ids), environment.getattr(l_3_loop, 'index0')) if environment.getattr(l_1_heads, 'needed') else None)
                _loop_vars['own'] = l_3_own
                t_18.extend((
                    '<tr',
                    str((' class="pause"' if (environment.getattr(l_3_loop, 'index0') in environment.getattr(l_2_group, 'pauses')) else (' class="held"' if (environment.getattr(l_3_loop, 'index0') in environment.getattr(l_2_group, 'held')) else cond_expr_undefined("the inline if-expression on line 63 in 'base/html.jinja' evaluated to false and no else section was defined.")))),
                    '>',
                ))
                l_4_loop = missing
                for l_4_cell, l_4_loop in LoopContext(l_3_row, undefined):
                    _loop_vars = {}
                    pass
                    t_18.append(
                        str((context.call((undefined(name='body_cell') if l_0_body_cell is missing else l_0_body_cell), l_4_cell, environment.getattr(l_4_loop, 'index0'), l_1_panel, (undefined(name='own') if l_3_own is missing else l_3_own), (undefined(name='columns') if l_1_columns is missing else l_1_columns), _loop_vars=_loop_vars) if environment.getattr(l_4_cell, 'down') else cond_expr_undefined("the inline if-expression on line 63 in 'base/html.jinja' evaluated to false and no else section was defined."))),
                    )
                l_4_loop = l_4_cell = missing
                t_18.append(
                    '</tr>\n',
                )
            l_3_loop = l_3_row = l_3_own = missing
            t_18.append(
                '</tbody>\n',
            )
        l_2_loop = l_2_group = l_2_ids = missing
        return concat(t_18)
    context.exported_vars.add('body')
    context.vars['body'] = l_0_body = Macro(environment, macro, 'body', ('panel', 'heads'), False, False, False, context.eval_ctx.autoescape)
    yield '<!-- No style of its own: figures want text-align: right and tabular-nums; .words are left, .spanner centred, a space is before .pause. -->\n<figure class="kurbel" id="tab-'
    yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'anchor'))
    yield '" lang="'
    yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'lang'))
    yield '">\n'
    l_1_loop = missing
    for l_1_panel, l_1_loop in LoopContext(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'), undefined):
        l_1_first = l_1_caption = l_1_heads = l_1_sizes = missing
        _loop_vars = {}
        pass
        l_1_first = str_join(('tab-', environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'anchor'), '-caption', ))
        _loop_vars['first'] = l_1_first
        l_1_caption = str_join(((undefined(name='first') if l_1_first is missing else l_1_first), (str_join(('-', environment.getattr(l_1_loop, 'index'), )) if (not environment.getattr(l_1_loop, 'first')) else cond_expr_undefined("the inline if-expression on line 73 in 'base/html.jinja' evaluated to false and no else section was defined.")), ))
        _loop_vars['caption'] = l_1_caption
        l_1_heads = t_3(l_1_panel, environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'anchor'), environment.getattr(l_1_loop, 'index'))
        _loop_vars['heads'] = l_1_heads
        l_1_sizes = t_8(l_1_panel, environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'lang'))
        _loop_vars['sizes'] = l_1_sizes
        yield '<div class="scroll'
        yield str((' broad' if environment.getattr((undefined(name='sizes') if l_1_sizes is missing else l_1_sizes), 'broad') else (' slim' if environment.getattr((undefined(name='sizes') if l_1_sizes is missing else l_1_sizes), 'slim') else cond_expr_undefined("the inline if-expression on line 76 in 'base/html.jinja' evaluated to false and no else section was defined."))))
        yield '" role="region" aria-labelledby="'
        yield str(str_join(((undefined(name='first') if l_1_first is missing else l_1_first), (str_join((' ', (undefined(name='caption') if l_1_caption is missing else l_1_caption), )) if (not environment.getattr(l_1_loop, 'first')) else cond_expr_undefined("the inline if-expression on line 76 in 'base/html.jinja' evaluated to false and no else section was defined.")), )))
        yield '" tabindex="0">\n<table style="'
        yield str(environment.getattr((undefined(name='sizes') if l_1_sizes is missing else l_1_sizes), 'style'))
        yield '">\n<caption id="'
        yield str((undefined(name='caption') if l_1_caption is missing else l_1_caption))
        yield '"><span>'
        yield str((environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption') if environment.getattr(l_1_loop, 'first') else str_join(('(', environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'continued'), ')', ))))
        yield '</span></caption>\n'
        for l_2_group in environment.getattr(l_1_panel, 'column_groups'):
            _loop_vars = {}
            pass
            yield '<colgroup>'
            for l_3_place in l_2_group:
                _loop_vars = {}
                pass
                yield '<col'
                if ((t_6(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels')) > 1) and environment.getitem(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'widths'), l_3_place)):
                    pass
                    yield ' style="width: calc('
                    yield str(environment.getitem(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'widths'), l_3_place))
                    yield 'ch + '
                    yield str(t_2('%g', environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), l_3_place), 'gap')))
                    yield ' * var(--unit))"'
                yield '>'
            l_3_place = missing
            yield '</colgroup>\n'
        l_2_group = missing
        yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, (undefined(name='heads') if l_1_heads is missing else l_1_heads), (undefined(name='sizes') if l_1_sizes is missing else l_1_sizes), _loop_vars=_loop_vars))
        yield str(context.call((undefined(name='body') if l_0_body is missing else l_0_body), l_1_panel, (undefined(name='heads') if l_1_heads is missing else l_1_heads), _loop_vars=_loop_vars))
        yield '</table>\n</div>\n'
    l_1_loop = l_1_panel = l_1_first = l_1_caption = l_1_heads = l_1_sizes = missing
    if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
        pass
        yield '<ul class="notes">\n'
        for l_1_note in environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
            _loop_vars = {}
            pass
            yield '<li id="'
            yield str(environment.getattr(l_1_note, 'target'))
            yield '"'
            yield str((' class="marked"' if environment.getattr(l_1_note, 'mark') else cond_expr_undefined("the inline if-expression on line 92 in 'base/html.jinja' evaluated to false and no else section was defined.")))
            yield '>'
            yield str((str_join((environment.getattr(l_1_note, 'mark'), ' ', )) if environment.getattr(l_1_note, 'mark') else cond_expr_undefined("the inline if-expression on line 92 in 'base/html.jinja' evaluated to false and no else section was defined.")))
            yield str(environment.getattr(l_1_note, 'text'))
            yield '</li>\n'
        l_1_note = missing
        yield '</ul>\n'
    if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'):
        pass
        yield '<p class="source">'
        yield str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'source'))
        yield ': '
        yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'))
        yield '</p>\n'
    yield '</figure>\n'


TEMPLATES = {1922992451: root}
