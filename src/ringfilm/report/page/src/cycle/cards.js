// The numbers that matter, each with the error of the mesh and the range of the ledger.
import { element, svgElement } from '../dom.js';
import { swatchSvg } from '../plot/svg.js';
import { angleInWords, errorText, meaningful, number } from '../units.js';

/** A misprint of the reproduced paper, whose loads are 20 to 40 times too large: no model that anyone would choose. */
const kMisprint = /polynomial-as-printed/;

/**
 * Lowest and highest value among the case and its solved other choices, in display units; null where fewer than
 * two were computed.
 */
export function modelBand(model, c, name) {
  const solved = c.ledger
    .flatMap((entry) => entry.variants)
    .filter((v) => v.solved && !kMisprint.test(v.setting));
  const values = [c, ...solved]
    .map((one) => model.value(one, name).value)
    .filter((v) => v !== null && Number.isFinite(v));
  if (solved.length < 2 || values.length < 3) return null;
  return { low: Math.min(...values), high: Math.max(...values), choices: solved.length };
}

function accuracy(model, c, name) {
  const { value, unit } = model.value(c, name);
  if (value === null) return null;
  const error = errorText(model.error(c, name));
  const band = modelBand(model, c, name);
  const shownUnit = unit ? `\u00a0${unit}` : '';
  const parts = [
    error ? `mesh ±\u00a0${error}${shownUnit}` : null,
    band ? `model ${number(band.low, 3)} to ${number(band.high, 3)}${shownUnit}` : null,
  ].filter(Boolean);
  return parts.length
    ? element(
        'span',
        { class: 'card-accuracy' },
        parts.map((part, i) => element('span', {}, i < parts.length - 1 ? `${part}; ` : part)),
      )
    : null;
}

/** One value with its unit. */
function shownValue(text, unit) {
  return element('span', { class: 'card-value' }, element('b', {}, text), unit ? ` ${unit}` : '');
}

/** The sum over the rings of a pack, under those of its rings. */
function sumRow(model, pack, name, detail) {
  const { value, unit } = model.value(pack, name);
  const isAlone = model.packs.length === 1 && pack.ring_numbers.length === model.cases.length;
  return element(
    'div',
    { class: 'card-row' },
    element('span', { class: 'card-name' }, `${isAlone ? '' : `${pack.title}: `}all ${pack.n_rings} rings`),
    shownValue(meaningful(value, null), unit),
    element('span', { class: 'card-detail' }, detail(pack)),
  );
}

function card(model, heading, name, detail, sums = []) {
  const rows = model.cases.map((c) => {
    const { value, unit } = model.value(c, name);
    return element(
      'div',
      { class: 'card-row' },
      model.several
        ? element(
            'span',
            { class: 'card-name' },
            svgElement(swatchSvg({ caseIndex: c.index, part: null })),
            c.name,
          )
        : null,
      shownValue(meaningful(value, model.error(c, name)), value === null ? '' : unit),
      element('span', { class: 'card-detail' }, detail(c)),
      accuracy(model, c, name),
    );
  });
  return element('section', { class: 'card' }, element('h2', {}, heading), rows, sums);
}

/** What the words "mesh" and "model" on the cards mean, as far as they occur. */
function explanation(model) {
  const meshed = model.cases.some((c) => c.errors?.has_values);
  const choices = Math.max(0, ...model.cases.map((c) => modelBand(model, c, 'fmep')?.choices ?? 0));
  const parts = [
    meshed ? 'Mesh: what cells and crank steps may have moved.' : null,
    choices ? `Model: lowest and highest among ${choices} other choices of the ledger, one at a time.` : null,
  ].filter(Boolean);
  return parts.length ? element('p', { class: 'how cards-how' }, parts.join(' ')) : null;
}

export function cards(model) {
  const fmep = (c) => {
    const { value, unit } = model.value(c, 'fmep');
    return value === null ? '' : `FMEP ${number(value, 3)} ${unit}`;
  };
  return [
    element(
      'div',
      { class: 'cards' },
      card(
        model,
        'Mean friction power',
        'mean_power_loss',
        fmep,
        model.packs.map((pack) => sumRow(model, pack, 'mean_power_loss', fmep)),
      ),
      card(model, 'Thinnest film', 'min_film_thickness', (c) =>
        c.complete ? angleInWords(c.values.min_film_thickness_angle).replace('firing ', '') : '',
      ),
      card(model, 'In mixed lubrication', 'mixed_share', () => 'of the cycle'),
      card(model, 'Mean oil flow', 'mean_absolute_oil_flow', (c) =>
        c.complete && model.hasFloodedInlet(c) ? 'flooded inlet: an upper bound' : '',
      ),
    ),
    explanation(model),
  ];
}
