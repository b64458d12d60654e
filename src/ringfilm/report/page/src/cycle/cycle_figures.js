// The figures over the engine cycle, as plain data that the screen, the SVG and the CSV are drawn from.
import {
  angle,
  angleInWords,
  display,
  howOften,
  number,
  sentence,
  shortPath,
  withUnit,
  wrapped,
} from '../units.js';
import { boundaryPowerShare, window } from '../model.js';
import { kRegimeLimits } from '../plot/palette.js';

export const kCycleRange = [-360, 360];
const kZoom = [-30, 90];

/** Curves that differ by less than this share of their size are drawn once, for all cases. */
const kSame = 1e-6;

function sameInAll(model, name) {
  if (!model.several) return false;
  const [first, ...others] = model.cases.map((c) => c.curves[name]);
  const size = Math.max(...first.map((v) => Math.abs(v ?? 0)), 1e-300);
  return others.every(
    (list) =>
      list.length === first.length &&
      list.every((v, k) => Math.abs((v ?? 0) - (first[k] ?? 0)) <= kSame * size),
  );
}

/** One series a case, or one for all where the cases do not differ. */
function caseSeries(model, name, { part = null, range = kCycleRange } = {}) {
  const drawn = (c) => {
    const error = model.curveError(c, name);
    return { ...window(model.curve(c, name), ...range), error: error && window(error, ...range).y };
  };
  if (sameInAll(model, name) && part === null)
    return [{ caseIndex: null, part, label: model.allCases, ...drawn(model.cases[0]) }];
  return model.cases.map((c) => ({ caseIndex: c.series, part, label: c.name, ...drawn(c) }));
}

/** What the band about a curve is, for the captions of figures that have one. */
export function bandSentence(panels) {
  return panels.some((panel) => panel.series.some((s) => s.error))
    ? ' Light band: how far cells and crank steps may have moved the curve; where none is seen it ' +
        'is thinner than the line.'
    : '';
}

function overlaySeries(model, name, range = kCycleRange) {
  const { convert } = display(model.curveQuantity.get(name));
  return model.payload.overlays
    .filter((o) => o.quantity === name)
    .map((o) => {
      const points = o.crank_angle
        .map((a, k) => [wrapped(a), convert(o.value[k])])
        .sort((a, b) => a[0] - b[0]);
      const curve = { x: points.map((p) => p[0]), y: points.map((p) => p[1]) };
      return {
        caseIndex: null,
        part: 'measured',
        label: /measured/i.test(o.name) ? o.name : `measured: ${o.name}`,
        ...window(curve, ...range),
      };
    });
}

export function overlaySentence(model, name) {
  const laid = model.payload.overlays.filter((o) => o.quantity === name);
  return laid.length
    ? ' Dots: given from outside, not computed here ' +
        `(${laid.map((o) => `${o.name}, ${shortPath(o.source)}`).join('; ')}).`
    : '';
}

/** Where the gas pressure peaks, once for each different angle. */
export function pressurePeaks(model) {
  const peaks = [];
  for (const c of model.cases) {
    const at = model.peakAngle(c);
    if (at === null) continue;
    const known = peaks.find((p) => Math.abs(p.at - at) < 0.25);
    if (known) known.caseIndex = null;
    else peaks.push({ at, caseIndex: model.several ? c.series : null });
  }
  return peaks;
}

/** A panel over the crank angle. @param more what else it has: zeroLine, fromZero, yScale, ... */
export function crankPanel(id, yLabel, yUnit, series, more = {}) {
  return {
    id,
    yLabel,
    yUnit,
    xLabel: 'crank angle, firing TDC = 0',
    xUnit: '°',
    crank: true,
    xRange: kCycleRange,
    series,
    ...more,
  };
}

export function cyclePanel(model, name, options = {}) {
  const { range = kCycleRange, zeroLine = false, fromZero = true } = options;
  const quantity = model.curveQuantity.get(name);
  const series = [...caseSeries(model, name, options), ...overlaySeries(model, name, range)];
  return crankPanel(name, quantity.long_name, display(quantity).unit, series, {
    xRange: range,
    zeroLine,
    fromZero,
    peaks: pressurePeaks(model),
  });
}

/** "62.0 bar in all cases", or "new ring: 62.0 bar; run-in ring: ..." */
export function forEachCase(model, stated) {
  const sentences = model.cases.map(stated);
  if (!model.several) return sentences[0];
  if (new Set(sentences).size === 1) return `${sentences[0]} in ${model.allCases}`;
  return model.cases.map((c, i) => `${c.name} ${sentences[i]}`).join('; ');
}

