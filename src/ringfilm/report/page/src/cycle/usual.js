// Whether a result is usual: published ranges, as docs/manual/guide/plausibility.md argues them.
import { element } from '../dom.js';
import { converted, number } from '../units.js';

/** Usual friction mean effective pressure in the engine of a car [kPa], by the kind of ring and of the pack. Those of a
 * diesel engine are kDieselFactor times as high, as gas loads are; an oil ring has none, and its range goes with the
 * bore (`diesel`). */
export const kUsualFmep = {
  top: { low: 1, high: 20, words: 'a top ring' },
  second: { low: 0.5, high: 8, words: 'a second compression ring' },
  oil: { low: 1, high: 12, words: 'an oil ring', diesel: { low: 0.5, high: 7 } },
  pack: { low: 4, high: 40, words: 'a ring pack' },
};
/** Peak pressures and ranges of a diesel engine are about so many times those of a car. */
export const kDieselFactor = 2;
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

/** The range of FMEP of a kind in the engine of a case, by its bore and peak pressure, and in words by which. */
export function fmepRange(model, c, kind) {
  const { low, high, words, diesel } = kUsualFmep[kind];
  const bore = converted(model.input(c, 'engine.bore')?.value_si ?? 0, 'mm');
  const peak = converted(c.values.peak_gas_pressure ?? 0, 'bar');
  const reasons = [
    bore > kLargestCarBore ? `a bore of ${number(bore, 3)} mm` : null,
    peak > kHighestCarPeak && !diesel ? `a peak pressure of ${number(peak, 3)} bar` : null,
  ].filter(Boolean);
  return reasons.length
    ? {
        low: diesel ? diesel.low : kDieselFactor * low,
        high: diesel ? diesel.high : kDieselFactor * high,
        words: `${words} of a diesel engine, for ${reasons.join(' and ')}`,
      }
    : { low, high, words: `${words} of a car engine` };
}

/** @param values in SI @param range of fmepRange() @returns { value, found, text } of an FMEP; null without a cycle */
export function fmepVerdict(model, values, range) {
  const { value, unit } = model.value({ values }, 'fmep');
  const found = verdict(value, range);
  if (!found) return null;
  return {
    found,
    value: `${number(value, 3)} ${unit}`,
    text: `${kWords[found]} ${range.low} to ${range.high} kPa of ${range.words}`,
  };
}

/** The kind of a ring by its place in its pack. */
function kindOf(model, c, place) {
  if (model.input(c, 'ring.kind')?.shown === 'oil') return 'oil';
  return place === 1 ? 'top' : 'second';
}

/** Verdicts on the FMEP of all rings, rails of an oil ring together, and of packs: { name, ... } of fmepVerdict(). */
export function fmepVerdicts(model) {
  const inPacks = new Set(
    (model.payload.packs ?? []).flatMap((pack) => pack.ring_numbers.map((_, i) => pack.first_case + i)),
  );
  const alone = model.cases
    .filter((c) => !inPacks.has(c.index))
    .map((c) => ({
      name: c.name,
      ...fmepVerdict(model, c.values, fmepRange(model, c, kindOf(model, c, 1))),
    }));
  const packed = model.packs.flatMap((pack) => {
    const faces = model.cases.slice(pack.first_case, pack.first_case + pack.ring_numbers.length);
    const before = model.packs.length > 1 ? `${pack.name}, ` : '';
    return [
      ...pack.by_ring.map(({ ring, values }) => {
        const face = faces[pack.ring_numbers.indexOf(ring)];
        // The peak of the cylinder, which the first ring has above it, decides on the engine.
        const range = fmepRange(model, { ...face, values: faces[0].values }, kindOf(model, face, ring));
        return { name: `${before}ring ${ring}`, ...fmepVerdict(model, values, range) };
      }),
      { name: `${before}pack`, ...fmepVerdict(model, pack.values, fmepRange(model, faces[0], 'pack')) },
    ];
  });
  return [...alone, ...packed].filter(({ found }) => found);
}

/** Verdict on the boundary friction coefficient that the case states. */
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

function usualLine(label, { found, value, text }, whom) {
  return element(
    'li',
    { class: ['above', 'below'].includes(found) ? 'unusual' : 'usual' },
    whom ? `${whom}: ` : null,
    `${label} `,
    element('b', {}, value),
    ` – ${text}`,
  );
}

/** The lines on the first screen that state whether the results are usual; null where nothing can be stated. */
export function usualCard(model) {
  const coefficients = model.cases
    .map((c) => ({ name: c.name, ...coefficientVerdict(model, c) }))
    .filter((entry) => entry.found);
  const alike = (entry) => coefficients.filter((one) => one.value === entry.value && one.text === entry.text);
  const lines = [
    ...fmepVerdicts(model).map((entry) => usualLine('FMEP', entry, model.several ? entry.name : '')),
    ...coefficients
      .filter((entry) => alike(entry)[0] === entry)
      .map((entry) => {
        const whose = alike(entry).map(({ name }) => name);
        return usualLine(
          'boundary friction coefficient',
          entry,
          whose.length < model.cases.length ? whose.join(', ') : '',
        );
      }),
  ];
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
