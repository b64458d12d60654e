// Ring, groove, liner and pressures, drawn from the numbers of the case where the gas pressure peaks; under a constant
// pressure where the film is thinnest.
import { element, svgElement } from '../dom.js';
import { caseColour } from '../plot/palette.js';
import { area, kFaint, kInk, line, px, rectangle, rule, svgDocument, text } from '../plot/svg_shapes.js';
import { angleInWords, converted, nearestAngle, number, wrapped } from '../units.js';

const kWidth = 470;
const kHeight = 300;
/** The face lies between these heights, the chamber above [pixel]. */
const kFace = { top: 76, bottom: 226 };
/** The running surface of the liner, and how far the widest gap reaches from it [pixel]. */
const kLiner = 268;
const kWidestGap = 72;
/** Groove bottom, and how far the highest pressure reaches into the liner [pixel]. */
const kGroove = 62;
const kPressureRoom = 118;
/** Piston lands end this far from the liner: not to scale [pixel]. */
const kLand = 28;

const kPiston = '#c9ced6';
const kRing = '#e9ecf0';
const kOil = '#e8b64c';
const kGas = '#f7d9d0';
const kBelow = '#dbe8f4';
const kWall = '#dfe2e7';

/** Index of the stored fields within a degree of an angle, -1 without them. */
function fieldsAt(c, angle) {
  const k = nearestAngle(c.fields.crank_angle, angle);
  return k >= 0 && Math.abs(wrapped(c.fields.crank_angle[k] - angle)) <= 1 ? k : -1;
}

/**
 * What is drawn at a crank angle, in SI: gap along the face, pressures about the ring and along the face. Null where
 * a case has no face or no curves.
 */
export function sectionState(c, angle) {
  const { x, face_height: height } = c.fields;
  if (x.length < 2 || height.length !== x.length || c.curves.crank_angle.length === 0) return null;
  const sample = nearestAngle(c.curves.crank_angle, angle);
  const at = (name) => c.curves[name]?.[sample] ?? null;
  const film = at('min_film_thickness') ?? 0;
  const k = fieldsAt(c, angle);
  const lowest = Math.min(...height);
  return {
    angle,
    film,
    x,
    gap: height.map((v) => v - lowest + film),
    above: at('gas_pressure'),
    below: at('crankcase_pressure'),
    wetted: [at('wetted_begin') ?? x[0], at('wetted_end') ?? x[x.length - 1]],
    tension: c.derived.elastic_pressure ?? null,
    share: c.inputs.find((entry) => entry.key === 'gas.pressure_behind_ring')?.value_si ?? 1,
    filmPressure: k >= 0 ? (c.fields.film_pressure[k] ?? null) : null,
    asperityPressure: k >= 0 ? (c.fields.asperity_pressure[k] ?? null) : null,
  };
}

/** How many times wider across the gap than along the face the drawing is. */
export function exaggeration(state) {
  const along = (kFace.bottom - kFace.top) / (state.x[state.x.length - 1] - state.x[0]);
  return kWidestGap / Math.max(...state.gap) / along;
}

const bar = (pressure) => `${number(converted(pressure, 'bar'), 3)}\u00a0bar`;

const box = (x, y, width, height, fill) => rectangle(x, y, width, height, `fill="${fill}"`);

/** An arrow from one point to another, both on a level. */
function arrow(from, to, y, stroke) {
  const head = to > from ? -6 : 6;
  return (
    rule(from, y, to, y, stroke, 1.3) + `<path d="M${px(to)} ${px(y)}l${head} -3.5v7Z" fill="${stroke}"/>`
  );
}

/** What fills the gap along a part of the face. */
function fluid(edge, state, [from, to], fill) {
  const part = edge.filter((_, i) => state.x[i] >= from && state.x[i] <= to);
  if (part.length < 2) return '';
  return area([...part, [kLiner, part[part.length - 1][1]], [kLiner, part[0][1]]], fill, 0.85);
}

function solids(edge, state) {
  const clearance = 7;
  const { top, bottom } = kFace;
  const land = kLiner - kLand;
  return [
    box(0, 0, kLiner, top, kGas),
    box(kGroove, top - clearance, 60, bottom - top + clearance, kGas),
    box(0, bottom, kLiner, kHeight - bottom, kBelow),
    box(0, 30, land, top - clearance - 30, kPiston),
    box(0, bottom, land, kHeight - 40 - bottom, kPiston),
    box(0, top - clearance - 1, kGroove, bottom - top + clearance + 2, kPiston),
    box(kLiner, 0, kWidth - kLiner, kHeight, kWall),
    fluid(edge, state, [state.x[0], state.wetted[0]], kGas),
    fluid(edge, state, state.wetted, kOil),
    fluid(edge, state, [state.wetted[1], state.x[state.x.length - 1]], kBelow),
    area([[kGroove + 34, top], ...edge, [kGroove + 34, bottom]], kRing, 1),
    line([[kGroove + 34, top], ...edge, [kGroove + 34, bottom], [kGroove + 34, top]], kInk, { width: 1.4 }),
    rule(kLiner, 0, kLiner, kHeight, kInk, 1.4),
  ];
}

