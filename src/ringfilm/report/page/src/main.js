// Puts the page together from the data that it carries.
import { clearanceFigure, gapFigure } from './cycle/around_figures.js';
import { aroundView } from './cycle/around_view.js';
import { hasBore } from './cycle/bore_drawing.js';
import { boreView } from './cycle/bore_view.js';
import { CycleGroup } from './plot/chart.js';
import {
  cycleFigure,
  kCycleFigures,
  kCycleRange,
  otherQuantityFigure,
  shownElsewhere,
  zoomFigure,
} from './cycle/cycle_figures.js';
import { element, section, startViews } from './dom.js';
import { contactPressureFigure, flowFactorFigure, realAreaFigure } from './cycle/contact_figures.js';
import { faceView, howToStoreFields } from './cycle/face_view.js';
import { caseEntry, ChartView, markHidden, Visibility } from './figure/chart_view.js';
import { picker } from './figure/choices.js';
import { firstScreen, operatingLine, reportTitle } from './cycle/first_screen.js';
import { comparisonSection } from './cycle/comparison.js';
import { influenceFigure, ledgerSection } from './cycle/ledger.js';
import { Model } from './model.js';
import {
  energyFigure,
  faceFigure,
  linerFilmFigure,
  regimeFigure,
  stribeckFigure,
  wearFigure,
} from './cycle/other_figures.js';
import { indicatorFigure } from './cycle/indicator_figure.js';
import { byFace, comparisonFigures, comparisonTable } from './pack/pack_comparison.js';
import { packFigures } from './pack/pack_figures.js';
import { PackModel } from './pack/pack_model.js';
import { packSentences, packView, ringTable } from './pack/pack_view.js';
import { charts, showPage } from './page_head.js';
import { cycleValuesSection, inputsSection, notesSection, provenanceSection } from './tables.js';
import { axisTitle } from './plot/scales.js';
import { converted, display } from './units.js';
import { Unrolled } from './cycle/unrolled.js';

const kRanges = [
  ['Whole cycle', -360, 360],
  ['±90°', -90, 90],
  ['Intake', -360, -180],
  ['Compression', -180, 0],
  ['Power', 0, 180],
  ['Exhaust', 180, 360],
];

function toolbar(model, visibility, group) {
  const cases = model.several
    ? model.entries.map(({ series, name }) => caseEntry({ caseIndex: series, label: name }, visibility))
    : [];
  visibility.listeners.push(() => markHidden(cases, visibility));
  const ranges = kRanges.map(([label, low, high]) =>
    element(
      'button',
      {
        type: 'button',
        class: 'range',
        'aria-pressed': String(low === kCycleRange[0] && high === kCycleRange[1]),
        onclick: () => group.zoom(low, high),
      },
      label,
    ),
  );
  group.listeners.push((low, high) =>
    ranges.forEach((button, i) => {
      button.setAttribute(
        'aria-pressed',
        String(Math.abs(low - kRanges[i][1]) < 0.5 && Math.abs(high - kRanges[i][2]) < 0.5),
      );
    }),
  );
  return element(
    'div',
    { class: 'toolbar', role: 'toolbar', 'aria-label': 'What the charts show' },
    cases.length ? element('span', { class: 'tools' }, cases) : null,
    element('span', { class: 'tools' }, ranges),
  );
}

/** A chart of a quantity that the reader picks; null without one. */
function otherQuantity(model, context) {
  const quantities = model.curveQuantities.filter(({ name }) => !shownElsewhere().includes(name));
  if (quantities.length === 0) return null;
  const names = quantities.map(({ name }) => name);
  const overlaid = model.payload.overlays.map((o) => o.quantity).find((name) => names.includes(name));
  const first = overlaid ?? (names.includes('power_loss') ? 'power_loss' : names[0]);
  const figure = (name) => byFace(model, (own) => otherQuantityFigure(own, name));
  const choice = picker(
    'Quantity',
    quantities.map((q) => [q.name, axisTitle(q.long_name, display(q).unit)]),
    first,
    (name) => view.replace(figure(name)),
    { id: 'quantity' },
  );
  const view = new ChartView(figure(first), context, [choice]);
  return view;
}

/** One line under the title of a figure that leaves the page: which case this is. Whole words only. */
function subtitle(model) {
  const kRoom = 112;
  const synthetic = model.cases.some((c) => model.isSynthetic(c)) ? ['SYNTHETIC cylinder pressure'] : [];
  const parts = [reportTitle(model), ...synthetic, ...operatingLine(model).split(', ').filter(Boolean)];
  let line = parts[0].length > kRoom ? `${parts[0].slice(0, kRoom - 1)}…` : parts[0];
  for (const part of parts.slice(1)) if (line.length + part.length + 2 <= kRoom) line += `, ${part}`;
  return line;
}

/** The cases whose film is unrolled, ready to be drawn. */
function unrolledCases(model) {
  const { unrolled_fields: fields, strip_fields: strips } = model.payload;
  return model.cases
    .filter((c) => c.unrolled)
    .map((c) => ({
      name: c.name,
      data: new Unrolled(c.unrolled, { fields, strips }),
      peakAngle: c.values.peak_gas_pressure_angle,
      face: converted(Math.max(0, ...c.fields.x), 'mm'),
    }));
}

