"""Arrays, tables and dictionaries as the files that verbs read, and back. Not a bit is lost on the way."""

import contextlib
import csv
import json
import math
import os
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Union

from . import _calib
from .errors import FileError, UsageError

#: What stands for a table: a file, a pandas or polars frame, or columns by name.
Table = Union[str, "os.PathLike[str]", Mapping[str, Any], Any]

#: What stands for a document: a file, or its content.
Content = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def is_path(value: object) -> bool:
    """Whether this names a file."""
    return isinstance(value, (str, os.PathLike))


@contextlib.contextmanager
def folder() -> Iterator[Path]:
    """A folder for the length of a call."""
    with tempfile.TemporaryDirectory(prefix="calib-") as name:
        yield Path(name)


def writable(path: Union[str, "os.PathLike[str]"]) -> Path:
    """A file that is to be written: its folder is there."""
    path = Path(path)
    if not path.parent.is_dir():
        raise FileError(f"cannot write {path}: there is no folder {path.parent}", "make it first, or name another place")
    return path


def columns(table: Any) -> Dict[str, List[Any]]:
    """Columns by name; a missing value is ``None``.

    In a frame of pandas or polars NaN is a missing value, as it is there; in a dictionary it is a number that is
    not finite, which the tool refuses with its place.
    """
    if hasattr(table, "to_dict") and hasattr(table, "columns"):
        names = [str(name) for name in table.columns]
        return {name: [absent(one) for one in listed(table[name], name)] for name in names}
    if getattr(getattr(table, "dtype", None), "names", None):
        return {name: listed(table[name], name) for name in table.dtype.names}
    if not isinstance(table, Mapping):
        raise UsageError(
            f"a {type(table).__name__} is no table",
            "give a file, a frame of pandas or polars, or a dictionary of columns",
        )
    found = {str(name): listed(values, str(name)) for name, values in table.items()}
    return spread(found)


def listed(values: Any, name: str) -> List[Any]:
    """The values of a column; a single one counts for every row."""
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
        return [values]
    values = values.tolist() if hasattr(values, "tolist") else list(values)
    if not isinstance(values, list):
        return [values]
    if any(isinstance(one, (list, tuple, dict)) for one in values):
        raise UsageError(f"column {name} has more than one value in a row", "give one-dimensional arrays")
    return values


def spread(found: Dict[str, List[Any]]) -> Dict[str, List[Any]]:
    """Single values for every row; columns of other lengths are no table."""
    lengths = {name: len(values) for name, values in found.items()}
    rows = max(lengths.values(), default=0)
    for name, length in lengths.items():
        if length == 1:
            found[name] = found[name] * rows
        elif length != rows:
            raise UsageError(
                f"column {name} has {length} values, where {rows} are in the longest",
                "give every column the same length, or a single value",
            )
    return found


def absent(value: Any) -> Any:
    """A value of a frame, where NaN and NA are none."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return None
    return None if type(value).__name__ in ("NAType", "NaTType") else value


def write_csv(path: Path, found: Mapping[str, List[Any]]) -> Path:
    """Columns as a CSV; numbers in full."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(found)
        for row in zip(*found.values()):
            writer.writerow(["" if cell is None else cell_of(cell) for cell in row])
    return path


def cell_of(value: Any) -> str:
    """A cell: a complex number is refused, for which of its parts was meant?"""
    if isinstance(value, complex):
        raise UsageError(f"{value} is complex", "give magnitude and phase as columns of their own")
    return repr(value) if isinstance(value, float) else str(value)


def read_csv(path: Union[str, "os.PathLike[str]"]) -> Dict[str, List[Any]]:
    """Columns of a CSV; an empty cell is ``None``, what is no number stays a text."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.reader(file))
    header = [name.strip() for name in rows[0]] if rows else []
    body = [row for row in rows[1:] if row]
    return {name: [value_of(row[at]) if at < len(row) else None for row in body] for at, name in enumerate(header)}


def value_of(cell: str) -> Any:
    """A number where it is one."""
    try:
        return float(cell) if cell.strip() else None
    except ValueError:
        return cell


def write_toml(path: Path, content: Mapping[str, Any]) -> Path:
    """A document as TOML; ``None`` is left out."""
    try:
        text = json.dumps(plain(content), allow_nan=False)
        path.write_text(_calib.toml(text), encoding="utf-8")
    except ValueError as error:
        raise UsageError(f"{path.name}: {error}", "every value is a finite number, a text, a list or a table") from None
    return path


def plain(value: Any) -> Any:
    """The value in types that JSON has."""
    if isinstance(value, Mapping):
        return {str(key): plain(one) for key, one in value.items() if one is not None}
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    raise UsageError(f"{value!r} is a {type(value).__name__}", "give numbers, texts, lists and dictionaries")


def table_file(table: Table, into: Path, name: str) -> Path:
    """The file of a table, written into a folder of ours if it is none yet."""
    return Path(table) if is_path(table) else write_csv(into / name, columns(table))


def content_file(content: Content, into: Path, name: str) -> Path:
    """The file of a document, written into a folder of ours if it is none yet."""
    if is_path(content):
        return Path(content)
    if not isinstance(content, Mapping):
        raise UsageError(
            f"a {type(content).__name__} is no {name}",
            "give a file, or a dictionary of what is in one",
        )
    return write_toml(into / name, content)
