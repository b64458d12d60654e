// A figure that is drawn as a whole, for the width it has, with a read-out under the pointer.
import { element, onNewWidth, svgElement } from '../dom.js';
import { columnsCsv } from '../downloads.js';
import { svgDocument } from '../plot/svg_shapes.js';
import { typeset } from '../units.js';
import { FigureView } from './figure_view.js';

export class DrawingView extends FigureView {
  /**
   * @param figure figure of the present choice of the reader, beside what FigureView has: caption(), columns(),
   * draw(width, isFile) to { shapes, height }; at(x, y, width): what lies under the pointer, as nodes; host: class of
   * the drawing; fixedWidth: that of a drawing of one size; savedTitle: that of files; under(width): nodes that lie
   * under it on the screen
   * @param choices nodes with which the reader chooses; call `redraw` when they change
   */
  constructor(figure, context, choices = []) {
    super(figure, context, { above: choices });
    this.host = element('div', { class: figure.host ?? 'drawing', role: 'img', 'aria-label': figure.title });
    this.body.append(this.host);
    this.savedWidth = figure.fixedWidth ?? 900;
    if (figure.at) this.listen();
  }

  get hasNumbers() {
    return Boolean(this.figure.columns);
  }

  csv() {
    return columnsCsv(this.figure.columns());
  }

  svg(width, subtitle) {
    const shown = this.figure.fixedWidth ?? width;
    const { title, savedTitle = title } = this.figure;
    return svgDocument(this.figure.draw(shown, true), shown, { title: savedTitle, subtitle });
  }

  start() {
    this.redraw();
    onNewWidth(this.node, () => this.redraw());
  }

  redraw() {
    const { figure, host } = this;
    this.width = figure.fixedWidth ?? Math.max(280, host.clientWidth || this.node.clientWidth);
    const under = figure.under?.(this.width) ?? [];
    const background = under.length ? 'none' : '#fff';
    this.drawn = svgElement(svgDocument(figure.draw(this.width, false), this.width, { background }));
    host.replaceChildren(...under, this.drawn);
    this.title.textContent = figure.title;
    this.caption.textContent = typeset(figure.caption());
    host.setAttribute('aria-label', figure.spoken ?? `${figure.title}. ${this.caption.textContent}`);
  }

  listen() {
    this.readOut = element('div', { class: 'map-value' });
    this.body.append(this.readOut);
    const pointed = (event) => {
      const box = this.drawn.getBoundingClientRect();
      const scale = this.width / box.width;
      const found = this.figure.at(
        (event.clientX - box.left) * scale,
        (event.clientY - box.top) * scale,
        this.width,
      );
      this.readOut.replaceChildren(...(found ?? []));
    };
    this.host.addEventListener('pointermove', pointed);
    this.host.addEventListener('pointerdown', pointed);
    this.host.addEventListener('pointerleave', (event) => {
      if (event.pointerType !== 'touch') this.readOut.replaceChildren();
    });
  }
}