/** The sentence of each case on values of a whole cycle, which a stopped integration does not have. */
export function ofEachCycle(model, stated) {
  return forEachCase(model, (c) => (c.complete ? stated(c) : 'none, the integration stopped early'));
}

export function valueWithUnit(model, c, name, digits = 3) {
  const { value, unit } = model.value(c, name);
  return withUnit(value, unit, digits);
}

const kOrigin = {
  synthetic: 'SYNTHETIC: made by a formula, not measured',
  measured: 'a measured trace',
  computed: 'a trace computed by another program',
};

/** Where the gas pressure of a case comes from. */
function origin(model, c) {
  const named = (key) => model.input(c, key)?.shown;
  if (named('gas.model') === 'wiebe') return 'computed by the single-zone model, not measured';
  return kOrigin[named('gas.trace_origin')] ?? 'a trace that the case does not state as measured or computed';
}

function pressureFigure(model) {
  const synthetic = model.cases.some((c) => model.isSynthetic(c));
  return {
    id: 'cylinder-pressure',
    title: synthetic ? 'Gas pressure above the ring (SYNTHETIC)' : 'Gas pressure above the ring',
    paper: 'Fig. 7',
    offersLog: true,
    panels: [cyclePanel(model, 'gas_pressure')],
    caption:
      'Absolute gas pressure above the ring; it also presses the ring outwards from behind. Peak: ' +
      ofEachCycle(
        model,
        (c) =>
          `${valueWithUnit(model, c, 'peak_gas_pressure')} ` +
          (model.peakAngle(c) === null ? 'at all angles' : angleInWords(model.peakAngle(c))),
      ) +
      `. Origin: ${forEachCase(model, (c) => origin(model, c))}.` +
      `${overlaySentence(model, 'gas_pressure')}`,
  };
}

/** Closer to another angle than this, the thinnest film is at that angle [degree]. */
const kThere = 2;

/** Where the film of a case is thinnest, in words: next to the peak of the gas pressure. */
export function thinnestInWords(model, c) {
  const at = wrapped(c.values.min_film_thickness_angle);
  const peak = model.peakAngle(c);
  if (at === null || peak === null) return angleInWords(at);
  const after = wrapped(at - peak);
  const size = `${angle(Math.abs(after))}°`;
  if (Math.abs(after) <= kThere) return `${angleInWords(at)}, at the peak of the gas pressure`;
  return Math.abs(after) < kFollows
    ? `${angleInWords(at)}, ${size} ${after > 0 ? 'after' : 'before'} the peak of the gas pressure`
    : `${angleInWords(at)}, away from the peak of the gas pressure`;
}

/** Within this the peak of the gas pressure is named with its distance [degree]. */
const kFollows = 90;

function filmFigure(model) {
  return {
    id: 'min-film-thickness',
    title: 'Minimum film thickness',
    paper: 'Fig. 8',
    panels: [cyclePanel(model, 'min_film_thickness')],
    caption:
      'Smallest separation of the mean planes anywhere along the face. Thinnest: ' +
      ofEachCycle(
        model,
        (c) => `${valueWithUnit(model, c, 'min_film_thickness')} ${thinnestInWords(model, c)}`,
      ) +
      `.${overlaySentence(model, 'min_film_thickness')}`,
  };
}

/** Marks of the lambda ratios above which the asperities of each case carry less than 1 % of the tension. */
export function fullFilmMarks(model) {
  const found = model.cases
    .map((c) => ({ c, at: c.derived?.full_film_lambda_ratio }))
    .filter(({ at }) => at > 0);
  const isOne = new Set(found.map(({ at }) => number(at, 2))).size === 1;
  return (isOne ? found.slice(0, 1) : found).map(({ c, at }) => ({
    at,
    label: isOne ? 'full film above' : `${c.name}: full film above`,
  }));
}

function lambdaRatioFigure(model) {
  const marks = fullFilmMarks(model);
  const limit = (c) =>
    c.derived?.full_film_lambda_ratio > 0 ? number(c.derived.full_film_lambda_ratio, 2) : 'any';
  return {
    id: 'lambda-ratio',
    title: 'Lambda ratio',
    panels: [{ ...cyclePanel(model, 'lambda_ratio'), yMarks: marks }],
    caption:
      'Minimum film over the composite roughness of the two surfaces. Lowest: ' +
      `${ofEachCycle(model, (c) => valueWithUnit(model, c, 'min_lambda_ratio'))}.` +
      (marks.length
        ? ' By the contact law of the case asperities carry less than 1\u00a0% of the tension above a ratio of ' +
          `${forEachCase(model, limit)} (dotted, where the chart reaches it).`
        : ''),
  };
}

