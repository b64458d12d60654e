// Whether a result is usual: published ranges, as docs/manual/guide/plausibility.md argues them.
import { element } from '../dom.js';
import { number } from '../units.js';

/** Friction mean effective pressure of one compression ring [kPa]. */
export const kUsualFmep = { low: 1, high: 20, engine: 'car' };
/** The same of a diesel engine, whose peak pressures are about twice as high. */
export const kUsualDieselFmep = { low: 2, high: 40, engine: 'diesel' };
/** A larger bore [mm], or a higher peak pressure [bar], is that of a diesel engine. */
export const kLargestCarBore = 100;
export const kHighestCarPeak = 120;
/** Boundary friction in engine oil with anti-wear additive. */
export const kUsualCoefficient = { low: 0.08, high: 0.15 };
/** The lowest with a friction modifier (MoDTC). */
export const kModifiedCoefficient = 0.03;

/** From this share of the upper limit on a value is at the upper end of its range. */
const kUpperEnd = 0.75;

/** 'below', 'usual', 'upper end' or 'above'; null without a value. */
export function verdict(value, { low, high }) {
  if (value === null || value === undefined || !Number.isFinite(value)) return null;
  if (value < low) return 'below';
  if (value > high) return 'above';
  return value > kUpperEnd * high ? 'upper end' : 'usual';
}

const kWords = {
  below: 'not usual: below',
  usual: 'usual: within',
  'upper end': 'usual, at the upper end of',
  above: 'not usual: above',
};

/** The range of FMEP of the engine of a case, by its bore and peak pressure, and in words by which of them. */
export function fmepRange(model, c) {
  const bore = (model.input(c, 'engine.bore')?.value_si ?? 0) * 1e3;
  const peak = (c.values.peak_gas_pressure ?? 0) / 1e5;
  const reasons = [
    bore > kLargestCarBore ? `a bore of ${number(bore, 3)} mm` : null,
    peak > kHighestCarPeak ? `a peak pressure of ${number(peak, 3)} bar` : null,
  ].filter(Boolean);
  return reasons.length
    ? { ...kUsualDieselFmep, reason: `, for ${reasons.join(' and ')}` }
    : { ...kUsualFmep, reason: '' };
}

/** @returns { value, found, text } on the FMEP of a case, null without a cycle */
export function fmepVerdict(model, c) {
  const { value, unit } = model.value(c, 'fmep');
  const range = fmepRange(model, c);
  const found = verdict(value, range);
  if (!found) return null;
  return {
    found,
    value: `${number(value, 3)} ${unit}`,
    text:
      `${kWords[found]} ${range.low} to ${range.high} kPa of one compression ring of a ${range.engine} engine` +
      range.reason,
  };
}

/** The same on the boundary friction coefficient that the case states. */
export function coefficientVerdict(model, c) {
  const value = model.input(c, 'contact.boundary_shear_strength_coefficient')?.value_si;
  const found = verdict(value, { low: kModifiedCoefficient, high: kUsualCoefficient.high });
  if (!found) return null;
  const range = `${kUsualCoefficient.low} to ${kUsualCoefficient.high}`;
  const of =
    value < kUsualCoefficient.low
      ? `${kModifiedCoefficient} to ${kUsualCoefficient.low} of oil with friction modifier`
      : `${range} of engine oil`;
  return {
    found,
    value: number(value, 3),
    text:
      `${kWords[found === 'upper end' ? 'usual' : found]} ${of}` +
      (found === 'above' ? '; a dry value: boundary friction is proportional to it' : ''),
  };
}

/** The lines on the first screen that state whether the results are usual; null where nothing can be stated. */
export function usualCard(model) {
  const line = (label, one) => {
    const found = model.cases.map((c) => ({ c, ...one(model, c) })).filter((entry) => entry.found);
    const texts = [...new Set(found.map((entry) => `${entry.value}: ${entry.text}`))];
    return texts.map((shown) => {
      const whose = found.filter((entry) => `${entry.value}: ${entry.text}` === shown);
      const { found: kind, value, text } = whose[0];
      return element(
        'li',
        { class: ['above', 'below'].includes(kind) ? 'unusual' : 'usual' },
        whose.length < model.cases.length ? `${whose.map(({ c }) => c.name).join(', ')}: ` : null,
        `${label} `,
        element('b', {}, value),
        ` – ${text}`,
      );
    });
  };
  const lines = [line('FMEP', fmepVerdict), line('boundary friction coefficient', coefficientVerdict)].flat();
  if (lines.length === 0) return null;
  return element(
    'section',
    { class: 'plausibility' },
    element('h2', {}, 'Is it usual?'),
    element('ul', {}, lines),
    element(
      'p',
      { class: 'how' },
      'Ranges and their sources: page "Is my result usual?" of the manual. A usual result is not a ' +
        'validated one.',
    ),
  );
}
