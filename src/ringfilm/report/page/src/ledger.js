// The assumption ledger: what is taken for granted, and what it changes to take something else.
import { element } from './dom.js';
import { section, table } from './tables.js';
import { percent, withUnit } from './units.js';

/** The values whose change is told, in this order. */
const kTold = [
  ['fmep', 'FMEP'],
  ['mean_power_loss', 'mean power'],
  ['min_film_thickness', 'minimum film'],
  ['film_parameter_at_peak_pressure', 'λ at peak pressure'],
  ['mean_absolute_oil_flow', 'mean oil flow'],
];

function changeCell(model, base, variant, name) {
  const { value, unit } = model.value(variant, name);
  const before = model.value(base, name).value;
  const ratio = before ? (value - before) / Math.abs(before) : NaN;
  const strong = Math.abs(ratio) >= 0.1 ? 'strong' : '';
  return { text: [element('span', { class: 'whole' }, withUnit(value, unit, 3)), ' ', element('span', { class: `change ${strong}` }, percent(ratio))], attributes: { class: 'number' } };
}

function asRunCell(model, c, name) {
  const { value, unit } = model.value(c, name);
  return { text: withUnit(value, unit, 3), attributes: { class: 'number' } };
}

function variantTable(model, topic, entries) {
  const rows = [];
  for (const { c, entry } of entries) {
    if (entry.variants.length === 0) continue;
    rows.push([{ text: 'as run' }, ...(model.several ? [c.name] : []), ...kTold.map(([name]) => asRunCell(model, c, name))]);
    for (const v of entry.variants) {
      const cells = v.solved
        ? kTold.map(([name]) => changeCell(model, c, v, name))
        : [{ text: `no solution: ${v.reason}`, attributes: { colspan: kTold.length } }];
      rows.push([{ text: element('code', {}, v.setting) }, ...(model.several ? [c.name] : []), ...cells]);
    }
  }
  if (rows.length === 0) return null;
  return table(`What lifting it changes: ${topic}`, ['setting', ...(model.several ? ['case'] : []), ...kTold.map(([, label]) => label)], rows, { classes: 'variants' });
}

/** Statements of all cases, told once where they agree. */
function statements(model, entries) {
  const told = [];
  for (const { c, entry } of entries) {
    const known = told.find((t) => t.statement === entry.statement);
    if (known) known.cases.push(c.name);
    else told.push({ statement: entry.statement, cases: [c.name] });
  }
  if (told.length === 1) return element('p', { class: 'statement' }, told[0].statement);
  return element('ul', { class: 'statement' }, told.map((t) => element('li', {}, element('b', {}, `${t.cases.join(', ')}: `), t.statement)));
}

export function ledgerSection(model) {
  const topics = [...new Set(model.cases.flatMap((c) => c.ledger.map((entry) => entry.topic)))];
  if (topics.length === 0) return null;
  const computed = model.cases.some((c) => c.ledger_computed);
  const articles = topics.map((topic) => {
    const entries = model.cases.flatMap((c) => c.ledger.filter((entry) => entry.topic === topic).map((entry) => ({ c, entry })));
    const { entry } = entries[0];
    const standing = entry.can_be_lifted
      ? entries.some((e) => e.entry.variants.length > 0) ? 'another choice was run' : 'another choice exists; not computed'
      : 'cannot be lifted here';
    return element('article', { class: 'assumption' },
      element('h3', {}, element('span', {}, topic.replace(/-/g, ' ')), ' ', element('span', { class: `standing ${entry.can_be_lifted ? 'liftable' : ''}` }, standing)),
      statements(model, entries),
      entry.consequence ? element('p', { class: 'consequence' }, entry.consequence) : null,
      variantTable(model, topic, entries),
      entry.source ? element('p', { class: 'source' }, 'Argued in ', element('code', {}, entry.source)) : null);
  });
  return section('ledger', 'What is assumed, and what it decides',
    element('p', {}, computed
      ? 'Where the program offers another choice, the cycle was run again with that choice alone; changes are against the case as run, those of 10\u00a0% and more in bold.'
      : 'The other choices were not computed for this result; run with --ledger to have them.'),
    articles);
}
