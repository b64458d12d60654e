// What the page states about a cycle: usual ranges, the section, the thinnest film, kinks. Without a browser
// usage: node cycle_test.mjs SOURCE_FOLDER_OF_THE_PAGE
import assert from 'node:assert/strict';
import test from 'node:test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const load = (name) => import(pathToFileURL(join(process.argv[2], 'src', name)).href);
const { settingWords } = await load('cycle/setting_words.js');
const { breakthroughs, closings, fullFilmMarks, thinnestInWords } = await load('cycle/cycle_figures.js');
const { regimeFigure } = await load('cycle/other_figures.js');
const { indicatorFigure } = await load('cycle/indicator_figure.js');
const { exaggeration, sectionState, sectionSvg } = await load('cycle/section_drawing.js');
const usual = await load('cycle/usual.js');
const { warnings } = await load('cycle/first_screen.js');
const { massText, oilAbove } = await load('cycle/oil_above.js');
const { boundaryPowerShare, Model } = await load('model.js');
const { figureCsv } = await load('downloads.js');
const { kSpanHeight, logarithmic, spanBars } = await load('plot/scales.js');
const { figureSvg } = await load('plot/svg.js');

test('a note that is only for information heads no page', () => {
  const note = (message, rank, for_information) => ({ topic: message, message, rank, for_information });
  const model = (...notes) => ({ cases: [{ name: 'a', notes, files: [] }], isSynthetic: () => false });
  assert.deepEqual(warnings(model(note('of the solver', 60, true))), []);
  assert.deepEqual(warnings(model(note('of the solver', 60, true), note('a limit', 9, false))), ['a limit.']);
});

test('usual ranges are those that the manual argues', () => {
  const page = readFileSync(join(process.argv[2], '../../../../docs/manual/guide/plausibility.md'), 'utf8');
  const { kUsualFmep, kDieselFactor, kUsualCoefficient, kModifiedCoefficient, verdict } = usual;
  const { top, second, oil, pack } = kUsualFmep;
  assert.ok(page.includes(`FMEP between ${top.low} and ${top.high} kPa for a top ring`));
  assert.ok(page.includes(`down to ${top.low} kPa`) && page.includes(`to ${top.high} kPa; down`));
  for (const [words, { low, high }] of [
    ['second compression ring', second],
    ['oil ring with all its rails', oil],
    ['ring pack', pack],
  ])
    assert.ok(page.includes(`| ${words}, car engine | ${low} to ${high} kPa |`), words);
  for (const [words, { low, high }] of [
    ['top ring alone', top],
    ['second compression ring', second],
    ['ring pack', pack],
  ]) {
    const row = `| ${words}, diesel engine | ${kDieselFactor * low} to ${kDieselFactor * high} kPa |`;
    assert.ok(page.includes(row), row);
  }
  const { low, high } = oil.diesel;
  assert.ok(
    page.includes(`| oil ring with all its rails, diesel engine | ${low} to ${high} kPa | patton1989`),
  );
  // Half to three quarters of the friction without gas load after patton1989, a quarter to twice of that.
  const withoutGas = (4.06e4 * (1 + 1000 / 1200)) / 130 ** 2;
  assert.ok(Math.abs((0.25 * 0.5 * withoutGas) / low - 1) < 0.15);
  assert.ok(Math.abs((2 * 0.75 * withoutGas) / high - 1) < 0.15);
  assert.ok(page.includes(`a bore above ${usual.kLargestCarBore} mm or a peak pressure above`));
  assert.ok(page.includes(`a peak pressure above ${usual.kHighestCarPeak} bar`));
  assert.ok(page.includes(`| ${kUsualCoefficient.low} to ${kUsualCoefficient.high} |`));
  assert.ok(page.includes(`| down to ${kModifiedCoefficient} |`));
  assert.deepEqual(
    [0.5, 7, 19.1, 22, null, NaN].map((v) => verdict(v, top)),
    ['below', 'usual', 'upper end', 'above', null, null],
  );
});

