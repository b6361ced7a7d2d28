"""The notebooks, executed as they are; their numbers are those of the command line, and of the truth."""

import json
import subprocess
import sys
from pathlib import Path

import pandas
import pytest
from conftest import command_line

EXAMPLES = Path(__file__).parents[1] / "examples"


def executed(name, monkeypatch):
    """The names a notebook leaves, after every cell in order."""
    monkeypatch.syspath_prepend(str(EXAMPLES.parents[1]))
    space = {"__name__": "__main__"}
    for cell in json.loads((EXAMPLES / f"{name}.ipynb").read_text("utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{name}.ipynb", "exec"), space)
    return space


def test_every_notebook_is_executed_here():
    tested = {"budget", "drift", "first_calibration", "fleet_state", "gap", "own_model"}
    assert {path.stem for path in EXAMPLES.glob("*.ipynb")} == tested


def test_a_first_calibration(monkeypatch):
    space = executed("first_calibration", monkeypatch)
    space["run"].record.save("r.calibrec")
    said, _ = command_line("--json", "show", "r.calibrec")
    assert space["table"].sensitivity_v_per_ms2.tolist() == [point["sensitivity_v_per_ms2"] for point in said["points"]]
    assert all(file.is_file() for file in space["files"])


def test_a_budget(monkeypatch, place):
    space = executed("budget", monkeypatch)
    (place / "b.toml").write_text(
        'measurand = "sensitivity magnitude at 160 Hz"\ncoverage_factor = 2\n'
        '[[component]]\nlabel = "Reference"\nvalue = 0.5\ndistribution = "normal"\nk = 2\n'
        '[[component]]\nlabel = "Gain"\nvalue = 0.2\ndistribution = "rectangular"\n'
        '[[component]]\nlabel = "Transverse motion"\nvalue = 0.3\ndistribution = "special"\ndivisor = 4.24\n'
    )
    assert space["evaluated"] == command_line("--json", "budget", "b.toml")[0]
    grown = space["expanded_uncertainties"]
    assert grown == sorted(grown) and len(set(grown)) == 10


def test_a_gap(monkeypatch):
    space = executed("gap", monkeypatch)
    assert space["answer"] == command_line("--json", "gap", "diagnose", "dataset")[0]
    assert space["answer"].effects() == ["suspension_cubic"] and space["plan"].measurements


def test_a_model_of_ones_own(monkeypatch):
    space = executed("own_model", monkeypatch)
    assert space["answer"].effects() == ["mount_compliance"], space["answer"]
    assert space["answer"].verdict == "explained"
    assert space["plain"].effects() != ["mount_compliance"], "the model told nothing"


def test_a_drift_study(monkeypatch):
    space = executed("drift", monkeypatch)
    assert space["out"] == space["truth"]["outliers"]
    true = space["truth"]["reference_drift_rel_per_year"]
    rows = space["references"]
    off = [(row.drift_rel_per_year - true[row.instrument_serial]) / row.standard_uncertainty_rel_per_year for row in rows.itertuples()]
    # Normal deviates: their root mean square over ten instruments is below 2 with a probability of 0.99999.
    assert (sum(one**2 for one in off) / len(off)) ** 0.5 < 2


def test_the_state_of_a_fleet(monkeypatch):
    space = executed("fleet_state", monkeypatch)
    checks = pandas.read_parquet("state-lake/checks")
    last = checks.groupby("instrument_serial").time.max().dt.tz_convert("UTC")
    due = last + pandas.to_timedelta(checks.groupby("instrument_serial").every_days.first(), unit="D")
    state = space["state"].set_index("instrument_serial").loc[last.index]
    assert list(state.last_check) == list(last.dt.normalize()) and list(state.due) == list(due.dt.normalize()) and len(state) == 6
    late = due.index[due.dt.normalize() < space["today"]]
    assert set(space["overdue"].instrument_serial) == set(late) and len(late) >= 1
    records = pandas.read_parquet("state-lake/records").groupby("instrument_serial").size()
    assert list(state.records) == list(records)


@pytest.mark.parametrize("script", ["first.py"])
def test_the_script_of_the_readme(script, place):
    done = subprocess.run([sys.executable, EXAMPLES / script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "explained ['suspension_cubic']" in done.stdout
