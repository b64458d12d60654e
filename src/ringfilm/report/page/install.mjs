// Installs the locked packages of this folder into the build folder: node install.mjs WORK_FOLDER [--with-tools]
// Without --with-tools those that make the page, with it also those that format, check and test it.
// Does nothing where they are installed already, so that only the first build needs a network.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  accessSync,
  constants,
  copyFileSync,
  existsSync,
  mkdirSync,
  readFileSync,
  writeFileSync,
} from 'node:fs';
import { homedir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const pageFolder = dirname(fileURLToPath(import.meta.url));
const [workFolder, option] = process.argv.slice(2);
const withTools = option === '--with-tools';
const listed = ['package.json', 'package-lock.json', '.npmrc'];

const hash = createHash('sha256');
for (const name of listed) hash.update(readFileSync(join(pageFolder, name)));
// The bundler is a program of its own: packages fetched for another kind of machine are of no use here.
const locked = `${hash.digest('hex')} ${process.platform} ${process.arch}`;
const all = `${locked} with tools\n`;
const required = withTools ? all : `${locked}\n`;

const mark = join(workFolder, 'node_modules', '.installed');
const installed = existsSync(mark) ? readFileSync(mark, 'utf8') : '';
if (installed === required || installed === all) process.exit(0);

mkdirSync(workFolder, { recursive: true });
for (const name of listed) copyFileSync(join(pageFolder, name), join(workFolder, name));
// A home folder that cannot be written must not stop npm.
function homeIsWritable() {
  try {
    accessSync(homedir(), constants.W_OK);
    return true;
  } catch {
    return false;
  }
}

const options = ['--ignore-scripts', '--prefer-offline', '--no-audit', '--no-fund'];
const npm = spawnSync('npm', ['ci', ...(withTools ? [] : ['--omit=dev']), ...options], {
  cwd: workFolder,
  env: homeIsWritable()
    ? process.env
    : { ...process.env, npm_config_cache: resolve(workFolder, 'npm-cache') },
  stdio: ['ignore', 'ignore', 'inherit'],
});
if (npm.status !== 0) {
  console.error(
    `The packages of the report page could not be installed (npm ci in ${workFolder}).\n` +
      'The first build needs a network and the programs node and npm; later ones do not. ' +
      'Run the build again with a network.',
  );
  process.exit(1);
}
writeFileSync(mark, required);
