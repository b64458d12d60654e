// The payload of a study made handy.
import { display, withUnit } from '../units.js';

export class StudyModel {
  constructor(payload) {
    Object.assign(this, payload);
    this.quantity = new Map(
      [...payload.quantities, ...payload.page_quantities].map((q) => [q.name, { ...q, ...shownAs(q) }]),
    );
    this.factors = payload.factors.map((f, index) => ({ ...f, ...shownAs(f), index }));
    this.bases = payload.bases.map((b, index) => ({ ...b, index }));
    this.several = this.bases.length > 1;
    this.mainValues = payload.main_values.map((name) => this.quantity.get(name));
    this.solved = this.scenarios - this.unsolved.count;
  }

  /** A value of a quantity as text, with its unit. */
  valueText(quantity, value, digits = 4) {
    return withUnit(quantity.convert(value ?? null), quantity.shown, digits);
  }

  /** Interval [value, low, high] in the unit that people read. */
  interval(quantity, triple) {
    return triple ? triple.map((v) => quantity.convert(v)) : [null, null, null];
  }

  /** The level of a factor as text: a number with its unit, or the words of a choice. */
  levelText(factor, level) {
    if (level === null) return 'as in the base';
    if (factor.choices.length) return shortChoice(factor.choices[level]);
    return shortWithUnit(factor.convert(level), factor.shown);
  }

  /** "1024 scenarios" */
  counted(n) {
    return `${count(n)} ${n === 1 ? 'scenario' : 'scenarios'}`;
  }
}

/** Up to four digits, without idle zeros. */
export function short(v) {
  return String(Number(v.toPrecision(4))).replace(/^-/, '−');
}

/** "1 048 576" */
export function count(n) {
  return String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f');
}

export function shortWithUnit(v, unit) {
  return unit ? `${short(v)}\u00a0${unit}` : short(v);
}

function shownAs(described) {
  const { unit, convert } = display(described);
  // Text in brackets is reported once, where the word is explained.
  return {
    short_name: (described.long_name ?? described.name).replace(/ \(.*\)$/, ''),
    shown: described.unit ? unit : '',
    convert,
  };
}

/** "sae-30" of "../../data/lubricants/sae-30.toml" */
export function shortChoice(text) {
  return text
    .split(/[/\\]/)
    .pop()
    .replace(/\.toml$/, '');
}
