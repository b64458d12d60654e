// The page of the gas of a ring pack alone: no films, so no friction and no oil.
import { ChartView, Visibility } from '../figure/chart_view.js';
import { code, section, startViews } from '../dom.js';
import { shownInput } from '../model.js';
import { cards, charts, headWarning, numberCard, pageHead, showPage } from '../page_head.js';
import { CycleGroup } from '../plot/chart.js';
import { filesTable, folded, inputCell, keyCell, programRows, right, table } from '../tables.js';
import { gasSum, gasValue, kBlowBy, kStandard } from './gas_words.js';
import { angleInWords, converted, number, sentence, typeset, wrapped } from '../units.js';
import { blowBy, gasComposition, gasPressures, ringPositions } from './pack_figures.js';
import { packOfGas, regionWords } from './pack_model.js';
import { gasTables, packView } from './pack_view.js';

const kOperating = [
  ['engine.bore', 'bore'],
  ['engine.stroke', 'stroke'],
  ['operating.speed', 'speed'],
  ['gas_path.ring_motion', 'ring motion'],
];

function operatingLine(inputs) {
  return kOperating
    .flatMap(([key, word]) => {
      const entry = inputs.find((one) => one.key === key);
      return entry ? [`${word} ${shownInput(entry)}`] : [];
    })
    .join(', ');
}

function firstScreen(payload) {
  const { gas, notes } = payload;
  const mass = gasSum(gas, kBlowBy.mass);
  const below = gas.regions.find((region) => /^land/.test(region.name));
  const synthetic = payload.inputs.some(
    (entry) => entry.key === 'gas.trace_origin' && entry.shown === 'synthetic',
  );
  const warning = synthetic
    ? 'the cylinder pressure is SYNTHETIC: made by a formula, not measured on an engine.'
    : notes.length
      ? `${notes[0].message}.`
      : null;
  return pageHead(
    {
      kind: 'Gas between the rings of a pack over one engine cycle, without films',
      title: payload.title,
      operating: operatingLine(payload.inputs),
    },
    warning ? headWarning('Warning', typeset(warning)) : null,
    cards(
      numberCard('Blow-by of a cylinder', number(mass.value, 3), {
        of: ` ${mass.unit} per cycle`,
        detail: `${gasValue(gas, kBlowBy.flow)} ${kStandard}`,
      }),
      below
        ? numberCard(`Peak on ${regionWords(below.name)}`, number(converted(below.peak_pressure, 'bar'), 3), {
            of: ' bar',
            detail: angleInWords(wrapped(below.peak_pressure_angle)),
          })
        : null,
      numberCard('Changes of flank contact', String(gas.events.length), { detail: 'in a cycle, all rings' }),
    ),
  );
}

function regionTable({ regions }) {
  const hasMeans = regions.every((region) => region.mean_pressure !== undefined);
  return table(
    'Pressures of the regions',
    ['region', right('peak [bar]'), right('at'), ...(hasMeans ? [right('mean [bar]')] : [])],
    regions.map((region) => [
      regionWords(region.name),
      right(number(converted(region.peak_pressure, 'bar'), 4)),
      right(angleInWords(wrapped(region.peak_pressure_angle))),
      ...(hasMeans ? [right(number(converted(region.mean_pressure, 'bar'), 4))] : []),
    ]),
  );
}

const kEvents = {
  'leaves-lower': 'leaves the lower flank',
  'lands-lower': 'lands on the lower flank',
  'leaves-upper': 'leaves the upper flank',
  'lands-upper': 'lands on the upper flank',
};

function eventTable({ events }) {
  if (events.length === 0) return null;
  return table(
    'Changes of flank contact',
    ['ring', right('crank angle'), 'event'],
    events.map((event) => [
      `ring ${event.ring}`,
      right(angleInWords(wrapped(event.crank_angle))),
      kEvents[event.event] ?? event.event,
    ]),
  );
}

function inputTable(inputs) {
  return folded(
    `${inputs.length} inputs, ${inputs.filter((entry) => entry.assumed).length} of them assumed`,
    table(
      'Inputs',
      ['key', 'value'],
      inputs.map((entry) => [keyCell(entry), inputCell(entry)]),
      { folds: true, classes: 'inputs' },
    ),
  );
}

function buildPage(payload) {
  const packed = packOfGas(payload);
  const context = {
    visibility: new Visibility(),
    group: new CycleGroup(),
    besidePaper: false,
    stem: payload.title,
    subtitle: payload.title,
  };
  const figures = [gasPressures(packed), blowBy(packed), gasComposition(packed), ringPositions(packed)]
    .filter(Boolean)
    .map((figure) => new ChartView(figure, context));
  const views = [packView(packed, context), ...figures];
  const { gas } = payload;
  const parts = [
    section('pack', 'Ring pack', charts(views), regionTable(gas), gasTables(gas), eventTable(gas)),
    payload.notes.length
      ? section(
          'validity',
          'Validity: what to know before using these results',
          table(
            'Notes on validity',
            ['note', 'topic'],
            payload.notes.map((note) => [sentence(note.message), { text: code(note.topic) }]),
            { folds: true },
          ),
        )
      : null,
    section('inputs', 'Inputs', inputTable(payload.inputs)),
    section(
      'provenance',
      'Where this comes from',
      table('Program', ['what', 'value'], programRows(payload.provenance)),
      payload.files.length ? filesTable(payload.files) : null,
    ),
  ];
  showPage(
    firstScreen(payload),
    parts.map((node) => node && { node }),
    { contents: false },
  );
  startViews(views);
}

buildPage(JSON.parse(document.getElementById('result-data').textContent));