/**
 * The section of the ring pack: one pack, as its drawing has one slider, or several and nothing else beside each
 * other; null where there is none.
 */
function packPart(model, context) {
  if (model.comparesPacks) {
    const views = comparisonFigures(model).map((figure) => new ChartView(figure, context));
    return { words: [comparisonTable(model)], views };
  }
  if (model.packs.length !== 1) return null;
  const packed = new PackModel(model.packs[0], model);
  const figures = packFigures(packed).map((figure) => new ChartView(figure, context));
  const drawing = packed.hasCurves || packed.pack.gas ? packView(packed, context) : null;
  return { words: [ringTable(packed), packSentences(packed)], views: [drawing, ...figures].filter(Boolean) };
}

/** May the reader get fields along the face? Pages of compared packs have none, and no cycle means none. */
function hasNoFields(model) {
  return !model.comparesPacks && (model.several || model.cases[0].complete);
}

/** Film and friction: before the fields along the face. */
const kFirstRow = 2;

function buildPage(model) {
  const visibility = new Visibility();
  const group = new CycleGroup();
  const title = reportTitle(model);
  const besidePaper = model.cases.some((c) => c.comparison.length > 0);
  const context = { visibility, group, besidePaper, stem: title, subtitle: subtitle(model) };
  const views = [];
  const view = (figure) => (figure ? new ChartView(figure, context) : null);
  const faced = (make) => view(byFace(model, make));

  const hasCurves = model.cases.some((c) => c.curves.crank_angle.length > 1);
  const cycle = hasCurves
    ? [
        ...kCycleFigures.map((make) => faced((own) => cycleFigure(own, make))),
        otherQuantity(model, context),
      ].filter(Boolean)
    : [];
  const others = [
    hasCurves ? faced(zoomFigure) : null,
    hasCurves ? faced(stribeckFigure) : null,
    hasCurves ? view(indicatorFigure(model)) : null,
    faced(linerFilmFigure),
    faced(wearFigure),
    faced(regimeFigure),
    faced(energyFigure),
  ].filter(Boolean);
  const faces = [faced(faceFigure)].filter(Boolean);
  const along = faceView(model, context);
  const unrolled = unrolledCases(model);
  const inBore = unrolled.find(({ data }) => hasBore(data));
  const around = [
    inBore ? boreView(model, inBore, context) : null,
    unrolled.length ? aroundView(model, unrolled, context) : null,
    hasCurves ? view(clearanceFigure(model)) : null,
    hasCurves ? view(gapFigure(model)) : null,
  ].filter(Boolean);
  const pack = packPart(model, context);
  const contact = [contactPressureFigure, realAreaFigure, flowFactorFigure].map(faced).filter(Boolean);
  const influence = view(influenceFigure(model));
  views.push(
    ...cycle,
    ...(pack?.views ?? []),
    ...(along ? [along] : []),
    ...others,
    ...faces,
    ...contact,
    ...around,
    ...(influence ? [influence] : []),
  );

  const how = element(
    'p',
    { class: 'how' },
    'Drag across a chart to zoom all of them, double-click for the whole cycle; ' +
      (along ? 'the cursor moves the fields along the face; ' : '') +
      'the thin dashed line marks the peak of the gas pressure.',
    model.several ? ' A name in a legend hides that case in the whole page.' : '',
  );
  const cycleParts = [
    ...cycle.slice(0, kFirstRow),
    along ?? (hasNoFields(model) ? howToStoreFields() : null),
    ...cycle.slice(kFirstRow),
  ];
  const part = (id, label, heading, list, ...content) => ({
    id,
    label,
    node: list?.length ? section(id, heading, content.length ? content : charts(list)) : null,
  });
  showPage(firstScreen(model), [
    part(
      'pack',
      'Ring pack',
      model.comparesPacks ? 'Ring packs' : 'Ring pack',
      pack ? [pack] : null,
      pack?.words,
      charts(pack?.views ?? []),
    ),
    part(
      'cycle',
      'Over the cycle',
      'Over the engine cycle',
      cycle,
      how,
      toolbar(model, visibility, group),
      charts(cycleParts),
    ),
    part('friction', 'Friction and wear', 'Friction and wear', others),
    part('face', 'Face', 'Face of the ring', faces),
    part('contact', 'Contact law', 'Contact law', contact),
    part(
      'around',
      'Around the ring',
      'Around the ring',
      around,
      around.map((one) => one.node),
    ),
    { id: 'cycle-values', label: 'Cycle values', node: cycleValuesSection(model) },
    { id: 'comparison', label: 'Published values', node: comparisonSection(model) },
    { id: 'ledger', label: 'Assumptions', node: ledgerSection(model, influence?.node) },
    { id: 'validity', label: 'Validity', node: notesSection(model) },
    { id: 'inputs', label: 'Inputs', node: inputsSection(model) },
    { id: 'provenance', label: 'Provenance', node: provenanceSection(model) },
  ]);
  startViews(views);
}

buildPage(new Model(JSON.parse(document.getElementById('result-data').textContent)));
