"""The fleet's lake: records of many laboratories as Parquet that engines read."""

import os
from typing import Optional, Union

from ._answer import Document
from ._verb import verb

_Path = Union[str, "os.PathLike[str]"]


def export_lake(folder: _Path, *, laboratory: Optional[str] = None, logbook: Optional[_Path] = None) -> Document:
    """Adds the logbook to a lake: Parquet by laboratory, instrument and year.

    What the lake has already is not written again, and a call that was cut off leaves no half of anything.

    Args:
        folder: the lake; made if it is not there.
        laboratory: its name, a part of every path; None: that in the file of the laboratory.
        logbook: default: that of this user.

    Returns:
        ``files`` that were added, and ``records`` in them.
    """
    return verb("export", lake=folder, laboratory_name=laboratory, logbook=logbook)
