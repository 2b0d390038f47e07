# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Robots: where the joints of an arm may be."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import numbers
from ._errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from ._cost import Cost, CostMap, SquaredCost, Wind
    from ._result import Result


@dataclass(frozen=True)
class Joint:
    """A coordinate of a configuration."""

    name: str
    lower: float
    """rad, or a length of a joint that slides; may be -inf."""
    upper: float
    velocity: float
    """Largest, per s; infinite: not known."""


class Pose:
    """A place in space, and how a tool is turned there. Immutable.

    position: (3,). At most one of: rotation, a matrix (3, 3) whose columns are the axes; rpy (3,), roll, pitch and yaw
    about the fixed axes x, y, z, rad; quaternion (4,): w, x, y, z. None of them: turned in any way.
    """

    def __init__(
        self,
        position: ArrayLike,
        rotation: ArrayLike | None = None,
        *,
        rpy: ArrayLike | None = None,
        quaternion: ArrayLike | None = None,
    ) -> None:
        if sum(given is not None for given in (rotation, rpy, quaternion)) > 1:
            raise InputError("a pose has at most one of rotation, rpy and quaternion")
        self._position = _vector(position, "position", 3)
        self._turn: NDArray[np.float64] | None = None
        if rotation is not None:
            self._turn = _rotation(rotation)
        elif rpy is not None:
            self._turn = _of_rpy(_vector(rpy, "rpy", 3))
        elif quaternion is not None:
            self._turn = _of_quaternion(_vector(quaternion, "quaternion", 4))

    @classmethod
    def of_matrix(cls, matrix: ArrayLike) -> Pose:
        """The pose of a homogeneous matrix (4, 4)."""
        array = numbers(matrix, "matrix")
        if array.shape != (4, 4) or not np.allclose(array[3], [0, 0, 0, 1], atol=1e-9):
            raise InputError("a matrix of a pose has the shape (4, 4), and the last row 0, 0, 0, 1")
        return cls(array[:3, 3], array[:3, :3])

    @property
    def position(self) -> NDArray[np.float64]:
        """(3,), length units; a copy."""
        return self._position.copy()

    @property
    def rotation(self) -> NDArray[np.float64] | None:
        """(3, 3), a copy; None: turned in any way."""
        return None if self._turn is None else self._turn.copy()

    @property
    def matrix(self) -> NDArray[np.float64]:
        """(4, 4): homogeneous. Raises InputError for a pose without a rotation."""
        if self._turn is None:
            raise InputError("a pose that is turned in any way has no matrix")
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = self._turn, self._position
        return matrix

    def config(self) -> dict[str, Any]:
        """As in a configuration."""
        block: dict[str, Any] = {"position": self._position.tolist()}
        if self._turn is not None:
            block["quaternion"] = _quaternion(self._turn)
        return block

    def __repr__(self) -> str:
        turned = "" if self._turn is None else f", quaternion={[round(x, 6) for x in _quaternion(self._turn)]}"
        return f"Pose({[round(x, 6) for x in self._position.tolist()]}{turned})"


