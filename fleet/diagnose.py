"""Thousands of gap datasets at once: each is a row that carries its table and its rig."""

import json

#: Columns of a dataset in a table: its name, the text of its `points.csv`, and that of its `rig.toml`.
DATASETS = "dataset string, points string, rig string"
#: Columns of an answer in a table; `answer` is the whole document.
ANSWERS = "dataset string, verdict string, cause string, probability double, summary string, answer string"
#: Tasks an executor's core is given of a job: what is lost with one is a small part of it.
TASKS_A_CORE = 8


def on_spark(spark, rows):
    """Answers of rows of DATASETS as a frame of Spark, with the columns ANSWERS."""
    spark.sparkContext.addPyFile(__file__)
    frame = spark.createDataFrame(rows, DATASETS)
    return frame.repartition(TASKS_A_CORE * spark.sparkContext.defaultParallelism).mapInPandas(answered, ANSWERS)


def answered(frames):
    """`mapInPandas`: rows of DATASETS become rows of ANSWERS."""
    import pandas

    for frame in frames:
        rows = [answer_of(row.dataset, row.points, row.rig) for row in frame.itertuples(index=False)]
        yield pandas.DataFrame(rows, columns=["dataset", "verdict", "cause", "probability", "summary", "answer"])


def answer_of(dataset, points, rig):
    """The answer for one dataset; an unusable one is an answer too, so that a job never ends for one row."""
    import tempfile
    from pathlib import Path

    import calib

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in (("points.csv", points), ("rig.toml", rig)):
            # A file that a table does not state is not there.
            if isinstance(text, str):
                (folder / file).write_text(text, encoding="utf-8")
        try:
            answer = calib.gap.diagnose(folder)
        except calib.CalibError as error:
            return dataset, "unusable", "", None, str(error).replace(name, str(dataset)), ""
    return row_of(dataset, answer)


def row_of(dataset, answer):
    """An answer as a row of ANSWERS."""
    # The folder it was in is gone.
    answer["dataset"]["path"] = dataset
    best = answer["causes"][0] if answer["causes"] else None
    cause = "+".join(best["effects"]) if best else ""
    return dataset, answer["verdict"], cause, best and best["probability"], answer["summary"], json.dumps(answer)


def datasets(folders):
    """Folders of datasets as rows of DATASETS."""
    from pathlib import Path

    return [
        (folder.name, (folder / "points.csv").read_text("utf-8"), (folder / "rig.toml").read_text("utf-8"))
        for folder in map(Path, folders)
    ]
