// The pages of several ring packs and of the gas alone in a real browser:
// node pack_browser_test.mjs PAGES_FOLDER PACKAGES_FOLDER
import assert from 'node:assert/strict';
import { colouredPixels, opened, runTests, test } from './browser.mjs';

test('two ring packs have one colour each, one row a ring, and their blow-by', async () => {
  const { page, faults } = await opened('two_packs.html', 1400);
  const heads = await page.$$eval('#pack thead th', (nodes) => nodes.map((n) => n.textContent));
  assert.equal(heads.length, 3);
  assert.match(heads[2], /end gap 0\.2 mm/);
  const rows = await page.$$eval('#pack tbody tr', (nodes) => nodes.map((n) => n.textContent));
  assert.match(
    rows.find((row) => row.startsWith('blow-by [mg')),
    /2\.000.*2\.000/,
  );
  for (const id of ['pack-friction', 'pack-pressures', 'pack-blow-by'])
    assert.ok((await colouredPixels(page, `#${id}`)) > 200, `${id} shows no curve`);
  const friction = await page.$$eval('#total-friction .panel', (nodes) =>
    nodes.map((node) => ({
      ring: node.querySelector('.axis-title').textContent,
      packs: [...node.querySelectorAll('.legend .entry .label')].map((label) => label.textContent),
    })),
  );
  assert.equal(friction.length, 2);
  assert.match(friction[1].ring, /^ring 2: /);
  assert.equal(friction[1].packs.length, 2);
  assert.equal(await page.$$eval('.toolbar .entry', (nodes) => nodes.length), 2);
  assert.equal(await page.$('#along-the-face'), null);
  assert.deepEqual(faults, []);
  await page.close();
});

for (const name of ['gas.html', 'hostile_gas.html']) {
  test(`the gas of a pack alone has a page: ${name}`, async () => {
    const { page, faults } = await opened(name, 1400);
    for (const id of ['pack-pressures', 'pack-blow-by', 'pack-positions'])
      assert.ok((await colouredPixels(page, `#${id}`)) > 200, `${id} shows no curve`);
    assert.match(await page.textContent('.cards'), /2\.00 mg per cycle/);
    assert.match(await page.textContent('#pack-drawing svg'), /ring 2, groove/);
    assert.match(await page.textContent('#validity'), /no oil ring/);
    assert.equal(await page.evaluate(() => window.hostile), undefined);
    assert.deepEqual(faults, []);
    await page.close();
  });
}

await runTests();
