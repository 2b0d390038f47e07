// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The 3D view of a report: reads the scene beside it, draws on demand, and leaves the still picture in place where there is no WebGL.
import {
  BufferAttribute, BufferGeometry, CapsuleGeometry, Color, DirectionalLight, DoubleSide, EdgesGeometry, FrontSide, Group, HemisphereLight,
  LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial, PerspectiveCamera, Points, Raycaster, Scene, ShaderMaterial, Triangle, Vector2,
  Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";

const dark = matchMedia("(prefers-color-scheme: dark)").matches;
const colours = {
  surface: dark ? "#8d8a84" : "#d9d4c9",
  path: dark ? "#4aa3dc" : "#0072B2",
  first: dark ? "#c9c6c0" : "#4d4d4d",
  other: dark ? "#33bd93" : "#009E73",
  end: dark ? "#ef8244" : "#D55E00",
  point: dark ? "#1c1c1b" : "#ffffff",
  box: dark ? "#7a7771" : "#8a867e",
  ground: dark ? "#3a3936" : "#efeeea",
  edge: dark ? "#bdbab4" : "#6b675f",
  hand: dark ? "#ef8244" : "#D55E00",
  start: "#70beec",
  between: "#3898cf",
  target: "#0072B2",
  asked: dark ? "#e58fc4" : "#a3307f",
};
// Lines are drawn a little nearer to the eye than they are, so that neither rounding nor triangles, nor the discs of a cloud, hide them.
const towardsEye = { surface: 0.004, cloud: 0.012 };

/** Centre and radius of the ball that the view has to show. */
function ballAround(data) {
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
  const grow = (flat) => {
    for (let i = 0; i + 2 < flat.length; i += 3) {
      const p = new Vector3(flat[i], flat[i + 1], flat[i + 2]);
      low.min(p);
      high.max(p);
    }
  };
  for (const flat of [data.surface?.vertices, data.points?.positions, data.lines.path, data.lines.first]) if (flat) grow(flat);
  const centre = low.clone().add(high).multiplyScalar(0.5);
  return { centre, radius: Math.max(high.distanceTo(low) / 2, 1e-300) };
}

/** How far the eye has to be from the centre, in direction `home`, to see all of `flat` (coordinates in the ball). */
function distanceToSee(flat, home, up, tangent, aspect) {
  const right = new Vector3().crossVectors(up, home).normalize(), above = new Vector3().crossVectors(home, right), p = new Vector3();
  let distance = 0.2;
  for (let i = 0; i < flat.length; i += 3) {
    p.set(flat[i], flat[i + 1], flat[i + 2]);
    const across = Math.max(Math.abs(p.dot(right)) / (tangent * aspect), Math.abs(p.dot(above)) / tangent);
    distance = Math.max(distance, p.dot(home) + 1.07 * across);
  }
  return distance;
}

/** Coordinates relative to the ball: single precision then costs nothing, and every scene has the size of 1. */
function inBall(flat, { centre, radius }) {
  const out = new Float32Array(flat.length);
  for (let i = 0; i < flat.length; i += 3) {
    out[i] = (flat[i] - centre.x) / radius;
    out[i + 1] = (flat[i + 1] - centre.y) / radius;
    out[i + 2] = (flat[i + 2] - centre.z) / radius;
  }
  return out;
}

function surfaceMesh(surface, ball) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(inBall(surface.vertices, ball), 3));
  geometry.setIndex(new BufferAttribute(new Uint32Array(surface.triangles), 1));
  geometry.computeVertexNormals();
  const material = new MeshStandardMaterial({
    color: colours.surface, roughness: 0.78, metalness: 0, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  return new Mesh(geometry, material);
}

/** Points of a cloud: round discs in the tangent planes, lit like the surfaces. */
function surfels(points, ball) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(inBall(points.positions, ball), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(points.normals), 3));
  const material = new ShaderMaterial({
    uniforms: { radius: { value: 0.85 * points.spacing / ball.radius }, height: { value: 1 }, colour: { value: new Color(colours.surface) } },
    vertexShader: `uniform float radius, height; varying vec3 centre, facing;
      void main() {
        vec4 p = modelViewMatrix * vec4(position, 1.0);
        centre = p.xyz;
        facing = normalize(normalMatrix * normal);
        gl_Position = projectionMatrix * p;
        gl_PointSize = max(2.0, 2.0 * radius * height * projectionMatrix[1][1] / gl_Position.w);
      }`,
    fragmentShader: `uniform mat4 projectionMatrix; uniform vec3 colour; uniform float radius; varying vec3 centre, facing;
      void main() {
        vec3 n = normalize(facing);
        vec2 q = 2.0 * radius * (gl_PointCoord - 0.5) * vec2(1.0, -1.0);
        float z = -dot(n.xy, q) / (sign(n.z + 1e-9) * max(abs(n.z), 0.2));
        if (dot(q, q) + z * z > radius * radius) discard;
        vec4 place = projectionMatrix * vec4(centre + vec3(q, z), 1.0);
        gl_FragDepth = 0.5 + 0.5 * place.z / place.w;
        float light = 0.42 + 0.58 * abs(dot(n, normalize(vec3(-0.35, 0.5, 1.0))));
        gl_FragColor = vec4(colour * light, 1.0);
        #include <colorspace_fragment>
      }`,
  });
  return new Points(geometry, material);
}

