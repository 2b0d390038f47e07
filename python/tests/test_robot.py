# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Robots as objects: what they know, where their tools are, paths between all kinds of ends, and motions."""

import os
import pickle
from pathlib import Path
from xml.etree import ElementTree

import leastcost as lc
import numpy as np
import pytest

BALL = {"type": "ball", "center": [0, 0.05, 0.35], "radius": 0.25}

# Two links of length 1 and 0.5 in the plane z = 0, and a hand at their end.
ARM = """<robot name="two">
  <link name="base"/>
  <link name="upper"><collision><origin xyz="0.5 0 0" rpy="0 1.5707963267948966 0"/>
    <geometry><capsule length="0.9" radius="0.05"/></geometry></collision></link>
  <link name="lower"><collision><origin xyz="0.25 0 0" rpy="0 1.5707963267948966 0"/>
    <geometry><capsule length="0.4" radius="0.05"/></geometry></collision></link>
  <link name="hand"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="2"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="1 0 0"/>
    <axis xyz="0 0 1"/><limit lower="-2.5" upper="2.5" velocity="3"/></joint>
  <joint name="wrist" type="fixed"><parent link="lower"/><child link="hand"/>
    <origin xyz="0.5 0 0" rpy="0 0 1.5707963267948966"/></joint>
</robot>"""
POST = {"type": "ball", "center": [1.1, 0.5, 0], "radius": 0.1}


@pytest.fixture
def two(tmp_path) -> lc.Robot:
    (tmp_path / "two.urdf").write_text(ARM)
    return lc.Robot.read(tmp_path / "two.urdf", tool="hand")


@pytest.fixture
def gantry(configs) -> lc.Robot:
    data = configs / "data"
    return lc.Robot.read(data / "gantry_arm.urdf", srdf=data / "gantry_arm.srdf", group="arm", hold_state="open")


def hand_of_two(q):
    """By hand: position, and the angle of the hand."""
    angle = q[0] + q[1]
    return [np.cos(q[0]) + 0.5 * np.cos(angle), np.sin(q[0]) + 0.5 * np.sin(angle), 0], angle + np.pi / 2


def test_what_a_robot_knows(two, gantry):
    assert two.joints == [lc.Joint("shoulder", -3, 3, 2), lc.Joint("elbow", -2.5, 2.5, 3)]
    assert two.links == ["base", "hand", "lower", "upper"] and two.states == {}
    assert repr(two) == "<leastcost.Robot: shoulder, elbow>"
    assert [joint.name for joint in gantry.joints] == ["rail", "shoulder", "elbow", "roll"]
    assert gantry.joints[3].velocity == np.inf and gantry.joints[3].lower == -np.inf
    assert sorted(gantry.states) == ["left_bin", "right_bin"]
    assert gantry.states["left_bin"].tolist() == [-0.7, 0.3, -0.4, 0]


def test_where_the_tool_is(two, tmp_path):
    q = [0.4, -1.1]
    position, angle = hand_of_two(q)
    pose = two.pose(q)
    assert np.allclose(pose.position, position)
    assert np.allclose(pose.rotation, lc.Pose([0, 0, 0], rpy=[0, 0, angle]).rotation)
    assert np.allclose(two.pose(q, "lower").position, [np.cos(0.4), np.sin(0.4), 0])
    offset = lc.Robot.read(tmp_path / "two.urdf", tool={"link": "hand", "offset": [0.1, 0, 0.2]})
    assert np.allclose(offset.pose(q).position, two.pose(q).matrix @ [0.1, 0, 0.2, 1] @ np.eye(4)[:, :3])
    with pytest.raises(lc.Error, match="has no link 'foot'; it has: base, hand, lower, upper"):
        two.pose(q, "foot")
    with pytest.raises(lc.Error, match="has no link 'foot'"):
        lc.Robot.read(tmp_path / "two.urdf", tool="foot")


