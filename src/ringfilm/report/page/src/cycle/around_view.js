// The film around the ring on the page: case, view, colours and crank angle as the reader picks them.
import { fieldCaption, fieldMaps, fieldRows, stripCaption, stripMaps, stripRows } from './around_figures.js';
import { element, onNewWidth, svgElement } from '../dom.js';
import { fileStem, heading, save, savePng } from '../downloads.js';
import { angle, angleInWords, number, plain, withUnit, wrapped } from '../units.js';

const kPrinted = 900;
const kSaved = 900;

/** Buttons of which one is pressed. */
function choice(label, options, chosen, act) {
  const buttons = options.map(([text, value]) =>
    element(
      'button',
      {
        type: 'button',
        class: 'range',
        'aria-pressed': String(value === chosen),
        onclick: () => {
          buttons.forEach((button, n) =>
            button.setAttribute('aria-pressed', String(options[n][1] === value)),
          );
          act(value);
        },
      },
      text,
    ),
  );
  return element('span', { class: 'tools', role: 'group', 'aria-label': label }, buttons);
}

export class AroundView {
  /** @param cases those with an unrolled film: { name, data } */
  constructor(model, cases, context) {
    Object.assign(this, { model, cases, context, ends: false, own: false });
    this.host = element('div', { class: 'map maps', role: 'img' });
    this.readOut = element('div', { class: 'map-value', 'aria-live': 'off' });
    this.print = element('div', { class: 'print-only' });
    this.caption = element('figcaption', {});
    this.slider = element('input', {
      type: 'range',
      min: 0,
      step: 1,
      id: 'around-angle',
      'aria-label': 'crank angle of the maps around the ring',
      oninput: () => this.show(Number(this.slider.value)),
    });
    this.angleText = element('output', { for: 'around-angle' });
    this.sliderRow = element(
      'div',
      { class: 'slider' },
      element('label', { for: 'around-angle' }, 'Crank angle'),
      this.slider,
      this.angleText,
    );
    this.ownChoice = choice(
      'Colours',
      [
        ['Colours of all angles', false],
        ['Of this angle', true],
      ],
      false,
      (own) => {
        this.own = own;
        this.draw();
      },
    );
    this.viewChoice = choice(
      'Part of the ring',
      [
        ['Whole ring', false],
        ['Ends of the gap', true],
      ],
      false,
      (ends) => {
        this.ends = ends;
        this.draw();
      },
    );
    const caseChoice =
      cases.length > 1
        ? choice(
            'Case',
            cases.map(({ name }, n) => [name, n]),
            0,
            (n) => this.showCase(n),
          )
        : null;
    this.node = element(
      'figure',
      { id: 'around-the-ring', class: 'figure' },
      element('div', { class: 'figure-heading' }, (this.title = element('h3', {})), this.downloads()),
      this.sliderRow,
      element('div', { class: 'choices' }, caseChoice, this.viewChoice, this.ownChoice),
      element('div', { class: 'panels' }, this.host, this.readOut),
      this.print,
      this.caption,
    );
    this.host.addEventListener('pointermove', (event) => this.pointed(event));
    this.host.addEventListener('pointerdown', (event) => this.pointed(event));
    this.host.addEventListener('pointerleave', (event) => {
      if (event.pointerType !== 'touch') this.readOut.replaceChildren();
    });
  }

  start() {
    this.showCase(0);
    onNewWidth(this.node, () => this.draw());
  }

  showCase(n) {
    const { data, name, peakAngle, face } = this.cases[n];
    Object.assign(this, { data, face });
    const caseName = this.cases.length > 1 || this.model.several ? name : '';
    this.caption.textContent = data.hasFields ? fieldCaption(data, caseName) : stripCaption(data, caseName);
    this.sliderRow.hidden = !data.hasFields;
    this.ownChoice.hidden = !data.hasFields;
    this.viewChoice.hidden = data.closed;
    if (data.closed) this.ends = false;
    if (data.hasFields) {
      // On the axis of the charts, whatever the order in the file.
      this.order = data.angles
        .map((_, k) => k)
        .sort((a, b) => wrapped(data.angles[a]) - wrapped(data.angles[b]));
      const off = (k) => Math.abs(wrapped(data.angles[k]) - wrapped(peakAngle ?? 0));
      this.slider.max = this.order.length - 1;
      this.slider.value = this.order.reduce((best, k, at) => (off(k) < off(this.order[best]) ? at : best), 0);
    }
    this.show(Number(this.slider.value));
  }

