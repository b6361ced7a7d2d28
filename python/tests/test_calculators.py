"""Calculators: the numbers of the command line, to the last bit, from files, dictionaries, arrays and frames."""

import math

import numpy
import pandas
import polars
import pytest
from conftest import command_line

import calib

BUDGET = {
    "measurand": "sensitivity magnitude at 160 Hz",
    "coverage_factor": 2,
    "component": [
        {"label": "Reference", "value": 0.5, "distribution": "normal", "k": 2, "degrees_of_freedom": 9},
        {"label": "Gain", "value": 1 / 3, "distribution": "rectangular"},
    ],
    "correlation": [{"a": "Reference", "b": "Gain", "r": 0.5}],
}
TOML = """measurand = "sensitivity magnitude at 160 Hz"
coverage_factor = 2
[[component]]
label = "Reference"
value = 0.5
distribution = "normal"
k = 2
degrees_of_freedom = 9
[[component]]
label = "Gain"
value = 0.3333333333333333
distribution = "rectangular"
[[correlation]]
a = "Reference"
b = "Gain"
r = 0.5
"""


def test_a_budget_is_that_of_the_command_line(place):
    (place / "b.toml").write_text(TOML)
    said, code = command_line("--json", "budget", "b.toml")
    assert code == 0
    assert calib.budget(BUDGET) == calib.budget("b.toml") == said
    # Theory: a normal one over k, a rectangular one over sqrt(3), and their sum with r = 0.5.
    u1, u2 = 0.25, (1 / 3) / math.sqrt(3)
    combined_rel = math.sqrt(u1**2 + u2**2 + 2 * 0.5 * u1 * u2) / 100
    assert said["combined_standard_uncertainty"] == pytest.approx(combined_rel, rel=1e-12)


def test_a_monte_carlo_is_the_same_for_the_same_seed(place):
    (place / "b.toml").write_text(TOML)
    said, _ = command_line("--json", "budget", "b.toml", "--monte-carlo", "--seed", "5")
    assert calib.budget(BUDGET, monte_carlo=True, seed=5) == said


def points():
    """A resonance at 30 kHz with a damping of 0.02, by its formula."""
    f = numpy.array([100.0, 500.0, 1000.0, 2000.0, 5000.0, 8000.0, 10000.0])
    x = f / 30e3
    h = 0.01 / (1 - x**2 + 2j * 0.02 * x)
    return {"frequency_hz": f, "magnitude": abs(h), "phase_deg": numpy.degrees(numpy.angle(h)),
            "u_magnitude_percent": 0.1, "u_phase_deg": 0.1}


def test_arrays_frames_and_files_are_one_table(place):
    table = points()
    frame = pandas.DataFrame(table)
    frame.to_csv("p.csv", index=False)
    said, code = command_line("--json", "identify", "p.csv", "--trials", "1000")
    assert code == 0
    wanted = dict(trials=1000)
    for data in (table, frame, polars.DataFrame(frame.to_dict("list")), "p.csv", frame.to_records(index=False)):
        assert calib.identify(data, **wanted) == said
    assert said["f0_hz"] == pytest.approx(30e3, rel=1e-9) and said["delta"] == pytest.approx(0.02, rel=1e-9)


def test_phase_and_link_are_those_of_the_command_line(place):
    (place / "p.toml").write_text(
        "reference_deg = 1.0\nphasemeter_deg = 0.5\namplifier_deg = 0.3\n"
        "[[frequency]]\nfrequency_hz = 160.0\nphase_difference_deg = [-1.0, -1.2, -0.8]\nreference_phase_deg = 0.1\n"
    )
    said, _ = command_line("--json", "phase", "p.toml")
    frequency = [{"frequency_hz": 160.0, "phase_difference_deg": numpy.array([-1.0, -1.2, -0.8]), "reference_phase_deg": 0.1}]
    asked = {"reference_deg": 1.0, "phasemeter_deg": 0.5, "amplifier_deg": 0.3, "frequency": frequency}
    assert calib.phase(asked) == said
    table = {"laboratory": ["A", "B", "C"], "frequency_hz": 160.0,
             "degree_of_equivalence": [1e-5, -2e-5, 9e-5], "expanded_uncertainty": [5e-5, 5e-5, 5e-5]}
    pandas.DataFrame(table).to_csv("d.csv", index=False)
    said, _ = command_line("--json", "linking", "--doe", "d.csv")
    assert calib.linking(doe=table) == said


def test_conversions_and_risks_are_those_of_the_command_line():
    said, _ = command_line("--json", "convert", "--frequency", 160, "--sensitivity", 0.01, "--phase=-3.3")
    assert calib.convert(160.0, 0.01, -3.3) == said
    several = calib.convert(numpy.array([80.0, 160.0]), 0.01, -3.3)
    assert several[1] == said
    # S_v = S_a * omega; the core calculates in f32.
    velocity = [one for one in said["sensitivities"] if one["quantity"] == "velocity"][0]
    assert [v for v in velocity.values() if isinstance(v, float)][0] == pytest.approx(0.01 * 2 * math.pi * 160, rel=1e-7)
    said, _ = command_line("--json", "risk", "--ratio", 4)
    assert calib.risk(4) == said


def test_refused_readings_are_a_warning_and_a_result(place):
    table = {"frequency_hz": [80.0, 160.0], "dut_v": [0.1, 0.1], "reference_sensitivity_v": 0.01,
             "reference_before_v": [0.1, 0.1], "reference_after_v": [0.1, 0.2]}
    with pytest.warns(calib.NotPassedWarning, match="1 of 2"):
        said = calib.sensitivity(table)
    assert [point["sensitivity"] is None for point in said["points"]] == [False, True]
    pandas.DataFrame(table).to_csv("r.csv", index=False)
    assert command_line("--json", "sensitivity", "r.csv") == (said, 7)


def test_any_verb_can_be_asked():
    assert calib.verb("version")["tool_version"] == calib.__version__
    assert calib.verb("nomogram", frequency=160.0, acceleration=10.0) == command_line(
        "--json", "nomogram", "--frequency", 160, "--acceleration", 10)[0]