class Robot:
    """A robot, ready for many queries. Immutable; threads may share it.

    block: as under `robot` in a configuration: {"type": "dh_arm", "model": "ur5"}, or what a function of lc.robot
      returns. Robot.read() reads a URDF. Files in it are relative to `folder`.
    tool: what pose() and goals that are a Pose speak of: the name of a link, or {"link": name, "offset": (3,)}, a
      point in the frame of the link. None: the last link.

    A configuration is an array (d,), one value for each joint (rad, or length units of joints that slide), or the name
    of a state. Raises ConfigError and InputError.
    """

    def __init__(
        self,
        block: Mapping[str, Any],
        *,
        tool: str | Mapping[str, Any] | None = None,
        folder: str | os.PathLike[str] = "",
    ) -> None:
        from ._config import plain_block

        if not isinstance(block, Mapping):
            raise TypeError(f"a robot is a dict as under `robot` in a configuration, not {type(block).__name__}")
        self._state = (plain_block(block, "config['robot']"), tool, str(Path(folder).absolute()))
        self._core = _leastcost.Robot(self._state[0], Path(self._state[2]))
        self._link, self._offset = _tool(tool)
        self._core.pose(np.zeros(len(self.joints)), self._link, self._offset)  # the link is there

    @classmethod
    def read(
        cls,
        file: str | os.PathLike[str],
        *,
        srdf: str | os.PathLike[str] | None = None,
        group: str | None = None,
        tool: str | Mapping[str, Any] | None = None,
        attached: Sequence[Mapping[str, Any]] | None = None,
        **options: Any,
    ) -> Robot:
        """A robot of a URDF file, with its SRDF; names are relative to the current folder.

        group: of the SRDF, whose joints move; None: all. tool: as of Robot. attached: what the robot carries, a list of
          blocks as in a configuration: [{"link": "hand", "type": "box", "size": [..], "pose": {"position": [..]}}].
        options: the others of `robot: {type: urdf}`: hold, hold_state, soft_limits, base, packages; see lc.robot.urdf.
        """
        given: dict[str, Any] = {"srdf": srdf, "group": group, "attached": attached, **options}
        block = {"type": "urdf", "file": file, **{key: value for key, value in given.items() if value is not None}}
        return cls(block, tool=tool)

    @property
    def joints(self) -> list[Joint]:
        """One for each coordinate of a configuration."""
        return [Joint(*joint) for joint in self._core.joints()]

    @property
    def links(self) -> list[str]:
        """Names of the frames that pose() knows: of a URDF all its links."""
        return self._core.links()

    @property
    def states(self) -> dict[str, NDArray[np.float64]]:
        """Configurations (d,) by their names: the group states of the SRDF."""
        return self._core.states()

    def pose(self, q: ArrayLike | str, link: str | None = None) -> Pose:
        """Where the tool is in a configuration q, or the frame of a link; length units of the robot's file.

        Raises InputError for a link that is not there."""
        at = self._configuration(q, "q")
        tool = (self._link, self._offset) if link is None else (link, (0.0, 0.0, 0.0))
        return Pose.of_matrix(self._core.pose(at, *tool))

    def find_path(
        self,
        source: ArrayLike | str | Mapping[str, Any],
        target: ArrayLike | str | Pose | Mapping[str, Any],
        *,
        cost: str | Mapping[str, Any] | Cost | CostMap | Wind | SquaredCost | None = None,
        obstacles: Sequence[Mapping[str, Any]] = (),
        scene: str | os.PathLike[str] | None = None,
        **options: Any,
    ) -> Result:
        """The path of least cost between two configurations, as lc.find_path(robot, cost, source, target, ...).

        source: a configuration (d,) or the name of a state. target: the same; several of them (k, d); or a Pose of the
          tool. The goal that is cheapest to reach is taken. Dicts are as under `ends` in a configuration.
        cost: None means length in joint space.
        obstacles: blocks as in a configuration. scene: a file of further obstacles, also a planning scene of MoveIt.
        options: clearance (length units), points, initializer, set, max_seconds, ... of lc.find_path.
        """
        from ._find_path import find_path

        around = list(obstacles)
        if scene is not None:
            around.append({"type": "scene", "file": scene})
        return find_path(self, cost, source, target, obstacles=around, **options)  # type: ignore[arg-type]

    def _configuration(self, q: Any, name: str) -> NDArray[np.float64]:
        if isinstance(q, str):
            states = self.states
            if q not in states:
                raise InputError(f"{name} is {q!r}, and the robot's states are {', '.join(states) or 'none'}")
            return states[q]
        at = numbers(q, name)
        if at.shape != (len(self.joints),) or not np.isfinite(at).all():
            raise InputError(
                f"{name} has the shape {at.shape}; a configuration of {self!r} has {len(self.joints)} finite numbers"
            )
        return at

    @property
    def _external(self) -> _leastcost.External:
        return self._core.external()

    def __reduce__(self) -> tuple[Any, ...]:
        return (_robot, self._state)

    def __repr__(self) -> str:
        return f"<leastcost.Robot: {', '.join(joint.name for joint in self.joints)}>"


