// The curves that were kept, over crank angle: those of few scenarios, or bands.
import { crankPanel } from '../cycle/cycle_figures.js';
import { kOnlyCase } from '../model.js';
import { short } from './study_model.js';
import { angle, display, number } from '../units.js';

/** Quantities that may have either sign. */
const kSigned = [
  'friction_on_liner',
  'piston_velocity',
  'oil_flow_middle',
  'oil_flow_chamber_edge',
  'oil_flow_crankcase_edge',
  'gas_flow_through_film',
];

/** Does a curve have signs, also that of a ring of a pack: ring_2_friction_on_liner? */
const isSigned = (name) => kSigned.includes(name.replace(/^ring_\d+_/, ''));

/** A curve of each drawn scenario; null where bands take their place. */
function scenarioSeries(model, x, shown, quantity) {
  return (
    model.curves.scenarios?.list.map(({ name, base, values }, place) => ({
      caseIndex: place,
      part: null,
      label: model.several ? `${model.bases[base].name}, ${name}` : name,
      x,
      y: shown(values[quantity]),
    })) ?? null
  );
}

function curvesSentence({ of, list }) {
  return list.length < of
    ? `${list.length} of ${of} scenarios, evenly picked; the result file has all.`
    : `The curves of all ${of} scenarios.`;
}

/** Median and bands of each base. */
function bandSeries(model, x, shown, quantity) {
  const { curves } = model;
  const words = (share) => `${short(100 * share)} %`;
  return curves.bands
    .filter((band) => band.quantity === quantity && band.values[2].some((v) => v !== null))
    .map((band) => {
      const [low, lower, middle, upper, high] = band.values.map(shown);
      const [a, b, , c, d] = curves.shares.map(words);
      return {
        caseIndex: model.several ? band.base : kOnlyCase,
        part: null,
        label: model.several ? model.bases[band.base].name : 'median of the scenarios',
        x,
        y: middle,
        bands: [
          { low, high, words: [a, d] },
          { low: lower, high: upper, words: [b, c] },
        ],
      };
    });
}

function bandsSentence(model, quantity, series, x, unit) {
  const width = (s) => {
    const [{ low, high }] = s.bands;
    const k = high.reduce((best, v, n) => (v - low[n] > high[best] - low[best] ? n : best), 0);
    return (
      `${model.several ? `${s.label} ` : ''}${number(low[k], 3)} to ${number(high[k], 3)} ${unit} at ` +
      `${angle(x[k])}°`
    );
  };
  const n = model.curves.bands
    .filter((band) => band.quantity === quantity)
    .map((band) => model.statistics[model.main_values[0]][band.base]?.n ?? 0);
  return (
    `Line: median; bands: 50\u00a0% and 90\u00a0% of the ${[...new Set(n)].join(', ')} ` +
    `scenarios${model.several ? ' of each base' : ''}` +
    `${model.has_sample ? '' : ', which are not a sample: bands show their range, not how likely it is'}` +
    '. Each angle has its own quantiles: no band is the curve of one scenario. Widest: ' +
    `${series.map(width).join('; ')}.`
  );
}

/** A figure for each quantity: the curves of few scenarios, or median and bands of each base. */
export function curveFigures(model) {
  const { curves } = model;
  if (!curves) return [];
  const x = [...curves.angles, 360];
  return curves.quantities
    .map((described, i) => {
      const { unit, convert } = display(described);
      const shown = (values) => [...values, values[0]].map((v) => convert(v));
      const single = scenarioSeries(model, x, shown, i);
      const series = single ?? bandSeries(model, x, shown, i);
      if (series.length === 0) return null;
      return {
        id: `band-${described.name.replace(/_/g, '-')}`,
        group: true,
        title: `${described.long_name[0].toUpperCase()}${described.long_name.slice(1)}`,
        panels: [
          crankPanel(`band-${described.name}`, described.long_name, unit, series, {
            xLabel: 'crank angle',
            zeroLine: isSigned(described.name),
            fromZero: !isSigned(described.name),
          }),
        ],
        caption: single ? curvesSentence(curves.scenarios) : bandsSentence(model, i, series, x, unit),
      };
    })
    .filter(Boolean);
}
