"""The command line run in this process: main() with its sentences and exit codes, without its start-up."""

from __future__ import annotations

import csv
import io
import os
import signal
import sys
from collections.abc import Callable
from contextlib import ExitStack, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from typing import Any
from unittest import mock

from kurbel.cli import main
from kurbel.errors import KurbelError

HANDLED = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


@dataclass(frozen=True)
class Result:
    code: int
    out: str
    err: str

    def records(self, delimiter: str = ",") -> list[dict[str, str]]:
        return list(csv.DictReader(io.StringIO(self.out, newline=""), delimiter=delimiter))


def kurbel(*words: str, **environment: str) -> Result:
    """Run `kurbel` with these words; of the tester's KURBEL_ variables only those given here are set."""
    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True)
    err = io.StringIO()
    clean = {name: value for name, value in os.environ.items() if "KURBEL" not in name} | environment
    handlers = {number: signal.getsignal(number) for number in HANDLED}
    with ExitStack() as stack:
        stack.enter_context(mock.patch.object(sys, "argv", ["kurbel", *words]))
        stack.enter_context(mock.patch.dict(os.environ, clean, clear=True))
        stack.enter_context(redirect_stdout(out))
        stack.enter_context(redirect_stderr(err))
        try:
            main()
        except SystemExit as end:
            code = end.code
        finally:
            for number, handler in handlers.items():
                signal.signal(number, handler)
    assert isinstance(code, int)
    out.flush()
    buffer = out.buffer
    assert isinstance(buffer, io.BytesIO)
    return Result(code, buffer.getvalue().decode(), err.getvalue())


def printed(*words: str, **environment: str) -> Result:
    """Run a command that must succeed without a word on standard error."""
    result = kurbel(*words, **environment)
    assert (result.code, result.err) == (0, ""), result.err
    return result


def refusal(*words: str, code: int = 2, **environment: str) -> str:
    """Run a command that must fail with an empty output, and return its one line on standard error."""
    result = kurbel(*words, **environment)
    assert (result.code, result.out) == (code, ""), result.err
    name, sentence = result.err.split(": ", 1)
    assert name == "kurbel"
    assert sentence.endswith("\n")
    line = sentence.removesuffix("\n")
    assert line
    assert line.isprintable()
    assert not line.endswith(".")
    assert ". " not in line
    return line


def answered(*words: str) -> None:
    """Run a command, which must print a page or refuse by one line."""
    result = kurbel(*words)
    if result.code == 0:
        assert result.out.endswith("\n")
        assert result.err == ""
    else:
        assert (result.code, result.out, result.err.count("\n")) == (2, "", 1)
        assert result.err.startswith("kurbel: ")


def sentence_of(read: Callable[[Any], object], text: Any) -> str:
    """Return the sentence by which a text is refused that is read."""
    try:
        read(text)
    except KurbelError as error:
        return str(error)
    raise AssertionError(f"not refused: {text!r}")


def records(*words: str, **environment: str) -> list[dict[str, str]]:
    """Return the rows of the page that a command line prints, by their keys."""
    return printed(*words, "-f", "csv", **environment).records()


def column(key: str, *words: str) -> list[str]:
    """Return what a command line prints under this key, row by row."""
    return [record[key] for record in records(*words)]
