// Bundles the page into one template and writes it as a C++ source: node bundle.mjs WORK_FOLDER OUTPUT.cpp
// The template is cut at its two gaps (title, data), which the program fills for each report.
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
    nodePaths: [join(workFolder, 'node_modules')],
    logLevel: 'warning',
  });
  return built.outputFiles[0].text.trim();
}

const script = bundled('src/main.js');
const style = bundled('src/style.css');
for (const [name, text, end] of [['script', script, '</script'], ['style sheet', style, '</style']]) {
  if (text.toLowerCase().includes(end)) throw new Error(`the ${name} holds ${end} and would end too early`);
}
const licence = readFileSync(join(workFolder, 'node_modules', 'uplot', 'LICENSE'), 'utf8').replaceAll('--', '- -');

// The browser runs this very script and no other, and fetches nothing, whatever the data hold.
const scriptHash = createHash('sha256').update(script).digest('base64');
const fill = { SCRIPT: script, SCRIPT_HASH: scriptHash, STYLE: style, UPLOT_LICENCE: licence.trim() };
const template = readFileSync(join(pageFolder, 'template.html'), 'utf8')
  .replace(/\{\{(SCRIPT|SCRIPT_HASH|STYLE|UPLOT_LICENCE)\}\}/g, (_, name) => fill[name]);

const parts = template.split(/\{\{(?:TITLE|DATA)\}\}/);
if (parts.length !== 3) throw new Error('the template needs {{TITLE}} and {{DATA}} once each, in this order');

const names = ['before_title', 'before_data', 'after_data'];
const arrays = parts.map((part, i) => {
  const bytes = [...Buffer.from(part, 'utf8')];
  const lines = [];
  for (let k = 0; k < bytes.length; k += 40) lines.push(bytes.slice(k, k + 40).join(','));
  return `const unsigned char ${names[i]}_bytes[] = {\n${lines.join(',\n')}};\n`;
});
const views = names.map(
  (name) => `std::string_view ${name}() { return {reinterpret_cast<const char*>(${name}_bytes), sizeof ${name}_bytes}; }\n`
);
writeFileSync(
  outputFile,
  '// Made from src/ringfilm/report/page when the program is built.\n#include "ringfilm/report/page_template.hpp"\n\n' +
    'namespace ringfilm::report::page_template {\nnamespace {\n' + arrays.join('') + '}  // namespace\n\n' +
    views.join('') + '}  // namespace ringfilm::report::page_template\n'
);
