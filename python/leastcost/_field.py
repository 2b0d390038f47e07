# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Fields: the least cost from a place to everywhere."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field as dataclass_field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._config import source_of
from ._cost import Cost, CostMap
from ._domains import Cloud, Space, Terrain
from ._errors import InputError, OutputError
from ._find_path import refuse_mistaken
from ._mesh import Mesh
from ._places import end_tuple, is_number, is_on_face
from ._robot import Robot

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import Union

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from ._config import Config
    from ._cost import SquaredCost, Wind
    from ._domains import Domain
    from ._places import Place

    #: One place, or several.
    Places = Union[Place, Iterable[Place]]


@dataclass(frozen=True, eq=False)
class Way:
    """A path between a place and the nearest of those of a field."""

    points: NDArray[np.float64] = dataclass_field(repr=False)
    """(n, d): as it is walked, in coordinates of the domain; on a mesh (n, 3)."""
    cost: float
    """Under the cost of the field."""


class _Kept:
    """What pickle keeps of a field: its numbers, not the objects that it was made of."""

    def __init__(self, numbers: dict[str, Any]) -> None:
        self.numbers = numbers

    def values(self) -> NDArray[np.float64]:
        values: NDArray[np.float64] = self.numbers["values"]
        return values

    def axes(self) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
        axes: tuple[NDArray[np.float64], NDArray[np.float64]] | None = self.numbers["axes"]
        return axes

    def mesh(self) -> tuple[NDArray[np.float64], NDArray[np.int32]] | None:
        mesh: tuple[NDArray[np.float64], NDArray[np.int32]] | None = self.numbers["mesh"]
        return mesh

    def errors(self) -> tuple[float, float]:
        largest, mean = self.numbers["errors"]
        return largest, mean

    def method(self) -> str:
        return str(self.numbers["method"])

    def unit(self) -> str:
        return str(self.numbers["unit"])

    def directed(self) -> bool:
        return bool(self.numbers["directed"])

    def is_corridor(self) -> bool:
        return bool(self.numbers["is_corridor"])

    def way(self, to: Any) -> tuple[NDArray[np.float64], float]:
        raise _gone("way")

    def corridor(self, to: Any) -> _leastcost.Field:
        raise _gone("corridor")

    def save(self, file: Path) -> None:
        raise OutputError("a field that was pickled has no files any more: save it before, or use numpy.save")


_NUMBERS = ("values", "axes", "mesh", "errors", "method", "unit", "directed", "is_corridor")


def _gone(what: str) -> InputError:
    return InputError(f"a field that was pickled has no {what} any more: make it before, or compute the field again")


def _unpickled(numbers: dict[str, Any]) -> Field:
    return Field(_Kept(numbers))


