// The page of `ringfilm life` in a real browser: node life_test.mjs PROGRAM SOURCES PACKAGES_FOLDER
// Exit code 77 where there is no chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [program, sources, packagesFolder] = process.argv.slice(2);
const browserProgram = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(
  (path) => existsSync(path),
);
if (!browserProgram) {
  console.log(
    'SKIPPED: no chromium is installed (apt-get install chromium); the page of lives was not ' +
      'tested in a browser.',
  );
  process.exit(77);
}
const { chromium } = createRequire(join(packagesFolder, 'package.json'))('playwright-core');
const folder = mkdtempSync(join(tmpdir(), 'life-page-'));
const rings = join(sources, 'cases', 'styles2014');
const state = (hours, ring) => `[[state]]\nhours = "${hours} h"\ncase = "${rings}/${ring}.toml"\n`;

/** Writes a life and its page; both have coarse films, for what is drawn does not depend on them. */
function written(name, text) {
  writeFileSync(join(folder, `${name}.toml`), text);
  execFileSync(program, ['life', `${name}.toml`, '--html', `${name}.html`], { cwd: folder });
}
const point = '[[duty.point]]\nname = "all"\nweight = 1\nset = { "solver.cells" = 60 }\n';
written(
  'path',
  `title = "a path"\ncase = "${rings}/new.toml"\nhours = ["0 h", "3 h", "10 h", "30 h", "150 h", "300 h"]\n` +
    state(0, 'new') +
    state(10, 'run-in') +
    state(150, 'embedded') +
    point +
    '[end_of_life]\nmean_power_loss = "60 W"\n',
);
written(
  'scenario',
  `title = "</script><b>a scenario</b>"\ncase = "${rings}/new.toml"\nmode = "archard"\n` +
    'hours = ["0 h", "10 h", "150 h"]\n' +
    '[wear]\ncoefficient = "4e-18 m2/N"\nsurface = "path"\njumps = 8\norientations = "both"\n' +
    state(0, 'new') +
    state(10, 'run-in') +
    state(150, 'embedded') +
    `[pack]\ncase = "${join(sources, 'cases', 'ring-pack', 'two_rings.toml')}"\n` +
    point,
);
const browser = await chromium.launch({
  executablePath: browserProgram,
  args: ['--no-sandbox', '--disable-gpu'],
});

/** Opens a page at a width; `faults` collects everything that must not happen. */
async function opened(name, width) {
  const page = await browser.newPage({ viewport: { width, height: 900 } });
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.stack));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`outside request: ${request.url()}`);
  });
  await page.goto(pathToFileURL(join(folder, `${name}.html`)).href);
  await page.waitForSelector('.chart svg');
  return { page, faults };
}

const text = async (page, selector) => (await page.textContent(selector)).replace(/[\u00a0\u202f]/g, ' ');

/** Moves a slider to a place and lets the page follow. */
async function slide(page, selector, value) {
  await page.$eval(
    selector,
    (node, to) => {
      node.value = String(to);
      node.dispatchEvent(new Event('input', { bubbles: true }));
    },
    value,
  );
}

const kOverHours = [
  'mean-power-loss',
  'mean-absolute-oil-flow',
  'energy-per-cycle',
  'fmep',
  'lambda-ratio-at-peak-pressure',
  'min-film-thickness',
  'peak-friction-coefficient-firing',
  'mean-boundary-power',
];
const kOfWear = ['worn-area', 'largest-worn-depth', 'end-gap-growth', 'blow-by-flow'];

const tests = [];
const test = (name, run) => tests.push({ name, run });

for (const width of [390, 1400]) {
  for (const [name, ids] of [
    ['path', kOverHours],
    ['scenario', [...kOverHours, ...kOfWear]],
  ]) {
    test(`the page of a ${name} has all curves at ${width} pixels, linear and logarithmic`, async () => {
      const { page, faults } = await opened(name, width);
      assert.equal(
        await page.evaluate(() => document.documentElement.scrollWidth),
        width,
        'no sideways scrolling',
      );
      assert.deepEqual(
        await page.$$eval('#hours figure', (nodes) => nodes.map((node) => node.id)),
        ids.map((id) => `hours-${id}`),
      );
      const axes = await page.locator('#hours-mean-power-loss .axis-title').allTextContents();
      assert.ok(
        axes.some((title) => title.includes('running time [h]')),
        axes.join('|'),
      );
      assert.ok(
        axes.some((title) => title.includes('running time + 1 h [h]')),
        axes.join('|'),
      );
      assert.equal(await page.locator('.card').count(), name === 'path' ? 4 : 3); // with its limit
      assert.deepEqual(faults, []);
      await page.close();
    });
  }
}