def test_a_path_equals_that_of_the_configuration(gantry, configs):
    of_file = lc.run(configs / "robot_from_urdf.yaml", set={"path.points": 30})
    own = gantry.find_path(
        "left_bin",
        "right_bin",
        obstacles=[BALL, {"type": "box", "lower": [-0.25, -0.4, 0], "upper": [-0.15, -0.1, 0.8]}],
        clearance=0.01,
        points=30,
    )
    assert own.certified and own.cost == of_file.cost and np.array_equal(own.points, of_file.points)
    copy = pickle.loads(pickle.dumps(gantry))
    again = lc.find_path(
        copy, None, gantry.states["left_bin"], "right_bin", obstacles=[BALL], clearance=0.01, points=30
    )
    assert again.certified


def test_goals_and_poses(two):
    source = [-0.5, 0.3]
    goals = np.array([[0.9, 1.0], [2.5, -1.0]])
    to_goals = two.find_path(source, goals, obstacles=[POST], clearance=0.01)
    assert to_goals.certified and np.allclose(to_goals.points[-1], goals[0])
    pose = two.pose([0.9, 1.0])
    reached = two.find_path(source, lc.Pose(pose.position), obstacles=[POST], clearance=0.01)
    assert reached.certified and np.allclose(two.pose(reached.points[-1]).position, pose.position)
    turned = two.find_path(source, pose, obstacles=[POST], clearance=0.01)
    assert np.allclose(turned.points[-1], [0.9, 1.0], atol=1e-6)  # of two ways, that with this angle
    tips = np.array([hand_of_two(q)[0][:2] for q in turned.points])
    assert np.linalg.norm(tips - [1.1, 0.5], axis=1).min() > 0.1


def test_a_scene(two, tmp_path):
    (tmp_path / "scene.yaml").write_text("objects:\n  - {id: post, type: ball, center: [1.1, 0.5, 0], radius: 0.1}\n")
    with_scene = two.find_path([-0.5, 0.3], [0.9, 1.0], scene=tmp_path / "scene.yaml", clearance=0.01, points=40)
    with_ball = two.find_path([-0.5, 0.3], [0.9, 1.0], obstacles=[POST], clearance=0.01, points=40)
    assert with_scene.cost == pytest.approx(with_ball.cost, rel=1e-12) and with_scene.certified


def test_what_it_carries_keeps_clear(tmp_path, two):
    stick = {"id": "stick", "link": "hand", "type": "capsule", "from": [0, 0, 0], "to": [0, 0.4, 0], "radius": 0.03}
    holding = lc.Robot.read(tmp_path / "two.urdf", attached=[stick])
    source, target = [-0.5, 0.3], [0.9, 1.0]
    alone = two.find_path(source, target, obstacles=[POST], clearance=0.01)
    path = holding.find_path(source, target, obstacles=[POST], clearance=0.01)
    assert path.certified and path.cost > alone.cost
    with pytest.raises(lc.ConfigError, match="has no link 'claw'"):
        lc.Robot.read(tmp_path / "two.urdf", attached=[{**stick, "link": "claw"}])


def test_a_cost_of_its_own(two):
    def shoulder_is_dear(a, b):
        return 9 * (b - a)[0] ** 2 + (b - a)[1] ** 2

    path = lc.find_path(two, shoulder_is_dear, [-0.5, 0.3], [0.9, 1.0], obstacles=[POST], clearance=0.01)
    length = two.find_path([-0.5, 0.3], [0.9, 1.0], obstacles=[POST], clearance=0.01)
    moves = np.diff(length.points, axis=0)
    assert path.certified and path.cost < np.sqrt(9 * moves[:, 0] ** 2 + moves[:, 1] ** 2).sum()


