// The page of a study: what varied, what came of it, the pictures of its kind, how sure they are.
import { CycleGroup } from '../plot/chart.js';
import { picker } from '../figure/choices.js';
import { DrawingView } from '../figure/drawing_view.js';
import { element, section, startViews } from '../dom.js';
import { ChartView, Visibility } from '../figure/chart_view.js';
import { comparisonFigure } from './study_compare.js';
import { curveFigures } from './study_curves.js';
import { effectsFigure, indicesFigure, rankingFigure, sensitivityFigure } from './study_decides.js';
import { lowestFigure } from './study_lowest.js';
import { gridCurvesFigure, GridValues, MapChoice, mapFigure } from './study_map.js';
import { StudyModel } from './study_model.js';
import { convergenceFigure, histogramFigure } from './study_spread.js';
import { stribeckFigure } from './study_stribeck.js';
import {
  accuracySection,
  differencesTable,
  firstScreen,
  indicesTable,
  notesSection,
  pointsSection,
  provenanceSection,
  statisticsSection,
  unsolvedSection,
  variedSection,
} from './study_tables.js';
import { charts, showPage } from '../page_head.js';

/** A figure of charts; a curve that is hidden in it remains visible in the others. */
const chartView = (figure, context) => new ChartView(figure, { ...context, visibility: new Visibility() });

/**
 * A main value (and base) that the reader picks for the figures of a section. @param figures (model,
 * chosen) to a figure or null
 */
function pickedFigures(model, context, values, figures, { withBase = false } = {}) {
  const chosen = { value: values[0].name, base: 0 };
  const views = figures.flatMap((make) => {
    const figure = make(model, chosen);
    if (!figure) return [];
    if (!figure.panels) return [new DrawingView(figure, context)];
    const view = chartView(figure, context);
    return [Object.assign(view, { redraw: () => view.replace(make(model, chosen)) })];
  });
  const redraw = () => views.forEach((view) => view.redraw());
  const choices = [
    values.length > 1
      ? picker(
          'Value',
          values.map((q) => [q.name, q.short_name]),
          chosen.value,
          (name) => {
            chosen.value = name;
            redraw();
          },
        )
      : null,
    withBase && model.several
      ? picker(
          'Base',
          model.bases.map((b) => [b.index, b.name]),
          0,
          (base) => {
            chosen.base = Number(base);
            redraw();
          },
        )
      : null,
  ].filter(Boolean);
  return { views, choices: choices.length ? element('div', { class: 'choices' }, choices) : null };
}

const kMostListed = 400;

/** What is drawn of a grid, with the choice of its axes. */
function gridPart(model, context) {
  if (!model.grid)
    return model.method === 'grid'
      ? {
          views: [],
          choices: element(
            'p',
            { class: 'how' },
            'No maps are drawn: even with two levels of each factor the grid has more points than a page can hold. \
The result file has all of them.',
          ),
        }
      : null;
  const shown = model.grid.quantities.map((name) => model.quantity.get(name));
  const choice = new MapChoice(model);
  if (choice.up === undefined) {
    const views = shown
      .map((q) => gridCurvesFigure(model, q))
      .filter(Boolean)
      .map((figure) => chartView(figure, context));
    return views.length ? { views, choices: null } : null;
  }
  const lowest = lowestFigure(model, shown.find((q) => q.name === 'fmep') ?? shown[0], choice);
  const views = [...shown.map((q) => mapFigure(model, q, choice)), ...(lowest ? [lowest] : [])].map(
    (figure) => new DrawingView(figure, context),
  );
  const host = element('div', { class: 'choices' });
  const redraw = (act) => (value) => {
    const focused = [...host.querySelectorAll('select, input')].indexOf(document.activeElement);
    act(Number(value));
    build();
    host.querySelectorAll('select, input')[focused]?.focus();
    views.forEach((view) => view.redraw());
  };
  const axis = (label, which, other) => {
    const numeric = choice.grid.numeric();
    if (numeric.length < 2) return null;
    return picker(
      label,
      numeric.map((a) => [choice.grid.axes.indexOf(a), a.factor.name]),
      choice[which],
      redraw((k) => {
        if (k === choice[other]) choice[other] = choice[which];
        choice[which] = k;
      }),
    );
  };
  const build = () =>
    host.replaceChildren(
      ...[
        model.several
          ? picker(
              'Base',
              model.bases.map((b) => [b.index, b.name]),
              choice.base,
              redraw((b) => choice.setBase(b)),
            )
          : null,
        axis('Across', 'across', 'up'),
        axis('Up', 'up', 'across'),
        ...choice.grid.axes.map((a, k) =>
          k === choice.across || k === choice.up || a.levels.length < 2
            ? null
            : picker(
                a.factor.name,
                a.levels.slice(0, kMostListed).map((level, i) => [i, model.levelText(a.factor, level)]),
                choice.places[k],
                redraw((i) => {
                  choice.places[k] = i;
                }),
              ),
        ),
      ].filter(Boolean),
    );
  build();
  return { views, choices: host };
}