test('the range of the friction is that of the engine of the case', () => {
  const range = (bore, peak) => {
    const model = smallModel([{ key: 'engine.bore', value_si: bore }], {}, { peak_gas_pressure: peak });
    return usual.fmepRange(model, model.cases[0], 'top');
  };
  assert.deepEqual(range(0.089, 62e5), { low: 1, high: 20, words: 'a top ring of a car engine' });
  assert.deepEqual(range(0.13, 90e5), {
    low: 2,
    high: 40,
    words: 'a top ring of a diesel engine, for a bore of 130 mm',
  });
  assert.match(range(0.083, 180e5).words, /diesel engine, for a peak pressure of 180 bar$/);
});

test('rings of a pack are judged by their kind, rails together, and so is the pack', () => {
  const ring = (kind, peak_gas_pressure, bore) => ({
    title: kind,
    complete: true,
    values: { peak_gas_pressure },
    unrolled_values: {},
    inputs: [
      { key: 'engine.bore', value_si: bore },
      { key: 'ring.kind', shown: kind },
    ],
    curves: {},
    errors: null,
  });
  const fmep = (kPa) => ({ fmep: 1e3 * kPa });
  const verdicts = (peak, bore = 0.089) => {
    const model = new Model({
      curve_quantities: [],
      cycle_quantities: [{ name: 'fmep', unit: 'Pa', display_unit: 'kPa', long_name: 'FMEP' }],
      derived_quantities: [],
      unrolled_quantities: [],
      unrolled_cycle_quantities: [],
      cases: [
        ring('compression', peak, bore),
        ring('compression', 6e5, bore),
        ring('oil', 1e5, bore),
        ring('oil', 1e5, bore),
      ],
      packs: [
        {
          title: 'pack',
          complete: true,
          first_case: 0,
          ring_numbers: [1, 2, 3, 3],
          values: fmep(42),
          by_ring: [12, 12, 18].map((kPa, i) => ({ ring: i + 1, values: fmep(kPa) })),
        },
      ],
    });
    return usual.fmepVerdicts(model).map(({ name, found, text }) => `${name}: ${found}, ${text}`);
  };
  const [first, second, third, pack] = verdicts(62e5);
  assert.match(first, /^ring 1: usual, .*1 to 20 kPa of a top ring of a car engine$/);
  assert.match(second, /^ring 2: above, .*0\.5 to 8 kPa of a second compression ring of a car engine$/);
  assert.match(third, /^ring 3: above, .*1 to 12 kPa of an oil ring of a car engine$/);
  assert.match(pack, /^pack: above, .*4 to 40 kPa of a ring pack of a car engine$/);
  // The peak of the cylinder decides for all but the oil ring, which has no gas load: there the bore decides.
  const loaded = verdicts(180e5);
  [loaded[0], loaded[1], loaded[3]].forEach((line) => assert.match(line, /diesel engine/));
  assert.match(loaded[2], /1 to 12 kPa of an oil ring of a car engine/);
  assert.match(verdicts(180e5, 0.13)[2], /0\.5 to 7 kPa of an oil ring of a diesel engine/);
});

/** A compression and expansion p V^n = C of an engine with a ratio of 10, and no gas exchange. */
function polytropicCase(name, index, { offset = 0, inputs = [] } = {}) {
  const crank_angle = Array.from({ length: 720 }, (_, k) => k);
  const [stroke, rod, ratio] = [0.08, 0.14, 10];
  const volume = (degree) => {
    const angle = (degree * Math.PI) / 180;
    const r = stroke / 2;
    return (
      stroke / (ratio - 1) + r + rod - r * Math.cos(angle) - Math.sqrt(rod ** 2 - (r * Math.sin(angle)) ** 2)
    );
  };
  const bottom = volume(180);
  const pressure = (degree) =>
    (degree < 180 || degree > 540 ? 1e5 * (bottom / volume(degree)) ** index : 1e5) + offset;
  return {
    title: name,
    complete: true,
    values: {},
    curves: { crank_angle, gas_pressure: crank_angle.map(pressure) },
    derived: { imep: 5.507e5 },
    inputs: [
      { key: 'engine.bore', value_si: 0.08 },
      { key: 'engine.stroke', value_si: stroke },
      { key: 'engine.connecting_rod_length', value_si: rod },
      ...inputs,
    ],
  };
}

