"""Failures, each with the way out."""

from typing import Dict, Optional, Type


class CalibError(Exception):
    """A failure; ``hint`` says what to do about it.

    ``exit_code`` is that of the command line tool, by which a class is chosen.
    """

    def __init__(self, error: str, hint: Optional[str] = None, exit_code: int = 1) -> None:
        super().__init__(f"{error}\nhint: {hint}" if hint else error)
        self.error = error
        self.hint = hint
        self.exit_code = exit_code

    def __reduce__(self) -> tuple:
        # An exception crosses processes, as from a job of a cluster.
        return type(self), (self.error, self.hint, self.exit_code)


class FileError(CalibError, OSError):
    """A file could not be read or written."""


class DefectError(CalibError, RuntimeError):
    """A mistake of ours: report it."""


class UsageError(CalibError, ValueError):
    """An argument that makes no sense."""


class LinkError(CalibError, ConnectionError):
    """No such calibrator, no answer, or damaged answers."""


class ProtocolError(CalibError, ConnectionError):
    """The calibrator speaks another protocol version, or answers nonsense."""


class RefusedError(CalibError):
    """The calibrator understood and refused."""


class InputError(CalibError, ValueError):
    """Data, a record or settings are not usable; says where."""


class NotPassedWarning(UserWarning):
    """Done, but a point was refused, a conformity is not "pass", or a check failed: the result says which."""


#: Exit code of the tool when the work was done and is not a pass.
NOT_PASSED = 7

_CLASSES: Dict[int, Type[CalibError]] = {
    1: FileError,
    2: UsageError,
    3: LinkError,
    4: ProtocolError,
    5: RefusedError,
    6: InputError,
}


def of(error: str, hint: Optional[str], exit_code: int) -> CalibError:
    """The exception of a failure of the tool."""
    if error.startswith("a defect of calib"):
        return DefectError(error, hint, exit_code)
    if hint is None and exit_code == 1:
        hint = "name a place that is there, and that may be read and written"
    return _CLASSES.get(exit_code, CalibError)(error, hint, exit_code)
