"""Made of the template by scripts/made_ahead.py, by the checksums of their files; not to be edited."""

# mypy: ignore-errors
from kurbel.formats.filling import LoopContext, Macro, Markup, Undefined, identity, missing, str_join


def root(context, environment):
    resolve = context.resolve_or_missing
    undefined = environment.undefined
    concat = environment.concat
    cond_expr_undefined = Undefined
    if 0: yield None
    l_0_longtable = resolve('longtable')
    l_0_tex = resolve('tex')
    l_0_marker = resolve('marker')
    l_0_page = resolve('page')
    l_0_cell = l_0_head = l_0_body = l_0_fitted = l_0_caption = l_0_captioned = l_0_below = missing
    t_1 = environment.filters['length']
    t_2 = environment.filters['spanner_lines']
    t_3 = environment.filters['trim']
    pass
    def macro(l_1_cell, l_1_place, l_1_count, l_1_align):
        t_4 = []
        if l_1_cell is missing:
            l_1_cell = undefined("parameter 'cell' was not provided", name='cell')
        if l_1_place is missing:
            l_1_place = undefined("parameter 'place' was not provided", name='place')
        if l_1_count is missing:
            l_1_count = undefined("parameter 'count' was not provided", name='count')
        if l_1_align is missing:
            l_1_align = undefined("parameter 'align' was not provided", name='align')
        pass
        if (environment.getattr(l_1_cell, 'down') == 0):
            pass
        elif ((environment.getattr(l_1_cell, 'kind') == 'missing') and (l_1_align == 'right')):
            pass
            t_4.extend((
                '\\multicolumn{1}{',
                str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'heading'), l_1_place, 'c', l_1_count)),
                '}{',
                str(environment.getattr(l_1_cell, 'text')),
                str(environment.getattr(l_1_cell, 'marks')),
                '}',
            ))
        elif context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'is_raw'), l_1_place):
            pass
            t_4.append(
                str(environment.getattr(l_1_cell, 'text')),
            )
            if environment.getattr(l_1_cell, 'marks'):
                pass
                t_4.extend((
                    '{\\rlap{',
                    str(environment.getattr(l_1_cell, 'marks')),
                    '}}',
                ))
        else:
            pass
            t_4.append(
                str(environment.getattr(l_1_cell, 'text')),
            )
            if environment.getattr(l_1_cell, 'tail'):
                pass
                t_4.extend((
                    '\\phantom{',
                    str(environment.getattr(l_1_cell, 'tail')),
                    '}',
                ))
            if (environment.getattr(l_1_cell, 'marks') and (l_1_align == 'right')):
                pass
                t_4.extend((
                    '\\rlap{',
                    str(environment.getattr(l_1_cell, 'marks')),
                    '}',
                ))
            else:
                pass
                t_4.append(
                    str(environment.getattr(l_1_cell, 'marks')),
                )
        return concat(t_4)
    context.exported_vars.add('cell')
    context.vars['cell'] = l_0_cell = Macro(environment, macro, 'cell', ('cell', 'place', 'count', 'align'), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_panel):
        t_5 = []
        l_1_count = missing
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        pass
        l_1_count = t_1(environment.getattr((l_1_panel if (undefined(name='longtable') if l_0_longtable is missing else l_0_longtable) else (undefined(name='tex') if l_0_tex is missing else l_0_tex)), 'columns'))
        t_5.append(
            '\\toprule\n',
        )
        l_2_loop = missing
        for l_2_spanners, l_2_loop in LoopContext(environment.getattr(l_1_panel, 'spanners'), undefined):
            _loop_vars = {}
            pass
            l_3_loop = missing
            for l_3_line, l_3_loop in LoopContext(t_2(l_2_spanners, t_1(environment.getattr(l_1_panel, 'columns')), environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'stacked')), undefined):
                _loop_vars = {}
                pass
                l_4_loop = missing
                for l_4_cell, l_4_loop in LoopContext(l_3_line, undefined):
                    _loop_vars = {}
                    pass
                    if environment.getattr(l_4_cell, 'text'):
                        pass
                        t_5.extend((
                            '\\multicolumn{',
                            str(environment.getattr(l_4_cell, 'across')),
                            '}{',
                            str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'head'), l_4_cell, 'c', (undefined(name='count') if l_1_count is missing else l_1_count), _loop_vars=_loop_vars)),
                            '}{',
                            str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'spanner'), l_4_cell, _loop_vars=_loop_vars)),
                            '}',
                        ))
                    t_5.append(
                        str((' \\\\\n' if environment.getattr(l_4_loop, 'last') else ' & ')),
                    )
                l_4_loop = l_4_cell = missing
            l_3_loop = l_3_line = missing
            def t_6(fiter):
                for l_3_cell in fiter:
                    if environment.getattr(l_3_cell, 'text'):
                        yield l_3_cell
            for l_3_cell in t_6(l_2_spanners):
                _loop_vars = {}
                pass
                t_5.extend((
                    '\\cmidrule(',
                    str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'trims'), l_3_cell, (undefined(name='count') if l_1_count is missing else l_1_count), _loop_vars=_loop_vars)),
                    '){',
                    str((environment.getattr(l_3_cell, 'first') + 1)),
                    '-',
                    str((environment.getattr(l_3_cell, 'last') + 1)),
                    '}',
                ))
            l_3_cell = missing
            t_5.append(
                '\n',
            )
        l_2_loop = l_2_spanners = missing
        l_2_loop = missing
        for l_2_line, l_2_loop in LoopContext(environment.getattr(l_1_panel, 'heading_lines'), undefined):
            _loop_vars = {}
            pass
            l_3_loop = missing
            for l_3_text, l_3_loop in LoopContext(l_2_line, undefined):
                l_3_align = missing
                _loop_vars = {}
                pass
                l_3_align = ('c' if (environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), environment.getattr(l_3_loop, 'index0')), 'align') == 'right') else 'l')
                _loop_vars['align'] = l_3_align
                if l_3_text:
                    pass
                    t_5.extend((
                        '\\multicolumn{1}{',
                        str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'heading'), environment.getattr(l_3_loop, 'index0'), (undefined(name='align') if l_3_align is missing else l_3_align), (undefined(name='count') if l_1_count is missing else l_1_count), _loop_vars=_loop_vars)),
                        '}{',
                        str(l_3_text),
                        '}',
                    ))
                t_5.append(
                    str((' \\\\\n' if environment.getattr(l_3_loop, 'last') else ' & ')),
                )
            l_3_loop = l_3_text = l_3_align = missing
        l_2_loop = l_2_line = missing
        t_5.append(
            '\\midrule\n',
        )
        return concat(t_5)
    context.exported_vars.add('head')
    context.vars['head'] = l_0_head = Macro(environment, macro, 'head', ('panel',), False, False, False, context.eval_ctx.autoescape)
    def macro(l_1_panel):
        t_7 = []
        if l_1_panel is missing:
            l_1_panel = undefined("parameter 'panel' was not provided", name='panel')
        pass
        l_2_loop = missing
        for l_2_group, l_2_loop in LoopContext(environment.getattr(l_1_panel, 'groups'), undefined):
            _loop_vars = {}
            pass
            if (not environment.getattr(l_2_loop, 'first')):
                pass
                t_7.extend((
                    '\\addlinespace[',
                    str(('0.9em' if environment.getattr(l_2_group, 'label') else '0.5em')),
                    ']\n',
                ))
            if environment.getattr(l_2_group, 'label'):
                pass
                t_7.extend((
                    '\\multicolumn{',
                    str(t_1(environment.getattr(l_1_panel, 'columns'))),
                    '}{@{}l@{}}{',
                    str(environment.getattr(l_2_group, 'label')),
                    '} \\\\*\n',
                ))
            l_3_loop = missing
            for l_3_row, l_3_loop in LoopContext(environment.getattr(l_2_group, 'rows'), undefined):
                l_3_end = missing
                _loop_vars = {}
                pass
                if (environment.getattr(l_3_loop, 'index0') in environment.getattr(l_2_group, 'pauses')):
                    pass
                    t_7.append(
                        '\\addlinespace[0.35em]\n',
                    )
                l_3_end = (' \\\\*\n' if (environment.getattr(l_3_loop, 'index') in environment.getattr(l_2_group, 'held')) else ' \\\\\n')
                _loop_vars['end'] = l_3_end
                l_4_loop = missing
                for l_4_one, l_4_loop in LoopContext(l_3_row, undefined):
                    _loop_vars = {}
                    pass
                    t_7.extend((
                        str(t_3(context.call((undefined(name='cell') if l_0_cell is missing else l_0_cell), l_4_one, environment.getattr(l_4_loop, 'index0'), t_1(environment.getattr((l_1_panel if (undefined(name='longtable') if l_0_longtable is missing else l_0_longtable) else (undefined(name='tex') if l_0_tex is missing else l_0_tex)), 'columns')), environment.getattr(environment.getitem(environment.getattr(l_1_panel, 'columns'), environment.getattr(l_4_loop, 'index0')), 'align'), _loop_vars=_loop_vars), ' \n')),
                        str(((undefined(name='end') if l_3_end is missing else l_3_end) if environment.getattr(l_4_loop, 'last') else ' & ')),
                    ))
                l_4_loop = l_4_one = missing
            l_3_loop = l_3_row = l_3_end = missing
        l_2_loop = l_2_group = missing
        return concat(t_7)
    context.exported_vars.add('body')
    context.vars['body'] = l_0_body = Macro(environment, macro, 'body', ('panel',), False, False, False, context.eval_ctx.autoescape)
    def macro():
        t_8 = []
        pass
        if environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'fits'):
            pass
            t_8.append(
                '\\small\\dimen2=2\\fontcharwd\\font`0 \\tabcolsep0.65em\n',
            )
        else:
            pass
            t_8.extend((
                '% The gaps, then the type, become smaller until the columns, measured in figures, fit the line.\n\\newcommand{\\kurbelfit}{\\dimen2=2\\fontcharwd\\font`0\n  \\tabcolsep\\dimexpr(\\linewidth-',
                str(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'all')),
                '\\dimen2)*100/',
                str(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'gaps')),
                '\\relax}%\n\\small\\kurbelfit\n\\ifdim\\tabcolsep<0.3em\\footnotesize\\kurbelfit\\fi\n\\ifdim\\tabcolsep<0.3em\\scriptsize\\kurbelfit\\fi\n\\ifdim\\tabcolsep<0.3em\\tabcolsep0.3em\\fi\n\\ifdim\\tabcolsep>0.65em\\tabcolsep0.65em\\fi\n',
            ))
        t_8.append(
            '\\cmidrulekern\\tabcolsep\n',
        )
        if (undefined(name='marker') if l_0_marker is missing else l_0_marker):
            pass
            t_8.extend((
                '\\sisetup{output-decimal-marker=',
                str((undefined(name='marker') if l_0_marker is missing else l_0_marker)),
                '}%\n',
            ))
        return concat(t_8)
    context.exported_vars.add('fitted')
    context.vars['fitted'] = l_0_fitted = Macro(environment, macro, 'fitted', (), False, False, False, context.eval_ctx.autoescape)
    def macro():
        t_9 = []
        pass
        t_9.append(
            '% Lines of equal length, where nobody says how the lines of captions end.\n\\newcommand{\\kurbelbalanced}{\\expandafter\\ifx\\csname caption@hj\\endcsname\\relax\\kurbellines\\else\n  \\expandafter\\ifx\\csname caption@hj\\endcsname\\empty\\kurbellines\\fi\\fi}%\n\\newcommand{\\kurbellines}{\\leftskip0pt plus.25\\linewidth\\rightskip\\leftskip\\parfillskip0pt\\parindent0pt\n  \\spaceskip\\fontdimen2\\font\\thickmuskip5mu\\medmuskip4mu\\tolerance9999\\hyphenpenalty10000\\hbadness10000\\relax}%\n',
        )
        return concat(t_9)
    context.exported_vars.add('caption')
    context.vars['caption'] = l_0_caption = Macro(environment, macro, 'caption', (), False, False, False, context.eval_ctx.autoescape)
    def macro():
        t_10 = []
        pass
        t_10.extend((
            '\\caption[{',
            str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption')),
            '}]{\\kurbelbalanced ',
            str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption')),
            '}\\label{tab:',
            str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'anchor')),
            '}',
        ))
        return concat(t_10)
    context.exported_vars.add('captioned')
    context.vars['captioned'] = l_0_captioned = Macro(environment, macro, 'captioned', (), False, False, False, context.eval_ctx.autoescape)
    def macro():
        t_11 = []
        pass
        t_11.append(
            '\\footnotesize\\raggedright\n',
        )
        for l_2_note in environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
            _loop_vars = {}
            pass
            t_11.extend((
                str((str_join((environment.getattr(l_2_note, 'mark'), '~', )) if environment.getattr(l_2_note, 'mark') else cond_expr_undefined("the inline if-expression on line 87 in 'base/latex.jinja' evaluated to false and no else section was defined."))),
                str(environment.getattr(l_2_note, 'text')),
                '\\par\n',
            ))
        l_2_note = missing
        if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'):
            pass
            t_11.extend((
                str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'source')),
                ': ',
                str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source')),
                '\n',
            ))
        return concat(t_11)
    context.exported_vars.add('below')
    context.vars['below'] = l_0_below = Macro(environment, macro, 'below', (), False, False, False, context.eval_ctx.autoescape)
    yield '% Packages: amsmath, array, booktabs, '
    yield str(('longtable' if (undefined(name='longtable') if l_0_longtable is missing else l_0_longtable) else 'graphicx'))
    yield str((', lscape' if ((undefined(name='longtable') if l_0_longtable is missing else l_0_longtable) and environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'wide')) else cond_expr_undefined("the inline if-expression on line 93 in 'base/latex.jinja' evaluated to false and no else section was defined.")))
    yield str((', siunitx' if (undefined(name='marker') if l_0_marker is missing else l_0_marker) else cond_expr_undefined("the inline if-expression on line 93 in 'base/latex.jinja' evaluated to false and no else section was defined.")))
    yield '\n'
    if (undefined(name='longtable') if l_0_longtable is missing else l_0_longtable):
        pass
        if environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'wide'):
            pass
            yield '\\begin{landscape}\n'
        yield '\\begingroup\n'
        yield str(context.call((undefined(name='fitted') if l_0_fitted is missing else l_0_fitted)))
        yield '\\edef\\kurbelwidth{\\the\\dimexpr'
        yield str(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'all'))
        yield '\\dimen2+\\tabcolsep*'
        yield str(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'gaps'))
        yield '/100\\relax}%\n\\LTcapwidth\\kurbelwidth\\relax\n\\ifdim\\LTcapwidth>.85\\linewidth\\LTcapwidth.85\\linewidth\\fi\n\\ifdim\\LTcapwidth<14em\\LTcapwidth14em\\fi\n'
        yield str(context.call((undefined(name='caption') if l_0_caption is missing else l_0_caption)))
        l_1_loop = missing
        for l_1_panel, l_1_loop in LoopContext(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'), undefined):
            _loop_vars = {}
            pass
            if (not environment.getattr(l_1_loop, 'first')):
                pass
                yield '\\addtocounter{table}{-1}\n'
            yield '\\begin{longtable}{'
            yield str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'spec'), t_1(environment.getattr(l_1_panel, 'columns')), _loop_vars=_loop_vars))
            yield '}\n'
            if environment.getattr(l_1_loop, 'first'):
                pass
                yield str(context.call((undefined(name='captioned') if l_0_captioned is missing else l_0_captioned), _loop_vars=_loop_vars))
                yield ' \\\\\n'
                yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, _loop_vars=_loop_vars))
                yield '\\endfirsthead\n'
            else:
                pass
                yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, _loop_vars=_loop_vars))
                yield '\\endfirsthead\n'
            yield '\\multicolumn{'
            yield str(t_1(environment.getattr(l_1_panel, 'columns')))
            yield '}{@{}l@{}}{\\tablename~\\thetable\\ ('
            yield str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'continued'))
            yield ')} \\\\\n'
            yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, _loop_vars=_loop_vars))
            yield '\\endhead\n\\bottomrule\n\\endfoot\n'
            yield str(context.call((undefined(name='body') if l_0_body is missing else l_0_body), l_1_panel, _loop_vars=_loop_vars))
            yield '\\end{longtable}\n'
        l_1_loop = l_1_panel = missing
        if (environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes') or environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source')):
            pass
            yield '\\begin{center}\n\\dimen0=\\kurbelwidth\\relax\n\\ifdim\\dimen0<.6\\linewidth\\dimen0=.6\\linewidth\\fi\n\\begin{minipage}{\\dimen0}\n'
            yield str(context.call((undefined(name='below') if l_0_below is missing else l_0_below)))
            yield '\\end{minipage}\n\\end{center}\n'
        yield '\\endgroup\n'
        if environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'wide'):
            pass
            yield '\\end{landscape}\n'
    else:
        pass
        yield '\\begin{table}[htbp]\n\\centering\n'
        if environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'turns'):
            pass
            yield '% On a line that is too short for type of 7 pt the table stands turned, on a page of its own.\n\\newcommand{\\kurbelturned}{\\mbox}\\newcommand{\\kurbelline}{\\linewidth}%\n\\sbox0{\\fontsize{7}{8}\\selectfont\\hspace{'
            yield str(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'least'))
            yield '\\dimexpr2\\fontcharwd\\font`0\\relax}}%\n\\ifdim\\wd0>\\linewidth\\ifdim\\textheight>\\linewidth\n\\renewcommand{\\kurbelturned}{\\rotatebox{90}}\\renewcommand{\\kurbelline}{\\textheight}\\fi\\fi\n\\sbox4{\\kurbelturned{\\begin{minipage}{\\kurbelline}\\centering\n'
        yield '\\sbox0{%\n'
        yield str(context.call((undefined(name='fitted') if l_0_fitted is missing else l_0_fitted)))
        yield '\\sbox2{%\n\\begin{tabular}{'
        yield str(context.call(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'spec'), t_1(environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'columns'))))
        yield '}\n'
        l_1_loop = missing
        for l_1_panel, l_1_loop in LoopContext(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'), undefined):
            _loop_vars = {}
            pass
            yield str(context.call((undefined(name='head') if l_0_head is missing else l_0_head), l_1_panel, _loop_vars=_loop_vars))
            yield str(context.call((undefined(name='body') if l_0_body is missing else l_0_body), l_1_panel, _loop_vars=_loop_vars))
            yield '\\bottomrule\n'
            if (not environment.getattr(l_1_loop, 'last')):
                pass
                yield '\\addlinespace[2ex]\n'
        l_1_loop = l_1_panel = missing
        yield '\\end{tabular}}%\n\\ifdim\\wd2>\\linewidth\n\\ifdim\\dimexpr\\csname f@size\\endcsname pt*\\number\\linewidth/\\number\\wd2\\relax<6.9pt\n\\PackageWarningNoLine{kurbel}{The line is too short for tab:'
        yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'anchor'))
        yield ': its type is below 7pt}\\fi\n\\sbox2{\\resizebox{\\linewidth}{!}{\\usebox2}}\\fi\n\\usebox2}%\n% The caption is no wider than the table. Some classes have the space above it that belongs below it.\n\\dimen0=\\wd0\n\\ifdim\\dimen0>.85\\linewidth\\dimen0=.85\\linewidth\\fi\n\\ifdim\\dimen0<14em\\dimen0=14em\\fi\n\\edef\\kurbelskip{\\the\\ifdim\\abovecaptionskip<\\belowcaptionskip\\belowcaptionskip\\else\\abovecaptionskip\\fi}%\n\\abovecaptionskip0pt\\belowcaptionskip0pt\n'
        yield str(context.call((undefined(name='caption') if l_0_caption is missing else l_0_caption)))
        yield '\\begin{minipage}{\\dimen0}\n'
        yield str(context.call((undefined(name='captioned') if l_0_captioned is missing else l_0_captioned)))
        yield '\n\n\\end{minipage}\\par\\nointerlineskip\\vspace{\\kurbelskip}\n\\usebox0\n'
        if (environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes') or environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source')):
            pass
            yield '\n\\smallskip\n\\dimen0=\\wd0\n\\ifdim\\dimen0<.6\\linewidth\\dimen0=.6\\linewidth\\fi\n\\begin{minipage}{\\dimen0}\n'
            yield str(context.call((undefined(name='below') if l_0_below is missing else l_0_below)))
            yield '\\end{minipage}\n'
        if environment.getattr((undefined(name='tex') if l_0_tex is missing else l_0_tex), 'turns'):
            pass
            yield '\\end{minipage}}}%\n\\ifdim\\wd4>\\linewidth\\sbox4{\\resizebox{\\linewidth}{!}{\\usebox4}}\\fi\n\\usebox4\n'
        yield '\\end{table}\n'


TEMPLATES = {3069090975: root}
