// The values of the gas of a pack in the units in which they are read.
import { display, withUnit } from '../units.js';

/** A sum of the gas over a cycle, in its unit of display. */
export function gasSum(gas, name) {
  const { unit, convert } = display(gas.quantities.sums.find((quantity) => quantity.name === name));
  return { value: convert(gas[name]), unit };
}

export function gasValue(gas, name) {
  const { value, unit } = gasSum(gas, name);
  return withUnit(value, unit, 3);
}

/** What blow-by by volume refers to. */
export const kStandard = 'at 1.01325 bar and 25 °C';

/** Blow-by of one cylinder, by mass and by volume. */
export const kBlowBy = { mass: 'blow_by_per_cycle', flow: 'blow_by_flow' };

/** "2.23 mg per cycle, 1.41 l/min at 1.01325 bar and 25 °C", of one cylinder. */
export function blowByWords(gas) {
  return `${gasValue(gas, kBlowBy.mass)} per cycle, ${gasValue(gas, kBlowBy.flow)} ${kStandard}`;
}

/** A mass below this share of the largest one is rounding of the quadrature along the paths. */
const kRounding = 1e-9;

/** The paths with 0 for masses that are rounding. */
export function withoutRounding(paths) {
  const masses = (path) => Object.entries(path).filter(([name]) => name !== 'name');
  const largest = Math.max(...paths.flatMap((path) => masses(path).map(([, mass]) => Math.abs(mass))));
  const shown = ([name, mass]) => [name, Math.abs(mass) < kRounding * largest ? 0 : mass];
  return paths.map((path) => ({ name: path.name, ...Object.fromEntries(masses(path).map(shown)) }));
}