/** A line of constant width on the screen; where the surface hides it, a faint one. */
function line(flat, ball, { colour, width, dashed = false, order = 2 }) {
  const group = new Group();
  const geometry = new LineGeometry().setPositions(inBall(flat, ball));
  const add = (options) => {
    const material = new LineMaterial({ color: colour, linewidth: width, dashed, dashSize: 0.03, gapSize: 0.02, alphaToCoverage: false, ...options });
    const drawn = new Line2(geometry, material);
    if (dashed) drawn.computeLineDistances();
    drawn.renderOrder = order;
    group.add(drawn);
  };
  add({ depthTest: false, depthWrite: false, transparent: true, opacity: 0.16 });
  add({ depthTest: true });
  return group;
}

/** Round markers of constant size on the screen, with a rim; faint where `hidden` says so and the surface hides them. */
function markers(flat, ball, { fill, rim, size, order = 4, hidden = 0 }) {
  const group = new Group();
  if (hidden > 0) group.add(discs(flat, ball, { fill, rim, size, order, opacity: hidden, depthTest: false }));
  group.add(discs(flat, ball, { fill, rim, size, order, opacity: 1, depthTest: true }));
  return group;
}

function discs(flat, ball, { fill, rim, size, order, opacity, depthTest }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(inBall(flat, ball), 3));
  const material = new ShaderMaterial({
    transparent: true, depthTest, depthWrite: depthTest,
    uniforms: { size: { value: size * Math.min(devicePixelRatio, 2) }, opacity: { value: opacity }, fill: { value: new Color(fill) }, rim: { value: new Color(rim) } },
    vertexShader: `uniform float size;
      void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); gl_PointSize = size; }`,
    fragmentShader: `uniform vec3 fill, rim; uniform float size, opacity;
      void main() {
        float r = length(gl_PointCoord - 0.5) * size, edge = 0.5 * size;
        float inside = 1.0 - smoothstep(edge - 1.0, edge, r);
        if (inside <= 0.0) discard;
        gl_FragColor = vec4(mix(fill, rim, smoothstep(0.62 * edge - 0.7, 0.62 * edge + 0.7, r)), inside * opacity);
        #include <colorspace_fragment>
      }`,
  });
  const drawn = new Points(geometry, material);
  drawn.renderOrder = order;
  return drawn;
}

/** The edges of a box, as far as it is finite. */
function boxEdges({ lower, upper }, ball) {
  if ([...lower, ...upper].some((side) => side === null)) return null;
  const corner = (k) => [0, 1, 2].map((i) => ((k >> i) & 1 ? upper : lower)[i]);
  const flat = [];
  for (let a = 0; a < 8; ++a)
    for (let i = 0; i < 3; ++i) if (!((a >> i) & 1)) flat.push(...corner(a), ...corner(a | (1 << i)));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(inBall(flat, ball), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: colours.box }));
}

