// The ring in its bore at one crank angle: bore and ring as a polar drawing, and what the ring carries around it.
import { document, frame, line } from '../plot/plot_frame.js';
import { kFaint, kInk, px, rule, text } from '../plot/svg_shapes.js';
import { number } from '../units.js';

const kBore = '#8a93a0';
const kRing = '#003f7d';
const kOpen = '#d1490a';
const kFilm = '#003f7d';
const kAsperities = '#d1490a';
const kFriction = '#159a7a';
const kThickness = '#a04fa0';
/** The ends of the ring, of its length on either side: what they carry is beyond the scale. */
const kEnds = 0.04;
const kPanel = 178;
/** Largest deviation of the bore in the drawing, of its radius. */
const kShown = 0.22;
const kFullTurn = 2 * Math.PI;
/** Half of what the page may have lost by rounding. */
const kIsLifted = 0.5;

/** Is there a bore that is not round to draw? */
export function hasBore(data) {
  const bore = data.strips.strip_bore_deviation;
  return Boolean(bore && data.strips.strip_min_film_thickness && bore.range[1] > bore.range[0]);
}

/** Drawing units per micrometre, the same at all angles: deviations and clearances fit into a share of the radius. */
function magnification(data, radius) {
  const bore = data.strips.strip_bore_deviation.range;
  const clearance = data.strips.strip_min_film_thickness.range;
  const most = Math.max(Math.abs(bore[0]), Math.abs(bore[1]), Math.abs(bore[0] - clearance[1]));
  return (kShown * radius) / most;
}

/** By how much the drawing enlarges deviations over the bore itself. */
export function enlargement(data) {
  const boreRadius = (data.circumference * 1e3) / kFullTurn; // [um]
  return magnification(data, 1) * boreRadius;
}

/** A length that is easy to read, below so many micrometres. */
function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((n) => n * power).find((length) => length <= most) ?? power;
}

/** Bore and ring; angles grow counterclockwise from the right, where 0° around the bore is. */
function polar(data, k, width) {
  const size = Math.min(width, 430);
  const radius = size / 2 / (1 + kShown) - 26;
  const centre = { x: width / 2, y: radius * (1 + kShown) + 30 };
  const scale = magnification(data, radius);
  const bore = (j) => data.stripValue('strip_bore_deviation', k, j);
  const clearance = (j) => data.stripValue('strip_min_film_thickness', k, j);
  const at = (j, deviation) => {
    const turn = (data.around(data.y[j]) * Math.PI) / 180;
    const r = radius + scale * deviation;
    return [centre.x + r * Math.cos(turn), centre.y - r * Math.sin(turn)];
  };
  const strips = data.y.map((_, j) => j);
  const boreLine = strips.map((j) => at(j, bore(j)));
  const ringLine = strips.map((j) => at(j, bore(j) - clearance(j)));
  const lifted = strips.map((j) => (data.stripValue('strip_lifted_off', k, j) ?? 0) > kIsLifted);
  const path = (points) => points.map(([x, y], n) => `${n ? 'L' : 'M'}${px(x)} ${px(y)}`).join('');
  const between = `${path(boreLine)}${path([...ringLine].reverse()).replace('M', 'L')}Z`;
  // The bore continues across the gap of the ring.
  const closedBore = [...boreLine, boreLine[0]];
  const shapes = [
    `<circle cx="${px(centre.x)}" cy="${px(centre.y)}" r="${px(radius)}" fill="none" stroke="#d5d9df" ` +
      `stroke-dasharray="4 4"/>`,
    `<path d="${between}" fill="#f6d9c8" stroke="none"/>`,
    line(closedBore, kBore, { width: 1.6 }),
    line(ringLine, kRing, { width: 2.2 }),
  ];
  let part = [];
  strips.forEach((j) => {
    if (lifted[j]) part.push(ringLine[j]);
    if (part.length && (!lifted[j] || j + 1 === strips.length)) {
      if (part.length === 1) part.push([part[0][0] + 0.5, part[0][1]]);
      shapes.push(line(part, kOpen, { width: 4 }));
      part = [];
    }
  });
  for (const degrees of [0, 90, 180, 270]) {
    const turn = (degrees * Math.PI) / 180;
    const [c, s] = [Math.cos(turn), -Math.sin(turn)];
    const out = radius * (1 + kShown) + 10;
    shapes.push(
      text(centre.x + out * c, centre.y + out * s + 4, `${degrees}°`, { anchor: 'middle', fill: kFaint }),
    );
  }
  if (!data.closed) {
    const turn = (data.gapPosition * Math.PI) / 180;
    const inside = radius * (1 - kShown) - 14;
    shapes.push(
      text(centre.x + inside * Math.cos(turn), centre.y - inside * Math.sin(turn) + 4, 'gap', {
        anchor: 'middle',
        fill: kFaint,
      }),
    );
  }
  const length = roundLength((0.5 * radius) / scale);
  const bar = { y: centre.y + 8, half: (scale * length) / 2 };
  const widest = Math.max(...strips.map((j) => clearance(j)));
  shapes.push(
    rule(centre.x - bar.half, bar.y, centre.x + bar.half, bar.y, kInk, 1.6),
    rule(centre.x - bar.half, bar.y - 4, centre.x - bar.half, bar.y + 4, kInk, 1.6),
    rule(centre.x + bar.half, bar.y - 4, centre.x + bar.half, bar.y + 4, kInk, 1.6),
    text(centre.x, bar.y - 9, `${number(length, 3)} µm`, { anchor: 'middle' }),
    text(centre.x, bar.y + 22, `largest clearance ${number(widest, 3)} µm`, { anchor: 'middle', size: 11 }),
  );
  const words = [
    { words: 'bore', colour: kBore },
    { words: 'ring', colour: kRing },
    { words: 'lifted off', colour: kOpen },
  ];
  const top = centre.y + radius * (1 + kShown) + 42;
  shapes.push(...key(words, centre.x - 105, top));
  return { shapes, height: top + 16 };
}

/** Lines and their names in a row. */
function key(entries, left, top) {
  return entries.flatMap(({ words, colour }, n) => [
    rule(left + 76 * n, top - 4, left + 76 * n + 18, top - 4, colour, 2.4),
    text(left + 76 * n + 23, top, words, { size: 11 }),
  ]);
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

/** The whole drawing at a crank angle as an SVG document. @param k number of the angle */
export function boreSvg(data, k, width, { title = '', subtitle = '' } = {}) {
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
  return document({ shapes, height: Math.max(drawing.height, bottom) }, width, { title, subtitle });
}
