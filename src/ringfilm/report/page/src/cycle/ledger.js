// The assumption ledger: what is taken for granted, and what it changes to take something else.
import { element, section } from '../dom.js';
import { axisTitle } from '../plot/scales.js';
import { scrolling, table } from '../tables.js';
import { number, percent, sentence, withUnit } from '../units.js';
import { settingWords } from './setting_words.js';

/** The values whose change is reported, in this order, with heads short enough for a phone. */
const kReported = [
  ['fmep', 'FMEP'],
  ['min_film_thickness', 'min film'],
  ['lambda_ratio_at_peak_pressure', 'λ at peak'],
  ['mean_boundary_power', 'boundary power'],
  ['mean_absolute_oil_flow', 'oil passing under'],
];

/** From this relative change on a number is in bold. */
const kStrong = 0.1;

/** The change of a value against the case as run, its own size on demand. */
function changeCell(model, variant, name, base) {
  const { value, unit } = model.value(variant, name);
  const before = model.value(base, name).value;
  const ratio = before ? (value - before) / Math.abs(before) : NaN;
  return element(
    'td',
    {
      class: `number ${Math.abs(ratio) >= kStrong ? 'strong' : ''}`,
      title: value === null ? null : withUnit(value, unit, 3),
    },
    percent(ratio),
  );
}

/** Rows of one choice, one a case that has it: the first cell names the choice for all of them. */
function choiceRows(model, heading, attributes, rows) {
  return rows.map(({ c, cells }, i) =>
    element(
      'tr',
      { class: i === 0 ? 'first' : '' },
      i === 0 ? element('th', { scope: 'rowgroup', rowspan: rows.length, ...attributes }, heading) : null,
      model.several ? element('th', { scope: 'row' }, c.name) : null,
      cells,
    ),
  );
}

/** All choices in one table: changes of the values against the case as run. Null where none was run. */
function matrix(model) {
  const settings = [
    ...new Set(model.cases.flatMap((c) => c.ledger.flatMap((e) => e.variants.map((v) => v.setting)))),
  ];
  if (settings.length === 0) return null;
  const asRun = model.cases.map((c) => ({
    c,
    cells: kReported.map(([name]) =>
      element('td', { class: 'number' }, number(model.value(c, name).value, 3)),
    ),
  }));
  const changed = (setting) =>
    model.cases.flatMap((c) => {
      const variant = c.ledger.flatMap((entry) => entry.variants).find((v) => v.setting === setting);
      if (!variant) return [];
      const cells = variant.solved
        ? kReported.map(([name]) => changeCell(model, variant, name, c))
        : element('td', { colspan: kReported.length }, `No solution: ${sentence(variant.reason)}`);
      return [{ c, cells }];
    });
  const heads = kReported.map(([name, label]) =>
    element(
      'th',
      { scope: 'col', class: 'number' },
      axisTitle(label, model.value(model.cases[0], name).unit),
    ),
  );
  const caption = 'What another choice changes, one at a time';
  return scrolling(
    caption,
    element(
      'table',
      { class: 'variants' },
      element('caption', {}, caption),
      element(
        'thead',
        {},
        element(
          'tr',
          {},
          element('th', { scope: 'col' }, 'other choice'),
          model.several ? element('th', { scope: 'col' }, 'case') : null,
          heads,
        ),
      ),
      element('tbody', { class: 'base' }, choiceRows(model, 'as run', {}, asRun)),
      settings.map((setting) =>
        element('tbody', {}, choiceRows(model, settingWords(setting), { title: setting }, changed(setting))),
      ),
    ),
  );
}

/** Statements of all cases, reported once where they agree. */
function statements(model, entries) {
  const reported = [];
  for (const { c, entry } of entries) {
    const known = reported.find((t) => t.statement === entry.statement);
    if (known) known.cases.push(c.name);
    else reported.push({ statement: entry.statement, cases: [c.name] });
  }
  if (reported.length === 1) return [sentence(reported[0].statement)];
  return reported.map((t) =>
    element('span', { class: 'of-case' }, element('b', {}, `${t.cases.join(', ')}: `), sentence(t.statement)),
  );
}