const uprightCapsule = new Vector3(0, 1, 0), numbersOfFrame = 7, numbersOfCapsule = 8, numbersOfPlate = 10;

/** The corners of the part of a workspace that is worth a look. */
function cornersOf({ lower, upper }) {
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [0, 1, 2].map((i) => ((k >> i) & 1 ? upper : lower)[i]));
}

/** Solids with sharp and with smooth edges, the sharp ones drawn. */
function solids(soup, ball, { colour, side, edges }) {
  const shared = new BufferGeometry(), group = new Group();
  if (soup.triangles.length === 0) return group;
  shared.setAttribute("position", new BufferAttribute(inBall(soup.vertices, ball), 3));
  shared.setIndex(new BufferAttribute(new Uint32Array(soup.triangles), 1));
  const material = new MeshStandardMaterial({ color: colour, roughness: 0.8, metalness: 0, side, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  group.add(new Mesh(toCreasedNormals(shared, 0.7), material));
  if (edges) group.add(new LineSegments(new EdgesGeometry(shared, 40), new LineBasicMaterial({ color: colours.edge })));
  return group;
}

/** A robot as one group for each link, so that a pose moves groups only. */
function robotOf(workspace, ball, { colour, opacity = 1 }) {
  const robot = new Group(), at = (flat, i) => new Vector3(flat[i], flat[i + 1], flat[i + 2]).divideScalar(ball.radius);
  const material = new MeshStandardMaterial({ color: colour, roughness: 0.65, metalness: 0, transparent: opacity < 1, opacity, depthWrite: opacity === 1, side: DoubleSide });
  for (let i = 0; i < workspace.poses[0].length; i += numbersOfFrame) robot.add(new Group());
  const { capsules, plates } = workspace;
  for (let i = 0; i < capsules.length; i += numbersOfCapsule) {
    const from = at(capsules, i + 1), to = at(capsules, i + 4), along = to.clone().sub(from);
    const capsule = new Mesh(new CapsuleGeometry(capsules[i + 7] / ball.radius, along.length(), 8, 24), material);
    if (along.length() > 0) capsule.quaternion.setFromUnitVectors(uprightCapsule, along.clone().normalize());
    capsule.position.copy(from).addScaledVector(along, 0.5);
    robot.children[capsules[i]].add(capsule);
  }
  robot.children.forEach((link, number) => {
    const places = [];
    for (let i = 0; i < plates.length; i += numbersOfPlate)
      if (plates[i] === number) for (let k = 1; k < numbersOfPlate; ++k) places.push(plates[i + k] / ball.radius);
    if (places.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
    geometry.computeVertexNormals();
    link.add(new Mesh(geometry, material));
  });
  return robot;
}

/** Moves the links of a robot to where a pose has them. */
function take(robot, frames, ball) {
  robot.children.forEach((link, number) => {
    const i = numbersOfFrame * number, place = new Vector3(frames[i + 4], frames[i + 5], frames[i + 6]);
    link.quaternion.set(frames[i], frames[i + 1], frames[i + 2], frames[i + 3]).normalize();
    link.position.copy(place.sub(ball.centre).divideScalar(ball.radius));
  });
}

function buildWorkspace({ workspace, hand }) {
  const flat = cornersOf(workspace), ball = ballAround({ lines: { path: flat } }), scene = new Scene(), near = new Group(), layers = {};
  scene.add(solids(workspace.ground, ball, { colour: colours.ground, side: FrontSide, edges: false }));
  layers.obstacles = solids(workspace.obstacles, ball, { colour: colours.surface, side: DoubleSide, edges: true });
  layers.start = robotOf(workspace, ball, { colour: colours.start, opacity: 0.35 });
  layers.target = robotOf(workspace, ball, { colour: colours.target, opacity: 0.35 });
  layers.between = robotOf(workspace, ball, { colour: colours.between });
  for (const layer of Object.values(layers)) scene.add(layer);
  take(layers.start, workspace.poses[0], ball);
  take(layers.target, workspace.poses.at(-1), ball);
  layers.path = line(hand, ball, { colour: colours.hand, width: 3, order: 3 });
  near.add(layers.path);
  scene.add(near);
  const pose = (k) => take(layers.between, workspace.poses[k], ball);
  return { scene, near, layers, seen: [inBall(flat, ball)], ball, pose };
}

function build(data) {
  if (data.workspace) return buildWorkspace(data);
  const ball = ballAround(data), scene = new Scene(), near = new Group(), layers = {};
  const surface = data.surface && surfaceMesh(data.surface, ball);
  if (surface) scene.add(surface);
  if (data.points) scene.add(surfels(data.points, ball));
  const box = data.box && boxEdges(data.box, ball);
  if (box) scene.add(box);
  layers.others = new Group();
  for (const other of data.lines.others) layers.others.add(line(other, ball, { colour: colours.other, width: 2, order: 1 }));
  layers.first = line(data.lines.first, ball, { colour: colours.first, width: 2, dashed: true, order: 2 });
  layers.path = line(data.lines.path, ball, { colour: colours.path, width: 4, order: 3 });
  const many = data.markers.length / 3 > 120;
  layers.points = markers(data.markers, ball, { fill: colours.point, rim: colours.path, size: many ? 5 : 7.5, order: 4 });
  layers.ends = markers(data.ends, ball, { fill: colours.end, rim: colours.point, size: 14, order: 5, hidden: 0.4 });
  for (const layer of Object.values(layers)) near.add(layer);
  scene.add(near);
  const seen = [data.surface?.vertices, data.points?.positions, data.lines.path, data.lines.first].filter(Boolean).map((flat) => inBall(flat, ball));
  return { scene, near, layers, seen, ball, surface };
}

/** A lamp beside the head of the viewer, and a sky above it, so that no side is black and no edge of the light is seen. */
function addLights(camera) {
  const lamp = new DirectionalLight("#ffffff", 1.7), sky = new HemisphereLight("#ffffff", "#8f887c", 1.5);
  lamp.position.set(-0.45, 0.55, 1);
  sky.position.set(-0.3, 1, 0.2);
  camera.add(lamp, lamp.target, sky);
  lamp.target.position.set(0, 0, -1);
}

class Viewer {
  constructor(stage, data) {
    this.stage = stage;
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    Object.assign(this, build(data));
    this.towardsEye = data.points ? towardsEye.cloud : towardsEye.surface;
    this.camera = new PerspectiveCamera(26, 1, 0.05, 60);
    this.camera.up.set(...data.view.up);
    this.home = new Vector3(...data.view.direction).normalize();
    addLights(this.camera);
    this.scene.add(this.camera);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableZoom = false;  // the wheel scrolls the page until the view has been touched
    this.controls.addEventListener("change", () => this.render());
    this.listen();
  }

  listen() {
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "3D view. Drag or use the arrow keys to turn, plus and minus to zoom, 0 to reset.");
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    this.canvas.addEventListener("pointerdown", () => { this.controls.enableZoom = true; this.canvas.focus(); });
    this.canvas.addEventListener("blur", () => { this.controls.enableZoom = false; });
    this.canvas.addEventListener("dblclick", () => this.reset());
    this.canvas.addEventListener("pointerdown", (event) => { this.pressed = [event.clientX, event.clientY]; });
    this.canvas.addEventListener("click", (event) => this.click(event));
    if (this.pose) this.slide(document.getElementById("pose"));
    for (const toggle of this.stage.parentElement.querySelectorAll("input[data-layer]"))
      toggle.addEventListener("change", () => { this.layers[toggle.dataset.layer].visible = toggle.checked; this.render(); });
    new ResizeObserver(() => this.resize()).observe(this.stage);
  }

  /** The robot goes where the slider is. */
  slide(slider) {
    const move = () => { this.pose(Number(slider.value)); this.render(); };
    slider.addEventListener("input", move);
    this.pose(Number(slider.value));
    document.getElementById("pose-row").hidden = false;
  }

  key(event) {
    const turn = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    const zoom = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey || !(turn || zoom || event.key === "0")) return;
    event.preventDefault();
    if (event.key === "0") return this.reset();
    const eye = this.camera.position.clone().sub(this.controls.target);
    if (turn) {
      const right = new Vector3().crossVectors(this.camera.up, eye).normalize();
      const angle = eye.angleTo(this.camera.up) + turn[1];
      if (angle > 0.02 && angle < Math.PI - 0.02) eye.applyAxisAngle(right, turn[1]);
      eye.applyAxisAngle(this.camera.up, turn[0]);
    }
    if (zoom) eye.multiplyScalar(zoom);
    this.camera.position.copy(this.controls.target).add(eye);
    this.controls.update();
    this.render();
  }

  /** A click that did not turn the view names a point of the mesh, if the page answers: a vertex within a few pixels, else the place itself. */
  click(event) {
    const answers = globalThis.leastcostClicks?.choose;
    if (!answers || !this.surface || event.detail > 1 || Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) > 4) return;
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const at = new Vector2((2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height), ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    const hit = ray.intersectObject(this.surface)[0];
    if (!hit) return;
    const places = this.surface.geometry.getAttribute("position"), vertices = [hit.face.a, hit.face.b, hit.face.c];
    const corners = vertices.map((v) => new Vector3().fromBufferAttribute(places, v));
    const pixels = corners.map((corner) => {
      const seen = corner.clone().project(this.camera);
      return Math.hypot(((seen.x - at.x) * width) / 2, ((seen.y - at.y) * height) / 2);
    });
    const nearest = pixels.indexOf(Math.min(...pixels));
    const weights = new Triangle(...corners).getBarycoord(hit.point, new Vector3());
    const rounded = weights && [weights.x, weights.y].map((w) => Number(Math.min(Math.max(w, 0), 1).toFixed(3)));
    const usable = rounded && rounded[0] + rounded[1] <= 1;
    answers(hit.faceIndex, usable ? [...rounded, 1 - rounded[0] - rounded[1]] : null, pixels[nearest] < 9 || !usable ? vertices[nearest] : -1);
  }

  /** Ends and path of an answer; coordinates of the mesh. */
  show(ends, points) {
    if (this.asked) this.near.remove(this.asked);
    this.asked = new Group();
    if (points.length > 3) this.asked.add(line(points, this.ball, { colour: colours.asked, width: 4, order: 6 }));
    if (ends.length) this.asked.add(markers(ends.flat(), this.ball, { fill: colours.asked, rim: colours.point, size: 14, order: 7, hidden: 0.4 }));
    this.near.add(this.asked);
    this.render();
  }

  reset() {
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    const distance = Math.max(...this.seen.map((flat) => distanceToSee(flat, this.home, this.camera.up, tangent, this.camera.aspect)));
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(this.home).multiplyScalar(distance);
    this.controls.minDistance = 0.15;
    this.controls.maxDistance = 8 * distance;
    this.controls.update();
    this.render();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.stage;
    if (width === 0 || height === 0) return;
    const first = this.canvas.parentElement === null;
    if (first) this.stage.replaceChildren(this.canvas);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.scene.traverse((object) => {
      const uniform = object.material?.uniforms?.height;
      if (uniform) uniform.value = height * this.renderer.getPixelRatio() * 0.5;
    });
    if (first) this.reset();
    this.render();
  }

  render() {
    // Scaled about the eye, the lines stay where they are on the screen and come nearer.
    this.near.scale.setScalar(1 - this.towardsEye);
    this.near.position.copy(this.camera.position).multiplyScalar(this.towardsEye);
    this.renderer.render(this.scene, this.camera);
  }
}

function start() {
  const stage = document.getElementById("stage"), source = document.getElementById("scene");
  if (!stage || !source) return;
  try {
    const data = JSON.parse(source.textContent), mesh = globalThis.leastcostClicks?.mesh;
    if (mesh) data.surface = mesh;
    const viewer = new Viewer(stage, data);
    globalThis.leastcostView = viewer;
    document.documentElement.dataset.viewer = "webgl";
    viewer.resize();
  } catch (error) {
    document.documentElement.dataset.viewer = "still";
    document.getElementById("no-webgl").hidden = false;
  }
  document.documentElement.dataset.ready = "1";
}

start();
