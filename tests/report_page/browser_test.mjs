// The report page in a real browser: node browser_test.mjs PAGES_FOLDER PACKAGES_FOLDER
import assert from 'node:assert/strict';
import {
  bandPixels,
  colouredPixels,
  curveHeight,
  downloaded,
  opened,
  plotEdges,
  runTests,
  test,
} from './browser.mjs';

for (const width of [390, 1400]) {
  for (const name of ['three.html', 'hostile.html', 'bare.html']) {
    test(`${name} opens at ${width} px without error, outside request or sideways scroll`, async () => {
      const { page, faults } = await opened(name, width);
      await page.waitForTimeout(200);
      const [wide, shown] = await page.evaluate(() => [
        document.documentElement.scrollWidth,
        window.innerWidth,
      ]);
      assert.ok(wide <= shown, `the page is ${wide} px wide in a window of ${shown} px`);
      assert.deepEqual(faults, []);
      await page.close();
    });
  }

  test(`curves are drawn and cycle charts are in columns at ${width} px`, async () => {
    const { page, faults } = await opened('three.html', width);
    for (const id of [
      'total-friction',
      'friction-on-liner',
      'friction-firing',
      'stribeck',
      'archard-wear-load-stroke',
      'ring-faces',
      'along-the-face',
    ]) {
      assert.ok((await colouredPixels(page, `#${id}`)) > 200, `${id} shows no curve`);
    }
    const edges = await plotEdges(page);
    assert.ok(edges.length >= 7);
    // One column on a phone, two on a wide screen.
    assert.equal(new Set(edges).size, width < 900 ? 1 : 2, `plotting areas differ: ${edges}`);
    assert.deepEqual(faults, []);
    await page.close();
  });
}

for (const width of [390, 1400]) {
  test(`a light band lies about every cycle curve that has an error at ${width} px`, async () => {
    const alone = await opened('coarse.html', width);
    for (const figure of ['min-film-thickness', 'lambda-ratio']) {
      assert.ok((await bandPixels(alone.page, `#${figure}`)) > 1000, `no band in ${figure}`);
    }
    assert.equal(
      await alone.page.locator('#cylinder-pressure .chart .band').count(),
      0,
      'an input has no band',
    );
    assert.deepEqual(alone.faults, []);
    await alone.page.close();
    const { page, faults } = await opened('three.html', width);
    assert.match(
      await page.textContent('#total-friction figcaption'),
      /Light band: how far cells and crank steps/,
    );
    assert.match(await page.textContent('#cycle-values'), /400 cells at 1\.00°/);
    assert.match(await page.textContent('#cycle-values td'), /^[\d.]+ ± [\d.]+$/);
    const svg = (await downloaded(page, 'total-friction', 'SVG')).bytes.toString('utf8');
    assert.equal(svg.match(/class="band"/g).length, 3, 'one band a case');
    assert.match(
      (await downloaded(page, 'total-friction', 'CSV')).bytes.toString('utf8'),
      /error of total friction \[N\]/,
    );
    assert.deepEqual(faults, []);
    await page.close();
  });
}

/** Pixels of a map: how many are violet (low), yellow (high), black or white (hatched, or nothing). */
function mapPixels(page, n) {
  return page.$eval(`#around-the-ring .maps canvas:nth-of-type(${n})`, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const count = { low: 0, high: 0, white: 0, dark: 0, all: canvas.width * canvas.height };
    for (let k = 0; k < data.length; k += 4) {
      const [r, g, b] = [data[k], data[k + 1], data[k + 2]];
      if (r > 250 && g > 250 && b > 250) count.white++;
      else if (Math.abs(r - g) < 12 && Math.abs(g - b) < 12) count.dark++;
      else if (r > 200 && g > 200) count.high++;
      else if (g < 90) count.low++;
    }
    return count;
  });
}

