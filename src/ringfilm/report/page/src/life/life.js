// The page of `ringfilm life`: friction, oil and film over the running hours, and how each number is known.
import { element } from '../dom.js';
import { FigureView, Visibility } from '../cycle/figure_view.js';
import { section, table } from '../tables.js';
import { display, number, withUnit } from '../units.js';
import { faceFigure, facesOf } from './life_face.js';
import { attributionFigure, figuresOverHours } from './life_figures.js';
import { kStandings, publishedWear, whatToMeasure } from './life_words.js';

const right = (text) => ({ text, attributes: { class: 'number' } });

function shown(life, name, state) {
  const described = life.quantities.find((quantity) => quantity.name === name);
  const { unit, convert } = display(described);
  return withUnit(convert(state[name]), unit, 4);
}

function card(heading, value, detail) {
  return element(
    'section',
    { class: 'card' },
    element('h2', {}, heading),
    element(
      'div',
      { class: 'card-row' },
      element('span', { class: 'card-value' }, element('b', {}, value)),
      element('span', { class: 'card-detail' }, detail),
    ),
  );
}

function firstScreen(life) {
  const [first, last] = [life.states[0], life.states[life.states.length - 1]];
  const wears = life.mode === 'archard';
  const claim = wears
    ? 'A scenario: the wear coefficient is an input, assumed or tuned. It is not a prediction of wear.'
    : 'Between the measured states everything is interpolated; the band shows what the choice of the ' +
      'interpolation does. Nothing is known after the last measured state.';
  const change = (name) => `after ${number(last.hours, 4)} h; ${shown(life, name, first)} at the start`;
  return element(
    'header',
    { class: 'first-screen' },
    element(
      'p',
      { class: 'kind' },
      wears ? 'Scenario of a ring that wears' : 'A ring between measured states',
    ),
    element('h1', {}, life.title),
    element('p', { class: 'operating' }, `${life.program}, commit ${life.commit}`),
    element(
      'div',
      { class: 'cards' },
      card('Friction power', shown(life, 'mean_power_loss', last), change('mean_power_loss')),
      card('Oil flow', shown(life, 'mean_absolute_oil_flow', last), change('mean_absolute_oil_flow')),
      card(
        'Lambda ratio at peak pressure',
        shown(life, 'lambda_ratio_at_peak_pressure', last),
        change('lambda_ratio_at_peak_pressure'),
      ),
    ),
    element('p', { class: 'warning', role: 'note' }, element('strong', {}, 'Read this first: '), claim),
  );
}

function valuesTable(life) {
  const shownNames = life.quantities.filter((quantity) => quantity.name in life.states[0]);
  const heads = ['running time', 'known as', ...shownNames.map((quantity) => right(quantity.long_name))];
  const rows = life.states.map((state) => [
    withUnit(state.hours, 'h', 6),
    kStandings[state.standing],
    ...shownNames.map((quantity) => right(shown(life, quantity.name, state))),
  ]);
  return table('Values over the running time', heads, rows, { folds: true });
}

function endTable(life) {
  const when = (hours) =>
    hours === null || hours === undefined ? 'not within these hours' : withUnit(hours, 'h', 4);
  const others = Object.keys(life.end_of_life[0].interpolations ?? {});
  return table(
    'When the stated limits are reached',
    ['quantity', 'limit', 'reached', ...others, 'ring turned over'],
    life.end_of_life.map((end) => [
      life.quantities.find((quantity) => quantity.name === end.quantity).long_name,
      right(shown(life, end.quantity, { [end.quantity]: end.limit })),
      when(end.hours),
      ...others.map((name) => when(end.interpolations[name])),
      when(end.turned),
    ]),
    { folds: true },
  );
}

function pointsTable(life) {
  const last = life.states[life.states.length - 1];
  const power = 'mean_power_loss';
  return table(
    `Operating points after ${number(last.hours, 4)} h`,
    ['operating point', right('share of the time'), right('friction power'), right('oil flow')],
    last.points.map((point) => [
      point.name,
      right(withUnit(100 * point.share, '%', 3)),
      right(shown(life, power, point)),
      right(shown(life, 'mean_absolute_oil_flow', point)),
    ]),
    { folds: true },
  );
}

function faceSection(life, context, views) {
  const view = new FigureView(faceFigure(life, life.states.length - 1), context);
  views.push(view);
  const label = element('output', { for: 'face-hours' }, `${number(life.states.at(-1).hours, 4)} h`);
  const slider = element('input', {
    type: 'range',
    id: 'face-hours',
    min: '0',
    max: String(life.states.length - 1),
    step: '1',
    value: String(life.states.length - 1),
    'aria-label': 'reported running time of the face',
    oninput: () => {
      const k = Number(slider.value);
      label.textContent = `${number(life.states[k].hours, 4)} h`;
      view.replace(faceFigure(life, k));
    },
  });
  return section(
    'face',
    'The face',
    element('p', {}, element('label', { for: 'face-hours' }, 'Running time: '), slider, ' ', label),
    view.node,
    facesOf(life),
  );
}

function figureRow(figures, context, views) {
  const made = figures.map((figure) => new FigureView(figure, context));
  views.push(...made);
  return made.map((view) => view.node);
}

function buildPage(life) {
  const context = {
    visibility: new Visibility(),
    group: null,
    besidePaper: false,
    stem: 'life',
    subtitle: life.title,
  };
  const views = [];
  const attribution = attributionFigure(life);
  const sections = [
    firstScreen(life),
    section('hours', 'Over the running time', figureRow(figuresOverHours(life), context, views)),
    faceSection(life, context, views),
    attribution ? section('parts', 'What changes friction', figureRow([attribution], context, views)) : null,
    section(
      'values',
      'Values',
      valuesTable(life),
      life.states[0].points.length > 1 ? pointsTable(life) : null,
    ),
    life.end_of_life ? section('end', 'End of life', endTable(life)) : null,
    section(
      'measure',
      'What to measure next',
      whatToMeasure(),
      life.mode === 'archard' ? publishedWear() : null,
    ),
    section(
      'notes',
      'Notes',
      element(
        'ul',
        {},
        life.notes.map((note) =>
          element('li', {}, `${note.message} (${note.count} of ${life.cycles} cycles)`),
        ),
      ),
    ),
  ];
  document.getElementById('report').replaceChildren(...sections.filter(Boolean));
  views.forEach((view) => view.start());
  window.addEventListener('beforeprint', () => views.forEach((view) => view.beforePrint()));
}

buildPage(JSON.parse(document.getElementById('result-data').textContent));
