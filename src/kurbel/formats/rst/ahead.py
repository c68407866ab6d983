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
    t_1 = environment.filters['finish']
    t_2 = environment.filters['grid_table']
    t_3 = environment.filters['left_columns']
    pass
    l_1_loop = missing
    for l_1_panel, l_1_loop in LoopContext(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'), undefined):
        l_1_name = resolve('name')
        _loop_vars = {}
        pass
        yield '.. table::'
        yield str((str_join((' ', environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption'), )) if (environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption') and environment.getattr(l_1_loop, 'first')) else cond_expr_undefined("the inline if-expression on line 2 in 'base/rst.jinja' evaluated to false and no else section was defined.")))
        yield '\n'
        if environment.getattr(l_1_loop, 'first'):
            pass
            yield '   :name: tab-'
            yield str((undefined(name='name') if l_1_name is missing else l_1_name))
            yield '\n'
        yield '   :align: center\n   :class: kurbel'
        for l_2_place in t_3(l_1_panel):
            _loop_vars = {}
            pass
            yield ' left-'
            yield str(l_2_place)
        l_2_place = missing
        yield '\n\n'
        for l_2_line in t_2(l_1_panel):
            _loop_vars = {}
            pass
            yield '   '
            yield str(l_2_line)
            yield '\n'
        l_2_line = missing
        if (not environment.getattr(l_1_loop, 'last')):
            pass
            yield '\n'
    l_1_loop = l_1_panel = l_1_name = missing
    if (environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes') or environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source')):
        pass
        yield '\n.. container:: kurbel-notes\n\n'
        for l_1_note in environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
            _loop_vars = {}
            pass
            yield '   | '
            yield str((t_1(str_join((environment.getattr(l_1_note, 'mark'), ' ', environment.getattr(l_1_note, 'text'), ))) if environment.getattr(l_1_note, 'mark') else environment.getattr(l_1_note, 'text')))
            yield '\n'
        l_1_note = missing
        if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'):
            pass
            yield '   | '
            yield str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'source'))
            yield ': '
            yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'))
            yield '\n'


TEMPLATES = {2322962912: root}
