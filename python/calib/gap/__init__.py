"""Why reality differs from a simulation: the diagnosis of docs/gap.md, of the library's beliefs or of your own model."""

import html
import os
from pathlib import Path
from typing import Any, Iterable, List, Optional, Union

from .. import _tables
from .._tables import Content, Table
from .._verb import carry_out, verb
from ..errors import UsageError
from .answer import Answer
from .model import Model, divided_out, from_fmu, from_table, from_time_domain

__all__ = [
    "Answer",
    "challenge",
    "diagnose",
    "effects",
    "from_fmu",
    "from_table",
    "from_time_domain",
    "plan",
    "score",
    "simulate",
]

_Path = Union[str, "os.PathLike[str]"]


def diagnose(
    data: Union[Table, Iterable[_Path]],
    rig: Optional[Content] = None,
    *,
    model: Optional[Model] = None,
    without: Union[str, Iterable[str]] = (),
    max_effects: int = 2,
    validate: Optional[_Path] = None,
    report: Optional[_Path] = None,
    confirm: bool = False,
) -> Union[Answer, List[Any]]:
    """Says where measurement and simulation differ, which unmodelled effect does it, and what to measure next.

    Args:
        data: a dataset folder, several of them or a sealed set (then a list is returned), or a table with the columns
            of a ``points.csv`` (``frequency_hz``, ``ratio``, ``dut_deg``, ``u_ratio``, ...) or of a ``record.csv``
            (``time_s``, ``input``, ``output``). Amplitudes are r.m.s., phases degrees.
        rig: what the simulation believes: a ``rig.toml``, a dictionary of what is in one, or ``"standard"``; None: that
            of the folder, else ``"standard"``.
        model: your own simulation of the ratio of device and reference, as :func:`from_time_domain` and
            :func:`from_fmu` make one too: the library's effects are then corrections to it.
        without: effects that must not be named.
        max_effects: largest number of effects at a time, 0 to 3.
        validate: another dataset to score on, instead of rows that took no part.
        report: writes the report into this HTML file, in a folder that is there.
        confirm: adds the most probable cause to the emulated rig and compares (minutes).

    Returns:
        The answer; in a notebook it shows its report. Of several datasets a list, in order: one that is unusable is
        a document with ``error``.

    Raises:
        InputError: unusable data, with file, line, column and the way out.
    """
    if model is not None and not callable(model):
        raise UsageError(f"a {type(model).__name__} is no model", "give a function, or one of from_time_domain(), ...")
    if report is not None:
        # Before the work, and not after it.
        _tables.writable(report)
    options = {
        "without": _names(without),
        "max_effects": max_effects,
        "validate": validate,
        "confirm": confirm,
    }
    with _tables.folder() as into:
        if _are_folders(data):
            if model is not None or rig is not None:
                raise UsageError("model= and rig= are for one dataset", "call diagnose() once for each")
            if not data:
                raise UsageError("the list names no dataset", "name folders, or a sealed set")
            words = ["gap", "diagnose", *(os.fspath(one) for one in data)]
            answers = carry_out(words, {**options, "report": report})
            return [Answer(one) if "verdict" in one else one for one in _listed(answers)]
        folder = _dataset(data, rig, into)
        if model is not None:
            folder = divided_out(folder, model, into / "corrected")
        page = into / "report.html"
        found = carry_out(["gap", "diagnose", str(folder)], {**options, "report": page}, hide=str(into))
        if isinstance(found, list):
            return [Answer(one) if "verdict" in one else one for one in found]
        # Under the name that was given, not that of a folder of ours.
        name = os.fspath(data) if _tables.is_path(data) else "table"
        found["dataset"]["path"] = name
        shown = page.read_text(encoding="utf-8").replace(_escaped(str(folder)), _escaped(name))
        answer = Answer(found, shown)
        if report is not None:
            answer.save_report(report)
        return answer


def simulate(
    rig: Content = "standard",
    effects: Union[str, Iterable[str]] = (),
    *,
    out: Optional[_Path] = None,
    seed: int = 0,
    columns: str = "all",
    off_by: Optional[float] = None,
) -> Any:
    """A dataset of known cause from the digital twin.

    Args:
        rig: what the simulation believes: a file, a dictionary, ``"standard"`` or ``"oscillator"``.
        effects: of the measured side: ``"suspension_cubic=k3_n_per_m3:1e7"``, or names alone for usual values.
        out: a new folder for the dataset, whose path is returned; None: the table is returned.
        seed: of noise, mountings and true values.
        columns: ``all``, ``no-current`` or ``ratio``.
        off_by: puts every nominal parameter so many standard uncertainties off, 0 to 3.

    Returns:
        The folder, or the table as columns by name (``pandas.DataFrame`` takes it).
    """
    options = {"effect": _names(effects), "seed": seed, "columns": columns, "off_by": off_by}
    with _tables.folder() as into:
        believed = rig if isinstance(rig, str) else _tables.content_file(rig, into, "rig.toml")
        folder = Path(out) if out is not None else into / "dataset"
        carry_out(["gap", "simulate", str(believed)], {**options, "out": folder}, hide=str(into))
        if out is not None:
            return folder
        table = folder / "points.csv"
        return _tables.read_csv(table if table.exists() else folder / "record.csv")


