// Computed values next to published ones, and next to those of a second implementation.
import { code, element, section } from '../dom.js';
import { folded, right, table } from '../tables.js';
import { asStated, display, percent, sentence, typeset, withUnit } from '../units.js';

/** Closer than this, nothing is left to explain by another setting. */
const kAgrees = 0.01;

/** The source of rows that no publication states. */
const kSecondImplementation = 'independent implementation';

const isCrossCheck = (row) => row.source === kSecondImplementation;

/** What is compared, computed, given and the deviation. */
function figures(model, row) {
  const quantity = model.cycleQuantity.get(row.quantity);
  const { unit, convert } = quantity ? display(quantity) : { unit: '', convert: (v) => v };
  return [
    sentence(row.statement).replace(/\.$/, ''),
    right(withUnit(convert(row.computed), unit)),
    right(asStated(convert(row.published), unit)),
    right(percent(row.deviation)),
  ];
}

function publishedRow(model, c, row) {
  const quantity = model.cycleQuantity.get(row.quantity);
  const { unit, convert } = quantity ? display(quantity) : { unit: '', convert: (v) => v };
  const isSensitive = row.strongest_setting && !(Math.abs(row.deviation) < kAgrees);
  const strongest = isSensitive
    ? [
        code(row.strongest_setting),
        row.with_strongest_setting === null
          ? ''
          : ` gives ${withUnit(convert(row.with_strongest_setting), unit, 3)}`,
      ]
    : c.ledger_computed
      ? '–'
      : 'not computed';
  return [...figures(model, row), row.source, typeset(row.decided_by) || '–', { text: strongest }];
}

const kPublishedHeads = [
  'what',
  right('computed'),
  right('published'),
  right('deviation'),
  'source',
  'decided by',
  'setting that comes closest',
];

function crossCheck(model, shown) {
  const rows = shown.flatMap((c) =>
    c.comparison.filter(isCrossCheck).map((row) => {
      const [what, ...numbers] = figures(model, row);
      return [what, ...(model.several ? [c.name] : []), ...numbers];
    }),
  );
  if (rows.length === 0) return null;
  const heads = [right('computed'), right('second program'), right('deviation')];
  return element(
    'div',
    { class: 'cross-check' },
    element('h3', {}, 'Cross-check with a second program'),
    element(
      'p',
      {},
      'It solves the same equations with the same inputs and shares no code with this one: agreement shows ' +
        'that the equations are solved alike, not that they are right.',
    ),
    folded(
      `${rows.length} values of both programs`,
      table(
        'Cross-check with a second program',
        ['what', ...(model.several ? ['case'] : []), ...heads],
        rows,
        { folds: true },
      ),
    ),
  );
}

export function comparisonSection(model) {
  const shown = model.cases.filter((c) => c.comparison.length > 0);
  if (shown.length === 0) return null;
  const published = shown.filter((c) => c.comparison.some((row) => !isCrossCheck(row)));
  return section(
    'comparison',
    'Next to the published values',
    published.length
      ? element(
          'p',
          {},
          'Deviation is computed minus published, over published. "Decided by" names the inputs that ' +
            'the source leaves open; the last column is the one other choice of such an input that ' +
            'comes closest.',
        )
      : null,
    published.map((c) =>
      table(
        model.several ? c.name : 'Computed and published values',
        kPublishedHeads,
        c.comparison.filter((row) => !isCrossCheck(row)).map((row) => publishedRow(model, c, row)),
        { folds: true, classes: 'comparison' },
      ),
    ),
    crossCheck(model, shown),
  );
}
