// First screen and tables of a study.
import { code, element, section } from '../dom.js';
import { alarm, cards, notesBox, pageHead } from '../page_head.js';
import { axisTitle } from '../plot/scales.js';
import { differenceOf, middleOf, middleWord } from './study_compare.js';
import { count } from './study_model.js';
import { cardsSentence, cardValues, studyCard, swatch } from './study_cards.js';
import { shareText } from './study_spread.js';
import { fold, foldedFiles, isWide, programRows, right, table, withCsv } from '../tables.js';
import { number, percent, sentence, typeset, withUnit } from '../units.js';

const kKinds = {
  map: 'A map: many operating points',
  uncertainty: 'Uncertainty: what the scatter of the inputs leaves in friction and film',
  compare: 'A comparison of engine cycles',
  screening: 'Screening: which inputs matter at all',
};

/** Values beside the main ones whose errors are the largest. */
const kOtherErrors = 6;

function points(model) {
  const n = model.scenarios / model.bases.length;
  const rows = model.points_per_row > 1 ? `${count(n / model.points_per_row)} ` : '';
  return (
    {
      grid: 'full grid',
      'one-at-a-time': 'one factor at a time',
      list: `list of ${count(n)} points`,
      'operating-points': `${count(n)} operating points`,
      'latin-hypercube': `Latin hypercube of ${count(n)} points`,
      sobol: model.has_indices
        ? `scrambled Sobol points, ${rows}rows of ${model.points_per_row} for the indices`
        : `${count(n)} scrambled Sobol points`,
      morris: `${rows}trajectories after Morris`,
    }[model.method] ?? model.method
  );
}

/** Reasons that differ in their numbers alone are reported with those of the first. */
const reasonText = (r) =>
  `${sentence(r.reason)}${r.numbers_differ ? ' The numbers are those of the first.' : ''}`;

/** Notes on results that mean little in their order of severity, then the most frequent. */
function byWeight(scenarioNotes) {
  const serious = scenarioNotes.filter((note) => note.serious);
  return [...serious, ...scenarioNotes.filter((note) => !note.serious).sort((a, b) => b.count - a.count)];
}

export function firstScreen(model) {
  const failed = model.unsolved.count;
  const notes = model.notes.map((note) => [sentence(note)]);
  const [first] = byWeight(model.scenario_notes.filter((note) => note.topic !== 'accuracy-asked-for'));
  if (first) {
    const others = model.scenario_notes.length - 1;
    const more = others > 0 ? `${others} more ${others === 1 ? 'note' : 'notes'} on results` : 'Which ones';
    notes.unshift([
      `${count(first.count)} of ${count(model.scenarios)} scenarios: ${sentence(first.message)} `,
      element('a', { href: '#notes' }, more),
    ]);
  }
  const bases = model.several
    ? `${model.bases.length} bases (${model.bases.map((b) => b.name).join(', ')})`
    : `base ${model.bases[0].name}`;
  const factors = `${model.factors.length} ${model.factors.length === 1 ? 'factor' : 'factors'}`;
  return pageHead(
    {
      kind: kKinds[model.kind] ?? 'A study',
      title: model.title || 'A study',
      operating: `${count(model.scenarios)} scenarios: ${bases}, ${factors}, ${points(model)}, seed ${model.seed}`,
    },
    failed > 0
      ? alarm(`${count(failed)} of ${count(model.scenarios)} scenarios NOT SOLVED. `, [
          `${model.unsolved.reasons[0].count > 1 ? 'Most often' : 'The first'}: ` +
            `${reasonText(model.unsolved.reasons[0])} `,
          element('a', { href: '#unsolved' }, 'All reasons'),
        ])
      : null,
    model.solved > 0 ? cards(cardValues(model).map((name) => studyCard(model, name))) : null,
    model.solved > 0 ? element('p', { class: 'how' }, cardsSentence(model)) : null,
    notesBox(notes),
  );
}

const kHow = { set: 'is', scale: 'times the base’s', add: 'added to the base’s' };

