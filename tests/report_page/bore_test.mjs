// The drawing of the ring in its bore, without a browser: node bore_test.mjs PAGE_FOLDER
import assert from 'node:assert/strict';
import test from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const { boreDrawing, enlargement, hasBore } = await import(
  pathToFileURL(join(process.argv[2], 'src', 'cycle/bore_drawing.js')).href
);
const { boreFigure } = await import(
  pathToFileURL(join(process.argv[2], 'src', 'measurement/bore_figure.js')).href
);

// A bore of order 2, 10 um; the ring 2 um away from it, lifted off on the first quarter.
const kStrips = 90;
const circumference = 280;
const y = Array.from({ length: kStrips }, (_, j) => ((j + 0.5) * circumference) / kStrips);
const around = (at) => (360 * at) / circumference;
const fields = {
  strip_bore_deviation: (k, j) => 10 * Math.cos((2 * Math.PI * around(y[j])) / 180),
  strip_min_film_thickness: () => 2,
  strip_lifted_off: (k, j) => (k === 0 && around(y[j]) < 90 ? 1 : 0),
  strip_hydrodynamic_load: () => 3,
};
const ranges = {
  strip_bore_deviation: [-10, 10],
  strip_min_film_thickness: [2, 2],
  strip_lifted_off: [0, 1],
  strip_hydrodynamic_load: [3, 3],
};
const data = {
  y,
  circumference,
  length: circumference,
  closed: true,
  gapPosition: 0,
  stripAngles: [0, 10],
  strips: Object.fromEntries(Object.entries(ranges).map(([name, range]) => [name, { range, unit: 'µm' }])),
  stripValue: (name, k, j) => fields[name]?.(k, j) ?? null,
  around,
};

const kPath = /<path d="([^"]*)" fill="none" stroke="(#[0-9a-f]*)"/g;
const paths = (svg, colour) =>
  [...svg.matchAll(kPath)]
    .filter((found) => found[2] === colour)
    .map((found) =>
      [...found[1].matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, a, b]) => [Number(a), Number(b)]),
    );

const boreSvg = (k, width) => boreDrawing(data, k, width).shapes.join('');

test('bore and ring are apart by the clearance on the scale that is stated', () => {
  const svg = boreSvg(1, 420);
  const [bore] = paths(svg, '#8a93a0');
  const ring = paths(svg, '#003f7d').find((points) => points.length === kStrips);
  const circle = svg
    .match(/<circle cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)"/)
    .slice(1)
    .map(Number);
  const far = ([a, b]) => Math.hypot(a - circle[0], b - circle[1]);
  const pixelsPerMicrometre = (Math.max(...bore.map(far)) - Math.min(...bore.map(far))) / 20;
  ring.forEach((point, j) => {
    assert.ok(Math.abs(far(bore[j]) - far(point) - 2 * pixelsPerMicrometre) < 0.03, String(j));
  });
  const boreRadius = (1e3 * circumference) / (2 * Math.PI);
  assert.ok(Math.abs(enlargement(data) / ((pixelsPerMicrometre * boreRadius) / circle[2]) - 1) < 0.01);
  // The bar is as long as it states.
  const length = Number(svg.match(/>([\d.]+) µm</)[1]);
  const bar = svg.match(/<(?:line|path)[^>]*stroke="#30343b"[^>]*stroke-width="1.6"[^>]*>/g);
  assert.ok(length > 0 && bar.length === 3, String(bar));
});

test('what is lifted off is marked, and only that', () => {
  assert.equal(paths(boreSvg(1, 420), '#d1490a').length, 0);
  const [part, ...others] = paths(boreSvg(0, 420), '#d1490a');
  assert.equal(others.length, 0);
  assert.equal(part.length, y.filter((at) => around(at) < 90).length);
});

test('a round bore is not drawn', () => {
  const round = { ...data, strips: { ...data.strips, strip_bore_deviation: { range: [0, 0], unit: 'µm' } } };
  assert.ok(hasBore(data));
  assert.ok(!hasBore(round));
  assert.ok(!hasBore({ ...data, strips: {} }));
});

test('a static closure is drawn with what of the ring is apart from the bore', () => {
  const x = Array.from({ length: 361 }, (_, j) => j);
  const bore = x.map((angle) => 8 * Math.cos((4 * Math.PI * angle) / 180));
  const ring = bore.map((deviation, j) => deviation - (j > 100 && j < 140 ? 1.5 : 0));
  const shape = {
    name: 'bore_around',
    series: [
      { x, y: bore },
      { x, y: ring },
    ],
  };
  const figure = boreFigure({ curves: [{ name: 'clearance_around', series: [] }, shape] });
  const { shapes } = figure.draw(420);
  const [part, ...others] = paths(shapes.join(''), '#d1490a');
  assert.equal(others.length, 0);
  assert.equal(part.length, 39);
  assert.match(figure.caption(), /by up to 1\.5\d* µm/);
  assert.deepEqual(figure.columns()[3].values.slice(100, 102), [0, 1.5]);
  assert.equal(boreFigure({ curves: [] }), null);
  const round = x.map(() => 0);
  assert.equal(
    boreFigure({
      curves: [
        {
          ...shape,
          series: [
            { x, y: round },
            { x, y: round },
          ],
        },
      ],
    }),
    null,
  );
});