function asperityShareFigure(model) {
  const range = (c) => {
    const shares = model.curve(c, 'asperity_load_share').y.filter((v) => v !== null);
    return shares.length
      ? `${number(Math.min(...shares), 2)} to ${number(Math.max(...shares), 2)}\u00a0%`
      : 'none';
  };
  return {
    id: 'asperity-share',
    title: 'Load carried by asperities',
    offersLog: true,
    panels: [{ ...cyclePanel(model, 'asperity_load_share'), yMarks: kRegimeLimits }],
    caption:
      'Share of asperities in the load that they and the oil carry beyond the pressures at the edges; where it is ' +
      `100\u00a0% oil carries nothing. Range: ${forEachCase(model, range)}. Boundary friction in the friction power: ` +
      `${ofEachCycle(model, (c) => withUnit(boundaryPowerShare(c.values), '%', 3))}.`,
  };
}

/** More marks than these would cover the curves. */
const kMostMarks = 4;

/** Is gas at an edge of the face? It may fill a part of it, which no cavity is. */
const hasGasEdge = (model, c) =>
  ['film.chamber_edge', 'film.crankcase_edge'].some((key) => model.input(c, key)?.shown === 'gas');

/**
 * Crank angles where a cavity of a mass-conserving film closes, on the axis of the charts: the film is full from
 * there on, and friction has a kink. None next to gas, where a film without a cavity need not be full.
 */
export function closings(model, c) {
  if (model.input(c, 'film.cavitation')?.shown !== 'mass-conserving' || hasGasEdge(model, c)) return [];
  const curve = model.curve(c, 'cavitated_fraction');
  return curve.x.filter((_, k) => k > 0 && curve.y[k] === 0 && curve.y[k - 1] > 0);
}

/** Marks of the kinks for a chart, and the sentence on them for its caption. */
function kinks(model) {
  const found = model.cases.map((c) => ({ c, at: closings(model, c) })).filter(({ at }) => at.length > 0);
  const all = [...new Set(found.flatMap(({ at }) => at))].sort((a, b) => a - b);
  if (all.length === 0) return { marks: [], words: '' };
  const words = found
    .map(({ c, at }) => `${model.several ? `${c.name} ` : ''}${at.map(angleInWords).join(' and ')}`)
    .join('; ');
  return {
    marks: all.length > kMostMarks ? [] : all.map((at, i) => ({ at, label: i === 0 ? 'cavity closes' : '' })),
    words: ` The kink of the curve is physical: there a cavity closes and the film is full again (${words}).`,
  };
}

/** Stretches of crank angles in which gas of an edge reaches the lowest place of the face: { from, to, count }. */
export function breakthroughs(c) {
  const angles = c.curves.crank_angle;
  const blows = (c.curves.gas_breakthrough ?? []).map((v) => v > 0);
  if (!blows.includes(true)) return [];
  const n = angles.length;
  const first = blows.findIndex((here, k) => here && !blows[(k + n - 1) % n]);
  if (first < 0) return [{ from: -360, to: 360, count: n }];
  const found = [];
  for (let step = 0; step < n; step++) {
    const k = (first + step) % n;
    if (!blows[k]) continue;
    if (!blows[(k + n - 1) % n]) found.push({ from: wrapped(angles[k]), count: 0 });
    Object.assign(found[found.length - 1], {
      to: wrapped(angles[k]),
      count: found[found.length - 1].count + 1,
    });
  }
  return found.sort((a, b) => a.from - b.from);
}

/** Stretches of gas breakthrough for a chart, and the sentence on them for its caption. */
function gasBreakthrough(model) {
  const found = model.cases.map((c) => ({ c, at: breakthroughs(c) })).filter(({ at }) => at.length > 0);
  if (found.length === 0) return { spans: [], words: '' };
  const stretch = ({ from, to }) =>
    from === to ? `${angle(from)}°` : `${angle(from)}° to ${angle(from < to ? to : to + 720)}°`;
  const words = ({ c, at }) => {
    const count = at.reduce((sum, one) => sum + one.count, 0);
    const shown = at.slice(0, kMostMarks).map(stretch).join(', ');
    return (
      `${model.several ? `${c.name} ` : ''}at ${howOften(count, c.curves.crank_angle.length)} (${shown}` +
      `${at.length > kMostMarks ? `, ${at.length - kMostMarks} more` : ''})`
    );
  };
  return {
    spans: found.flatMap(({ c, at }) => at.map(({ from, to }) => ({ from, to, caseIndex: c.series }))),
    words: ` Bars on top: gas breaks through the film ${found.map(words).join('; ')}.`,
  };
}

