// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The 3D view of a report: reads the scene beside it, draws on demand, and leaves the still picture in place where there is no WebGL.
import {
  BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, HemisphereLight, LineBasicMaterial, LineSegments,
  Mesh, MeshStandardMaterial, PerspectiveCamera, Points, Scene, ShaderMaterial, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";

const dark = matchMedia("(prefers-color-scheme: dark)").matches;
const colours = {
  surface: dark ? "#8d8a84" : "#d9d4c9",
  path: dark ? "#4aa3dc" : "#0072B2",
  first: dark ? "#c9c6c0" : "#4d4d4d",
  other: dark ? "#33bd93" : "#009E73",
  end: dark ? "#ef8244" : "#D55E00",
  point: dark ? "#1c1c1b" : "#ffffff",
  box: dark ? "#7a7771" : "#8a867e",
};
// Lines are drawn a little nearer to the eye than they are, so that neither rounding nor the triangles hide them.
const towardsEye = 0.004;

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

/** Points of a cloud: round discs, lit like the surfaces. */
function surfels(points, ball) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(inBall(points.positions, ball), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(points.normals), 3));
  const material = new ShaderMaterial({
    uniforms: { size: { value: 1.55 * points.spacing / ball.radius }, height: { value: 1 }, colour: { value: new Color(colours.surface) } },
    vertexShader: `uniform float size, height; varying float light;
      void main() {
        vec4 p = modelViewMatrix * vec4(position, 1.0);
        vec3 n = normalize(normalMatrix * normal);
        light = 0.42 + 0.58 * abs(dot(n, normalize(vec3(-0.35, 0.5, 1.0))));
        gl_Position = projectionMatrix * p;
        gl_PointSize = max(1.5, size * height * projectionMatrix[1][1] / gl_Position.w);
      }`,
    fragmentShader: `uniform vec3 colour; varying float light;
      void main() {
        if (length(gl_PointCoord - 0.5) > 0.5) discard;
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

function build(data) {
  const ball = ballAround(data), scene = new Scene(), near = new Group(), layers = {};
  if (data.surface) scene.add(surfaceMesh(data.surface, ball));
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
  return { scene, near, layers, seen };
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
    for (const toggle of this.stage.parentElement.querySelectorAll("input[data-layer]"))
      toggle.addEventListener("change", () => { this.layers[toggle.dataset.layer].visible = toggle.checked; this.render(); });
    new ResizeObserver(() => this.resize()).observe(this.stage);
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
    this.near.scale.setScalar(1 - towardsEye);
    this.near.position.copy(this.camera.position).multiplyScalar(towardsEye);
    this.renderer.render(this.scene, this.camera);
  }
}

function start() {
  const stage = document.getElementById("stage"), source = document.getElementById("scene");
  if (!stage || !source) return;
  try {
    const viewer = new Viewer(stage, JSON.parse(source.textContent));
    document.documentElement.dataset.viewer = "webgl";
    viewer.resize();
  } catch (error) {
    document.documentElement.dataset.viewer = "still";
    document.getElementById("no-webgl").hidden = false;
  }
  document.documentElement.dataset.ready = "1";
}

start();
