"""Sealed sets on top of simulations that are not ours.

    python sealed.py [--cases 100] [--json OUT]

Each case of `calib gap challenge` is what a rig of the library would show. With the response of a foreign simulation in the
device, harmonics included, it is what a rig would show whose transducer is that simulation, with the effect on top. The diagnosis is told
the simulation, by another way than the cases were made where there is one, and the sealed truth is opened afterwards.
"""

import argparse
import hashlib
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
import scipy.signal

import calib

HERE = Path(__file__).parent
RESONANCE_HZ, DAMPING, CORNER_HZ, HIGH_PASS_HZ = 32e3, 0.05, 60e3, 0.2


def theory(frequencies):
    """The accelerometer by its formula: a damped resonance and a low-pass."""
    w, w0, corner = (2 * math.pi * numpy.asarray(one) for one in (frequencies, RESONANCE_HZ, CORNER_HZ))
    return w0**2 / (w0**2 - w**2 + 2j * DAMPING * w0 * w) * corner / (corner + 1j * w)


def state_space():
    """A scipy state space with a conditioner's high-pass: truth by its formula, belief by the matrices."""
    w0, corner, low = (2 * math.pi * one for one in (RESONANCE_HZ, CORNER_HZ, HIGH_PASS_HZ))
    parts = [
        scipy.signal.StateSpace([[0, w0], [-w0, -2 * DAMPING * w0]], [[0], [w0]], [[1, 0]], [[0]]),
        scipy.signal.StateSpace([[-corner]], [[corner]], [[1]], [[0]]),
        scipy.signal.StateSpace([[-low]], [[low]], [[-1]], [[1]]),
    ]

    def response(part, frequency_hz):
        turned = 2j * math.pi * frequency_hz * numpy.eye(len(part.A)) - part.A
        return (part.C @ numpy.linalg.solve(turned, part.B) + part.D).item()

    def model(frequencies, conditions):
        return numpy.array([math.prod((response(part, f) for part in parts), start=1.0) for f in frequencies])

    def true(frequencies):
        w = 2j * math.pi * numpy.asarray(frequencies)
        return theory(frequencies) * w / (w + low)

    return true, model


def fmu(folder):
    """An FMU of pythonfmu, simulated in time by FMPy; truth by the formula it was made from."""
    build = [str(Path(sys.executable).parent / "pythonfmu"), "build", "-f", str(HERE / "models/accelerometer.py")]
    subprocess.run([*build, "-d", str(folder)], check=True, stdout=subprocess.DEVNULL)
    step = {"step_s": 4e-7, "duration_s": 1.4e-3}
    return theory, calib.gap.from_fmu(folder / "Accelerometer.fmu", input="acceleration", output="voltage", **step)


def table():
    """A table of 400 responses, as somebody's finite elements print one: three modes, read between its lines."""
    lines = numpy.geomspace(1.0, 30e3, 400)

    def true(frequencies):
        f = numpy.asarray(frequencies)
        modes = [(0.9, 45e3, 0.02), (0.07, 61e3, 0.03), (0.03, 80e3, 0.05)]
        return sum(share / (1 - (f / at) ** 2 + 2j * damping * f / at) for share, at, damping in modes)

    return true, calib.gap.from_table(lines, true(lines))


def sealed(true, model, folder, cases, seed, strata=("null", "single")):
    """The score of a sealed set on top of a foreign simulation."""
    calib.gap.challenge(folder / "set", cases=cases, seed=seed, strata=strata)
    manifest = json.loads((folder / "set" / "challenge.json").read_text("utf-8"))
    answers = [answered(folder / "set" / case["name"], case.get("without", []), true, model) for case in manifest["cases"]]
    return calib.gap.score(answers, folder / "set-truth.json")


def answered(case, without, true, model):
    """The answer for a case whose transducer is the foreign simulation."""
    points, rig = (case / "points.csv").read_bytes(), (case / "rig.toml").read_bytes()
    seen = shown(calib._tables.read_csv(case / "points.csv"), true)
    answer = calib.gap.diagnose(seen, rig=case / "rig.toml", model=model, without=without)
    # The sealed truth knows the case as it was sealed.
    answer["dataset"]["sha256"] = hashlib.sha256(rig + points).hexdigest()
    return answer


def shown(columns, true):
    """A table as a device with this response shows it: each order of its wave by the response at its frequency. What is
    above the fifth order, in `dut_noise_v`, no table has: that column stays."""
    f = numpy.array(columns["frequency_hz"])
    first = true(f)
    for name in {"ratio", "dut_v"} & set(columns):
        columns[name] = product(columns[name], abs(first))
    if "dut_deg" in columns:
        columns["dut_deg"] = turned(columns["dut_deg"], first)
    for order in (2, 3, 4, 5):
        if f"dut_h{order}" in columns:
            columns[f"dut_h{order}"] = product(columns[f"dut_h{order}"], abs(true(order * f) / first))
            columns[f"dut_h{order}_deg"] = turned(columns[f"dut_h{order}_deg"], true(order * f) / first**order)
    return columns


def product(values, factors):
    return [None if one is None else one * float(factor) for one, factor in zip(values, factors)]


def turned(degrees, factors):
    return [None if one is None else one + float(by) for one, by in zip(degrees, numpy.degrees(numpy.angle(factors)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--json", type=Path)
    asked = parser.parse_args()
    report = {}
    for number, name in enumerate(("state space", "fmu", "table")):
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            true, model = {"state space": state_space, "fmu": lambda: fmu(folder), "table": table}[name]()
            score = sealed(true, model, folder, asked.cases, 100 + number)
        found, null = score["visible"]["strata"]["single"], score["strata"]["null"]
        report[name] = {"visible": found["cases"], "named": found["top_1"], "alarms": null["false_alarm"]}
        print(
            f"{name:<12} named {found['top_1']['count']} of {found['top_1']['of']} visible,"
            f" alarms {null['false_alarm']['count']} of {null['false_alarm']['of']}",
            flush=True,
        )
    if asked.json:
        asked.json.parent.mkdir(parents=True, exist_ok=True)
        asked.json.write_text(json.dumps(report, indent=2), encoding="utf-8")


if __name__ == "__main__":
    main()
