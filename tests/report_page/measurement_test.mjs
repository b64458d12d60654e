// The page of a measurement in a real browser: node measurement_test.mjs PAGES_FOLDER PACKAGES_FOLDER
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
    'SKIPPED: no chromium is installed (apt-get install chromium); the page of measurements was ' +
      'not tested in a browser.',
  );
  process.exit(77);
}
const { chromium } = createRequire(join(packagesFolder, 'package.json'))('playwright-core');
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox', '--disable-gpu'] });

/** Opens a page at a width; `faults` collects everything that must not happen. */
async function opened(name, width) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, acceptDownloads: true });
  const page = await context.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.stack));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/willReadFrequently/.test(message.text()))
      faults.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`outside request: ${request.url()}`);
  });
  await page.goto(pathToFileURL(join(pagesFolder, name)).href);
  await page.waitForSelector('.chart svg');
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

for (const width of [390, 1400]) {
  test(`every figure is at ${width} pixels, with units on its axes`, async () => {
    const { page, faults } = await opened('measurement.html', width);
    assert.equal(
      await page.evaluate(() => document.documentElement.scrollWidth),
      width,
      'no sideways scrolling',
    );
    assert.equal(await page.textContent('h1'), 'Liner, honed (made-up numbers)');
    assert.equal(await page.locator('.card').count(), 3);
    assert.match(
      await page.textContent('.card'),
      /density of asperity peaks.*0\.038 ± 0\.003 µm⁻².*S-filter 2\.5 µm, pixel 1 µm/,
    );
    assert.match(await page.textContent('.warning'), /N depends on the cut-off/);
    assert.equal(await page.locator('.chart svg').count(), 5);
    const titles = (await page.locator('.axis-title').allTextContents()).join('|');
    for (const title of [
      'height [µm]',
      'distance along the row [mm]',
      'material ratio [%]',
      'spatial frequency [mm⁻¹]',
      'power spectral density [µm³]',
      'short cut-off [µm]',
      'density of asperity peaks [mm⁻²]',
      'lateral signal [mV]',
    ]) {
      assert.ok(titles.includes(title), `${title} in ${titles}`);
    }
    const map = page.locator('.map svg');
    const words = await map.textContent();
    for (const word of ['x [µm]', 'y [µm]', 'height [µm]', 'not measured', '1', '2', '200\u202fµm'])
      assert.ok(words.includes(word), word);
    assert.equal(await map.locator('.frame').count(), 2);
    assert.equal(await map.locator('.colour-bar').count(), 1);
    assert.deepEqual(faults, []);
    await page.context().close();
  });

  test(`the map keeps its proportions at ${width} pixels, and its scale bar is as long as it states`, async () => {
    const { page } = await opened('measurement.html', width);
    const box = (selector) =>
      page.$eval(selector, (node) => {
        const { width: w, height: h } = node.getBoundingClientRect();
        return [w, h];
      });
    const [w, h] = await box('.map image');
    assert.ok(Math.abs(h / w - 600 / 900) < 0.005, `${w} by ${h}`);
    const [bar] = await box('.map .scale-bar');
    assert.ok(Math.abs(bar / w - 200 / 900) < 0.005, `bar ${bar} of ${w}`);
    await page.context().close();
  });
}

for (const width of [390, 1400]) {
  test(`a ring is drawn in its bore at ${width} pixels`, async () => {
    const { page, faults } = await opened('closure.html', width);
    assert.equal(
      await page.evaluate(() => document.documentElement.scrollWidth),
      width,
      'no sideways scrolling',
    );
    assert.equal(await page.textContent('.kind'), 'A ring in its bore');
    const words = await page.locator('#ring-in-bore svg').first().textContent();
    for (const word of ['largest clearance 1.5', 'gap', '90°', 'apart'])
      assert.ok(words.includes(word), word);
    const rows = (await downloaded(page, 'The ring in its bore as CSV')).split('\r\n');
    assert.equal(rows[0], '"angle [degree]","bore [um]","ring [um]","clearance [um]"');
    assert.equal(rows.length, 363); // a heading, 361 places and the end of the last line
    assert.match(rows[91], /^90,8,6\.5,1\.5$/);
    assert.deepEqual(faults, []);
    await page.context().close();
  });
}

