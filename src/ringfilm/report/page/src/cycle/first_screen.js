// What was computed, the three numbers that matter, the one warning that matters.
import { cycleCards } from './cards.js';
import { element } from '../dom.js';
import { shownInput, stoppedAt, withShortPaths } from '../model.js';
import { drawings } from './section_drawing.js';
import { alarm, headWarning, pageHead } from '../page_head.js';
import { mergedNotes } from '../tables.js';
import { angleInWords, number, typeset } from '../units.js';
import { usualCard } from './usual.js';

const kOperating = [
  ['engine.bore', 'bore'],
  ['engine.stroke', 'stroke'],
  ['engine.connecting_rod_length', 'rod'],
  ['operating.speed', 'speed'],
  ['operating.oil_temperature', 'oil at'],
  ['ring.face_width', 'ring width'],
  ['film.cavitation', 'cavitation'],
];

/** "bore 89 mm, stroke 79.5 mm, ..." with every value that occurs. */
export function operatingLine(model) {
  return kOperating
    .map(([key, word]) => {
      const values = [
        ...new Set(
          model.cases
            .map((c) => model.input(c, key))
            .filter(Boolean)
            .map(shownInput),
        ),
      ];
      return values.length ? `${word} ${values.join(' / ')}` : null;
    })
    .filter(Boolean)
    .join(', ');
}

export function reportTitle(model) {
  if (!model.several) return model.cases[0].title || 'One engine cycle';
  const packs = `${model.entries.length} ring packs compared`;
  if (model.sharedTitle) return model.comparesPacks ? `${model.sharedTitle}: ${packs}` : model.sharedTitle;
  return model.comparesPacks ? packs : `${model.cases.length} engine cycles compared`;
}

/** The most serious thing first, without what is only for information. */
export function warnings(model) {
  const list = [];
  const whom = (cases) =>
    cases.length === model.cases.length ? '' : `${cases.map((c) => c.name).join(', ')}: `;
  const synthetic = model.cases.filter((c) => model.isSynthetic(c));
  if (synthetic.length)
    list.push(
      `${whom(synthetic)}the cylinder pressure is SYNTHETIC: made by a formula, not measured on ` +
        'an engine. Levels of friction and film follow from it.',
    );
  const notes = model.cases.flatMap((c) =>
    c.notes.filter((note) => !note.for_information).map((note) => ({ c, note })),
  );
  for (const { c, note } of notes.sort((a, b) => a.note.rank - b.note.rank)) {
    if (note.topic !== 'synthetic-trace') list.push(`${whom([c])}${withShortPaths(c, note.message)}.`);
  }
  return list;
}

/** Where the integration of a case stopped, in words. */
function stop(c) {
  const at = c.effort.cycles_integrated >= 1 ? null : stoppedAt(c.curves.crank_angle);
  const after =
    c.effort.cycles_integrated > 0 ? ` after ${number(c.effort.cycles_integrated, 3)} cycles` : '';
  if (c.curves.crank_angle.length === 0) return 'before the first crank angle was solved';
  return at === null
    ? after.trim() || 'at an angle that the stored samples do not contain'
    : `in its first cycle, last solved ${angleInWords(at).replace(/^(?=\d)/, 'at ')}${after && `,${after}`}`;
}

/** Lists the cases that did not complete, before any number. */
function stopped(model) {
  const broken = model.cases.filter((c) => !c.complete);
  if (broken.length === 0) return null;
  return alarm(
    'INCOMPLETE: ',
    model.several
      ? `${broken.length} of ${model.cases.length} cases did not come to a cycle that repeats itself.`
      : 'the integration did not come to a cycle that repeats itself.',
    broken.map((c) => element('p', {}, `${model.several ? `${c.name}: s` : 'S'}topped ${stop(c)}.`)),
    element(
      'p',
      {},
      'No values of a whole cycle exist: no power, no FMEP, no thinnest film, no shares. The ' +
        'curves show what was solved until then.',
    ),
  );
}

export function firstScreen(model) {
  const found = warnings(model);
  const several = mergedNotes(model).length - 1;
  const warning =
    found.length === 0
      ? null
      : headWarning(
          'Warning',
          typeset(found[0]),
          several > 0
            ? [
                ' ',
                element('a', { href: '#validity' }, `${several} more ${several === 1 ? 'note' : 'notes'}`),
              ]
            : null,
        );
  return pageHead(
    {
      kind: 'Mixed lubrication of the piston ring and the liner over one engine cycle',
      title: reportTitle(model),
      operating: operatingLine(model),
    },
    stopped(model),
    warning,
    element(
      'div',
      { class: `summary ${model.several ? '' : 'alone'}` },
      model.cases.every((c) => !c.complete)
        ? null
        : element('div', { class: 'numbers' }, cycleCards(model), usualCard(model)),
      drawings(model),
    ),
  );
}
