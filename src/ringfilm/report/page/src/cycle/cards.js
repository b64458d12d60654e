// The numbers that matter, each with the error of the mesh and the range of the ledger.
import { element, svgElement } from '../dom.js';
import { boundaryPowerShare } from '../model.js';
import { card, cardRow, cards, cardValue } from '../page_head.js';
import { massText, oilAbove } from './oil_above.js';
import { swatchSvg } from '../plot/line_panel.js';
import { angleInWords, errorText, meaningful, number } from '../units.js';

/** A misprint of the reproduced paper, whose loads are 20 to 40 times too large: no model that anyone would choose. */
const kMisprint = /polynomial-as-printed/;

/**
 * Lowest and highest value among the case and its solved other choices, in display units; null where fewer than
 * two were computed. @param of the value of a case or of another choice
 */
export function modelBand(c, of) {
  const solved = c.ledger
    .flatMap((entry) => entry.variants)
    .filter((v) => v.solved && !kMisprint.test(v.setting));
  const values = [c, ...solved].map(of).filter((v) => v !== null && Number.isFinite(v));
  if (solved.length < 2 || values.length < 3) return null;
  return { low: Math.min(...values), high: Math.max(...values), choices: solved.length };
}

/** A value of the cycle with its error and the range of the ledger. */
const cycleValue = (model, name) => (c) => ({
  ...model.value(c, name),
  error: model.error(c, name),
  band: modelBand(c, (one) => model.value(one, name).value),
});

/** Share of boundary friction in the friction power with the range of the ledger. */
const boundaryShare = (c) => ({
  value: boundaryPowerShare(c.values),
  unit: '%',
  error: null,
  band: modelBand(c, (one) => boundaryPowerShare(one.values)),
});

/** Film on the liner behind a ring on its downstrokes [µm], where the oil on the liner is followed. */
const oilFilm = (c) => ({ value: oilAbove(c)?.film ?? null, unit: 'µm', error: null, band: null });

function accuracy({ value, unit, error, band }) {
  if (value === null) return null;
  const mesh = errorText(error);
  const shownUnit = unit ? `\u00a0${unit}` : '';
  const parts = [
    mesh ? `mesh ±\u00a0${mesh}${shownUnit}` : null,
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

const shownValue = (text, unit) => cardValue(text, unit ? ` ${unit}` : '');

const mark = (series) => svgElement(swatchSvg({ caseIndex: series, part: null }));

/** A pack, with what its rings come to where they add up. @param sum maps a pack to { value, unit, detail } */
function packRow(model, pack, sum) {
  const isAlone = model.packs.length === 1 && pack.ring_numbers.length === model.cases.length;
  const { value, unit, detail } = sum ? sum(pack) : {};
  return cardRow(
    [
      model.comparesPacks ? mark(model.allPacks.indexOf(pack)) : null,
      [isAlone ? null : pack.name, sum ? `all ${pack.n_rings} rings` : null].filter(Boolean).join(': '),
    ],
    sum ? shownValue(meaningful(value, null), value === null ? '' : unit) : null,
    sum ? detail : null,
  );
}

function caseRow(model, c, of, detail) {
  const stated = of(c);
  const pack = model.comparesPacks ? model.allPacks[c.series] : null;
  const name = pack ? c.name.slice(`${pack.name}, `.length) : c.name;
  return cardRow(
    model.several ? [pack ? null : mark(c.series), name] : null,
    shownValue(meaningful(stated.value, stated.error), stated.value === null ? '' : stated.unit),
    detail(c),
    accuracy(stated),
  );
}

/** A row for each case, and one for each pack: above its rings where packs are compared. */
function caseCard(model, heading, of, detail, sum = null) {
  const ofCase = (c) => caseRow(model, c, of, detail);
  const ofPack = (pack) => packRow(model, pack, pack.complete ? sum : null);
  const rows = model.comparesPacks
    ? model.allPacks.flatMap((pack, p) => [
        ofPack(pack),
        ...model.cases.filter((c) => c.series === p).map(ofCase),
      ])
    : [...model.cases.map(ofCase), ...(sum ? model.packs.map(ofPack) : [])];
  return card(heading, rows);
}

/** What the words "mesh" and "model" on the cards mean, as far as they occur. */
function explanation(model) {
  const meshed = model.cases.some((c) => c.errors?.has_values);
  const choices = Math.max(
    0,
    ...model.cases.map((c) => modelBand(c, (one) => model.value(one, 'fmep').value)?.choices ?? 0),
  );
  const parts = [
    meshed ? 'Mesh: what cells and crank steps may have moved.' : null,
    choices ? `Model: lowest and highest among ${choices} other choices of the ledger, one at a time.` : null,
  ].filter(Boolean);
  return parts.length ? element('p', { class: 'how cards-how' }, parts.join(' ')) : null;
}

export function cycleCards(model) {
  const fmep = (c) => {
    const { value, unit } = model.value(c, 'fmep');
    return value === null ? '' : `FMEP ${number(value, 3)} ${unit}`;
  };
  return [
    cards(
      caseCard(model, 'Mean friction power', cycleValue(model, 'mean_power_loss'), fmep, (pack) => ({
        ...model.value(pack, 'mean_power_loss'),
        detail: fmep(pack),
      })),
      caseCard(model, 'Thinnest film', cycleValue(model, 'min_film_thickness'), (c) =>
        c.complete ? angleInWords(c.values.min_film_thickness_angle).replace('firing ', '') : '',
      ),
      caseCard(
        model,
        'Boundary friction',
        boundaryShare,
        () => 'of the friction power',
        (pack) => ({ value: boundaryPowerShare(pack.values), unit: '%', detail: 'of the friction power' }),
      ),
      model.cases.some(oilAbove)
        ? caseCard(model, 'Oil left above the ring', oilFilm, (c) =>
            oilAbove(c)
              ? `on the liner; ${massText(c.values.oil_scraped_up)} a cycle at TDC`
              : 'not followed',
          )
        : null,
    ),
    explanation(model),
  ];
}
