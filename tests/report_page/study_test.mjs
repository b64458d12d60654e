// The page of a study in a real browser: node study_test.mjs PAGES_FOLDER PACKAGES_FOLDER
// Exit code 77 where there is no chromium.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [pagesFolder, packagesFolder] = process.argv.slice(2);
const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) =>
  existsSync(path),
);
if (!program) {
  console.log(
    'SKIPPED: no chromium is installed (apt-get install chromium); the page of studies was not ' +
      'tested in a browser.',
  );
  process.exit(77);
}
const { chromium } = createRequire(join(packagesFolder, 'package.json'))('playwright-core');
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox', '--disable-gpu'] });

/** Opens a page at a width; `faults` collects everything that must not happen. */
async function opened(name, width = 1400) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, acceptDownloads: true });
  const page = await context.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.stack));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`outside request: ${request.url()}`);
  });
  await page.goto(pathToFileURL(join(pagesFolder, name)).href);
  await page.waitForSelector('.drawing svg');
  return { page, faults };
}

/** Text of the file behind a button. */
async function downloaded(page, label) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.click(`button[aria-label="${label}"]`),
  ]);
  return readFileSync(await download.path(), 'utf8');
}

const tests = [];
const test = (name, run) => tests.push({ name, run });

const kFigures = {
  study_uncertainty: [
    'band-min-film-thickness',
    'band-friction-on-liner',
    'histograms',
    'sobol',
    'tornado',
    'comparison-figure',
    'convergence',
    'stribeck',
  ],
  study_map: [
    'map-mean-total-friction',
    'map-fmep',
    'map-min-film-thickness',
    'map-boundary-regime-energy-share',
    'map-full-film-energy-share',
    'map-boundary-power-share',
    'lowest-fmep',
    'stribeck',
    'comparison-figure',
  ],
  study_screening: ['morris', 'ranking', 'comparison-figure', 'stribeck'],
  study_comparison: ['comparison-figure', 'stribeck'],
  study_points: ['comparison-figure', 'stribeck'],
  study_sweep: [
    'band-min-film-thickness',
    'band-friction-on-liner',
    'map-mean-total-friction',
    'map-fmep',
    'map-min-film-thickness',
    'map-boundary-regime-energy-share',
    'map-full-film-energy-share',
    'map-boundary-power-share',
    'comparison-figure',
    'stribeck',
  ],
};
for (const [name, expected] of Object.entries(kFigures)) {
  for (const width of [390, 1400]) {
    test(`${name} is at ${width} pixels`, async () => {
      const { page, faults } = await opened(`${name}.html`, width);
      assert.equal(
        await page.evaluate(() => document.documentElement.scrollWidth),
        width,
        'no sideways scrolling',
      );
      const figures = await page.$$eval('figure', (nodes) => nodes.map((node) => node.id));
      assert.deepEqual([...figures].sort(), [...expected].sort());
      assert.equal(await page.locator('.card').count(), 3);
      for (const caption of await page.locator('figcaption').allTextContents())
        assert.ok(caption.length > 30 && !/undefined|NaN|null|object/.test(caption), caption);
      const drawn = await page.$$eval('.drawing svg', (nodes) => nodes.map((node) => node.outerHTML));
      drawn.forEach((svg) =>
        assert.ok(!/NaN|undefined|Infinity/.test(svg), svg.match(/.{60}(NaN|undefined|Infinity).{60}/)?.[0]),
      );
      for (const id of ['values', 'varied', 'provenance', 'notes'])
        assert.equal(await page.locator(`section#${id}`).count(), 1, id);
      assert.deepEqual(faults, []);
      await page.context().close();
    });
  }
}

