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
    t_1 = environment.filters['join']
    t_2 = environment.filters['pipe_tables']
    pass
    if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption'):
        pass
        yield '**'
        yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'caption'))
        yield '**\n\n'
    for l_1_panel in environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'panels'):
        _loop_vars = {}
        pass
        for l_2_part in t_2(l_1_panel):
            _loop_vars = {}
            pass
            if environment.getattr(l_2_part, 'label'):
                pass
                yield '**'
                yield str(environment.getattr(l_2_part, 'label'))
                yield '**\n\n'
            yield str(t_1(environment.getattr(l_2_part, 'lines'), '\n'))
            yield '\n\n'
        l_2_part = missing
    l_1_panel = missing
    for l_1_note in environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
        _loop_vars = {}
        pass
        yield '- '
        yield str((str_join((environment.getattr(l_1_note, 'mark'), ' ', )) if environment.getattr(l_1_note, 'mark') else cond_expr_undefined("the inline if-expression on line 16 in 'base/markdown.jinja' evaluated to false and no else section was defined.")))
        yield str(environment.getattr(l_1_note, 'text'))
        yield '\n'
    l_1_note = missing
    if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'):
        pass
        if environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'notes'):
            pass
            yield '\n'
        yield str(environment.getattr(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'words'), 'source'))
        yield ': '
        yield str(environment.getattr((undefined(name='page') if l_0_page is missing else l_0_page), 'source'))
        yield '\n'


TEMPLATES = {3837419070: root}
