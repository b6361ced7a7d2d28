"""Figures of the fleet: questions and diagnoses on Spark with 1 and 2 executors, beside DuckDB and the plain tool.

    bench.py [--records 2000 20000 100000 1000000] [--datasets 10000] [--json OUT]
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import cluster
import diagnose
import lake as tables
import make_lake

#: Largest relative difference of two engines: sums in another order.
AGREES_REL = 1e-7
#: Cores, threads or executors that each way is tried with.
CORES = (1, 2)


def timed(work):
    """Seconds, and what came of it."""
    begun = time.monotonic()
    done = work()
    return time.monotonic() - begun, done


def by_duckdb(place, threads):
    """Every question by DuckDB: seconds to start, and seconds and rows of each by name."""
    import duckdb

    started, connection = timed(lambda: tables.duckdb_views(duckdb.connect(config={"threads": threads}), place))
    ask = lambda name: connection.execute(tables.query(name)).fetchall()
    return started, {name: timed(lambda name=name: ask(name)) for name in tables.questions()}


def by_spark(place, executors):
    """The rows by Spark; the time of its start includes that of the cluster."""
    started, spark = timed(lambda: tables.spark_views(cluster.session(executors), place))
    try:
        ask = lambda name: [tuple(row) for row in spark.sql(tables.query(name)).collect()]
        return started, {name: timed(lambda name=name: ask(name)) for name in tables.questions()}
    finally:
        spark.stop()


def differing(one, other):
    """Rows that are not the same."""
    if len(one) != len(other):
        return max(len(one), len(other))
    return sum(not all(map(same, a, b)) for a, b in zip(one, other))


def same(a, b):
    """Numbers to rounding, all else exactly."""
    if isinstance(a, float) and isinstance(b, (int, float)):
        return math.isclose(a, b, rel_tol=AGREES_REL, abs_tol=1e-12)
    return a == b


def questions(records):
    """Seconds from nothing to five answers by each way, and whether they are the same."""
    with tempfile.TemporaryDirectory() as name:
        place = Path(name) / "lake"
        took, truth = timed(lambda: make_lake.make(place, records))
        files = sum(1 for _ in place.rglob("*.parquet"))
        print(f"{records} records in {files} files, made in {took:.0f} s", flush=True)
        ways = {}
        for engine, ask in (("duckdb", by_duckdb), ("spark", by_spark)):
            for cores in CORES:
                started, answers = ask(place, cores)
                truth_rows = ways.setdefault("rows", {question: rows for question, (_, rows) in answers.items()})
                wrong = sum(differing(rows, truth_rows[question]) for question, (_, rows) in answers.items())
                asked = {question: round(took, 3) for question, (took, _) in answers.items()}
                ways[f"{engine} {cores}"] = {"start_s": round(started, 3), "questions_s": asked, "differing": wrong}
                print(f"  {engine:<6} {cores}: {started:6.2f} s to start, {sum(asked.values()):7.2f} s for {len(asked)}"
                      f" questions, {wrong} rows differ", flush=True)
        found = {row[0] for row in ways.pop("rows")["outliers"] if abs(row[4]) > 1 and row[1].startswith("CHECK")}
        return {"records": records, "files": files, "outliers_found": sorted(found) == truth["outliers"], **ways}


def from_nothing(way):
    """Seconds until every question is answered."""
    return way["start_s"] + sum(way["questions_s"].values())


def crossover(sizes):
    """Smallest lake of which Spark is asked sooner than DuckDB, each with the cores it likes best; None: not reached."""
    best = lambda size, engine: min(from_nothing(size[f"{engine} {cores}"]) for cores in CORES)
    return next((size["records"] for size in sizes if best(size, "spark") < best(size, "duckdb")), None)


#: What the measured side of a dataset has; none too. Effects that one sweep of ratio and phase can show.
CAUSES = ([], ["dut_resonance"], ["dut_highpass"], ["mount_compliance"], ["dut_frequency_slope"])


def sweep_of(seed):
    """A dataset as a row: one sweep, ratio and phase alone, so that ten thousand can be waited for."""
    import calib

    with tempfile.TemporaryDirectory() as name:
        place = Path(name) / f"{seed:06}"
        calib.gap.simulate("standard", CAUSES[seed % len(CAUSES)], out=place, seed=seed, columns="ratio")
        ((dataset, points, rig),) = diagnose.datasets([place])
    head, *lines = points.splitlines(keepends=True)
    return dataset, head + "".join(line for line in lines if line.startswith("0,")), rig


def rows_of(count):
    """So many datasets, each of its own seed."""
    return [sweep_of(seed) for seed in range(count)]


def put(rows, folder):
    """The datasets as folders, which the plain tool reads."""
    for name, points, rig in rows:
        place = folder / name
        place.mkdir(parents=True)
        (place / "points.csv").write_text(points, encoding="utf-8")
        (place / "rig.toml").write_text(rig, encoding="utf-8")


#: The plain tool in a process of its own, which has so many cores: `calib gap diagnose FOLDER --json`.
PLAIN = "import calib, json, sys; json.dump(calib.gap.diagnose(sorted(sys.argv[1:])), sys.stdout)"


def by_plain(rows, cores):
    """Seconds, and answers in the order of their names, by one call of the plain tool."""
    with tempfile.TemporaryDirectory() as name:
        put(rows, Path(name))
        call = [sys.executable, "-c", PLAIN, *(str(path) for path in Path(name).iterdir())]
        asked = {**os.environ, "RAYON_NUM_THREADS": str(cores)}
        took, done = timed(lambda: subprocess.run(call, env=asked, stdout=subprocess.PIPE, check=True))
    return took, [diagnose.row_of(row[0], answer) for row, answer in zip(rows, json.loads(done.stdout))]


def by_executors(rows, executors, kill=False):
    """The answers by `mapInPandas`, and the tasks that were lost; with `kill` an executor is killed on the way."""
    spark = cluster.session(executors)
    try:
        # The cluster is up, and its Pythons have loaded what they need.
        started, _ = timed(lambda: diagnose.on_spark(spark, rows[: 4 * executors]).collect())
        if kill:
            # That one is lost is no news.
            spark.sparkContext.setLogLevel("OFF")
            cluster.kill_in_mid_job(spark)
        took, found = timed(lambda: diagnose.on_spark(spark, rows).collect())
        return started, took, sorted(tuple(row) for row in found), cluster.lost_tasks(spark)
    finally:
        spark.stop()


def diagnoses(count):
    """Seconds for so many datasets by each way, and whether the answers are the same."""
    took, rows = timed(lambda: rows_of(count))
    print(f"{count} datasets of one sweep each, made in {took:.0f} s", flush=True)
    ways = {}
    for cores in CORES:
        plain, wanted = by_plain(rows, cores)
        ways[f"plain {cores}"] = {"s": round(plain, 2)}
        print(f"  plain {cores}: {plain:7.1f} s", flush=True)
        for kill in (False, True)[:cores]:
            started, took, found, lost = by_executors(rows, cores, kill)
            wrong = sum(a != b for a, b in zip(found, wanted)) + abs(len(found) - len(wanted))
            way = {"start_s": round(started, 2), "s": round(took, 2), "differing": wrong, "lost_tasks": lost}
            ways[f"spark {cores}{', one killed' if kill else ''}"] = way
            print(f"  spark {cores}: {took:7.1f} s, {took / plain:.2f} of plain, after {started:.1f} s to start;"
                  f" {wrong} answers differ, executors killed {len(lost)}", flush=True)
    return {"datasets": count, **ways}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--records", type=int, nargs="*", default=[2_000, 20_000, 100_000, 1_000_000])
    parser.add_argument("--datasets", type=int, default=10_000)
    parser.add_argument("--json", type=Path)
    asked = parser.parse_args()
    report = {"questions": [questions(records) for records in asked.records]}
    if report["questions"]:
        report["crossover_records"] = crossover(report["questions"])
        print("Spark is the sooner from", report["crossover_records"] or f"more than {max(asked.records)}", "records on")
    if asked.datasets:
        report["diagnosis"] = diagnoses(asked.datasets)
    if asked.json:
        asked.json.parent.mkdir(parents=True, exist_ok=True)
        asked.json.write_text(json.dumps(report, indent=2), encoding="utf-8")


if __name__ == "__main__":
    main()