function modelOf(...cases) {
  return new Model({
    curve_quantities: [
      { name: 'gas_pressure', unit: 'Pa', display_unit: 'bar', long_name: 'gas pressure above the ring' },
    ],
    cycle_quantities: [],
    derived_quantities: [],
    unrolled_quantities: [],
    unrolled_cycle_quantities: [],
    cases,
  });
}

test('the indicator diagram has the volume of the crank and the index of compression', () => {
  const stated = { inputs: [{ key: 'gas.compression_ratio', value_si: 10 }] };
  const figure = indicatorFigure(modelOf(polytropicCase('a', 1.32, stated)));
  const [{ xScale, yScale, series }] = figure.panels;
  assert.deepEqual([xScale, yScale, series.length], ['log', 'log', 1]);
  const swept = ((Math.PI * 8 * 8) / 4) * 8; // [cm3]
  assert.ok(Math.abs(Math.min(...series[0].x) - swept / 9) < 1e-6 * swept);
  assert.ok(Math.abs(Math.max(...series[0].x) - (swept * 10) / 9) < 1e-6 * swept);
  assert.ok(Math.abs(Math.max(...series[0].y) - 10 ** 1.32) < 1e-9 * 21); // compressed ten times from 1 bar
  assert.equal(series[0].x.length, 721); // the loop is closed
  assert.match(figure.caption, /Indicated mean effective pressure: 5\.507 bar/);
  assert.match(figure.caption, /index of compression from −90° to −45°: 1\.32 /);
  assert.doesNotMatch(figure.caption, /assumed/);
});

test('an offset shows in the index, and an unknown compression ratio is assumed', () => {
  const stated = { inputs: [{ key: 'gas.compression_ratio', value_si: 10 }] };
  const raised = indicatorFigure(modelOf(polytropicCase('a', 1.32, { ...stated, offset: 0.5e5 })));
  assert.match(raised.caption, /−45°: 1\.[01]/); // n p/(p + offset), eq-compression-index
  assert.match(indicatorFigure(modelOf(polytropicCase('a', 1.32))).caption, /ratio of 12 is assumed/);
});

test('the indicator diagram draws a pressure once, and none without compression or crank', () => {
  const twice = indicatorFigure(modelOf(polytropicCase('a', 1.3), polytropicCase('b', 1.3)));
  assert.deepEqual(
    twice.panels[0].series.map(({ label, caseIndex }) => [label, caseIndex]),
    [['both cases', null]],
  );
  assert.equal(
    indicatorFigure(modelOf(polytropicCase('a', 1.3), polytropicCase('b', 1.35))).panels[0].series.length,
    2,
  );
  const second = polytropicCase('a', 1.3, { inputs: [{ key: 'ring.pressure_above', shown: '1 bar' }] });
  assert.equal(indicatorFigure(modelOf(second)), null);
  assert.equal(indicatorFigure(modelOf(polytropicCase('a', 0))), null);
  const bare = polytropicCase('a', 1.3);
  assert.equal(indicatorFigure(modelOf({ ...bare, inputs: bare.inputs.slice(1) })), null);
});

test('oil above a ring is the film behind it on downstrokes, where the oil on the liner is followed', () => {
  const stroke = {
    film_behind_power: [1e-6, 2e-6],
    film_behind_exhaust: [9e-6, 9e-6],
    film_behind_intake: [3e-6, 4e-6],
  };
  assert.equal(oilAbove({ complete: true, stroke }).film.toFixed(9), '2.500000000');
  assert.equal(oilAbove({ complete: true, stroke: {} }), null);
  assert.equal(oilAbove({ complete: false, stroke }), null);
  assert.deepEqual([7.237e-7, 8.8e-31, 0, null].map(massText), [
    '0.724\u00a0mg',
    'below 0.001\u00a0mg',
    '0\u00a0mg',
    '–',
  ]);
});

