// Settings of the ledger in words: contact.integrals = "polynomial-4-digit" is the spelling of a case file.
import { typeset } from '../units.js';

const kKeys = {
  'gas.pressure_behind_ring': 'share of the gas pressure behind the ring',
  'gas.crankcase_pressure': 'pressure below the ring',
  'operating.oil_temperature': 'oil temperature',
  'contact.composite_modulus': 'composite modulus',
  'contact.integrals': 'contact integrals',
  'contact.lambda_ratio': 'lambda ratio of the contact',
  'contact.roughness_measure': 'roughness measure',
  'ring.elastic_pressure': 'elastic pressure of the ring',
  'ring.face.orientation': 'orientation of the face',
  'film.cavitation': 'cavitation model',
  'film.cavitation_pressure': 'cavitation pressure',
  'lubricant.viscosity_pressure': 'viscosity against pressure',
  'lubricant.compressibility': 'density against pressure',
};

const kValues = {
  'polynomial-4-digit': 'polynomials of four digits',
  'polynomial-as-printed': 'polynomials as printed',
  'ra-to-rq': 'Ra converted to Rq',
  'x0-chamber': 'x = 0 at the chamber',
  'x0-crankcase': 'x = 0 at the crankcase',
  'leading-edge': 'x = 0 at the leading edge',
  'reynolds-exit': 'Reynolds exit',
  nominal: 'of the thinnest film',
  none: 'no dependence',
  barus: 'Barus',
  roelands: 'Roelands',
};

/** "contact integrals: polynomials of four digits"; other keys by their last part. */
export function settingWords(setting) {
  const found = /^([\w.]+) = "?(.*?)"?$/.exec(setting);
  if (!found) return setting;
  const [, key, value] = found;
  const name = kKeys[key] ?? key.split('.').pop().replace(/_/g, ' ');
  return `${name}: ${kValues[value] ?? typeset(value)}`;
}
