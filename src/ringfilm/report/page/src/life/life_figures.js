// Values over the running time, on a linear and a logarithmic axis, and what each part of the ring changes.
import { kOnlyCase } from '../model.js';
import { display } from '../units.js';
import { hoursText } from './life_words.js';

/** Quantities that have a figure, the most important first. */
const kDrawn = [
  'mean_power_loss',
  'mean_absolute_oil_flow',
  'fmep',
  'lambda_ratio_at_peak_pressure',
  'min_film_thickness',
  'peak_friction_coefficient_firing',
  'mixed_share',
  'worn_area',
  'largest_worn_depth',
];

const kParts = [
  ['face', 'face'],
  ['roughness', 'roughness'],
  ['shear_strength', 'shear strength'],
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

function seriesOf(life, described, convert, place) {
  const { name } = described;
  const x = life.states.map((state) => place(state.hours));
  const values = (from) => life.states.map((state) => convert(from(state)));
  const measured = life.states.filter((state) => state.standing === 'measured');
  const band = bandOf(life, described, convert);
  const wears = life.mode === 'archard';
  const all = [
    {
      caseIndex: kOnlyCase,
      part: null,
      label: wears ? 'scenario' : 'interpolated',
      x,
      y: values((state) => state[name]),
      bands: band ? [band] : [],
    },
  ];
  if (life.states.every((state) => state.turned && name in state.turned)) {
    all.push({
      caseIndex: null,
      part: 'boundary',
      label: 'ring turned over',
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
    yLabel: described.long_name,
    yUnit: unit,
    fromZero: true,
    series: seriesOf(life, described, convert, isLog ? afterOneHour : (hours) => hours),
  };
}

export function figuresOverHours(life) {
  const isKnown = (state, name) => typeof state[name] === 'number';
  return kDrawn
    .filter((name) => life.states.every((state) => isKnown(state, name)))
    .map((name, k) => {
      const described = life.quantities.find((quantity) => quantity.name === name);
      const scales = life.states.length > 1 ? ['linear', 'log'] : ['linear'];
      const known =
        life.mode === 'archard'
          ? life.wear.fit
            ? 'A scenario, not a prediction: the line has the geometric mean of the coefficients that the measured ' +
              'faces allow, the band has both ends of their range.'
            : 'A scenario with a given wear coefficient, not a prediction. A dashed line is the ring turned over.'
          : 'Dots: measured states. The line between them is interpolated; the band covers other time constants and ' +
            'an interpolation that is linear in time. The dashed line is the ring turned over: which edge was ' +
            'the chamber edge is not known from the faces.';
      return {
        id: `hours-${name.replace(/_/g, '-')}`,
        title: `${described.long_name[0].toUpperCase()}${described.long_name.slice(1)}`,
        layout: 'row',
        panels: scales.map((scale) => panelOf(life, described, scale)),
        caption:
          k === 0
            ? `${known} Left: linear in time; right: logarithmic, with the start at 1 h.`
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
