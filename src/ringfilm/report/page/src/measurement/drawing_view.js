// A drawn figure on the page: heading, what the reader may choose, drawing, caption, files to take away.
import { element, onNewWidth, svgElement } from '../dom.js';
import { columnsCsv, fileStem, save, savePng } from '../downloads.js';
import { document as svgDocument } from '../plot/plot_frame.js';
import { typeset } from '../units.js';

const kPrinted = { half: 450, whole: 900 };
const kSaved = 900;

export class DrawingView {
  /**
   * @param figure id, title, caption() and columns() of the present choice, draw(width) to { shapes, height
   * }, half:
   * two of them side by side on paper, at(x, y, width): what lies under the pointer, in words
   * @param choices nodes with which the reader chooses; call `redraw` when they change
   */
  constructor(figure, context, choices = []) {
    Object.assign(this, { figure, context });
    this.host = element('div', { class: 'drawing', role: 'img', 'aria-label': figure.title });
    this.print = element('div', { class: 'print-only' });
    this.caption = element('figcaption');
    this.readOut = figure.at ? element('div', { class: 'map-value' }) : null;
    this.node = element(
      'figure',
      { id: figure.id, class: `figure ${figure.half ? 'half' : ''}` },
      element('div', { class: 'figure-heading' }, element('h3', {}, figure.title), this.downloads()),
      choices.length ? element('div', { class: 'choices' }, choices) : null,
      element('div', { class: 'panels' }, this.host, this.readOut),
      this.print,
      this.caption,
    );
    if (figure.at) {
      this.host.addEventListener('pointermove', (event) => this.pointed(event));
      this.host.addEventListener('pointerleave', () => this.readOut.replaceChildren());
    }
  }

  downloads() {
    const name = (ending) => `${fileStem(this.context.stem, this.figure.id)}.${ending}`;
    const button = (label, action) =>
      element(
        'button',
        {
          type: 'button',
          class: 'download',
          'aria-label': `${this.figure.title} as ${label}`,
          onclick: action,
        },
        label,
      );
    const svg = () => this.svg(kSaved, this.context.subtitle);
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), svg())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', svg())),
      button('CSV', () => save(name('csv'), 'text/csv', columnsCsv(this.figure.columns()))),
    );
  }

  svg(width, subtitle) {
    return svgDocument(this.figure.draw(width), width, { title: this.figure.title, subtitle });
  }

  start() {
    this.redraw();
    onNewWidth(this.node, () => this.redraw());
  }

  redraw() {
    this.drawnWidth = Math.max(280, this.host.clientWidth || this.node.clientWidth);
    this.host.replaceChildren(svgElement(svgDocument(this.figure.draw(this.drawnWidth), this.drawnWidth)));
    const caption = typeset(this.figure.caption());
    this.caption.textContent = caption;
    this.host.setAttribute('aria-label', `${this.figure.title}. ${caption}`);
  }

  pointed(event) {
    const box = this.host.firstElementChild.getBoundingClientRect();
    const scale = this.drawnWidth / box.width;
    const found = this.figure.at(
      (event.clientX - box.left) * scale,
      (event.clientY - box.top) * scale,
      this.drawnWidth,
    );
    this.readOut.replaceChildren(...(found ? [`${found.place}: `, element('b', {}, found.value)] : []));
  }

  beforePrint() {
    this.print.replaceChildren(svgElement(this.svg(this.figure.half ? kPrinted.half : kPrinted.whole, '')));
  }
}

/** A labelled list to choose from. @param options [value, words] */
export function picker(label, options, chosen, act) {
  const list = element(
    'select',
    { onchange: () => act(list.value) },
    options.map(([value, words]) =>
      element('option', { value, selected: String(value) === String(chosen) }, words),
    ),
  );
  return element('label', { class: 'choice' }, label, ' ', list);
}
