"""Your own simulation as what is believed.

The library believes in transducers without dynamics: the ratio of device and reference is the quotient of two
sensitivities. What another simulation knows better is divided out of what the device showed before it is diagnosed: ratio
and phase at the frequencies of the table, and the device's harmonics at two to five times these. So an effect that is
named is a correction to *that* simulation, as a factor on its response.
"""

import cmath
import math
import os
import shutil
import statistics
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Union

from .. import _tables
from ..errors import FileError, InputError, UsageError

#: Frequencies (Hz) and conditions by name, one value a row, to the complex ratio of device and reference, in any unit.
Model = Callable[[Any, Mapping[str, Any]], Any]

#: Conditions a model is told, where the table has them.
_CONDITIONS = ("acceleration_ms2", "temperature_c", "payload_kg", "rotation_deg", "tilt_deg", "time_s", "coil_v")
#: Cycles played before a response is read, and while it is read.
_SETTLING_CYCLES, _READ_CYCLES = 20, 10
#: Harmonics a table may have, and by how much dividing a response out may raise the noise of one.
_ORDERS, _NOISE_GROWS = (2, 3, 4, 5), 1.05
#: Largest change of an answer that is at rest, relative to its largest value.
_AT_REST = 1e-5


def from_time_domain(
    simulate: Callable[[Any, Any], Any],
    *,
    settling_s: float = 0.0,
    amplitude: float = 1.0,
    samples_a_cycle: int = 64,
) -> Model:
    """A model of responses out of one in time: a sine is played through it at each frequency.

    Args:
        simulate: ``f(t, input) -> output``: times in s, equally spaced from 0, and the input at them, as arrays.
        settling_s: how long the slowest of its transients takes to die away, s; at least 20 cycles are waited for.
        amplitude: peak of the sine that is played, in the unit of the input.
        samples_a_cycle: times at which it is played.
    """
    import numpy

    if not callable(simulate):
        raise UsageError(f"a {type(simulate).__name__} is no simulation", "give a function f(t, input) -> output")

    def response(frequency_hz: float) -> complex:
        cycles = max(_SETTLING_CYCLES, math.ceil(settling_s * frequency_hz)) + _READ_CYCLES
        t = numpy.arange(cycles * samples_a_cycle) / (frequency_hz * samples_a_cycle)
        turn = 2.0 * math.pi * frequency_hz * t
        output = numpy.asarray(simulate(t, amplitude * numpy.sin(turn)), dtype=float).reshape(-1)
        if output.shape != t.shape:
            raise UsageError(
                f"the model gave {output.size} values for {t.size} times", "return one output for each time"
            )
        read = slice(-_READ_CYCLES * samples_a_cycle, None)
        # Whole cycles: sine and cosine are orthogonal on them.
        turned = output[read] * numpy.exp(-1j * turn[read])
        return complex(2j * turned.mean() / amplitude)

    return _remembering(response)


