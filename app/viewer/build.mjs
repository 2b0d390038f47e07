// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// build.mjs VIEWER_JS OUTPUT_CPP: bundles the viewer with three.js and writes it as a C++ string. Needs the packages of package.json in node_modules
// beside this file; no network.
import { writeFileSync } from "node:fs";
import { build } from "esbuild";

const [entry, output] = process.argv.slice(2);
const bundle = await build({
  entryPoints: [entry],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  charset: "ascii",
  legalComments: "inline", // the licence notice of three.js stays
  nodePaths: [new URL("node_modules", import.meta.url).pathname],
  write: false,
  logLevel: "warning",
});
// Within a page, nothing may end its script element.
const script = bundle.outputFiles[0].text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const pieces = script.match(/[\s\S]{1,12000}/g).map((piece) => `R"leastcost(${piece})leastcost"`);
writeFileSync(
  output,
  `// Made by build.mjs out of viewer.js and three.js (MIT); do not edit.
#include "app/report/page/viewer_script.hpp"

namespace leastcost::app {

std::string_view viewer_script() {
  static constexpr char script[] =
${pieces.join("\n")};
  return {script, sizeof(script) - 1};
}

}  // namespace leastcost::app
`,
);