def plan(data: Content, *, most: int = 24) -> Any:
    """The measurements to take next: the points that best separate what is still possible, and by how many sigma.

    Args:
        data: a dataset folder, or a rig as for :func:`simulate`.
        most: measurements at most, 1 to 100.
    """
    with _tables.folder() as into:
        subject = data if isinstance(data, str) else _tables.content_file(data, into, "rig.toml")
        return carry_out(["gap", "plan", str(subject)], {"most": most}, hide=str(into))


def effects(name: Optional[str] = None) -> Any:
    """The library: of each effect stage, formula, parameters with units and bounds, where it shows, what it is
    confused with.

    Args:
        name: of one effect: a list of one is returned; None: all.
    """
    return verb("gap", "effects", *([] if name is None else [name]))


def challenge(out: _Path, *, cases: int, seed: int, strata: Union[str, Iterable[str]] = ()) -> Any:
    """A sealed set: datasets whose truth is kept apart, beside it in ``OUT-truth.json``.

    Args:
        out: a new folder for the datasets.
        cases: of each kind.
        seed: of everything that is drawn: who knows it knows the truth.
        strata: kinds of cases: ``null``, ``single``, ``pair``, ``withheld``, ...; empty: all.

    Returns:
        How many there are, and the SHA-256 of the truth, to be published before anybody answers.
    """
    options = {"cases": cases, "seed": seed, "strata": _names(strata)}
    return carry_out(["gap", "challenge", os.fspath(out)], options)


def score(answers: Union[_Path, Iterable[Any]], truth: _Path, *, sha256: Optional[str] = None) -> Any:
    """Scores answers: opens the truth of a sealed set, if it is the one that was sealed.

    Args:
        answers: a file of JSON lines, or the list that :func:`diagnose` returned.
        truth: the truth of the set.
        sha256: of the truth as published; default: that in the set beside it.
    """
    with _tables.folder() as into:
        lines = Path(answers) if _tables.is_path(answers) else _lines(answers, into / "answers.jsonl")
        return carry_out(["gap", "score", str(lines), os.fspath(truth)], {"sha256": sha256}, hide=str(into))


def _lines(answers: Iterable[Any], path: Path) -> Path:
    import json

    path.write_text("".join(json.dumps(one) + "\n" for one in answers), encoding="utf-8")
    return path


def _names(value: Union[str, Iterable[str]]) -> List[str]:
    """Names in a list; a single one need not be."""
    return [value] if isinstance(value, str) else list(value)


def _are_folders(data: Any) -> bool:
    """A list of folders, and not a table."""
    return isinstance(data, (list, tuple)) and all(_tables.is_path(one) for one in data)


def _listed(answers: Any) -> List[Any]:
    return answers if isinstance(answers, list) else [answers]


def _escaped(text: str) -> str:
    """Text as the report's template writes it."""
    return html.escape(text).replace("/", "&#x2f;")


def _dataset(data: Any, rig: Optional[Content], into: Path) -> Path:
    """The folder of a dataset: the one given, or one of ours with that table and that rig."""
    if _tables.is_path(data) and rig is None:
        return Path(data)
    folder = into / "dataset"
    folder.mkdir()
    if _tables.is_path(data):
        found = _tables.read_csv(_table_in(Path(data)))
    else:
        found = _tables.columns(data)
    is_record = "input" in found and "output" in found
    _tables.write_csv(folder / ("record.csv" if is_record else "points.csv"), found)
    _put_rig("standard" if rig is None else rig, is_record, folder)
    return folder


def _table_in(data: Path) -> Path:
    """The table of a dataset folder, or the file itself."""
    tables = [data / "points.csv", data / "record.csv"] if data.is_dir() else [data]
    for table in tables:
        if table.is_file():
            return table
    raise UsageError(f"there is no table in {data}", "name a dataset folder, or a table")


def _put_rig(rig: Content, is_record: bool, folder: Path) -> None:
    """Writes what is believed beside the table."""
    if rig == "standard":
        with _tables.folder() as apart:
            name = "oscillator" if is_record else "standard"
            options = {"out": apart / "d", "columns": "ratio"}
            carry_out(["gap", "simulate", name], options)
            text = (apart / "d" / "rig.toml").read_text(encoding="utf-8")
    else:
        file = _tables.content_file(rig, folder, "rig.toml")
        file = file / "rig.toml" if file.is_dir() else file
        try:
            text = file.read_text(encoding="utf-8")
        except OSError as error:
            raise UsageError(f"there is no rig {file}: {error.strerror}", "docs/gap.md shows a rig.toml") from None
    (folder / "rig.toml").write_text(text, encoding="utf-8")