for (const width of [390, 1400]) {
  test(`the film around the ring is drawn, read and enlarged at ${width} px`, async () => {
    const { page, faults } = await opened('unrolled.html', width);
    const [wide, shown] = await page.evaluate(() => [
      document.documentElement.scrollWidth,
      window.innerWidth,
    ]);
    assert.ok(wide <= shown, `the page is ${wide} px wide in a window of ${shown} px`);
    // At the peak of the gas pressure: all colours, and a cavity that takes 0.22 of the face.
    assert.match(await page.textContent('#around-the-ring output'), /20° after firing TDC/);
    const whole = await mapPixels(page, 1);
    assert.ok(whole.low > 0.05 * whole.all && whole.high > 0.02 * whole.all, JSON.stringify(whole));
    const hatched = (whole.white + whole.dark) / whole.all;
    assert.ok(hatched > 0.17 && hatched < 0.27, `hatched: ${hatched}`);
    const fill = await mapPixels(page, 2);
    assert.equal(fill.white, 0);
    assert.ok(fill.high > 0.6 * fill.all);
    // 0.3 mm between 7.2 mm of ring: 4 % more is white, and what was hatched is not so near the ends.
    await page.click('#around-the-ring button:text-is("Ends of the gap")');
    const ends = await mapPixels(page, 2);
    const share = ends.white / ends.all;
    assert.ok(Math.abs(share - 0.3 / 7.5) < 0.01, `the gap takes ${share}`);
    await page.locator('#around-the-ring .maps').scrollIntoViewIfNeeded();
    const box = await page.locator('#around-the-ring .maps canvas').first().boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 50);
    assert.match(await page.textContent('#around-the-ring .map-value'), /in the gap of the ring/);
    await page.mouse.move(box.x + box.width - 4, box.y + 30);
    assert.match(
      await page.textContent('#around-the-ring .map-value'),
      /^x [\d.]+\smm, y [\d.]+\smm \([\d.]+° around the bore\): p [\d.]+\sbar, θ 1.00, h [\d.]+\sµm$/,
    );
    assert.match(
      await page.textContent('#around-the-ring figcaption'),
      /from one end of the ring's gap of 0.30.mm.*Highest: .*face widths.*Hatched: cavities.*61 of 121 nodes/s,
    );
    assert.deepEqual(faults, []);
    await page.close();
  });
}

test('the slider moves the maps around the ring, and their colours follow if asked', async () => {
  const { page, faults } = await opened('unrolled.html', 1400);
  const far = async (own) => {
    await page.click(`#around-the-ring button:text-is("${own ? 'Of this angle' : 'Colours of all angles'}")`);
    return mapPixels(page, 1);
  };
  await page.focus('#around-angle');
  await page.keyboard.press('Home');
  assert.match(await page.textContent('#around-the-ring h3'), /before firing TDC/);
  assert.match(await page.getAttribute('#around-angle', 'aria-valuetext'), /before firing TDC/);
  assert.equal((await far(false)).high, 0, 'a low pressure has no high colour among those of all angles');
  assert.ok((await far(true)).high > 1000);
  assert.deepEqual(faults, []);
  await page.close();
});

test('sums of strips are drawn over the cycle, and a case without an unrolled film has no map', async () => {
  const { page, faults } = await opened('unrolled.html', 1400);
  assert.deepEqual(
    await page.$$eval('#around-the-ring .choices .tools:first-child button', (list) =>
      list.map((b) => b.textContent),
    ),
    ['fields', 'strips'],
  );
  await page.click('#around-the-ring button:text-is("strips")');
  assert.equal(await page.isVisible('#around-angle'), false);
  assert.match(await page.textContent('#around-the-ring figcaption'), /sums over the strips/);
  const load = await mapPixels(page, 1);
  assert.equal(load.white, 0);
  assert.ok(load.high > 0.02 * load.all && load.low > 0.3 * load.all, JSON.stringify(load));
  const rows = (await downloaded(page, 'around-the-ring', 'CSV')).bytes.toString('utf8').trim().split('\r\n');
  assert.match(rows[0], /^"crank angle \[degree\]","y \[mm\]"/);
  assert.ok(rows.length > 240 * 50);
  assert.ok((await colouredPixels(page, '#gap-of-the-ring')) > 200);
  assert.match(
    await page.textContent('#gap-of-the-ring figcaption'),
    /between film and gap: 7\.0.*mg\/s.*0\.012\s%.*mean load: 0\.20\s%/s,
  );
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  assert.equal(await page.locator('#around-the-ring .print-only image').count(), 2);
  const none = await opened('three.html', 1400);
  assert.equal(await none.page.$('#around'), null);
  assert.deepEqual([...faults, ...none.faults], []);
  await none.page.close();
  await page.close();
});