test('the section is drawn from the numbers of the case at the peak of the gas pressure', () => {
  const one = {
    curves: {
      crank_angle: [0, 20, 40],
      gas_pressure: [3e6, 6.2e6, 4e6],
      crankcase_pressure: [1e5, 1e5, 1e5],
      min_film_thickness: [8e-7, 6e-7, 7e-7],
    },
    derived: { elastic_pressure: 2e5 },
    inputs: [],
    fields: { x: [0, 5e-4, 1e-3], face_height: [2.94e-5, 0, 9e-6], crank_angle: [], film_pressure: [] },
  };
  const state = sectionState(one, 20);
  assert.deepEqual([state.angle, state.above, state.film], [20, 6.2e6, 6e-7]);
  // 72 pixels for a gap of 30 um, 150 for a face of 1 mm.
  assert.ok(Math.abs(exaggeration(state) - 16) < 0.01);
  const svg = sectionSvg(state);
  assert.ok(/62.0\u00a0bar/.test(svg) && /0.600 µm/.test(svg) && !/NaN|undefined|asperity/.test(svg));
  assert.equal(sectionState({ ...one, fields: { ...one.fields, x: [] } }, 20), null);
});

/** A model of one case of four samples with the given inputs, curves and values. */
function smallModel(inputs, curves, values) {
  const quantities = Object.keys(curves).map((name) => ({
    name,
    unit: '1',
    display_unit: '1',
    long_name: name,
  }));
  return new Model({
    curve_quantities: quantities,
    cycle_quantities: [],
    derived_quantities: [],
    unrolled_quantities: [],
    unrolled_cycle_quantities: [],
    cases: [{ title: 't', complete: true, values, unrolled_values: {}, inputs, curves, errors: null }],
  });
}

test('the place of the thinnest film is named next to the peak of the gas pressure', () => {
  const words = (thinnest, peak, pressures = [1, 2]) => {
    const model = smallModel(
      [],
      { crank_angle: [0, 20], gas_pressure: pressures },
      { min_film_thickness_angle: thinnest, peak_gas_pressure_angle: peak },
    );
    return thinnestInWords(model, model.cases[0]);
  };
  assert.equal(words(20, 20), '20° after firing TDC, at the peak of the gas pressure');
  assert.equal(words(5, 20), '5° after firing TDC, 15° before the peak of the gas pressure');
  assert.equal(words(540, 20), '180° before firing TDC, away from the peak of the gas pressure');
  assert.equal(words(5, 0, [2, 2]), '5° after firing TDC');
});

test('boundary friction is a share of the friction power, without friction there is none', () => {
  assert.equal(boundaryPowerShare({ mean_boundary_power: 9, mean_power_loss: 10 }), 90);
  assert.equal(boundaryPowerShare({ mean_boundary_power: 0, mean_power_loss: 0 }), null);
});

test('the lambda ratio above which the film is full is marked once where all cases have the same', () => {
  const model = (...ratios) => ({
    cases: ratios.map((ratio, i) => ({
      name: `case ${i}`,
      derived: ratio ? { full_film_lambda_ratio: ratio } : {},
    })),
  });
  assert.deepEqual(fullFilmMarks(model(4.752, 4.754)), [{ at: 4.752, label: 'full film above' }]);
  assert.deepEqual(fullFilmMarks(model(4.75, null, 3.8)), [
    { at: 4.75, label: 'case 0: full film above' },
    { at: 3.8, label: 'case 2: full film above' },
  ]);
  assert.deepEqual(fullFilmMarks(model(null)), []);
});

test('the regimes are bars that add up to the whole: cycle, sliding distance, friction energy', () => {
  const shares = { cycle: [0.25, 0.7, 0.05], distance: [0.2, 0.7, 0.1], energy: [0.5, 0.5, 0] };
  const values = Object.fromEntries(
    Object.entries(shares).flatMap(([of, list]) =>
      ['boundary_regime', 'mixed_regime', 'full_film'].map((name, k) => [`${name}_${of}_share`, list[k]]),
    ),
  );
  const model = smallModel([], { crank_angle: [0] }, values);
  model.cycleQuantity = new Map(
    Object.keys(values).map((name) => [name, { name, unit: '1', display_unit: '%', long_name: name }]),
  );
  const figure = regimeFigure(model);
  assert.match(figure.caption, /Friction energy: boundary 50\u00a0%, mixed 50\u00a0%, full film 0\u00a0%\./);
  const svg = figureSvg(figure, () => true, { width: 600 });
  const bars = [...svg.matchAll(/width="([\d.]+)" height="20.00"[^>]*><title>computed, ([^<]*)</g)];
  assert.equal(bars.length, 9);
  const whole = Number(bars[0][1]) / 0.25;
  for (const [, width, words] of bars) {
    const [, of, percent] = /(cycle|distance|energy), .*: ([\d.]+) %$/.exec(words);
    assert.ok(of in shares && Math.abs((100 * Number(width)) / whole - percent) < 0.05, words);
  }
  const [heads, row] = figureCsv(figure).split('\r\n');
  assert.equal(heads.split('","').length, 10);
  assert.match(heads, /"share, friction energy, full film \[%\]"$/);
  assert.equal(row, '"computed",25,70,5,20,70,10,50,50,0');
  assert.equal(regimeFigure({ cases: [{ complete: false }] }), null);
});

