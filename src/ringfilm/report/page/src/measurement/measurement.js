// The page of a measurement: what an instrument gave, what became of it, and what a case takes from it.
import { element, section, startViews } from '../dom.js';
import { ChartView, Visibility } from '../figure/chart_view.js';
import { boreFigure } from './bore_figure.js';
import { DrawingView } from '../figure/drawing_view.js';
import { mapFigure } from '../plot/map_figure.js';
import { curveFigure, withoutPoints } from './measurement_figures.js';
import { fragmentBlock, groupTable, numbersTable, shownNumber } from './measurement_tables.js';
import {
  card,
  cardRow,
  cards,
  cardValue,
  charts,
  noteList,
  notesBox,
  pageHead,
  showPage,
} from '../page_head.js';
import { programRows, table } from '../tables.js';
import { sentence, typeset, typesetSymbol, typesetUnit, withoutFolders } from '../units.js';

const kKinds = {
  surface: 'A measured surface and its roughness',
  pair: 'Two measured surfaces and their contact',
  face: 'A measured ring face and its shape',
  conformity: 'A ring in its bore',
  contact: 'Contact law of a measured pair',
  'contact-of-case': 'Contact law of a case',
  'friction-band': 'Friction by contact law',
  'lateral-force': 'Friction loops and the coefficient of boundary shear strength',
};

const kKeyValues = 3;

function keyValues(measurement) {
  const all = measurement.groups.flatMap((group) => group.values);
  const named = measurement.key_values.map((name) => all.find((value) => value.name === name));
  return named.length ? named : all.filter((value) => value.value !== null).slice(0, kKeyValues);
}

function valueCard(value) {
  const whole = shownNumber(value);
  const [shown, error] = whole.startsWith('(') ? [whole] : whole.split(' ± ');
  const unit = typesetUnit(value.unit);
  const after = (error ? ` ± ${error}` : '') + (unit && shown !== '–' ? ` ${unit}` : '');
  const symbol = element('span', { class: 'card-symbol' }, typesetSymbol(value.symbol));
  return card(
    value.long_name || value.name,
    cardRow(null, cardValue(shown, after), null, symbol),
    value.remark ? element('p', { class: 'card-remark' }, typeset(value.remark)) : null,
  );
}

const kSourcesOnFirstScreen = 2; // the file and whether it can be what it seems; all of them are at the end

function firstScreen(measurement) {
  const values = keyValues(measurement);
  return pageHead(
    {
      kind: kKinds[measurement.kind] ?? 'A measurement',
      title: measurement.title,
      operating: measurement.sources.slice(0, kSourcesOnFirstScreen).map(typeset),
    },
    values.length ? cards(values.map(valueCard)) : null,
    notesBox(measurement.notes.map(sentence)),
  );
}

function figureViews(measurement, context) {
  const maps = measurement.maps
    .filter((map) => !map.empty && map.points_x > 1 && map.points_y > 1)
    .map((map) => new DrawingView(mapFigure(map), context));
  const curves = measurement.curves
    .map(curveFigure)
    .filter(Boolean)
    // A curve that is hidden in one figure remains visible in the others.
    .map((figure) => new ChartView(figure, { ...context, visibility: new Visibility() }));
  const bore = boreFigure(measurement);
  return { maps, curves, drawings: bore ? [new DrawingView(bore, context)] : [] };
}

function buildPage(measurement) {
  const context = { group: null, besidePaper: false, stem: measurement.title, subtitle: measurement.title };
  const { maps, curves, drawings } = figureViews(measurement, context);
  const empty = measurement.maps
    .filter((map) => map.empty)
    .map((map) => `${map.title}: no point was measured.`);
  const missing = [...empty, ...withoutPoints(measurement.curves)];
  const hasErrors = measurement.groups.some((group) => group.values.some((value) => value.error > 0));
  const parts = [
    ['bore', 'Ring and bore', drawings.length > 0, drawings.map((view) => view.node)],
    ['maps', 'Height maps', maps.length > 0, maps.map((view) => view.node)],
    [
      'curves',
      'Curves',
      curves.length > 0 || missing.length > 0,
      [
        element(
          'p',
          { class: 'how' },
          'Drag across a chart to zoom, double-click for the whole; a name in a legend hides its curve.',
        ),
        missing.length ? noteList(missing.map(sentence)) : null,
        charts(curves),
      ],
    ],
    [
      'values',
      'Values',
      measurement.groups.length > 0,
      [
        hasErrors ? element('p', { class: 'how' }, 'After ±: one standard error.') : null,
        measurement.groups.map((group, i) => groupTable(group, i, context)),
      ],
    ],
    [
      'tables',
      'Tables',
      measurement.tables.length > 0,
      measurement.tables.map((given) => numbersTable(given, context)),
    ],
    ['fragment', 'For a case', measurement.fragment !== '', fragmentBlock(measurement.fragment, context)],
    [
      'done',
      'What was done',
      measurement.statements.length > 0,
      element(
        'ol',
        { class: 'done' },
        measurement.statements.map((statement) => element('li', {}, sentence(statement))),
      ),
    ],
    [
      'provenance',
      'Where this comes from',
      true,
      [
        element(
          'ul',
          { class: 'done' },
          measurement.sources.map((source) => element('li', {}, typeset(source))),
        ),
        table('Program', ['what', ''], programRows(measurement.provenance)),
      ],
    ],
  ];
  showPage(
    firstScreen(measurement),
    parts.map(([id, label, there, content]) => there && { id, label, node: section(id, label, content) }),
  );
  const views = [...drawings, ...maps, ...curves];
  startViews(views);
}

/** A measurement without the folders of the machine on which it was made: a page is sent to others. */
function portable(measurement) {
  const texts = (list) => list.map(withoutFolders);
  return {
    ...measurement,
    sources: texts(measurement.sources),
    statements: texts(measurement.statements),
    notes: texts(measurement.notes),
    groups: measurement.groups.map((group) => ({
      ...group,
      values: group.values.map((value) => ({ ...value, remark: withoutFolders(value.remark) })),
    })),
  };
}

buildPage(portable(JSON.parse(document.getElementById('result-data').textContent)));