test('every part of the report is there, in order', async () => {
  const { page } = await opened('three.html', 1400);
  const ids = await page.$$eval('main figure, main section[id]', (nodes) => nodes.map((n) => n.id));
  assert.deepEqual(ids, [
    'cycle',
    'min-film-thickness',
    'total-friction',
    'along-the-face',
    'cylinder-pressure',
    'lambda-ratio',
    'asperity-share',
    'friction-on-liner',
    'oil-flow-middle',
    'other-quantity',
    'friction',
    'friction-firing',
    'stribeck',
    'archard-wear-load-stroke',
    'regimes',
    'energy-by-stroke',
    'face',
    'ring-faces',
    'cycle-values',
    'comparison',
    'ledger',
    'influences',
    'validity',
    'inputs',
    'provenance',
  ]);
  assert.match(await page.textContent('.warning'), /SYNTHETIC/);
  assert.match(await page.textContent('#cylinder-pressure'), /SYNTHETIC/);
  assert.match(
    await page.textContent('.cards'),
    /118\s*W.*19\.1\s*kPa.*mesh ±\s*4\s*W.*0\.62\s*µm.*20° after TDC.*mesh ±\s*0\.02\s*µm.*90\.0\s*%/s,
  );
  // No regime of lubrication follows from the lambda ratio alone.
  assert.doesNotMatch(await page.textContent('main'), /mixed below|lubrication is mixed/);
  assert.match(await page.textContent('#regimes'), /boundary above 90\s*%, mixed, full film below 1\s*%/);
  // Three bars of three parts each, of each case.
  assert.equal((await page.$$('#regimes .bars > svg rect title')).length, 27);
  assert.equal(await page.$$eval('.section-drawing svg', (nodes) => nodes.length), 3);
  assert.match(
    await page.textContent('.plausibility'),
    /FMEP 19\.1 kPa – usual, at the upper end of 1 to 20 kPa of a top ring/,
  );
  await page.close();
});

test('the page of a ring pack has the sum of its rings', async () => {
  const { page, faults } = await opened('pack.html', 1400);
  const rows = await page.$$eval('.card:first-child .card-row', (nodes) => nodes.map((n) => n.textContent));
  assert.equal(rows.length, 3);
  const [top, second, sum] = rows.map((text) => Number(text.match(/FMEP ([\d.]+)/)[1]));
  assert.match(rows[2], /^all 2 rings/);
  assert.ok(Math.abs(top + second - sum) < 0.1);
  const boundary = await page.$$eval('.card:nth-child(3) .card-row b', (nodes) =>
    nodes.map((n) => Number(n.textContent)),
  );
  // 106.3 W and 0.7 of it are boundary friction, next to 11.75 W of each ring.
  [106.3 / 118.05, 74.41 / 86.16, 180.71 / 204.21].forEach((share, i) =>
    assert.ok(Math.abs(boundary[i] - 100 * share) < 0.06, `${boundary[i]} %`),
  );
  assert.deepEqual(faults, []);
  await page.close();
});