def test_a_motion(two, gantry):
    path = two.find_path([-0.5, 0.3], [0.9, 1.0], obstacles=[POST], clearance=0.01)
    motion = path.trajectory(acceleration=6, interval=0.005)
    assert motion.names == ["shoulder", "elbow"] and not motion.touches
    assert motion.times[0] == 0 and motion.times[-1] == motion.duration >= motion.least_duration
    assert motion.positions.shape == motion.velocities.shape == motion.accelerations.shape == (len(motion.times), 2)
    assert np.allclose(motion.positions[[0, -1]], [[-0.5, 0.3], [0.9, 1.0]])
    assert np.all(np.abs(motion.velocities) <= np.array([2, 3]) + 1e-9)  # those of the URDF
    assert np.all(np.abs(motion.accelerations) <= 6 + 1e-9)
    moved = np.diff(motion.positions, axis=0) / np.diff(motion.times)[:, None]
    assert np.allclose(moved, (motion.velocities[1:] + motion.velocities[:-1]) / 2, atol=0.05)
    assert path.trajectory(velocity=0.5, acceleration=6).duration > motion.duration
    with pytest.raises(lc.InputError, match="acceleration is needed: .*joint_limits.yaml of MoveIt"):
        path.trajectory()
    with pytest.raises(lc.InputError, match="one number, or one for each of the 2"):
        path.trajectory(velocity=[1, 2, 3], acceleration=1)
    other = gantry.find_path("left_bin", "right_bin", obstacles=[BALL], clearance=0.01, points=30)
    with pytest.raises(lc.InputError, match="velocity is needed: .* none for the joint 'roll'"):
        other.trajectory(acceleration=1)
    with pytest.raises(lc.OutputError, match="pickled"):
        pickle.loads(pickle.dumps(path)).trajectory(acceleration=1)


def test_limits_from_a_file_of_moveit(two, tmp_path):
    path = two.find_path([-0.5, 0.3], [0.9, 1.0], obstacles=[POST], clearance=0.01)
    file = tmp_path / "joint_limits.yaml"
    joints = {"shoulder": 6, "elbow": 3}
    lines = [f"  {name}: {{has_acceleration_limits: true, max_acceleration: {a}}}" for name, a in joints.items()]
    file.write_text("joint_limits:\n" + "\n".join(lines))
    motion = path.trajectory(limits=file)
    assert motion.duration == path.trajectory(acceleration=[6, 3]).duration and motion.notes == []
    assert path.trajectory(limits=str(file), acceleration=6).duration == path.trajectory(acceleration=6).duration
    file.write_text("default_acceleration_scaling_factor: 0.5\n" + file.read_text())
    slow = path.trajectory(limits=file)
    assert slow.duration == path.trajectory(acceleration=[3, 1.5]).duration
    assert "default_acceleration_scaling_factor" in slow.notes[0]
    with pytest.raises(lc.InputError, match="none.yaml"):
        path.trajectory(limits=tmp_path / "none.yaml")
    with pytest.raises(lc.InputError, match="limits has limits of joints, but there is no robot"):
        lc.find_path(lc.Plane(), None, (0, 0), (3, 4)).trajectory(limits=file)


def test_a_motion_in_the_plane():
    path = lc.find_path(lc.Plane(), None, (0, 0), (3, 4))
    motion = path.trajectory(velocity=10, acceleration=1)
    assert motion.duration == pytest.approx(2 * (4 / 1) ** 0.5) and motion.names == ["x", "y"]  # y alone is as quick
    with pytest.raises(lc.InputError, match="velocity: .*limits of both"):
        path.trajectory(acceleration=1)


@pytest.mark.parametrize(
    "source, target, message",
    [
        ([0, 0, 0], [1, 1], r"source has the shape \(3,\); a configuration of .* has 2 finite numbers"),
        ([0, np.nan], [1, 1], "source has the shape"),
        ("home", [1, 1], "source is 'home', and the robot's states are none"),
        ([0, 0], np.eye(4), r"goals of .* have the shape \(k, 2\).*Pose.of_matrix"),
        ([0, 0], np.zeros((0, 2)), "target has the shape"),
        (lc.Pose([1, 0, 0]), [1, 1], "a path starts at a configuration"),
        ([0, 0], "x", "target is 'x'"),
    ],
)
def test_ends_are_refused_in_words(two, source, target, message):
    with pytest.raises(lc.InputError, match=message):
        two.find_path(source, target, obstacles=[POST])


