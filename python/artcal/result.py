"""Results: objects whose attributes are the keys of the JSON (docs/result-schema.md)."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

if TYPE_CHECKING:
    import pandas


def _wrap(value: Any) -> Any:
    if isinstance(value, dict):
        return Table(value)
    if isinstance(value, list):
        return [_wrap(one) for one in value]
    return value


class Table:
    """A JSON object: table.key and table["key"] are the same."""

    def __init__(self, data: dict[str, Any]) -> None:
        self._data = data

    def __getattr__(self, key: str) -> Any:
        if key.startswith("__") or "_data" not in self.__dict__:
            raise AttributeError(key)
        if key not in self._data:
            raise AttributeError(f"there is no {key!r}, but {', '.join(self._data)}")
        return _wrap(self._data[key])

    def __getitem__(self, key: str) -> Any:
        return _wrap(self._data[key])

    def __contains__(self, key: object) -> bool:
        return key in self._data

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._data})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self._data == other._data

    def __repr__(self) -> str:
        return f"<{', '.join(self._data)}>"

    def to_dict(self) -> dict[str, Any]:
        """The plain dictionary."""
        return self._data


def _flat(row: dict[str, Any], name: str = "") -> dict[str, Any]:
    """As the program's CSV has it: nested keys after a point, elements of lists numbered from 1."""
    fields: dict[str, Any] = {}
    for key, value in row.items():
        path = f"{name}.{key}" if name else key
        if isinstance(value, dict):
            fields.update(_flat(value, path))
        elif isinstance(value, list):
            fields.update(_flat({str(i + 1): one for i, one in enumerate(value)}, path))
        else:
            fields[path] = value
    return fields


class Result(Table):
    """What a command of the program found.

    Attributes: the keys of its JSON. Besides, `text` is what the program prints for a person, and `exit_code` is 1 where
    a verification did not show conformity, else 0.
    """

    text: str
    exit_code: int

    def __init__(self, text_of_json: str, text: str = "", exit_code: int = 0) -> None:
        super().__init__(json.loads(text_of_json))
        self._json = text_of_json
        self.text = text
        self.exit_code = exit_code

    def to_json(self) -> str:
        """The JSON, byte for byte as `--json` writes it."""
        return self._json

    def save(self, path: str | Path) -> None:
        """Writes the JSON to a file, such as for report()."""
        Path(path).write_text(self._json, encoding="ascii")

    def __repr__(self) -> str:
        return f"<artcal result: {self._data.get('kind', 'unknown')}>"

    def tables(self) -> list[str]:
        """What to_frame() can show."""
        data = self._data
        verification = "decision_rule" in data
        found = [
            ("parameters", bool(data.get("parameters"))),
            ("readings", "residuals" in data or data.get("kind") == "evaluation"),
            ("verdicts", verification),
            ("lengths", bool(self._lengths())),
            ("values", not verification and bool(data.get("values"))),
        ]
        return [name for name, there in found if there]

    def to_frame(self, what: str | None = None) -> "pandas.DataFrame":
        """A table as a pandas frame: parameters, readings, lengths, verdicts or values.

        Columns have the names of the JSON's keys, with their units (mm, rad). Raises ValueError for a table that the
        result does not have.
        """
        import pandas

        tables = self.tables()
        name = tables[0] if what is None and tables else what
        if name not in tables:
            raise ValueError(f"the result has no table {what!r}, but {', '.join(tables) or 'none'}")
        rows = {
            "parameters": lambda: self._data["parameters"],
            "readings": self._readings,
            "lengths": self._lengths,
        }.get(str(name), lambda: self._data["values"])()
        return pandas.DataFrame([_flat(row) for row in rows])

    def _lengths(self) -> list[dict[str, Any]]:
        rows = list((self._data.get("after") or self._data.get("evaluation") or {}).get("lengths", []))
        values = self._data.get("values")
        if isinstance(values, list):
            rows += [value for value in values if isinstance(value, dict) and value.get("second") is not None]
        return rows

    def _readings(self) -> list[dict[str, Any]]:
        if "residuals" not in self._data:
            return list(self._data["readings"])
        residuals = self._data["residuals"]
        count = len(residuals["reading"])
        features = self._data["after"]["features"]
        rows = []
        for i in range(count):
            row: dict[str, Any] = {}
            for key, column in residuals.items():
                if key == "prismatic_joints":  # of the arm, not of a reading
                    continue
                nested = bool(column) and isinstance(column[0], list)
                row[key] = [part[i] for part in column] if nested else column[i]
            row.update({key: features[row["feature"]][key] for key in ("artefact", "placement", "feature")})
            rows.append(row)
        return rows

    def plot_residuals(self, axes: Any = None) -> Any:
        """Deviations of every reading before and after, by matplotlib. Returns the axes."""
        from . import plots

        return plots.residuals(self, axes)

    def plot_correlation(self, axes: Any = None) -> Any:
        """Correlation of the identified parameters, by matplotlib. Returns the axes."""
        from . import plots

        return plots.correlation(self, axes)

    def plot_arm(self, axes: Any = None) -> Any:
        """The identified arm in a posture of the recording with the tips of all readings, in 3-D. Returns the axes."""
        from . import plots

        return plots.arm(self, axes)
