"""What kurbel says when it cannot go on: one sentence each."""


class KurbelError(Exception):
    """A sentence for the user: what was given, what is allowed, and why.

    `exit_code` is what the command line ends with: 2 for wrong usage, 1 for a job that failed.
    """

    exit_code = 2

    def __reduce__(self) -> tuple[object, ...]:
        # An exception is made anew of its sentence, which some are not made of.
        return Exception.__new__, (type(self), *self.args), vars(self)


class FailedError(KurbelError):
    """A job that failed."""

    exit_code = 1


class NotationError(KurbelError):
    """Text that is not a number, an angle, a ratio or a list of them."""


class KeywordError(KurbelError, TypeError):
    """A value that a function of Python has not, is given twice, of another kind, or lacks."""


class ProblemError(KurbelError):
    """A crank drive that cannot be built or cannot turn."""


class UnsettledError(ProblemError):
    """The greatest precision does not tell numbers apart."""


class NoRootError(FailedError):
    """A condition that holds at no crank angle."""


class ChoiceError(KurbelError):
    """A name that no layout, column, format, language or method has."""


class MissingExtraError(FailedError):
    """A feature whose library is not installed."""


class CardError(FailedError):
    """A file that is no indicator card."""


class MachineError(FailedError):
    """A file that describes no machine."""


class RodError(FailedError):
    """A file that describes no connecting rod."""


class MarkerError(FailedError):
    """A document whose marked places cannot be found or filled."""


class OutsideError(FailedError):
    """A file that a handbook, or a document, may not read, for it lies elsewhere."""

    def __init__(self, name: str, whose: str) -> None:
        super().__init__(
            f'"{name[:60]}" leads out of the folder of the {whose}; put what it names into that folder,'
            " or add --allow-outside"
        )


class OutputError(FailedError):
    """A file or stream that could not be written."""


class LayoutError(FailedError):
    """A layout.toml or a template that cannot be used."""


class ConstructionError(FailedError):
    """A file of a construction that cannot be used."""


class FormatError(FailedError):
    """A folder of an output format that cannot be used."""


class SourceError(FailedError):
    """A source of printed values cannot be used."""


class HandbookError(FailedError):
    """A manifest, or a folder that a handbook cannot be built into."""


class ProseError(FailedError):
    """A text that cannot be set; `line` counts the lines of the text from 1."""

    def __init__(self, line: int, reason: str) -> None:
        super().__init__(f"line {line}: {reason}")
        self.line = line
