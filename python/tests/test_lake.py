"""Exported tables are read by pandas, polars and DuckDB, and asked by every question of the fleet."""

import sys
from pathlib import Path

import duckdb
import pandas
import polars
import pytest

import calib

sys.path.insert(0, str(Path(__file__).parents[2] / "fleet"))
import bench
import lake
import make_lake


@pytest.fixture
def exported(measured, place):
    """A lake of one record, added through the package by a laboratory whose name looks like a number."""
    _, run = measured
    run.record.save("r.calibrec")
    (added,) = calib.verb("logbook", "add", "r.calibrec")
    done = calib.export_lake("lake", laboratory="12")
    assert done.records == 1 and len(done.files) == 5, added
    assert calib.export_lake("lake", laboratory="12").records == 0
    return run.record


def test_a_point_is_the_same_in_every_reader(exported):
    wanted = [point.sensitivity_v_per_ms2 for point in exported.points]
    by_pandas = pandas.read_parquet("lake/points").sort_values("position")
    by_polars = polars.read_parquet("lake/points/**/*.parquet", hive_partitioning=True).sort("position")
    by_duckdb = duckdb.sql("from read_parquet('lake/points/**/*.parquet', hive_partitioning = true) order by position").df()
    for table in (by_pandas, by_polars.to_pandas(), by_duckdb):
        # A record keeps S as f32, which the document states in its shortest digits.
        assert table.sensitivity_v_per_ms2.tolist() == pytest.approx(wanted, rel=1e-7)
        assert len(table) == 2


def test_a_certificates_table_is_read_by_pandas(exported, place):
    (file,) = exported.certificate("out", format="csv", logbook="none.sqlite")
    found = pandas.read_csv(file, comment="#")
    assert len(found) >= 2


def test_every_question_is_answered_of_a_real_lake(exported):
    asked = lake.duckdb_views(duckdb.connect(), "lake")
    state = asked.sql(lake.query("state")).df()
    assert list(state.records) == [1] and state.due_s.isna().all()
    assert list(state.laboratory) == ["12"]
    for question in lake.questions():
        asked.sql(lake.query(question)).fetchall()


def test_made_lakes_have_the_columns_of_real_ones(exported, place):
    make_lake.make("made", 200)
    # A laboratory may be called 12, which is a name.
    described = "describe from read_parquet('{}/{}/**/*.parquet', hive_types_autocast = false)"
    for table in lake.TABLES:
        if table == "checks":
            continue
        names = [
            {row[0]: row[1] for row in duckdb.sql(described.format(which, table)).fetchall()}
            for which in ("lake", "made")
        ]
        assert names[0] == names[1], table


def test_truth_is_found_in_a_lake_that_was_drawn(place):
    truth = make_lake.make("made", 5000)
    asked = lake.duckdb_views(duckdb.connect(), "made")
    rows = asked.sql(lake.query("drift")).df()
    rows = rows[rows.dut_serial.str.startswith("D-") & (rows.results >= 10)]
    # A device measured by a biased instrument of its own has its drift all the same: biases do not move.
    off = [row.drift_rel_per_year - truth["drift_rel_per_year"][row.dut_serial] for row in rows.itertuples()]
    # The reference of the one instrument it is measured with drifts by 1e-3 a year, r.m.s.: what is left.
    assert (sum(one**2 for one in off) / len(off)) ** 0.5 < 3e-3 and len(off) > 10


def test_references_drift_the_other_way_than_their_standards_show(place):
    truth = make_lake.make("made", 5000)
    rows = lake.duckdb_views(duckdb.connect(), "made").sql(lake.query("reference_drift")).df()
    off = [
        (row.drift_rel_per_year - truth["reference_drift_rel_per_year"][row.instrument_serial])
        / row.standard_uncertainty_rel_per_year
        for row in rows.itertuples()
    ]
    assert len(off) >= 6 and max(map(abs, off)) < 5
    drifts = rows.drift_rel_per_year.abs() > 5 * rows.standard_uncertainty_rel_per_year
    assert drifts.any()


def test_rows_are_compared_as_they_are():
    assert bench.differing([(1, "a", 1.0)], [(1, "a", 1.0 + 1e-12)]) == 0
    assert bench.differing([(1, "a", 1.0)], [(1, "a", 1.0 + 1e-3)]) == 1
    assert bench.differing([(1, "b", 1.0)], [(1, "a", 1.0)]) == 1
    assert bench.differing([(1, None)], []) == 1