def end_of_robot(place: Any, name: str, robot: Robot) -> Mapping[str, Any]:
    """As in a configuration."""
    if isinstance(place, Pose):
        if name == "source":
            raise InputError("a path starts at a configuration: source is an array or the name of a state, not a Pose")
        if robot._core.space() == 2:
            raise InputError("a Pose is one in space, and this robot is in the plane: give a configuration")
        tool: dict[str, Any] = {"offset": list(robot._offset), **place.config()}
        return {"tool": {**tool, "link": robot._link} if robot._link else tool}
    if isinstance(place, str):
        robot._configuration(place, name)
        return {"state": place}
    array = numbers(place, name)
    count = len(robot.joints)
    if name == "target" and array.ndim == 2:
        if array.shape[1] != count or not len(array) or not np.isfinite(array).all():
            hint = "; a matrix of a pose is Pose.of_matrix(..)" if array.shape == (4, 4) else ""
            raise InputError(
                f"target has the shape {array.shape}; goals of {robot!r} have the shape (k, {count}), and are "
                f"finite{hint}"
            )
        return {"points": array}
    return {"point": robot._configuration(array, name)}


def _robot(block: Mapping[str, Any], tool: Any, folder: str) -> Robot:
    return Robot(block, tool=tool, folder=folder)


def _tool(tool: str | Mapping[str, Any] | None) -> tuple[str, tuple[float, float, float]]:
    """Link, empty for the last one, and offset."""
    if tool is None or isinstance(tool, str):
        return tool or "", (0.0, 0.0, 0.0)
    if not isinstance(tool, Mapping) or not set(tool) <= {"link", "offset"}:
        raise InputError(f'tool is {tool!r}; it must be the name of a link, or {{"link": name, "offset": (x, y, z)}}')
    x, y, z = _vector(tool.get("offset", (0, 0, 0)), "offset of the tool", 3).tolist()
    return str(tool.get("link") or ""), (x, y, z)


def _vector(values: ArrayLike, name: str, count: int) -> NDArray[np.float64]:
    array = numbers(values, name)
    if array.shape != (count,) or not np.isfinite(array).all():
        raise InputError(f"{name} is {values!r}; it has {count} finite numbers")
    return array


def _rotation(matrix: ArrayLike) -> NDArray[np.float64]:
    array = numbers(matrix, "rotation")
    if array.shape != (3, 3):
        raise InputError(f"rotation has the shape {array.shape}; it must be a matrix of shape (3, 3)")
    if not (np.allclose(array @ array.T, np.eye(3), atol=1e-6) and np.linalg.det(array) > 0):
        raise InputError("rotation must be a rotation matrix: perpendicular columns of length 1, right-handed")
    return array


def _of_rpy(rpy: NDArray[np.float64]) -> NDArray[np.float64]:
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def _of_quaternion(quaternion: NDArray[np.float64]) -> NDArray[np.float64]:
    length = np.linalg.norm(quaternion)
    if not length > 0:
        raise InputError("quaternion is 0; no rotation is (1, 0, 0, 0)")
    w, x, y, z = quaternion / length
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _quaternion(turn: NDArray[np.float64]) -> list[float]:
    """Of a rotation: the eigenvector of a symmetric matrix (Bar-Itzhack 2000), which needs no cases."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = turn
    matrix = np.array(
        [
            [xx + yy + zz, zy - yz, xz - zx, yx - xy],
            [zy - yz, xx - yy - zz, xy + yx, xz + zx],
            [xz - zx, xy + yx, yy - xx - zz, yz + zy],
            [yx - xy, xz + zx, yz + zy, zz - xx - yy],
        ]
    )
    vector = np.linalg.eigh(matrix)[1][:, -1]
    return [float(value) for value in (vector if vector[0] >= 0 else -vector)]
