// The numbers on the first screen of a study.
import { element } from '../dom.js';
import { card, cardRow, cardValue } from '../page_head.js';
import { caseColour } from '../plot/palette.js';
import { number } from '../units.js';

/** The values on the first screen. */
const kCards = ['fmep', 'mean_power_loss', 'min_film_thickness'];

/** These values; a study without one of them has its first main values instead. */
export function cardValues(model) {
  if (kCards.every((name) => model.quantity.has(name))) return kCards;
  return model.main_values.slice(0, kCards.length);
}

export function swatch(base) {
  return element('span', { class: 'base-swatch', style: `background: ${caseColour(base)}` });
}

/**
 * What a card has on a value of a base: { value, detail }. A sample has the median and its range, operating
 * points their weighted mean, any other plan the range, each with the scenarios of its ends, since a median of
 * chosen points means nothing.
 */
export function cardTexts(model, name, base) {
  const q = model.quantity.get(name);
  const s = model.statistics[name][base];
  if (!s) return { value: null, detail: 'not solved' };
  const shown = (v) => number(q.convert(v), 3);
  if (model.has_sample) {
    const [low, , middle, , high] = s.quantiles.map(([v]) => v);
    return { value: shown(middle), detail: `${shown(low)} to ${shown(high)}` };
  }
  const at = model.extremes[name]?.[base];
  if (model.points.length) {
    const ends = ['lowest', 'highest']
      .map((end) => `${end} ${shown(s[end])}${at ? `, ${at[end]}` : ''}`)
      .join('; ');
    return s.weighted_mean === null
      ? { value: null, detail: `a point was not solved; ${ends}` }
      : { value: shown(s.weighted_mean), detail: ends };
  }
  const [low, high] = [shown(s.lowest), shown(s.highest)];
  if (low === high) return { value: low, detail: 'in all scenarios' };
  return { value: `${low} to ${high}`, detail: at ? `lowest at ${at.lowest}; highest at ${at.highest}` : '' };
}

export function studyCard(model, name) {
  const q = model.quantity.get(name);
  const rows = model.bases.map((b) => {
    const { value, detail } = cardTexts(model, name, b.index);
    const after = q.shown && value !== null ? ` ${q.shown}` : '';
    return cardRow(model.several ? [swatch(b.index), b.name] : null, cardValue(value ?? '–', after), detail);
  });
  return card(q.short_name, rows);
}

/** What the numbers on the cards are. */
export function cardsSentence(model) {
  if (model.has_sample) return 'Median, and 5 % to 95 % of the scenarios.';
  return model.points.length
    ? 'Weighted mean of the operating points, and where the value is lowest and highest.'
    : 'Lowest and highest of the scenarios, and where they are.';
}
