// The assumption ledger: what is taken for granted, and what it changes to take something else.
import { code, element } from '../dom.js';
import { axisTitle } from '../plot/scales.js';
import { section } from '../tables.js';
import { number, percent, sentence } from '../units.js';

/** The values whose change is reported, in this order, with heads short enough for a phone. */
const kReported = [
  ['fmep', 'FMEP'],
  ['mean_power_loss', 'mean power'],
  ['min_film_thickness', 'min film'],
  ['lambda_ratio_at_peak_pressure', 'λ at peak'],
  ['mean_absolute_oil_flow', 'oil flow'],
];

/** From this relative change on a number is in bold. */
const kStrong = 0.1;

function valueCell(model, values, name, base) {
  const { value } = model.value(values, name);
  const before = base ? model.value(base, name).value : null;
  const ratio = before ? (value - before) / Math.abs(before) : NaN;
  const change = base
    ? element('span', { class: `change ${Math.abs(ratio) >= kStrong ? 'strong' : ''}` }, percent(ratio))
    : element('span', { class: 'change' });
  return element('td', { class: 'number' }, number(value, 3), ' ', change);
}

/** One group of rows a setting, one row a case in it. */
function variantTable(model, topic, entries) {
  const settings = [...new Set(entries.flatMap(({ entry }) => entry.variants.map((v) => v.setting)))];
  if (settings.length === 0) return null;
  const name = (c) => (model.several ? element('th', { scope: 'row' }, c.name) : null);
  const group = (heading, rows) =>
    element(
      'tbody',
      {},
      element(
        'tr',
        { class: 'setting' },
        element('th', { scope: 'rowgroup', colspan: kReported.length + (model.several ? 1 : 0) }, heading),
      ),
      rows,
    );
  const base = group(
    'as run',
    entries.map(({ c }) =>
      element(
        'tr',
        {},
        name(c),
        kReported.map(([value]) => valueCell(model, c, value)),
      ),
    ),
  );
  const changed = settings.map((setting) =>
    group(
      code(setting),
      entries.flatMap(({ c, entry }) => {
        const variant = entry.variants.find((v) => v.setting === setting);
        if (!variant) return [];
        const cells = variant.solved
          ? kReported.map(([value]) => valueCell(model, variant, value, c))
          : element('td', { colspan: kReported.length }, `No solution: ${sentence(variant.reason)}`);
        return [element('tr', {}, name(c), cells)];
      }),
    ),
  );
  const heads = kReported.map(([value, label]) =>
    element(
      'th',
      { scope: 'col', class: 'number' },
      axisTitle(label, model.value(model.cases[0], value).unit),
    ),
  );
  const caption = `What another choice changes: ${topic.replace(/-/g, ' ')}`;
  return element(
    'div',
    { class: 'table-scroll', tabindex: '0', role: 'region', 'aria-label': caption },
    element(
      'table',
      { class: 'variants' },
      element('caption', {}, caption),
      element(
        'thead',
        {},
        element('tr', {}, model.several ? element('th', { scope: 'col' }, 'case') : null, heads),
      ),
      base,
      changed,
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
  if (reported.length === 1) return element('p', { class: 'statement' }, sentence(reported[0].statement));
  return element(
    'ul',
    { class: 'statement' },
    reported.map((t) =>
      element('li', {}, element('b', {}, `${t.cases.join(', ')}: `), sentence(t.statement)),
    ),
  );
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
        categories: ranked.map(([name]) => name),
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
      `. The strongest: ${setting} moves FMEP by ` +
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
  const articles = topics.map((topic) => {
    const entries = model.cases.flatMap((c) =>
      c.ledger.filter((entry) => entry.topic === topic).map((entry) => ({ c, entry })),
    );
    const { entry } = entries[0];
    const standing = entry.can_be_lifted
      ? entries.some((e) => e.entry.variants.length > 0)
        ? 'another choice was run'
        : 'another choice exists; not computed'
      : 'cannot be lifted here';
    return element(
      'article',
      { class: 'assumption' },
      element(
        'h3',
        {},
        element('span', {}, topic.replace(/-/g, ' ')),
        ' ',
        element('span', { class: `standing ${entry.can_be_lifted ? 'liftable' : ''}` }, standing),
      ),
      statements(model, entries),
      entry.consequence ? element('p', { class: 'consequence' }, sentence(entry.consequence)) : null,
      variantTable(model, topic, entries),
      entry.source ? element('p', { class: 'source' }, 'Argued in ', code(entry.source)) : null,
    );
  });
  return section(
    'ledger',
    'What is assumed, and what it decides',
    element(
      'p',
      {},
      computed
        ? 'Where the program offers another choice, the cycle was run again with that choice ' +
            'alone; changes are against the case as run, those of 10\u00a0% and more in bold.'
        : 'The other choices were not computed for this result; run with --ledger to have them.',
    ),
    influence,
    articles,
  );
}
