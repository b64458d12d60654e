// A real browser for the tests of the report page: started with PAGES_FOLDER PACKAGES_FOLDER as arguments.
// Exit code 77 where there is no chromium.
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [pagesFolder, packagesFolder] = process.argv.slice(2);
const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) =>
  existsSync(path),
);
if (!program) {
  console.log(
    'SKIPPED: no chromium is installed (apt-get install chromium); the report page was not tested in a browser.',
  );
  process.exit(77);
}
const { chromium } = createRequire(join(packagesFolder, 'package.json'))('playwright-core');

const profile = mkdtempSync(join(tmpdir(), 'report-page-'));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: program,
  args: [
    '--no-sandbox',
    '--disable-gpu',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--no-first-run',
  ],
  acceptDownloads: true,
});

/** Opens a page at a width; `faults` collects everything that must not happen. */
export async function opened(name, width) {
  const page = await browser.newPage();
  await page.setViewportSize({ width, height: 900 });
  const faults = [];
  // "ResizeObserver loop completed ..." reaches the window only.
  await page.exposeFunction('reportFault', (message) => faults.push(`window error: ${message}`));
  await page.addInitScript(() =>
    window.addEventListener('error', (event) => window.reportFault(event.message)),
  );
  page.on('pageerror', (error) => faults.push(`page error: ${error.stack}`));
  // Reading pixels back is this test's doing, not the page's.
  const mine = /willReadFrequently/;
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !mine.test(message.text()))
      faults.push(`console: ${message.text()}`);
  });
  await page.route('**/*', (route) => {
    const url = route.request().url();
    if (/^(file|data|blob):/.test(url)) return route.continue();
    faults.push(`outside request: ${url}`);
    return route.abort();
  });
  await page.goto(pathToFileURL(join(pagesFolder, name)).href);
  await page.waitForSelector('.chart canvas, .bars svg');
  return { page, faults };
}

/** Pixels of a chart's canvas that are neither white nor transparent nor grey: the curves. */
export function colouredPixels(page, selector) {
  return page.$eval(`${selector} canvas`, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let n = 0;
    for (let k = 0; k < data.length; k += 4)
      if (
        data[k + 3] > 0 &&
        Math.max(data[k], data[k + 1], data[k + 2]) - Math.min(data[k], data[k + 1], data[k + 2]) > 40
      )
        n++;
    return n;
  });
}

/** Height that the curves of a chart take, as a share of its canvas. */
export function curveHeight(page, selector) {
  return page.$eval(`${selector} canvas`, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let [top, bottom] = [canvas.height, 0];
    for (let k = 0; k < data.length; k += 4) {
      const [high, low] = [
        Math.max(data[k], data[k + 1], data[k + 2]),
        Math.min(data[k], data[k + 1], data[k + 2]),
      ];
      if (data[k + 3] === 0 || high - low <= 40) continue;
      const row = Math.floor(k / 4 / canvas.width);
      [top, bottom] = [Math.min(top, row), Math.max(bottom, row)];
    }
    return (bottom - top) / canvas.height;
  });
}

/** Pixels of a chart's canvas that are tinted as lightly as the band of an error. */
export function bandPixels(page, selector) {
  return page.$eval(`${selector} canvas`, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let n = 0;
    for (let k = 0; k < data.length; k += 4) {
      const [high, low] = [
        Math.max(data[k], data[k + 1], data[k + 2]),
        Math.min(data[k], data[k + 1], data[k + 2]),
      ];
      if (data[k + 3] > 250 && high > 200 && high - low >= 15 && high - low < 70) n++;
    }
    return n;
  });
}

/** Left edge of the plotting area of every chart over the cycle. */
export function plotEdges(page) {
  return page.$$eval('#cycle .figure:not(#along-the-face) .u-over', (overs) =>
    overs.map((o) => {
      const b = o.getBoundingClientRect();
      return [Math.round(b.left), Math.round(b.right)].join();
    }),
  );
}

export async function downloaded(page, figure, label) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.click(`#${figure} .download:text-is("${label}")`),
  ]);
  const path = await download.path();
  return { name: download.suggestedFilename(), bytes: readFileSync(path) };
}

const tests = [];
export const test = (name, run) => tests.push({ name, run });

/** Runs all tests, reports each and ends the process. */
export async function runTests() {
  let failed = 0;
  try {
    for (const { name, run } of tests) {
      try {
        await run();
        console.log(`ok      ${name}`);
      } catch (error) {
        failed++;
        console.log(`FAILED  ${name}\n        ${error.stack.replace(/\n/g, '\n        ')}`);
      }
    }
  } finally {
    await browser.close();
    rmSync(profile, { recursive: true, force: true });
  }
  console.log(`${tests.length - failed} of ${tests.length} browser tests passed`);
  process.exit(failed ? 1 : 0);
}