for (const width of [420, 1400]) {
  test(`a ring pack is drawn with its gas, and the slider moves its drawing at ${width} px`, async () => {
    const { page, faults } = await opened('ring_pack.html', width);
    const [wide, shown] = await page.evaluate(() => [
      document.documentElement.scrollWidth,
      window.innerWidth,
    ]);
    assert.ok(wide <= shown, `the page is ${wide} px wide in a window of ${shown} px`);
    for (const id of ['pack-friction', 'pack-pressures', 'pack-blow-by', 'pack-positions'])
      assert.ok((await colouredPixels(page, `#${id}`)) > 200, `${id} shows no curve`);
    const rows = await page.$eval('#pack table', (node) =>
      [...node.tBodies[0].rows].map((row) => row.textContent),
    );
    assert.equal(rows.length, 3);
    assert.match(rows[2], /^pack/);
    assert.match(
      await page.textContent('.cards'),
      /Oil left above the ring.*1\.50\s*µm.*0\.250\smg a cycle at TDC.*ring 2.*–.*not followed/s,
    );
    assert.match(
      await page.textContent('.plausibility'),
      /ring 1: FMEP.*a top ring of.*ring 2: FMEP.*a second compression ring of.*pack: FMEP.*a ring pack of/s,
    );
    assert.match(await page.textContent('#pack-blow-by figcaption'), /2\.00\smg per cycle, 1\.26\sl\/min/);
    const cylinder = () =>
      page.$eval('#pack-drawing svg', (svg) => Number(/cylinder ([\d.]+)/.exec(svg.textContent)[1]));
    const atPeak = await cylinder();
    await page.focus('#pack-angle');
    await page.keyboard.press('Home');
    assert.match(await page.textContent('#pack-drawing output'), /TDC/);
    assert.ok((await cylinder()) < atPeak / 10, 'the drawing has the pressures of the slider');
    const csv = (await downloaded(page, 'pack-friction', 'CSV')).bytes.toString('utf8').trim().split('\n');
    assert.ok(csv.length > 700);
    assert.deepEqual(faults, []);
    await page.close();
  });
}

test('no width of the window upsets the page', async () => {
  const { page, faults } = await opened('three.html', 1400);
  for (let width = 320; width <= 1440; width += 35) {
    await page.setViewportSize({ width, height: 900 });
    await page.waitForTimeout(40);
    const [wide, shown] = await page.evaluate(() => [
      document.documentElement.scrollWidth,
      window.innerWidth,
    ]);
    assert.ok(wide <= shown, `the page is ${wide} px wide in a window of ${shown} px`);
  }
  assert.deepEqual(faults, []);
  await page.close();
});

test('on a phone every link to a section is shown in full', async () => {
  for (const width of [320, 420, 700]) {
    const { page } = await opened('three.html', width);
    const cut = await page.$$eval('.contents a', (links) =>
      links
        .filter((link) => {
          const { left, right } = link.getBoundingClientRect();
          return left < 0 || right > window.innerWidth;
        })
        .map((link) => link.textContent),
    );
    assert.deepEqual(cut, []);
    await page.close();
  }
});

test('on a phone every button of the bar can be reached', async () => {
  const { page } = await opened('three.html', 390);
  await page.$eval('#lambda-ratio', (node) => node.scrollIntoView());
  const outside = await page.$$eval('.toolbar button', (buttons) =>
    buttons
      .filter((b) => {
        const box = b.getBoundingClientRect();
        return (
          box.left < 0 ||
          box.right > window.innerWidth ||
          document
            .elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2)
            ?.closest('button') !== b
        );
      })
      .map((b) => b.textContent),
  );
  assert.deepEqual(outside, []);
  await page.close();
});

test('an incomplete result states this first and draws what there is', async () => {
  const { page, faults } = await opened('bare.html', 1400);
  const reported = await page.textContent('.stopped');
  assert.match(reported, /INCOMPLETE/);
  assert.match(reported, /in its first cycle, last solved at 29° after firing TDC/);
  assert.match(reported, /No values of a whole cycle exist/);
  assert.equal(await page.$('.cards'), null);
  assert.equal(await page.$('#cycle-values table'), null);
  assert.equal(await page.$('#along-the-face'), null);
  assert.equal(await page.$('#ledger'), null);
  assert.deepEqual(faults, []);
  await page.close();
});

