// The tables under the figures.
import { code, element, onNewWidth, section, withSubscripts } from './dom.js';
import { columnsCsv, fileStem, save, saveButton } from './downloads.js';
import { shownInput, withShortPaths } from './model.js';
import {
  display,
  howOften,
  number,
  sentence,
  shortPath,
  typeset,
  typesetFormula,
  withError,
} from './units.js';

/** A cell is its text, or { text, attributes }. */
function described(content) {
  const { text, attributes = {} } =
    content && typeof content === 'object' && 'text' in content ? content : { text: content };
  return { text, attributes };
}

/** A table that may be wider than the page; where it is, a line states that it scrolls. */
export function scrolling(label, content) {
  const region = element(
    'div',
    { class: 'table-scroll', tabindex: '0', role: 'region', 'aria-label': label },
    content,
  );
  const mark = () => region.classList.toggle('overflows', region.scrollWidth > region.clientWidth + 1);
  onNewWidth(region, mark);
  requestAnimationFrame(mark);
  return region;
}

/** A table that stays a table for screen readers and folds into blocks on a phone. */
export function table(caption, heads, rows, { folds = false, classes = '' } = {}) {
  const cells = (row) =>
    row.map((content, i) => {
      const { text, attributes } = described(content);
      const empty = text === '–' ? 'nothing' : '';
      return element(
        i === 0 ? 'th' : 'td',
        {
          role: i === 0 ? 'rowheader' : 'cell',
          scope: i === 0 ? 'row' : null,
          'data-label': described(heads[i]).text,
          ...attributes,
          class: `${attributes.class ?? ''} ${empty}`.trim() || null,
        },
        Array.isArray(text) ? element('span', {}, text) : (text ?? '–'),
      );
    });
  return scrolling(
    caption,
    element(
      'table',
      { role: 'table', class: `${folds ? 'folds' : ''} ${classes}` },
      element('caption', {}, caption),
      element(
        'thead',
        { role: 'rowgroup' },
        element(
          'tr',
          { role: 'row' },
          heads.map((h) =>
            element(
              'th',
              { role: 'columnheader', scope: 'col', ...described(h).attributes },
              described(h).text,
            ),
          ),
        ),
      ),
      element(
        'tbody',
        { role: 'rowgroup' },
        rows.map((row) => element('tr', { role: 'row' }, cells(row))),
      ),
    ),
  );
}

/** A cell of a number, or the head over it. */
export const right = (text, attributes = {}) => ({ text, attributes: { class: 'number', ...attributes } });

/** Is the page wide enough for long tables? On a phone they are folded until the reader opens them. */
export const isWide = () => window.innerWidth > 760;

export function fold(summary, open, ...content) {
  return element('details', { class: 'fold', open }, element('summary', {}, summary), content);
}

export const folded = (summary, ...content) => fold(summary, isWide(), ...content);

/** A heading above a table, with the button that takes its numbers away. @param columns see columnsCsv() */
export function withCsv(title, spoken, context, id, columns) {
  const name = `${fileStem(context.stem, id)}.csv`;
  const button = saveButton('CSV', () => save(name, 'text/csv', columnsCsv(columns())), `${spoken} as CSV`);
  return element('div', { class: 'table-heading' }, title, element('span', { class: 'downloads' }, button));
}

/** Rows on the program that made a result. */
export const programRows = (provenance) =>
  ['program', 'commit', 'compiler'].map((key) => [key, provenance[key] || '–']);

/** The files that were read, with their hashes. @param whose heads and cells of a column beside role and hash */
export function filesTable(files, whose = { heads: [], cells: () => [] }) {
  return table(
    'Files read',
    ['file', 'role', ...whose.heads, 'SHA-256'],
    files.map((f) => [
      { text: code(shortPath(f.path), { title: f.path }) },
      f.role,
      ...whose.cells(f),
      { text: element('code', { class: 'hash' }, f.sha256) },
    ]),
    { folds: true },
  );
}

export const foldedFiles = (files, whose) =>
  folded(`${files.length} files read, with their hashes`, filesTable(files, whose));

