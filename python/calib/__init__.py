"""Field vibration calibrator after ISO 16063-21: measure, evaluate, and explain the gap to a simulation.

Every function is a verb of the command line tool ``calib``: the same checks, the same numbers to the last bit, and
the same remedies when something is wrong, as exceptions (:class:`CalibError`). Quantities are SI, their unit is in
their name (``frequency_hz``, ``sensitivity_v_per_ms2``), amplitudes say peak or rms.

>>> import calib
>>> with calib.connect("emulated") as instrument:
...     run = instrument.run([80, 160], level=10.0)
>>> run.record.to_pandas()
"""

from . import gap
from ._answer import Document
from ._verb import verb
from .calculators import budget, convert, identify, linking, phase, risk, sensitivity
from .calibrator import Calibrator, Run, connect
from .errors import (
    CalibError,
    DefectError,
    FileError,
    InputError,
    LinkError,
    NotPassedWarning,
    ProtocolError,
    RefusedError,
    UsageError,
)
from .lake import export_lake
from .record import Record

__version__ = verb("version")["tool_version"]

__all__ = [
    "CalibError",
    "Calibrator",
    "DefectError",
    "Document",
    "FileError",
    "InputError",
    "LinkError",
    "NotPassedWarning",
    "ProtocolError",
    "Record",
    "RefusedError",
    "Run",
    "UsageError",
    "budget",
    "connect",
    "convert",
    "export_lake",
    "gap",
    "identify",
    "linking",
    "phase",
    "risk",
    "sensitivity",
    "verb",
]
