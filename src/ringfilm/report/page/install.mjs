// Brings the locked packages of this folder into the build folder: node install.mjs WORK_FOLDER
// Does nothing where they already stand there, so that only the first build needs a network.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const pageFolder = dirname(fileURLToPath(import.meta.url));
const workFolder = process.argv[2];
const listed = ['package.json', 'package-lock.json', '.npmrc'];

const hash = createHash('sha256');
for (const name of listed) hash.update(readFileSync(join(pageFolder, name)));
// The bundler is a program of its own: packages fetched for another kind of machine are of no use here.
const wanted = `${hash.digest('hex')} ${process.platform} ${process.arch}\n`;

const mark = join(workFolder, 'node_modules', '.installed');
if (existsSync(mark) && readFileSync(mark, 'utf8') === wanted) process.exit(0);

mkdirSync(workFolder, { recursive: true });
for (const name of listed) copyFileSync(join(pageFolder, name), join(workFolder, name));
const npm = spawnSync('npm', ['ci', '--ignore-scripts', '--prefer-offline', '--no-audit', '--no-fund'], {
  cwd: workFolder,
  stdio: ['ignore', 'ignore', 'inherit'],
});
if (npm.status !== 0) {
  console.error(
    `The packages of the report page could not be installed (npm ci in ${workFolder}).\n` +
      'The first build needs a network and the programs node and npm; later ones do not. Run the build again with a network.'
  );
  process.exit(1);
}
writeFileSync(mark, wanted);
