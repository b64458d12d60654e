// The figures over the engine cycle, as plain data that the screen, the SVG and the CSV are drawn from.
import { angleInWords, display, number, shortPath, withUnit, wrapped } from '../units.js';
import { window } from '../model.js';

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

export function quantityAxis(model, name) {
  const quantity = model.curveQuantity.get(name);
  return { yLabel: quantity.long_name, yUnit: display(quantity).unit };
}

/** One series a case, or one for all where the cases do not differ. */
export function caseSeries(model, name, { part = null, range = kCycleRange } = {}) {
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
    const at = wrapped(c.values.peak_gas_pressure_angle ?? null);
    if (at === null) continue;
    const known = peaks.find((p) => Math.abs(p.at - at) < 0.25);
    if (known) known.caseIndex = null;
    else peaks.push({ at, caseIndex: model.several ? c.index : null });
  }
  return peaks;
}

export function cyclePanel(model, name, options = {}) {
  const range = options.range ?? kCycleRange;
  return {
    id: name,
    ...quantityAxis(model, name),
    xLabel: 'crank angle, firing TDC = 0',
    xUnit: '°',
    crank: true,
    xRange: range,
    zeroLine: options.zeroLine ?? false,
    fromZero: options.fromZero ?? true,
    yMarks: options.yMarks ?? [],
    peaks: pressurePeaks(model),
    series: [...caseSeries(model, name, options), ...overlaySeries(model, name, range)],
  };
}

/** "62.0 bar in all cases", or "new ring: 62.0 bar; run-in ring: ..." */
export function forEachCase(model, sentence) {
  const sentences = model.cases.map(sentence);
  if (!model.several) return sentences[0];
  if (new Set(sentences).size === 1) return `${sentences[0]} in ${model.allCases}`;
  return model.cases.map((c, i) => `${c.name} ${sentences[i]}`).join('; ');
}

/** The same for the values of a whole cycle. */
export function ofEachCycle(model, sentence) {
  return forEachCase(model, (c) => (c.complete ? sentence(c) : 'none, the integration stopped early'));
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
    panels: [cyclePanel(model, 'gas_pressure')],
    caption:
      'Absolute gas pressure above the ring; it also presses the ring outwards from behind. Peak: ' +
      ofEachCycle(
        model,
        (c) =>
          `${valueWithUnit(model, c, 'peak_gas_pressure')} ${angleInWords(c.values.peak_gas_pressure_angle)}`,
      ) +
      `. Origin: ${forEachCase(model, (c) => origin(model, c))}.` +
      `${overlaySentence(model, 'gas_pressure')}`,
  };
}

/** How close to the peak of the pressure the thinnest film still counts as being there [degree]. */
const kNearPeak = 15;

function filmFigure(model) {
  const nearPeak = model.cases.every(
    (c) =>
      c.complete &&
      Math.abs(wrapped(c.values.min_film_thickness_angle) - wrapped(c.values.peak_gas_pressure_angle)) <=
        kNearPeak,
  );
  return {
    id: 'min-film-thickness',
    title: 'Minimum film thickness',
    paper: 'Fig. 8',
    panels: [cyclePanel(model, 'min_film_thickness')],
    caption:
      'Smallest separation of the mean planes anywhere along the face. Thinnest: ' +
      ofEachCycle(
        model,
        (c) =>
          `${valueWithUnit(model, c, 'min_film_thickness')} ` +
          `${angleInWords(c.values.min_film_thickness_angle)}`,
      ) +
      '.' +
      (nearPeak ? ' That is at the peak of the gas pressure, not at the dead centre.' : '') +
      `${overlaySentence(model, 'min_film_thickness')}`,
  };
}

function lambdaRatioFigure(model) {
  return {
    id: 'lambda-ratio',
    title: 'Lambda ratio',
    panels: [cyclePanel(model, 'lambda_ratio', { yMarks: [{ at: 3, label: 'mixed below 3' }] })],
    caption:
      'Minimum film over the composite roughness of the two surfaces. Under 3 the asperities ' +
      'touch, lubrication is mixed. Share of the cycle: ' +
      `${ofEachCycle(model, (c) => valueWithUnit(model, c, 'mixed_share'))}.`,
  };
}

function frictionFigure(model) {
  return {
    id: 'total-friction',
    title: 'Friction',
    paper: 'Fig. 9',
    panels: [cyclePanel(model, 'total_friction')],
    caption: `Boundary plus viscous friction of the whole ring, without sign. Peak: ${ofEachCycle(
      model,
      (c) =>
        `${valueWithUnit(model, c, 'peak_total_friction')} ` +
        `${angleInWords(c.values.peak_total_friction_angle)}`,
    )}.${overlaySentence(model, 'total_friction')}`,
  };
}

function frictionZoomFigure(model) {
  const zoom = (name, part) => cyclePanel(model, name, { part, range: kZoom });
  return {
    id: 'friction-firing',
    title: 'Friction around firing TDC, split',
    paper: 'Fig. 9',
    layout: 'row',
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
    title: 'Oil flow under the middle of the ring',
    paper: 'Fig. 11',
    panels: [cyclePanel(model, 'oil_flow_middle', { zeroLine: true })],
    caption:
      'Mass flow through the middle section of the face, whole circumference, seen from the ring; ' +
      'positive from chamber to crankcase. Mean without sign: ' +
      ofEachCycle(model, (c) => valueWithUnit(model, c, 'mean_absolute_oil_flow')) +
      '; net over the cycle: ' +
      ofEachCycle(model, (c) => valueWithUnit(model, c, 'net_oil_flow')) +
      `.${overlaySentence(model, 'oil_flow_middle')}`,
  };
}

export function cycleFigures(model) {
  const figures = [
    pressureFigure,
    filmFigure,
    lambdaRatioFigure,
    frictionFigure,
    linerFrictionFigure,
    flowFigure,
  ];
  return figures.map((make) => withBandSentence({ ...make(model), group: 'cycle' }));
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
      `${quantity.long_name}${quantity.symbol ? `, ${quantity.symbol} in the theory` : ''}; named ` +
      `${name} in the result file.${overlaySentence(model, name)}`,
  });
}

export function shownElsewhere() {
  return [
    'crank_angle',
    'gas_pressure',
    'min_film_thickness',
    'lambda_ratio',
    'total_friction',
    'friction_on_liner',
    'oil_flow_middle',
  ];
}

/** Text for people who cannot see the chart: what it spans. */
export function spokenSummary(figure) {
  return figure.panels
    .map((panel) => {
      const parts = panel.series.map((s) => {
        const seen = s.y.filter((v) => v !== null && Number.isFinite(v));
        return seen.length
          ? `${s.label} from ${number(Math.min(...seen), 3)} to ${number(Math.max(...seen), 3)}`
          : `${s.label} without values`;
      });
      return (
        `${panel.yLabel}${panel.yUnit ? ` in ${panel.yUnit}` : ''} over ${panel.xLabel}: ` +
        `${parts.join(', ')}`
      );
    })
    .join('. ');
}