/** An input as a cell, marked where it is assumed. */
export function inputCell(entry) {
  const shown = shownInput(entry);
  return {
    text: entry.assumed ? [shown, ' ', element('span', { class: 'tag' }, 'assumed')] : shown,
    attributes: {
      class: entry.assumed ? 'assumed' : '',
      title: shortPath(entry.shown) === entry.shown ? null : entry.shown,
    },
  };
}

/** A key with its line of help as a cell. */
export function keyCell({ key, help }) {
  const words = withSubscripts(typesetFormula(typeset(help)));
  return { text: [code(key), element('span', { class: 'help' }, words)] };
}

/** One column of numbers a case, heads set over their digits. */
const numberHeads = (model) => model.cases.map((c) => right(model.several ? c.name : 'value'));

/** "mean friction power [W]", the unit in soft type. */
function named(quantity) {
  const { unit } = display(quantity);
  return [typesetFormula(quantity.long_name), unit ? element('span', { class: 'unit' }, ` [${unit}]`) : null];
}

/** "400 x 90 cells at 1°, step error 0.002", and why it was not solved. */
export function gridText(run) {
  const cells = run.cells_y ? `${run.cells} x ${run.cells_y}` : run.cells;
  const error = run.step_error ? `, step error ${number(run.step_error, 2)}` : '';
  const unsolved = run.solved ? '' : `, not solved: ${run.reason}`;
  return `${cells} cells at ${number(run.crank_step, 3)}°${error}${unsolved}`;
}

/** Where the errors beside the values come from. */
function gridSentence(model) {
  const estimated = model.cases.filter((c) => c.errors?.has_values);
  if (estimated.length === 0)
    return model.cases.some((c) => c.errors)
      ? ' The values have no error estimate; a note gives the reason.'
      : '';
  const grids = estimated[0].errors.runs.map(gridText);
  return (
    ' After ±: how far cells and crank steps may have moved the value, from integrations on other ' +
    `grids (${grids.join('; ')}); it does not include errors of models and inputs.`
  );
}

export function cycleValuesSection(model) {
  const heads = ['quantity', ...numberHeads(model)];
  const rows = model.payload.cycle_quantities.map((q) => [
    { text: named(q) },
    ...model.cases.map((c) => {
      const { value, unit } = model.value(c, q.name);
      return right(withError(value, model.error(c, q.name), unit));
    }),
  ]);
  if (model.cases.every((c) => !c.complete)) {
    return section(
      'cycle-values',
      'Values of the whole cycle',
      element('p', {}, 'None: the integration stopped before the cycle repeated itself.'),
    );
  }
  return section(
    'cycle-values',
    'Values of the whole cycle',
    element(
      'p',
      {},
      'Loads, friction and flow are those of the whole circumference. Angles count from firing ' +
        'TDC, negative before it.',
      gridSentence(model),
    ),
    table('Values of the whole cycle', heads, rows),
  );
}

/** How often a note applies, in words; a dash where it is on the case as a whole. */
function often(model, c, { counts, count }) {
  if (counts === 'case') return '–';
  const step = model.input(c, 'solver.crank_step')?.value_si ?? 0;
  return howOften(count, counts === 'crank angles' && c.complete && step > 0 ? Math.round(720 / step) : null);
}

/** Notes of all cases, the most serious first; one entry where they agree. */
export function mergedNotes(model) {
  const merged = [];
  const add = (rank, topic, message, count, oneCase) => {
    const known = merged.find((n) => n.topic === topic && n.message === message && n.count === count);
    if (known) known.cases.push(oneCase);
    else merged.push({ rank, topic, message, count, cases: [oneCase] });
  };
  for (const c of model.cases) {
    for (const n of c.notes) add(n.rank, n.topic, withShortPaths(c, n.message), often(model, c, n), c);
    for (const n of c.input_notes) add(Infinity, 'input', withShortPaths(c, n), '–', c);
  }
  return merged.sort((a, b) => (a.rank === b.rank ? 0 : a.rank - b.rank));
}

export function notesSection(model) {
  const merged = mergedNotes(model);
  const whom = (cases) =>
    !model.several ? null : cases.length === model.cases.length ? 'all' : cases.map((c) => c.name).join(', ');
  const content =
    merged.length === 0
      ? element('p', {}, 'Every law stayed within its range, and no remedy was needed.')
      : table(
          'Notes on validity',
          ['note', ...(model.several ? ['case'] : []), 'how often', 'topic'],
          merged.map((n) => [
            sentence(n.message),
            ...(model.several ? [whom(n.cases)] : []),
            n.count,
            { text: code(n.topic) },
          ]),
          { folds: true },
        );
  return section('validity', 'Validity: what to know before using these results', content);
}

