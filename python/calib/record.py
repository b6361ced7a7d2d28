"""A record: what an instrument stored of a run, as tables, as a picture, as a certificate."""

import html
import os
import re
from pathlib import Path
from typing import Any, Dict, Iterable, List, Optional, Union

from . import _tables
from ._answer import Document
from ._verb import carry_out, verb
from .errors import FileError, UsageError

#: Name of the file a record is handed on in.
_FILE = "record.calibrec"


class Record:
    """A record, by its bytes or the file they are in; nothing of it is changed."""

    def __init__(self, source: Union[bytes, str, "os.PathLike[str]"]) -> None:
        """
        Raises:
            FileError: there is no such file.
            InputError: it is no record, or was damaged.
        """
        if isinstance(source, (bytes, bytearray, memoryview)):
            self.bytes = bytes(source)
        elif isinstance(source, (str, os.PathLike)):
            self.bytes = _read(source)
        else:
            raise UsageError(f"a {type(source).__name__} is no record", "give the bytes of one, or a file")
        self.document: Document = self._shown()

    @classmethod
    def of_logbook(
        cls,
        number: int,
        *,
        instrument: Optional[str] = None,
        series: Optional[int] = None,
        logbook: Union[str, "os.PathLike[str]", None] = None,
    ) -> "Record":
        """A record of the logbook, by its ``number`` (``calib.verb("logbook", "records")`` lists them).

        Args:
            number: its instrument's.
            instrument: where several instruments have one of this number, the serial number of one, or how it ends.
            series: where an instrument began to count anew, 0 for what it had before, 1 for what it has since.
            logbook: default: that of this user.
        """
        with _tables.folder() as into:
            which = {"instrument": instrument, "series": series, "logbook": logbook}
            verb("logbook", "get", number, out=into / _FILE, **which)
            return cls(into / _FILE)

    def _shown(self) -> Document:
        with _tables.folder() as into:
            file = self.save(into / _FILE)
            # No logbook: what a record says is the same everywhere.
            return carry_out(["show", str(file)], {"logbook": into / "none.sqlite"}, hide=str(into))

    @property
    def points(self) -> List[Document]:
        """Points in rising frequency, then level: the keys of docs/json.md, each with its unit.

        Raises:
            UsageError: it is the record of a change of settings, which has none.
        """
        if not self.is_calibration:
            raise UsageError("this record is of a change of settings and has no points", "`is_calibration` tells")
        return self.document["points"]

    @property
    def is_calibration(self) -> bool:
        """False for the record of a change of settings, which has no points."""
        return "points" in self.document

    def save(self, path: Union[str, "os.PathLike[str]"]) -> Path:
        """Writes the record as it was stored to ``path``."""
        path = _tables.writable(path)
        path.write_bytes(self.bytes)
        return path

    def columns(self) -> Dict[str, List[Any]]:
        """The points as columns, units in the names; ``None`` where there is no value."""
        names = list(dict.fromkeys(name for point in self.points for name in point))
        flat = [name for name in names if not any(isinstance(point.get(name), (dict, list)) for point in self.points)]
        return {name: [point.get(name) for point in self.points] for name in flat}

    def to_numpy(self) -> Dict[str, Any]:
        """The points as arrays, units in the names; NaN where there is no number."""
        import numpy

        def array(values: List[Any]) -> Any:
            if any(isinstance(one, str) for one in values):
                return numpy.array(["" if one is None else one for one in values])
            if all(isinstance(one, bool) for one in values):
                return numpy.array(values, dtype=bool)
            return numpy.array([float("nan") if one is None else one for one in values], dtype=float)

        return {name: array(values) for name, values in self.columns().items()}

    def to_pandas(self) -> Any:
        """The points as a frame of pandas, units in the names of the columns."""
        import pandas

        frame = pandas.DataFrame(self.to_numpy())
        frame.attrs.update(self._about())
        return frame

    def to_xarray(self) -> Any:
        """The points as a dataset of xarray along ``point``; frequency and level are its coordinates."""
        import xarray

        arrays = {name: ("point", values) for name, values in self.to_numpy().items()}
        coordinates = {name: arrays.pop(name) for name in ("frequency_hz", "set_acceleration_rms_ms2")}
        return xarray.Dataset(arrays, coords=coordinates, attrs=self._about())

    def _about(self) -> Dict[str, Any]:
        return {"certificate": self.document["certificate"], "conformity": self.document["conformity"]}

    def certificate(
        self,
        out: Union[str, "os.PathLike[str]"] = ".",
        *,
        format: Optional[Iterable[str]] = None,
        **options: object,
    ) -> List[Path]:
        """Writes the certificate, and returns its files. In a logbook it is entered as issued.

        Args:
            out: folder of the files.
            format: of ``pdf``, ``dcc``, ``html``, ``csv``, ``json``, ``uff``; None: all but uff.
            **options: further options of ``calib certificate``: ``language``, ``laboratory``, ``particulars``,
                ``customer``, ``strict``, ``sign``, ``logbook``.

        Warns:
            NotPassedWarning: the conformity that was asked for is not "pass".
        """
        formats = None if format is None else [format] if isinstance(format, str) else list(format)
        with _tables.folder() as into:
            file = self.save(into / _FILE)
            options = {"out": out, "format": formats, **options}
            written = carry_out(["certificate", str(file)], options, hide=str(into))
        return [Path(name) for name in written["files"]]

    def verify(self, *, key: Optional[str] = None, **options: object) -> Document:
        """Says what its signature proves.

        Args:
            key: public key of the instrument, 64 hexadecimal digits; None: that which the logbook knows.
            **options: further options of ``calib verify``: ``logbook``.

        Warns:
            NotPassedWarning: it was altered, or is not signed.
        """
        with _tables.folder() as into:
            file = self.save(into / _FILE)
            (said,) = carry_out(["verify", str(file)], {"key": key, **options}, hide=str(into))
        # The file was ours, and is gone.
        del said["file"]
        return said

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self.bytes == other.bytes

    def __hash__(self) -> int:
        return hash(self.bytes)

    def __repr__(self) -> str:
        if not self.is_calibration:
            return "<record of a change of settings>"
        return f"<record {self.document['certificate']}, {len(self.points)} points>"

    def _repr_html_(self) -> Optional[str]:
        """Plot and conformity, for a notebook."""
        if not self.is_calibration:
            return None
        stated = self.document["conformity_statement"]
        words = f"{stated['title']}: {stated['because']}" if stated else "no tolerance was stated"
        valid = sum(point["state"] == "valid" for point in self.points)
        head = f"<b>{html.escape(self.document['certificate'])}</b>: {valid} of {len(self.points)} points valid"
        return f"<div>{head}; {html.escape(words)}<br>{self.plot()}</div>"

    def plot(self) -> str:
        """The response over frequency with U as the certificate draws it: SVG."""
        with _tables.folder() as into:
            apart = {"logbook": into / "none.sqlite"}
            (page,) = self.certificate(into, format=["html"], **apart)
            found = re.search(r"<svg.*?</svg>", page.read_text(encoding="utf-8"), re.DOTALL)
            return found.group(0) if found else ""


def _read(path: Union[str, "os.PathLike[str]"]) -> bytes:
    try:
        return Path(path).read_bytes()
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(f"cannot read {os.fspath(path)}: {reason}", "`calib.connect(...).record(ID)` fetches one") from None
