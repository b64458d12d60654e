// Steps of colour of a map next to the numerical error, without a browser
// usage: node map_test.mjs SOURCE_FOLDER_OF_THE_PAGE
import assert from 'node:assert/strict';
import test from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const load = (name) => import(pathToFileURL(join(process.argv[2], 'src', name)).href);
const { MapChoice, mapFigure } = await load('study/study_map.js');
const { lowestFigure } = await load('study/study_lowest.js');
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

/** A map of 2 x 2 scenarios for each oil of a list of values. */
function comparedOils(values) {
  const factor = (name, choices = []) => ({
    name,
    unit: '1',
    display_unit: '1',
    choices,
    logarithmic: false,
  });
  const axis = (k, levels) => ({ factor: k, levels, of: levels.length });
  const model = new StudyModel({
    quantities: [{ name: 'fmep', unit: 'Pa', display_unit: 'kPa', long_name: 'FMEP' }],
    page_quantities: [],
    main_values: ['fmep'],
    factors: [factor('speed'), factor('temperature'), factor('oil', ['oils/thin.toml', 'oils/thick.toml'])],
    bases: [{ name: 'base' }],
    unsolved: { count: 0 },
    error: null,
    usual_accuracy: 0.005,
    grid: {
      quantities: ['fmep'],
      bases: [{ axes: [axis(0, [1, 2]), axis(1, [1, 2]), axis(2, [0, 1])], values: { fmep: values } }],
    },
  });
  const figure = lowestFigure(model, model.quantity.get('fmep'), new MapChoice(model));
  const shapes = figure.draw(600).shapes.join('');
  return { caption: figure.caption(), regions: shapes.match(/class="lowest"/g)?.length ?? 0, figure };
}

test('the choice with the lowest value has a region, with its share and lead in the caption', () => {
  const { caption, regions, figure } = comparedOils([5000, 6000, 5000, 6000, 5000, 4000, 5000, 4000]);
  assert.equal(figure.title, 'oil with the lowest FMEP');
  assert.equal(regions, 2);
  assert.match(caption, /thin at 2 of 4, by up to 17 %; thick at 2 of 4, by up to 20 %/);
  assert.match(caption, /Nothing but speed, temperature, oil varies\./);
});

test('scenarios that one choice did not solve have no lowest', () => {
  const { caption, regions } = comparedOils([5000, null, 5000, 6000, 5000, 4000, 5000, 4000]);
  assert.equal(regions, 0);
  assert.match(caption, /thin at 1 of 3/);
});
