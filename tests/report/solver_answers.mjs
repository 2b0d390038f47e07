// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// solver_answers.mjs MODULE SCRIPT FOLDER=SOURCE:TARGET...: asks the module of the reports for the path of each run, between two vertices of a mesh or two places
// "x,y" of a plane, and fails unless its length is that of the run to the last printed digit (12), with a proof.
import { readFileSync } from "node:fs";
import { join } from "node:path";

const [moduleFile, script, ...runs] = process.argv.slice(2);
(0, eval)(readFileSync(script, "utf8"));
const module = readFileSync(moduleFile).toString("base64");

let failed = 0;
for (const run of runs) {
  const [folder, ends] = run.split("="), [source, target] = ends.split(":").map((end) => end.split(",").map(Number));
  const data = JSON.parse(readFileSync(join(folder, "clicks.json"), "utf8")), result = JSON.parse(readFileSync(join(folder, "result.json"), "utf8"));
  const mesh = data.mesh && { vertices: new Float64Array(data.mesh.vertices), triangles: new Int32Array(data.mesh.triangles) };
  const corner = ([vertex]) => {
    const at = mesh.triangles.indexOf(vertex), weights = [0, 0, 0];
    weights[at % 3] = 1;
    return [Math.floor(at / 3), ...weights];
  };
  const solver = globalThis.leastcostSolver();
  await solver.load({ module, mesh, plan: data.plan });
  const answer = await solver.ask({ source: mesh ? corner(source) : source, target: mesh ? corner(target) : target, seconds: 60 });
  // Of a plan the run delivers a polyline that is longer by a millionth; what it proves about the path along the circles, it proves to 1e-9.
  const expected = mesh ? result.cost.value : result.global.lower_bound, above = answer.length / expected - 1;
  const right = mesh ? answer.length.toPrecision(12) === expected.toPrecision(12) : above >= 0 && above < 1.1e-9;
  const fine = right && answer.proved && answer.points.length > 3 && answer.bound <= answer.length;
  console.log(`${folder}: ${answer.length} (run: ${expected}), ${answer.proved ? "proved" : "not proved"}: ${fine ? "fine" : "WRONG"}`);
  failed += fine ? 0 : 1;
}
process.exit(failed === 0 ? 0 : 1);
