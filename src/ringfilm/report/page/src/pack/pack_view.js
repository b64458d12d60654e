// The drawing of a ring pack with its slider, and the section of a pack on the page.
import { element } from '../dom.js';
import { AngleSlider } from '../figure/choices.js';
import { DrawingView } from '../figure/drawing_view.js';
import { boundaryPowerShare } from '../model.js';
import { folded, right, table } from '../tables.js';
import { axisTitle } from '../plot/scales.js';
import { display, number, withUnit } from '../units.js';
import { blowByWords, withoutRounding } from './gas_words.js';
import { kPackWidth, packDrawing } from './pack_drawing.js';
import { kTiltFactor, sectionCorners } from './ring_outline.js';

/** All crank angles of the slider. */
const kAngles = Array.from({ length: 720 }, (_, k) => k - 359);

export function packView(packed, context) {
  const slider = new AngleSlider({
    id: 'pack-angle',
    spoken: 'crank angle of the drawing of the ring pack',
    angles: kAngles,
    at: packed.model.peakAngle(packed.cases[0]),
    group: context.group,
    show: () => view.redraw(),
  });
  const figure = {
    id: 'pack-drawing',
    file: 'ring-pack',
    named: 'Drawing of the ring pack',
    title: 'The pack and its gas pressures',
    half: true,
    host: 'pack-drawing',
    fixedWidth: kPackWidth,
    get savedTitle() {
      return `${figure.title} ${slider.words}`;
    },
    get spoken() {
      return `Section of the ring pack ${slider.words}`;
    },
    draw: () => packDrawing(packed, slider.angle),
    caption: () =>
      'Widths of the rings and heights of the piston lands to scale, from the keys of the case; side clearances ' +
      'and the gap to the liner enlarged, thicknesses not to scale. The darker a space, the higher its pressure ' +
      '(logarithmic). Rings are drawn where they are in their grooves at this crank angle' +
      (packed.cases.some(sectionCorners) ? `, stated sections with ${kTiltFactor} times their twist.` : '.'),
  };
  const view = new DrawingView(figure, context, [slider.node]);
  return view;
}

/** Friction of each ring and of the pack, with a column for each value that adds up. */
export function ringTable({ pack, model }) {
  const names = Object.keys(pack.values);
  const row = (what, values) => [
    what,
    ...names.map((name) => right(number(model.value({ values }, name).value, 4))),
    right(`${number((100 * values.mean_power_loss) / pack.values.mean_power_loss, 3)} %`),
    right(withUnit(boundaryPowerShare(values), '%', 3)),
  ];
  return table(
    'Friction by ring',
    [
      'ring',
      ...names.map((name) => {
        const { longName, unit } = model.value(pack, name);
        return right(`${longName} [${unit}]`);
      }),
      right('share in the pack'),
      right('boundary friction in the power'),
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
    if (value === undefined) return right('–');
    if (typeof value === 'boolean') return right(value ? 'yes' : 'no');
    const isCount = shown === '1' && Number.isInteger(value);
    return right(isCount ? String(value) : number(convert(value), 3));
  };
  return table(
    caption,
    [what, ...columns.map(({ long_name: name, unit }) => right(axisTitle(name, unit)))],
    rows.map((row) => [nameOf(row), ...columns.map((column) => cell(row[column.name], column))]),
    { folds: true },
  );
}

/** What passes each path in a cycle, forward and back, and what moves the rings in their grooves. */
export function gasTables(gas) {
  if (!gas) return null;
  const { composition, paths, ring_motion: motion } = gas.quantities;
  return folded(
    'Gas flows and ring motion',
    gasTable(
      'Gas that passes each path in a cycle, per cylinder',
      'path',
      paths,
      withoutRounding(gas.paths),
      ({ name }) => name,
    ),
    gasTable(
      'Gases and species that the gas carries, per cylinder',
      'gas',
      composition ?? [],
      gas.composition ?? [],
      ({ name }) => name,
    ),
    gasTable('Rings in their grooves', 'ring', motion, gas.ring_motion, ({ ring }) => `ring ${ring}`),
  );
}

/** The oil consumption of a cylinder, its parts and its sums for the engine, each with its band. */
function consumptionWords(losses) {
  const units = {
    'kg/s': { unit: 'g/h', factor: 3.6e6 },
    'kg/J': { unit: 'g/kWh', factor: 3.6e9 },
    1: { unit: '%', factor: 100 },
  };
  const shown = losses.map(({ name, unit, low, value, high }) => {
    const { unit: shownUnit, factor } = units[unit];
    const [from, at, to] = [low, value, high].map((one) => Number((factor * one).toPrecision(2)));
    return `${name.replaceAll('_', ' ')} ${at} ${shownUnit} (${from} to ${to})`;
  });
  return `Oil consumption, estimated, of one cylinder: ${shown.join('; ')}.`;
}

/** Which inputs narrow the band of the total, the one that narrows it most first. */
function narrowedTable(bands) {
  const grams = (rate) => Number((3.6e6 * rate).toPrecision(2));
  return table(
    'What narrows the band of the oil consumption where it is known, the most effective input first',
    ['input', 'part', right('share of the band'), right('total that remains [g/h]')],
    bands.map(({ part, input, low, high, band_share: share }) => [
      input,
      part.replaceAll('_', ' '),
      right(`${Math.round(100 * share)} %`),
      right(`${grams(low)} to ${grams(high)}`),
    ]),
    { folds: true },
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
  const losses = pack.oil_consumption ?? [];
  if (losses.length > 0) sentences.push(consumptionWords(losses));
  const narrowed = pack.oil_narrowed_by ?? [];
  return [
    ...sentences.map((words) => element('p', { class: 'how' }, words)),
    ...(narrowed.length > 0 ? [narrowedTable(narrowed)] : []),
    gasTables(gas),
  ];
}
