"""The calibrator: the shipping firmware on the emulated board, in this process and at an address."""

import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import zlib

import numpy
import pandas
import pytest
import xarray
from conftest import command_line, move_to

import calib
from calib.calibrator import _list_of


def test_a_run_is_heard_point_by_point_and_is_a_record(measured):
    heard, run = measured
    assert [point.frequency_hz for point in heard] == [80.0, 160.0]
    assert isinstance(run, calib.Run) and run.state == "finished" and run.record.points == run.record.document["points"]
    # The emulated rig has 10 mV/(m/s2); U is stated, k = 2, and is far from the 5 % allowed here.
    for point, level in zip(run.points, (10.0, 5.0)):
        assert point.state == "valid"
        assert point.sensitivity_v_per_ms2 == pytest.approx(0.01, rel=0.05)
        assert point.acceleration_rms_ms2 == pytest.approx(level, rel=0.02)


def test_a_run_takes_points_level_and_sensor_in_this_order(place):
    calib.verb("sensors", "add", serial="LW7", model="353B03")
    with calib.connect("emulated") as instrument:
        run = instrument.run([160], 5.0, "LW7")
    (point,) = run.points
    assert point.acceleration_rms_ms2 == pytest.approx(5.0, rel=0.02)
    assert "LW7" in str(run.record.document)


@pytest.mark.parametrize("form", ["pairs", "array", "pandas", "dictionary"])
def test_points_may_be_any_table(form, place):
    points = {"frequency_hz": [80.0, 160.0], "acceleration_rms_ms2": [5.0, 10.0]}
    given = {"pairs": list(zip(*points.values())), "array": numpy.array(list(points.values())).T,
             "pandas": pandas.DataFrame(points), "dictionary": points}[form]
    assert _list_of(given, place).read_text() == "frequency_hz,acceleration_rms_ms2\n80.0,5.0\n160.0,10.0\n"


def test_a_record_is_a_table_with_units(measured):
    _, run = measured
    record = run.record
    frame = record.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.frequency_hz) == [80.0, 160.0]
    assert frame.sensitivity_v_per_ms2.dtype == float and frame.state.tolist() == ["valid", "valid"]
    assert frame.inverted.dtype == bool
    data = record.to_xarray()
    assert isinstance(data, xarray.Dataset) and data.sensitivity_v_per_ms2.dims == ("point",)
    assert numpy.array_equal(data.sensitivity_v_per_ms2.values, frame.sensitivity_v_per_ms2.values)
    arrays = record.to_numpy()
    assert list(arrays) == list(record.columns()) == list(frame) and arrays["inverted"].dtype == bool
    assert arrays["sensitivity_v_per_ms2"].tolist() == [point.sensitivity_v_per_ms2 for point in record.points]
    with_units = [name for name in frame if re.search(r"_(hz|ms2|v|deg|rel|db|s|c)$|_per_", name)]
    assert len(with_units) > 20, list(frame)


def test_a_record_is_what_the_command_line_shows(measured, place):
    _, run = measured
    run.record.save("r.calibrec")
    assert command_line("--json", "show", "r.calibrec") == (dict(run.record.document), 0)
    assert calib.Record("r.calibrec") == run.record == calib.Record(run.record.bytes)
    assert run.record.plot().startswith("<svg") and "valid" in run.record._repr_html_()


def test_a_certificate_is_written_once_and_entered(measured, place):
    _, run = measured
    files = run.record.certificate("out", format=["json", "uff"])
    assert sorted(file.suffix for file in files) == [".json", ".uff"] and all(file.is_file() for file in files)
    run.record.save("r.calibrec")
    calib.verb("logbook", "add", "r.calibrec")
    run.record.certificate("entered", format=["json", "csv"])
    issued = calib.verb("logbook", "certificates")
    assert sorted(one.format for one in issued) == ["csv", "json"]
    (kept,) = calib.verb("logbook", "records")
    assert calib.Record.of_logbook(kept.record_id) == run.record


def test_a_certificate_in_the_universal_file_format_is_read_by_pyuff(measured, place):
    import pyuff

    _, run = measured
    (file,) = run.record.certificate("out", format="uff")
    sets = pyuff.UFF(str(file)).read_sets()
    (response,) = [one for one in (sets if isinstance(sets, list) else [sets]) if one["type"] == 58]
    assert list(response["x"]) == pytest.approx([80.0, 160.0], rel=1e-6)
    # Twelve digits of a value that is an f32.
    wanted = [point.sensitivity_v_per_ms2 for point in run.record.points]
    assert list(abs(response["data"])) == pytest.approx(wanted, rel=1e-6)