for (const name of ['three.html', 'hostile.html', 'bare.html']) {
  test(`${name} shows no number that is not finite`, async () => {
    const { page } = await opened(name, 1400);
    const text = await page.evaluate(() =>
      [...document.querySelectorAll('main, main [aria-label], main [title]')]
        .map((n) => [n.innerText, n.getAttribute('aria-label'), n.getAttribute('title')].join(' '))
        .join('\n'),
    );
    assert.doesNotMatch(text, /\b(nan|NaN|inf|Infinity|undefined)\b/);
    await page.close();
  });
}

test('files are without the folders of one machine, notes with their count in words', async () => {
  const { page } = await opened('three.html', 1400);
  const files = await page.textContent('#provenance');
  assert.match(files, /cases\/styles2014\/new\.toml/);
  assert.doesNotMatch(await page.evaluate(() => document.querySelector('main').innerText), /\/somewhere\//);
  assert.match(await page.textContent('#validity'), /412 of 720 crank angles/);
  await page.close();
});

test('no setting is named where computed and published agree', async () => {
  const { page } = await opened('three.html', 1400);
  const rows = await page.$$eval('#comparison .comparison tbody tr', (list) =>
    list.map((r) => [r.children[3].textContent, r.children[6].textContent]),
  );
  assert.equal(rows.length, 6, 'published values alone are in these tables');
  const check = await page.textContent('#comparison .cross-check');
  assert.match(check, /Cross-check with a second program.*mean friction power.*118/is);
  assert.ok(rows.some(([, setting]) => setting.includes('190 GPa')));
  for (const [deviation, setting] of rows)
    if (Math.abs(parseFloat(deviation.replace('−', '-'))) < 1) assert.equal(setting, '–');
  await page.close();
});

test('indices of symbols are set low, keys keep their underscores', async () => {
  const { page } = await opened('three.html', 1400);
  assert.equal(await page.$eval('#inputs sub', (node) => node.textContent), 'LFM');
  assert.match(await page.textContent('#inputs'), /boundary_shear_strength_coefficient/);
  await page.close();
});

test('the ledger is one table of words', async () => {
  const { page } = await opened('three.html', 1400);
  assert.equal((await page.$$('#ledger table.variants')).length, 1);
  const text = await page.textContent('#ledger table.variants');
  assert.match(
    text,
    /as run.*cavitation model: mass-conserving.*−9\.0\s%.*composite modulus: 190 GPa.*No solution/s,
  );
  assert.doesNotMatch(text, /film\.cavitation/);
  assert.match(await page.textContent('#ledger .assumptions'), /Oil supply.*none in this program/s);
  await page.close();
});

test('a table that is wider than the page states that it scrolls', async () => {
  const { page } = await opened('three.html', 390);
  const regions = await page.$$eval('.table-scroll', (nodes) =>
    nodes
      .filter((n) => n.clientWidth > 0)
      .map((n) => [n.scrollWidth > n.clientWidth + 1, n.classList.contains('overflows')]),
  );
  assert.ok(regions.some(([wide]) => wide));
  for (const [wide, marked] of regions) assert.equal(marked, wide);
  await page.close();
});

test('a hostile title is text, not a program', async () => {
  const { page } = await opened('hostile.html', 1400);
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => window.hostile), undefined);
  assert.match(await page.textContent('h1'), /<img src=x onerror=/);
  assert.match(await page.title(), /<\/script><img/);
  assert.equal(await page.$('main img'), null);
  await page.close();
});