function buildPage(model) {
  const context = {
    group: null,
    besidePaper: false,
    stem: model.title || 'study',
    subtitle: `${model.title}, ${model.counted(model.scenarios)}`,
  };
  const views = [];
  const kept = (list) => {
    views.push(...list);
    return list.map((view) => view.node);
  };
  const drawing = (figure) => (figure ? kept([new DrawingView(figure, context)]) : []);
  const any = model.solved > 0;
  const with_ = (part) =>
    model.mainValues.filter((q) =>
      model[part][q.name]?.some(
        (one) =>
          one && (one.factors ? one.factors.some(Boolean) : Array.isArray(one) ? one.some(Boolean) : true),
      ),
    );

  const parts = [];
  const add = (id, label, heading, content) => {
    const nodes = content.flat(Infinity).filter(Boolean);
    if (nodes.length) parts.push({ id, label, node: section(id, heading, nodes) });
  };

  const maps = () => {
    const found = any ? gridPart(model, context) : null;
    return found ? [found.choices, charts(kept(found.views))] : [];
  };
  const stribeck = () => (any && model.stribeck ? drawing(stribeckFigure(model)) : []);
  const screening = () => {
    const values = with_('effects');
    if (values.length === 0) return [];
    const found = pickedFigures(model, context, values, [effectsFigure, rankingFigure], { withBase: true });
    return [found.choices, charts(kept(found.views))];
  };
  const spread = () => drawing(histogramFigure(model));
  const decides = () => {
    const hasIndices = with_('indices').length > 0;
    const values = hasIndices ? with_('indices') : with_('sensitivities');
    if (values.length === 0) return [];
    const found = pickedFigures(
      model,
      context,
      values,
      [hasIndices ? indicesFigure : null, with_('sensitivities').length ? sensitivityFigure : null].filter(
        Boolean,
      ),
    );
    return [found.choices, charts(kept(found.views)), indicesTable(model)];
  };
  const compare = () => {
    const figure = any ? drawing(comparisonFigure(model)) : [];
    return figure.length ? [figure, differencesTable(model)] : [];
  };
  const curves = () => {
    const figures = curveFigures(model);
    if (figures.length === 0)
      return any && (model.kind === 'uncertainty' || model.kind === 'compare')
        ? [
            element(
              'p',
              { class: 'how' },
              'No curves over crank angle were kept. To have their bands, write curves = "quantiles" into [keep] of \
the study and run it anew.',
            ),
          ]
        : [];
    const visibility = new Visibility();
    const group = new CycleGroup();
    return [
      element(
        'p',
        { class: 'how' },
        `Drag across a chart to zoom all of them, double-click for the whole cycle.${
          model.curves.scenarios || model.several ? ' A name in a legend hides its curve.' : ''
        }`,
      ),
      kept(figures.map((figure) => new ChartView(figure, { ...context, visibility, group }))),
    ];
  };
  const settle = () => {
    const values = model.mainValues.filter((q) =>
      model.convergence[q.name]?.some((c) => c && c.n.length > 1),
    );
    if (values.length === 0) return [];
    const found = pickedFigures(model, context, values, [convergenceFigure]);
    return [found.choices, kept(found.views)];
  };

  const order = {
    map: ['maps', 'stribeck', 'compare', 'screening', 'spread', 'decides', 'curves', 'settle'],
    compare: ['compare', 'curves', 'spread', 'maps', 'decides', 'screening', 'stribeck', 'settle'],
    screening: ['screening', 'compare', 'maps', 'spread', 'decides', 'curves', 'stribeck', 'settle'],
    uncertainty: ['curves', 'spread', 'decides', 'compare', 'settle', 'screening', 'maps', 'stribeck'],
  };
  const makers = {
    maps: () => {
      const curve = model.grid?.bases.every((_, b) => new GridValues(model, b).numeric().length < 2)
        ? new GridValues(model, 0).numeric()[0]
        : null;
      const label = curve ? `Over ${curve.factor.name}` : 'Maps';
      add('maps', label, label, maps());
    },
    stribeck: () => add('regimes', 'Stribeck curve', 'Stribeck curve', stribeck()),
    screening: () => add('screening', 'Screening', 'Which inputs matter', screening()),
    spread: () => add('spread', 'Spread', 'How far the values are spread', spread()),
    decides: () => add('decides', 'Which input decides', 'Which input decides', decides()),
    compare: () => add('comparison', 'Side by side', 'Side by side', compare()),
    curves: () => add('curves', 'Over the cycle', 'Over the engine cycle', curves()),
    settle: () => add('settle', 'Convergence', 'How sure the statistics are', settle()),
  };
  (order[model.kind] ?? order.uncertainty).forEach((name) => makers[name]());
  const rest = [
    ['points', 'Operating points', any ? pointsSection(model) : null],
    ['values', 'Cycle values', any ? statisticsSection(model, context) : null],
    ['accuracy', 'Accuracy', accuracySection(model)],
    ['notes', 'Notes', notesSection(model)],
    ['varied', 'What varied', variedSection(model)],
    ['unsolved', 'Not solved', unsolvedSection(model)],
    ['provenance', 'Provenance', provenanceSection(model)],
  ].map(([id, label, node]) => ({ id, label, node }));
  showPage(firstScreen(model), [...parts, ...rest]);
  startViews(views);
}

buildPage(new StudyModel(JSON.parse(document.getElementById('result-data').textContent)));