/** What is taken for granted, one row a topic. */
function assumptionTable(model, topics) {
  const rows = topics.map((topic) => {
    const entries = model.cases.flatMap((c) =>
      c.ledger.filter((entry) => entry.topic === topic).map((entry) => ({ c, entry })),
    );
    const { entry } = entries[0];
    const standing = entry.can_be_lifted
      ? entries.some((e) => e.entry.variants.length > 0)
        ? 'computed above'
        : 'not computed'
      : 'none in this program';
    const name = topic.replace(/-/g, ' ');
    return [
      { text: name[0].toUpperCase() + name.slice(1), attributes: { title: entry.source || null } },
      { text: statements(model, entries) },
      sentence(entry.consequence) || '–',
      standing,
    ];
  });
  return table('Assumptions', ['assumption', 'what is assumed', 'what follows', 'other choice'], rows, {
    folds: true,
    classes: 'assumptions',
  });
}

/** How many settings the figure of influences ranks. */
const kRanked = 12;

/**
 * Which other choice moves the friction most: relative change of FMEP, strongest first. Null where no variant
 * was run.
 */
export function influenceFigure(model) {
  const settings = new Map();
  for (const c of model.cases) {
    for (const variant of c.ledger.flatMap((entry) => entry.variants)) {
      const before = c.values.fmep;
      const change =
        variant.solved && before && variant.values.fmep !== null
          ? (100 * (variant.values.fmep - before)) / before
          : null;
      if (!settings.has(variant.setting))
        settings.set(
          variant.setting,
          model.cases.map(() => null),
        );
      settings.get(variant.setting)[c.index] = change;
    }
  }
  const strength = (changes) => Math.max(...changes.map((v) => Math.abs(v ?? 0)));
  const ranked = [...settings].sort((a, b) => strength(b[1]) - strength(a[1])).slice(0, kRanked);
  if (ranked.length === 0) return null;
  const [setting, changes] = ranked[0];
  return {
    id: 'influences',
    title: 'What moves the friction most',
    panels: [
      {
        id: 'influences',
        bars: true,
        ranked: true,
        yLabel: 'change of FMEP',
        yUnit: '%',
        categories: ranked.map(([name]) => settingWords(name)),
        groups: model.cases.map((c) => ({
          caseIndex: c.series,
          label: c.name,
          stacks: ranked.map(([, list]) => [{ part: 'total', value: list[c.index] }]),
        })),
      },
    ],
    caption:
      'Each line is the same case with one other choice' +
      (settings.size > ranked.length ? `; the ${ranked.length} strongest of ${settings.size}` : '') +
      `. The strongest, ${settingWords(setting)}, moves FMEP by ` +
      model.cases
        .map((c, i) => `${percent((changes[i] ?? NaN) / 100)}${model.several ? ` (${c.name})` : ''}`)
        .join(', ') +
      '.',
  };
}

/** @param influence the node of the figure of influences, null if there is none */
export function ledgerSection(model, influence) {
  const topics = [...new Set(model.cases.flatMap((c) => c.ledger.map((entry) => entry.topic)))];
  if (topics.length === 0) return null;
  const computed = model.cases.some((c) => c.ledger_computed);
  return section(
    'ledger',
    'What is assumed, and what it decides',
    element(
      'p',
      {},
      computed
        ? 'Where the program offers another choice, the cycle was run again with that choice ' +
            'alone. Changes are against the case as run, those of 10\u00a0% and more in bold; mean power ' +
            'changes as FMEP does.'
        : 'The other choices were not computed for this result; run with --ledger to have them.',
    ),
    influence,
    matrix(model),
    assumptionTable(model, topics),
    element('p', { class: 'how' }, 'Theory and reasons: docs/theory/assumptions.md.'),
  );
}
