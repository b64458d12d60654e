// What a reader chooses with: lists, buttons of which one is pressed, a slider over crank angles.
import { element } from '../dom.js';
import { angleInWords, nearestAngle, wrapped } from '../units.js';

/** A labelled list to choose from. @param options [value, words] */
export function picker(label, options, chosen, act, attributes = {}) {
  const list = element(
    'select',
    { ...attributes, onchange: () => act(list.value) },
    options.map(([value, words]) =>
      element('option', { value, selected: String(value) === String(chosen) }, words),
    ),
  );
  return element('label', { class: 'choice' }, label, ' ', list);
}

/** Buttons of which one is pressed. @param options [words, value] */
export function buttons(label, options, chosen, act) {
  const list = options.map(([words, value]) =>
    element(
      'button',
      {
        type: 'button',
        class: 'range',
        'aria-pressed': String(value === chosen),
        onclick: () => {
          list.forEach((button, n) => button.setAttribute('aria-pressed', String(options[n][1] === value)));
          act(value);
        },
      },
      words,
    ),
  );
  return element('span', { class: 'tools', role: 'group', 'aria-label': label }, list);
}

/** A slider over a list of things. @param spoken its name @param act is called with the index */
export function slider(id, label, spoken, count, index, act) {
  const input = element('input', {
    type: 'range',
    id,
    min: 0,
    max: count - 1,
    step: 1,
    value: index,
    'aria-label': spoken,
    oninput: () => act(Number(input.value)),
  });
  const output = element('output', { for: id });
  return { input, output, label: element('label', { for: id }, label) };
}

/** The crank angle of a figure: that of its slider, or under the cursor of the charts over the cycle. */
export class AngleSlider {
  /**
   * @param angles in any order @param at where it begins
   * @param group charts whose cursors it moves and follows, or null
   * @param show draws the figure anew @param isFree may the cursor move it?
   */
  constructor({ id, spoken, angles, at, group = null, show, more = [], isFree = () => true }) {
    Object.assign(this, { group, show, isFree });
    this.setAngles(angles, at);
    const parts = slider(id, 'Crank angle', spoken, angles.length, this.index, (index) => this.choose(index));
    Object.assign(this, parts);
    this.node = element('div', { class: 'slider' }, parts.label, parts.input, parts.output, more);
    this.write();
    group?.followers.push((angle) => this.follow(angle));
  }

  /** On the axis of the charts, whatever the order in the file. */
  setAngles(angles, at) {
    this.order = angles.map((_, k) => k).sort((a, b) => wrapped(angles[a]) - wrapped(angles[b]));
    this.angles = this.order.map((k) => wrapped(angles[k]));
    this.index = Math.max(0, nearestAngle(this.angles, at ?? 0));
    if (!this.input) return;
    this.input.max = angles.length - 1;
    this.write();
  }

  get angle() {
    return this.angles[this.index];
  }

  /** Number of the angle in the list that was given. */
  get k() {
    return this.order[this.index];
  }

  /** "20° after firing TDC" */
  get words() {
    return angleInWords(this.angle);
  }

  /** Shows the angle that the reader picked, here and under the cursors of the charts. */
  choose(index) {
    this.set(index);
    this.group?.point(this.angle);
  }

  /** Shows the angle nearest to that under a cursor, once a frame. */
  follow(angle) {
    if (!this.isFree()) return;
    const isWaiting = this.next !== undefined;
    this.next = nearestAngle(this.angles, angle);
    if (isWaiting || this.next === this.index) return;
    requestAnimationFrame(() => {
      if (this.next !== this.index) this.set(this.next);
      this.next = undefined;
    });
  }

  set(index) {
    this.index = index;
    this.write();
    this.show();
  }

  write() {
    this.input.value = this.index;
    this.output.textContent = this.words.replace(/^at /, '');
    this.input.setAttribute('aria-valuetext', this.words);
  }
}
