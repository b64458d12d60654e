// Bundles each page into one template and writes them as a C++ source: node bundle.mjs WORK_FOLDER OUTPUT.cpp
// A template is cut at its two gaps (title, data), which the program fills.
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const pageFolder = dirname(fileURLToPath(import.meta.url));
const [workFolder, outputFile] = process.argv.slice(2);
const packages = createRequire(join(workFolder, 'package.json'));
const esbuild = packages('esbuild');

function bundled(entry) {
  const built = esbuild.buildSync({
    entryPoints: [join(pageFolder, entry)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    charset: 'ascii',
    target: ['es2020'],
    logLevel: 'warning',
  });
  return built.outputFiles[0].text.trim();
}

const style = bundled('src/style.css');

function refuseEnd(name, text, end) {
  if (text.toLowerCase().includes(end)) throw new Error(`the ${name} holds ${end} and would end too early`);
}

/** The three parts of the page whose script starts in `entry`. */
function parts(entry) {
  const script = bundled(entry);
  refuseEnd(`script of ${entry}`, script, '</script');
  refuseEnd('style sheet', style, '</style');
  // The browser runs this very script and no other, and fetches nothing, whatever the data hold.
  const scriptHash = createHash('sha256').update(script).digest('base64');
  const fill = { SCRIPT: script, SCRIPT_HASH: scriptHash, STYLE: style };
  const template = readFileSync(join(pageFolder, 'template.html'), 'utf8').replace(
    /\{\{(SCRIPT|SCRIPT_HASH|STYLE)\}\}/g,
    (_, name) => fill[name],
  );
  const cut = template.split(/\{\{(?:TITLE|DATA)\}\}/);
  if (cut.length !== 3) throw new Error('the template needs {{TITLE}} and {{DATA}} once each, in this order');
  return cut;
}

/** A page as byte arrays and the function that returns them. */
function asSource(page, entry) {
  const arrays = parts(entry).map((part, i) => {
    const bytes = [...Buffer.from(part, 'utf8')];
    const lines = [];
    for (let k = 0; k < bytes.length; k += 40) lines.push(bytes.slice(k, k + 40).join(','));
    return `const unsigned char ${page}_${i}[] = {\n${lines.join(',\n')}};\n`;
  });
  const view = (i) => `{reinterpret_cast<const char*>(${page}_${i}), sizeof ${page}_${i}}`;
  return (
    `namespace {\n${arrays.join('')}}  // namespace\n\n` +
    `PageTemplate ${page}() { return {${[0, 1, 2].map(view).join(', ')}}; }\n\n`
  );
}

writeFileSync(
  outputFile,
  '// Made from src/ringfilm/report/page when the program is built.\n' +
    '#include "ringfilm/report/page_template.hpp"\n\n' +
    'namespace ringfilm::report::page_template {\n' +
    asSource('report', 'src/main.js') +
    asSource('verification', 'src/verification.js') +
    asSource('measurement', 'src/measurement/measurement.js') +
    asSource('study', 'src/study/study.js') +
    asSource('life', 'src/life/life.js') +
    asSource('gas', 'src/pack/gas.js') +
    '}  // namespace ringfilm::report::page_template\n',
);
