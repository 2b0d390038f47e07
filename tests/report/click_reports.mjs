// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// click_reports.mjs CHROMIUM SCREENSHOTS REPORT=KIND...: asks reports for paths between two clicked points (KIND mesh or plan), and between two that are typed, on
// screens of three widths, light and dark, from the disk and without a network; and once without WebAssembly. Fails where there is no proved answer.
import { mkdirSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { openBrowser, watch } from "./browser.mjs";

const [executablePath, screenshots, ...reports] = process.argv.slice(2);
mkdirSync(screenshots, { recursive: true });
const browser = await openBrowser(executablePath);

const state = (page, name) => page.evaluate((key) => document.documentElement.dataset[key], name);

/** Waits for the answer to the last question; a fault, or nothing. */
async function faultOfAnswer(page, which) {
  await page.waitForFunction(() => !["waiting", undefined].includes(document.documentElement.dataset.asked), null, { timeout: 60000 }).catch(() => {});
  const asked = await state(page, "asked"), text = await page.locator("#ask-answer").textContent();
  await page.evaluate(() => { delete document.documentElement.dataset.asked; });
  if (asked !== "proved") return [`${which}: '${asked}', not 'proved': ${text}`];
  const yaml = await page.locator("#ask-yaml").textContent(), python = await page.locator("#ask-python").textContent();
  const found = [];
  if (!/proved: no path is shorter/.test(text)) found.push(`${which}: no proof in '${text}'`);
  if (!/^ends:\n {2}source: \{.+\}\n {2}target: \{.+\}$/.test(yaml)) found.push(`${which}: YAML is '${yaml}'`);
  if (!/^import leastcost as lc\n/.test(python)) found.push(`${which}: Python is '${python}'`);
  return found;
}

async function open(file, { width, colorScheme, found, without = false }) {
  const address = pathToFileURL(resolve(file)).href, page = await browser.context.newPage();
  if (without) await page.addInitScript(() => { delete globalThis.WebAssembly; });
  watch(page, address, /^(data|blob):/, found);
  await page.emulateMedia({ colorScheme });
  await page.setViewportSize({ width, height: 900 });
  await page.goto(address, { waitUntil: "load" });
  return page;
}

/** Two clicks into the picture, at shares of its size. */
async function click(page, kind, shares) {
  const picture = page.locator(kind === "mesh" ? "#stage canvas" : "#plane svg.clickable");
  await picture.scrollIntoViewIfNeeded();
  const box = await picture.boundingBox();
  for (const [x, y] of shares) await picture.click({ position: { x: x * box.width, y: y * box.height } });
}

async function faults(file, kind, width, colorScheme) {
  const found = [], page = await open(file, { width, colorScheme, found });
  if (await state(page, "clicks") !== "ready") found.push("the page does not answer clicks");
  else {
    await click(page, kind, kind === "mesh" ? [[0.47, 0.5], [0.55, 0.6]] : [[0.14, 0.12], [0.9, 0.74]]);
    found.push(...(await faultOfAnswer(page, "clicks")));
    const answer = await page.locator("#ask-answer").boundingBox(), height = page.viewportSize().height;
    if (answer.y < 0 || answer.y + answer.height > height + 1) found.push(`the answer of a click is at ${answer.y} to ${answer.y + answer.height} of ${height} px`);
    await page.screenshot({ path: join(screenshots, `${basename(dirname(resolve(file)))}_${width}_${colorScheme}.png`), fullPage: false });
    // By keyboard: from field to field, and Enter.
    await page.locator("#ask-from").fill(kind === "mesh" ? "0" : "0, 0");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Control+A");
    await page.keyboard.type(kind === "mesh" ? "5" : "9, 0.2");
    await page.keyboard.press("Enter");
    found.push(...(await faultOfAnswer(page, "keyboard")));
    // What is no end is said, and asks nothing.
    await page.locator("#ask-to").fill("nowhere");
    await page.keyboard.press("Enter");
    const said = await page.locator("#ask-answer").textContent();
    if (!/^to: give/.test(said)) found.push(`'nowhere' as an end: '${said}'`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    if (wide > 1) found.push(`the page is ${wide} px wider than the window`);
  }
  await page.close();
  return found;
}

async function faultsWithout(file) {
  const found = [], page = await open(file, { width: 800, colorScheme: "light", found, without: true });
  const said = await page.locator("#ask-answer").textContent();
  if (!/no WebAssembly/.test(said)) found.push(`without WebAssembly the page says '${said}'`);
  if (await page.locator("#ask-form").isVisible()) found.push("without WebAssembly the fields are there");
  await page.close();
  return found;
}

let failed = 0;
const tell = (name, found) => {
  console.log(`${name}: ${found.length === 0 ? "fine" : "\n  " + found.join("\n  ")}`);
  failed += found.length;
};
for (const report of reports) {
  const [file, kind] = report.split("=");
  for (const width of [400, 800, 1400])
    for (const scheme of ["light", "dark"]) tell(`${file}, ${width} px, ${scheme}`, await faults(file, kind, width, scheme));
}
tell("without WebAssembly", await faultsWithout(reports[0].split("=")[0]));
await browser.close();
process.exit(failed === 0 ? 0 : 1);