test('the slider moves the fields along the face', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const before = await page.textContent('#along-the-face output');
  await page.focus('#face-angle');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  const after = await page.textContent('#along-the-face output');
  assert.notEqual(after, before);
  assert.match(await page.textContent('#along-the-face h3'), /180°/);
  // A pressure of 1 bar has an axis of its own: not that of 62 bar, on which its curve would lie flat.
  await page.waitForTimeout(100);
  assert.ok((await curveHeight(page, '#along-the-face')) > 0.4);
  assert.deepEqual(faults, []);
  await page.close();
});

test('the fields along the face follow the cursor of the charts, the cursor follows slider and play', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const film = page.locator('#min-film-thickness .over');
  await film.scrollIntoViewIfNeeded();
  const box = await film.boundingBox();
  // Three quarters of the axis are 180 degrees after firing TDC.
  await page.mouse.move(box.x + 0.75 * box.width, box.y + 60);
  const angle = (found) =>
    page.waitForFunction((words) => {
      const { textContent } = document.querySelector('#along-the-face h3');
      return words.startsWith('not ') ? !textContent.endsWith(words.slice(4)) : textContent.endsWith(words);
    }, found);
  await angle(' 180°');
  await page.mouse.move(5, 5);
  await page.focus('#face-angle');
  await page.keyboard.press('ArrowLeft');
  assert.match(await page.textContent('#along-the-face h3'), /90°/);
  assert.match(await page.textContent('#total-friction .at'), /at 90°/);
  await page.click('#along-the-face button:text-is("Play")');
  await angle('not  90°');
  await page.click('#along-the-face button:text-is("Pause")');
  const at = await page.textContent('#total-friction .at');
  assert.ok((await page.textContent('#along-the-face h3')).endsWith(at.replace('at ', '')), at);
  assert.deepEqual(faults, []);
  await page.close();
});

test('friction turns to a logarithmic axis and back, in the window shown', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const before = await colouredPixels(page, '#total-friction');
  await page.click('.range:text-is("Power")');
  await page.click('#total-friction .scale');
  await page.waitForTimeout(100);
  assert.ok((await colouredPixels(page, '#total-friction')) > 200);
  const svg = (await downloaded(page, 'total-friction', 'SVG')).bytes.toString('utf8');
  assert.ok(!svg.includes('NaN') && !svg.includes('>exhaust<'));
  await page.click('#total-friction .scale');
  await page.click('.range:text-is("Whole cycle")');
  await page.waitForTimeout(100);
  assert.equal(await colouredPixels(page, '#total-friction'), before);
  assert.deepEqual(faults, []);
  await page.close();
});

test('a name in the legend hides its case in the whole page and brings it back', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const counted = async () => [
    await colouredPixels(page, '#total-friction'),
    await colouredPixels(page, '#stribeck'),
    (await page.$$('#energy-by-stroke .bars > svg rect title')).length,
  ];
  const all = await counted();
  await page.click('#total-friction .entry[data-case="0"]');
  await page.waitForTimeout(100);
  const fewer = await counted();
  fewer.forEach((n, i) => assert.ok(n < all[i], `chart ${i} did not change: ${all} -> ${fewer}`));
  assert.equal(await page.getAttribute('#stribeck .entry[data-case="0"]', 'aria-pressed'), 'false');
  await page.click('#stribeck .entry[data-case="0"]');
  await page.waitForTimeout(100);
  assert.deepEqual(await counted(), all);
  assert.deepEqual(faults, []);
  await page.close();
});

test('the cursor reads values in all cycle charts, and a drag zooms all of them', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const over = page.locator('#total-friction .over');
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + 80);
  await page.waitForTimeout(100);
  const at = await page.textContent('#total-friction .at');
  assert.match(at, /^at \d/);
  assert.equal(await page.textContent('#min-film-thickness .at'), at);
  assert.match(await page.textContent('#total-friction .entry .value'), /\d/);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 200, box.y + 80, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(100);
  assert.equal(await page.getAttribute('.range:text-is("Whole cycle")', 'aria-pressed'), 'false');
  await page.click('.range:text-is("Whole cycle")');
  assert.equal(await page.getAttribute('.range:text-is("Whole cycle")', 'aria-pressed'), 'true');
  assert.deepEqual(faults, []);
  await page.close();
});

