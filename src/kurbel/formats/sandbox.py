"""Templates of a user's folder: run in Jinja's sandbox, with limits, and with errors that name file and line.

Beside `render` the only module that knows Jinja. It is loaded for a user's templates only.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from jinja2 import BaseLoader, TemplateNotFound, TemplateSyntaxError, nodes
from jinja2.compiler import CodeGenerator, Frame
from jinja2.environment import Environment
from jinja2.loaders import split_template_path
from jinja2.runtime import Context
from jinja2.sandbox import ImmutableSandboxedEnvironment

from kurbel.errors import KurbelError, LayoutError
from kurbel.formats.sandbox_limits import OPERATORS, check_call, concatenated
from kurbel.page.layouts import template_folder

LONGEST_FILE = 1_000_000
# Those whose length has little to do with what they are given, and one that is different every time.
_BARRED_FILTERS = ("filesizeformat", "pprint", "random", "tojson", "urlize", "wordwrap", "xmlattr")


def filled(environment: Environment, template: str, values: Mapping[str, object], folder: str) -> str:
    """Return what the template makes of the values.

    Raises LayoutError, with the file and the line, for whatever is wrong with a template of the folder.
    """
    try:
        return environment.get_template(template).render(values)
    except KurbelError:
        raise
    except TemplateSyntaxError as error:
        raise _refused(
            error.filename or error.name or template, error.lineno, error.message, folder
        ) from None
    except Exception as error:
        # Whatever a template does with what it is given, such as 1/0 or "a".b(), is its own mistake.
        place = _place(error, folder) or (template, 0)
        raise _refused(*place, _reason(error), folder) from None


def _reason(error: Exception) -> str:
    if isinstance(error, TemplateNotFound):
        return f"there is no template {error.name}"
    if isinstance(error, RecursionError):
        return "it calls itself without end"
    if isinstance(error, MemoryError):
        return "it needs more memory than there is"
    return str(error) or type(error).__name__


def _place(error: Exception, folder: str) -> tuple[str, int] | None:
    """Return the file and line of a user's template that ran last."""
    found = None
    step = error.__traceback__
    while step:
        file = step.tb_frame.f_code.co_filename
        if _is_within(file, folder):
            found = file, step.tb_lineno
        step = step.tb_next
    return found


def _refused(file: str, line: int | None, reason: str | None, folder: str) -> LayoutError:
    name = os.path.relpath(file, os.path.realpath(folder)) if _is_within(file, folder) else file
    where = f"{os.path.join(folder, name)}{f', line {line}' if line else ''}"
    words = " ".join((reason or "it is not understood").split())
    return LayoutError(f"the template {where} cannot be used: {words[:300]}")


def _is_within(path: str, folder: str) -> bool:
    return path.startswith(os.path.join(os.path.realpath(folder), ""))


class Folders(BaseLoader):
    """Loads templates from a user's folder, and from ours those that it does not have."""

    def __init__(self, folder: str) -> None:
        self.folder = folder

    def get_source(self, environment: Environment, template: str) -> tuple[str, str, Callable[[], bool]]:
        path = self._path(template)
        found = path, _stamp(path)
        with open(path, encoding="utf-8") as file:
            text = file.read(LONGEST_FILE + 1)
        if len(text) > LONGEST_FILE:
            raise LayoutError(f"the template {path} is longer than {LONGEST_FILE} characters")
        return text, path, lambda: (now := self._path(template), _stamp(now)) == found

    def _path(self, template: str) -> str:
        """Return the file of a template; one outside the folders is refused, however it is reached."""
        parts = split_template_path(template)
        for folder in (self.folder, template_folder()):
            path = os.path.realpath(os.path.join(folder, *parts))
            if not os.path.isfile(path):
                continue
            if not _is_within(path, folder):
                raise LayoutError(
                    f"the template {os.path.join(folder, template)} is a link that leads out of {folder}"
                )
            return path
        raise TemplateNotFound(template)


def _stamp(path: str) -> tuple[int, int]:
    status = os.stat(path)
    return status.st_mtime_ns, status.st_size


class _LimitedCode(CodeGenerator):
    """Jinja's ~ is no operator that a sandbox is asked about."""

    def visit_Concat(self, node: nodes.Concat, frame: Frame) -> None:
        self.write("environment.concat((")
        for part in node.nodes:
            self.visit(part, frame)
            self.write(", ")
        self.write("))")


class Sandbox(ImmutableSandboxedEnvironment):
    intercepted_binops = frozenset(OPERATORS)
    code_generator_class = _LimitedCode

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self.globals.pop("lipsum")
        for name in _BARRED_FILTERS:
            del self.filters[name]
        self.filters.update({name: _checked(name, each) for name, each in self.filters.items()})

    @staticmethod
    def concat(pieces: Iterable[Any]) -> str:
        return concatenated(pieces)

    def call_binop(self, context: Context, operator: str, left: Any, right: Any) -> Any:
        return OPERATORS[operator](left, right)

    def call(__self, __context: Context, __obj: Any, *args: Any, **kwargs: Any) -> Any:
        owner = getattr(__obj, "__self__", None)
        if isinstance(owner, str | bytes | int):
            check_call(owner, __obj.__name__, args, kwargs)
        return super().call(__context, __obj, *args, **kwargs)

    def wrap_str_format(self, value: Any) -> Callable[..., str] | None:
        """Return the sandbox's own str.format, which looks at its text first."""
        wrapped: Callable[..., str] | None = super().wrap_str_format(value)
        return wrapped and _checked_method(value.__self__, wrapped)


def _checked(name: str, each: Callable[..., Any]) -> Callable[..., Any]:
    """Return a filter that first looks at what it is given."""
    skipped = 1 if hasattr(each, "jinja_pass_arg") else 0

    def checked(*args: Any, **named: Any) -> Any:
        check_call(args[skipped], name, args[skipped + 1 :], named)
        return each(*args, **named)

    # Jinja reads from this what a filter wants before the value.
    checked.__dict__.update(getattr(each, "__dict__", {}))
    return checked


def _checked_method(owner: str, each: Callable[..., str]) -> Callable[..., str]:
    def checked(*args: Any, **named: Any) -> str:
        check_call(owner, "format", args, named)
        return each(*args, **named)

    return checked
