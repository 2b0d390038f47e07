// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Shortest paths between two clicked points in a report: asks the library, compiled to WebAssembly (solver.cpp), in a worker where the browser lets a page
// of the disk have one. Stands before the 3D view, which draws the mesh that is unpacked here.
(() => {
  "use strict";

  /** What runs in the worker, or in the page: loads the module and answers. Self-contained, as a worker gets its text. */
  function makeSolver() {
    let library, kind, sides;
    const place = (array) => {
      const at = library.give(Math.max(array.byteLength, 8));
      if (at === 0) throw new Error("out of memory");
      new Uint8Array(library.memory.buffer, at, array.byteLength).set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
      return at;
    };
    const text = (at) => {
      const bytes = new Uint8Array(library.memory.buffer);
      let end = at;
      while (bytes[end] !== 0) ++end;
      return new TextDecoder().decode(bytes.slice(at, end));
    };
    const call = (name, ...numbers) => {
      if (library[name](...numbers) !== 1) throw new Error(text(library.fault()));
    };
    async function instance(module) {
      const packed = Uint8Array.from(atob(module), (c) => c.charCodeAt(0));
      const bytes = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
      const view = () => new DataView(library.memory.buffer);
      const none = (a, b) => { view().setUint32(a, 0, true); view().setUint32(b, 0, true); return 0; };
      const system = {
        clock_time_get: (clock, precision, at) => { view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true); return 0; },
        environ_sizes_get: none,
        environ_get: () => 0,
        proc_exit: () => { throw new Error("the search came to a sudden end"); },
      };
      const made = await WebAssembly.instantiate(bytes, { env: { emscripten_notify_memory_growth: () => {} }, wasi_snapshot_preview1: system });
      library = made.instance.exports;
      library._initialize();
    }
    return {
      async load({ module, mesh, plan }) {
        await instance(module);
        kind = mesh ? "mesh" : "plan";
        if (mesh) {
          const coordinates = place(mesh.vertices), corners = place(mesh.triangles);
          call("load_mesh", coordinates, mesh.vertices.length / 3, corners, mesh.triangles.length / 3);
          library.take_back(coordinates);
          library.take_back(corners);
        } else {
          const box = plan.box ?? { lower: [null, null], upper: [null, null] };
          sides = [...box.lower.map((x) => x ?? -Infinity), ...box.upper.map((x) => x ?? Infinity)];
          call("load_plan", place(new Float64Array(plan.corners)), place(new Int32Array(plan.counts)), place(new Float64Array(plan.required)), plan.counts.length,
            place(new Float64Array(sides)));
        }
      },
      /** Ends as numbers: face and barycentric coordinates, or x and y. */
      ask({ source, target, seconds }) {
        const begun = performance.now();
        if (kind === "plan")
          for (const [name, [x, y]] of [["first", source], ["second", target]]) {
            if (x < sides[0] || y < sides[1] || x > sides[2] || y > sides[3]) throw new Error(`the ${name} point is outside the box`);
            if (library.room_at(x, y) < 0) throw new Error(`the ${name} point is within an obstacle or its clearance`);
          }
        call(kind === "mesh" ? "on_mesh" : "in_plane", ...source, ...target, seconds);
        const at = library.answer() / 8, numbers = new Float64Array(library.memory.buffer);
        const dimension = kind === "mesh" ? 3 : 2, count = numbers[at + 3];
        return {
          proved: numbers[at] === 1, length: numbers[at + 1], bound: numbers[at + 2],
          points: Array.from(numbers.slice(at + 4, at + 4 + dimension * count)), seconds: (performance.now() - begun) / 1000,
        };
      },
    };
  }

  if (typeof document === "undefined") {  // a test of the answers alone
    globalThis.leastcostSolver = makeSolver;
    return;
  }

  /** The solver behind messages: its calls become promises. Without workers it runs in the page. */
  async function startSolver(content) {
    const inPage = async () => {
      const solver = makeSolver();
      await solver.load(content);
      return { ask: async (question) => { await new Promise((next) => setTimeout(next, 20)); return solver.ask(question); } };
    };
    const source = `const solver = (${makeSolver})();
      onmessage = async ({ data: [number, name, content] }) => {
        try { postMessage([number, await solver[name](content)]); } catch (error) { postMessage([number, null, error.message]); }
      };`;
    let worker;
    try {
      worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
    } catch (error) {
      return inPage();
    }
    const waiting = new Map();
    let number = 0, failed;
    const send = (name, content) => new Promise((resolve, reject) => { waiting.set(++number, { resolve, reject }); worker.postMessage([number, name, content]); });
    worker.onmessage = ({ data: [which, answer, fault] }) => {
      const { resolve, reject } = waiting.get(which);
      waiting.delete(which);
      fault === undefined ? resolve(answer) : reject(new Error(fault));
    };
    const broken = new Promise((resolve) => { worker.onerror = (event) => { event.preventDefault(); failed = true; resolve(); }; });
    await Promise.race([send("load", content), broken]);
    return failed ? inPage() : { ask: (question) => send("ask", question) };
  }

  /** Numbers as whole ones, each the difference from the one `stride` before, in groups of seven bits (clicks_part.cpp). */
  function unpacked(base64, count, stride) {
    const bytes = atob(base64), out = new Float64Array(count);
    for (let i = 0, at = 0; i < count; ++i) {
      let value = 0, scale = 1, byte;
      do {
        byte = bytes.charCodeAt(at++);
        value += (byte & 127) * scale;
        scale *= 128;
      } while (byte & 128);
      out[i] = (value % 2 === 0 ? value / 2 : -(value + 1) / 2) + (i >= stride ? out[i - stride] : 0);
    }
    return out;
  }

  function unpackedMesh(mesh) {
    let vertices;
    if (mesh.decimals === null) vertices = new Float64Array(Uint8Array.from(atob(mesh.vertices), (c) => c.charCodeAt(0)).buffer);
    else {
      const power = 10 ** mesh.decimals;
      vertices = unpacked(mesh.vertices, 3 * mesh.vertex_count, 3).map((whole) => whole / power);
    }
    const triangles = new Int32Array(unpacked(mesh.triangles, 3 * mesh.triangle_count, 1));
    return { vertices, triangles, numbers: mesh.numbers === undefined ? null : unpacked(mesh.numbers, mesh.vertex_count, 1) };
  }

  /** As many digits as the bar leaves: the last one is that of the bar's first. */
  function digits(value, bar) {
    const decimals = Math.ceil(-Math.log10(Math.max(bar, 1e-14 * Math.abs(value))) - 1e-9);
    return decimals >= 0 ? value.toFixed(Math.min(decimals, 100)) : String(Math.round(value / 10 ** -decimals) * 10 ** -decimals);
  }

  const source = document.getElementById("clicks");
  if (!source) return;
  const data = JSON.parse(source.textContent), panel = document.getElementById("ask"), say = document.getElementById("ask-answer"),
    lines = document.getElementById("ask-lines"), inputs = [document.getElementById("ask-from"), document.getElementById("ask-to")];
  const mesh = data.mesh ? unpackedMesh(data.mesh) : null;
  globalThis.leastcostClicks = { mesh };
  // On a small screen the panel is below the picture: what is said after a click stays in sight.
  let clicked = false, away = false;
  const stayInSight = () => say.classList.toggle("afloat", clicked && away);
  new IntersectionObserver((entries) => {
    away = !entries.at(-1).isIntersecting;
    stayInSight();
  }).observe(document.getElementById("ask-form"));
  const speak = (text) => { say.textContent = text; };
  if (typeof WebAssembly !== "object" || typeof DecompressionStream !== "function") {
    document.documentElement.dataset.clicks = "none";
    document.getElementById("ask-form").hidden = true;
    speak("This browser has no WebAssembly, so the page cannot search for other paths. “leastcost run” can.");
    return;
  }

  // --- ends -----------------------------------------------------------------------------------------------------------------------------------------------

  const cornerOf = [];  // of a mesh: a halfedge that leaves a vertex
  if (mesh) mesh.triangles.forEach((v, i) => { cornerOf[v] = i; });
  const positionOf = (v) => Array.from(mesh.vertices.slice(3 * v, 3 * v + 3));
  const fileNumber = (v) => (mesh.numbers ? mesh.numbers[v] : v);

  function vertexEnd(v) {
    const at = cornerOf[v], weights = [0, 0, 0], number = fileNumber(v), position = positionOf(v);
    weights[at % 3] = 1;
    const named = number >= 0;
    return {
      ask: [Math.floor(at / 3), ...weights], position, text: named ? String(number) : position.join(", "),
      yaml: named ? `{vertex: ${number}}` : `{point: [${position.join(", ")}]}`, python: named ? String(number) : `[${position.join(", ")}]`,
    };
  }

  function faceEnd(face, weights) {
    const corners = [0, 1, 2].map((k) => positionOf(mesh.triangles[3 * face + k]));
    const position = [0, 1, 2].map((i) => weights.reduce((sum, w, k) => sum + w * corners[k][i], 0));
    const text = position.join(", ");
    return { ask: [face, ...weights], position, text, yaml: `{point: [${text}]}`, python: `[${text}]` };
  }

  function planeEnd(x, y) {
    const text = `${x}, ${y}`;
    return { ask: [x, y], position: [x, y], text, yaml: `{point: [${text}]}`, python: `[${text}]` };
  }

  /** The end that an input names. Throws an Error for people. */
  function typedEnd(input, name) {
    if (input.end && input.end.text === input.value) return input.end;
    const numbers = input.value.trim() === "" ? [] : input.value.split(/[\s,;]+/).filter(Boolean).map(Number);
    if (mesh) {
      const count = mesh.vertices.length / 3, v = mesh.numbers ? mesh.numbers.indexOf(numbers[0]) : numbers[0];
      if (numbers.length !== 1 || !Number.isInteger(v) || v < 0 || v >= count)
        throw new Error(`${name}: give the number of a vertex that a face uses, ${fileNumber(0)} to ${fileNumber(count - 1)}`);
      return vertexEnd(v);
    }
    if (numbers.length !== 2 || !numbers.every(Number.isFinite)) throw new Error(`${name}: give two coordinates, such as 1.5, 2`);
    return planeEnd(...numbers);
  }

  // --- questions and answers ------------------------------------------------------------------------------------------------------------------------------

  const canWait = 30;  // seconds
  let solver, number = 0;
  const view = () => globalThis.leastcostView ?? (mesh ? null : planeView);

  function show(ends, points) { view()?.show(ends.map((end) => end.position), points); }

  function report(ends, answer) {
    const { length, bound, proved, points, seconds } = answer;
    lines.hidden = true;
    if (!Number.isFinite(length) || points.length === 0) {
      speak(proved || length === Infinity && bound === Infinity ? "No path joins these points." : "No path between these points was found.");
      return;
    }
    document.documentElement.dataset.length = String(length);
    const gap = Math.max(length - bound, 0), bar = Math.max(gap, 1e-14 * length);
    const time = seconds < 1 ? `${Math.max(1, Math.round(1000 * seconds))} ms` : `${seconds.toFixed(1)} s`;
    const less = gap > 0 ? `no path is shorter by more than ${bar.toExponential(1)}` : "no path is shorter";
    speak(proved ? `${data.unit} ${digits(length, bar)}, proved: ${less}. (${time})`
      : `${data.unit} ${digits(length, bar)}, not proved to be the least: a path may be shorter by ${bar.toExponential(1)}. (${time})`);
    document.getElementById("ask-yaml").textContent = `ends:\n  source: ${ends[0].yaml}\n  target: ${ends[1].yaml}`;
    document.getElementById("ask-python").textContent = mesh
      ? `import leastcost as lc\nmesh = lc.Mesh.read(${JSON.stringify(data.file)})\npath = mesh.geodesic(${ends[0].python}, ${ends[1].python})`
      : `import leastcost as lc\nresult = lc.run("config.resolved.yaml", set={\n    "ends.source": {"point": ${ends[0].python}},\n    "ends.target": {"point": ${ends[1].python}}})`;
    lines.hidden = false;
  }

  async function ask(ends) {
    const mine = ++number;
    document.documentElement.dataset.asked = "waiting";
    speak("Searching …");
    show(ends, []);
    try {
      if (ends[0].text === ends[1].text) throw new Error("both ends are the same point");
      solver ??= startSolver({ module: document.getElementById("solver").textContent, mesh, plan: data.plan });
      const answer = await (await solver).ask({ source: ends[0].ask, target: ends[1].ask, seconds: canWait });
      if (mine !== number) return;
      show(ends, answer.points);
      report(ends, answer);
      document.documentElement.dataset.asked = answer.proved ? "proved" : "found";
    } catch (error) {
      if (mine !== number) return;
      lines.hidden = true;
      speak(`No answer: ${error.message}.`);
      document.documentElement.dataset.asked = "fault";
    }
  }

  let chosen = [];
  function choose(end) {
    if (chosen.length === 2) chosen = [];
    chosen.push(end);
    clicked = true;
    stayInSight();
    const input = inputs[chosen.length - 1];
    input.value = end.text;
    input.end = end;
    if (chosen.length === 2) return void ask(chosen);
    ++number;
    inputs[1].value = "";
    lines.hidden = true;
    show(chosen, []);
    speak("Click the other end.");
  }

  document.getElementById("ask-form").addEventListener("submit", (event) => {
    event.preventDefault();
    try {
      chosen = [typedEnd(inputs[0], "from"), typedEnd(inputs[1], "to")];
    } catch (error) {
      speak(`${error.message}.`);
      return;
    }
    ask(chosen);
  });
  for (const button of panel.querySelectorAll("button[data-copy]"))
    button.addEventListener("click", () => navigator.clipboard?.writeText(document.getElementById(button.dataset.copy).textContent).then(
      () => { button.textContent = "copied"; setTimeout(() => { button.textContent = "copy"; }, 1500); }, () => {}));

  // --- the plane ------------------------------------------------------------------------------------------------------------------------------------------

  /** Draws into the picture of the plane, which stands in the page as SVG. */
  const planeView = {
    show(ends, points) {
      const { left, top, scale, lower, upper } = data.frame, drawing = document.querySelector("#plane svg");
      const x = (value) => (left + scale * (value - lower)).toFixed(2), y = (value) => (top + scale * (upper - value)).toFixed(2);
      drawing.querySelector("#asked")?.remove();
      const group = document.createElementNS("http://www.w3.org/2000/svg", "g");
      group.id = "asked";
      const add = (name, attributes) => {
        const element = document.createElementNS("http://www.w3.org/2000/svg", name);
        for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
        group.append(element);
      };
      let d = "";
      for (let i = 0; i < points.length; i += 2) d += `${i ? "L" : "M"}${x(points[i])} ${y(points[i + 1])}`;
      if (d) add("path", { class: "asked", d });
      for (const [u, v] of ends) add("circle", { class: "asked-end", cx: x(u), cy: y(v), r: 6 });
      drawing.append(group);
    },
  };

  if (!mesh) {
    const drawing = document.querySelector("#plane svg"), { left, top, scale, lower, upper, width, height } = data.frame;
    drawing.classList.add("clickable");
    const decimals = Math.max(0, Math.ceil(Math.log10(scale)));  // of a pixel
    drawing.addEventListener("click", (event) => {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing.getScreenCTM().inverse());
      if (at.x < left || at.x > left + width || at.y < top || at.y > top + height) return;
      choose(planeEnd(Number((lower + (at.x - left) / scale).toFixed(decimals)), Number((upper - (at.y - top) / scale).toFixed(decimals))));
    });
  }

  // What the 3D view calls.
  globalThis.leastcostClicks.choose = (face, weights, vertex) => choose(vertex >= 0 ? vertexEnd(vertex) : faceEnd(face, weights));
  document.documentElement.dataset.clicks = "ready";
})();
