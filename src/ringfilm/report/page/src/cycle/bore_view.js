// The drawing of the ring in its bore on the page: case and crank angle as the reader picks them.
import { boreSvg, enlargement } from './bore_drawing.js';
import { element, onNewWidth, svgElement } from '../dom.js';
import { fileStem, save, savePng } from '../downloads.js';
import { angleInWords, number, wrapped } from '../units.js';

const kSaved = 900;

export class BoreView {
  /** @param one a case with a bore that is not round: { name, data, peakAngle } */
  constructor(model, one, context) {
    Object.assign(this, { data: one.data, context });
    const { data } = this;
    // On the axis of the charts, whatever the order in the file.
    this.order = data.stripAngles
      .map((_, k) => k)
      .sort((a, b) => wrapped(data.stripAngles[a]) - wrapped(data.stripAngles[b]));
    this.host = element('div', { class: 'bore-drawing', role: 'img' });
    this.print = element('div', { class: 'print-only' });
    this.slider = element('input', {
      type: 'range',
      min: 0,
      max: this.order.length - 1,
      step: 1,
      value: this.nearest(one.peakAngle ?? 0),
      id: 'bore-angle',
      'aria-label': 'crank angle of the ring in its bore',
      oninput: () => {
        this.show(Number(this.slider.value));
        context.group.point(wrapped(this.angle));
      },
    });
    this.angleText = element('output', { for: 'bore-angle' });
    context.group.followers.push((angle) => this.follow(angle));
    const name = model.several ? `, ${one.name}` : '';
    this.title = `The ring in its bore${name}`;
    this.node = element(
      'figure',
      { id: 'ring-in-bore', class: 'figure' },
      element('div', { class: 'figure-heading' }, element('h3', {}, this.title), this.downloads()),
      element(
        'div',
        { class: 'slider' },
        element('label', { for: 'bore-angle' }, 'Crank angle'),
        this.slider,
        this.angleText,
      ),
      element('div', { class: 'panels' }, this.host),
      this.print,
      element(
        'figcaption',
        {},
        'Bore and face of the ring, their deviations from a circle enlarged ' +
          `${number(enlargement(data), 3)} times over the bore (scale in the middle), the same at all ` +
          'crank angles; dashed the round bore. Between them the smallest film thickness of each strip, ' +
          'orange where the ring is lifted off: where it carries less than a tenth of what presses it on. ' +
          'Loads and friction per length around the ring; next to its ends they may exceed the scale.',
      ),
    );
  }

  nearest(angle) {
    const off = (k) => Math.abs(wrapped(this.data.stripAngles[k]) - angle);
    return this.order.reduce((best, k, at) => (off(k) < off(this.order[best]) ? at : best), 0);
  }

  follow(angle) {
    const at = this.nearest(angle);
    if (at === Number(this.slider.value) || this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.slider.value = at;
      this.show(at);
    });
  }

  show(at) {
    this.k = this.order[at];
    this.angle = this.data.stripAngles[this.k];
    const words = angleInWords(this.angle);
    this.angleText.textContent = words.replace(/^at /, '');
    this.slider.setAttribute('aria-valuetext', words);
    this.host.setAttribute('aria-label', `${this.title} ${words}`);
    const width = Math.max(280, this.host.clientWidth);
    this.host.replaceChildren(svgElement(boreSvg(this.data, this.k, width)));
  }

  start() {
    this.show(Number(this.slider.value));
    onNewWidth(this.node, () => this.show(Number(this.slider.value)));
  }

  saved() {
    const title = `${this.title} ${angleInWords(this.angle)}`;
    return boreSvg(this.data, this.k, kSaved, { title, subtitle: this.context.subtitle });
  }

  downloads() {
    const name = (ending) => `${fileStem(this.context.stem, 'ring-in-bore')}.${ending}`;
    const button = (label, action) =>
      element(
        'button',
        { type: 'button', class: 'download', 'aria-label': `Ring in its bore as ${label}`, onclick: action },
        label,
      );
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), this.saved())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', this.saved())),
    );
  }

  beforePrint() {
    this.print.replaceChildren(svgElement(boreSvg(this.data, this.k, kSaved)));
  }
}