def from_fmu(
    path: Union[str, "os.PathLike[str]"],
    *,
    input: str,
    output: str,
    step_s: float,
    duration_s: float,
    amplitude: float = 1.0,
    start_values: Optional[Mapping[str, float]] = None,
) -> Model:
    """A model of responses out of an FMU for co-simulation (FMI 2 or 3), simulated by FMPy: by its answer to a step.

    Its input is constant from the start, so it does not matter how the FMU continues one within a step. Of an FMU that
    is not linear it is the response to small signals, with ``amplitude`` for a small one. A part of the output that
    follows the input at once is late by half a step.

    Args:
        path: the ``.fmu``.
        input: name of its input, the quantity of the reference.
        output: name of its output, that of the device.
        step_s: step of its communication, s: a tenth of the period of its fastest resonance or less.
        duration_s: until its answer is at rest, s; refused if it is not.
        amplitude: of the step, in the unit of the input.
        start_values: of its parameters by name, each in the unit the FMU states.
    """
    try:
        import fmpy
    except ImportError:
        raise UsageError("FMPy is not installed", "pip install calib[fmu]") from None
    import numpy

    if not os.path.isfile(path):
        raise FileError(f"there is no FMU {os.fspath(path)}", "name the .fmu file")
    given = numpy.array([(0.0, amplitude), (duration_s, amplitude)], dtype=[("time", float), (input, float)])
    done = fmpy.simulate_fmu(
        os.fspath(path),
        stop_time=duration_s,
        step_size=step_s,
        output_interval=step_s,
        start_values=dict(start_values or {}),
        input=given,
        output=[output],
    )
    answer = numpy.asarray(done[output], dtype=float) / amplitude
    late = answer[len(answer) * 9 // 10 :]
    if numpy.ptp(late) > _AT_REST * numpy.abs(answer).max():
        raise UsageError(f"the FMU is not at rest after {duration_s} s", "give a longer duration_s")
    rises = numpy.diff(answer)
    middles = (numpy.arange(rises.size) + 0.5) * step_s

    def model(frequencies: Any, conditions: Mapping[str, Any]) -> Any:
        # Spectrum of the rises; that each is spread over a step is a known factor.
        return numpy.array(
            [
                rises @ numpy.exp(-2j * math.pi * one * middles) / numpy.sinc(one * step_s)
                for one in numpy.asarray(frequencies, dtype=float)
            ]
        )

    return model


def from_table(frequency_hz: Any, response: Any) -> Model:
    """A model that is a table of complex responses: between its lines logarithm and phase go straight over the
    logarithm of the frequency; beyond its ends it says nothing.

    Args:
        frequency_hz: of its lines, Hz, in any order.
        response: complex, one for each; in any unit.
    """
    import numpy

    lines = numpy.asarray(frequency_hz, dtype=float).reshape(-1)
    values = numpy.asarray(response, dtype=complex).reshape(-1)
    if not lines.size or lines.shape != values.shape:
        raise UsageError(
            f"the table has {lines.size} frequencies and {values.size} responses", "give one response for each frequency"
        )
    order = numpy.argsort(lines)
    lines, values = lines[order], values[order]
    if not (numpy.isfinite(lines).all() and lines[0] > 0 and (numpy.diff(lines) > 0).all()):
        raise UsageError("frequencies of the table are above zero and differ", "leave lines out that say the same twice")
    if not (numpy.isfinite(values).all() and values.all()):
        raise UsageError("a response of the table is zero or no number", "leave that line out")
    at = numpy.log(lines)
    gain, turn = numpy.log(numpy.abs(values)), numpy.unwrap(numpy.angle(values))

    def model(frequencies: Any, conditions: Mapping[str, Any]) -> Any:
        wanted = numpy.log(numpy.asarray(frequencies, dtype=float))
        outside = (wanted < at[0] - 1e-9) | (wanted > at[-1] + 1e-9)
        found = numpy.exp(numpy.interp(wanted, at, gain) + 1j * numpy.interp(wanted, at, turn))
        return numpy.where(outside, complex("nan"), found)

    return model


def divided_out(folder: Path, model: Model, into: Path) -> Path:
    """The dataset as a transducer without dynamics would have shown it, in a folder of its own."""
    points = folder / "points.csv"
    if not points.is_file():
        raise UsageError("model= is for points of a calibrator", "a record is diagnosed with the library's oscillator")
    table = _tables.read_csv(points)
    known = _responses(model, table)
    corrected = {**table, **_fundamentals(table, known)}
    for order in _ORDERS:
        if f"dut_h{order}" in table:
            corrected.update(_harmonics(table, known, model, order))
    # Harmonics of a kink beyond the fifth are in the noise, and how the transducer shapes it no table shows.
    corrected.pop("dut_noise_v", None)
    into.mkdir()
    shutil.copy(folder / "rig.toml", into / "rig.toml")
    _tables.write_csv(into / "points.csv", corrected)
    return into


def _responses(model: Model, table: Mapping[str, List[Any]]) -> List[complex]:
    """Predictions of the model for each row, checked."""
    frequencies = table.get("frequency_hz")
    if not frequencies or any(not isinstance(one, float) for one in frequencies):
        raise InputError("points.csv: column frequency_hz has no number in every row", "state each frequency in Hz", 6)
    values = _said(model, table, range(len(frequencies)))
    for row, (value, frequency_hz) in enumerate(zip(values, frequencies), start=1):
        if not _is_response(value):
            raise UsageError(
                f"the model gave {value} at {frequency_hz} Hz, row {row}",
                "return a finite ratio above zero, or leave rows out that it does not cover",
            )
    return values


def _said(model: Model, table: Mapping[str, List[Any]], rows: Sequence[int], order: int = 1) -> List[complex]:
    """Responses of the model at so many times the frequency of these rows: one complex number for each."""
    import numpy

    frequencies = numpy.array([order * table["frequency_hz"][row] for row in rows])
    conditions = {
        name: numpy.array([math.nan if table[name][row] is None else table[name][row] for row in rows], dtype=float)
        for name in _CONDITIONS
        if name in table
    }
    values = numpy.asarray(model(frequencies, conditions))
    if values.dtype.kind not in "fciu" or values.shape != frequencies.shape:
        raise UsageError(
            f"the model gave {values.dtype} of shape {values.shape} for {len(frequencies)} rows",
            "return one complex ratio for each row",
        )
    return [complex(value) for value in values.tolist()]


def _is_response(value: complex) -> bool:
    return cmath.isfinite(value) and value != 0


def _fundamentals(table: Mapping[str, List[Any]], known: List[complex]) -> Dict[str, List[Any]]:
    """Ratio and phase over what is known of them. The constant gain is the measurand: a model's says nothing."""
    corrected: Dict[str, List[Any]] = {}
    middle = statistics.median(map(abs, known))
    for name in ("ratio", "dut_v"):
        if name in table:
            rows = zip(table[name], known)
            corrected[name] = [None if one is None else one * middle / abs(value) for one, value in rows]
    if "dut_deg" in table:
        rows = zip(table["dut_deg"], known)
        corrected["dut_deg"] = [None if one is None else one - math.degrees(cmath.phase(value)) for one, value in rows]
    return corrected


def _harmonics(
    table: Mapping[str, List[Any]], known: List[complex], model: Model, order: int
) -> Dict[str, List[Any]]:
    """A harmonic of the device over what the model makes of it, relative to what it makes of the fundamental. It is
    left out where the model knows nothing at its frequency, or where its noise would grow."""
    name = f"dut_h{order}"
    sizes = list(table[name])
    phases = list(table.get(f"{name}_deg", [None] * len(sizes)))
    rows = [row for row, size in enumerate(sizes) if size is not None]
    for row, there in zip(rows, _said(model, table, rows, order) if rows else []):
        here = known[row]
        if not _is_response(there) or abs(there) * _NOISE_GROWS < abs(here):
            sizes[row] = phases[row] = None
            continue
        sizes[row] *= abs(here) / abs(there)
        if phases[row] is not None:
            phases[row] -= math.degrees(cmath.phase(there) - order * cmath.phase(here))
    return {name: sizes, f"{name}_deg": phases} if f"{name}_deg" in table else {name: sizes}


def _remembering(response: Callable[[float], complex]) -> Model:
    """Each frequency is asked for once, however many rows have it."""
    import numpy

    known: Dict[float, complex] = {}

    def model(frequencies: Any, conditions: Mapping[str, Any]) -> Any:
        for one in frequencies:
            if float(one) not in known:
                known[float(one)] = response(float(one))
        return numpy.array([known[float(one)] for one in frequencies])

    return model
