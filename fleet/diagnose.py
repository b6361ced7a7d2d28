"""Thousands of gap datasets at once: each is a row that carries its table and its rig."""

import json

#: Columns of an answer in a table; `answer` is the whole document.
ANSWERS = "dataset string, verdict string, cause string, probability double, summary string, answer string"


def answered(frames):
    """`mapInPandas`: rows of `dataset`, `points` (CSV), `rig` (TOML) become rows of ANSWERS."""
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
        (folder / "points.csv").write_text(points, encoding="utf-8")
        (folder / "rig.toml").write_text(rig, encoding="utf-8")
        try:
            answer = calib.gap.diagnose(folder)
        except calib.CalibError as error:
            return dataset, "unusable", "", None, str(error).replace(name, dataset), ""
    # The folder is ours and gone.
    answer["dataset"]["path"] = dataset
    best = answer["causes"][0] if answer["causes"] else None
    cause = "+".join(best["effects"]) if best else ""
    return dataset, answer["verdict"], cause, best and best["probability"], answer["summary"], json.dumps(answer)


def datasets(folders):
    """Folders as rows for a job."""
    return [
        (folder.name, (folder / "points.csv").read_text("utf-8"), (folder / "rig.toml").read_text("utf-8"))
        for folder in folders
    ]
