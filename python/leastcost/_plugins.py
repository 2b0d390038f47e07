# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
# Made by python/generate_plugins.py: do not edit.
"""Blocks of a configuration, one function per plug-in: `lc.cost.travel_time(gravity=1)` is
{"type": "travel_time", "gravity": 1}. What is not given is left to leastcost, whose defaults may depend on the rest."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Mapping, Sequence
    from typing import Literal, Union

    from numpy.typing import ArrayLike

    File = Union[str, os.PathLike[str]]
    #: The word alone, or its block.
    Block = Union[str, Mapping[str, Any]]

Kind = TypeVar("Kind")


def _block(type: str, **options: Any) -> dict[str, Any]:
    return {"type": type, **{key: value for key, value in options.items() if value is not None}}


def _in_words(kind: type[Kind]) -> type[Kind]:
    """The kind, whose functions say what they have instead of an option that they have not."""
    for name, member in list(vars(kind).items()):
        if isinstance(member, staticmethod):
            setattr(kind, name, staticmethod(_told(f"{kind.__name__}.{name}", member.__func__)))
    return kind


def _told(name: str, function: Callable[..., dict[str, Any]]) -> Callable[..., dict[str, Any]]:
    known = function.__code__.co_varnames[: function.__code__.co_kwonlyargcount]

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> dict[str, Any]:
        for option in options:
            if option not in known:
                raise TypeError(f"lc.{name}() has no option {option!r}{_meant(option, known)}")
        return function(*arguments, **options)

    return call


def _meant(option: str, known: tuple[str, ...]) -> str:
    import difflib

    near = difflib.get_close_matches(option, known, 1)
    if near:
        return f" (did you mean {near[0]!r}?)"
    return f"; its options are: {', '.join(known)}" if known else "; it has none"


@_in_words
class manifold:
    """Where points lie."""

    @staticmethod
    def euclidean(
        *,
        dimension: int | None = None,
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
    ) -> dict[str, Any]:
        """R^d, or a box in it.

        dimension: Dimension d of R^d; not needed if lower or upper is given as a list. (>= 1 and <= 64; default: 2)
        lower: Lower corner of a box, one number per coordinate; default: unbounded. [length]
        upper: Upper corner of a box, one number per coordinate; default: unbounded. [length]
        """
        return _block("euclidean", dimension=dimension, lower=lower, upper=upper)

    @staticmethod
    def robot() -> dict[str, Any]:
        """The configurations of the robot: the box of its joint limits."""
        return _block("robot")

    @staticmethod
    def mesh(*, file: File, weld: bool | float | None = None, subdivide: int | None = None) -> dict[str, Any]:
        """A triangle mesh in R^3, read from an OBJ, OFF, PLY or STL file.

        file: Mesh file: OBJ, OFF, PLY or STL.
        weld: true: merges vertices with exactly equal positions (always done for STL). A number: merges vertices no
          farther apart than this, in length units of the file. (default: false)
        subdivide: Midpoint subdivisions: the same geometry with 4^k as many faces. (>= 0 and <= 8; default: 0)
        """
        return _block("mesh", file=file, weld=weld, subdivide=subdivide)

    @staticmethod
    def map(
        *,
        file: File,
        cell: float | None = None,
        origin: ArrayLike | None = None,
        negate: bool | None = None,
        occupied_thresh: float | None = None,
        free_thresh: float | None = None,
        unknown: Literal["blocked", "free"] | None = None,
    ) -> dict[str, Any]:
        """The free part of the plane on an occupancy map: Moving AI, PNG, PGM or map_server YAML.

        file: Map: Moving AI (.map), an image (.png, .pgm), or a map_server YAML (.yaml), which sets cell, origin,
          negate and the thresholds.
        cell: Side length of a cell. [length] (> 0; default: 1)
        origin: Position of the map's lower corner. In a Moving AI map x is the column and y the row, counted downwards;
          in an image y points up. [length] (default: [0, 0])
        negate: White cells are blocked instead of black ones. (default: false)
        occupied_thresh: Cells with an occupancy (blackness, 0 to 1) above it are blocked. (>= 0 and <= 1; default:
          0.65)
        free_thresh: Cells with an occupancy below it are free; between the two thresholds they are unknown. (>= 0 and
          <= 1; default: 0.196)
        unknown: How unknown cells are treated. (default: "blocked")
        """
        return _block(
            "map", file=file, cell=cell, origin=origin, negate=negate, occupied_thresh=occupied_thresh,
            free_thresh=free_thresh, unknown=unknown
        )

    @staticmethod
    def parametric(*, surface: Block, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> dict[str, Any]:
        """A surface x(u, v) in R^3, by name or by formulas; points are given in u and v.

        surface: The surface: a named one with its dimensions, or formulas in u and v. (type: plane, sphere, ellipsoid,
          torus, cylinder, cone, catenoid, paraboloid, hyperboloid, klein_bottle, moebius_strip, spiral, enneper,
          formula)
        lower: Lower corner of a box, one number per coordinate; default: unbounded. [length]
        upper: Upper corner of a box, one number per coordinate; default: unbounded. [length]
        """
        return _block("parametric", surface=surface, lower=lower, upper=upper)

    @staticmethod
    def earth(*, semi_major_axis: float | None = None, inverse_flattening: float | None = None) -> dict[str, Any]:
        """The WGS84 ellipsoid; points are (latitude, longitude) in degrees, lengths in metres.

        semi_major_axis: Equatorial radius of the ellipsoid; default: WGS84. [m] (> 0; default: 6378137)
        inverse_flattening: 1 / f of the ellipsoid; 0: a sphere; default: WGS84. (>= 0; default: 298.257223563)
        """
        return _block("earth", semi_major_axis=semi_major_axis, inverse_flattening=inverse_flattening)

    @staticmethod
    def implicit(*, surface: Block, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> dict[str, Any]:
        """A surface f(x, y, z) = 0, or a curve f(x, y) = 0: by name or as a formula.

        surface: The surface, by name or as a formula. (type: sphere, ellipsoid, torus, genus2, gyroid, paper_curve,
          formula)
        lower: Lower corner of a box, one number per coordinate; default: unbounded. [length]
        upper: Upper corner of a box, one number per coordinate; default: unbounded. [length]
        """
        return _block("implicit", surface=surface, lower=lower, upper=upper)

    @staticmethod
    def constraint(
        *,
        dimension: int | None = None,
        equations: str | Sequence[str] | None = None,
        parameters: Mapping[str, float] | None = None,
        set: Block | None = None,
    ) -> dict[str, Any]:
        """The solutions of equations in R^n: formulas, the n-sphere, the rotations SO(3).

        dimension: Dimension n of the space. (>= 2 and <= 64)
        equations: Formulas in x0 .. x{n-1} that are zero on the set, fewer than n of them.
        parameters: Constants that the equations use, by name.
        set: A named set, instead of equations. (type: sphere, so3)
        """
        return _block("constraint", dimension=dimension, equations=equations, parameters=parameters, set=set)

    @staticmethod
    def se2(*, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> dict[str, Any]:
        """Poses of a body in the plane: points (x, y, angle), the angle in radians.

        lower: Lower corner of a box for the position; default: unbounded. [length]
        upper: Upper corner of a box for the position; default: unbounded. [length]
        """
        return _block("se2", lower=lower, upper=upper)

    @staticmethod
    def se3(*, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> dict[str, Any]:
        """Poses of a body in space: points (x, y, z, qw, qx, qy, qz) with a unit quaternion.

        lower: Lower corner of a box for the position; default: unbounded. [length]
        upper: Upper corner of a box for the position; default: unbounded. [length]
        """
        return _block("se3", lower=lower, upper=upper)

    @staticmethod
    def point_cloud(
        *,
        file: File,
        neighbours: int | None = None,
        radius: float | None = None,
        max_edge: float | None = None,
        normals: Literal["auto", "given", "estimate"] | None = None,
    ) -> dict[str, Any]:
        """The smooth surface through a point cloud in R^3, read from a PLY or XYZ file.

        file: Point cloud: PLY, or text with rows x y z [nx ny nz].
        neighbours: Number of nearest neighbours of a point: they are its links in the graph and give its local spacing.
          (>= 4 and <= 100; default: 12)
        radius: Radius of the moving least squares fit; 0: 4, larger where the cloud is noisy. [local spacings] (>= 0
          and <= 100; default: 0)
        max_edge: Longest link of the neighbour graph, to prevent jumps between sheets; a larger value joins parts with
          a gap between them. [local spacings] (>= 1; default: 3)
        normals: given: the normals of the file. estimate: by robust quadratic fits, oriented along a minimum spanning
          tree. auto: those of the file where they agree with the estimate. (default: "auto")
        """
        return _block(
            "point_cloud", file=file, neighbours=neighbours, radius=radius, max_edge=max_edge, normals=normals
        )

    @staticmethod
    def signed_distance(
        *,
        source: Block,
        cell: float | None = None,
        accuracy: float | None = None,
        margin: int | None = None,
        memory_limit: float | None = None,
    ) -> dict[str, Any]:
        """The zero set of a signed-distance grid, computed from a mesh, a cloud or a formula, or read from a file.

        source: Source of the distances. (type: mesh, point_cloud, implicit, file)
        cell: Side of a cell of the grid; 0: from `accuracy`, or 1/64 of the longest side of the surface. [length] (>=
          0; default: 0)
        accuracy: Instead of `cell`: largest distance between the surface of the grid and its source. The cell is
          reduced until a measurement confirms it. [length] (>= 0; default: 0)
        margin: Number of cells around the surface; paths cannot leave the grid. [cells] (>= 1 and <= 1000; default: 8)
        memory_limit: Limit on the memory to compute the grid; a grid that needs more is refused beforehand. [GiB] (> 0;
          default: 1)
        """
        return _block(
            "signed_distance", source=source, cell=cell, accuracy=accuracy, margin=margin, memory_limit=memory_limit
        )

    @staticmethod
    def terrain(
        *,
        file: File,
        cell: ArrayLike | None = None,
        origin: ArrayLike | None = None,
        nodata: float | None = None,
        value_scale: float | None = None,
        degrees: bool | None = None,
    ) -> dict[str, Any]:
        """The surface (x, y, z(x, y)) over a raster of heights; points are map coordinates (x, y).

        file: Raster: an ESRI ASCII grid (.asc), a table of numbers whose first line is the northernmost row (.csv), or,
          in builds with GDAL, any raster that GDAL reads (.tif).
        cell: Side length of a cell, [25], or lengths along x and y, [25, 30]; default: from the file, or [1]. [length]
          (> 0)
        origin: Position (x, y) of the lower left corner of the raster; default: from the file, or (0, 0). [length]
        nodata: Value that marks missing data; default: from the file.
        value_scale: Factor by which values are multiplied: 0.3048 converts feet to metres. (default: 1)
        degrees: Whether cell and origin, from the file or given here, are longitude and latitude in degrees. Points are
          then metres east and north of the lower left corner, on WGS84, exact at the raster's centre. Not needed if the
          CRS of the file, or the .prj beside it, says so. (default: false)
        """
        return _block(
            "terrain", file=file, cell=cell, origin=origin, nodata=nodata, value_scale=value_scale, degrees=degrees
        )


@_in_words
class obstacle:
    """Regions that paths avoid."""

    @staticmethod
    def ball(*, center: ArrayLike, radius: float) -> dict[str, Any]:
        """A ball; in the plane, a disc.

        center: Coordinates of the centre. [length]
        radius: Radius. [length] (> 0)
        """
        return _block("ball", center=center, radius=radius)

    @staticmethod
    def box(
        *,
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
        size: ArrayLike | None = None,
        pose: Mapping[str, Any] | None = None,
    ) -> dict[str, Any]:
        """A box, turned or along the axes; in the plane a rectangle; requires a clearance.

        lower: Corner with the smallest coordinates; requires upper. [length]
        upper: Corner with the largest coordinates; requires lower. [length]
        size: Edge lengths of a box centred on the origin of its frame; replaces lower and upper. [length]
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        """
        return _block("box", lower=lower, upper=upper, size=size, pose=pose)

    @staticmethod
    def capsule(*, from_: ArrayLike, to: ArrayLike, radius: float) -> dict[str, Any]:
        """All points within a radius of a segment.

        from_: One end of its axis. [length]
        to: The other end. [length]
        radius: Distance of its surface from the axis. [length] (> 0)
        """
        return _block("capsule", **{"from": from_}, to=to, radius=radius)

    @staticmethod
    def cylinder(*, radius: float, height: float, pose: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """A cylinder with flat ends in space; requires a clearance.

        radius: Radius. [length] (> 0)
        height: Height, along the z axis of its frame; the origin is at half the height. [length] (> 0)
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        """
        return _block("cylinder", radius=radius, height=height, pose=pose)

    @staticmethod
    def cone(
        *,
        radius: float,
        height: float,
        top_radius: float | None = None,
        pose: Mapping[str, Any] | None = None,
    ) -> dict[str, Any]:
        """A cone or a frustum of one in space; requires a clearance.

        radius: Radius of the base, at the lower end. [length] (> 0)
        height: Height, along the z axis of its frame; the origin is at half the height. [length] (> 0)
        top_radius: Radius at the upper end; 0: a tip. [length] (>= 0; default: 0)
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        """
        return _block("cone", radius=radius, height=height, top_radius=top_radius, pose=pose)

    @staticmethod
    def half_space(*, normal: ArrayLike, offset: float | None = None) -> dict[str, Any]:
        """All points behind a plane, such as the ground; requires a clearance.

        normal: Direction out of the obstacle, of any length.
        offset: Distance of its plane from the origin, along the normal. [length] (default: 0)
        """
        return _block("half_space", normal=normal, offset=offset)

    @staticmethod
    def polygon(*, corners: ArrayLike) -> dict[str, Any]:
        """A polygon in the plane, convex or not; requires a clearance.

        corners: Corners in order, [x, y] each. [length]
        """
        return _block("polygon", corners=corners)

    @staticmethod
    def map(
        *,
        file: File,
        cell: float | None = None,
        origin: ArrayLike | None = None,
        negate: bool | None = None,
        occupied_thresh: float | None = None,
        free_thresh: float | None = None,
        unknown: Literal["blocked", "free"] | None = None,
    ) -> dict[str, Any]:
        """The blocked cells of an occupancy map, as boxes in the plane; requires a clearance.

        file: Map: Moving AI (.map), an image (.png, .pgm), or a map_server YAML (.yaml), which sets cell, origin,
          negate and the thresholds.
        cell: Side length of a cell. [length] (> 0; default: 1)
        origin: Position of the map's lower corner. In a Moving AI map x is the column and y the row, counted downwards;
          in an image y points up. [length] (default: [0, 0])
        negate: White cells are blocked instead of black ones. (default: false)
        occupied_thresh: Cells with an occupancy (blackness, 0 to 1) above it are blocked. (>= 0 and <= 1; default:
          0.65)
        free_thresh: Cells with an occupancy below it are free; between the two thresholds they are unknown. (>= 0 and
          <= 1; default: 0.196)
        unknown: How unknown cells are treated. (default: "blocked")
        """
        return _block(
            "map", file=file, cell=cell, origin=origin, negate=negate, occupied_thresh=occupied_thresh,
            free_thresh=free_thresh, unknown=unknown
        )

    @staticmethod
    def raster(
        *,
        file: File,
        cell: ArrayLike | None = None,
        origin: ArrayLike | None = None,
        nodata: float | None = None,
        value_scale: float | None = None,
        degrees: bool | None = None,
        above: float | None = None,
        below: float | None = None,
    ) -> dict[str, Any]:
        """Cells of a raster without data, or above or below a value, as boxes; requires a clearance.

        file: Raster: an ESRI ASCII grid (.asc), a table of numbers whose first line is the northernmost row (.csv), or,
          in builds with GDAL, any raster that GDAL reads (.tif).
        cell: Side length of a cell, [25], or lengths along x and y, [25, 30]; default: from the file, or [1]. [length]
          (> 0)
        origin: Position (x, y) of the lower left corner of the raster; default: from the file, or (0, 0). [length]
        nodata: Value that marks missing data; default: from the file.
        value_scale: Factor by which values are multiplied: 0.3048 converts feet to metres. (default: 1)
        degrees: Whether cell and origin, from the file or given here, are longitude and latitude in degrees. Points are
          then metres east and north of the lower left corner, on WGS84, exact at the raster's centre. Not needed if the
          CRS of the file, or the .prj beside it, says so. (default: false)
        above: Cells with a larger value are also obstacles.
        below: Cells with a smaller value are also obstacles.
        """
        return _block(
            "raster", file=file, cell=cell, origin=origin, nodata=nodata, value_scale=value_scale, degrees=degrees,
            above=above, below=below
        )

    @staticmethod
    def mesh(
        *,
        file: File,
        weld: bool | float | None = None,
        inside: Literal["auto", "solid", "surface"] | None = None,
        radius: float | None = None,
        scale: float | None = None,
        rotation: ArrayLike | None = None,
        translation: ArrayLike | None = None,
    ) -> dict[str, Any]:
        """A triangle mesh in space, solid or as a surface; requires a clearance or a thickness.

        file: Mesh file: OBJ, OFF, PLY or STL.
        weld: true: merges vertices with exactly equal positions (always done for STL). A number: merges vertices no
          farther apart than this, in length units of the file. (default: false)
        inside: solid: the enclosed volume is part of the obstacle. surface: only the faces are, so a path can run
          inside. auto: solid if the mesh is closed. (default: "auto")
        radius: Thickness around the mesh. [length] (>= 0; default: 0)
        scale: Scale factor, applied first. (> 0; default: 1)
        rotation: Rotation vector, axis times angle, applied second. [rad]
        translation: Translation, applied last. [length]
        """
        return _block(
            "mesh", file=file, weld=weld, inside=inside, radius=radius, scale=scale, rotation=rotation,
            translation=translation
        )

    @staticmethod
    def height_field(
        *,
        file: File | None = None,
        cell: ArrayLike | None = None,
        origin: ArrayLike | None = None,
        nodata: float | None = None,
        value_scale: float | None = None,
        degrees: bool | None = None,
        heights: ArrayLike | None = None,
        depth: float | None = None,
        pose: Mapping[str, Any] | None = None,
    ) -> dict[str, Any]:
        """Ground in space: all that is below the heights of a raster; requires a clearance.

        file: Raster: an ESRI ASCII grid (.asc), a table of numbers whose first line is the northernmost row (.csv), or,
          in builds with GDAL, any raster that GDAL reads (.tif).
        cell: Side length of a cell, [25], or lengths along x and y, [25, 30]; default: from the file, or [1]. [length]
          (> 0)
        origin: Position (x, y) of the lower left corner of the raster; default: from the file, or (0, 0). [length]
        nodata: Value that marks missing data; default: from the file.
        value_scale: Factor by which values are multiplied: 0.3048 converts feet to metres. (default: 1)
        degrees: Whether cell and origin, from the file or given here, are longitude and latitude in degrees. Points are
          then metres east and north of the lower left corner, on WGS84, exact at the raster's centre. Not needed if the
          CRS of the file, or the .prj beside it, says so. (default: false)
        heights: Instead of a file: rows of heights, the northernmost first. [length]
        depth: How far the ground reaches down below its least height; default: the diagonal of the field. [length] (>
          0)
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        """
        return _block(
            "height_field", file=file, cell=cell, origin=origin, nodata=nodata, value_scale=value_scale,
            degrees=degrees, heights=heights, depth=depth, pose=pose
        )

    @staticmethod
    def points(*, file: File, radius: float, pose: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """A point cloud in space: all places within a radius of a point.

        file: Point cloud file: PLY, XYZ, TXT, CSV or ASC.
        radius: Radius of a ball around each point. [length] (> 0)
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        """
        return _block("points", file=file, radius=radius, pose=pose)

    @staticmethod
    def scene(
        *,
        file: File,
        pose: Mapping[str, Any] | None = None,
        without: str | Sequence[str] | None = None,
    ) -> dict[str, Any]:
        """The objects of a planning scene in space, from a file; requires a clearance.

        file: Scene file (YAML): objects with poses, or a planning scene of MoveIt.
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        without: Ids of objects that are left out.
        """
        return _block("scene", file=file, pose=pose, without=without)

    @staticmethod
    def distance_grid(*, file: File, radius: float | None = None, memory_limit: float | None = None) -> dict[str, Any]:
        """A signed distance on a regular grid in space; requires a clearance or a thickness.

        file: Signed distances, negative inside the obstacle, in the text format of SDFGen.
        radius: Thickness around the obstacle. [length] (>= 0; default: 0)
        memory_limit: Limit on the memory for the grid; a grid that needs more is refused. [GiB] (> 0; default: 1)
        """
        return _block("distance_grid", file=file, radius=radius, memory_limit=memory_limit)

    @staticmethod
    def octomap(*, file: File, pose: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """The occupied space of an OctoMap, as boxes in space; requires a clearance.

        file: OctoMap file, .bt or .ot.
        pose: Position and rotation of the shape's frame. (with position, rpy, quaternion, rotation, angle)
        """
        return _block("octomap", file=file, pose=pose)


@_in_words
class robot:
    """Bodies that move among obstacles."""

    @staticmethod
    def dh_arm(
        *,
        model: Block | None = None,
        base: ArrayLike | None = None,
        attached: Sequence[Mapping[str, Any]] | None = None,
    ) -> dict[str, Any]:
        """An arm with revolute joints, from a Denavit-Hartenberg table; a configuration is its joint angles.

        model: The arm: a named model, or a table. (type: panda, ur5, table; default: "panda")
        base: Position of the base; the z axis of its frame points up. [length] (default: [0, 0, 0])
        attached: Objects that it carries: shapes on its links. (with id, link, size, radius, height, from, to, file,
          pose, touches)
        """
        return _block("dh_arm", model=model, base=base, attached=attached)

    @staticmethod
    def rigid_body(*, shape: ArrayLike) -> dict[str, Any]:
        """A body of balls and capsules, in the plane (x, y, angle) or in space (x, y, z, quaternion).

        shape: Capsules in body coordinates, one per row; equal ends make a ball. In the plane: [x1, y1, x2, y2,
          radius], with configurations (x, y, angle). In space: [x1, y1, z1, x2, y2, z2, radius], with configurations
          (x, y, z, qw, qx, qy, qz). [length]
        """
        return _block("rigid_body", shape=shape)

    @staticmethod
    def urdf(
        *,
        file: File,
        srdf: File | None = None,
        group: str | None = None,
        hold: Mapping[str, float] | None = None,
        hold_state: str | None = None,
        soft_limits: bool | None = None,
        base: Mapping[str, Any] | None = None,
        packages: File | None = None,
        attached: Sequence[Mapping[str, Any]] | None = None,
    ) -> dict[str, Any]:
        """A robot from a URDF file, with the groups, states and pairs of its SRDF; a configuration is its joint values.

        file: URDF file.
        srdf: SRDF file: groups of joints, named states, pairs of links that may touch.
        group: Group of the SRDF whose joints move; default: all joints.
        hold: Values at which joints are held, {finger: 0.02}; default: 0, or the limit nearest to it. [rad or length]
        hold_state: SRDF state that sets the joints that are neither moved nor listed in hold.
        soft_limits: Keep to the soft limits of a safety_controller where they are narrower. (default: true)
        base: Where the root link stands. (with position, rpy)
        packages: Folder with the packages of package:// names; meshes are also searched for beside the URDF.
        attached: Objects that it carries: shapes on its links. (with id, link, size, radius, height, from, to, file,
          pose, touches)
        """
        return _block(
            "urdf", file=file, srdf=srdf, group=group, hold=hold, hold_state=hold_state, soft_limits=soft_limits,
            base=base, packages=packages, attached=attached
        )


@_in_words
class cost:
    """The cost of a move from a to b."""

    @staticmethod
    def euclidean() -> dict[str, Any]:
        """Length: c(a, b) = |b - a|."""
        return _block("euclidean")

    @staticmethod
    def metric_tensor(*, matrix: ArrayLike) -> dict[str, Any]:
        """Length under a constant metric tensor M: c(a, b) = sqrt((b - a)' M (b - a)).

        matrix: Symmetric positive definite matrix M, one row per ambient coordinate; c = sqrt((b-a)' M (b-a)).
        """
        return _block("metric_tensor", matrix=matrix)

    @staticmethod
    def metric_field(
        *,
        field: Block,
        reading: Literal["metric", "root"] | None = None,
        rule: Literal["auto", "midpoint", "average"] | None = None,
    ) -> dict[str, Any]:
        """Length under a metric tensor that varies with position: by name, by formulas, from a file, or from curvature.

        field: The tensor T(x): by name, or as formulas in the coordinates. (type: half_plane, poincare_disc,
          fisher_rao, formula, file, curvature)
        reading: T is the metric, c = sqrt(d' T d) (VFCS Eq. 1), or a root of it, c = |T d| (VFCS Sec. 4.5). (default:
          "metric")
        rule: midpoint: T at the middle of a segment. average: the mean of T at its ends (VFCS Sec. 4.5). auto: average
          for tensors given on data, whose midpoints are off the surface; otherwise midpoint. (default: "auto")
        """
        return _block("metric_field", field=field, reading=reading, rule=rule)

    @staticmethod
    def travel_time(
        *,
        rule: Literal["chute", "midpoint"] | None = None,
        gravity: float | None = None,
        start_speed: float | None = None,
        level: float | None = None,
        potential: str | None = None,
        parameters: Mapping[str, float] | None = None,
    ) -> dict[str, Any]:
        """Time of a bead that slides without friction, under gravity or in a potential.

        rule: chute: exact time of a straight chute; midpoint: speed at mid-height, VFCS Eq. (21). (default: "chute")
        gravity: Gravitational acceleration; the last coordinate is height, up is positive. [length/s^2] (> 0; default:
          9.80665)
        start_speed: Speed at the source. [length/s] (>= 0; default: 0)
        level: Height at which the bead is at rest, or its energy in a potential; default: from the source and the start
          speed. Required for a ring without a source. [length, in a potential length^2/s^2]
        potential: Instead of gravity: the potential energy per mass as a formula in the coordinates, like "(x^2 + y^2)
          / 2". [length^2/s^2]
        parameters: Constants that the potential can use, like {k: 2}.
        """
        return _block(
            "travel_time", rule=rule, gravity=gravity, start_speed=start_speed, level=level, potential=potential,
            parameters=parameters
        )

    @staticmethod
    def clearance(*, reach: float, weight: float | None = None) -> dict[str, Any]:
        """Length with a weight that increases smoothly near obstacles.

        reach: Distance, beyond the clearance, at which the extra cost of an obstacle ends. [length] (> 0)
        weight: Extra cost per unit of length in contact with an obstacle. (>= 0; default: 1)
        """
        return _block("clearance", reach=reach, weight=weight)

    @staticmethod
    def cost_map(
        *,
        file: File,
        cell: ArrayLike | None = None,
        origin: ArrayLike | None = None,
        nodata: float | None = None,
        value_scale: float | None = None,
        degrees: bool | None = None,
        interpolation: Literal["auto", "cells", "bilinear", "smooth"] | None = None,
    ) -> dict[str, Any]:
        """Length times a cost per unit of length in the plane, from a raster.

        file: Raster: an ESRI ASCII grid (.asc), a table of numbers whose first line is the northernmost row (.csv), or,
          in builds with GDAL, any raster that GDAL reads (.tif).
        cell: Side length of a cell, [25], or lengths along x and y, [25, 30]; default: from the file, or [1]. [length]
          (> 0)
        origin: Position (x, y) of the lower left corner of the raster; default: from the file, or (0, 0). [length]
        nodata: Value that marks missing data; default: from the file.
        value_scale: Factor by which values are multiplied: 0.3048 converts feet to metres. (default: 1)
        degrees: Whether cell and origin, from the file or given here, are longitude and latitude in degrees. Points are
          then metres east and north of the lower left corner, on WGS84, exact at the raster's centre. Not needed if the
          CRS of the file, or the .prj beside it, says so. (default: false)
        interpolation: cells: constant in each cell. bilinear: through the values, with kinks between cells. smooth: the
          bicubic spline with the values as coefficients, without kinks and smoother than the values. auto: cells for a
          path between two ends in the plane without obstacles, unless a solver, a post-processor or a clearance is
          given; otherwise smooth. (default: "auto")
        """
        return _block(
            "cost_map", file=file, cell=cell, origin=origin, nodata=nodata, value_scale=value_scale, degrees=degrees,
            interpolation=interpolation
        )

    @staticmethod
    def weighted_length(*, weights: ArrayLike) -> dict[str, Any]:
        """Length with a weight for each factor of the domain, or for each coordinate.

        weights: One per factor of the domain (se2, se3: position, then rotation, in length per radian), or one per
          coordinate. (> 0)
        """
        return _block("weighted_length", weights=weights)

    @staticmethod
    def layers(
        *,
        interfaces: ArrayLike,
        speeds: ArrayLike | None = None,
        indices: ArrayLike | None = None,
        normals: ArrayLike | None = None,
    ) -> dict[str, Any]:
        """Length or time through layers of constant index, with refraction at the interfaces.

        interfaces: Positions of the interfaces, lowest first: normal . x = this number (heights, if the normal is the
          last axis). [length]
        speeds: Speed in each layer, lowest first; one more than interfaces. [length/s]
        indices: Instead of speeds: cost per unit of length in each layer (refractive index).
        normals: Upward normals of the interfaces, one row for all or one for each (dipping layers); default: the last
          axis.
        """
        return _block("layers", interfaces=interfaces, speeds=speeds, indices=indices, normals=normals)

    @staticmethod
    def kinetic_energy(*, model: Block | None = None) -> dict[str, Any]:
        """Length under the kinetic energy of an arm; least-cost paths are its motions without forces.

        model: The arm: a named model, or a table. (type: panda, ur5, table; default: "panda")
        """
        return _block("kinetic_energy", model=model)

    @staticmethod
    def end_effector_length(
        *,
        model: Block | None = None,
        tool: ArrayLike | None = None,
        joint_weight: float | None = None,
    ) -> dict[str, Any]:
        """Length of the path of an arm's tool, plus a small part of that of its joints.

        model: The arm: a named model, or a table. (type: panda, ur5, table; default: "panda")
        tool: Position of the tool in the frame of the last row. [length] (default: [0, 0, 0])
        joint_weight: Weight of joint rotation relative to the path of the tool. [length per rad] (> 0; default: 0.05)
        """
        return _block("end_effector_length", model=model, tool=tool, joint_weight=joint_weight)

    @staticmethod
    def zermelo(
        *,
        speed: str,
        flow: Block,
        parameters: Mapping[str, float] | None = None,
        unit: str | None = None,
    ) -> dict[str, Any]:
        """Travel time of a vehicle of given speed in wind or current, by formula or on a grid.

        speed: Speed of the vehicle through the air or water: a number, or a formula in the coordinates. [length/time]
        flow: The velocity of the wind or current. (type: uniform, formula, grid, east_north)
        parameters: Constants that the formulas can use, like {a: 2, b: 1}.
        unit: Unit of time, which follows from the units of length and speed. (default: "s")
        """
        return _block("zermelo", speed=speed, flow=flow, parameters=parameters, unit=unit)

    @staticmethod
    def walking(
        *,
        law: Block | None = None,
        length: Literal["m", "km"] | None = None,
        rounding: float | None = None,
    ) -> dict[str, Any]:
        """Time or energy of walking over terrain, with switchbacks on steep slopes; the last of three coordinates is
        height.

        law: Cost of walking as a function of slope, with its unit. (type: tobler, minetti; default: "tobler")
        length: The unit of the coordinates, height included. (default: "m")
        rounding: Range of slope, to both sides, over which the kink of Tobler's law at -0.05 and the corners of the
          hull are rounded. The error bar includes the effect; a larger range needs fewer points. [slope] (> 0 and <=
          0.05; default: 0.01)
        """
        return _block("walking", law=law, length=length, rounding=rounding)

    @staticmethod
    def refractive_index(*, index: Block) -> dict[str, Any]:
        """Optical length under an index n(x): linear velocity, lenses, layers, powers, formulas.

        index: The refractive index n(x), by name or as a formula. (type: linear_velocity, luneburg, maxwell_fisheye,
          smooth_layers, power_law, formula)
        """
        return _block("refractive_index", index=index)

    @staticmethod
    def formula(
        *,
        lagrangian: str,
        parameters: Mapping[str, float] | None = None,
        convexify: bool | None = None,
        unit: str | None = None,
    ) -> dict[str, Any]:
        """Any cost per unit of length F(x, v), as a formula in position and direction; asymmetric costs are allowed.

        lagrangian: F(x, v) > 0 of degree 1 in v, like "sqrt(vx^2 + vy^2) * (1 + x^2)"; in more than three dimensions in
          x0, x1, ... and v0, v1, ...
        parameters: Constants that the formula can use, like {a: 2, b: 1}.
        convexify: In the plane: replaces F by its convex hull in v where F is not convex; zigzags attain the hull.
          (default: false)
        unit: Unit of the cost, as free text. (default: "cost")
        """
        return _block("formula", lagrangian=lagrangian, parameters=parameters, convexify=convexify, unit=unit)

    @staticmethod
    def sum(*, terms: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
        """A sum of costs with positive weights.

        terms: The costs, like [{weight: 2, cost: euclidean}, {cost: {type: travel_time}}]. (with weight, cost)
        """
        return _block("sum", terms=terms)

    @staticmethod
    def scaled(*, by: str, cost: Block, parameters: Mapping[str, float] | None = None) -> dict[str, Any]:
        """A cost times a positive field f(x), given as a formula.

        by: f(x) > 0 in the coordinates, like "1 + x^2".
        cost: The cost to be multiplied. (lc.cost)
        parameters: Constants that the formula can use, like {a: 2, b: 1}.
        """
        return _block("scaled", by=by, cost=cost, parameters=parameters)


@_in_words
class kernel:
    """The convex H of the energy sum H(c / s0)."""

    @staticmethod
    def linear() -> dict[str, Any]:
        """H(s) = s: the plain cost. Points can slide along the path, so nothing can be certified."""
        return _block("linear")

    @staticmethod
    def square() -> dict[str, Any]:
        """H(s) = s^2: the usual path energy; enforces equal spacing less strongly."""
        return _block("square")

    @staticmethod
    def expm1_square() -> dict[str, Any]:
        """H(s) = exp(s^2) - 1: the choice of VFCS, enforces equal spacing most strongly."""
        return _block("expm1_square")

    @staticmethod
    def exp() -> dict[str, Any]:
        """H(s) = exp(s)."""
        return _block("exp")

    @staticmethod
    def expm1() -> dict[str, Any]:
        """H(s) = exp(s) - 1."""
        return _block("expm1")

    @staticmethod
    def exp_square() -> dict[str, Any]:
        """H(s) = exp(s^2)."""
        return _block("exp_square")


@_in_words
class initializer:
    """How the first path is found."""

    @staticmethod
    def straight() -> dict[str, Any]:
        """The straight line between the ends, bent around places where its cost is infinite."""
        return _block("straight")

    @staticmethod
    def bow(*, height: float | None = None, angle: float | None = None) -> dict[str, Any]:
        """An arc on a given side of the straight line.

        height: Height of the arc, relative to the distance between the ends; 0.5 is nearly a half circle. (>= 0;
          default: 0.5)
        angle: Side of the arc, as an angle about the straight line. [degrees] (default: 0)
        """
        return _block("bow", height=height, angle=angle)

    @staticmethod
    def dijkstra(
        *,
        routes: int | None = None,
        rank: int | None = None,
        diagonals: bool | None = None,
        landmarks: int | None = None,
    ) -> dict[str, Any]:
        """The least-cost path along the edges of the mesh, or the neighbour graph of the cloud.

        routes: 1: the least-cost edge path. 2: the better of two straightened graph paths, for costs with a constant
          metric. (>= 1 and <= 2; default: 1)
        rank: k: the k-th of several routes that avoid each other, for another class of paths. (>= 1 and <= 32; default:
          1)
        diagonals: Also use moves from a mesh vertex across an edge to the opposite vertex, for costs with a constant
          metric. The path is then more often in the class of the shortest one. (default: false)
        landmarks: Number of mesh vertices whose distances to all others are computed once, to guide every later search,
          for costs with a constant metric. Faster for many pairs on a large mesh; each distance takes 4 bytes. (>= 0
          and <= 256; default: 0)
        """
        return _block("dijkstra", routes=routes, rank=rank, diagonals=diagonals, landmarks=landmarks)

    @staticmethod
    def plane_cut(*, point: ArrayLike, normal: ArrayLike) -> dict[str, Any]:
        """The closed curve in which a plane cuts the surface, for a ring.

        point: A point of the plane. Of several closed curves, the nearest to it is taken (on a smooth surface: one
          nearby). [length]
        normal: Normal of the plane, of any length.
        """
        return _block("plane_cut", point=point, normal=normal)

    @staticmethod
    def eikonal(
        *,
        cells: int | None = None,
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
        fallback: bool | None = None,
    ) -> dict[str, Any]:
        """Follows the arrival-cost field back to the source, over two coordinates, for any cost.

        cells: Number of cells along the longest side of the box. Default: as in the cost raster, or a multiple, limited
          so that the field takes a fraction of a second; 100 without a raster. (>= 4 and <= 2000)
        lower: Lower corner of the searched box of coordinates. Default: that of the domain; if it has none, a box
          around the ends with their distance as margin.
        upper: Upper corner of that box.
        fallback: If no path is found, use the straight line, or, among obstacles, a grid in the plane or the edges of
          the domain. Without obstacles, also use the line if it costs no more. On if eikonal is the default. (default:
          false)
        """
        return _block("eikonal", cells=cells, lower=lower, upper=upper, fallback=fallback)

    @staticmethod
    def cell_graph(*, side_points: int | None = None) -> dict[str, Any]:
        """The least-cost path between points on the cell sides of a cost map (interpolation: cells).

        side_points: Points on each side of a cell, in addition to its corners; more points find more paths and take
          longer. Default: 3, or 1 if the raster has more than 300,000 cells. (>= 0 and <= 63)
        """
        return _block("cell_graph", side_points=side_points)

    @staticmethod
    def grid(
        *,
        resolution: float | None = None,
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
        refinements: int | None = None,
        shortcuts: bool | None = None,
        trees: bool | None = None,
    ) -> dict[str, Any]:
        """A least-cost route over a regular grid in the plane or in space that keeps clear of obstacles.

        resolution: Side length of a cell of the first grid; default: 1/64 of the longest side of the box, in space
          1/32. [length] (> 0)
        lower: Lower corner of the searched box. Default: that of the domain; if it has none, a box around the ends with
          their distance as margin. [length]
        upper: Upper corner of that box. [length]
        refinements: How often the cells are halved if the grid has no passage. (>= 0 and <= 20; default: 4)
        shortcuts: Removes points of the route that a straight move can skip. (default: true)
        trees: If no grid has a passage, random trees search for one, as in rrt. (default: true)
        """
        return _block(
            "grid", resolution=resolution, lower=lower, upper=upper, refinements=refinements, shortcuts=shortcuts,
            trees=trees
        )

    @staticmethod
    def rrt(
        *,
        step: float | None = None,
        shell: float | None = None,
        goal_bias: float | None = None,
        reach: float | None = None,
        max_nodes: int | None = None,
        shortcuts: int | None = None,
        paths: int | None = None,
        seed: int | None = None,
    ) -> dict[str, Any]:
        """Random trees from both ends, for robots, among obstacles and near smooth domains; shortened.

        step: Length of an edge of the tree; default: 1/16 of the distance between the ends; for a robot, 1/16 of the
          diagonal of its joint limits. [length] (> 0)
        shell: Largest distance of a node from the domain; default: a quarter of the step. [length] (>= 0)
        goal_bias: Share of samples placed at the other end. (>= 0 and <= 1; default: 0.1)
        reach: How far beyond the tree samples are taken, in units of the distance between the ends. (> 0; default: 1)
        max_nodes: Number of nodes in both trees at which the search gives up. (>= 1; default: 20000)
        shortcuts: Number of random shortcuts tried on the path found; for a robot, up to ten times as many. (>= 0;
          default: 200)
        paths: Number of paths to find, of which the shortest is taken; default: among obstacles 8 in space and 4 in
          more dimensions (a robot; up to 12 if the best is far from straight), otherwise 1. (>= 1)
        seed: Seed of the samples; default: the seed of the run. (>= 0)
        """
        return _block(
            "rrt", step=step, shell=shell, goal_bias=goal_bias, reach=reach, max_nodes=max_nodes, shortcuts=shortcuts,
            paths=paths, seed=seed
        )

    @staticmethod
    def waypoints(*, points: ArrayLike) -> dict[str, Any]:
        """A path through the given points, in order.

        points: Points to pass through, one row each, in order. [length]
        """
        return _block("waypoints", points=points)

    @staticmethod
    def coordinate_circle(
        *,
        through: ArrayLike,
        coordinate: int | None = None,
        turns: int | None = None,
    ) -> dict[str, Any]:
        """A ring along which one coordinate of a chart runs once or more through its period.

        through: A point of the circle, in the coordinates of the chart.
        coordinate: The coordinate that varies, numbered from 0. (>= 0; default: 0)
        turns: Number of turns. (>= 1 and <= 1000; default: 1)
        """
        return _block("coordinate_circle", through=through, coordinate=coordinate, turns=turns)

    @staticmethod
    def file(*, file: File) -> dict[str, Any]:
        """A path through the points of a text file, such as the path.csv of an earlier run.

        file: Text file with one point per row, such as the path.csv of an earlier run.
        """
        return _block("file", file=file)

    @staticmethod
    def ompl(
        *,
        planner: Literal[
            "RRTConnect", "RRT", "LazyRRT", "TRRT", "EST", "BiEST", "KPIECE1", "BKPIECE1", "LBKPIECE1", "SBL", "STRIDE",
            "PDST", "PRM", "LazyPRM", "FMT", "BFMT", "PRMstar", "RRTstar", "InformedRRTstar", "BITstar"
        ] | None = None,
        max_seconds: float | None = None,
        range: float | None = None,
        step: float | None = None,
        reach: float | None = None,
        shortcuts: int | None = None,
        seed: int | None = None,
    ) -> dict[str, Any]:
        """A path found by an OMPL planner among the obstacles of the domain, shortened.

        planner: Planner of OMPL; those from PRMstar on improve their path until max_seconds have passed. (default:
          "RRTConnect")
        max_seconds: Time after which the planner gives up. [s] (> 0 and <= 1e+06; default: 10)
        range: Longest move that a planner adds at once; default: for a robot 1/8 of the distance between the ends, else
          OMPL's choice for the space. [length] (> 0)
        step: Moves are checked in pieces of half this length; default: 1/16 of the distance between the ends. [length]
          (> 0)
        reach: How far beyond the ends samples are taken along unbounded coordinates, in units of the distance between
          the ends. (> 0; default: 1)
        shortcuts: Number of random shortcuts tried on the path found. (>= 0; default: 200)
        seed: Seed of the planner; default: the seed of the run. (>= 0)
        """
        return _block(
            "ompl", planner=planner, max_seconds=max_seconds, range=range, step=step, reach=reach, shortcuts=shortcuts,
            seed=seed
        )


@_in_words
class solver:
    """How the path is improved."""

    @staticmethod
    def newton(
        *,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        max_evaluations: int | None = None,
    ) -> dict[str, Any]:
        """Block-tridiagonal Newton on the chain.

        tolerance: Stops at this relative cost error g' H^-1 g / (2 sum H'(s) s). [relative cost error] (>= 0; default:
          1e-14)
        max_iterations: Limit on iterations. (>= 1; default: 200)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 100000)
        """
        return _block("newton", tolerance=tolerance, max_iterations=max_iterations, max_evaluations=max_evaluations)

    @staticmethod
    def lbfgs(
        *,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        max_evaluations: int | None = None,
        memory: int | None = None,
        precondition: Literal["chain", "none"] | None = None,
    ) -> dict[str, Any]:
        """Riemannian L-BFGS, preconditioned by the chain Hessian.

        tolerance: Stops at this relative cost error g' H^-1 g / (2 sum H'(s) s). [relative cost error] (>= 0; default:
          1e-14)
        max_iterations: Limit on iterations. (>= 1; default: 1000)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 100000)
        memory: Number of stored pairs. (>= 1 and <= 1000; default: 10)
        precondition: Initial inverse Hessian. chain: that of the chain (iterations independent of n). none: a multiple
          of the identity. (default: "chain")
        """
        return _block(
            "lbfgs", tolerance=tolerance, max_iterations=max_iterations, max_evaluations=max_evaluations, memory=memory,
            precondition=precondition
        )

    @staticmethod
    def gradient_descent(
        *,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        max_evaluations: int | None = None,
    ) -> dict[str, Any]:
        """Riemannian steepest descent.

        tolerance: Stops at this relative cost error g' H^-1 g / (2 sum H'(s) s). [relative cost error] (>= 0; default:
          1e-14)
        max_iterations: Limit on iterations. (>= 1; default: 20000)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 100000)
        """
        return _block(
            "gradient_descent", tolerance=tolerance, max_iterations=max_iterations, max_evaluations=max_evaluations
        )

    @staticmethod
    def vfcs(
        *,
        gradient_tolerance: float | None = None,
        max_iterations: int | None = None,
        max_evaluations: int | None = None,
        memory: int | None = None,
    ) -> dict[str, Any]:
        """Algorithm 1 of VFCS as printed, including its stopping rule.

        gradient_tolerance: Stops at this norm of the projected gradient: the rule of the paper. (>= 0; default: 1e-08)
        max_iterations: Limit on iterations. (>= 1; default: 20000)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 100000)
        memory: Number of stored pairs. (>= 1 and <= 1000; default: 10)
        """
        return _block(
            "vfcs", gradient_tolerance=gradient_tolerance, max_iterations=max_iterations,
            max_evaluations=max_evaluations, memory=memory
        )

    @staticmethod
    def georce(
        *,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        max_evaluations: int | None = None,
    ) -> dict[str, Any]:
        """GEORCE (arXiv 2505.05961): alternates between the optimality conditions of a discrete energy in a chart.

        tolerance: Stops when an iteration lowers its discrete energy by less than this fraction. (>= 0; default: 1e-12)
        max_iterations: Limit on iterations. (>= 1; default: 1000)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 100000)
        """
        return _block("georce", tolerance=tolerance, max_iterations=max_iterations, max_evaluations=max_evaluations)

    @staticmethod
    def string(
        *,
        step: float | None = None,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        max_evaluations: int | None = None,
    ) -> dict[str, Any]:
        """The string method: steps normal to the path, then equal spacing; no energy.

        step: Step along the force, relative to the largest stable step of the stiffest point. (> 0 and <= 1; default:
          0.5)
        tolerance: Stops when no point moves farther in one iteration. [segments] (>= 0; default: 1e-10)
        max_iterations: Limit on iterations. (>= 1; default: 20000)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 100000)
        """
        return _block(
            "string", step=step, tolerance=tolerance, max_iterations=max_iterations, max_evaluations=max_evaluations
        )

    @staticmethod
    def none() -> dict[str, Any]:
        """The first path unchanged, for post-processors that find the shortest one."""
        return _block("none")

    @staticmethod
    def nlopt(
        *,
        algorithm: Literal[
            "lbfgs", "tnewton", "tnewton_restart", "tnewton_precond", "tnewton_precond_restart", "var1", "var2", "mma",
            "ccsaq", "slsqp", "cobyla", "bobyqa", "neldermead", "sbplx", "praxis"
        ] | None = None,
        tolerance: float | None = None,
        max_evaluations: int | None = None,
        precondition: Literal["chain", "none"] | None = None,
        restart: int | None = None,
    ) -> dict[str, Any]:
        """NLopt's local optimisers, preconditioned by the chain Hessian or not.

        algorithm: Local optimiser of NLopt; those after slsqp need no gradients and are for few points. (default:
          "lbfgs")
        tolerance: Stops at this relative cost error g' H^-1 g / (2 sum H'(s) s). [relative cost error] (>= 0; default:
          1e-14)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 20000)
        precondition: chain: variables in which the energy is about |z|^2 / 2, from the chain Hessian (evaluations
          independent of n). none: plain tangent coordinates. (default: "chain")
        restart: Evaluations after which the chain Hessian is factored again and the back end restarted; 15 to 30 work
          well. Not used with precondition: none. (>= 2; default: 20)
        """
        return _block(
            "nlopt", algorithm=algorithm, tolerance=tolerance, max_evaluations=max_evaluations,
            precondition=precondition, restart=restart
        )

    @staticmethod
    def ceres(
        *,
        algorithm: Literal["levenberg_marquardt", "dogleg", "lbfgs", "bfgs", "ncg"] | None = None,
        max_iterations: int | None = None,
        tolerance: float | None = None,
        max_evaluations: int | None = None,
        precondition: Literal["chain", "none"] | None = None,
        restart: int | None = None,
    ) -> dict[str, Any]:
        """Ceres: trust region on the residual form, or line search.

        algorithm: Trust region (the first two) or line search; ncg: nonlinear conjugate gradients. (default:
          "levenberg_marquardt")
        max_iterations: Limit on iterations of the trust region. (>= 1; default: 500)
        tolerance: Stops at this relative cost error g' H^-1 g / (2 sum H'(s) s). [relative cost error] (>= 0; default:
          1e-14)
        max_evaluations: Limit on energy and gradient evaluations. (>= 1; default: 20000)
        precondition: chain: variables in which the energy is about |z|^2 / 2, from the chain Hessian (evaluations
          independent of n). none: plain tangent coordinates. (default: "chain")
        restart: Evaluations after which the chain Hessian is factored again and the back end restarted; 15 to 30 work
          well. Not used with precondition: none. (>= 2; default: 20)
        """
        return _block(
            "ceres", algorithm=algorithm, max_iterations=max_iterations, tolerance=tolerance,
            max_evaluations=max_evaluations, precondition=precondition, restart=restart
        )


@_in_words
class post_processor:
    """Steps after the solve."""

    @staticmethod
    def trace() -> dict[str, Any]:
        """The solved path as a polyline on the mesh."""
        return _block("trace")

    @staticmethod
    def straighten() -> dict[str, Any]:
        """The exact locally shortest path on the mesh, in the same class as the solved one."""
        return _block("straighten")

    @staticmethod
    def on_surface(*, tolerance: float | None = None) -> dict[str, Any]:
        """The solved path as a polyline that lies on a smooth domain within a tolerance.

        tolerance: Largest distance of the delivered curve from the domain; default: 1e-6 of its extent. [length] (> 0)
        """
        return _block("on_surface", tolerance=tolerance)

    @staticmethod
    def taut(*, excess: float | None = None) -> dict[str, Any]:
        """The shortest path in its class among obstacles in the plane, or among convex ones in space.

        excess: Largest relative excess of the polyline's length over the curve's, at round corners. (>= 1e-10 and <=
          0.01; default: 1e-06)
        """
        return _block("taut", excess=excess)

    @staticmethod
    def refract() -> dict[str, Any]:
        """The least-cost path through the same layers, with Snell's law at every interface."""
        return _block("refract")

    @staticmethod
    def refract_cells() -> dict[str, Any]:
        """The locally least-cost path over the cells of a cost map, with Snell's law at every cell side."""
        return _block("refract_cells")

    @staticmethod
    def switchbacks(*, width: float) -> dict[str, Any]:
        """The zigzag of given width that a walking path represents on steep slopes.

        width: Largest total width of the zigzag across the path. [length] (> 0)
        """
        return _block("switchbacks", width=width)