/** Pressures of oil and asperities along the face, laid over the liner. */
function pressures(state, y) {
  const lists = [state.filmPressure, state.asperityPressure].filter(Boolean);
  const highest = Math.max(state.above ?? 0, ...lists.flat().filter((v) => v !== null));
  const reach = (p) => kLiner + (kPressureRoom * p) / highest;
  const points = (list) => list.map((p, i) => (p === null ? null : [reach(p), y(state.x[i])]));
  if (lists.length === 0) return [];
  const out = [
    area(
      [[kLiner, kFace.top], ...points(state.filmPressure).filter(Boolean), [kLiner, kFace.bottom]],
      caseColour(0),
      0.15,
    ),
    line(points(state.filmPressure), caseColour(0)),
  ];
  if (state.asperityPressure) out.push(line(points(state.asperityPressure), '#b03a06', { dash: '6 3' }));
  const label = (words, at, fill) => text(kLiner + 12, at, words, { size: 11, fill, halo: kWall });
  out.push(
    label(`film pressure, to ${bar(Math.max(...state.filmPressure))}`, kFace.bottom + 18, caseColour(0)),
  );
  if (state.asperityPressure)
    out.push(
      label(
        `asperity pressure, to ${bar(Math.max(...state.asperityPressure))}`,
        kFace.bottom + 33,
        '#b03a06',
      ),
    );
  return out;
}

function labels(state, y) {
  const middle = (kFace.top + kFace.bottom) / 2;
  const ring = kGroove + 40;
  const behind = state.below + state.share * (state.above - state.below);
  const thinnest = state.gap.indexOf(Math.min(...state.gap));
  return [
    text(8, 20, `gas above the ring ${bar(state.above)}`, { weight: 600 }),
    text(8, kHeight - 14, `gas below the ring ${bar(state.below)}`, { weight: 600 }),
    text(8, 56, 'piston', { fill: kFaint, size: 11 }),
    text(8, 246, 'piston', { fill: kFaint, size: 11 }),
    text(kWidth - 8, 20, 'liner', { anchor: 'end', fill: kFaint, size: 11 }),
    ...[0.25, 0.5, 0.75].map((share) =>
      arrow(kGroove + 6, kGroove + 32, kFace.top + share * (kFace.bottom - kFace.top), '#b03a06'),
    ),
    text(ring, middle - 20, 'ring', { fill: kFaint, size: 11 }),
    text(ring, middle - 4, `gas ${bar(behind)}`, { size: 11 }),
    state.tension === null ? '' : text(ring, middle + 11, `tension ${bar(state.tension)}`, { size: 11 }),
    rule(kLiner + 40, 52, kLiner + 1, y(state.x[thinnest]), kInk, 0.8),
    text(kLiner + 12, 46, `film ${number(converted(state.film, 'um'), 3)} µm`, { weight: 600 }),
    rule(kWidth - 26, kFace.top, kWidth - 26, kFace.bottom, kFaint),
    rule(kWidth - 30, kFace.top, kWidth - 22, kFace.top, kFaint),
    rule(kWidth - 30, kFace.bottom, kWidth - 22, kFace.bottom, kFaint),
    text(
      kWidth - 4,
      kFace.top - 6,
      `${number(converted(state.x[state.x.length - 1] - state.x[0], 'mm'), 3)} mm`,
      {
        anchor: 'end',
        size: 11,
        fill: kFaint,
      },
    ),
  ];
}

/** The section as an SVG document. */
export function sectionSvg(state) {
  const [first, last] = [state.x[0], state.x[state.x.length - 1]];
  const y = (x) => kFace.top + ((x - first) / (last - first)) * (kFace.bottom - kFace.top);
  const across = kWidestGap / Math.max(...state.gap);
  const edge = state.x.map((x, i) => [kLiner - across * state.gap[i], y(x)]);
  const shapes = [...solids(edge, state), ...pressures(state, y), ...labels(state, y)];
  return svgDocument({ shapes, height: kHeight }, kWidth);
}

function drawing(model, c) {
  const peak = model.peakAngle(c);
  const angle = peak ?? wrapped(c.values.min_film_thickness_angle ?? c.curves.crank_angle[0] ?? 0);
  const state = sectionState(c, angle);
  if (!state) return null;
  const when = angleInWords(state.angle);
  const why =
    peak !== null ? ', where the gas pressure peaks' : c.complete ? ', where the film is thinnest' : '';
  const times = Math.round(exaggeration(state));
  const words =
    `${model.several ? `${c.name}, ` : ''}${when}${why}. Face and film: ${times} times ` +
    'wider than long; groove, lands and ring thickness not to scale.';
  return element(
    'div',
    { class: 'section-drawing' },
    element(
      'div',
      { role: 'img', 'aria-label': `Section of ring, groove and liner, ${words}` },
      svgElement(sectionSvg(state)),
    ),
    element('p', { class: 'how' }, words),
  );
}

/** More would push the charts off the first pages. */
const kMostDrawings = 3;

/** One drawing for each of the first cases; null where none can be drawn. */
export function drawings(model) {
  const drawn = model.cases
    .slice(0, kMostDrawings)
    .map((c) => drawing(model, c))
    .filter(Boolean);
  return drawn.length ? element('div', { class: 'drawings' }, drawn) : null;
}