test('each curve states how it is known', async () => {
  const entries = async (name) => {
    const { page } = await opened(name, 1400);
    const found = await page.locator('#hours-mean-power-loss .entry').allTextContents();
    await page.close();
    return found.join('|');
  };
  const path = await entries('path');
  for (const words of ['interpolated', 'held: assumed', 'ring turned over, interpolated', 'measured states'])
    assert.ok(path.includes(words), `${words} in ${path}`);
  const scenario = await entries('scenario');
  for (const words of ['scenario: assumed', 'ring turned over, scenario: assumed'])
    assert.ok(scenario.includes(words), `${words} in ${scenario}`);
  const { page } = await opened('scenario', 1400);
  assert.match(
    await text(page, '#hours-mean-power-loss figcaption'),
    /not a prediction.*interpolated between measured states/,
  );
  await page.close();
});

test('a slider shows the face over the hours, beside the measured one', async () => {
  const { page, faults } = await opened('scenario', 1400);
  assert.match(
    await text(page, '#face-over-hours figcaption'),
    /after 150 h .*Dots: the face that was measured/,
  );
  await slide(page, '#face-hours', 1);
  assert.equal(await text(page, 'output[for=face-hours]'), '10 h');
  assert.match(await text(page, '#face-over-hours figcaption'), /after 10 h/);
  assert.match(await text(page, '#face'), /rms.*within 0\.50 mm of the middle.*10 h\d\.\d+ µm/);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a slider sets how much of the width is trusted', async () => {
  const { page, faults } = await opened('path', 1400);
  const whole = await text(page, '#wear table');
  assert.match(whole, /150 h19\.2 µm mm/);
  await slide(page, '#trusted-width', 3);
  assert.match(await text(page, 'output[for=trusted-width]'), /without 0\.30 mm at each edge/);
  assert.match(await text(page, '#wear table'), /150 h0\.46\d µm mm/);
  assert.deepEqual(faults, []);
  await page.close();
});

test('bars attribute the change to face, roughness and shear strength', async () => {
  const { page } = await opened('path', 390);
  assert.match(
    await text(page, '#attribution figcaption'),
    /only the face, only the roughness or only the shear strength/,
  );
  const labels = await page.$$eval('#attribution .bars text', (nodes) =>
    nodes.map((node) => node.getBoundingClientRect()).map(({ left, right, top }) => ({ left, right, top })),
  );
  assert.ok(labels.length >= 10, `${labels.length} labels`);
  for (const [k, one] of labels.entries())
    for (const other of labels.slice(k + 1))
      assert.ok(
        Math.abs(one.top - other.top) > 8 || one.right <= other.left || other.right <= one.left,
        'labels overlap',
      );
  await page.close();
});

test('the page lists limits, blow-by and what to measure', async () => {
  const path = await opened('path', 1400);
  assert.match(await text(path.page, '#end table'), /friction power60\.00 W\d/);
  assert.match(await text(path.page, '#measure'), /mass of the ring.*orientation.*roughness of the liner/);
  await path.page.close();
  const scenario = await opened('scenario', 1400);
  assert.match(await text(scenario.page, '#wear table'), /blow-by.*l\/min/);
  assert.match(await text(scenario.page, '#measure table'), /marine engines.*0\.38 to 2\.95 mm/);
  assert.equal(await scenario.page.textContent('h1'), '</script><b>a scenario</b>');
  await scenario.page.close();
});

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
  rmSync(folder, { recursive: true });
}
console.log(`${tests.length - failed} of ${tests.length} browser tests passed`);
process.exit(failed ? 1 : 0);