def test_poses():
    turn = lc.Pose([1, 2, 3], rpy=[0.3, -0.4, 2.9])
    assert np.allclose(turn.rotation @ turn.rotation.T, np.eye(3)) and turn.matrix.shape == (4, 4)
    for given in (lc.Pose.of_matrix(turn.matrix), lc.Pose([1, 2, 3], quaternion=turn.config()["quaternion"])):
        assert np.allclose(given.matrix, turn.matrix)
    half = lc.Pose([0, 0, 0], np.diag([-1, -1, 1]))
    assert np.allclose(lc.Pose([0, 0, 0], quaternion=half.config()["quaternion"]).rotation, half.rotation)
    for arguments, message in [
        (dict(position=[0, 0]), "position is"),
        (dict(position=[0, 0, 0], rotation=np.diag([1, 1, -1])), "must be a rotation matrix"),
        (dict(position=[0, 0, 0], rotation=np.eye(4)), r"matrix of shape \(3, 3\)"),
        (dict(position=[0, 0, 0], rpy=[0, 0, 0], quaternion=[1, 0, 0, 0]), "at most one"),
        (dict(position=[0, 0, 0], quaternion=[0, 0, 0, 0]), "quaternion is 0"),
    ]:
        with pytest.raises(lc.InputError, match=message):
            lc.Pose(**arguments)
    with pytest.raises(lc.InputError, match="has no matrix"):
        lc.Pose([0, 0, 0]).matrix


def test_other_robots_and_places_of_robots(two):
    arm = lc.Robot(lc.robot.dh_arm(model="ur5"))
    assert len(arm.joints) == 6 and arm.pose(np.zeros(6)).matrix.shape == (4, 4)
    with pytest.raises(lc.ConfigError, match="a robot goes under 'robot'"):
        lc.run({"manifold": two, "cost": "euclidean", "ends": {}})
    ends = {"source": {"point": [-0.5, 0.3]}, "target": {"point": [0.9, 1.0]}}
    config = {"manifold": "robot", "robot": two, "obstacles": [POST], "clearance": 0.01, "cost": "euclidean"}
    assert lc.run({**config, "ends": ends}).certified
    with pytest.raises(lc.InputError, match="no_such.urdf"):
        lc.Robot.read("no_such.urdf")


def test_the_panda():
    """Of the data that the tests in C++ use, too."""
    folder = Path(os.environ.get("LEASTCOST_DATA") or Path(__file__).parents[3] / "shared/data") / "planning/mbm"
    if not (folder / "panda.urdf").exists():
        pytest.skip("there is no planning/mbm/panda.urdf in the test data (LEASTCOST_DATA)")
    panda = lc.Robot.read(folder / "panda.urdf", srdf=folder / "panda.srdf", group="panda_arm", tool="panda_hand")
    joints = {joint.get("name"): joint for joint in ElementTree.parse(folder / "panda.urdf").getroot().iter("joint")}
    fastest = [float(joints[joint.name].find("limit").get("velocity")) for joint in panda.joints]
    assert [joint.velocity for joint in panda.joints] == fastest and len(fastest) == 7
    ready = panda.states["ready"]
    hand = panda.pose(ready)
    assert np.allclose(hand.position, [0.3069, 0, 0.5903], atol=2e-3)  # published for this state
    goal = lc.Pose(hand.position + [0.1, 0.2, -0.1], hand.rotation)
    below = {"type": "box", "size": [0.6, 0.6, 0.1], "pose": {"position": [0.5, 0.1, 0.2], "rpy": [0, 0, 0.3]}}
    path = panda.find_path("ready", goal, obstacles=[below], clearance=0.01, max_seconds=60)
    assert np.allclose(panda.pose(path.points[-1]).position, goal.position, atol=1e-6)
    motion = path.trajectory(acceleration=5)
    assert np.all(np.abs(motion.velocities).max(axis=0) <= np.array(fastest) + 1e-9)
