"""The answer of a diagnosis."""

import html
import os
from pathlib import Path
from typing import Any, Optional, Union

from .._answer import Document
from .._tables import writable
from ..errors import UsageError


class Answer(Document):
    """The answer of a diagnosis: the document of docs/gap.md, and its report where one was asked for.

    ``verdict``, ``summary``, ``causes`` (names, probability, parameters with uncertainties), ``gap`` (before and after,
    on rows that took no part), ``where``, ``next_measurement``.
    """

    def __init__(self, document: Any, page: Optional[str] = None) -> None:
        super().__init__(document)
        # Beside the document, and no part of it.
        object.__setattr__(self, "_page", page)

    def __reduce__(self) -> tuple:
        return type(self), (dict(self), self._page)

    def save_report(self, path: Union[str, "os.PathLike[str]"]) -> Path:
        """Writes the report to ``path``: one HTML page that needs nothing else."""
        if self._page is None:
            raise UsageError("one of several answers has no report of its own", "diagnose that dataset alone")
        path = writable(path)
        path.write_text(self._page, encoding="utf-8")
        return path

    def effects(self) -> list:
        """Names of the most probable cause; empty where there is none."""
        return list(self["causes"][0]["effects"]) if self["causes"] else []

    def __repr__(self) -> str:
        return f"<{self['verdict']}: {self['summary']}>"

    def _repr_html_(self) -> str:
        if self._page is None:
            return f"<b>{html.escape(self['verdict'])}</b>: {html.escape(self['summary'])}"
        page = html.escape(self._page, quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:40em;border:0" sandbox=""></iframe>'
