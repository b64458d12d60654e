// The ring in its bore at one crank angle: bore and ring as a polar drawing, and what the ring carries around it.
import { frame } from '../plot/plot_frame.js';
import { key, kShown, polarBore } from '../plot/polar_bore.js';
import { line } from '../plot/svg_shapes.js';

const kFilm = '#003f7d';
const kAsperities = '#d1490a';
const kFriction = '#159a7a';
const kThickness = '#a04fa0';
/** The ends of the ring, of its length on either side: what they carry is beyond the scale. */
const kEnds = 0.04;
const kPanel = 178;
const kFullTurn = 2 * Math.PI;
const kMicrometresPerMillimetre = 1000;
/** Half of what the page may have lost by rounding. */
const kIsLifted = 0.5;

/** Is there a bore that is not round to draw? */
export function hasBore(data) {
  const bore = data.strips.strip_bore_deviation;
  return Boolean(bore && data.strips.strip_min_film_thickness && bore.range[1] > bore.range[0]);
}

/** The deviation that the drawing has to show at most, the same at all angles [um]. */
function largestDeviation(data) {
  const bore = data.strips.strip_bore_deviation.range;
  const clearance = data.strips.strip_min_film_thickness.range;
  return Math.max(Math.abs(bore[0]), Math.abs(bore[1]), Math.abs(bore[0] - clearance[1]));
}

/** By how much the drawing enlarges deviations over the bore itself. */
export function enlargement(data) {
  const boreRadius = (kMicrometresPerMillimetre * data.circumference) / kFullTurn; // [um]
  return (kShown * boreRadius) / largestDeviation(data);
}

/** Bore and ring; angles grow counterclockwise from the right, where 0° around the bore is. */
function polar(data, k, width) {
  const strips = data.y.map((_, j) => j);
  return polarBore(
    {
      turns: strips.map((j) => data.around(data.y[j])),
      bore: strips.map((j) => data.stripValue('strip_bore_deviation', k, j)),
      clearance: strips.map((j) => data.stripValue('strip_min_film_thickness', k, j)),
      isApart: strips.map((j) => (data.stripValue('strip_lifted_off', k, j) ?? 0) > kIsLifted),
      apart: 'lifted off',
      most: largestDeviation(data),
      gap: data.closed ? null : data.gapPosition,
    },
    width,
  );
}

const kAround = { low: 0, high: 360, label: 'around the bore', unit: '°' };

/** The highest value of the cycle, the ends of the ring excepted. */
function highest(data, name) {
  const isEnd = data.y.map((y) => Math.min(y, data.length - y) < kEnds * data.length && !data.closed);
  let most = 0;
  data.stripAngles.forEach((_, k) =>
    isEnd.forEach((end, j) => {
      if (!end) most = Math.max(most, data.stripValue(name, k, j) ?? 0);
    }),
  );
  return most;
}

/** One panel over the angle around the bore, of strips in the order of that angle. */
function panel(data, k, box, label, curves) {
  const order = data.y.map((_, j) => j).sort((a, b) => data.around(data.y[a]) - data.around(data.y[b]));
  const high = 1.1 * Math.max(...curves.map(({ name }) => highest(data, name))) || 1;
  const axes = frame(box, kAround, { low: 0, high, label, unit: data.strips[curves[0].name].unit });
  const height = (name, j) => axes.y(Math.min(data.stripValue(name, k, j) ?? 0, high));
  const drawn = curves.map(({ name, colour }) =>
    line(
      order.map((j) => [axes.x(data.around(data.y[j])), height(name, j)]),
      colour,
    ),
  );
  const names = curves.length > 1 ? key(curves, axes.plot.right - 170, axes.plot.top - 8) : [];
  return [...axes.shapes, ...drawn, ...axes.edges, ...names];
}

/** What is drawn over the angle around the bore, of what the page has. */
function panels(data) {
  const all = [
    [
      'film thickness',
      [{ name: 'strip_min_film_thickness', words: 'smallest across the face', colour: kThickness }],
    ],
    [
      'load',
      [
        { name: 'strip_hydrodynamic_load', words: 'film', colour: kFilm },
        { name: 'strip_asperity_load', words: 'asperities', colour: kAsperities },
      ],
    ],
    ['friction', [{ name: 'strip_total_friction', words: 'total', colour: kFriction }]],
  ];
  return all
    .map(([label, curves]) => [label, curves.filter(({ name }) => data.strips[name])])
    .filter(([, curves]) => curves.length);
}

/** The whole drawing at a crank angle. @param k number of the angle */
export function boreDrawing(data, k, width) {
  const isWide = width >= 760;
  const left = isWide ? Math.min(460, width / 2) : width;
  const drawing = polar(data, k, left);
  const at = isWide ? { x: left, y: 0, width: width - left } : { x: 0, y: drawing.height + 6, width };
  const shapes = [...drawing.shapes];
  let bottom = at.y;
  for (const [label, curves] of panels(data)) {
    shapes.push(...panel(data, k, { ...at, y: bottom, height: kPanel }, label, curves));
    bottom += kPanel + 6;
  }
  return { shapes, height: Math.max(drawing.height, bottom) };
}
