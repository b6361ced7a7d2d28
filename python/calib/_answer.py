"""Documents of the tool, with attributes."""

from typing import Any


class Document(dict):
    """The document of a verb, as docs/json.md describes it: a dictionary whose keys are attributes too."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name}; there are {', '.join(map(str, self))}") from None

    def __dir__(self) -> list:
        return [*super().__dir__(), *self]
