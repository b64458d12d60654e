// What stays the same on every page of a life: words for how a number is known, and which measurements would help.
import { element } from '../dom.js';
import { table } from '../tables.js';
import { number } from '../units.js';

/** A running time as texts show it: "150 h". */
export const hoursText = (hours) => `${Number(number(hours, 4))} h`;

export const kStateOrigins = {
  measured: 'measured state',
  interpolated: 'interpolated between measured states',
  held: 'held after the last measured state: assumed',
  scenario: 'scenario: tuned or assumed coefficient',
};

/** How the curve of a life is known, as its legend states it. */
export const curveOrigin = (life) =>
  life.mode !== 'archard'
    ? 'interpolated'
    : life.wear.coefficient_origin === 'tuned'
      ? 'scenario: tuned to the faces'
      : 'scenario: assumed';

const kMeasurements = [
  ['mass of the ring before and after', 'worn area, which faces alone leave open by a factor of forty'],
  ['radial thickness at three places', 'worn depth, without the mass'],
  ['direction of the scan and a reference on the flank', 'orientation and tilt of the face'],
  ['the same ring before and after', 'wear apart from the scatter between rings'],
  ['roughness of the liner at each state', 'which of the two surfaces became smoother'],
  ['boundary shear strength under oil with additives', 'friction apart from the dry reference'],
];

/** Wear that was published elsewhere, for its magnitude alone. */
export function publishedWear() {
  return table(
    'Published wear, magnitude only',
    ['what', 'readings', 'wear'],
    [
      [
        'cylinder liners of 32 marine engines',
        '64',
        '0.38 to 2.95 mm per 10 000 h, mean 1.10; other loads, speeds and fuels: no coefficient follows from it',
      ],
    ],
    { folds: true },
  );
}

export function whatToMeasure() {
  return element(
    'ul',
    {},
    kMeasurements.map(([what, why]) => element('li', {}, element('b', {}, what), `: ${why}`)),
  );
}
