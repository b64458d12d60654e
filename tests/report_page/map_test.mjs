// Steps of colour of a map next to the numerical error, without a browser
// usage: node map_test.mjs SOURCE_FOLDER_OF_THE_PAGE
import assert from 'node:assert/strict';
import test from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const load = (name) => import(pathToFileURL(join(process.argv[2], 'src', name)).href);
const { MapChoice, mapFigure } = await load('study/study_map.js');
const { StudyModel } = await load('study/study_model.js');
const { differenceOf } = await load('study/study_compare.js');

/** A map of 2 x 2 scenarios from a low to a high value [kPa]. */
function drawn(low, high, error) {
  const factor = (name) => ({ name, unit: '1', display_unit: '1', choices: [], logarithmic: false });
  const axis = (k) => ({ factor: k, levels: [1, 2], of: 2 });
  const model = new StudyModel({
    quantities: [{ name: 'fmep', unit: 'Pa', display_unit: 'kPa', long_name: 'FMEP' }],
    page_quantities: [],
    main_values: ['fmep'],
    factors: [factor('speed'), factor('load')],
    bases: [{ name: 'base' }],
    unsolved: { count: 0 },
    error: error === null ? null : { quantiles: { fmep: error } },
    usual_accuracy: 0.005,
    grid: {
      quantities: ['fmep'],
      bases: [{ axes: [axis(0), axis(1)], values: { fmep: [low, high, low, high].map((v) => 1e3 * v) } }],
    },
  });
  const figure = mapFigure(model, model.quantity.get('fmep'), new MapChoice(model));
  const colours = new Set(
    figure
      .draw(600)
      .shapes.join('')
      .match(/class="band" d="[^"]*" fill="[^"]*"/g)
      .map((band) => /fill="([^"]*)"/.exec(band)[1]),
  );
  return { colours: colours.size, caption: figure.caption() };
}

test('differences below the numerical error are one colour', () => {
  for (const error of [null, 0.001, 0.02]) {
    const { colours, caption } = drawn(6.841, 6.842, error);
    assert.equal(colours, 1);
    assert.match(caption, /hardly varies, by 1\.0\u202f·\u202f10⁻³ kPa, less than its numerical error of/);
  }
});

test('steps of colour are no finer than the numerical error', () => {
  // 0.1 kPa of 7 kPa: without an estimate 0.035 kPa are distinguished, with one of 0.02 % all steps.
  assert.ok(drawn(6.9, 7, null).colours <= 3);
  assert.ok(drawn(6.9, 7, 0.0002).colours > 5);
  assert.ok(drawn(1, 7, null).colours > 5);
});

test('a base of which an operating point was not solved has no difference to another one', () => {
  const compared = (mean) => ({
    has_sample: false,
    comparison: { fmep: [{ weighted_mean: 10 }, { weighted_mean: mean }] },
  });
  assert.equal(differenceOf(compared(null), { name: 'fmep' }, 1), null);
  assert.match(differenceOf(compared(11), { name: 'fmep' }, 1).text, /10/);
});
