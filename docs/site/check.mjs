// Opens every page of the site in a browser, wide and narrow: node check.mjs SITE PACKAGES_FOLDER [PICTURES]
// No request may leave the folder, no page may fail or be wider than its window, no link may be dead.
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, relative, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [site, packagesFolder, pictures] = process.argv.slice(2).map((path) => resolve(path));
const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) =>
  existsSync(path),
);
if (!program) {
  console.log('docs: SKIPPED: no chromium is installed, so no page was opened.');
  process.exit(0);
}
const { chromium } = createRequire(join(packagesFolder, 'package.json'))('playwright-core');
const pages = readdirSync(site, { recursive: true })
  .map(String)
  .filter((path) => path.endsWith('.html') && !path.startsWith('_static') && !path.startsWith('examples'));
const faults = [];
const anchors = new Map(); // file -> names of its places
const links = []; // [page, file, place]
let formulas = 0;

const browser = await chromium.launch({
  executablePath: program,
  args: ['--no-sandbox', '--disable-gpu', '--allow-file-access-from-files'],
});
const tab = await browser.newPage();
let now = '';
tab.on('pageerror', (error) => faults.push(`${now}: ${error.message}`));
tab.on('console', (message) => {
  if (message.type() === 'error') faults.push(`${now}: ${message.text()}`);
});
tab.on('request', (request) => {
  if (!/^(file|data|blob):/.test(request.url())) faults.push(`${now}: asks for ${request.url()}`);
});
tab.on('requestfailed', (request) => faults.push(`${now}: ${request.url()} is missing`));
for (const path of pages) {
  now = path;
  await tab.setViewportSize({ width: 1400, height: 900 });
  await tab.goto(pathToFileURL(join(site, path)).href);
  // Formulas are set after the page has come.
  await tab
    .waitForFunction(
      () => !document.querySelector('.math') || document.querySelector('.MathJax_SVG svg'),
      null,
      { timeout: 20000 },
    )
    .catch(() => faults.push(`${path}: its formulas were not set`));
  await tab.evaluate(
    () => globalThis.MathJax?.Hub && new Promise((done) => globalThis.MathJax.Hub.Queue(done)),
  );
  const found = await tab.evaluate(() => ({
    ids: [...document.querySelectorAll('[id], a[name]')]
      .flatMap((element) => [element.id, element.getAttribute('name')])
      .filter(Boolean),
    links: [...document.querySelectorAll('a[href], img[src]')].map((element) => element.href ?? element.src),
    formulas: document.querySelectorAll('.MathJax_SVG').length,
    wrong: [...document.querySelectorAll('.MathJax_SVG_Error, [data-mjx-error], .merror')].map(
      (element) => element.textContent,
    ),
    dollars: [...document.querySelectorAll('.content p, .content td, .content li')]
      .filter((element) => !element.querySelector('code') && /\$[^$]*\\/.test(element.innerText))
      .map((element) => element.innerText.slice(0, 60)),
  }));
  formulas += found.formulas;
  for (const words of found.wrong) faults.push(`${path}: a formula cannot be set: ${words}`);
  for (const words of found.dollars) faults.push(`${path}: a formula is shown as text: ${words}`);
  anchors.set(path, new Set(found.ids));
  for (const href of found.links) {
    if (!href.startsWith('file:')) continue;
    const url = new URL(href);
    links.push([
      path,
      relative(site, fileURLToPath(url.href.replace(/[#?].*$/, ''))),
      decodeURIComponent(url.hash.slice(1)),
    ]);
  }
  const slugged = path.replace(/[/.]/g, '-');
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
    await tab.screenshot({ path: join(pictures, `${slugged}-1400.png`) });
  }
  await tab.setViewportSize({ width: 390, height: 844 });
  const width = await tab.evaluate(() => document.documentElement.scrollWidth);
  if (width > 390) faults.push(`${path}: ${width} px wide in a window of 390`);
  if (pictures) await tab.screenshot({ path: join(pictures, `${slugged}-390.png`) });
}
await browser.close();
for (const [page, file, place] of links) {
  if (file.startsWith('..') || !existsSync(join(site, file)))
    faults.push(`${page}: link to ${file}, which is not there`);
  else if (place && anchors.has(file) && !anchors.get(file).has(place))
    faults.push(`${page}: ${file} has no place ${place}`);
}
for (const fault of new Set(faults)) console.error(`docs: ${fault}`);
console.log(
  `docs: ${pages.length} pages opened, ${links.length} links, ${formulas} formulas, ` +
    `${new Set(faults).size} faults`,
);
process.exit(faults.length ? 1 : 0);
