"""Wrong input is an exception that says what, where and the way out; nothing ends the interpreter."""

import math
import pickle

import numpy
import pytest

import calib

#: A sweep of a device that is flat.
SWEEP = {"frequency_hz": [20.0, 40.0, 80.0, 160.0], "ratio": 1.0, "u_ratio": 1e-3}

BAD_TABLES = [
    ({"frequency_hz": [float("nan")], "magnitude": [1.0]}, calib.InputError),
    ({"frequency_hz": [float("inf")] * 3, "magnitude": [1.0] * 3, "phase_deg": 0.0}, calib.InputError),
    ({"frequency_hz": [1.0, 2.0], "magnitude": [1.0, 2.0, 3.0]}, calib.UsageError),
    ({"frequency_hz": numpy.ones((2, 2)), "magnitude": 1.0}, calib.UsageError),
    ({"frequency_hz": [1j], "magnitude": [1.0]}, calib.UsageError),
    ({}, calib.InputError),
    (7, calib.UsageError),
    (None, calib.UsageError),
    ([1, 2], calib.UsageError),
    ("absent.csv", calib.FileError),
]


@pytest.mark.parametrize("table, expected", BAD_TABLES)
def test_a_table_that_is_none_is_refused(table, expected):
    with pytest.raises(expected) as caught:
        calib.identify(table)
    assert caught.value.hint and "calib-" not in str(caught.value), "a folder of ours is named"


def test_a_place_in_an_array_is_named():
    table = {"frequency_hz": [100.0, float("nan"), 300.0], "magnitude": 1.0, "phase_deg": 0.0}
    with pytest.raises(calib.InputError, match="points.csv.*3"):
        calib.identify(table)


@pytest.mark.parametrize(
    "call",
    [
        lambda: calib.budget({"measurand": "m", "component": [{"label": "a", "value": float("nan")}]}),
        lambda: calib.budget({"component": object()}),
        lambda: calib.budget(3),
        lambda: calib.budget("absent.toml"),
        lambda: calib.convert(-1.0, 0.01),
        lambda: calib.convert(float("nan"), 0.01),
        lambda: calib.convert(True, 0.01),
        lambda: calib.convert("160 Hz", 0.01),
        lambda: calib.risk(0.5),
        lambda: calib.risk(None),
        lambda: calib.linking(),
        lambda: calib.identify(),
        lambda: calib.verb("no-such-verb"),
        lambda: calib.verb("budget", no_such_option=3),
        lambda: calib.verb("convert", frequency=object(), sensitivity=1.0),
        lambda: calib.Record(b""),
        lambda: calib.Record(b"\x00" * 1000),
        lambda: calib.Record("absent.calibrec"),
        lambda: calib.Record(17),
        lambda: calib.gap.diagnose("absent"),
        lambda: calib.gap.diagnose({"frequency_hz": [1.0], "ratio": [float("nan")]}),
        lambda: calib.gap.diagnose({"frequency_hz": [100.0], "rati": [1.0]}),
        lambda: calib.gap.diagnose({}),
        lambda: calib.gap.diagnose([], model=lambda f, c: f),
        lambda: calib.gap.effects("no_such_effect"),
        lambda: calib.gap.simulate("standard", "no_such_effect"),
        lambda: calib.gap.simulate("standard", off_by=9.0),
        lambda: calib.gap.plan("absent"),
        lambda: calib.connect("tcp:127.0.0.1:1"),
        lambda: calib.connect("/dev/absent"),
        lambda: calib.connect(""),
        lambda: calib.export_lake("lake", laboratory="Lab"),
        lambda: calib.gap.diagnose([]),
        lambda: calib.gap.diagnose(SWEEP, model=3),
        lambda: calib.gap.diagnose(SWEEP, report="absent/report.html"),
        lambda: calib.gap.diagnose(SWEEP, without="no_such_effect"),
        lambda: calib.gap.effects(3),
        lambda: calib.gap.from_table([100.0, 200.0], [1.0]),
        lambda: calib.gap.from_table([0.0, 200.0], [1.0, 1.0]),
        lambda: calib.gap.from_table([100.0, 100.0], [1.0, 2.0]),
        lambda: calib.gap.from_table([100.0, 200.0], [1.0, math.nan]),
        lambda: calib.gap.from_table([], []),
        lambda: calib.gap.from_fmu("absent.fmu", input="a", output="b", step_s=1e-6, duration_s=1e-3),
        lambda: calib.gap.from_time_domain(3),
        lambda: calib.Record.of_logbook("first"),
        lambda: calib.verb("--help"),
        lambda: calib.connect("emulated").run([(80.0, 5.0, 1.0)]),
        lambda: calib.connect("emulated").record("first"),
    ],
)
def test_misuse_is_an_exception_with_the_way_out(call):
    with pytest.raises(calib.CalibError) as caught:
        call()
    assert caught.value.hint, caught.value
    assert not isinstance(caught.value, calib.DefectError), caught.value


CLASSES = [
    (1, calib.FileError, OSError),
    (2, calib.UsageError, ValueError),
    (3, calib.LinkError, ConnectionError),
    (4, calib.ProtocolError, ConnectionError),
    (5, calib.RefusedError, calib.CalibError),
    (6, calib.InputError, ValueError),
]


@pytest.mark.parametrize("exit_code, kind, also", CLASSES)
def test_each_exit_code_of_the_tool_is_a_class(exit_code, kind, also):
    error = calib.errors.of("what", "the way out", exit_code)
    assert type(error) is kind and isinstance(error, also) and "the way out" in str(error)


def test_what_the_calibrator_refuses_and_what_is_our_mistake_are_classes_of_their_own():
    with pytest.raises(calib.RefusedError, match="no record of this number"):
        calib.connect("emulated").record(9999)
    assert isinstance(calib.errors.of("a defect of calib: index 3 of 2", "report it", 1), calib.DefectError)


def test_an_exception_crosses_processes_whole():
    with pytest.raises(calib.UsageError) as caught:
        calib.risk(0.5)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (type(again), again.hint, again.exit_code) == (calib.UsageError, caught.value.hint, 2)
    assert isinstance(again, ValueError)


def test_an_effect_and_a_stratum_alone_are_taken_as_such(place):
    assert calib.gap.diagnose(SWEEP, without="dut_drift").effects() == []
    assert calib.gap.challenge("set", cases=2, seed=1, strata="null").cases == 2


def test_a_place_that_cannot_be_written_is_a_file_error(measured, place):
    answer = calib.gap.diagnose(SWEEP)
    for write in (answer.save_report, measured[1].record.save):
        with pytest.raises(calib.FileError) as caught:
            write("absent/file")
        assert caught.value.hint
