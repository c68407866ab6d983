"""The command line: what `kurbel` answers at once, and how it ends.

Only commands import click (app.py), so that `kurbel --help` is there before one notices.
"""

from __future__ import annotations

import gc
import os
import signal
import sys

from kurbel import __version__

# That of typing, which to load is half of what `kurbel --help` takes.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import FrameType, TracebackType
    from typing import NoReturn, TextIO

# Name, the module of the command, or of the function of its name that makes its table, and one line of help.
COMMANDS = {
    "table": ("commands.motion", "Print a table of piston path, velocity and acceleration."),
    "forces": ("commands.forces", "Print the forces in rod, guide and crank pin."),
    "inertia": ("commands.inertia", "Print the forces of the moving connecting rod."),
    "solve": ("commands.solve", "Print the crank angles at which a condition holds."),
    "delta": ("commands.engine", "Print the degree of irregularity of a steam engine."),
    "turning": ("commands.engine", "Print tangential force and excess energy over the crank angle."),
    "pressures": ("commands.power", "Print the acceleration pressure beside that on the piston."),
    "power": ("commands.power", "Print the mean pressure, the power, or the sizes for a power."),
    "flywheel": ("commands.flywheel", "Print the flywheel that keeps an engine or a machine even."),
    "deadcentres": ("commands.motion", "Print dead centres, stroke and times of a crank drive."),
    "harmonics": ("commands.harmonics", "Print the harmonics of the piston's motion or of the torque."),
    "balance": ("commands.balance", "Print the free forces and moments of an engine."),
    "rotor": ("commands.rotor", "Print the unbalance of rotating masses, and what balances it."),
    "locomotive": ("commands.rotor", "Print hammer blow, swaying couple and balance of a locomotive."),
    "firing": ("commands.balance", "Print firing orders, or the cranks that one needs."),
    "sweep": ("cli.sweep", "Compute a table at every combination, into a file of columns."),
    "collate": ("cli.books", "Compare printed values, a book's or yours, with recomputed ones."),
    "verify": ("cli.verify", "Compute the numbers of a page a second time."),
    "sources": ("cli.books", "List the books that can be collated."),
    "example": ("cli.books", "Print a worked example of a book, as printed and recomputed."),
    "plot": ("cli.drawn", "Draw a mechanism to scale, paths of points, and how it moves."),
    "construct": ("cli.drawn", "Draw a construction of the books, and print its lengths."),
    "handbook": ("cli.handbook", "Build, check or watch a whole appendix from its manifest."),
    "inject": ("cli.inject", "Refresh the tables at marked places of your own documents."),
    "layouts": ("cli.listing", "List the page layouts."),
    "quantities": ("cli.listing", "List the quantities that columns can show."),
    "help": ("cli.help", "Say what there is for what one wants, or search for a word."),
}

# What stands together in the help.
GROUPS = {
    "Motion and forces": ("table", "forces", "inertia", "solve", "deadcentres"),
    "Engines": ("delta", "turning", "pressures", "power", "flywheel", "harmonics"),
    "Balance": ("balance", "rotor", "locomotive", "firing"),
    "Sweeps": ("sweep",),
    "Books": ("collate", "sources", "example", "verify"),
    "Drawings and documents": ("plot", "construct", "handbook", "inject"),
    "Lists and help": ("layouts", "quantities", "help"),
}
# Characters of a word, such as a path, and of a sentence, which may list all columns.
LONGEST_WORD, LONGEST_SENTENCE = 300, 3000
# What a shell calls a program that Ctrl-C ended.
INTERRUPTED = 128 + signal.SIGINT
# Seconds in which whatever swallowed Ctrl-C has come to its end.
SOON = 0.01
# So many more objects than before let Python look for garbage; a drawing has 190,000.
ALLOCATED = 250_000

LANGUAGES = "Pages are in German; in English with --lang en, or KURBEL_LANG=en for all."
SUMMARY = "Compute and typeset tables of the crank drive; every printed digit is right."
VARIABLES = """\
KURBEL_LANG, KURBEL_FORMAT and KURBEL_DECIMAL set defaults for
  all commands, KURBEL_TABLE_RATIO and the like one option of a command. Long
  pages go through KURBEL_PAGER, else PAGER, else less; NO_COLOR takes colours
  away, FORCE_COLOR has them in pipes."""
SHORT = """\
Usage: kurbel COMMAND [OPTIONS]

  {summary}

  kurbel table --ratio 1:5              a first table
  kurbel table --ratio 1:5 --lang en    in English; KURBEL_LANG=en for all
  kurbel forces --eps 4 -o forces.tex   a steam engine, for LaTeX

{groups}

More:
  kurbel help                what one has or wants: a steam engine, a diagram
  kurbel help --search WORD  what you do not know the name of
  kurbel COMMAND -h          what one needs first of a command
  kurbel --help              what each command does
"""
HELP = """\
Usage: kurbel [OPTIONS] COMMAND [ARGS]...

  {summary}

  kurbel table --ratio 1:5
  kurbel table --ratio 1:5 --lang en

  {languages}

{commands}

Options:
  --no-pager   Print long pages on a terminal without a pager.
  --version    Show the version and exit.
  -h           Show the commands by their names alone.
  --help       Show what each command does.

  kurbel help is by what one has or wants, and searches. Of a command kurbel
  table -h shows what one needs first, kurbel table --help all options, kurbel
  table --help page those of a topic.

  Environment: {variables}
"""


def short_help() -> str:
    """Return what `kurbel` says of itself on a screen."""
    groups = "\n".join(f"{f'{title}:':24}{' '.join(names)}" for title, names in GROUPS.items())
    return SHORT.format(summary=SUMMARY, groups=groups)


