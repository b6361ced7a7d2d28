"""The diagnosis: of folders, frames and sealed sets; the document of the command line."""

import html
import json
import os
import pickle
import tempfile

import pandas
import polars
import pytest
from conftest import command_line

import calib

CUBIC = "suspension_cubic=k3_n_per_m3:1e7"


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return calib.gap.simulate("standard", CUBIC, out=tmp_path_factory.mktemp("gap") / "cubic", seed=7)


def test_an_answer_is_that_of_the_command_line(dataset):
    answer = calib.gap.diagnose(dataset)
    said, code = command_line("--json", "gap", "diagnose", dataset)
    assert (answer, code) == (said, 0)
    assert answer.verdict == "explained" and answer.effects() == ["suspension_cubic"]
    found = answer.causes[0].parameters.suspension_cubic.k3_n_per_m3
    assert abs(found.value - 1e7) < 4 * found.standard_uncertainty
    assert "<html" in answer._page and "srcdoc" in answer._repr_html_()
    again = pickle.loads(pickle.dumps(answer))
    assert again == answer and again.effects() == answer.effects()


def test_a_frame_with_a_rig_is_the_same_dataset(dataset):
    # By default pandas reads a number to a digit or so.
    frame = pandas.read_csv(dataset / "points.csv", float_precision="round_trip")
    by_folder = calib.gap.diagnose(dataset, report="folder.html")
    for data in (frame, polars.read_csv(dataset / "points.csv"), dataset / "points.csv"):
        answer = calib.gap.diagnose(data, rig=dataset / "rig.toml")
        for key in ("verdict", "causes", "gap", "where"):
            assert answer[key] == by_folder[key], key
        # Under the name that was given, not that of a folder of the package's own.
        name = "table" if data is frame or isinstance(data, polars.DataFrame) else str(data)
        page = html.unescape(answer._page)
        assert answer.dataset.path == name and f'<p class="path">{name}</p>' in page
        assert os.path.join(tempfile.gettempdir(), "calib-") not in page
    assert open("folder.html").read() == by_folder.save_report("again.html").read_text("utf-8")
    assert "<html" in open("folder.html").read()
    (several,) = calib.gap.diagnose([dataset])
    with pytest.raises(calib.UsageError, match="several"):
        several.save_report("none.html")


def test_a_simulation_is_the_table_of_the_command_line(dataset):
    table = calib.gap.simulate("standard", CUBIC, seed=7)
    written = pandas.read_csv(dataset / "points.csv", float_precision="round_trip")
    assert pandas.DataFrame(table).astype(float).equals(written.astype(float))


def test_plan_and_effects_are_those_of_the_command_line():
    table = calib.gap.simulate("standard", "dut_drift", seed=3, columns="ratio", out="dd")
    assert calib.gap.plan("dd", most=4) == command_line("--json", "gap", "plan", table, "--most", 4)[0]
    assert calib.gap.effects() == command_line("--json", "gap", "effects")[0]
    assert calib.gap.effects("dut_drift") == command_line("--json", "gap", "effects", "dut_drift")[0]


def test_a_sealed_set_is_answered_and_scored(place):
    calib.gap.challenge("set", cases=1, seed=4, strata=["single", "null"])
    answers = calib.gap.diagnose(["set"])
    assert all("verdict" in one for one in answers)
    score = calib.gap.score(answers, "set-truth.json")
    (place / "a.jsonl").write_text("".join(json.dumps(one) + "\n" for one in answers))
    assert score == calib.gap.score("a.jsonl", "set-truth.json") == command_line(
        "--json", "gap", "score", "a.jsonl", "set-truth.json")[0]


@pytest.mark.parametrize("cause", ["corner_hz:45e3,bessel:0", "corner_hz:31e3,bessel:1", "corner_hz:80e3,bessel:1"])
def test_a_steep_filter_far_above_the_band_is_named(cause, place):
    # At 10 kHz the phase of Butterworth's at 45 kHz is bent by 11 of its u, and Bessel's at 80 kHz loses 25 u of the ratio.
    folder = calib.gap.simulate("standard", f"dut_lowpass_4={cause}", seed=3, out="steep")
    answer = calib.gap.diagnose(folder)
    assert answer.verdict == "explained" and answer.effects() == ["dut_lowpass_4"], answer
    found = answer.causes[0].parameters.dut_lowpass_4.corner_hz
    assert abs(found.value - float(cause.split(",")[0].split(":")[1])) < 4 * found.standard_uncertainty


def test_an_unusable_dataset_of_several_is_an_error_beside_answers(dataset, place):
    with pytest.raises(calib.InputError, match="1 of 2"):
        calib.gap.diagnose([dataset, place / "absent"])
