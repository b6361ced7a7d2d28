"""Your own simulation as what is believed.

The library believes in transducers without dynamics: the ratio of device and reference is the quotient of two
sensitivities. What another simulation knows better is divided out of the measured ratio before it is diagnosed, so that
an effect that is named is a correction to *that* simulation, as a factor on its response.
"""

import cmath
import json
import math
import os
import shutil
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Union

from .. import _calib, _tables
from ..errors import InputError, UsageError

#: Frequencies (Hz) and conditions by name, one value a row, to the complex ratio of device and reference.
Model = Callable[[Any, Mapping[str, Any]], Any]

#: Conditions a model is told, where the table has them.
_CONDITIONS = ("acceleration_ms2", "temperature_c", "payload_kg", "rotation_deg", "tilt_deg", "time_s", "coil_v")
#: Cycles played before a response is read, and while it is read.
_SETTLING_CYCLES, _READ_CYCLES = 20, 10
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
        start_values: of its parameters.
    """
    try:
        import fmpy
    except ImportError:
        raise UsageError("FMPy is not installed", "pip install calib[fmu]") from None
    import numpy

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
    logarithm of the frequency; beyond its ends it says nothing and is refused."""
    import numpy

    at = numpy.log(numpy.asarray(frequency_hz, dtype=float))
    values = numpy.asarray(response, dtype=complex)
    order = numpy.argsort(at)
    at, values = at[order], values[order]
    gain, turn = numpy.log(numpy.abs(values)), numpy.unwrap(numpy.angle(values))

    def model(frequencies: Any, conditions: Mapping[str, Any]) -> Any:
        wanted = numpy.log(numpy.asarray(frequencies, dtype=float))
        outside = (wanted < at[0] - 1e-9) | (wanted > at[-1] + 1e-9)
        found = numpy.exp(numpy.interp(wanted, at, gain) + 1j * numpy.interp(wanted, at, turn))
        return numpy.where(outside, complex("nan"), found)

    return model


def divided_out(folder: Path, model: Model, into: Path) -> Path:
    """The dataset with the response that the model knows divided out of its ratio, in a folder of its own."""
    points = folder / "points.csv"
    if not points.is_file():
        raise UsageError("model= is for points of a calibrator", "a record is diagnosed with the library's oscillator")
    table = _tables.read_csv(points)
    known = _responses(model, table)
    into.mkdir()
    shutil.copy(folder / "rig.toml", into / "rig.toml")
    _tables.write_csv(into / "points.csv", _corrected(table, known, _believed(into / "rig.toml")))
    return into


def _responses(model: Model, table: Mapping[str, List[Any]]) -> List[complex]:
    """What the model says of each row, checked."""
    frequencies = table.get("frequency_hz")
    if not frequencies or any(not isinstance(one, float) for one in frequencies):
        raise InputError("points.csv: column frequency_hz has no number in every row", "state each frequency in Hz", 6)
    import numpy

    conditions = {
        name: numpy.array([math.nan if one is None else one for one in table[name]], dtype=float)
        for name in _CONDITIONS
        if name in table
    }
    said = model(numpy.array(frequencies), conditions)
    values = numpy.asarray(said)
    if values.dtype.kind not in "fciu" or values.shape != (len(frequencies),):
        raise UsageError(
            f"the model gave {values.dtype} of shape {values.shape} for {len(frequencies)} rows",
            "return one complex ratio for each row",
        )
    for row, (value, frequency_hz) in enumerate(zip(values.tolist(), frequencies), start=1):
        if not cmath.isfinite(value) or value == 0:
            raise UsageError(
                f"the model gave {value} at {frequency_hz} Hz, row {row}",
                "return a finite ratio above zero, or leave rows out that it does not cover",
            )
    return [complex(value) for value in values.tolist()]


def _corrected(table: Dict[str, List[Any]], known: List[complex], believed: float) -> Dict[str, List[Any]]:
    """The table with the ratio over what is known of it."""
    corrected = dict(table)
    for name in ("ratio", "dut_v"):
        if name in table:
            rows = zip(table[name], known)
            corrected[name] = [None if one is None else one * believed / abs(value) for one, value in rows]
    if "dut_deg" in table:
        rows = zip(table["dut_deg"], known)
        corrected["dut_deg"] = [None if one is None else one - math.degrees(cmath.phase(value)) for one, value in rows]
    return corrected


def _believed(rig: Path) -> float:
    """The ratio the library believes in: the quotient of the two sensitivities of the rig, 1 where it states none."""
    stated = json.loads(_calib.json(rig.read_text(encoding="utf-8")))
    try:
        dut, reference = (stated[part]["sensitivity_v_per_ms2"]["value"] for part in ("dut", "reference"))
        return float(dut / reference)
    except (KeyError, TypeError, ZeroDivisionError):
        # What is not stated is free; what is stated wrongly, the diagnosis refuses.
        return 1.0


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
