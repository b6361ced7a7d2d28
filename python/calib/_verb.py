"""One verb of the tool: words in, its document out."""

import json
import logging
import os
import warnings
from typing import Any, Callable, List, Optional

from . import _calib, errors
from ._answer import Document

#: Remarks of the tool: what is no error and yet worth a sentence.
_remarks = logging.getLogger("calib")


def verb(*words: object, **options: object) -> Any:
    """Carries out any verb of the tool and returns the document that ``--json`` prints.

    ``words`` are the verb and what it is about (``"gap", "effects", "dut_drift"``), ``options`` its options with
    ``_`` for ``-``: ``True`` for a switch, a list for one that may be repeated, ``None`` for the default.

    >>> calib.verb("nomogram", frequency=160.0, acceleration=10.0)

    Raises:
        CalibError: as the tool fails, with the remedy in ``hint``.
    """
    return carry_out([str_of(word) for word in words], options)


def carry_out(
    words: List[str],
    options: "dict[str, object]",
    *,
    stop: Any = None,
    on_line: Optional[Callable[[Document], object]] = None,
    moves: bool = False,
    hide: str = "",
) -> Any:
    """:func:`verb`; ``on_line`` hears a stream, ``hide`` is a folder of ours that messages need not name."""
    known, subject = words[: depth(words)], words[depth(words) :]
    form = "--json-lines" if on_line else "--json"
    line = [form, *known, *arguments(options), "--", *subject]
    told = (lambda text: on_line(parsed(text))) if on_line else None
    output, remarks, failure = _calib.verb(line, stop or _calib.stop(True), told, moves)
    for remark in remarks:
        _remarks.info(remark)
    if failure is not None:
        error, hint, code = failure
        error = error.replace(hide + os.sep, "") if hide else error
        if code != errors.NOT_PASSED:
            raise errors.of(error, hint, code)
        warnings.warn(error, errors.NotPassedWarning, stacklevel=3)
    text = "".join(output)
    try:
        return parsed(text) if text.strip() else None
    except ValueError:
        raise errors.UsageError(f"{words[0]} says no document", "name a verb: `calib --help` at a terminal lists them") from None


def parsed(text: str) -> Any:
    """A document whose objects have attributes."""
    return json.loads(text, object_hook=Document)


#: Verbs that have verbs of their own.
_NESTED = ("adjust", "gap", "lists", "logbook", "points", "sensors")


def depth(words: List[str]) -> int:
    """How many of the words name the verb."""
    return 2 if words and words[0] in _NESTED and len(words) > 1 else 1


def arguments(options: "dict[str, object]") -> List[str]:
    """Options as words; ``--name=value``, so that a negative number is none of them."""
    line: List[str] = []
    for name, value in options.items():
        flag = "--" + name.strip("_").replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            line.append(flag)
        elif isinstance(value, (list, tuple)):
            line.extend(f"{flag}={str_of(one)}" for one in value)
        else:
            line.append(f"{flag}={str_of(value)}")
    return line


def str_of(value: object) -> str:
    """A word; numbers in full, so that not a bit is lost."""
    if isinstance(value, (str, os.PathLike)):
        text = os.fspath(value)
        return text if isinstance(text, str) else os.fsdecode(text)
    if isinstance(value, bool):
        raise errors.UsageError(f"{value} is no value", "give a number or a text")
    item = getattr(value, "item", None)
    if callable(item):
        value = scalar(value)
    if isinstance(value, (int, float)):
        return repr(value)
    raise errors.UsageError(
        f"{value!r} is a {type(value).__name__}, where a number, a text or a path is wanted",
        "convert it first",
    )


def scalar(value: Any) -> object:
    """The number in an array of one."""
    try:
        return value.item()
    except (ValueError, TypeError):
        raise errors.UsageError(f"{value!r} is no single number", "give one value at a time") from None