def test_a_signature_is_verified_and_an_altered_record_refused(measured, place):
    _, run = measured
    with pytest.warns(calib.NotPassedWarning):
        # This instrument has no key.
        assert run.record.verify().proof == "not_signed"
    altered = bytearray(run.record.bytes)
    altered[len(altered) // 2] ^= 1
    with pytest.raises(calib.InputError, match="download"):
        calib.Record(bytes(altered))


def emulate(*options):
    """`calib emulate` on a port of this computer, once it answers: its address and its process."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    process = subprocess.Popen(
        [os.environ["CALIB_TOOL"], "--quiet", "emulate", "--tcp", str(port), *options], stdout=subprocess.DEVNULL
    )
    address, begun = f"tcp:127.0.0.1:{port}", time.monotonic()
    # It reads its flash while it starts, on a computer that runs other tests beside this one.
    while command_line("-d", address, "--json", "records")[1] != 0:
        assert process.poll() is None and time.monotonic() - begun < 30
        time.sleep(0.05)
    return address, process


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    """`calib emulate` on a port of this computer, for all tests that leave nothing in it but records."""
    with pytest.MonkeyPatch.context() as patched:
        move_to(tmp_path_factory.mktemp("served"), patched)
        address, process = emulate()
    yield address, process
    process.kill()
    process.wait()


def test_a_signed_record_is_proven_by_its_key_and_by_no_other(place):
    address, held = emulate("--hold-button", "--flash", "flash.bin")
    made, code = command_line("-d", address, "--json", "key", "--make")
    assert code == 0
    held.send_signal(signal.SIGINT)
    held.wait()
    address, process = emulate("--flash", "flash.bin")
    try:
        record = calib.connect(address).run([160.0]).record
    finally:
        process.kill()
        process.wait()
    assert record.verify(key=made["public_key"]).proof == "proven"
    with pytest.warns(calib.NotPassedWarning):
        assert record.verify(key="ab" * 32).proof != "proven"
    # Who mends the checksum of what he altered has no key to sign it with.
    altered = bytearray(record.bytes)
    altered[20] ^= 1
    altered[-4:] = zlib.crc32(bytes(altered[:-4])).to_bytes(4, "little")
    with pytest.warns(calib.NotPassedWarning):
        assert calib.Record(bytes(altered)).verify(key=made["public_key"]).proof == "altered"


def test_the_selftest_says_each_line_with_its_limits(served):
    report = calib.connect(served[0]).selftest()
    said, code = command_line("-d", served[0], "--json", "selftest")
    names = [(line.check, line.unit, line.lower, line.upper) for line in report.lines]
    assert names == [tuple(line[key] for key in ("check", "unit", "lower", "upper")) for line in said["lines"]]
    assert report.passed == (code == 0) and len(names) > 5
    for line in report.lines:
        within = [line.lower is None or line.lower <= line.value, line.upper is None or line.value <= line.upper]
        assert line.passed == all(within), line


def test_a_calibrator_at_an_address_is_stopped_from_another_thread(served):
    address, _ = served
    instrument = calib.connect(address)
    assert isinstance(instrument, calib.Calibrator) and instrument.settings()["reference"]
    first = threading.Event()
    stopper = threading.Thread(target=lambda: (first.wait(60), instrument.stop()))
    stopper.start()
    with pytest.warns(calib.NotPassedWarning, match="stopped after"):
        run = instrument.run([80, 160, 315, 630, 1250], on_point=lambda point: first.set())
    stopper.join()
    assert run.state == "stopped" and 1 <= len(run.points) < 5
    assert instrument.info().records >= 1 and instrument.record(run.record_id) == run.record


def test_a_change_of_settings_is_a_record_without_points():
    # The emulated calibrator is shipped with its reference, which was a change.
    instrument = calib.connect("emulated")
    (line,) = [line for line in instrument.records() if line.kind == "reference_change"]
    record = instrument.record(line.record_id)
    assert not record.is_calibration and record._repr_html_() is None and record.document.settings
    for asked in (record.to_pandas, record.to_numpy, record.columns, record.certificate, record.plot, lambda: record.points):
        with pytest.raises(calib.CalibError, match="change of settings"):
            asked()


def test_an_exception_on_the_way_stops_the_run(served):
    address, _ = served
    instrument = calib.connect(address)
    before = len(instrument.records())

    def no_more(point):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        instrument.run([80, 160, 315, 630, 1250], on_point=no_more)
    # It is stored, and the instrument is free.
    lines = instrument.records()
    assert len(lines) == before + 1 and 1 <= len(instrument.record(lines[-1].record_id).points) < 5


def test_a_calibrator_that_vanishes_is_a_link_error(place):
    """One that answers nothing, and one that hangs up."""
    door = socket.create_server(("127.0.0.1", 0))
    port = door.getsockname()[1]

    def hang_up():
        with door:
            for _ in range(3):
                connection, _ = door.accept()
                connection.recv(10)
                connection.close()

    threading.Thread(target=hang_up, daemon=True).start()
    with pytest.raises(calib.LinkError) as caught:
        calib.connect(f"tcp:127.0.0.1:{port}")
    assert caught.value.hint


INTERRUPTED = """
import calib, sys
instrument = calib.connect(sys.argv[1])
try:
    instrument.run([80, 160, 315, 630, 1250], on_point=lambda point: print("point", flush=True))
except KeyboardInterrupt:
    print("interrupted", [line.points for line in instrument.records()], flush=True)
"""


def test_ctrl_c_stops_the_run_and_stores_it(served):
    address, _ = served
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, address], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "point\n"
    process.send_signal(signal.SIGINT)
    rest, _ = process.communicate(timeout=60)
    last = rest.splitlines()[-1]
    assert last.startswith("interrupted [") and process.returncode == 0
    assert 1 <= int(re.findall(r"\d+", last)[-1]) < 5


LONG = """
import calib
try:
    print("begun", flush=True)
    calib.gap.challenge("set", cases=100_000, seed=1)
except KeyboardInterrupt:
    print("interrupted", len(calib.risk(4)), flush=True)
"""


def test_ctrl_c_ends_a_calculation_at_once(place):
    process = subprocess.Popen([sys.executable, "-c", LONG], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    # The rest of it would take hours, and is dropped with the interpreter.
    rest, _ = process.communicate(timeout=60)
    assert rest.startswith("interrupted ") and process.returncode == 0


def test_other_threads_go_on_while_a_verb_works(place):
    ticks, begun, done = [], threading.Event(), threading.Event()

    def tick():
        while not done.wait(0.005):
            ticks.append(None)
            begun.set()

    thread = threading.Thread(target=tick)
    thread.start()
    begun.wait()
    before = len(ticks)
    calib.gap.challenge("set", cases=3, seed=1)
    during = len(ticks) - before
    done.set()
    thread.join()
    # A verb that kept the interpreter's lock would let one tick in at each of its ends.
    assert during > 4, during
