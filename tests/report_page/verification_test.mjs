// The page of `ringfilm verify` in a real browser: node verification_test.mjs PROGRAM PACKAGES_FOLDER
// Exit code 77 where there is no chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [program, packagesFolder] = process.argv.slice(2);
const browserProgram = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(
  (path) => existsSync(path),
);
if (!browserProgram) {
  console.log(
    'SKIPPED: no chromium is installed (apt-get install chromium); the page of verify was not ' +
      'tested in a browser.',
  );
  process.exit(77);
}
const { chromium } = createRequire(join(packagesFolder, 'package.json'))('playwright-core');
const folder = mkdtempSync(join(tmpdir(), 'verify-page-'));
const path = join(folder, 'verification.html');
execFileSync(program, [
  'verify',
  'rayleigh1918_inclined_slider',
  'ausas2009_oscillating_squeeze',
  '--output',
  path,
]);
const browser = await chromium.launch({
  executablePath: browserProgram,
  args: ['--no-sandbox', '--disable-gpu'],
});
try {
  for (const width of [390, 1400]) {
    const page = await browser.newPage({ viewport: { width, height: 900 } });
    const faults = [];
    page.on('pageerror', (error) => faults.push(error.stack));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) faults.push(message.text());
    });
    page.on('request', (request) => {
      if (!/^(file|data|blob):/.test(request.url())) faults.push(`outside request: ${request.url()}`);
    });
    await page.goto(pathToFileURL(path).href);
    await page.waitForSelector('.chart svg');
    assert.deepEqual(faults, []);
    assert.equal(
      await page.evaluate(() => document.documentElement.scrollWidth),
      width,
      `no sideways scrolling at ${width}`,
    );
    assert.equal(await page.textContent('.card .card-value'), '2 of 2');
    assert.equal(await page.locator('.chart svg').count(), 3, 'one plot for each order of convergence');
    const verdicts = await page.locator('.checks .verdict').allTextContents();
    assert.ok(verdicts.length > 15 && verdicts.every((text) => text === 'holds'), verdicts.join());
    await page.close();
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
