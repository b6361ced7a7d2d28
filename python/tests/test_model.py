"""Your own model as the belief: three simulations that are not ours."""

import math

import numpy
import pytest
import sealed

import calib


@pytest.mark.parametrize("name", ["state_space", "fmu", "table"])
def test_a_planted_effect_is_found_on_top_of_a_foreign_model(name, place):
    true, model = sealed.fmu(place) if name == "fmu" else getattr(sealed, name)()
    score = sealed.sealed(true, model, place, cases=6, seed=11)
    found, null = score["visible"]["strata"]["single"], score["strata"]["null"]
    # Of six with 95 % each, four or more are found with a probability of 0.998; of six with 1 %, one alarms at most
    # with 0.998.
    assert found["top_1"]["count"] >= found["top_1"]["of"] - 2, score
    assert null["false_alarm"]["count"] <= 1, score


def test_without_the_model_it_is_a_gap(place):
    true, _ = sealed.state_space()
    score = sealed.sealed(true, lambda f, c: numpy.ones(len(f)), place, cases=2, seed=11, strata=["null"])
    assert score["strata"]["null"]["false_alarm"]["count"] == 2


def test_a_response_in_time_is_that_of_theory():
    import scipy.signal

    w0 = 2 * math.pi * sealed.RESONANCE_HZ
    system = scipy.signal.StateSpace([[0, w0], [-w0, -2 * sealed.DAMPING * w0]], [[0], [w0]], [[1, 0]], [[0]])
    model = calib.gap.from_time_domain(lambda t, u: scipy.signal.lsim(system, u, t)[1], samples_a_cycle=256)
    f = numpy.array([100.0, 1000.0, 10e3])
    expected = w0**2 / (w0**2 - (2 * math.pi * f) ** 2 + 2j * sealed.DAMPING * w0 * 2 * math.pi * f)
    # Straight lines between 256 samples a cycle: their fundamental is low by (pi / 256)^2 / 3 = 5e-5.
    assert numpy.allclose(model(f, {}), expected, rtol=1e-4)


def test_an_fmu_responds_as_its_formula(place):
    true, model = sealed.fmu(place)
    f = numpy.array([200.0, 2000.0, 10e3])
    # Its resonance has died away to exp(-0.05 * 2 pi * 32e3 * 1.4e-3) = 8e-7; what is beyond 1 / step, and read as
    # if it were below, is (32e3 / 2.5e6)^2 * 60e3 / 2.5e6 = 4e-6.
    assert numpy.allclose(model(f, {}), true(f), rtol=1e-5)


def test_an_fmu_that_is_not_at_rest_is_refused(place):
    sealed.fmu(place)
    asked = dict(input="acceleration", output="voltage", step_s=1e-6)
    with pytest.raises(calib.UsageError, match="at rest"):
        calib.gap.from_fmu(place / "Accelerometer.fmu", duration_s=1e-4, **asked)


@pytest.mark.parametrize(
    "model, match",
    [
        (lambda f, c: numpy.full(len(f), math.nan), "nan at 5.0 Hz, row 1|nan"),
        (lambda f, c: numpy.zeros(len(f)), "row 1"),
        (lambda f, c: numpy.ones(3), "shape"),
        (lambda f, c: ["a"] * len(f), "gave"),
        (lambda f, c: None, "gave"),
        (calib.gap.from_table([100.0, 200.0], [1.0, 1.0]), "row 1"),
        (calib.gap.from_time_domain(lambda t, u: u[:5]), "5 values"),
    ],
)
def test_a_model_that_says_nonsense_is_refused_with_the_place(model, match, place):
    data = calib.gap.simulate("standard", out="d", columns="ratio")
    with pytest.raises(calib.UsageError, match=match) as caught:
        calib.gap.diagnose(data, model=model)
    assert caught.value.hint


def test_an_exception_of_a_model_is_its_own(place):
    data = calib.gap.simulate("standard", out="d", columns="ratio")

    def model(frequencies, conditions):
        assert set(conditions) >= {"acceleration_ms2"} and len(conditions["acceleration_ms2"]) == len(frequencies)
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        calib.gap.diagnose(data, model=model)
