// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Chromium for the tests of reports: without network, with WebGL in software, and a profile that goes with it.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

export async function openBrowser(executablePath, options = {}) {
  const profile = mkdtempSync(join(tmpdir(), "leastcost-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath,
    headless: true,
    args: [
      "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
      "--use-angle=swiftshader", "--use-gl=angle", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
    ],
    ...options,
  });
  await context.setOffline(true);
  return {
    context,
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}

/** What a page prints as an error or a warning, throws, or asks for beside itself and what is `allowed`, goes into `found`. */
export function watch(page, address, allowed, found) {
  page.on("console", (message) => { if (["error", "warning"].includes(message.type()) && !/GPU stall|software WebGL/.test(message.text())) found.push(`console: ${message.text()}`); });
  page.on("pageerror", (error) => found.push(`exception: ${error}`));
  page.on("request", (request) => { if (request.url() !== address && !allowed.test(request.url())) found.push(`request: ${request.url().slice(0, 200)}`); });
}
