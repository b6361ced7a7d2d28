"""Figures of the fleet: questions and diagnoses on Spark with 1 and 2 executors, beside DuckDB and the plain package.

    bench.py [--records 100000] [--datasets 10000] [--json OUT]
"""

import argparse
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import cluster
import diagnose
import lake as tables
import make_lake

#: Largest relative difference of two engines: sums in another order.
AGREES_REL = 1e-7


def timed(work):
    """Seconds, and what came of it."""
    begun = time.monotonic()
    done = work()
    return time.monotonic() - begun, done


def by_duckdb(place, threads):
    """Every question by DuckDB: seconds and rows, by name."""
    import duckdb

    connection = tables.duckdb_views(duckdb.connect(config={"threads": threads}), place)
    return {name: timed(lambda name=name: connection.execute(tables.query(name)).fetchall()) for name in tables.questions()}


def by_spark(place, executors):
    """The same by Spark."""
    spark = cluster.session(executors)
    try:
        tables.spark_views(spark, place)
        ask = lambda name: [tuple(row) for row in spark.sql(tables.query(name)).collect()]
        return {name: timed(lambda name=name: ask(name)) for name in tables.questions()}
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


def rows_of(count):
    """So many datasets as rows: fifty of four causes and none, each of its own seed, as often as needed."""
    import calib

    causes = [[], ["suspension_cubic"], ["dut_drift"], ["coulomb_friction"], ["cable_capacitance"]]
    known = {effect["id"] for effect in calib.gap.effects()}
    causes = [cause for cause in causes if set(cause) <= known]
    with tempfile.TemporaryDirectory() as name:
        distinct = min(count, 50)
        folders = [
            calib.gap.simulate("standard", causes[n % len(causes)], out=Path(name) / str(n), seed=n, columns="ratio")
            for n in range(distinct)
        ]
        kept = diagnose.datasets(folders)
    # More than that are the same again: making them would take longer than diagnosing them.
    return [(f"{n:06}", kept[n % distinct][1], kept[n % distinct][2]) for n in range(count)]


def answers_by_spark(rows, executors, kill=False):
    """Answers by `mapInPandas`, in the order of their names; with `kill` an executor is killed on the way."""
    spark = cluster.session(executors)
    try:
        here = Path(__file__).parent / "diagnose.py"
        spark.sparkContext.addPyFile(str(here))
        frame = spark.createDataFrame(rows, "dataset string, points string, rig string").repartition(8 * executors)
        # The cluster is up, and its Pythons are.
        frame.limit(1).mapInPandas(diagnose.answered, diagnose.ANSWERS).collect()
        killer = threading.Timer(5.0, kill_an_executor) if kill else None
        if killer:
            killer.start()
        took, found = timed(lambda: frame.mapInPandas(diagnose.answered, diagnose.ANSWERS).collect())
        return took, sorted(tuple(row) for row in found)
    finally:
        spark.stop()


def kill_an_executor():
    """Kills one executor of this program's own cluster."""
    listed = subprocess.run(["ps", "-eo", "pid,ppid,args"], capture_output=True, text=True).stdout.splitlines()[1:]
    parents = {int(line.split()[0]): int(line.split()[1]) for line in listed}
    for line in listed:
        pid = int(line.split()[0])
        if "CoarseGrainedExecutorBackend" in line and is_below(pid, parents):
            os.kill(pid, signal.SIGKILL)
            print(f"killed executor {pid}", flush=True)
            return
    print("no executor to kill", flush=True)
    os.kill(os.getpid(), signal.SIGINT)


def is_below(pid, parents):
    """Whether a process was started by this one."""
    while pid > 1:
        if pid == os.getpid():
            return True
        pid = parents.get(pid, 0)
    return False


def one_core():
    """A worker of the plain package diagnoses on one core, as one of Spark does."""
    os.environ["RAYON_NUM_THREADS"] = "1"


def answers_plain(rows, processes):
    """The same answers by the plain package on so many cores."""
    def work():
        with ProcessPoolExecutor(processes, initializer=one_core) as pool:
            return list(pool.map(answer_row, rows, chunksize=16))

    took, found = timed(work)
    return took, sorted(found)


def answer_row(row):
    return diagnose.answer_of(*row)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--records", type=int, default=100_000)
    parser.add_argument("--datasets", type=int, default=10_000)
    parser.add_argument("--json", type=Path)
    asked = parser.parse_args()
    one_core()
    report = {"records": asked.records, "datasets": asked.datasets, "questions": {}, "diagnosis": {}}
    with tempfile.TemporaryDirectory() as name:
        place = Path(name) / "lake"
        took, truth = timed(lambda: make_lake.make(place, asked.records))
        print(f"lake of {asked.records} records made in {took:.1f} s")
        ways = {f"duckdb, {n} threads": by_duckdb(place, n) for n in (1, 2)}
        ways.update({f"spark, {n} executors": by_spark(place, n) for n in (1, 2)})
        plain = ways["duckdb, 2 threads"]
        for way, answers in ways.items():
            report["questions"][way] = {
                question: {"s": round(took, 3), "rows": len(rows), "differing": differing(rows, plain[question][1])}
                for question, (took, rows) in answers.items()
            }
            total = sum(took for took, _ in answers.values())
            wrong = sum(one["differing"] for one in report["questions"][way].values())
            print(f"{way:<22} {total:7.2f} s for {len(answers)} questions, {wrong} rows differ")
        found = sorted({row[0] for row in plain["outliers"][1] if abs(row[4]) > 1 and row[1].startswith("CHECK")})
        report["outliers"] = {"true": truth["outliers"], "found": found}
        print("outliers", truth["outliers"], "found", found)
    rows = rows_of(asked.datasets)
    plain = {n: answers_plain(rows, n) for n in (1, 2)}
    for n, (took, _) in plain.items():
        report["diagnosis"][f"plain, {n} processes"] = {"s": round(took, 2)}
        print(f"plain, {n} processes    {took:8.1f} s for {asked.datasets} datasets")
    for way, executors, kill in (("1 executors", 1, False), ("2 executors", 2, False), ("2 executors, one killed", 2, True)):
        took, found = answers_by_spark(rows, executors, kill)
        wrong = sum(a != b for a, b in zip(found, plain[2][1])) + abs(len(found) - len(rows))
        report["diagnosis"][f"spark, {way}"] = {"s": round(took, 2), "differing": wrong}
        print(f"spark, {way:<24} {took:8.1f} s, {wrong} answers differ")
    if asked.json:
        asked.json.parent.mkdir(parents=True, exist_ok=True)
        asked.json.write_text(json.dumps(report, indent=2), encoding="utf-8")


if __name__ == "__main__":
    main()
