// A figure of charts or bars, with a legend that shows values under the cursor and hides cases.
import { element, onNewWidth, svgElement } from '../dom.js';
import { figureCsv } from '../downloads.js';
import { Chart } from '../plot/chart.js';
import { swatchSvg } from '../plot/line_panel.js';
import { isOneOfSeveral } from '../plot/palette.js';
import { logarithmic } from '../plot/scales.js';
import { figureSvg } from '../plot/svg.js';
import { angle, number, withUnit } from '../units.js';
import { FigureView } from './figure_view.js';

/** Which cases are hidden, for the whole page. */
export class Visibility {
  constructor() {
    this.hidden = new Set();
    this.listeners = [];
    this.shows = (series) => series.caseIndex === null || !this.hidden.has(series.caseIndex);
  }
  toggle(caseIndex) {
    if (!this.hidden.delete(caseIndex)) this.hidden.add(caseIndex);
    this.listeners.forEach((listener) => listener());
  }
}

/** The name of a case with its sample: a button that hides and shows it where it is one of several. */
export function caseEntry(series, visibility, value = '') {
  const parts = [svgElement(swatchSvg(series)), element('span', { class: 'label' }, series.label), value];
  if (!isOneOfSeveral(series.caseIndex)) return element('span', { class: 'entry' }, parts);
  return element(
    'button',
    {
      type: 'button',
      class: 'entry',
      'aria-pressed': String(visibility.shows(series)),
      title: `Hide or show ${series.label}`,
      'data-case': series.caseIndex,
      onclick: () => visibility.toggle(series.caseIndex),
    },
    parts,
  );
}

/** Marks the buttons of hidden cases among the entries. */
export function markHidden(entries, visibility) {
  entries
    .filter((entry) => entry.dataset.case !== undefined)
    .forEach((entry) =>
      entry.setAttribute('aria-pressed', String(!visibility.hidden.has(Number(entry.dataset.case)))),
    );
}

/** Text for people who cannot see the chart: what it spans. */
function spoken(panel) {
  const parts = panel.series.map((s) => {
    const seen = s.y.filter((v) => v !== null && Number.isFinite(v));
    return seen.length
      ? `${s.label} from ${number(Math.min(...seen), 3)} to ${number(Math.max(...seen), 3)}`
      : `${s.label} without values`;
  });
  return `${panel.yLabel}${panel.yUnit ? ` in ${panel.yUnit}` : ''} over ${panel.xLabel}: ${parts.join(', ')}`;
}

/** Where the values that are reported belong: the sample nearest to the cursor, not the cursor itself. */
function sampledPlace(panel, places) {
  const i = Math.max(
    0,
    panel.series.findIndex((s) => s.part !== 'measured'),
  );
  if (places[i] < 0) return '';
  const place = (panel.series[i].angle ?? panel.series[i].x)[places[i]];
  return panel.crank || panel.inOrderOfTime ? `at ${angle(place)}°` : `at ${withUnit(place, panel.xUnit, 3)}`;
}

const names = (figure) => figure.panels.map((panel) => panel.series?.map((s) => s.label).join()).join('\n');

export class ChartView extends FigureView {
  /** @param context visibility, group (CycleGroup), besidePaper, beside what FigureView has */
  constructor(figure, context, above = []) {
    const isBars = Boolean(figure.panels[0]?.bars);
    const half = figure.layout !== 'row' && !figure.long && !isBars;
    const button = figure.offersLog ? scaleButton(figure.title, (isLog) => this.setScale(isLog)) : null;
    super({ ...figure, half }, context, {
      classes: figure.layout === 'row' ? ['row'] : [],
      beside: [
        figure.paper && context.besidePaper
          ? element('span', { class: 'paper' }, `${figure.paper} of the paper`)
          : null,
        button,
      ],
      above,
    });
    this.isBars = isBars;
    this.savedWidth = 760;
    this.charts = [];
    this.lay();
    context.visibility.listeners.push(() => this.refresh());
  }

