"""Pictures of results by matplotlib, where it is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .result import Result


def _axes(axes: Any, **options: Any) -> Any:
    if axes is not None:
        return axes
    from matplotlib.figure import Figure

    return Figure().add_subplot(**options)


def residuals(result: "Result", axes: Any = None) -> Any:
    """Deviations of every reading before and after the identification, mm."""
    columns = result.to_dict()["residuals"]
    axes = _axes(axes)
    axes.plot(columns["reading"], columns["before_mm"], ".", label="nominal arm")
    axes.plot(columns["reading"], columns["after_mm"], ".", label="identified arm")
    axes.set_xlabel("reading")
    axes.set_ylabel("deviation, mm")
    axes.legend()
    return axes


def correlation(result: "Result", axes: Any = None) -> Any:
    """Correlation coefficients of the identified parameters, from -1 to 1."""
    import numpy as np

    covariance = result.to_dict()["covariance"]
    matrix = np.asarray(covariance["matrix"], dtype=float)
    deviations = np.sqrt(np.diag(matrix))
    axes = _axes(axes)
    image = axes.imshow(matrix / np.outer(deviations, deviations), vmin=-1.0, vmax=1.0, cmap="RdBu")
    names = covariance["parameters"]
    axes.set_xticks(range(len(names)), names, rotation=90)
    axes.set_yticks(range(len(names)), names)
    axes.figure.colorbar(image, ax=axes, label="correlation coefficient")
    return axes


def arm(result: "Result", axes: Any = None) -> Any:
    """The arm as a line through its joints, and where the tips were, base frame, mm."""
    data = result.to_dict()
    axes = _axes(axes, projection="3d")
    if data.get("arm_shape"):
        x, y, z = zip(*data["arm_shape"]["path_mm"])
        axes.plot(x, y, z, "-o", label="arm")
    if "residuals" in data:
        axes.scatter(*data["residuals"]["tip_mm"], s=4, label="tips")
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    axes.set_zlabel("z, mm")
    axes.legend()
    return axes
