"""Fixtures: a place of one's own for records and logbook, and the tool beside the package."""

import json
import os
import subprocess

import pytest

import calib


def move_to(folder, monkeypatch):
    """Nothing of this user is read or written."""
    for variable in ("CALIB_CONFIG", "CALIB_LABORATORY", "CALIB_OPERATOR", "CALIB_DEVICE", "CALIB_LABORATORY_KEY"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setenv("CALIB_STATE_DIR", str(folder / "state"))
    monkeypatch.setenv("CALIB_LOGBOOK", str(folder / "logbook.sqlite"))
    monkeypatch.setenv("HOME", str(folder))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(folder / "config"))
    monkeypatch.chdir(folder)


@pytest.fixture(autouse=True)
def place(tmp_path, monkeypatch):
    """A folder of the test's own, in which it works."""
    move_to(tmp_path, monkeypatch)
    return tmp_path


@pytest.fixture(scope="session")
def measured(tmp_path_factory):
    """A run on the emulated calibrator, measured once: what was heard on the way, and the run."""
    heard = []
    with pytest.MonkeyPatch.context() as patched:
        move_to(tmp_path_factory.mktemp("measured"), patched)
        with calib.connect("emulated") as instrument:
            run = instrument.run([80, (160, 5.0)], level=10.0, serial="SN1", model="demo", on_point=heard.append)
    return heard, run


def command_line(*words):
    """Output of the tool itself: its document, and its exit code."""
    done = subprocess.run([os.environ["CALIB_TOOL"], *map(str, words)], capture_output=True, text=True)
    return json.loads(done.stdout) if done.stdout.strip() else json.loads(done.stderr), done.returncode