export function variedSection(model) {
  const rows = model.factors.map((f) => [
    f.name,
    { text: f.keys.flatMap((key, i) => [i ? ', ' : '', code(key)]) },
    kHow[f.how] ?? f.how,
    typeset(f.words),
    ...(model.several
      ? [
          f.bases.length === model.bases.length
            ? 'all'
            : f.bases.map((b) => model.bases[b].name).join(', ') || 'none',
        ]
      : []),
    f.source || 'not stated',
  ]);
  const measured = model.factors.filter((f) => f.origin === 'measured').length;
  const correlations = model.correlations.map(
    (c) =>
      `${model.factors[c.factors[0]].name} and ${model.factors[c.factors[1]].name} ${number(c.value, 2)}`,
  );
  return section(
    'varied',
    'What varied',
    element(
      'p',
      {},
      `${
        measured === 0
          ? 'No scatter was taken over from a measurement: ranges and distributions are as the study’s \
file states them, with the source that it states.'
          : measured === model.factors.length
            ? 'All scatter is what was measured.'
            : `${measured} of ${model.factors.length} factors have the scatter that was measured; the others are as \
the study’s file states them.`
      }`,
      correlations.length ? ` Correlations of the normal scores: ${correlations.join('; ')}.` : '',
    ),
    table(
      'Factors',
      [
        'factor',
        'key of the case',
        'the number',
        'varies',
        ...(model.several ? ['bases'] : []),
        'where from',
      ],
      rows,
      { folds: true },
    ),
    model.several
      ? table(
          'Bases',
          ['base', 'case', right('scenarios')],
          model.bases.map((b) => [
            { text: [swatch(b.index), ' ', b.name] },
            b.title || '–',
            right(count(b.points)),
          ]),
          { folds: true },
        )
      : null,
  );
}

const interval = (q, triple, digits) => {
  const [value, low, high] = triple.map((v) => q.convert(v));
  const ends =
    low === null && high === null
      ? ''
      : `${low === null ? '…' : number(low, digits)} to ${high === null ? '…' : number(high, digits)}`;
  return {
    text: [number(value, digits), ends ? element('span', { class: 'interval' }, ends) : ''],
    attributes: { class: 'number' },
  };
};

export function statisticsSection(model, context) {
  const kShown = [0, 2, 4];
  // A median of points that were not sampled means nothing.
  const chosen = [...(model.points.length ? ['weighted_mean'] : []), 'lowest', 'highest'];
  const heads = model.has_sample
    ? ['quantity', right('mean'), ...kShown.map((k) => right(shareText(model.shares[k])))]
    : ['quantity', ...chosen.map((key) => right(key.replace('_', ' ')))];
  const rows = (b) =>
    model.quantities.map((described) => {
      const q = model.quantity.get(described.name);
      const s = model.statistics[q.name][b];
      const name = {
        text: [q.long_name, q.shown ? element('span', { class: 'unit' }, ` [${q.shown}]`) : ''],
      };
      if (!s) return [name, ...heads.slice(1).map(() => right('–'))];
      if (!model.has_sample) return [name, ...chosen.map((key) => right(number(q.convert(s[key]), 4)))];
      return [
        name,
        s.mean ? interval(q, s.mean, 4) : right('–'),
        ...kShown.map((k) => interval(q, s.quantiles[k], 4)),
      ];
    });
  const columns = () => {
    const all = model.bases.flatMap((b) =>
      model.quantities.map((described) => ({
        b,
        q: model.quantity.get(described.name),
        s: model.statistics[described.name][b.index],
      })),
    );
    const fixed = [
      { title: 'base', values: all.map(({ b }) => b.name) },
      { title: 'quantity', values: all.map(({ q }) => q.name) },
      { title: 'unit', values: all.map(({ q }) => q.shown) },
      { title: 'scenarios', values: all.map(({ s }) => s?.n ?? 0) },
    ];
    if (!model.has_sample)
      return [
        ...fixed,
        ...chosen.map((key) => ({
          title: key.replace('_', ' '),
          values: all.map(({ q, s }) => (s ? q.convert(s[key]) : null)),
        })),
      ];
    const triple = (title, of) =>
      ['', ', low', ', high'].map((end, i) => ({
        title: title + end,
        values: all.map(({ q, s }) => {
          const t = s && of(s);
          return t ? q.convert(t[i]) : null;
        }),
      }));
    return [
      ...fixed,
      ...triple('mean', (s) => s.mean),
      { title: 'standard deviation', values: all.map(({ q, s }) => (s ? q.convert(s.deviation) : null)) },
      ...model.shares.flatMap((share, k) => triple(`${100 * share} %`, (s) => s.quantiles[k])),
    ];
  };
  const counts = model.bases.map((b) => model.statistics[model.main_values[0]][b.index]);
  return section(
    'values',
    'Values of the cycle',
    withCsv(
      element(
        'p',
        {},
        model.has_sample
          ? `Over the scenarios of the sample (${[...new Set(counts.map((s) => count(s?.n ?? 0)))].join(
              ', \
',
            )}${model.several ? ' of each base' : ''}${
              counts.some((s) => s?.omitted)
                ? `, without \
${counts.map((s) => count(s?.omitted ?? 0)).join(', ')} that were not solved`
                : ''
            }); in small type the 95 % \
confidence interval of each number, … where so few scenarios do not determine it.`
          : `Over all ${model.points.length ? 'operating points, with their weights' : 'scenarios of the plan'}: \
they are not a sample and do not show how likely a value is.`,
      ),
      'Values of the cycle',
      context,
      'values',
      columns,
    ),
    model.bases.map((b) => {
      const content = table(`Values of the cycle, ${b.name}`, heads, rows(b.index), {
        classes: 'statistics titled',
      });
      return model.several ? fold([swatch(b.index), ' ', b.name], b.index === 0, content) : content;
    }),
  );
}