def help_text() -> str:
    """Return the help of `kurbel` itself."""
    width = max(map(len, COMMANDS))
    return HELP.format(
        summary=SUMMARY,
        languages=LANGUAGES,
        variables=VARIABLES,
        commands="\n\n".join(
            "\n".join((f"{title}:", *(f"  {name:{width}}  {COMMANDS[name][1]}" for name in names)))
            for title, names in GROUPS.items()
        ),
    )


def main() -> NoReturn:
    """Run the command line and leave with its exit code: 0 done, 1 failed, 2 wrong usage."""
    ctrl_c = _CtrlC()
    try:
        with ctrl_c:
            code, message = _ended()
            # Whatever a library makes of it is no fault; only a run that kept parts has a sentence.
            if ctrl_c.came and code not in (0, INTERRUPTED):
                code, message = INTERRUPTED, ""
            if message:
                say(message)
    except KeyboardInterrupt:
        code = INTERRUPTED
    except Exception:
        if not ctrl_c.came:
            raise
        code = INTERRUPTED
    # The end of the process frees all of it; to look through it once more is a tenth of the time of a page.
    gc.freeze()
    sys.exit(code)


class _CtrlC:
    """Ctrl-C ends the program with its exit code and without a word, wherever it falls.

    Libraries take what it raises for an error of their own, or print it, and Python swallows it in what runs
    as an object goes, such as the lock of a module.
    """

    def __init__(self) -> None:
        self.came = False

    def __enter__(self) -> None:
        # A job in the background ignores it.
        self._handled = signal.getsignal(signal.SIGINT) is signal.default_int_handler
        self._hooks = sys.excepthook, sys.unraisablehook
        sys.excepthook, sys.unraisablehook = self._printed, self._swallowed
        if self._handled:
            signal.signal(signal.SIGINT, self._raise)

    def __exit__(self, *_: object) -> None:
        if self._handled:
            # All is written: from here on it ends the process at once.
            signal.signal(signal.SIGINT, signal.SIG_DFL)
        sys.excepthook, sys.unraisablehook = self._hooks

    def _raise(self, number: int, frame: FrameType | None) -> None:
        self.came = True
        raise KeyboardInterrupt

    def _printed(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if kind is not KeyboardInterrupt:
            self._hooks[0](kind, error, trace)

    def _swallowed(self, what: sys.UnraisableHookArgs) -> None:
        if what.exc_type is not KeyboardInterrupt:
            self._hooks[1](what)
            return
        from _thread import interrupt_main
        from threading import Timer, get_ident

        # Again, behind what swallowed it; a signal also ends what waits.
        kill = getattr(signal, "pthread_kill", None)
        again = Timer(SOON, kill, (get_ident(), signal.SIGINT)) if kill else Timer(SOON, interrupt_main)
        again.daemon = True
        again.start()


def _ended() -> tuple[int, str]:
    """Run the command line; return its exit code and, if it failed, why."""
    _open_closed_streams()
    # What a command makes it keeps to its end; to look for garbage often is a twentieth of its time.
    gc.set_threshold(ALLOCATED)
    if hasattr(sys.stdout, "reconfigure"):
        # Help and lists have characters, such as ∞, that an old terminal lacks.
        sys.stdout.reconfigure(errors="replace")
    for number in (signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)):
        # nohup has a program ignore the end of its terminal.
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _terminated)
    try:
        return _run()
    except BrokenPipeError:
        _silence(sys.stdout)
        return 128 + getattr(signal, "SIGPIPE", 13), ""
    except OSError as error:
        _silence(sys.stdout)
        return 1, f"cannot write: {error.strerror or error}"


def _open_closed_streams() -> None:
    """Replace streams that the caller closed (>&-) and Python has as None.

    Errors go nowhere; print would put them among the data. Data cannot be written, which is an error.
    """
    if sys.stderr is None:
        sys.stderr = os.fdopen(os.open(os.devnull, os.O_WRONLY), "w")
    if sys.stdout is None:
        sys.stdout = os.fdopen(os.open(os.devnull, os.O_RDONLY), "w")


def _run() -> tuple[int, str]:
    if sys.argv[1:] == ["-h"]:
        sys.stdout.write(short_help())
    elif sys.argv[1:] == ["--help"] and not sys.stdout.isatty():
        sys.stdout.write(help_text())
    elif sys.argv[1:] in (["--version"], ["version"]):
        print(f"kurbel {__version__}")
    elif not sys.argv[1:] and "_KURBEL_COMPLETE" not in os.environ:
        tell(short_help())
        return 2, ""
    else:
        from kurbel.cli.app import run

        return run()
    sys.stdout.flush()
    return 0, ""


def say(message: str) -> None:
    """Write a sentence to standard error, on one line."""
    # The user's own text may have line ends and other controls.
    shown = "".join(one if one.isprintable() else ascii(one)[1:-1] for one in message)
    words = " ".join(_shortened(word, LONGEST_WORD) for word in shown.split(" "))
    tell(f"kurbel: {_shortened(words, LONGEST_SENTENCE)}\n")


def tell(text: str) -> None:
    """Write a text to standard error; where that takes nothing more, the exit code has to say it alone."""
    try:
        sys.stderr.write(text)
        sys.stderr.flush()
    except OSError:
        _silence(sys.stderr)


def _shortened(text: str, longest: int) -> str:
    """Return a text without its middle if it is longer than any of ours: then it has what was typed."""
    return text if len(text) <= longest else f"{text[: longest * 2 // 3]}…{text[-longest // 6 :]}"


def _silence(stream: TextIO) -> None:
    """Keep the interpreter from complaining about a stream that takes nothing more."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _terminated(number: int, frame: FrameType | None) -> None:
    # As an exception, so that half-written files are removed.
    raise SystemExit(128 + number)