  show(at) {
    if (this.data.hasFields) {
      this.k = this.order[at];
      const words = angleInWords(this.data.angles[this.k]);
      this.angleText.textContent = words.replace(/^at /, '');
      this.slider.setAttribute('aria-valuetext', words);
    }
    this.readOut.replaceChildren();
    this.draw();
  }

  /** The title that stays while the slider moves has no angle: the slider shows it. */
  draw() {
    const { data, ends, own } = this;
    if (!data) return;
    this.figure = data.hasFields
      ? fieldMaps(data, this.k, { ends, own })
      : stripMaps(data, { ends, face: this.face });
    this.title.textContent = this.figure.title;
    this.drawnWidth = Math.max(280, this.host.clientWidth);
    this.host.setAttribute('aria-label', `${this.figure.title}: ${this.figure.spoken()}`);
    const { plots } = this.figure.layout(this.drawnWidth, 0);
    this.canvases = this.figure.maps.map((map, n) =>
      this.figure.canvas(map, plots[n], Math.min(2, devicePixelRatio || 1), this.canvases?.[n]),
    );
    this.canvases.forEach((canvas, n) => {
      const { left, top, width, height } = plots[n];
      canvas.style.cssText = `left:${left}px;top:${top}px;width:${width}px;height:${height}px`;
    });
    this.host.replaceChildren(
      ...this.canvases,
      svgElement(this.figure.svg({ width: this.drawnWidth, heading: false, pictures: false })),
    );
  }

  pointed(event) {
    const box = this.host.lastElementChild.getBoundingClientRect();
    const scale = this.drawnWidth / box.width;
    const found = this.figure.at(
      (event.clientX - box.left) * scale,
      (event.clientY - box.top) * scale,
      this.drawnWidth,
    );
    this.readOut.replaceChildren(...(found ? this.words(found) : []));
  }

  /** What lies there: the place and all values of its node. */
  words({ column, row, atColumn, atRow }) {
    const { data } = this;
    const atRing = data.hasFields ? atColumn : atRow;
    const j = data.hasFields ? column : row;
    if (j < 0) return ['in the gap of the ring'];
    const y = data.y[j];
    const place = `y ${withUnit(y, 'mm', 4)} (${angle(data.around(y))}° around the bore)`;
    const nameAndValue = (name, value) => [`${name} `, element('b', {}, value)];
    if (!data.hasFields) {
      if (column < 0) return [];
      return [
        `at ${angle(wrapped(data.stripAngles[column]))}°, ${place}: `,
        ...Object.entries(data.strips)
          .slice(0, 4)
          .flatMap(([name, { unit, longName }], n) => [
            n ? ', ' : '',
            ...nameAndValue(longName.split(',')[0], withUnit(data.stripValue(name, column, j), unit, 3)),
          ]),
      ];
    }
    if (row < 0 || atRing === null) return [];
    const { fields } = data;
    const value = (name) => data.value(name, this.k, j, row);
    return [
      `x ${withUnit(data.x[row], 'mm', 3)}, ${place}: `,
      ...nameAndValue('p', withUnit(value('film_pressure'), fields.film_pressure.unit, 4)),
      ...(fields.film_content ? [', ', ...nameAndValue('θ', number(value('film_content'), 3))] : []),
      ...(fields.film_thickness
        ? [', ', ...nameAndValue('h', withUnit(value('film_thickness'), fields.film_thickness.unit, 3))]
        : []),
    ];
  }

  downloads() {
    const name = (ending) => `${fileStem(this.context.stem, 'around-the-ring')}.${ending}`;
    const button = (label, action) =>
      element(
        'button',
        { type: 'button', class: 'download', 'aria-label': `Around the ring as ${label}`, onclick: action },
        label,
      );
    const svg = () => this.figure.svg({ width: kSaved, subtitle: this.context.subtitle });
    const csv = () => {
      const { header, rows } = this.data.hasFields ? fieldRows(this.data, this.k) : stripRows(this.data);
      return (
        `${[header.map(heading).join(','), ...rows.map((row) => row.map(plain).join(','))].join('\r\n')}` +
        `\r\n`
      );
    };
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), svg())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', svg())),
      button('CSV', () => save(name('csv'), 'text/csv', csv())),
    );
  }

  beforePrint() {
    this.print.replaceChildren(svgElement(this.figure.svg({ width: kPrinted })));
  }
}
