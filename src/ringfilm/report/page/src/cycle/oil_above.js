// The oil that a ring leaves on the liner above it.
import { converted, withUnit } from '../units.js';

const mean = (list) => list.reduce((sum, v) => sum + v, 0) / list.length;

/**
 * Mean film on the liner behind a ring on its two downstrokes { film } [µm], as the gas path defines it for the first
 * ring of a pack; null where the oil on the liner is not followed.
 */
export function oilAbove(c) {
  const { film_behind_power: power, film_behind_intake: intake } = c.stroke;
  if (!c.complete || !(power?.length > 0) || !(intake?.length > 0)) return null;
  return { film: converted((mean(power) + mean(intake)) / 2, 'um') };
}

/** Less oil is not distinguished [mg]. */
const kLeastMass = 1e-3;

/** A mass of oil in mg as text. @param kilograms null where it is not known */
export function massText(kilograms) {
  const mass = converted(kilograms, 'mg');
  return mass > 0 && mass < kLeastMass ? `below ${kLeastMass}\u00a0mg` : withUnit(mass, 'mg', 3);
}
