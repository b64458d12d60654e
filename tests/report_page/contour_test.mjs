// Contours of maps, without a browser: node contour_test.mjs PAGE_FOLDER
import assert from 'node:assert/strict';
import test from 'node:test';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const { contourLines, filledBands, labelPlace, lowestRegions } = await import(
  pathToFileURL(join(process.argv[2], 'src', 'plot/contour.js')).href
);

const xs = [0, 10, 40, 50, 100];
const ys = [0, 30, 35, 60];
const plane = (i, j) => xs[i] + 2 * ys[j];
const area = (polygon) =>
  Math.abs(
    polygon.reduce((sum, p, k) => {
      const q = polygon[(k + 1) % polygon.length];
      return sum + p.x * q.y - q.x * p.y;
    }, 0),
  ) / 2;
const sum = (polygons) => polygons.reduce((total, p) => total + area(p), 0);

test('bands cover every cell once, and each holds its own values', () => {
  const levels = [40, 80, 150];
  const bands = filledBands(xs, ys, plane, levels);
  assert.equal(bands.length, 4);
  assert.ok(Math.abs(bands.reduce((total, polygons) => total + sum(polygons), 0) - 100 * 60) < 1e-9);
  // Below x + 2y = 40 there is a triangle of 40 by 20.
  assert.ok(Math.abs(sum(bands[0]) - 400) < 1e-9, String(sum(bands[0])));
  bands.forEach((polygons, k) =>
    polygons.flat().forEach(({ x, y }) => {
      const v = x + 2 * y;
      assert.ok(v >= (levels[k - 1] ?? -Infinity) - 1e-9 && v <= (levels[k] ?? Infinity) + 1e-9);
    }),
  );
});

test('the line of a plane is one straight line from edge to edge', () => {
  const lines = contourLines(xs, ys, plane, 80);
  assert.equal(lines.length, 1);
  lines[0].forEach(([x, y]) => assert.ok(Math.abs(x + 2 * y - 80) < 1e-9));
  assert.deepEqual(
    [lines[0][0], lines[0][lines[0].length - 1]].map(([x]) => Math.round(x)).sort((a, b) => a - b),
    [0, 80],
  );
});

test('a hill has a closed line, and a hole is neither filled nor crossed', () => {
  const side = [0, 1, 2, 3, 4, 5, 6];
  const hill = (i, j) => 10 - (i - 3) ** 2 - (j - 3) ** 2;
  const [ring, ...others] = contourLines(side, side, hill, 6);
  assert.equal(others.length, 0);
  assert.deepEqual(
    ring[0].map((v) => v.toFixed(9)),
    ring[ring.length - 1].map((v) => v.toFixed(9)),
  );
  const hole = (i, j) => (i === 3 && j === 3 ? null : hill(i, j));
  assert.ok(
    Math.abs(
      filledBands(side, side, hole, []).reduce((total, polygons) => total + sum(polygons), 0) - (36 - 4),
    ) < 1e-9,
  );
});

test('a label lies on its line, upright, and not on a short one', () => {
  const place = labelPlace(
    [
      [0, 0],
      [50, 0],
      [100, 0],
    ],
    30,
  );
  assert.equal(place.y, 0);
  assert.ok(place.angle >= -90 && place.angle <= 90);
  assert.equal(
    labelPlace(
      [
        [0, 0],
        [10, 0],
      ],
      30,
    ),
    null,
  );
});

test('regions of the lowest value cover every cell once, and meet where two values are equal', () => {
  // x, 30 and 130 - x over the width of 100: lowest from 0 to 30, then 30, then 130 - x never below 30.
  const values = [(i) => xs[i], () => 30, (i) => 130 - xs[i]];
  const { regions, borders } = lowestRegions(xs, ys, values);
  assert.ok(Math.abs(sum(regions[0]) - 30 * 60) < 1e-9, String(sum(regions[0])));
  assert.ok(Math.abs(sum(regions[1]) - 70 * 60) < 1e-9, String(sum(regions[1])));
  assert.equal(sum(regions[2]), 0);
  assert.ok(borders.length > 0);
  const inside = borders.filter(([a, b]) => a.x < 99 && b.x < 99);
  for (const [a, b] of inside) assert.ok(Math.abs(a.x - 30) < 1e-9 && Math.abs(b.x - 30) < 1e-9);
});

test('a cell next to a missing value has no region', () => {
  const { regions } = lowestRegions(xs, ys, [(i, j) => (i === 1 && j === 1 ? null : xs[i]), () => 200]);
  // Of 100 by 60 the four cells around that node are left out, 40 by 35.
  assert.ok(Math.abs(sum(regions[0]) - (100 * 60 - 40 * 35)) < 1e-9, String(sum(regions[0])));
});