export function inputsSection(model) {
  const keys = [...new Map(model.cases.flatMap((c) => c.inputs.map((entry) => [entry.key, entry]))).values()];
  const shown = (entry) => (entry === undefined ? { text: 'not used' } : inputCell(entry));
  const rows = keys.map((first) => {
    const entries = model.cases.map((c) => model.input(c, first.key));
    const differs = entries.some((e) => e?.shown !== entries[0]?.shown || e?.assumed !== entries[0]?.assumed);
    const cells =
      model.several && !differs
        ? [
            {
              ...shown(entries[0]),
              attributes: {
                ...shown(entries[0]).attributes,
                colspan: model.cases.length,
                'data-label': 'all cases',
              },
            },
          ]
        : entries.map((e) => {
            const cell = shown(e);
            return {
              ...cell,
              attributes: {
                ...cell.attributes,
                class: `${cell.attributes?.class ?? ''} ${differs ? 'differs' : ''}`,
              },
            };
          });
    return [keyCell(first), ...cells];
  });
  const derived = model.payload.derived_quantities.filter((q) =>
    model.cases.some((c) => q.name in c.derived),
  );
  const several = model.several;
  return section(
    'inputs',
    'Inputs',
    element(
      'p',
      {},
      'Stated by the user in upright type; ',
      element('span', { class: 'assumed-sample' }, 'assumed, because not stated'),
      several ? '; values that differ between the cases in bold.' : '.',
    ),
    folded(
      `${keys.length} inputs, ` +
        `${keys.filter((first) => model.cases.some((c) => model.input(c, first.key)?.assumed)).length}` +
        ' of them assumed',
      table('Inputs', ['key', ...model.cases.map((c) => (several ? c.name : 'value'))], rows, {
        folds: true,
        classes: 'inputs',
      }),
    ),
    derived.length === 0
      ? null
      : table(
          'What follows from the inputs',
          ['constant', ...numberHeads(model)],
          derived.map((q) => {
            const { convert } = display(q);
            return [
              { text: named(q) },
              ...model.cases.map((c) => right(number(convert(c.derived[q.name] ?? null), 4))),
            ];
          }),
        ),
  );
}

export function provenanceSection(model) {
  const heads = ['what', ...numberHeads(model)];
  const rows = [
    ...['program', 'commit', 'compiler', 'kernels'].map((key) => [
      key,
      ...model.cases.map((c) => right(c.provenance[key] || '–', { class: 'number wraps' })),
    ]),
    ...model.payload.effort_quantities.map(({ name, long_name: label }) => [
      label,
      ...model.cases.map((c) =>
        right(Number.isInteger(c.effort[name]) ? String(c.effort[name]) : number(c.effort[name], 2)),
      ),
    ]),
  ];
  const files = [];
  for (const c of model.cases) {
    for (const f of c.files) {
      const known = files.find((g) => g.path === f.path && g.sha256 === f.sha256 && g.role === f.role);
      if (known) known.cases.push(c.name);
      else files.push({ ...f, cases: [c.name] });
    }
  }
  const resolved = model.cases
    .filter((c) => c.resolved_case)
    .map((c) =>
      element(
        'details',
        {},
        element('summary', {}, model.several ? `Resolved case: ${c.name}` : 'Resolved case'),
        element(
          'p',
          {},
          'The complete case in SI; run again it gives the same numbers. ',
          saveButton('TOML', () =>
            save(`${fileStem(c.title, 'resolved')}.toml`, 'application/toml', c.resolved_case),
          ),
        ),
        element('pre', { tabindex: '0' }, c.resolved_case),
      ),
    );
  return section(
    'provenance',
    'Where this comes from',
    folded('Program and solver effort', table('Program and solver effort', heads, rows, { folds: true })),
    files.length === 0
      ? null
      : foldedFiles(files, {
          heads: model.several ? ['case'] : [],
          cells: (f) =>
            model.several ? [f.cases.length === model.cases.length ? 'all' : f.cases.join(', ')] : [],
        }),
    resolved,
  );
}
