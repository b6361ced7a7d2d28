"""A Spark session: a cluster by its URL, or one on this computer that talks on the loopback alone."""

import os
import sys


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
