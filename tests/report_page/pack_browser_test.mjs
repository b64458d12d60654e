// The page of the gas of a ring pack alone in a real browser:
// node pack_browser_test.mjs PAGES_FOLDER PACKAGES_FOLDER
import assert from 'node:assert/strict';
import { colouredPixels, opened, runTests, test } from './browser.mjs';

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