function frictionFigure(model) {
  const kink = kinks(model);
  const gas = gasBreakthrough(model);
  return {
    id: 'total-friction',
    title: 'Friction',
    paper: 'Fig. 9',
    offersLog: true,
    panels: [{ ...cyclePanel(model, 'total_friction'), xMarks: kink.marks, spans: gas.spans }],
    caption: `Boundary plus viscous friction of the whole ring, without sign. Peak: ${ofEachCycle(
      model,
      (c) =>
        `${valueWithUnit(model, c, 'peak_total_friction')} ` +
        `${angleInWords(c.values.peak_total_friction_angle)}`,
    )}.${kink.words}${gas.words}${overlaySentence(model, 'total_friction')}`,
  };
}

function frictionZoomFigure(model) {
  const zoom = (name, part) => cyclePanel(model, name, { part, range: kZoom });
  return {
    id: 'friction-firing',
    title: 'Friction around firing TDC, split',
    paper: 'Fig. 9',
    layout: 'row',
    offersLog: true,
    panels: [zoom('boundary_friction', 'boundary'), zoom('viscous_friction', 'viscous')],
    caption: (
      `From ${kZoom[0]}° to ${kZoom[1]}°: friction of touching asperities (dashed) and of the ` +
      'sheared oil (dotted), each on a scale of its own. Boundary peak against viscous peak: ' +
      ofEachCycle(
        model,
        (c) =>
          `${valueWithUnit(model, c, 'peak_boundary_friction')} against ` +
          `${valueWithUnit(model, c, 'peak_viscous_friction')}`,
      ) +
      '.'
    ).replace('-', '−'),
  };
}

function linerFrictionFigure(model) {
  return {
    id: 'friction-on-liner',
    title: 'Signed friction on the liner',
    panels: [cyclePanel(model, 'friction_on_liner', { zeroLine: true })],
    caption:
      'The force that a floating liner measures, positive towards TDC; it changes its sign where ' +
      `the piston turns round.${overlaySentence(model, 'friction_on_liner')}`,
  };
}

function flowFigure(model) {
  return {
    id: 'oil-flow-middle',
    title: 'Oil flow at mid-face',
    paper: 'Fig. 11',
    panels: [cyclePanel(model, 'oil_flow_middle', { zeroLine: true })],
    caption:
      'Mass flow through the middle section of the face, whole circumference, seen from the ring; ' +
      'positive from chamber to crankcase. ' +
      (model.cases.some((c) => model.hasFloodedInlet(c))
        ? 'A flooded inlet gives an upper bound: with less oil ahead of the ring less flows. '
        : '') +
      'Mean without sign: ' +
      ofEachCycle(model, (c) => valueWithUnit(model, c, 'mean_absolute_oil_flow')) +
      '; net over the cycle: ' +
      ofEachCycle(model, (c) => valueWithUnit(model, c, 'net_oil_flow')) +
      `.${overlaySentence(model, 'oil_flow_middle')}`,
  };
}

/** What makes the figures of the section over the cycle, in their order. */
export const kCycleFigures = [
  filmFigure,
  frictionFigure,
  pressureFigure,
  lambdaRatioFigure,
  asperityShareFigure,
  linerFrictionFigure,
  flowFigure,
];

/** @param make one of kCycleFigures */
export function cycleFigure(model, make) {
  return withBandSentence({ ...make(model), group: 'cycle' });
}

function withBandSentence(figure) {
  return { ...figure, caption: figure.caption + bandSentence(figure.panels) };
}

export function zoomFigure(model) {
  return withBandSentence(frictionZoomFigure(model));
}

/** Any curve quantity that has no figure of its own, for the reader to choose. */
export function otherQuantityFigure(model, name) {
  const quantity = model.curveQuantity.get(name);
  const signed = model.cases.some((c) => c.curves[name].some((v) => v < 0));
  return withBandSentence({
    id: 'other-quantity',
    title: 'Any other quantity',
    group: 'cycle',
    panels: [cyclePanel(model, name, { zeroLine: signed, fromZero: false })],
    caption:
      `${sentence(quantity.long_name)} Named ${name} in the result file.` + `${overlaySentence(model, name)}`,
  });
}

export function shownElsewhere() {
  return [
    'crank_angle',
    'gas_pressure',
    'min_film_thickness',
    'lambda_ratio',
    'asperity_load_share',
    'total_friction',
    'friction_on_liner',
    'oil_flow_middle',
  ];
}
