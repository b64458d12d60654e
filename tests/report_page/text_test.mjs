// What the page makes of numbers, angles, titles and gaps, without a browser
// usage: node text_test.mjs SOURCE_FOLDER_OF_THE_PAGE
import assert from 'node:assert/strict';
import test from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const load = (name) => import(pathToFileURL(join(process.argv[2], 'src', name)).href);
const {
  angleInWords,
  asStated,
  crankTicks,
  display,
  errorText,
  howOften,
  logTicks,
  number,
  numberOrCount,
  percent,
  meaningful,
  sentence,
  shortPath,
  ticks,
  tickText,
  typesetFormula,
  typesetMath,
  typesetSymbol,
  typesetUnit,
  withError,
  withErrorAndPower,
  withoutFolders,
  withUnit,
  wrapped,
} = await load('units.js');
const { namesByInputs, onCycleAxis, shortNames, stoppedAt } = await load('model.js');
const { figureCsv, fileStem } = await load('downloads.js');
const { figureSvg } = await load('plot/svg.js');
const { bandOutlines, freePlace, markIndices, markPlaces } = await load('plot/scales.js');
const { kHeightColours, kMissingColour } = await load('plot/colour_map.js');
const { fieldCaption } = await load('cycle/around_figures.js');
const { blowByWords, withoutRounding } = await load('pack/gas_words.js');
const { gridText } = await load('tables.js');
const { cellAt, cellEdges, crankAxis, ringAxis, Unrolled } = await load('cycle/unrolled.js');
const { fieldMaps, stripMaps } = await load('cycle/around_figures.js');
const { lengthUnit } = await load('plot/map_figure.js');
const { curveFigure, withoutPoints } = await load('measurement/measurement_figures.js');

test('numbers carry four significant digits and a true minus sign', () => {
  assert.equal(number(0.61732), '0.6173');
  assert.equal(number(118.04193), '118.0');
  assert.equal(number(12345.6), '12346');
  assert.equal(number(-0.0005), '−5.000\u202f·\u202f10⁻⁴');
  assert.equal(number(0), '0');
  for (const none of [null, undefined, NaN, Infinity]) assert.equal(number(none), '–');
});

test('a number just below a power of ten has no exponent', () => {
  assert.equal(number(999.97, 3), '1000');
  assert.equal(number(-99999.7, 4), '−100000');
});

test('a count has neither point nor zeros behind it', () => {
  assert.equal(numberOrCount(3, ''), '3');
  assert.equal(numberOrCount(-1624, ''), '−1624');
  assert.equal(numberOrCount(3, 'µm'), '3.000');
  assert.equal(numberOrCount(0.5, ''), '0.5000');
  assert.equal(numberOrCount(null, ''), '–');
});

test('value and error far from one share their power of ten', () => {
  assert.equal(withErrorAndPower(8.1e-8, 3.2e-9, ''), '(8.1 ± 0.4)\u202f·\u202f10⁻⁸');
  assert.equal(withErrorAndPower(0.412, 0.0123, ''), '0.412 ± 0.013');
  assert.equal(withErrorAndPower(8.1e-8, null, ''), number(8.1e-8));
  assert.equal(withErrorAndPower(null, 0.1, ''), '–');
});

test('units and symbols are printed as people write them', () => {
  assert.equal(typesetUnit('um-2'), 'µm⁻²');
  assert.equal(typesetUnit('um3'), 'µm³');
  assert.equal(typesetUnit('nN V-1'), 'nN V⁻¹');
  assert.equal(typesetUnit('1'), '');
  assert.equal(typesetSymbol('N beta sigma'), 'N β σ');
  assert.equal(typesetSymbol('m4'), 'm4');
  assert.equal(typesetFormula("2/E' = sum (1 - nu^2)/E_1"), "2/E' = Σ (1 − ν²)/E₁");
  assert.equal(typesetFormula('alpha_0 of the oil'), 'α₀ of the oil');
  assert.equal(typesetFormula('lowest lambda ratio'), 'lowest lambda ratio');
  assert.equal(typesetSymbol('sigma_1'), 'σ_1');
  assert.equal(typesetSymbol('constructor'), 'constructor');
  assert.deepEqual(
    [3e-3, 5e-5, 1e-9].map((v) => lengthUnit(v, 2).unit),
    ['mm', 'µm', 'nm'],
  );
});

