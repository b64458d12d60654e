// Material that a ring has lost: what a scenario gives, what measured faces allow, and their lower bounds.
import { element } from '../dom.js';
import { slider } from '../figure/choices.js';
import { right, table } from '../tables.js';
import { converted, display, inDegrees, number, withUnit } from '../units.js';
import { hoursText } from './life_words.js';

const area = (value) => right(withUnit(converted(value, 'um mm'), 'µm mm', 3));
const depth = (value) => right(withUnit(converted(value, 'um'), 'µm', 3));
const ends = (pair, unit) => right(pair ? `${number(pair[0], 3)} to ${withUnit(pair[1], unit, 3)}` : '–');

export function wornTable(life) {
  const known = life.worn_quantities
    .filter(({ name }) => name in life.states[0])
    .map(({ name, heading }) => ({
      name,
      heading,
      ...display(life.quantities.find((quantity) => quantity.name === name)),
    }));
  const banded = known.filter(({ name }) => life.states.some((state) => state.band?.[name]));
  return table(
    'Material lost since the start',
    [
      'running time',
      ...known.map(({ heading }) => right(heading)),
      ...banded.map(({ heading }) => right(`${heading}, band`)),
    ],
    life.states.map((state) => [
      hoursText(state.hours),
      ...known.map(({ name, unit, convert }) => right(withUnit(convert(state[name]), unit, 3))),
      ...banded.map(({ name, unit, convert }) => ends(state.band?.[name]?.map(convert), unit)),
    ]),
    { folds: true },
  );
}

const trusted = (margin) =>
  margin > 0 ? `without ${number(converted(margin, 'mm'), 2)} mm at each edge` : 'whole width';

const basisOf = (row) =>
  row.basis === 'least-wear'
    ? `least wear, ${trusted(row.untrusted_margin)}`
    : `closest face within ${number(converted(row.half_width, 'mm'), 2)} mm of the middle`;

function coefficientText(row) {
  if (row.coefficient !== null) return `${row.coefficient.toExponential(1)} m²/N`;
  return row.face_is_flat ? 'not determined: the face is flat' : 'not determined';
}

/** The range of coefficients, never one. */
export function fitTable(fit) {
  const [low, high] = fit.coefficient.map((value) => value.toExponential(1));
  return [
    element(
      'p',
      {},
      `The measured faces allow mean coefficients from ${low} to ${high} m²/N. No single one follows from them.`,
    ),
    table(
      'Wear coefficients that the measured faces allow',
      ['fitted to', 'up to', right('worn area'), right('rms distance left'), right('mean coefficient')],
      fit.rows.map((row) => [
        basisOf(row),
        hoursText(row.hours),
        area(row.worn_area),
        row.rms === undefined ? right('–') : depth(row.rms),
        right(coefficientText(row)),
      ]),
      { folds: true },
    ),
  ];
}

function boundsAt(states, k) {
  return table(
    'Least wear since the first state',
    ['measured state', right('worn area'), right('largest depth'), right('in the middle'), right('tilt')],
    states.map((state) => {
      const bound = state.least_wear[k];
      return [
        hoursText(state.hours),
        area(bound.worn_area),
        depth(bound.largest_worn_depth),
        depth(bound.depth_at_middle),
        right(`${number(60 * inDegrees(bound.tilt), 2)}′`),
      ];
    }),
    { folds: true },
  );
}

/** Lower bounds of wear at the measured states, by how much of the width is trusted; null where there are none. */
export function leastWear(life) {
  const states = life.states.filter((state) => state.least_wear);
  if (states.length === 0) return null;
  const margins = states[0].least_wear.map((bound) => bound.untrusted_margin);
  const words = (k) => trusted(margins[k]);
  const place = element('div', {}, boundsAt(states, 0));
  const { input, output, label } = slider(
    'trusted-width',
    'Trusted width: ',
    'how much of the width of the faces is trusted',
    margins.length,
    0,
    (k) => {
      output.textContent = words(k);
      place.replaceChildren(boundsAt(states, k));
    },
  );
  output.textContent = words(0);
  return [
    element(
      'p',
      {},
      'Faces are known up to an offset and a tilt. If material only disappears, at least this was lost; more is ' +
        'always possible. Where most of it lies at the edges, it rests on the chamfers of the scans.',
    ),
    element('p', {}, label, input, ' ', output),
    place,
  ];
}