/** The operating points of each base with their main values, and the weighted means. */
export function pointsSection(model) {
  if (model.points.length === 0) return null;
  const shown = model.mainValues;
  const heads = [
    'operating point',
    right('weight'),
    ...shown.map((q) => right(axisTitle(q.short_name, q.shown))),
  ];
  return section(
    'points',
    'Operating points',
    element('p', {}, 'Weights are shares of their sum. A mean is missing where a point was not solved.'),
    model.bases.map((b) => {
      const rows = model.points.map((point, p) => [
        point.name,
        right(withUnit(100 * point.share, '%', 3)),
        ...shown.map((q) => right(number(q.convert(model.point_values[q.name][b.index][p]), 4))),
      ]);
      const means = shown.map((q) => {
        const mean = model.statistics[q.name][b.index]?.weighted_mean ?? null;
        return { text: element('b', {}, number(q.convert(mean), 4)), attributes: { class: 'number' } };
      });
      const name = model.several ? `Operating points, ${b.name}` : 'Operating points';
      return table(name, heads, [...rows, ['weighted mean', '', ...means]], {
        folds: true,
        classes: 'titled',
      });
    }),
  );
}

export function differencesTable(model) {
  const shown = model.mainValues.filter((q) => model.comparison[q.name]);
  const groups = model.comparison_groups;
  const middle = (q, s) => (!s ? '–' : withUnit(q.convert(middleOf(model, s)), '', 4));
  const others = groups
    .slice(1)
    .map((_, i) => shown.some((q) => model.comparison[q.name][i + 1]?.difference));
  const [paired, alone] = [others.some(Boolean), model.has_sample && others.some((one) => !one)];
  const whom = alone ? 'Where an interval is given, both' : groups.length > 2 ? 'All' : 'Both';
  const rows = groups.map((g, k) => [
    g.name,
    ...shown.map((q) => {
      const difference = differenceOf(model, q, k);
      return {
        text: [
          middle(q, model.comparison[q.name][k]),
          difference
            ? element('span', { class: `change ${difference.sure ? 'strong' : ''}` }, difference.text)
            : '',
          difference?.interval ? element('span', { class: 'interval' }, difference.interval) : '',
        ],
        attributes: { class: 'number' },
      };
    }),
  ]);
  return [
    element(
      'p',
      {},
      `${middleWord(model)[0].toUpperCase()}${middleWord(model).slice(1)}, and the change against ${groups[0].name}.`,
      paired
        ? ` ${whom} were run at the same points, so that what they have in common cancels: the change is that of the \
mean, with its 95 % confidence interval below it; in bold where that leaves no doubt about the sign.${
            alone
              ? ' \
Without one the points differ, and the change is that of the median.'
              : ''
          }`
        : alone
          ? ' The points differ, and the change is that of the median.'
          : '',
    ),
    table(
      `Against ${groups[0].name}`,
      ['', ...shown.map((q) => right(axisTitle(q.short_name, q.shown)))],
      rows,
      { folds: true, classes: 'differences' },
    ),
  ];
}

