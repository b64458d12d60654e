// The figures of the contact law, without a browser: node contact_test.mjs PAGE_FOLDER
import assert from 'node:assert/strict';
import test from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const { contactPressureFigure, flowFactorFigure, realAreaFigure } = await import(
  pathToFileURL(join(process.argv[2], 'src', 'cycle/contact_figures.js')).href
);

const law = (label, pressure, deviation) => ({
  name: label,
  label,
  pressure,
  log_deviation: pressure.map(() => deviation),
});
const contact = (laws, flow = []) => ({
  separation: [0, 1e-6, 2e-6],
  laws,
  real_area: [0.2, 0.01, null],
  phi_x: flow,
  phi_y: flow,
  phi_s: [],
});
const page = (...contacts) => ({
  several: contacts.length > 1,
  cases: contacts.map((one, index) => ({
    name: `case ${index + 1}`,
    series: contacts.length > 1 ? index : -1,
    contact: one,
  })),
});

test('of one case all laws are drawn, each with the band of what was measured', () => {
  const model = page(contact([law('own', [1e9, 1e7, 1], Math.log(2)), law('other', [2e9, 2e7, 0], null)]));
  const { panels, caption } = contactPressureFigure(model);
  const [own, other] = panels[0].series;
  assert.deepEqual(own.x, [0, 1, 2]);
  assert.deepEqual(own.y, [1000, 10, null]);
  const [{ low, high }] = own.bands;
  [500, 5].forEach((v, k) => assert.ok(Math.abs(low[k] / v - 1) < 1e-12));
  [2000, 20].forEach((v, k) => assert.ok(Math.abs(high[k] / v - 1) < 1e-12));
  assert.equal(low[2], null);
  assert.equal(other.bands, undefined);
  assert.notEqual(own.caseIndex, other.caseIndex);
  assert.equal(panels[0].yScale, 'log');
  assert.match(caption, /one standard deviation/);
});

test('of several cases the law of each is drawn, in the colour of the case', () => {
  const one = () => contact([law('own', [1e9, 1e7, 1e5], null), law('other', [2e9, 2e7, 2e5], null)]);
  const { panels, caption } = contactPressureFigure(page(one(), one()));
  assert.deepEqual(
    panels[0].series.map((s) => [s.caseIndex, s.label]),
    [
      [0, 'case 1'],
      [1, 'case 2'],
    ],
  );
  assert.match(caption, /no scatter/);
});

test('the real area is a share in percent', () => {
  const [series] = realAreaFigure(page(contact([law('own', [1, 1, 1], null)]))).panels[0].series;
  assert.deepEqual(series.y, [20, 1, null]);
});

test('smooth walls have no flow factors', () => {
  const own = [law('own', [1, 1, 1], null)];
  assert.equal(flowFactorFigure(page(contact(own))), null);
  const { series } = flowFactorFigure(page(contact(own, [0.2, 0.5, 0.8]))).panels[0];
  assert.deepEqual(
    series.map((s) => s.part),
    [null, 'across'],
  );
});

test('without contact nothing is drawn', () => {
  for (const figure of [contactPressureFigure, realAreaFigure, flowFactorFigure]) {
    assert.equal(figure(page(null)), null);
  }
});
