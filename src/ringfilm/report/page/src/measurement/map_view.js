// A height map on the page: drawn for the width it has, a read-out under the pointer, files to take away.
import { element, onNewWidth, svgElement } from '../dom.js';
import { fileStem, save, savePng } from '../downloads.js';
import { MapFigure } from '../plot/map_figure.js';
import { typeset } from '../units.js';

const kPrinted = 760;
const kSaved = 900;

export class MapView {
  constructor(map, context) {
    this.figure = new MapFigure(map);
    this.context = context;
    this.host = element('div', {
      class: 'map',
      role: 'img',
      'aria-label': `${map.title}: ${this.figure.description()}`,
    });
    this.readOut = element('div', { class: 'map-value' });
    this.print = element('div', { class: 'print-only' });
    const title = element('h3', {}, map.title);
    this.node = element(
      'figure',
      { id: map.name, class: 'figure' },
      element('div', { class: 'figure-heading' }, title, this.downloads()),
      element('div', { class: 'panels' }, this.host, this.readOut),
      this.print,
      element(
        'figcaption',
        {},
        [map.caption, this.figure.description()].filter(Boolean).map(typeset).join(' '),
      ),
    );
    this.host.addEventListener('pointermove', (event) => this.pointed(event));
    this.host.addEventListener('pointerleave', () => this.readOut.replaceChildren());
  }

  downloads() {
    const name = (ending) => `${fileStem(this.context.stem, this.figure.name)}.${ending}`;
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
    const svg = () => this.figure.svg({ width: kSaved, subtitle: this.context.subtitle });
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), svg())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', svg())),
    );
  }

  start() {
    this.draw();
    onNewWidth(this.node, () => this.draw());
  }

  draw() {
    this.drawnWidth = Math.max(280, this.host.clientWidth);
    this.host.replaceChildren(svgElement(this.figure.svg({ width: this.drawnWidth, heading: false })));
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
    this.print.replaceChildren(svgElement(this.figure.svg({ width: kPrinted })));
  }
}
