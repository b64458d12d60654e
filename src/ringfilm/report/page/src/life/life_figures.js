// Values over the running time, on a linear and a logarithmic axis, and what each part of the ring changes.
import { kOnlyCase } from '../model.js';
import { display, typeset } from '../units.js';
import { curveOrigin, hoursText } from './life_words.js';

/** Quantities of the cycle that have a figure, the most important first; those of wear follow. */
const kDrawn = [
  'mean_power_loss',
  'mean_absolute_oil_flow',
  'energy_per_cycle',
  'fmep',
  'lambda_ratio_at_peak_pressure',
  'min_film_thickness',
  'peak_friction_coefficient_firing',
  'mean_boundary_power',
];

const kParts = [
  ['face', 'face'],
  ['roughness', 'roughness'],
  ['shear_strength', 'shear'],
];

/** Hours on the axis: a logarithm has no place for the start, which is drawn at 1 h. */
const afterOneHour = (hours) => hours + 1;

function bandOf(life, described, convert) {
  if (!life.states.every((state) => state.band && state.band[described.name])) return null;
  const end = (k) => life.states.map((state) => convert(state.band[described.name][k]));
  return {
    low: end(0),
    high: end(1),
    words: life.wear?.fit
      ? ['least over the fitted range', 'largest over it']
      : ['least of all interpolations', 'largest of them'],
  };
}

/** What follows the last measured state, with that state: assumed to stay as it was. */
function heldSeries(life, name, convert, place) {
  const first = life.states.findIndex((state) => state.state_origin === 'held');
  if (first < 0) return [];
  const held = life.states.slice(Math.max(0, first - 1));
  return [
    {
      caseIndex: null,
      part: 'viscous',
      label: 'held: assumed',
      x: held.map((state) => place(state.hours)),
      y: held.map((state) => convert(state[name])),
    },
  ];
}

function seriesOf(life, described, convert, place) {
  const { name } = described;
  const x = life.states.map((state) => place(state.hours));
  const values = (from) => life.states.map((state) => convert(from(state)));
  const measured = life.states.filter((state) => state.state_origin === 'measured');
  const band = bandOf(life, described, convert);
  const all = [
    {
      caseIndex: kOnlyCase,
      part: null,
      label: curveOrigin(life),
      x,
      y: values((state) => (state.state_origin === 'held' ? null : state[name])),
      bands: band ? [band] : [],
    },
    ...heldSeries(life, name, convert, place),
  ];
  if (life.states.every((state) => state.turned && name in state.turned)) {
    all.push({
      caseIndex: null,
      part: 'boundary',
      label: `ring turned over, ${curveOrigin(life)}`,
      x,
      y: values((state) => state.turned[name]),
    });
  }
  if (measured.length > 0) {
    all.push({
      caseIndex: null,
      part: 'measured',
      label: 'measured states',
      x: measured.map((state) => place(state.hours)),
      y: measured.map((state) => convert(state[name])),
    });
  }
  return all;
}

function panelOf(life, described, scale) {
  const { unit, convert } = display(described);
  const isLog = scale === 'log';
  return {
    id: `${described.name}-${scale}`,
    xScale: isLog ? 'log' : 'linear',
    xLabel: isLog ? 'running time + 1 h' : 'running time',
    xUnit: 'h',
    yLabel: typeset(described.long_name),
    yUnit: unit,
    fromZero: true,
    series: seriesOf(life, described, convert, isLog ? afterOneHour : (hours) => hours),
  };
}

const sentenceCase = (text) => text[0].toUpperCase() + text.slice(1);

function howKnown(life) {
  const turned = life.states.some((state) => state.turned)
    ? ' Dashed: the ring turned over, since faces do not show which edge was the chamber edge.'
    : '';
  if (life.mode !== 'archard') {
    return (
      'Dots: measured states. The line between them is interpolated; the band covers other time constants and ' +
      `an interpolation that is linear in time.${turned}`
    );
  }
  const surface = {
    path: ' Roughness and shear strength are interpolated between measured states.',
    'running-in':
      ' The roughness falls with the worn depth by a stated law; shear strength is assumed to stay.',
    frozen: ' Roughness and shear strength are assumed to stay as they are.',
  }[life.wear.surface];
  const coefficient = life.wear.fit
    ? 'A scenario, not a prediction: the line has the geometric mean of the coefficients that the measured faces ' +
      'allow, the band has both ends of their range.'
    : 'A scenario with a stated wear coefficient, not a prediction.';
  return coefficient + surface + turned;
}

export function figuresOverHours(life) {
  const isKnown = (state, name) => typeof state[name] === 'number';
  return [...kDrawn, ...life.worn_quantities.map((quantity) => quantity.name)]
    .filter((name) => life.states.every((state) => isKnown(state, name)))
    .map((name, k) => {
      const described = life.quantities.find((quantity) => quantity.name === name);
      const scales = life.states.length > 1 ? ['linear', 'log'] : ['linear'];
      return {
        id: `hours-${name.replace(/_/g, '-')}`,
        title: sentenceCase(typeset(described.long_name)),
        layout: 'row',
        panels: scales.map((scale) => panelOf(life, described, scale)),
        caption:
          k === 0
            ? `${howKnown(life)} The first panel is linear in time, the second logarithmic, with the start at 1 h.`
            : 'Lines and band as in the first figure.',
      };
    });
}

/** Friction power with one part of the last state in the first one. */
export function attributionFigure(life) {
  const [first, last] = [life.states[0], life.states[life.states.length - 1]];
  if (!last.attribution) return null;
  const described = life.quantities.find((quantity) => quantity.name === 'mean_power_loss');
  const { unit, convert } = display(described);
  const bars = [
    [hoursText(first.hours), first.mean_power_loss],
    ...kParts
      .filter(([name]) => last.attribution[name])
      .map(([name, label]) => [label, last.attribution[name].mean_power_loss]),
    [hoursText(last.hours), last.mean_power_loss],
  ];
  return {
    id: 'attribution',
    title: 'Friction power with one part of the ring changed',
    layout: 'row',
    panels: [
      {
        id: 'attribution-bars',
        bars: true,
        weight: 1,
        yLabel: described.long_name,
        yUnit: unit,
        categories: bars.map(([label]) => label),
        groups: [
          {
            caseIndex: kOnlyCase,
            label: described.long_name,
            stacks: bars.map(([, value]) => [{ part: 'total', value: convert(value) }]),
          },
        ],
      },
    ],
    caption:
      `First and last bar: the ring at ${hoursText(first.hours)} and ${hoursText(last.hours)}. Between them the ` +
      'first ring with only the face, only the roughness or only the shear strength of the last one. The parts ' +
      'do not add up: asperities share their load with the film.',
  };
}
