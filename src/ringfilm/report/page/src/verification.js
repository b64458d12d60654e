// The page of `ringfilm verify`: what was checked, against what, and how the errors fall with refinement.
import { element, section, startViews } from './dom.js';
import { ChartView, Visibility } from './figure/chart_view.js';
import { alarm, cards, headWarning, numberCard, pageHead, showPage } from './page_head.js';
import { fold, right, table } from './tables.js';
import { display, number, typeset, typesetMath, withUnit } from './units.js';

const kHolds = 'holds';

/** Texts of a case with their units and formulas as they are printed. */
const words = (text) => typeset(typesetMath(text));

function tolerance(row) {
  if (row.tolerance_kind === 'relative') return withUnit(100 * row.tolerance, '%', 2);
  const { unit, convert } = display(row);
  return withUnit(convert(row.tolerance), unit, 2);
}

function error(row) {
  if (row.error === null) return '–';
  if (row.tolerance_kind === 'relative') return withUnit(100 * row.error, '%', 2);
  const { unit, convert } = display(row);
  return withUnit(convert(row.error), unit, 2);
}

function verdictCell(verdict) {
  return {
    text: verdict === kHolds ? 'holds' : 'FAILS',
    attributes: { class: verdict === kHolds ? 'verdict' : 'verdict failed' },
  };
}

const isOrder = (row) => row.quantity.startsWith('order in');

function rowsTable(c) {
  const heads = [
    'check',
    'quantity',
    right('expected'),
    right('got'),
    right('error'),
    right('tolerance'),
    'verdict',
  ];
  const rows = c.rows.map((row) => {
    const { unit, convert } = display(row);
    const digits = isOrder(row) ? 3 : 7;
    return [
      row.label,
      row.quantity,
      right(withUnit(convert(row.expected), unit, digits)),
      right(withUnit(convert(row.got), unit, digits)),
      right(error(row)),
      right(tolerance(row)),
      verdictCell(row.verdict),
    ];
  });
  return table(`Checks of ${c.name}`, heads, rows, { folds: true, classes: 'checks' });
}

/** Why the numbers are expected and the tolerances are what they are. */
function grounds(c) {
  return fold(
    'Sources and reasons of the tolerances',
    false,
    table(
      `Grounds of ${c.name}`,
      ['check', 'known from', 'tolerance, because'],
      c.rows.map((row) => [words(row.label), words(row.source), words(row.because)]),
      { folds: true },
    ),
  );
}

/**
 * Error against step, both logarithmic, with the slope that is expected through the finest point, or below a
 * bound.
 */
function convergenceFigure(c, line, i) {
  const steps = [...line.levels].reverse();
  const errors = [...line.errors].reverse();
  const [finest, coarsest] = [steps[0], steps[steps.length - 1]];
  const inCells = line.refinement === 'cells';
  const isBound = line.bound !== null;
  const expectedAt = (step) =>
    isBound ? line.bound * step ** line.expected_order : errors[0] * (step / finest) ** line.expected_order;
  return {
    id: `${c.name}-${i}`,
    title: line.label,
    panels: [
      {
        id: `${c.name}-${i}`,
        xScale: 'log',
        yScale: 'log',
        yLabel: 'error',
        yUnit: '',
        xLabel: inCells ? '1 / number of cells' : line.step_unit ? 'step in time' : '1 / number of steps',
        xUnit: line.step_unit,
        series: [
          {
            caseIndex: null,
            part: 'viscous',
            label: isBound ? 'bound' : `slope ${number(line.expected_order, 2)}`,
            x: [finest, coarsest],
            y: [finest, coarsest].map(expectedAt),
          },
          {
            caseIndex: null,
            part: 'measured',
            label: isBound ? 'computed' : `computed, slope ${number(line.observed_order, 3)}`,
            x: steps,
            y: errors,
          },
        ],
      },
    ],
    caption:
      'Error relative to the known value against ' +
      `${inCells ? 'the size of a cell' : 'the step in time'}, both on logarithmic axes. The ` +
      'dotted line ' +
      (isBound ? 'is the largest error allowed, a share of a cell' : 'has the slope that the scheme claims') +
      '.',
  };
}

function caseSection(c, context, views) {
  const figures = c.lines
    .filter((line) => line.errors.every((e) => e > 0))
    .map((line, i) => new ChartView(convergenceFigure(c, line, i), context));
  views.push(...figures);
  return section(
    c.name,
    c.title,
    element('p', { class: 'how' }, element('code', {}, c.name)),
    element('p', {}, words(c.claim)),
    c.stops.map((stop) => alarm('NO SOLUTION: ', stop)),
    rowsTable(c),
    grounds(c),
    figures.length
      ? element(
          'div',
          { class: 'figure row' },
          element(
            'div',
            { class: 'panels' },
            figures.map((view) => view.node),
          ),
        )
      : null,
  );
}

function firstScreen(result) {
  const rows = result.cases.flatMap((c) => c.rows);
  const held = (list) => list.filter((item) => item.verdict === kHolds).length;
  const failed = result.cases.filter((c) => c.verdict !== kHolds);
  const orders = rows.filter(isOrder);
  return pageHead(
    {
      kind: 'Computed on this machine beside answers that are known from elsewhere',
      title: 'Verification',
      operating: `${result.program}, commit ${result.commit}`,
    },
    failed.length ? alarm('FAILS: ', failed.map((c) => c.name).join(', ')) : null,
    cards(
      numberCard('Cases', held(result.cases), { of: ` of ${result.cases.length}`, detail: 'hold' }),
      numberCard('Checks', held(rows), { of: ` of ${rows.length}`, detail: 'within tolerance' }),
      numberCard('Orders of convergence', held(orders), {
        of: ` of ${orders.length}`,
        detail: 'as claimed',
      }),
    ),
    result.not_covered.length
      ? headWarning(
          'Not covered',
          `${result.not_covered.length} further cases cannot be computed by this version and are ` +
            'not counted; ',
          element('a', { href: '#not-covered' }, 'which and why'),
          '.',
        )
      : null,
  );
}

function buildPage(result) {
  const context = {
    visibility: new Visibility(),
    group: null,
    besidePaper: false,
    stem: 'verification',
    subtitle: `${result.program}, commit ${result.commit}`,
  };
  const views = [];
  const sections = result.cases.map((c) => caseSection(c, context, views));
  const parts = [
    section(
      'overview',
      'Overview',
      table(
        'Cases',
        ['case', 'checks', 'verdict'],
        result.cases.map((c) => [
          { text: [element('a', { href: `#${c.name}` }, c.title)] },
          String(c.rows.length),
          verdictCell(c.verdict),
        ]),
      ),
    ),
    ...sections,
    result.not_covered.length
      ? section(
          'not-covered',
          'Not covered',
          table(
            'Cases that this version cannot compute',
            ['case', 'reason'],
            result.not_covered.map((item) => [item.what, item.reason]),
            { folds: true },
          ),
        )
      : null,
  ];
  showPage(
    firstScreen(result),
    parts.map((node) => ({ node })),
    { contents: false },
  );
  startViews(views);
}

buildPage(JSON.parse(document.getElementById('result-data').textContent));
