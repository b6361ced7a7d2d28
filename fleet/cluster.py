"""A Spark session: a cluster by its URL, or one on this computer that talks on the loopback alone."""

import os
import signal
import subprocess
import sys
import threading
import time


def session(executors=2, master=None, cores=1, memory_mib=1024, name="calib fleet"):
    """Spark on `master`, or on a cluster of so many executors of its own."""
    from pyspark.sql import SparkSession

    # Workers are this interpreter, in which `calib` is installed.
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
    os.environ.setdefault("PYSPARK_DRIVER_PYTHON", sys.executable)
    builder = SparkSession.builder.appName(name)
    if master is None:
        os.environ["SPARK_LOCAL_IP"] = "127.0.0.1"
        builder = (
            builder.master(f"local-cluster[{executors},{cores},{memory_mib}]")
            .config("spark.driver.host", "127.0.0.1")
            .config("spark.driver.bindAddress", "127.0.0.1")
            .config("spark.ui.enabled", "false")
            .config("spark.ui.showConsoleProgress", "false")
        )
    else:
        builder = builder.master(master)
    # Times are UTC everywhere; what one executor lost, another does again.
    builder = builder.config("spark.sql.session.timeZone", "UTC").config("spark.sql.shuffle.partitions", "8")
    builder = builder.config("spark.python.worker.reuse", "true")
    return builder.getOrCreate()


def kill_in_mid_job(spark):
    """Kills an executor of the session's own cluster, once a stage has done some of its tasks and has more to do than
    the executors have begun: whichever is killed loses a task. Watches from a thread of its own."""
    tracker = spark.sparkContext.statusTracker()
    driver = os.getpid()

    def in_the_middle():
        stages = (tracker.getStageInfo(stage) for stage in tracker.getActiveStageIds())
        return any(
            stage and stage.numCompletedTasks and stage.numTasks > stage.numCompletedTasks + stage.numActiveTasks
            for stage in stages
        )

    def watch():
        while not in_the_middle():
            time.sleep(0.02)
        os.kill(_executors_of(driver)[0], signal.SIGKILL)

    threading.Thread(target=watch, daemon=True).start()


def lost_tasks(spark):
    """Tasks that were lost with executors that are gone, an entry for each of these."""
    listed = spark.sparkContext._jsc.sc().statusStore().executorList(False)
    executors = [listed.apply(index) for index in range(listed.size())]
    return [executor.failedTasks() for executor in executors if not executor.isActive()]


def _executors_of(driver):
    """Processes of executors that descend from a driver."""
    # Their lines are long, and what tells them is at the end.
    listed = subprocess.run(["ps", "-eww", "-o", "pid,ppid,args"], capture_output=True, text=True, check=True).stdout
    lines = [line.split(None, 2) for line in listed.splitlines()[1:]]
    parents = {int(pid): int(parent) for pid, parent, *_ in lines}

    def descends(pid):
        while pid > 1 and pid != driver:
            pid = parents.get(pid, 0)
        return pid == driver

    return [int(pid) for pid, _, *words in lines if "CoarseGrainedExecutorBackend" in str(words) and descends(int(pid))]