test('a cavity closes where the film is full again, if its mass is conserved', () => {
  const at = (cavitation, edge = 'oil') => {
    const model = smallModel(
      [
        { key: 'film.cavitation', shown: cavitation },
        { key: 'film.chamber_edge', shown: 'oil' },
        { key: 'film.crankcase_edge', shown: edge },
      ],
      { crank_angle: [0, 180, 190, 540], gas_pressure: [1, 2, 2, 1], cavitated_fraction: [0, 0.1, 0, 0] },
      {},
    );
    return closings(model, model.cases[0]);
  };
  assert.deepEqual(at('mass-conserving'), [190]);
  assert.deepEqual(at('reynolds-exit'), []);
  // Gas fills a part of the face there, which counts as no cavity.
  assert.deepEqual(at('mass-conserving', 'gas'), []);
});

test('gas breaks through from the first to the last angle of each stretch, also across gas-exchange TDC', () => {
  const found = (gas_breakthrough) =>
    breakthroughs({ curves: { crank_angle: [0, 90, 180, 350, 370, 540], gas_breakthrough } });
  assert.deepEqual(found([0, 1, 1, 0, 0, 0]), [{ from: 90, to: 180, count: 2 }]);
  assert.deepEqual(found([1, 0, 0, 1, 1, 0]), [
    { from: 0, to: 0, count: 1 },
    { from: 350, to: -350, count: 2 },
  ]);
  assert.deepEqual(found([0, 0, 0, 0, 0, 0]), []);
  assert.deepEqual(found([1, 1, 1, 1, 1, 1]), [{ from: -360, to: 360, count: 6 }]);
});

test('stretches are bars within the window, a row for each case that is shown', () => {
  const spans = [
    { from: 350, to: -350, caseIndex: 0 },
    { from: 10, to: 20, caseIndex: 1 },
  ];
  const bars = (window, shown) =>
    spanBars({ spans }, window, shown).map(({ from, to, top }) => [from, to, top]);
  assert.deepEqual(
    bars([-360, 360], () => true),
    [
      [350, 360, 0],
      [-360, -350, 0],
      [10, 20, kSpanHeight + 1],
    ],
  );
  assert.deepEqual(
    bars([0, 15], ({ caseIndex }) => caseIndex === 1),
    [[10, 15, 0]],
  );
  assert.deepEqual(
    bars([30, 90], () => true),
    [],
  );
});

test('a logarithmic axis has no place for what is not positive', () => {
  const { panels } = logarithmic({
    panels: [{ series: [{ y: [0, 2, -1, 4], error: [1, 1, 1, 5] }] }],
  });
  assert.equal(panels[0].yScale, 'log');
  assert.deepEqual(panels[0].series[0].y, [null, 2, null, 4]);
  assert.deepEqual(panels[0].series[0].error, [null, 1, null, null]);
});

test('settings of the ledger are words, with and without an entry in the list', () => {
  assert.equal(
    settingWords('contact.integrals = "polynomial-4-digit"'),
    'contact integrals: polynomials of four digits',
  );
  assert.equal(settingWords('operating.oil_temperature = "100 degC"'), 'oil temperature: 100 °C');
  assert.equal(
    settingWords('gas.pressure_behind_ring = 0.9'),
    'share of the gas pressure behind the ring: 0.9',
  );
  assert.equal(settingWords('ring.some_new_key = "1 mm"'), 'some new key: 1 mm');
  assert.equal(settingWords('not a setting'), 'not a setting');
});
