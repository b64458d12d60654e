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
  await page.waitForSelector('.chart svg, .bars svg');
  return { page, faults };
}

/** The pixels of the first chart of a figure: { data, width }, bytes of red, green, blue and opacity. */
async function pixelsOf(page, selector) {
  const { width, data } = await page.$eval(`${selector} .chart svg`, async (svg) => {
    const image = new Image();
    const text = new XMLSerializer().serializeToString(svg);
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data: bytes } = context.getImageData(0, 0, canvas.width, canvas.height);
    let packed = '';
    for (let k = 0; k < bytes.length; k += 8192)
      packed += String.fromCharCode(...bytes.subarray(k, k + 8192));
    return { width: canvas.width, data: btoa(packed) };
  });
  return { width, data: Buffer.from(data, 'base64') };
}

/** Rows of the pixels of a chart that fulfil a condition on the spread and the brightest of their colours. */
async function rowsOf(page, selector, holds) {
  const { width, data } = await pixelsOf(page, selector);
  const rows = [];
  for (let k = 0; k < data.length; k += 4) {
    const [high, low] = [
      Math.max(data[k], data[k + 1], data[k + 2]),
      Math.min(data[k], data[k + 1], data[k + 2]),
    ];
    if (data[k + 3] > 250 && holds(high - low, high)) rows.push(Math.floor(k / 4 / width));
  }
  return rows;
}

const isCurve = (spread) => spread > 40;

/** Pixels of a chart that are neither white nor grey: the curves. */
export async function colouredPixels(page, selector) {
  return (await rowsOf(page, selector, isCurve)).length;
}

/** Height that the curves of a chart take, as a share of its plotting area. */
export async function curveHeight(page, selector) {
  const rows = await rowsOf(page, selector, isCurve);
  const plot = await page.$eval(`${selector} .over`, (over) => over.clientHeight);
  return (rows[rows.length - 1] - rows[0]) / plot;
}

/** Pixels of a chart that are tinted as lightly as the band of an error. */
export async function bandPixels(page, selector) {
  const isBand = (spread, high) => high > 200 && spread >= 15 && spread < 70;
  return (await rowsOf(page, selector, isBand)).length;
}

/** Left edge of the plotting area of every chart over the cycle. */
export function plotEdges(page) {
  return page.$$eval('#cycle .figure:not(#along-the-face) .over', (overs) =>
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
