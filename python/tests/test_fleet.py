"""The fleet on Spark: the rows of one computer, also beside an older lake and when an executor is killed on the way."""

import importlib.util
import os
import shutil
import sys
from pathlib import Path

import duckdb
import pytest

import calib

sys.path.insert(0, str(Path(__file__).parents[2] / "fleet"))
import bench
import cluster
import diagnose
import lake
import make_lake


@pytest.fixture(scope="module")
def spark():
    """A cluster of two executors on the loopback."""
    if shutil.which("java") is None or importlib.util.find_spec("pyspark") is None:
        assert "CI" not in os.environ, "Java or PySpark is missing"
        pytest.skip("the fleet on Spark is not tested: apt-get install default-jre-headless, pip install pyspark==4.*")
    # A minute of work is over before the second compiler of the JVM pays.
    os.environ.setdefault("JAVA_TOOL_OPTIONS", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC")
    session = cluster.session(2)
    session.sparkContext.setLogLevel("ERROR")
    yield session
    session.stop()


@pytest.fixture
def mixed(measured, place):
    """A lake of many laboratories, to which a real record was added by one whose name looks like a number, with the
    table of an older release beside it."""
    make_lake.make("lake", 1000)
    measured[1].record.save("r.calibrec")
    calib.verb("logbook", "add", "r.calibrec")
    assert calib.export_lake("lake", laboratory="12").records == 1
    old = place / "lake/records/laboratory=Old%20one%2F2/instrument=X/year=2020"
    old.mkdir(parents=True)
    duckdb.sql(f"COPY (SELECT 'aa' AS record_sha256, 'X' AS instrument_serial, 7::BIGINT AS record_id) TO '{old}/a.parquet'")
    return place / "lake"


def test_spark_gives_the_rows_of_duckdb(spark, mixed):
    lake.spark_views(spark, mixed)
    by_duckdb = lake.duckdb_views(duckdb.connect(), mixed)
    for question in lake.questions():
        wanted = by_duckdb.execute(lake.query(question)).fetchall()
        rows = [tuple(row) for row in spark.sql(lake.query(question)).collect()]
        assert len(rows) >= 6 and bench.differing(rows, wanted) == 0, question
    laboratories = {row[0] for row in by_duckdb.execute(lake.query("state")).fetchall()}
    assert {"12", "Old one/2"} < laboratories


def test_an_executor_killed_in_mid_job_changes_no_answer(spark):
    causes = ([], ["suspension_cubic=k3_n_per_m3:1e7"], ["dut_resonance"], ["mount_compliance"])
    folders = [calib.gap.simulate("standard", causes[n % 4], out=f"set/{n:02}", seed=n) for n in range(32)]
    rows = diagnose.datasets(folders)
    # A row that is no dataset has an answer too.
    rows += [("none", None, None), ("nonsense", "frequency_hz\n?\n", "[[["), ("empty", "", "")]
    cluster.kill_in_mid_job(spark)
    found = sorted(tuple(row) for row in diagnose.on_spark(spark, rows).collect())
    assert len(cluster.lost_tasks(spark)) == 1, "no executor was killed"
    assert found == sorted(diagnose.answer_of(*row) for row in rows)
    verdicts = {row[0]: row[1] for row in found}
    assert verdicts.pop("none") == verdicts.pop("nonsense") == verdicts.pop("empty") == "unusable"
    assert len(verdicts) == 32 and "unusable" not in verdicts.values()
