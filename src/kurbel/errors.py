"""What kurbel says when it cannot go on: one sentence each."""


class KurbelError(Exception):
    """A sentence for the user: what was given, what is allowed, and why.

    `exit_code` is what the command line ends with: 2 for wrong usage, 1 for a job that failed.
    """

    exit_code = 2


class NotationError(KurbelError):
    """Text that is not a number, an angle, a ratio or a list of them."""


class ProblemError(KurbelError):
    """A crank drive that cannot be built or cannot turn."""


class NoRootError(KurbelError):
    """A condition that holds at no crank angle."""

    exit_code = 1


class ChoiceError(KurbelError):
    """A name that no layout, column, format, language or method has."""


class MissingExtraError(KurbelError):
    """A feature whose library is not installed."""

    exit_code = 1


class CardError(KurbelError):
    """A file that is no indicator card."""

    exit_code = 1


class MachineError(KurbelError):
    """A file that describes no machine."""

    exit_code = 1


class RodError(KurbelError):
    """A file that describes no connecting rod."""

    exit_code = 1


class MarkerError(KurbelError):
    """A document whose marked places cannot be found or filled."""

    exit_code = 1


class OutputError(KurbelError):
    """A file or stream that could not be written."""

    exit_code = 1


class LayoutError(KurbelError):
    """A layout.toml or a template that cannot be used."""

    exit_code = 1


class SourceError(KurbelError):
    """A source of printed values cannot be used."""

    exit_code = 1


class HandbookError(KurbelError):
    """A manifest, or a folder that a handbook cannot be built into."""

    exit_code = 1


class TexError(KurbelError):
    """A PDF that TeX cannot make."""

    exit_code = 1


class ProseError(KurbelError):
    """A text that cannot be set; `line` counts the lines of the text from 1."""

    exit_code = 1

    def __init__(self, line: int, reason: str) -> None:
        super().__init__(f"line {line}: {reason}")
        self.line = line