test('missing points are grey, measured ones are not', async () => {
  const { page } = await opened('measurement.html', 1400);
  const pixels = await page.$eval('.map image', async (node) => {
    const image = new Image();
    image.src = node.getAttribute('href');
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const at = (x, y) => [...context.getImageData(x, y, 1, 1).data].slice(0, 3);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let grey = 0;
    for (let k = 0; k < data.length; k += 4)
      if (data[k] === 0xc3 && data[k + 1] === 0xc6 && data[k + 2] === 0xcb) grey++;
    return {
      size: [image.width, image.height],
      pore: at(150, 100),
      beside: at(190, 100),
      share: (4 * grey) / data.length,
    };
  });
  assert.deepEqual(pixels.size, [450, 300], 'blocks of 2 by 2 points');
  assert.deepEqual(pixels.pore, [0xc3, 0xc6, 0xcb]);
  assert.notDeepEqual(pixels.beside, [0xc3, 0xc6, 0xcb]);
  // Two discs of 40 and 25 um radius on 0.9 by 0.6 mm.
  assert.ok(
    Math.abs(pixels.share - (Math.PI * (40 ** 2 + 25 ** 2)) / (900 * 600)) < 0.001,
    String(pixels.share),
  );
  await page.context().close();
});

test('the caption reports blocks, the hidden peak, the colours and the missing share', async () => {
  const { page } = await opened('measurement.html', 1400);
  const caption = (await page.textContent('#surface_height figcaption')).replace(/\u00a0/g, ' ');
  for (const words of [
    '900 × 600 points of 1 × 1 µm',
    'means over blocks of 2 × 2 points',
    'Highest single point 9.50 µm at x = 675 µm, y = 150 µm',
    '0.1 % of what is drawn lie below',
    '1.3 % of the points were not measured',
  ]) {
    assert.ok(caption.includes(words), `${words} in ${caption}`);
  }
  assert.match(await page.textContent('#profile figcaption'), /Drawn from \d+ of 12000 points/);
  await page.context().close();
});

test('the pointer reads place and height off the map', async () => {
  const { page } = await opened('measurement.html', 1400);
  const box = await page.$eval('.map image', (node) => {
    node.scrollIntoView({ block: 'center' });
    const { left, top, width, height } = node.getBoundingClientRect();
    return { left, top, width, height };
  });
  const at = (x, y) => page.mouse.move(box.left + (x / 900) * box.width, box.top + (y / 600) * box.height);
  const reported = async () => (await page.textContent('.map-value')).replace(/\u00a0/g, ' ');
  await at(300, 200);
  assert.match(await reported(), /x (299|300|301) µm, y (199|200|201) µm: not measured/);
  await at(450, 50);
  assert.match(await reported(), /: −?\d\.\d+ µm$/);
  await page.context().close();
});

test('curves, tables and pictures can be taken away', async () => {
  const { page, faults } = await opened('measurement.html', 1400);
  const spectrum = await downloaded(page, 'Power spectrum as CSV');
  assert.match(
    spectrum.split('\r\n')[0],
    /^"spatial frequency \[mm⁻¹\]","along x: power spectral density \[µm³\]"/,
  );
  assert.ok(spectrum.split('\r\n').length > 399);
  const heights = await downloaded(page, 'Heights as CSV');
  assert.match(
    heights,
    /"root mean square height","Sq",0\.41234,0\.0123,"um","Gaussian filter 0\.8 mm, pixel 1 um"/,
  );
  assert.match(
    await downloaded(page, 'Each region as CSV'),
    /^"","asperity_density \[um-2\]","asperity_radius \[um\]"\r\n"1",0\.0383,5\.1\r\n"2",0\.0412,\r\n$/,
  );
  const svg = await downloaded(page, 'Heights of the liner as SVG');
  assert.ok(
    svg.includes('data:image/png;base64,') && svg.includes('Heights of the liner') && !svg.includes('"NaN'),
  );
  const png = await Promise.all([
    page.waitForEvent('download'),
    page.click('button[aria-label="Heights of the liner as PNG"]'),
  ]);
  assert.ok(statSync(await png[0].path()).size > 50000);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('the fragment is there to be copied', async () => {
  const { page } = await opened('measurement.html', 1400);
  const fragment = '[contact]\nasperity_density = "0.0383 um-2"\nasperity_radius = "5.12 um"\n';
  assert.equal(await page.textContent('#fragment pre'), fragment);
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.click('#fragment .copy');
  await page.waitForFunction(() => document.querySelector('#fragment .copy').textContent === 'Copied');
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), fragment);
  await page.context().close();
});

test('in print every figure is a drawing and no button is left', async () => {
  const { page, faults } = await opened('measurement.html', 1400);
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('.print-only svg:visible').count(), 6);
  assert.equal(await page.locator('button:visible').count(), 0);
  assert.deepEqual(faults, []);
  await page.context().close();
});

test('texts of files stay texts', async () => {
  const { page, faults } = await opened('hostile_measurement.html', 1400);
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
