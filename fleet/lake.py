"""The tables of a lake as views of an engine; the same SQL then runs on each."""

from pathlib import Path

TABLES = ("records", "points", "settings", "budgets", "checks")
#: Columns that are folders: a laboratory called 12 is no number.
FOLDERS = {"laboratory": "VARCHAR", "instrument": "VARCHAR", "year": "BIGINT"}
SQL = Path(__file__).parent / "sql"


def query(name):
    """The text of a question of the fleet."""
    return (SQL / f"{name}.sql").read_text(encoding="utf-8")


def questions():
    """Names of all of them."""
    return sorted(path.stem for path in SQL.glob("*.sql"))


def shared():
    """Views that several questions ask: name and text."""
    return [(path.stem, path.read_text(encoding="utf-8")) for path in sorted((SQL / "views").glob("*.sql"))]


def duckdb_views(connection, lake):
    """Views over a lake, for DuckDB."""
    folders = ", ".join(f"'{name}': {kind}" for name, kind in FOLDERS.items())
    for table in TABLES:
        files = f"{Path(lake)}/{table}/**/*.parquet".replace("'", "''")
        connection.execute(
            f"CREATE OR REPLACE VIEW {table} AS SELECT *, epoch_ms(time) / 1000.0 AS time_s FROM read_parquet("
            f"'{files}', hive_types = {{{folders}}}, union_by_name = true)"
        )
    for name, text in shared():
        connection.execute(f"CREATE OR REPLACE VIEW {name} AS {text}")
    return connection


def spark_views(spark, lake):
    """Views over a lake, for Spark."""
    spark.conf.set("spark.sql.sources.partitionColumnTypeInference.enabled", "false")
    for table in TABLES:
        frame = spark.read.option("mergeSchema", "true").parquet(f"{lake}/{table}")
        frame = frame.withColumn("year", frame["year"].cast("bigint"))
        frame.selectExpr("*", "unix_millis(time) / 1000.0D AS time_s").createOrReplaceTempView(table)
    for name, text in shared():
        spark.sql(text).createOrReplaceTempView(name)
    return spark