class Field:
    """The least cost from some places, or to them, to each node of a lattice or each vertex of a mesh."""

    def __init__(self, core: _leastcost.Field | _Kept, domain: object = None) -> None:
        self._core = core
        self._domain = domain

    def __reduce__(self) -> tuple[Any, ...]:
        """The numbers: a copy has no paths, corridors or files."""
        return _unpickled, ({name: getattr(self._core, name)() for name in _NUMBERS},)

    @cached_property
    def values(self) -> NDArray[np.float64]:
        """(rows, columns), row 0 in the north (y is largest); in space (nodes along x, y, z); on a mesh (n,), in the
        order of V. NaN: no path."""
        return self._core.values()

    @property
    def axes(self) -> tuple[NDArray[np.float64], ...] | None:
        """x of the columns and y of the rows of `values`, which falls; in space x, y and z; None on a mesh."""
        return self._core.axes()

    @property
    def nodes(self) -> NDArray[np.float64]:
        """(rows, columns, 2), coordinates of the nodes; in space (x, y, z, 3); on a mesh (n, 3), NaN for
        vertices of no face."""
        axes, mesh = self._core.axes(), self._core.mesh()
        if axes is not None:
            return np.stack(np.meshgrid(*axes, indexing="ij" if len(axes) == 3 else "xy"), axis=-1)
        assert mesh is not None
        return mesh[0]

    @property
    def faces(self) -> NDArray[np.int32] | None:
        """(m, 3): the triangles of a mesh, in rows of `nodes`; None over a lattice."""
        mesh = self._core.mesh()
        return None if mesh is None else mesh[1]

    @property
    def error(self) -> float:
        """How far a value may be from the least cost: over a lattice an estimate for the worst node, from the field on
        half as many cells (NaN: too few nodes); on a mesh a bound."""
        return self._core.errors()[0]

    @property
    def mean_error(self) -> float:
        """The same on average; NaN on a mesh."""
        return self._core.errors()[1]

    @property
    def method(self) -> str:
        """"isotropic march", "arrival field" or "exact windows"."""
        return self._core.method()

    @property
    def unit(self) -> str:
        """Of the values."""
        return self._core.unit()

    @property
    def directed(self) -> bool:
        """Whether there and back may differ."""
        return self._core.directed()

    def way(self, to: Place) -> Way:
        """The way between a place and the nearest of the field's places. Raises InputError where there is none."""
        if self._core.is_corridor():
            raise InputError("a corridor has no paths: ask the field from which it was made")
        return Way(*self._core.way(_named(to, "to", self._domain)))

    def corridor(self, to: Place | None = None) -> Field:
        """How much dearer a path to `to` through each node is than the cheapest of all: 0 along that one.

        to: None: the target of the configuration, or `to` of field(). Raises InputError."""
        if self._core.is_corridor():
            raise InputError("this is a corridor already")
        return Field(self._core.corridor(None if to is None else _named(to, "to", self._domain)), self._domain)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes a .csv, .npy, .asc (ESRI ASCII grid) or .tif (GeoTIFF, with GDAL) file; in space .csv, .npy or .vti;
        on a mesh .csv, .npy, .vtp or .ply. Returns its path."""
        file = Path(path)
        self._core.save(file)
        return file

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the field with matplotlib: shades and, over a lattice, contours at round values; returns the axes.

        ax: None makes new ones; of a mesh they need projection="3d". style: as for Axes.imshow or
        Axes3D.plot_trisurf."""
        from ._plot_field import plot_field

        if self.values.ndim == 3:
            raise InputError("a field in space has no plot: draw a slice of values, or save it as .vti for ParaView")
        return plot_field(self, ax, style)

    def __repr__(self) -> str:
        shape = " x ".join(map(str, self.values.shape))
        return f"<leastcost.{'corridor' if self._core.is_corridor() else 'Field'}: {shape} values, {self.method}>"


def field(
    domain: Domain | Config,
    source: Places | None = None,
    *,
    cost: str | Mapping[str, Any] | Cost | CostMap | Wind | SquaredCost | None = None,
    obstacles: Sequence[Mapping[str, Any]] = (),
    clearance: float = 0,
    to: Place | None = None,
    corridor: bool = False,
    to_here: bool = False,
    resolution: float | None = None,
    set: Mapping[str, Any] | None = None,
    folder: str | os.PathLike[str] = "",
) -> Field:
    """The least cost from a place, or from the nearest of several, to every node; as of `leastcost field`.

    domain: Plane(), a Terrain or a Mesh; a dict as under `manifold` in a configuration,
      lc.manifold.euclidean(lower=[0, 0], upper=[4, 2]); or a whole configuration with ends, as of run().
    source: (2,), a point; on a mesh the number of a vertex, (face, (b0, b1, b2)) or a point (3,); or several in a list
      or an array (k, d). None: the source of the configuration.
    cost, obstacles, clearance: as of find_path(); of a configuration they are its own. On a mesh the cost is length.
    to: where a corridor leads; in a plane without a box and without a raster of costs the field lies around source
      and `to`.
    corridor: field(...).corridor(): how much dearer a detour through each node is.
    to_here: costs of the way to the places, not from them.
    resolution: from node to node, length units; None: a node on every value of a raster of costs, else a 200th of the
      longest side, in space an 80th; at most a quarter of the shortest side. Not on a mesh.
    set, folder: as of run().

    Raises ConfigError, InputError; KeyboardInterrupt on Ctrl-C.
    """
    own: object = None
    if _is_config(domain):
        if cost is not None or len(obstacles) > 0 or clearance != 0:
            raise InputError("a configuration has its own cost, obstacles and clearance: give them there")
        config: Any = domain
        if to is not None:
            set = {**(set or {}), **_ends_option(end_tuple(to, "to"))}
        places = [] if source is None else _several(source, None)
    else:
        if isinstance(domain, (Robot, Cloud)):
            raise InputError(f"there are no fields on {domain!r}: they are in the plane, in space or on a mesh")
        if source is None:
            raise InputError("source is missing: where the field is from")
        refuse_mistaken(cost, obstacles)
        own = domain
        places = _several(source, domain)
        if not places:
            raise InputError("source has no places: give at least one")
        config = _config(domain, cost, obstacles, clearance, to)
    named = [_named(place, "source" if len(places) == 1 else f"source[{i}]", own) for i, place in enumerate(places)]
    step = None if resolution is None else float(resolution)
    made = Field(_leastcost.field(source_of(config, set=set, folder=folder), named, to_here, step), own)
    return made.corridor() if corridor else made


