// A figure on the page: heading, what the reader may choose, drawing, caption, files to take away.
import { element, svgElement } from '../dom.js';
import { fileStem, save, saveButton, savePng } from '../downloads.js';

/**
 * Width of a drawing for the printer, in a column and across the paper: letters come out at about 7 pt in
 * both.
 */
const kPrinted = { half: 450, whole: 900 };

/** What all figures share; the kinds of figures give svg(), the file of a width, and csv(). */
export class FigureView {
  /**
   * @param figure id, title, caption, half: two of them side by side on paper; named: what buttons call it, file:
   * how its files end, where these are not title and id
   * @param context stem of file names, subtitle for files
   */
  constructor(figure, context, { classes = [], beside = [], above = [] } = {}) {
    Object.assign(this, { figure, context });
    this.title = element('h3', {}, figure.title);
    this.heading = element('div', { class: 'figure-heading' }, this.title, beside, this.downloads());
    this.body = element('div', { class: 'panels' });
    this.print = element('div', { class: 'print-only' });
    this.caption = element('figcaption', {}, typeof figure.caption === 'string' ? figure.caption : '');
    this.node = element(
      'figure',
      { id: figure.id, class: ['figure', ...classes, figure.half ? 'half' : ''].filter(Boolean).join(' ') },
      this.heading,
      above,
      this.body,
      this.print,
      this.caption,
    );
  }

  downloads() {
    const { id, file = id, title, named = title } = this.figure;
    const name = (ending) => `${fileStem(this.context.stem, file)}.${ending}`;
    const svg = () => this.svg(this.savedWidth, this.context.subtitle);
    const button = (label, act) => saveButton(label, act, `${named} as ${label}`);
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), svg())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', svg())),
      this.hasNumbers ? button('CSV', () => save(name('csv'), 'text/csv', this.csv())) : null,
    );
  }

  get hasNumbers() {
    return true;
  }

  /** Lays a static drawing beside that of the screen for the printer. */
  beforePrint() {
    const width = this.figure.half ? kPrinted.half : kPrinted.whole;
    this.print.replaceChildren(svgElement(this.svg(width, '')));
  }
}
