"""A calibrator at an address: who it is, what it measures, how it is stopped."""

import os
import threading
import time
from pathlib import Path
from typing import Any, Callable, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from . import _calib, _tables
from ._answer import Document
from ._verb import carry_out, str_of
from .errors import LinkError, UsageError
from .record import Record

#: A list of points: a file, frequencies in Hz, pairs of frequency in Hz and acceleration in m/s2 r.m.s., or a table with
#: the columns ``frequency_hz`` and ``acceleration_rms_ms2``.
Points = Union[_tables.Table, Iterable[Union[float, Tuple[float, float]]]]

#: How long a stop may take to be confirmed by this computer's clock, s.
_STOP_S = 10.0


def connect(address: Optional[str] = None, *, logbook: Union[str, "os.PathLike[str]", None] = None) -> "Calibrator":
    """A calibrator, which is asked who it is.

    Args:
        address: a serial port (``COM3``, ``/dev/ttyACM0``), ``tcp:HOST:PORT``, or ``emulated``: the calibrator that is
            inside, running the shipping firmware. None: the only likely port.
        logbook: where records are kept; default: that of this user, if there is one.

    Raises:
        LinkError: nobody answers there.
    """
    calibrator = Calibrator(address, logbook=logbook)
    calibrator.info()
    return calibrator


class Calibrator:
    """A calibrator at an address. Each call opens the link and closes it, as a call of the tool does, so that the
    instrument is free in between."""

    def __init__(self, address: Optional[str], *, logbook: Union[str, "os.PathLike[str]", None] = None) -> None:
        self.address = address
        self.logbook = logbook
        self._running: Any = None
        self._lock = threading.Lock()

    def __enter__(self) -> "Calibrator":
        return self

    def __exit__(self, *_: object) -> None:
        """Leaves nothing moving: a run of another thread is stopped."""
        if self._running is not None:
            self.stop()

    def __repr__(self) -> str:
        return f"calib.connect({self.address!r})"

    def _verb(self, *words: str, **options: object) -> Any:
        return carry_out(list(words), {**self._own(), **options})

    def _own(self) -> "dict[str, object]":
        return {"device": self.address, "logbook": self.logbook}

    def info(self) -> Document:
        """Identity and health."""
        return self._verb("info")

    def selftest(self) -> Document:
        """The board's test of itself, with the table at rest: each line with its limits.

        Warns:
            NotPassedWarning: a line failed.
        """
        return self._verb("selftest")

    def settings(self) -> Document:
        """Its settings: limits, scales, influence quantities, the reference. SI, phases in rad."""
        return self._verb("settings")

    def records(self) -> List[Document]:
        """Records it keeps, a line each."""
        return self._verb("records")

    def record(self, number: int) -> Record:
        """A record it keeps, by its running ``number`` (``record_id`` of :meth:`records`)."""
        with _tables.folder() as into:
            done = self._verb("download", str_of(number), out=into)
            return Record(Path(done["file"]).read_bytes())

    def run(
        self,
        points: Optional[Points] = None,
        level: float = 10.0,
        sensor: Optional[str] = None,
        *,
        on_point: Optional[Callable[[Document], object]] = None,
        on_progress: Optional[Callable[[Document], object]] = None,
        **options: object,
    ) -> "Run":
        """Measures a list of points.

        Args:
            points: a file (.toml or .csv), frequencies in Hz, pairs of frequency and acceleration in m/s2 r.m.s., or a
                table with the columns of such a file; None: one-third octaves from 20 Hz to 10 kHz.
            level: acceleration of points that state none, m/s2 r.m.s.
            sensor: serial number of the device in the logbook; else ``serial=``, ``model=``.
            on_point: is called with each point as it is measured. An exception of it stops the run.
            on_progress: is called about ten times a second with state, fraction and time left.
            **options: further options of ``calib run``: ``operator``, ``temperature`` (degrees Celsius), ``mounting``,
                ``excitation`` (``single-sine``, ``multisine``, ``random``).

        Ctrl-C stops the run: the exciter is silent, and what there is is stored, before ``KeyboardInterrupt`` goes on.

        Warns:
            NotPassedWarning: points were refused; the run says which, why, and what to do.
        """
        result: List[Document] = []

        def hear(event: Document) -> None:
            kind = event.get("event")
            if kind == "result":
                result.append(event)
            elif kind == "point" and on_point is not None:
                on_point(event)
            elif kind == "progress" and on_progress is not None:
                on_progress(event)

        with _tables.folder() as into:
            wanted = {"points": _list_of(points, into), "level": level, "sensor": sensor, **options, **self._own()}
            self._carry_out_run(wanted, hear, str(into))
        done = result[0]
        # A run that could not be stored is in its points alone.
        return Run(done, None if done["state"] == "failed" else self.record(done["record_id"]))

    def _carry_out_run(self, options: "dict[str, object]", hear: Callable[[Document], None], hide: str) -> None:
        stop = _calib.stop(self._is_emulated())
        with self._lock:
            if self._running is not None:
                raise UsageError("this calibrator is measuring", "wait for it, or stop() it")
            self._running = stop
        try:
            carry_out(["run"], options, stop=stop, on_line=hear, moves=True, hide=hide)
        finally:
            self._running = None

    def _is_emulated(self) -> bool:
        return self.address in ("emulated", "emulated-usb")

    def stop(self) -> None:
        """Stops a run and silences the exciter, from any thread or process; returns once it is confirmed.

        Raises:
            LinkError: nobody confirmed it: use the button on the instrument.
        """
        running = self._running
        if running is None:
            self._verb("stop")
            return
        number, begun = _calib.ask(running), time.monotonic()
        while not _calib.is_confirmed(running, number) and self._running is running:
            if time.monotonic() - begun > _STOP_S:
                raise LinkError("the stop was not confirmed", "use the button on the instrument", 3)
            time.sleep(0.005)


class Run:
    """How a run ended: ``state``, ``points``, ``conformity_statement``, ``refusals`` (with what to do), and its ``record``."""

    def __init__(self, document: Document, record: Optional[Record]) -> None:
        self.document = document
        self.record = record

    def __getattr__(self, name: str) -> Any:
        if name in ("document", "record"):
            raise AttributeError(name)
        return getattr(self.document, name)

    def __repr__(self) -> str:
        refused = sum(point["state"] != "valid" for point in self.document["points"])
        return f"<run {self.document['state']}, {len(self.document['points'])} points, {refused} refused>"

    def _repr_html_(self) -> Optional[str]:
        return None if self.record is None else self.record._repr_html_()


def _list_of(points: Optional[Points], into: Path) -> Optional[Path]:
    """The file of a list of points."""
    if points is None or isinstance(points, (str, os.PathLike)):
        return None if points is None else Path(points)
    if hasattr(points, "columns") or isinstance(points, Mapping):
        return _tables.write_csv(into / "points.csv", _tables.columns(points))
    values = points.tolist() if hasattr(points, "tolist") else list(points)
    columns: "dict[str, list[Any]]" = {"frequency_hz": [], "acceleration_rms_ms2": []}
    for one in values:
        pair = one if isinstance(one, Sequence) and not isinstance(one, str) else (one, None)
        if len(pair) != 2:
            raise UsageError(f"{one!r} is no point", "give a frequency in Hz, or a pair of it and m/s2 r.m.s.")
        columns["frequency_hz"].append(pair[0])
        columns["acceleration_rms_ms2"].append(pair[1])
    if all(level is None for level in columns["acceleration_rms_ms2"]):
        del columns["acceleration_rms_ms2"]
    return _tables.write_csv(into / "points.csv", columns)
