// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// open_reports.mjs CHROMIUM SCREENSHOTS REPORT[=VIEWER]...: opens reports from the disk in a browser without network and fails when one prints an error, asks for
// anything but itself, breaks out of the width of the window, or, with VIEWER webgl, does not get its 3D view ready. Screenshots are for people.
import { mkdirSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { openBrowser, watch } from "./browser.mjs";

const [executablePath, screenshots, ...reports] = process.argv.slice(2);
mkdirSync(screenshots, { recursive: true });
const browser = await openBrowser(executablePath, {
  viewport: { width: 1200, height: 900 },
  colorScheme: process.env.LEASTCOST_COLOUR_SCHEME ?? "light",
});

/** What is wrong with one report, as a list of sentences. */
async function faults(file, viewer) {
  const found = [], address = pathToFileURL(resolve(file)).href;
  const page = await browser.context.newPage();
  watch(page, address, /^data:/, found);
  await page.goto(address, { waitUntil: "load" });
  if (viewer === "webgl") {
    await page.waitForFunction(() => document.documentElement.dataset.ready === "1", null, { timeout: 20000 }).catch(() => found.push("the ready flag was never set"));
    const state = await page.evaluate(() => document.documentElement.dataset.viewer);
    if (state !== "webgl") found.push(`the 3D view is '${state}', not 'webgl'`);
    // Turned, it has to look different.
    const canvas = page.locator("#stage canvas");
    const before = await canvas.screenshot();
    await canvas.focus();
    for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowRight");
    const after = await canvas.screenshot();
    if (before.equals(after)) found.push("arrow keys do not turn the 3D view");
    await page.keyboard.press("0");
    // A robot goes where the slider is.
    const slider = page.locator("#pose");
    if ((await slider.count()) > 0) {
      if (!(await slider.isVisible())) found.push("the slider of the robot's poses is hidden");
      await slider.focus();
      await page.keyboard.press("Home");
      const atStart = await canvas.screenshot();
      await page.keyboard.press("End");
      if (atStart.equals(await canvas.screenshot())) found.push("the slider does not move the robot");
      for (let i = 0; i < 20; ++i) await page.keyboard.press("ArrowLeft");
    }
  }
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  if (wide > 1) found.push(`the page is ${wide} px wider than the window`);
  await page.evaluate(() => document.querySelectorAll("details:not(.sub)").forEach((part) => { part.open = true; }));
  await page.screenshot({ path: join(screenshots, `${basename(dirname(resolve(file)))}.png`), fullPage: true });
  await page.setViewportSize({ width: 400, height: 800 });
  const narrow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  if (narrow > 1) found.push(`on a narrow screen the page is ${narrow} px wider than the window`);
  await page.close();
  return found;
}

let failed = 0;
for (const report of reports) {
  const [file, viewer] = report.split("=");
  const found = await faults(file, viewer);
  console.log(`${file}: ${found.length === 0 ? "fine" : "\n  " + found.join("\n  ")}`);
  failed += found.length;
}
await browser.close();
process.exit(failed === 0 ? 0 : 1);
