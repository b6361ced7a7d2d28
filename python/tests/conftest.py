"""Fixtures: a place of one's own for records and logbook, and the tool beside the package."""

import json
import os
import subprocess

import pytest

import calib


@pytest.fixture(autouse=True)
def place(tmp_path, monkeypatch):
    """Nothing of this user is read or written."""
    for variable in ("CALIB_CONFIG", "CALIB_LABORATORY", "CALIB_OPERATOR", "CALIB_DEVICE", "CALIB_LABORATORY_KEY"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setenv("CALIB_STATE_DIR", str(tmp_path / "state"))
    monkeypatch.setenv("CALIB_LOGBOOK", str(tmp_path / "logbook.sqlite"))
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="session")
def measured(tmp_path_factory):
    """A run on the emulated calibrator, measured once: what was heard on the way, and the run."""
    folder = tmp_path_factory.mktemp("measured")
    before = {name: os.environ.get(name) for name in ("CALIB_STATE_DIR", "CALIB_LOGBOOK")}
    os.environ["CALIB_STATE_DIR"] = str(folder / "state")
    os.environ["CALIB_LOGBOOK"] = str(folder / "none.sqlite")
    try:
        heard = []
        with calib.connect("emulated") as instrument:
            run = instrument.run([80, (160, 5.0)], level=10.0, serial="SN1", model="demo", on_point=heard.append)
    finally:
        for name, value in before.items():
            os.environ.pop(name, None)
            if value is not None:
                os.environ[name] = value
    return heard, run


def command_line(*words):
    """What the tool itself says: its document, and its exit code."""
    done = subprocess.run([os.environ["CALIB_TOOL"], *map(str, words)], capture_output=True, text=True)
    return json.loads(done.stdout) if done.stdout.strip() else json.loads(done.stderr), done.returncode
