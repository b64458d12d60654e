// What stays the same on every page of a life: words for how a number is known, and what would tell more.
import { element } from '../dom.js';

export const kStandings = {
  measured: 'measured state',
  interpolated: 'interpolated between measured states',
  held: 'held after the last measured state: assumed',
  scenario: 'scenario: tuned or assumed coefficient',
};

const kMeasurements = [
  ['mass of the ring before and after', 'worn area, which faces alone leave open by a factor of forty'],
  ['radial thickness at three places', 'worn depth, without the mass'],
  ['direction of the scan and a reference on the flank', 'orientation and tilt of the face'],
  ['the same ring before and after', 'wear apart from the scatter between rings'],
  ['roughness of the liner at each state', 'which of the two surfaces became smoother'],
  ['boundary shear strength under oil with additives', 'friction apart from the dry reference'],
];

export function whatToMeasure() {
  return element(
    'ul',
    {},
    kMeasurements.map(([what, why]) => element('li', {}, element('b', {}, what), `: ${why}`)),
  );
}