def _is_config(domain: Any) -> bool:
    """A file, a text or a dict with ends; the block of a manifold has a type."""
    if isinstance(domain, Mapping):
        return "ends" in domain or "manifold" in domain
    return isinstance(domain, (str, os.PathLike))


def _config(
    domain: Any, cost: Any, obstacles: Sequence[Mapping[str, Any]], clearance: float, to: Any
) -> dict[str, Any]:
    has_box = not isinstance(domain, Space) and not (isinstance(domain, Mapping) and domain.get("type") == "euclidean")
    has_box = has_box or (isinstance(domain, Mapping) and "lower" in domain)
    on_raster = isinstance(cost, CostMap) or (isinstance(cost, Mapping) and cost.get("type") == "cost_map")
    if not has_box and not on_raster and to is None:
        raise InputError(
            f"{domain!r} has no box: give it one, lc.manifold.euclidean(lower=[0, 0], upper=[4, 2]), or say where the "
            "field leads: to=(3, 1)"
        )
    config: dict[str, Any] = {
        "manifold": domain.config() if isinstance(domain, Space) else domain,
        "cost": "euclidean" if cost is None else Cost(cost) if callable(cost) and not isinstance(cost, Cost) else cost,
    }
    if to is not None:
        config["ends"] = {"target": _end(_place(to, "to", domain))}
    if len(obstacles) > 0:
        config["obstacles"] = list(obstacles)
    if clearance != 0:
        config["clearance"] = clearance
    return config


def _end(end: tuple[Any, ...]) -> dict[str, Any]:
    """As in a configuration."""
    if end[0] == "face":
        return {"face": end[1], "barycentric": list(end[2])}
    return {end[0]: end[1]}


def _ends_option(end: tuple[Any, ...]) -> dict[str, Any]:
    return {f"ends.target.{key}": value for key, value in _end(end).items()}


def _named(place: Any, name: str, domain: object) -> tuple[str, tuple[Any, ...]]:
    return f"{name}={place!r}", _place(place, name, domain)


def _place(place: Any, name: str, domain: object) -> tuple[Any, ...]:
    """As the compiled part takes it; a point near a mesh means the nearest one of it."""
    end = end_tuple(place, name)
    if isinstance(domain, (Space, Terrain)) and (end[0] != "point" or len(end[1]) != 2):
        raise InputError(f"{name} is {place!r}; it is a point (x, y)")
    if isinstance(domain, Mesh) and end[0] == "point":
        if len(end[1]) != 3:
            raise InputError(f"{name} is {place!r}; points of a mesh have three coordinates")
        return "point", list(domain._core.position(domain._core.nearest(*end[1])))
    return end


def _several(source: Any, domain: object) -> list[Any]:
    """One place as a list of one."""
    if is_number(source) or (isinstance(source, tuple) and is_on_face(source)):
        return [source]
    listed = list(source)
    numbers = all(np.ndim(x) == 0 for x in listed)
    whole = np.asarray(listed).dtype.kind in "iu" if numbers and listed else False
    if numbers and not (whole and (isinstance(domain, Mesh) or domain is None and len(listed) != 2)):
        return [listed] if listed else []
    return listed