/** Total indices of all main values: which input decides what. */
export function indicesTable(model) {
  const shown = model.mainValues.filter((q) => model.indices[q.name]?.some(Boolean));
  if (shown.length === 0) return null;
  return model.bases.map((b) =>
    fold(
      model.several
        ? [swatch(b.index), ` Total indices of all main values, ${b.name}`]
        : 'Total indices of all main values',
      b.index === 0 && isWide(),
      table(
        `Total indices, ${b.name}`,
        ['factor', ...shown.map((q) => right(q.short_name))],
        model.groups
          .map((name, g) => ({ name, g }))
          .filter(({ g }) => shown.some((q) => model.indices[q.name][b.index]?.total[g]))
          .map(({ name, g }) => [
            name,
            ...shown.map((q) => {
              const t = model.indices[q.name][b.index]?.total[g];
              return right(
                t ? number(Math.max(0, t[0]), 2) : '–',
                t
                  ? {
                      style: `background: rgba(0, 63, 125, ${Math.min(0.35, Math.max(0, 0.35 * t[0])).toFixed(3)})`,
                    }
                  : {},
              );
            }),
          ]),
        { classes: 'titled' },
      ),
    ),
  );
}

/** Notes on the results of single scenarios, those on results that mean little first, then the most frequent. */
export function notesSection(model) {
  if (model.scenario_notes.length === 0) return null;
  const notes = byWeight(model.scenario_notes);
  const bases = model.several ? model.bases : [];
  return section(
    'notes',
    'Notes on the results',
    element(
      'p',
      {},
      `What single results note: a model beyond its range, a remedy of the solver. Such scenarios count in all \
statistics. The figures are those of the scenario in the last column: where the note is worst, or, if no value of the \
cycle measures that, the first one with it. The result file lists all scenarios.`,
    ),
    table(
      'Notes',
      [right('scenarios'), ...bases.map((b) => right(b.name)), 'note', 'topic', right('figures of')],
      notes.map((n) => [
        right(`${count(n.count)} of ${count(model.scenarios)}`),
        ...bases.map((b) => right(count(n.counts[b.index]))),
        sentence(n.message),
        { text: code(n.topic) },
        right(`${n.is_worst ? 'worst: ' : 'first: '}${n.scenario}`),
      ]),
      { folds: true },
    ),
  );
}

/** How accurate the values are, as far as it was estimated on a sample. */
export function accuracySection(model) {
  const error = model.error;
  if (!error || error.count === 0) return null;
  const names = Object.keys(error.quantiles);
  const main = new Set(model.main_values);
  const ordered = [
    ...names.filter((name) => main.has(name)),
    ...names
      .filter((name) => !main.has(name))
      .sort((a, b) => error.quantiles[b] - error.quantiles[a])
      .slice(0, kOtherErrors),
  ];
  return section(
    'accuracy',
    'Numerical accuracy',
    element(
      'p',
      {},
      `Estimated on ${count(error.count)} of ${count(model.scenarios)} scenarios, which were integrated again with \
twice the cells and half the steps.${error.unsolved ? ` Not solved: ${count(error.unsolved)} more.` : ''}${
        error.coverage === null
          ? ''
          : ` ${number(100 * error.coverage, 3)} % of their ${count(error.values)} values are within the \
${error.asked.join(' or ')} % asked for.`
      } The main values come first, then the largest errors of others; the result file has all.`,
    ),
    table(
      'Relative error',
      ['quantity', right('95 % quantile of the relative error [%]')],
      ordered.map((name) => [
        model.quantity.get(name).long_name,
        // A value with such an error is not determined, however much larger it is.
        right(error.quantiles[name] > 1 ? 'more than 100' : number(100 * error.quantiles[name], 2)),
      ]),
      { folds: true },
    ),
  );
}

export function unsolvedSection(model) {
  const { count: failed, n_reasons: n, reasons } = model.unsolved;
  if (failed === 0) return null;
  return section(
    'unsolved',
    'Scenarios that were not solved',
    element(
      'p',
      {},
      `${count(failed)} of ${count(model.scenarios)} (${percent(failed / model.scenarios).replace('+', '')}). They \
are omitted from all statistics, which are those of what could be run.${
        n > reasons.length
          ? ` The ${reasons.length} \
most frequent of ${n} reasons; the result file has all.`
          : ''
      }`,
    ),
    table(
      'Reasons',
      [right('scenarios'), 'reason', right('the first')],
      reasons.map((r) => [right(count(r.count)), reasonText(r), right(String(r.first))]),
      { folds: true },
    ),
  );
}

export function provenanceSection(model) {
  return section(
    'provenance',
    'Where this comes from',
    table(
      'Program and plan',
      ['what', ''],
      [
        ...programRows(model.provenance),
        ['plan', `${points(model)}, seed ${model.seed}: the same file gives the same scenarios`],
      ],
    ),
    foldedFiles(model.files),
  );
}