  lay() {
    if (this.isBars)
      this.body.append(
        (this.host = element('div', { class: 'bars', role: 'img', 'aria-label': this.figure.caption })),
      );
    else this.body.append(...this.figure.panels.map((panel, i) => this.chartPanel(panel, i)));
  }

  chartPanel(panel, index) {
    const { figure, context } = this;
    const host = element('div', { class: 'chart', role: 'img', 'aria-label': spoken(panel) });
    const at = element('span', { class: 'at' });
    const values = panel.series.map(() => element('span', { class: 'value' }));
    const entries = panel.series.map((s, i) => caseEntry(s, context.visibility, values[i]));
    const readOut = (places) => {
      const shown = this.figure.panels[index];
      at.textContent = places ? sampledPlace(shown, places) : '';
      values.forEach((value, i) => {
        value.textContent = places ? number(shown.series[i].y[places[i]], 4) : '';
      });
    };
    // A chart measures its host, which must be in the page first.
    const start = (width) =>
      new Chart(host, panel, {
        width,
        visible: context.visibility.shows,
        readOut,
        group: figure.group ? context.group : null,
      });
    this.charts.push({ host, start, entries });
    return element('div', { class: 'panel' }, host, element('div', { class: 'legend' }, at, entries));
  }

  measure() {
    for (const entry of this.charts) entry.width = entry.host.clientWidth;
  }

  /** Draws; to be called once the node is in the page. */
  start() {
    for (const entry of this.charts) entry.chart = entry.start(entry.width);
    if (!this.isBars) return;
    this.drawBars();
    onNewWidth(this.node, () => this.drawBars());
  }

  /** One drawing holds all bar panels of the figure. */
  drawBars() {
    const { figure, host, context } = this;
    const width = Math.max(320, Math.min(1060, host.clientWidth || 760));
    host.replaceChildren(
      svgElement(figureSvg(figure, context.visibility.shows, { width, heading: false })),
      element(
        'div',
        { class: 'legend' },
        figure.panels[0].groups.map((g) => caseEntry(g, context.visibility)),
      ),
    );
  }

  /** Another figure in the place of this one, with new charts only where it has other curves. */
  replace(figure) {
    const isAlike = names(figure) === names(this.figure);
    this.figure = { ...this.figure, ...figure };
    this.title.textContent = figure.title;
    this.caption.textContent = figure.caption;
    if (this.isBars) {
      this.drawBars();
      return;
    }
    if (isAlike) {
      figure.panels.forEach((panel, i) => {
        this.charts[i].host.setAttribute('aria-label', spoken(panel));
        this.charts[i].chart?.replace(panel);
      });
      return;
    }
    this.charts.forEach(({ chart }) => this.context.group?.remove(chart));
    this.charts = [];
    this.body.replaceChildren();
    this.lay();
    this.start();
  }

  /** Turns the y axes from linear to logarithmic and back. */
  setScale(isLog) {
    this.linear ??= this.figure;
    this.replace(isLog ? logarithmic(this.linear) : this.linear);
  }

  refresh() {
    const { visibility } = this.context;
    for (const { chart, entries } of this.charts) {
      chart?.refresh();
      markHidden(entries, visibility);
    }
    if (this.isBars && this.host.isConnected) this.drawBars();
  }

  svg(width, subtitle) {
    const windows = Object.fromEntries(
      this.charts.filter((c) => c.chart).map(({ chart }) => [chart.panel.id, chart.window]),
    );
    return figureSvg(this.figure, this.context.visibility.shows, { width, windows, subtitle });
  }

  csv() {
    return figureCsv(this.linear ?? this.figure);
  }
}

function scaleButton(title, act) {
  const button = element(
    'button',
    {
      type: 'button',
      class: 'download scale',
      'aria-pressed': 'false',
      'aria-label': `${title}: logarithmic axis`,
      onclick: () => {
        const isLog = button.getAttribute('aria-pressed') !== 'true';
        act(isLog);
        button.setAttribute('aria-pressed', String(isLog));
      },
    },
    'log',
  );
  return button;
}