test('the accuracy of the sample is reported', async () => {
  const { page, faults } = await opened('study_uncertainty.html');
  const text = await page.textContent('section#accuracy');
  assert.match(text, /Estimated on 2 of \d+ scenarios.*Not solved: 1 more\./);
  assert.match(text, /97\.5 % of their 80 values are within the 0\.5 % asked for/);
  const rows = await page.locator('section#accuracy tbody tr').allTextContents();
  assert.equal(rows.length, 3);
  assert.ok(rows.some((row) => /0\.21$/.test(row)));
  assert.ok(rows.some((row) => /4\.6$/.test(row)));
  assert.ok(rows.some((row) => /more than 100$/.test(row))); // in place of 1129 %
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('operating points have their names, and their weighted mean heads the page', async () => {
  const { page, faults } = await opened('study_points.html');
  const card = await page.textContent('.card:first-child');
  assert.match(card, /new2\.13 kPalowest 1\.00, idle; highest 5\.00, full speed/);
  assert.match(card, /worn3\.13 kPa/);
  const rows = await page.$$eval('#points tbody tr', (list) => list.map((row) => row.textContent));
  assert.equal(rows.length, 2 * 4, 'points and mean of each base');
  assert.match(rows[1], /^part load62\.5\s%2\.000/);
  assert.match(rows[3], /^weighted mean2\.125/);
  assert.match(await page.textContent('#comparison-figure'), /Mark: weighted mean/);
  assert.doesNotMatch(await page.textContent('main'), /[Mm]edian/);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('a grid has its lowest and highest values with their places, and no median', async () => {
  const { page, faults } = await opened('study_map.html');
  assert.match(
    await page.textContent('.card:nth-child(3)'),
    /[\d.]+ to [\d.]+ µmlowest at speed 1000 rpm, warmth 13.33 K, law roelands; highest at speed 6000 rpm/,
  );
  assert.doesNotMatch(await page.textContent('#values'), /median/);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('curves of a sweep have the names of its scenarios', async () => {
  const { page, faults } = await opened('study_sweep.html');
  const names = await page.$$eval('#band-min-film-thickness .legend .label', (list) =>
    list.map((label) => label.textContent),
  );
  assert.equal(names.length, 8);
  assert.deepEqual([names[0], names[7]], ['speed 1000 rpm', 'speed 5000 rpm']);
  assert.match(await page.textContent('#band-min-film-thickness figcaption'), /8 of 9 scenarios, evenly/);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('another value is picked with the keyboard', async () => {
  const { page, faults } = await opened('study_uncertainty.html');
  const before = await page.textContent('#tornado figcaption');
  const picker = page.locator('#decides select');
  await picker.focus();
  for (let k = 0; k < 4; k++) await page.keyboard.press('ArrowDown');
  assert.equal(await picker.inputValue(), 'min_film_thickness');
  const after = await page.textContent('#tornado figcaption');
  assert.notEqual(after, before);
  assert.match(after, /minimum film thickness/);
  assert.match(
    await page.textContent('#sobol figcaption'),
    /minimum film thickness from 64 rows.*Strongest: speed and warmth/,
  );
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('a map shows another slice, base and axis, and what was not solved', async () => {
  const { page, faults } = await opened('study_map.html');
  const bands = () =>
    page.$$eval('#map-min-film-thickness path.band', (nodes) =>
      nodes.map((node) => node.getAttribute('d')).join(),
    );
  const seen = [await bands()];
  const selects = page.locator('#maps .choices select');
  assert.equal(await selects.count(), 4); // base, across, up, law
  assert.match(
    await page.textContent('#map-min-film-thickness figcaption'),
    /Hatched: next to the scenario \(×\) that was not solved/,
  );
  await selects.nth(0).selectOption({ label: 'worn' });
  seen.push(await bands());
  await selects.nth(1).selectOption({ label: 'warmth' });
  seen.push(await bands());
  assert.equal(new Set(seen).size, 3);
  assert.match(await page.locator('#map-fmep svg').textContent(), /warmth \[K\]/);
  const friction = await page.$$eval('#map-mean-total-friction path.band', (nodes) =>
    nodes.map((node) => node.getAttribute('d')).join(),
  );
  await selects.nth(3).selectOption({ label: 'barus' });
  assert.notEqual(
    await page.$$eval('#map-mean-total-friction path.band', (nodes) =>
      nodes.map((node) => node.getAttribute('d')).join(),
    ),
    friction,
  );
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('the pointer reads a map', async () => {
  const { page } = await opened('study_map.html');
  const host = page.locator('#map-min-film-thickness .drawing');
  await host.scrollIntoViewIfNeeded();
  const box = await host.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 120);
  assert.match(
    (await page.textContent('#map-min-film-thickness .map-value')).replace(/\u00a0/g, ' '),
    /^speed \d+ rpm, warmth −?[\d.]+ K: 0\.\d+ µm$/,
  );
  await page.context().close();
});

test('numbers and pictures can be taken away', async () => {
  const { page, faults } = await opened('study_uncertainty.html');
  const bands = (await downloaded(page, 'Minimum film thickness as CSV')).split('\r\n');
  assert.match(
    bands[0],
    /"crank angle \[degree\]".*"new: minimum film thickness, 5 % \[µm\]","new: minimum film thickness, 95 % \[µm\]"/,
  );
  assert.equal(bands.length, 75); // heads, 73 angles with both ends of the cycle, the last line's end
  const values = await downloaded(page, 'Values of the cycle as CSV');
  assert.match(
    values.split('\r\n')[0],
    /"base","quantity","unit","scenarios","mean","mean, low","mean, high","standard deviation","5 %"/,
  );
  assert.match(
    await downloaded(page, 'Which input decides: shares in the variance as CSV'),
    /"speed and warmth",[\d.]+/,
  );
  const svg = await downloaded(page, 'How the values of the cycle are spread as SVG');
  assert.ok(
    svg.includes('made-up uncertainty') &&
      svg.includes('minimum film thickness [µm]') &&
      !svg.includes('NaN'),
  );
  const [png] = await Promise.all([
    page.waitForEvent('download'),
    page.click('button[aria-label="Which input moves it how far as PNG"]'),
  ]);
  assert.ok(statSync(await png.path()).size > 10000);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('in print every figure is a drawing and no button is left', async () => {
  const { page, faults } = await opened('study_uncertainty.html');
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('.print-only svg:visible').count(), kFigures.study_uncertainty.length);
  assert.equal(await page.locator('button:visible, select:visible').count(), 0);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('texts of a study stay texts', async () => {
  const { page, faults } = await opened('hostile_study.html');
  assert.equal(await page.evaluate(() => window.hostile), undefined);
  assert.match(await page.textContent('h1'), /<\/script><img/);
  assert.deepEqual(faults, []);
  await page.context().close();
});

let failed = 0;
for (const { name, run } of tests) {
  try {
    await run();
    console.log(`ok      ${name}`);
  } catch (error) {
    failed++;
    console.log(`FAILED  ${name}\n        ${error.stack.replace(/\n/g, '\n        ')}`);
  }
}
await browser.close();
console.log(`${tests.length - failed} of ${tests.length} browser tests passed`);
process.exit(failed ? 1 : 0);
