# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Costs, solvers and first paths written in Python, under names of their own."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._config import _external
from ._cost import Cost, CostMap, Wind
from ._errors import InputError
from ._options import check_name, options_of

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import TypeVar

    from numpy.typing import ArrayLike, NDArray

    from ._options import Option

    Function = TypeVar("Function", bound=Callable[..., Any])


class SearchEnded(BaseException):
    """Raised in a solver by what it asks of its chain, once the time is up or a stop was asked for. Let it pass: the best
    points so far are taken."""


class Chain:
    """What a solver written in Python improves: a path as a chain of points, and its energy, the sum of H(c / s0) over
    the costs c of its moves (H: the kernel). The certificate asks for its least.

    Arrays of points have the shape (n, d), coordinates of the domain, one point per row; the ends of an open path are
    the first and the last row, which stay where they are. Points beside the domain are put onto it. Of the points that
    the solver has asked for and those that it returns, the ones with the least energy are taken.
    """

    def __init__(self, chain: _leastcost.Chain) -> None:
        self._chain = chain

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, d): those that the solver begins with, as a new array."""
        return self._chain.points.copy()

    @property
    def free(self) -> slice:
        """The rows that may move: all but the ends; in a ring all."""
        return slice(None) if self._chain.ring else slice(1, -1)

    def value(self, points: ArrayLike) -> float:
        """The energy of these points; infinite where they or the cost are."""
        return self._chain.value(self._like(points, "points"))

    def value_and_gradient(self, points: ArrayLike) -> tuple[float, NDArray[np.float64]]:
        """The energy and its gradient along the domain, (n, d), 0 at ends; NaN where the energy is infinite."""
        return self._chain.value_and_gradient(self._like(points, "points"))

    def retract(self, points: ArrayLike, steps: ArrayLike) -> NDArray[np.float64]:
        """The points moved by `steps`, (n, d), along the domain. In the plane and in space it is their sum."""
        return self._chain.retract(self._like(points, "points"), self._like(steps, "steps"))

    def _like(self, values: ArrayLike, name: str) -> NDArray[np.float64]:
        return _like(values, self._chain.points.shape, f"{name} have", "")

    def __repr__(self) -> str:
        return f"<leastcost.Chain: {len(self._chain.points)} points>"


def register_cost(
    name: str,
    *,
    unit: str = "cost",
    symmetric: bool = True,
    additive: bool = False,
    derivatives: str = "complex",
    options: Mapping[str, Option] | None = None,
) -> Callable[[Function], Function]:
    """Gives a cost written in Python a name in configurations: runs, pairs, studies, describe() and schema() know it.

        @lc.register_cost("chute", unit="s", additive=True)
        def chute(a, b, *, gravity=9.81):
            return 2 * ((b - a) ** 2).sum(0) / (np.sqrt(-gravity * a[1]) + np.sqrt(-gravity * b[1])) ** 2

        lc.run({"cost": {"type": "chute", "gravity": 1.62}, ...})

    The function takes a and b, as q of a Cost does, and its options, and returns the squared costs of the moves. Or it takes options alone, and returns a Cost, a
    CostMap, a Wind or a function q(a, b): for what is made once, from a file, say. It is returned as it is.

    name: lower-case letters, digits and _. A name of the library is refused; one of Python is replaced, so that a cell of
      a notebook can run again.
    unit, symmetric, additive, derivatives: of q, as of Cost.
    options: more about options, by their names: {"gravity": lc.option("Acceleration.", unit="m/s^2", above=0)}.

    Options are the other parameters of the function. Annotations tell their types, or else defaults: bool, int, float,
    str, Literal["a", "b"], Path (a file, relative to the configuration), list[float], list[list[float]], list[str],
    dict[str, float]. Without a default an option is required. The docstring's first paragraph is the summary.

    Raises InputError, TypeError."""
    check_name("cost", name)
    if not isinstance(unit, str):
        raise TypeError(f"the unit of the cost {name!r} is a text, not {unit!r}")
    for key, value in (("symmetric", symmetric), ("additive", additive)):
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{key} of the cost {name!r} is True or False, not {value!r}")

    def register(function: Function) -> Function:
        read = options_of(function, name, "cost", [0, 2], options)

        def cost_of(q: Callable[..., Any]) -> Cost:
            return Cost(q, unit=unit, symmetric=symmetric, additive=additive, derivatives=derivatives)

        def make(values: dict[str, Any]) -> _leastcost.External:
            values = read.values(values)
            if read.positional:
                return cost_of(partial(function, **values))._external
            made = function(**values)
            if isinstance(made, (Cost, CostMap, Wind)):
                return _external(made, name, False)
            if not callable(made):
                raise InputError(
                    f"the cost {name!r} made a {type(made).__name__}; it makes a Cost, a CostMap, a Wind or a function q(a, b)"
                )
            return cost_of(made)._external

        cost_of(function)  # checks the arguments
        _leastcost.register_cost(name, read.summary, read.plain, make)
        return function

    return register


def register_solver(
    name: str, *, options: Mapping[str, Option] | None = None
) -> Callable[[Function], Function]:
    """Gives a solver written in Python a name in configurations, beside newton and lbfgs.

        @lc.register_solver("descent")
        def descent(chain, *, steps=1000, rate=0.001):
            points = chain.points
            _, gradient = chain.value_and_gradient(points)
            for _ in range(steps):
                moved = chain.retract(points, -rate * gradient)
                value, slope = chain.value_and_gradient(moved)
                if value == np.inf:  # too far
                    rate /= 10
                    continue
                step, turned = moved - points, slope - gradient
                if not turned.any():
                    break
                rate = min(4 * rate, (step**2).sum() / abs((step * turned).sum()))  # Barzilai and Borwein
                points, gradient = moved, slope
            return points

    The energy is steep, and steeper with more points: steps of a fixed length seldom converge, and gradients alone need
    many steps. The function takes a Chain and its options, and returns points, (n, d). The certificate measures them as
    those of any other solver. Budgets and Ctrl-C are heard whenever the chain is asked for something.

    name, options: as of register_cost(). Meshes and other domains of faces are refused: there coordinates do not say
      in which face a point is.

    Raises InputError, TypeError."""
    check_name("solver", name)

    def register(function: Function) -> Function:
        read = options_of(function, name, "solver", [1], options)

        def solve(chain: _leastcost.Chain, values: dict[str, Any]) -> NDArray[np.float64]:
            points = function(Chain(chain), **read.values(values))
            return _like(points, chain.points.shape, f"the solver {name!r} returned points of", f"the solver {name!r}")

        _leastcost.register_solver(name, read.summary, read.plain, solve)
        return function

    return register


def register_initializer(
    name: str, *, options: Mapping[str, Option] | None = None
) -> Callable[[Function], Function]:
    """Gives a first path written in Python a name in configurations.

        @lc.register_initializer("arch")
        def arch(source, target, *, height=1.0):
            return [(source + target) / 2 + [0, height]]

    The function takes the ends, (d,) each, and its options, and returns points, (n, d), which the first path goes
    through from the source to the target, all in ambient coordinates. In a ring both ends are None.

    name, options: as of register_cost().

    Raises InputError, TypeError."""
    check_name("initializer", name)

    def register(function: Function) -> Function:
        read = options_of(function, name, "initializer", [2], options)

        def first_path(
            source: NDArray[np.float64] | None, target: NDArray[np.float64] | None, dimension: int, values: dict[str, Any]
        ) -> NDArray[np.float64]:
            points = _numbers(function(source, target, **read.values(values)), f"the initializer {name!r}")
            if points.ndim != 2 or points.shape[1] != dimension:
                raise InputError(
                    f"the initializer {name!r} returned points of the shape {points.shape}; it must be (n, {dimension})"
                )
            if not np.isfinite(points).all():
                raise InputError(f"the initializer {name!r} returned points that are not finite")
            ends = [end for end in (source, target) if end is not None]
            between = points[[not any(np.array_equal(point, end) for end in ends) for point in points]]
            if not len(between):
                raise InputError(f"the initializer {name!r} returned no points between the ends")
            return between

        _leastcost.register_initializer(name, read.summary, read.plain, first_path)
        return function

    return register


def _like(values: Any, shape: tuple[int, ...], has: str, returned_by: str) -> NDArray[np.float64]:
    """Of this shape; what is returned is finite."""
    array = _numbers(values, returned_by or "a solver")
    if array.shape != shape:
        raise InputError(f"{has} the shape {array.shape}; it must be {shape}")
    if returned_by and not np.isfinite(array).all():
        raise InputError(
            f"{returned_by} returned points that are not finite: take shorter steps where the energy is infinite"
        )
    return array


def _numbers(values: Any, who: str) -> NDArray[np.float64]:
    if values is None:
        raise InputError(f"{who} returned None; it returns points")
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{who} gave {type(values).__name__}, which is no array of points") from None
    return array
