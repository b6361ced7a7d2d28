"""What is wrong is an exception that says what, where and the way out; nothing ends the interpreter."""

import pickle

import numpy
import pytest

import calib

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
        lambda: calib.link(),
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
    ],
)
def test_misuse_is_an_exception_with_the_way_out(call):
    with pytest.raises(calib.CalibError) as caught:
        call()
    assert caught.value.hint, caught.value
    assert not isinstance(caught.value, calib.DefectError), caught.value


def test_an_exception_crosses_processes_whole():
    with pytest.raises(calib.UsageError) as caught:
        calib.risk(0.5)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (type(again), again.hint, again.exit_code) == (calib.UsageError, caught.value.hint, 2)
    assert isinstance(again, ValueError)
