// The page of `ringfilm life`: friction, oil and film over the running hours, and how each number is known.
import { element, section, startViews } from '../dom.js';
import { ChartView, Visibility } from '../figure/chart_view.js';
import { slider } from '../figure/choices.js';
import { cards, headWarning, numberCard, pageHead, showPage } from '../page_head.js';
import { right, table } from '../tables.js';
import { display, withUnit } from '../units.js';
import { distanceTable, faceFigure, facesOf } from './life_face.js';
import { attributionFigure, figuresOverHours } from './life_figures.js';
import { fitTable, leastWear, wornTable } from './life_wear.js';
import { hoursText, publishedWear, whatToMeasure } from './life_words.js';

const longName = (life, name) => life.quantities.find((quantity) => quantity.name === name).long_name;

function shown(life, name, state) {
  const described = life.quantities.find((quantity) => quantity.name === name);
  const { unit, convert } = display(described);
  return withUnit(convert(state[name]), unit, 4);
}

const reached = (hours) =>
  hours === null || hours === undefined ? 'not within these hours' : hoursText(hours);

/** When each stated limit is reached, as cards. */
function limitCards(life) {
  return (life.end_of_life ?? []).map((end) =>
    numberCard(`Limit: ${longName(life, end.quantity)}`, reached(end.hours), {
      detail: `${shown(life, end.quantity, { [end.quantity]: end.limit })}${
        end.starts ? `, starts ${end.starts} it` : ''
      }`,
    }),
  );
}

function firstScreen(life) {
  const [first, last] = [life.states[0], life.states[life.states.length - 1]];
  const wears = life.mode === 'archard';
  const claim = wears
    ? life.wear.fit
      ? 'A scenario with a coefficient fitted to the measured faces, which allow a wide range of it: the band ' +
        'is that range. It is not a prediction of wear.'
      : 'A scenario: the wear coefficient is an input, assumed or tuned. It is not a prediction of wear.'
    : 'Between the measured states everything is interpolated; the band shows what the choice of the ' +
      'interpolation does. Nothing is known after the last measured state.';
  const numbers = (heading, name) =>
    numberCard(heading, shown(life, name, last), {
      detail: `after ${hoursText(last.hours)}; ${shown(life, name, first)} at the start`,
    });
  return pageHead(
    {
      kind: wears ? 'Scenario of a ring that wears' : 'A ring between measured states',
      title: life.title,
      operating: `${life.program}, commit ${life.commit}`,
    },
    cards(
      numbers('Friction power', 'mean_power_loss'),
      numbers('Oil passing under the ring', 'mean_absolute_oil_flow'),
      numbers('Lambda ratio at peak pressure', 'lambda_ratio_at_peak_pressure'),
      ...limitCards(life),
    ),
    headWarning('Read this first', claim),
  );
}

function valuesTable(life) {
  const shownNames = life.quantities.filter((quantity) => quantity.name in life.states[0]);
  const heads = ['running time', 'known as', ...shownNames.map((quantity) => right(quantity.long_name))];
  const rows = life.states.map((state) => [
    hoursText(state.hours),
    state.state_origin,
    ...shownNames.map((quantity) => right(shown(life, quantity.name, state))),
  ]);
  return table('Values over the running time', heads, rows, { folds: true });
}

function endTable(life) {
  const others = Object.keys(life.end_of_life[0].interpolations ?? {});
  return table(
    'When the stated limits are reached',
    ['quantity', 'limit', 'reached', ...others, 'ring turned over'],
    life.end_of_life.map((end) => [
      longName(life, end.quantity),
      right(shown(life, end.quantity, { [end.quantity]: end.limit })),
      reached(end.hours),
      ...others.map((name) => reached(end.interpolations[name])),
      reached(end.turned),
    ]),
    { folds: true },
  );
}

function pointsTable(life) {
  const last = life.states[life.states.length - 1];
  const power = 'mean_power_loss';
  return table(
    `Operating points after ${hoursText(last.hours)}`,
    [
      'operating point',
      right('share of the time'),
      right('friction power'),
      right('oil passing under the ring'),
    ],
    last.points.map((point) => [
      point.name,
      right(point.share > 0 ? withUnit(100 * point.share, '%', 3) : 'reported only'),
      right(shown(life, power, point)),
      right(shown(life, 'mean_absolute_oil_flow', point)),
    ]),
    { folds: true },
  );
}

function faceSection(life, context, views) {
  const view = new ChartView(faceFigure(life, life.states.length - 1), context);
  views.push(view);
  const { states } = life;
  const { input, output, label } = slider(
    'face-hours',
    'Running time: ',
    'reported running time of the face',
    states.length,
    states.length - 1,
    (k) => {
      output.textContent = hoursText(states[k].hours);
      view.replace(faceFigure(life, k));
    },
  );
  output.textContent = hoursText(states.at(-1).hours);
  return section(
    'face',
    'The face',
    element('p', {}, label, input, ' ', output),
    view.node,
    distanceTable(life),
    facesOf(life),
  );
}

function wearSection(life) {
  const parts = [
    life.states[0].worn_area === null ? null : wornTable(life),
    life.wear?.fit ? fitTable(life.wear.fit) : null,
    leastWear(life),
  ].filter(Boolean);
  return parts.length ? section('wear', 'Wear', parts) : null;
}

function figureRow(figures, context, views) {
  const made = figures.map((figure) => new ChartView(figure, context));
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
    section('hours', 'Over the running time', figureRow(figuresOverHours(life), context, views)),
    faceSection(life, context, views),
    wearSection(life),
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
  showPage(
    firstScreen(life),
    sections.map((node) => ({ node })),
    { contents: false },
  );
  startViews(views);
}

buildPage(JSON.parse(document.getElementById('result-data').textContent));