test('any quantity of the result can be chosen', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const names = await page.$$eval('#quantity option', (options) => options.map((o) => o.value));
  assert.ok(names.includes('rupture_position') && names.includes('load_residual'));
  for (const name of names) {
    await page.selectOption('#quantity', name);
    assert.match(await page.textContent('#other-quantity figcaption'), new RegExp(name));
  }
  assert.deepEqual(faults, []);
  await page.close();
});

test('every figure can be taken away as PNG, SVG and CSV', async () => {
  const { page, faults } = await opened('three.html', 1400);
  const ids = await page.$$eval('main figure', (nodes) => nodes.map((n) => n.id));
  for (const id of ids) {
    const png = await downloaded(page, id, 'PNG');
    assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG', id);
    assert.ok(png.bytes.length > 5000, `${id}: PNG of ${png.bytes.length} bytes`);
    const svg = (await downloaded(page, id, 'SVG')).bytes.toString();
    assert.ok(
      svg.startsWith('<svg') && !svg.includes('NaN') && !svg.includes('undefined'),
      `${id}: a broken SVG`,
    );
    assert.equal(
      await page.evaluate(
        (text) =>
          new DOMParser().parseFromString(text, 'image/svg+xml').querySelectorAll('parsererror').length,
        svg,
      ),
      0,
      id,
    );
    const csv = (await downloaded(page, id, 'CSV')).bytes.toString().trim().split('\r\n');
    assert.ok(csv.length > 3 && csv[0].includes('['), `${id}: CSV ${csv[0]}`);
  }
  const csv = await downloaded(page, 'friction-on-liner', 'CSV');
  assert.match(csv.name, /styles-et-al-2014-friction-on-liner\.csv$/);
  assert.match(csv.bytes.toString(), /crank angle, firing TDC = 0 \[degree\]/);
  assert.deepEqual(faults, []);
  await page.close();
});

test('in print every figure is a drawing and no button is left', async () => {
  const { page, faults } = await opened('three.html', 1400);
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  const figures = await page.$$eval('main figure', (nodes) =>
    nodes.map((n) => n.querySelector('.print-only svg')?.getBoundingClientRect().width ?? 0),
  );
  figures.forEach((width) => assert.ok(width > 300));
  assert.equal(
    await page.$$eval(
      '.downloads, .toolbar, .panels',
      (nodes) => nodes.filter((n) => n.offsetParent !== null).length,
    ),
    0,
  );
  // Paper is narrower than the screens on which tables fold, and is not a phone.
  await page.setViewportSize({ width: 690, height: 900 });
  assert.equal(
    await page.$$eval(
      'table.folds tr',
      (rows) => rows.filter((r) => getComputedStyle(r).display !== 'table-row').length,
    ),
    0,
  );
  const pdf = await page.pdf({ format: 'A4' });
  assert.ok(pdf.length > 20000);
  assert.deepEqual(faults, []);
  await page.close();
});

test('what a screen reader needs is there', async () => {
  const { page } = await opened('three.html', 1400);
  assert.equal(
    await page.$$eval('[role=img]', (nodes) => nodes.filter((n) => !n.getAttribute('aria-label')).length),
    0,
  );
  assert.equal(
    await page.$$eval(
      'table',
      (nodes) => nodes.filter((n) => !n.caption || n.querySelectorAll('th[scope=col]').length === 0).length,
    ),
    0,
  );
  assert.equal(await page.$$eval('button', (nodes) => nodes.filter((n) => !n.textContent.trim()).length), 0);
  assert.equal(await page.$$eval('h1', (nodes) => nodes.length), 1);
  assert.equal(await page.getAttribute('html', 'lang'), 'en');
  await page.close();
});

await runTests();
