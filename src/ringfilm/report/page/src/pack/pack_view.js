// The drawing of a ring pack with its slider, and the section of a pack on the page.
import { element, svgElement } from '../dom.js';
import { fileStem, save, savePng } from '../downloads.js';
import { boundaryPowerShare } from '../model.js';
import { figure as numberCell, folded, table } from '../tables.js';
import { angleInWords, display, number, withUnit } from '../units.js';
import { blowByWords, withoutRounding } from './gas_words.js';
import { packSvg } from './pack_drawing.js';

export class PackDrawing {
  constructor(packed, context) {
    Object.assign(this, { packed, context, angle: Math.round(packed.model.peakAngle(packed.cases[0]) ?? 0) });
    this.host = element('div', { class: 'pack-drawing', role: 'img' });
    this.print = element('div', { class: 'print-only' });
    this.slider = element('input', {
      type: 'range',
      min: -360,
      max: 360,
      step: 1,
      value: this.angle,
      id: 'pack-angle',
      'aria-label': 'crank angle of the drawing of the ring pack',
      oninput: () => {
        this.show(Number(this.slider.value));
        context.group.point(this.angle);
      },
    });
    this.angleText = element('output', { for: 'pack-angle' });
    context.group.followers.push((angle) => this.follow(angle));
    this.node = element(
      'figure',
      { id: 'pack-drawing', class: 'figure half' },
      element(
        'div',
        { class: 'figure-heading' },
        element('h3', {}, 'The pack and its gas pressures'),
        this.downloads(),
      ),
      element(
        'div',
        { class: 'slider' },
        element('label', { for: 'pack-angle' }, 'Crank angle'),
        this.slider,
        this.angleText,
      ),
      element('div', { class: 'panels' }, this.host),
      this.print,
      element(
        'figcaption',
        {},
        'Widths of the rings and heights of the piston lands to scale, from the keys of the case; side clearances ' +
          'and the gap to the liner enlarged, thicknesses not to scale. The darker a space, the higher its pressure ' +
          '(logarithmic). Rings are drawn where they are in their grooves at this crank angle.',
      ),
    );
  }

  follow(angle) {
    const next = Math.round(angle);
    if (next === this.angle || this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.slider.value = next;
      this.show(next);
    });
  }

  show(angle) {
    this.angle = angle;
    const words = angleInWords(angle);
    this.angleText.textContent = words.replace(/^at /, '');
    this.slider.setAttribute('aria-valuetext', words);
    this.host.setAttribute('aria-label', `Section of the ring pack ${words}`);
    this.host.replaceChildren(svgElement(packSvg(this.packed, angle)));
  }

  downloads() {
    const name = (ending) => `${fileStem(this.context.stem, 'ring-pack')}.${ending}`;
    const button = (label, action) =>
      element(
        'button',
        {
          type: 'button',
          class: 'download',
          'aria-label': `Drawing of the ring pack as ${label}`,
          onclick: action,
        },
        label,
      );
    const svg = () => packSvg(this.packed, this.angle);
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), svg())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', svg())),
    );
  }

  start() {
    this.show(this.angle);
  }

  beforePrint() {
    this.print.replaceChildren(svgElement(packSvg(this.packed, this.angle)));
  }
}

/** Friction of each ring and of the pack, with a column for each value that adds up. */
export function ringTable({ pack, model }) {
  const names = Object.keys(pack.values);
  const row = (what, values) => [
    what,
    ...names.map((name) => numberCell(number(model.value({ values }, name).value, 4))),
    numberCell(`${number((100 * values.mean_power_loss) / pack.values.mean_power_loss, 3)} %`),
    numberCell(withUnit(boundaryPowerShare(values), '%', 3)),
  ];
  const head = (text) => ({ text, attributes: { class: 'number' } });
  const heading = ({ longName, unit }) => head(`${longName} [${unit}]`);
  return table(
    'Friction by ring',
    [
      'ring',
      ...names.map((name) => heading(model.value(pack, name))),
      head('share in the pack'),
      head('boundary friction in the power'),
    ],
    [...pack.by_ring.map(({ ring, values }) => row(`ring ${ring}`, values)), row('pack', pack.values)],
  );
}

/** A row for each path or ring, with a column for each of its quantities in the unit in which it is read. */
function gasTable(caption, what, quantities, rows, nameOf) {
  const columns = quantities
    .map((quantity) => ({ ...quantity, ...display(quantity) }))
    .filter(({ name }) => rows.some((row) => row[name] !== undefined));
  if (rows.length === 0 || columns.length === 0) return null;
  const cell = (value, { convert, display_unit: shown }) => {
    if (value === undefined) return numberCell('–');
    if (typeof value === 'boolean') return numberCell(value ? 'yes' : 'no');
    const isCount = shown === '1' && Number.isInteger(value);
    return numberCell(isCount ? String(value) : number(convert(value), 3));
  };
  const head = ({ long_name: text, unit }) => ({
    text: unit ? `${text} [${unit}]` : text,
    attributes: { class: 'number' },
  });
  return table(
    caption,
    [what, ...columns.map(head)],
    rows.map((row) => [nameOf(row), ...columns.map((column) => cell(row[column.name], column))]),
    { folds: true },
  );
}

/** What passes each path in a cycle, forward and back, and what moves the rings in their grooves. */
export function gasTables(gas) {
  if (!gas) return null;
  const { paths, ring_motion: motion } = gas.quantities;
  return folded(
    'Gas flows and ring motion',
    gasTable(
      'Gas that passes each path in a cycle, per cylinder',
      'path',
      paths,
      withoutRounding(gas.paths),
      ({ name }) => name,
    ),
    gasTable('Rings in their grooves', 'ring', motion, gas.ring_motion, ({ ring }) => `ring ${ring}`),
  );
}

/** What the gas and the oil of the pack come to: sentences, then tables. */
export function packSentences({ pack }) {
  const { gas, oil } = pack;
  const sentences = [];
  if (gas) sentences.push(`Blow-by per cylinder: ${blowByWords(gas)}.`);
  if (oil) {
    const shown = oil.quantities.map((quantity) => {
      const { unit, convert } = display(quantity);
      return `${quantity.long_name} ${withUnit(convert(oil[quantity.name]), unit, 3)}`;
    });
    sentences.push(
      `Oil on the liner: ${shown.join('; ')}. The bound is all that the first ring leaves there on its downstrokes.`,
    );
  }
  return [...sentences.map((words) => element('p', { class: 'how' }, words)), gasTables(gas)];
}