/** CIELAB (CIE 1976) of sRGB, D65: shares no line with the making of the colours. */
function lab(rgb) {
  const [r, g, b] = rgb
    .map((v) => v / 255)
    .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  const f = (t) => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116);
  const [x, y, z] = [
    (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505,
    0.2126 * r + 0.7152 * g + 0.0722 * b,
    (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089,
  ].map(f);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const apart = (a, b) => Math.hypot(...a.map((v, i) => v - b[i]));

test('colours of heights rise evenly in lightness, and no height is grey', () => {
  const labs = kHeightColours.map(lab);
  assert.equal(labs.length, 256);
  labs.slice(1).forEach((v, k) => assert.ok(v[0] > labs[k][0] - 0.2, `lightness falls at ${k}`));
  assert.ok(labs[255][0] - labs[0][0] > 70);
  const steps = [];
  for (let k = 16; k < 256; k += 16) steps.push(apart(labs[k], labs[k - 16]));
  // CIELAB and OKLab disagree by about so much on what is even; a rainbow of hues reaches 5.
  assert.ok(Math.max(...steps) / Math.min(...steps) < 1.6, String(steps));
  const missing = lab(kMissingColour.match(/[0-9a-f]{2}/g).map((hex) => parseInt(hex, 16)));
  assert.ok(Math.min(...labs.map((v) => apart(v, missing))) > 25);
});

test('labels of upright lines are in rows and inside the plot', () => {
  const places = markPlaces(
    [
      { at: 10, label: 'used' },
      { at: 15, label: 'other' },
      { at: 98, label: 'last' },
      { at: 120, label: 'outside' },
    ],
    (v) => v,
    () => 30,
    0,
    100,
  );
  assert.deepEqual(
    places.map((p) => p.label),
    ['used', 'other', 'last'],
  );
  assert.deepEqual(
    places.map((p) => p.row),
    [0, 1, 0],
  );
  assert.ok(places.every((p) => p.left >= 0 && p.left + 30 <= 100));
});

test('points are all marked, and marks of a line keep even distances on a logarithmic axis', () => {
  const x = Array.from({ length: 400 }, (_, k) => k + 1);
  assert.deepEqual(
    markIndices({ part: 'points', caseIndex: null, x: [1, null, 3], y: [1, 1, null] }, 0, 4, 1),
    [0],
  );
  const marks = markIndices({ part: null, caseIndex: 0, x, y: x }, 1, 400, 2, 'log').map((k) => x[k]);
  const ratios = marks
    .slice(1)
    .map((v, k) => v / marks[k])
    .slice(2);
  assert.ok(Math.max(...ratios) / Math.min(...ratios) < 1.2, String(ratios));
});

test('a curve has no point where a logarithmic axis has no place, and is stated to have none at all', () => {
  const axis = (logarithmic) => ({ long_name: 'x', unit: 'um', logarithmic });
  const curve = {
    name: 'c',
    title: 'Curve',
    caption: 'Given.',
    x: axis(true),
    y: axis(true),
    points: 4,
    drawn: 4,
    marks: [{ at: null, label: 'none' }],
    series: [{ label: 'a', points: false, x: [0, 1, 3, 2], y: [1, -1, 5, 4] }],
  };
  const {
    panels: [panel],
    caption,
  } = curveFigure(curve);
  assert.deepEqual(
    [panel.series[0].x, panel.series[0].y],
    [
      [1, 2, 3],
      [null, 4, 5],
    ],
  );
  assert.deepEqual([panel.xScale, panel.xUnit, panel.xMarks.length, caption], ['log', 'µm', 0, 'Given.']);
  assert.match(curveFigure({ ...curve, points: 9000 }).caption, /Drawn from 4 of 9000 points/);
  assert.deepEqual(
    withoutPoints([curve, { ...curve, series: [{ ...curve.series[0], y: [null, null, null, null] }] }])
      .length,
    1,
  );
});

test('an error is rounded up to a digit, and its value to the same place', () => {
  assert.equal(withError(19.0931, 0.0178, 'kPa'), '19.093 ± 0.018');
  assert.equal(withError(19.0931, 0.021, 'kPa'), '19.09 ± 0.03');
  assert.equal(withError(-1234.5, 40, 'N'), '−1230 ± 40');
  assert.equal(withError(0.3, 0.95, ''), '0.3 ± 1.0');
  assert.equal(withError(62.5, 1e-9, 'bar'), '62.50000 ± 0.00001');
  assert.equal(withError(180, 361, '°'), '180 ± 361');
  assert.equal(withError(62.5, 0, 'bar'), '62.50');
  assert.equal(withError(62.5, null, 'bar'), '62.50');
  assert.equal(withError(null, 0.1, 'bar'), '–');
});

test('a value on the first screen has the digits that mean something', () => {
  assert.equal(meaningful(0.61732, 0.00004), '0.617');
  assert.equal(meaningful(118.04, 4), '118');
  assert.equal(meaningful(0.61732, 0.019), '0.62');
  assert.equal(meaningful(0.3, 0.95), '0.3');
  assert.equal(meaningful(868.7, null), '869');
  assert.equal(meaningful(null, 0.1), '–');
  assert.deepEqual([0.0178, 0.00004, 3.51, 0, null].map(errorText), ['0.02', '0.00004', '4', '', '']);
});

test('a band has an outline for each piece of its curve', () => {
  assert.deepEqual(
    bandOutlines({ x: [0, 1, 2, 3, 4, 5], y: [1, 1, null, 2, 2, null], error: [0.5, 0.5, null, 1, 1, null] }),
    [
      [
        [0, 1.5],
        [1, 1.5],
        [1, 0.5],
        [0, 0.5],
      ],
      [
        [3, 3],
        [4, 3],
        [4, 1],
        [3, 1],
      ],
    ],
  );
  assert.deepEqual(bandOutlines({ x: [0, 1], y: [1, 1], error: null }), []);
});

test('a quantity without number has no unit', () => {
  assert.equal(withUnit(null, 'bar'), '–');
  assert.equal(withUnit(62, 'bar', 3), '62.0\u00a0bar');
});

test('a published value keeps the digits that it was published with', () => {
  assert.deepEqual(
    [asStated(1.41, ''), asStated(0.677, 'µm'), asStated(62, 'bar'), asStated(20, '°'), asStated(null, 'W')],
    ['1.41', '0.677\u00a0µm', '62\u00a0bar', '20°', '–'],
  );
});

test('changes carry their sign, no change has none', () => {
  assert.equal(percent(-0.088), '−8.8\u00a0%');
  assert.equal(percent(0.0001), '±0.0\u00a0%');
  assert.equal(percent(4.3), '+430\u00a0%');
  assert.equal(percent(12.41), '×\u00a013.4');
  assert.equal(percent(NaN), '–');
});

test('angles lie between -360 and 360 with firing TDC at 0', () => {
  assert.deepEqual([0, 20, 360, 361, 540, 719, 720, -90].map(wrapped), [0, 20, 360, -359, -180, -1, 0, -90]);
  assert.equal(angleInWords(20), '20° after firing TDC');
  assert.equal(angleInWords(719.5), '0.5° before firing TDC');
  assert.equal(angleInWords(360), 'at gas-exchange TDC');
  for (const none of [NaN, null, undefined]) assert.equal(angleInWords(none), 'at an angle not known');
});

test('display units divide by their size in SI', () => {
  const shown = (unit, displayUnit, value) => display({ unit, display_unit: displayUnit }).convert(value);
  // One division in double precision: relative error below 2.3e-16.
  const near = (a, b) => assert.ok(Math.abs(a - b) <= 4e-16 * Math.abs(b), `${a} is not ${b}`);
  near(shown('m', 'um', 6.173e-7), 0.6173);
  near(shown('Pa', 'bar', 62e5), 62);
  near(shown('kg/s', 'mg/s', 8.687e-4), 868.7);
  near(shown('1', '%', 0.561), 56.1);
  near(shown('Pa', 'kPa', 19093.66), 19.09366);
  near(shown('K', 'degC', 393.15), 120);
  near(shown('rad', 'degree', Math.PI / 3), 60);
  near(shown('kg', 'mg', 2.5e-6), 2.5);
  near(shown('m3/s', 'l/min', 1.5e-3 / 60), 1.5);
  assert.equal(shown('m', 'um', null), null);
  assert.deepEqual(
    [display({ unit: 'furlong', display_unit: 'league' }).unit, shown('furlong', 'league', 3)],
    ['furlong', 3],
  );
});

test('blow-by is read in the units of its description, and rounding is not', () => {
  const gas = {
    blow_by_per_cycle: 2.232e-6,
    blow_by_flow: 2.357e-5,
    quantities: {
      sums: [
        { name: 'blow_by_per_cycle', unit: 'kg', display_unit: 'mg' },
        { name: 'blow_by_flow', unit: 'm3/s', display_unit: 'l/min' },
      ],
    },
  };
  assert.equal(blowByWords(gas), '2.23\u00a0mg per cycle, 1.41\u00a0l/min at 1.01325 bar and 25 °C');
  const paths = [-2e-6, 3e-21].map((mass) => ({ name: 'end gap 1', mass_per_cycle: mass }));
  assert.deepEqual(
    withoutRounding(paths).map((path) => path.mass_per_cycle),
    [-2e-6, 0],
  );
});

test('all members of an integration for the error estimate are shown', () => {
  const run = { cells: 400, crank_step: 0.5, step_error: 0, solved: true };
  assert.equal(gridText(run), '400 cells at 0.500°');
  assert.equal(
    gridText({ ...run, cells_y: 90, step_error: 0.002, solved: false, reason: 'no film was found' }),
    '400 x 90 cells at 0.500°, step error 0.0020, not solved: no film was found',
  );
});

test('statements become sentences with printed units', () => {
  assert.equal(sentence('all oil is at 120 degC (at 20 degree)'), 'All oil is at 120 °C (at 20°).');
  assert.equal(sentence("E' is given."), "E' is given.");
  assert.equal(sentence('U/h up to 7.6e+06 1/s'), 'U/h up to 7.6\u202f·\u202f10⁶ 1/s.');
  assert.equal(sentence('1e-08 Pa-1'), '1\u202f·\u202f10⁻⁸ Pa⁻¹.');
  assert.equal(sentence('hash 12e5a and x2e3'), 'Hash 12e5a and x2e3.');
});

test('ticks are round and cover the range', () => {
  assert.deepEqual(ticks(0, 62, 5).values, [0, 20, 40, 60]);
  assert.deepEqual(crankTicks(-360, 360, 10).values, [-360, -270, -180, -90, 0, 90, 180, 270, 360]);
  assert.deepEqual(logTicks(0.0007, 0.3).values, [0.001, 0.01, 0.1]);
  assert.equal(tickText(-0.5, 0.5), '−0.5');
  assert.equal(tickText(20, 20), '20');
});

test('paths lose the folders of one machine and nothing is added', () => {
  assert.equal(shortPath('/home/x/ringfilm/cases/styles2014/common.toml'), 'cases/styles2014/common.toml');
  assert.equal(shortPath('/usr/share/ringfilm/data/lubricants/oil.toml'), 'data/lubricants/oil.toml');
  assert.equal(shortPath('/data/customers/secret/engine/tests/one.toml'), 'tests/one.toml');
  assert.equal(shortPath('C:\\work\\engine\\one.toml'), 'engine/one.toml');
  for (const same of ['one.toml', 'engine/one.toml', '1/3', 'x/y N']) assert.equal(shortPath(same), same);
});

test('formulas between dollar signs are printed without their commands', () => {
  assert.equal(typesetMath('warmer by $\\eta U^2/(12k)$ in the mean'), 'warmer by ηU²/(12k) in the mean');
  assert.equal(
    typesetMath('up to 3.33216 $\\eta u\\sqrt R\\,h_0^{-3/2}$, $u=U/2$: there'),
    'up to 3.33216 ηu√R\u2009h₀⁻³ᐟ², u=U/2: there',
  );
  assert.equal(typesetMath('$\\beta\\,\\eta Vab^3/h^3$ and $\\beta$'), 'β\u2009ηVab³/h³ and β');
  assert.equal(typesetMath('costs 5 $'), 'costs 5 $');
});

test('running text loses the folders of one machine', () => {
  assert.equal(
    withoutFolders('ring.bore.file: /home/x/secret/bore/shape.csv; SHA-256 12'),
    'ring.bore.file: bore/shape.csv; SHA-256 12',
  );
  assert.equal(
    withoutFolders('moments of the flat C:\\work\\maps\\flat.sur removed m0'),
    'moments of the flat maps/flat.sur removed m0',
  );
  assert.equal(withoutFolders('/usr/share/ringfilm/data/a/b.csv'), 'data/a/b.csv');
  for (const same of ['x/y N', '1/3 of it', 'maps/a.csv', 'https://example.org/a/b'])
    assert.equal(withoutFolders(same), same);
});

test('counts are reported of the whole only where it is known', () => {
  assert.deepEqual(
    [howOften(634, 720), howOften(634, null), howOften(1, null)],
    ['634 of 720 crank angles', '634 times', 'once'],
  );
});

test('an integration stops before the gap in its samples, wherever the axis begins', () => {
  const range = (from, to) => Array.from({ length: to - from }, (_, k) => from + k);
  assert.equal(stoppedAt(range(0, 30)), 29);
  // Started at 270 degree, stopped at 12: the samples are sorted from 0.
  assert.equal(stoppedAt([...range(0, 13), ...range(271, 720)]), 12);
  assert.equal(stoppedAt(range(0, 720)), null);
  assert.equal(stoppedAt([0, 20, 300, 310, 700]), null);
  assert.equal(stoppedAt([]), null);
});

test('a label keeps clear of the curves', () => {
  const flat = { x: [0, 100, 200, 300, 400], y: [50, 50, 50, 50, 50] };
  const panel = { series: [flat, { x: [300, 350, 400], y: [3, 2, 1] }] };
  // One pixel a unit, y downwards: the second curve ends where a label at the right would be.
  const box = { left: 0, top: 0, width: 400, height: 100, x: (v) => v, y: (v) => 100 - v };
  const place = freePlace(panel, () => true, 3, 60, box);
  assert.ok(place.x + 60 < 300, `label at ${place.x}`);
  assert.ok(place.y <= 97 && place.y - 11 >= 50, `base line at ${place.y}`);
});

test('a full cycle is closed at both ends', () => {
  const angles = Array.from({ length: 720 }, (_, k) => k);
  const curve = onCycleAxis(angles, angles);
  assert.deepEqual([curve.x[0], curve.y[0], curve.x.at(-1), curve.y.at(-1)], [-360, 360, 360, 360]);
  assert.ok(curve.x.every((v, k) => k === 0 || v > curve.x[k - 1]));
});

test('no line is drawn over missing samples', () => {
  const curve = onCycleAxis([0, 1, 2, 100, 101], [1, 2, 3, 4, 5]);
  assert.deepEqual(curve.y, [1, 2, 3, null, 4, 5]);
  assert.deepEqual(onCycleAxis([], []), { x: [], y: [] });
});

test('titles are distinguished by what differs', () => {
  assert.deepEqual(shortNames(['Styles et al. 2014, new ring', 'Styles et al. 2014, run-in ring']), {
    shared: 'Styles et al. 2014',
    names: ['new ring', 'run-in ring'],
  });
  assert.equal(shortNames(['same', 'same']), null);
  assert.deepEqual(shortNames(['engine A', 'boat']), { shared: '', names: ['engine A', 'boat'] });
  assert.deepEqual(shortNames(['Two rings: ring 1 (top)', 'Two rings: ring 2 (second)']), {
    shared: 'Two rings',
    names: ['ring 1 (top)', 'ring 2 (second)'],
  });
  assert.deepEqual(shortNames(['ring 1', 'ring 2']), { shared: '', names: ['ring 1', 'ring 2'] });
  assert.deepEqual(shortNames(['Low-tension set – new', 'Low-tension set – worn']), {
    shared: 'Low-tension set',
    names: ['new', 'worn'],
  });
});

test('cases of one title are named after the inputs in which they differ', () => {
  const cases = (...speeds) =>
    speeds.map((shown) => ({
      inputs: [
        { key: 'engine.bore', shown: '89 mm' },
        { key: 'operating.speed', shown },
        { key: 'output.fields', shown: `${shown}!` },
      ],
    }));
  assert.deepEqual(namesByInputs(cases('1500 rpm', '3000 rpm')), ['speed 1500 rpm', 'speed 3000 rpm']);
  assert.deepEqual(namesByInputs(cases('/home/x/y/a.csv', '/home/x/y/b.csv')), [
    'speed y/a.csv',
    'speed y/b.csv',
  ]);
  assert.deepEqual(namesByInputs(cases('1500 rpm', '1500 rpm')), ['case 1', 'case 2']);
  assert.deepEqual(namesByInputs(cases('1500 rpm', '1500 rpm', '3000 rpm')), [
    '1: speed 1500 rpm',
    '2: speed 1500 rpm',
    '3: speed 3000 rpm',
  ]);
});

test('every place belongs to the nearest node, and none outside', () => {
  const edges = cellEdges([0, 1, 4], 0, 4);
  assert.deepEqual(edges, [0, 0.5, 2.5, 4]);
  assert.deepEqual(
    [-0.1, 0, 0.49, 0.5, 2.4, 4, 4.1].map((v) => cellAt(edges, v)),
    [-1, 0, 0, 1, 1, 2, -1],
  );
});

/** A ring of 100 mm with three strips 0, 40 and L; one angle, two nodes, values 0 to 5 bar. */
function smallRing(endGap, more = {}) {
  const words = (...list) => Buffer.from(Uint16Array.from(list).buffer).toString('base64');
  const quantity = (name, displayUnit) => ({
    name,
    unit: displayUnit === 'bar' ? 'Pa' : '1',
    display_unit: displayUnit,
    long_name: name,
  });
  return new Unrolled(
    {
      circumference: 0.1,
      end_gap: endGap,
      gap_position: Math.PI / 2,
      stored: { angles: 1, y: 3, x: 2 },
      crank_angle: [20],
      x: [0, 1e-3],
      y: [0, 0.04, endGap ? 0.1 - endGap : 0.09],
      fields: {
        film_pressure: { low: 0, high: 5e5, data: words(0, 13107, 26214, 39320, 52427, 65534) },
        film_content: { low: 0.5, high: 1, data: words(65534, 65534, 0, 65534, 65535, 65534) },
      },
      highest_pressure: [{ x: 1e-3, y: 0.09, value: 5e5 }],
      lowest_film_content: [{ x: 0, y: 0.04, value: 0.5 }],
      strips: { crank_angle: [], y: [], fields: {} },
      ...more,
    },
    { fields: [quantity('film_pressure', 'bar'), quantity('film_content', '1')], strips: [] },
  );
}

test('fields around the ring come back from their words', () => {
  const ring = smallRing(0.01);
  // Half a step of 5 bar in 65534.
  [
    [0, 0, 0],
    [1, 0, 2],
    [2, 1, 5],
  ].forEach(([j, i, bar]) => assert.ok(Math.abs(ring.value('film_pressure', 0, j, i) - bar) < 5e-5));
  assert.equal(ring.value('film_content', 0, 2, 0), null);
  assert.deepEqual(
    [ring.isCavity(0, 0, 0), ring.isCavity(0, 1, 0), ring.isCavity(0, 2, 0)],
    [false, true, false],
  );
});

test('a model without a film content has cavities where the pressure is theirs', () => {
  const ring = smallRing(0.01, { rupture_pressure: 0, lowest_film_content: [{ x: 0, y: 0, value: 1 }] });
  assert.equal(ring.fields.film_content, undefined);
  assert.deepEqual([ring.isCavity(0, 0, 0), ring.hasCavity(0)], [false, false], 'edges are full');
  ring.x = [-1, ...ring.x.slice(0, 1), 1];
  ring.value = (name, k, j, i) => (j === 1 && i === 1 ? 0 : 2);
  assert.deepEqual([ring.isCavity(0, 0, 1), ring.isCavity(0, 1, 1), ring.hasCavity(0)], [false, true, true]);
  assert.match(
    fieldCaption(ring, ''),
    /where the pressure is that of a cavity; .* Reynolds' exit, does not define how much oil.*at 1 of the 1 angles/,
  );
  assert.match(fieldCaption(smallRing(0.01, { rupture_pressure: -1e5 }), ''), /No angle has a cavity/);
  assert.doesNotMatch(fieldCaption(smallRing(0.01), ''), /Reynolds/);
});

test('the gap is felt as far as pressures differ from those opposite', () => {
  // Of the strips at 0, 40 and 90 mm that in the middle has 2 and 3 bar; all three differ.
  assert.equal(smallRing(0.01).endReach(0), 0);
  const ring = smallRing(0.01);
  ring.y = [0, 20, 50];
  ring.yEdges = cellEdges(ring.y, 0, 90);
  assert.equal(ring.endReach(0), 20);
  assert.equal(smallRing(0).endReach(0), null);
});

test('the ends of the ring lie beside each other with the gap between them', () => {
  const ring = smallRing(0.01);
  const axis = ringAxis(ring, { ends: true, face: 2 });
  assert.deepEqual(
    [axis.from, axis.to, axis.pieces],
    [
      -11,
      11,
      [
        [-11, -5],
        [5, 11],
      ],
    ],
  );
  assert.deepEqual(
    [-5.5, -4, 0, 4, 5.5].map((v) => axis.index(v)),
    [2, -1, -1, -1, 0],
  );
  assert.deepEqual(
    [-11, -5, 5, 11].map((v) => Math.round(1e6 * axis.y(v)) / 1e6),
    [84, 90, 0, 6],
  );
  // The gap of 36 degree has its middle at 90 degree.
  assert.deepEqual(
    [0, 90].map((y) => Math.round(ring.around(y))),
    [108, 72],
  );
});

test('a closed ring begins again where its last strip ends', () => {
  const axis = ringAxis(smallRing(0), { ends: false, face: 2 });
  assert.deepEqual(
    [0, 19, 21, 64, 66, 94, 96, 100].map((v) => axis.index(v)),
    [0, 0, 1, 1, 2, 2, 0, 0],
  );
});

test('crank angles of the file find their place on the axis of the charts', () => {
  const axis = crankAxis([0, 180, 360, 540]);
  assert.deepEqual(
    [0, 80, 100, 180, 360, -180, -350, -260].map((v) => axis.index(v)),
    [0, 0, 1, 1, 2, 3, 2, 3],
  );
  const few = crankAxis([0, 10]);
  assert.deepEqual(
    [-6, -4, 4, 6, 14, 16].map((v) => few.index(v)),
    [-1, 0, 0, 1, 1, -1],
  );
});

test('one crank angle alone has a place of some degrees', () => {
  const one = crankAxis([20]);
  assert.deepEqual(
    [17, 18, 20, 22, 23].map((v) => one.index(v)),
    [-1, 0, 0, 0, -1],
  );
  assert.deepEqual(
    [-342, -340, -338, 20].map((v) => crankAxis([380]).index(v)),
    [0, 0, 0, -1],
  );
});

test('maps over the crank angle name strokes and dead centres, other maps do not', () => {
  const named = ['intake', 'compression', 'power', 'exhaust', 'firing TDC', 'BDC'];
  const words = (maps) => maps.draw(900, false).shapes.join('');
  const ring = smallRing(0.01);
  ring.strips = { strip_hydrodynamic_load: { longName: 'load', unit: 'N/mm', range: [0, 1] } };
  ring.stripAngles = [20];
  const over = words(stripMaps(ring, { ends: false, face: 2 }));
  for (const name of named) assert.ok(over.includes(`>${name}</text>`), name);
  const along = words(fieldMaps(ring, 0, { ends: false, own: false }));
  for (const name of named) assert.ok(!along.includes(`>${name}</text>`), name);
});

const series = (label, x, y) => ({ caseIndex: 0, part: null, label, x, y });
const figure = (list) => ({
  id: 'f',
  title: 'a < b',
  panels: [{ id: 'p', yLabel: 'film', yUnit: 'µm', xLabel: 'x', xUnit: 'mm', series: list }],
});

test('a CSV has one x column where all curves share it, else a pair a curve', () => {
  assert.equal(
    figureCsv(figure([series('a', [0, 1], [2, null]), series('b', [0, 1], [3, 4])])),
    '"x [mm]","a: film [µm]","b: film [µm]"\r\n0,2,3\r\n1,,4\r\n',
  );
  assert.equal(
    figureCsv(figure([series('a', [0], [2]), series('b', [5, 6], [3, 4])])),
    '"a: x [mm]","a: film [µm]","b: x [mm]","b: film [µm]"\r\n0,2,5,3\r\n,,6,4\r\n',
  );
});

test('a spreadsheet takes no case name for a formula', () => {
  assert.match(figureCsv(figure([series('=1+1', [0], [2]), series('b', [1], [2])])), /"'=1\+1: x \[mm\]"/);
});

test('file names hold letters, digits and dashes only', () => {
  assert.equal(fileStem('Styles et al. 2014/../<x>', 'stribeck'), 'styles-et-al-2014-x-stribeck');
  assert.equal(fileStem('§', 'f'), 'f');
});

test('a drawing escapes texts and survives curves without a number', () => {
  const svg = figureSvg(figure([series('<script>', [0, 1], [null, null])]), () => true);
  assert.ok(svg.includes('a &lt; b') && svg.includes('&lt;script&gt;') && !svg.includes('<script>'));
  assert.ok(!svg.includes('NaN') && !svg.includes('Infinity'));
});
