// A figure on the page: heading, charts, legend with read-out, caption, files to take away.
import { Chart } from '../plot/chart.js';
import { spokenSummary } from './cycle_figures.js';
import { element, onNewWidth, svgElement } from '../dom.js';
import { fileStem, figureCsv, save, savePng } from '../downloads.js';
import { isOneOfSeveral } from '../plot/palette.js';
import { axisTitle, logarithmic } from '../plot/scales.js';
import { figureSvg, swatchSvg } from '../plot/svg.js';
import { angle, number, withUnit } from '../units.js';

/**
 * Width of a drawing for the printer, in a column and across the paper: letters come out at about 7 pt in
 * both.
 */
const kPrinted = { half: 450, whole: 900 };

/** Two such figures are side by side on paper. */
function isHalfAPage(figure) {
  return figure.layout !== 'row' && !figure.long && !figure.panels.some((panel) => panel.bars);
}

const kChartHeight = { crank: 280, plain: 250 };

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
  forget(view) {
    this.listeners = this.listeners.filter((listener) => listener !== view.follow);
  }
}

/** Index of the sample nearest to `at`, -1 without samples. */
function nearest(series, at) {
  const xs = series.angle ?? series.x;
  let best = -1;
  xs.forEach((v, k) => {
    if (v !== null && series.y[k] !== null && (best < 0 || Math.abs(v - at) < Math.abs(xs[best] - at)))
      best = k;
  });
  return best;
}

/** Where the values that are reported belong: the sample nearest to the cursor, not the cursor itself. */
function sampledPlace(panel, at) {
  const series = panel.series.find((s) => s.part !== 'measured') ?? panel.series[0];
  const k = nearest(series, at);
  const place = k < 0 ? at : (series.angle ?? series.x)[k];
  return panel.crank || panel.inOrderOfTime ? `at ${angle(place)}°` : `at ${withUnit(place, panel.xUnit, 3)}`;
}

export class FigureView {
  /** @param context visibility, group (CycleGroup), stem of file names, subtitle for files */
  constructor(figure, context) {
    this.context = context;
    this.figure = figure;
    this.charts = [];
    this.values = [];
    this.node = element('figure', {
      id: figure.id,
      class: `figure ${figure.layout === 'row' ? 'row' : ''} ${isHalfAPage(figure) ? 'half' : ''}`,
    });
    this.build();
    this.follow = () => this.refresh();
    context.visibility.listeners.push(this.follow);
  }

  build() {
    const { figure } = this;
    this.title = element('h3', {}, figure.title);
    const paper =
      figure.paper && this.context.besidePaper
        ? element('span', { class: 'paper' }, `${figure.paper} of the paper`)
        : null;
    this.heading = element(
      'div',
      { class: 'figure-heading' },
      this.title,
      paper,
      this.scaleButton(),
      this.downloads(),
    );
    this.body = element('div', { class: 'panels' });
    this.caption = element('figcaption', {}, figure.caption);
    this.print = element('div', { class: 'print-only' });
    this.node.append(this.heading, this.body, this.print, this.caption);
    this.lay();
    this.refresh();
  }

  lay() {
    this.figure.panels.forEach((panel, i) =>
      this.body.append(panel.bars ? this.bars() : this.chartPanel(panel, i)),
    );
  }

  /** Another figure in the place of this one, with charts of its own. */
  replace(figure) {
    const { group } = this.context;
    for (const { chart } of this.charts) {
      if (figure.group) group.remove(chart);
      else chart?.plot.destroy();
    }
    this.figure = figure;
    this.charts = [];
    this.body.replaceChildren();
    this.lay();
    this.start();
    this.refresh();
  }

  /** Turns the y axes of a figure that offers it from linear to logarithmic and back. */
  scaleButton() {
    if (!this.figure.offersLog) return null;
    const button = element(
      'button',
      {
        type: 'button',
        class: 'download scale',
        'aria-pressed': 'false',
        'aria-label': `${this.figure.title}: logarithmic axis`,
        onclick: () => {
          const isLog = button.getAttribute('aria-pressed') !== 'true';
          const windows = this.charts.map(({ chart }) => chart.window);
          this.linear ??= this.figure;
          this.replace(isLog ? logarithmic(this.linear) : this.linear);
          this.charts.forEach(({ chart }, i) => chart.zoom(...windows[i]));
          button.setAttribute('aria-pressed', String(isLog));
        },
      },
      'log',
    );
    return button;
  }

  chartPanel(panel, index) {
    const { figure, context } = this;
    const host = element('div', {
      class: 'chart',
      role: 'img',
      'aria-label': spokenSummary({ panels: [panel] }),
    });
    const at = element('span', { class: 'at' });
    const values = panel.series.map(() => element('span', { class: 'value' }));
    const entries = panel.series.map((s, i) => this.legendEntry(s, values[i]));
    const node = element(
      'div',
      { class: 'panel' },
      element('div', { class: 'axis-title' }, axisTitle(panel.yLabel, panel.yUnit)),
      host,
      element('div', { class: 'axis-title below' }, axisTitle(panel.xLabel, panel.xUnit)),
      element('div', { class: 'legend' }, at, entries),
    );
    const readOut = (x) => {
      const shown = this.figure.panels[index];
      at.textContent = x === null ? '' : sampledPlace(shown, x);
      shown.series.forEach((s, i) => {
        values[i].textContent = x === null ? '' : number(s.y[nearest(s, x)], 4);
      });
    };
    // uPlot measures its host, which must be in the page first.
    this.charts.push({
      start: () =>
        new Chart(host, panel, {
          visible: context.visibility.shows,
          readOut,
          group: figure.group ? context.group : null,
          height: panel.crank ? kChartHeight.crank : kChartHeight.plain,
        }),
      entries,
      panel,
    });
    return node;
  }

  legendEntry(series, value) {
    const { visibility } = this.context;
    const sample = svgElement(swatchSvg(series));
    const label = element('span', { class: 'label' }, series.label);
    if (!isOneOfSeveral(series.caseIndex)) return element('span', { class: 'entry' }, sample, label, value);
    return element(
      'button',
      {
        type: 'button',
        class: 'entry',
        'aria-pressed': 'true',
        title: `Hide or show ${series.label}`,
        'data-case': series.caseIndex,
        onclick: () => visibility.toggle(series.caseIndex),
      },
      sample,
      label,
      value,
    );
  }

  bars() {
    // One drawing holds all bar panels of the figure.
    if (this.barHost) return '';
    this.barHost = element('div', { class: 'bars', role: 'img', 'aria-label': this.figure.caption });
    return this.barHost;
  }

  drawBars() {
    const width = Math.max(320, Math.min(1060, this.barHost.clientWidth || 760));
    const entries = this.figure.panels[0].groups.map((g) => this.legendEntry(g, ''));
    entries
      .filter((e) => e.dataset.case !== undefined)
      .forEach((e) =>
        e.setAttribute('aria-pressed', String(!this.context.visibility.hidden.has(Number(e.dataset.case)))),
      );
    this.barHost.replaceChildren(
      svgElement(figureSvg(this.figure, this.context.visibility.shows, { width, heading: false })),
      element('div', { class: 'legend' }, entries),
    );
  }

  /** Draws; to be called once the node is in the page. */
  start() {
    for (const entry of this.charts) entry.chart = entry.start();
    if (this.barHost) {
      this.drawBars();
      onNewWidth(this.node, () => this.drawBars());
    }
  }

  refresh() {
    const { visibility } = this.context;
    for (const { chart, entries, panel } of this.charts) {
      chart?.refresh();
      entries.forEach((entry, i) => {
        if (isOneOfSeveral(panel.series[i].caseIndex))
          entry.setAttribute('aria-pressed', String(visibility.shows(panel.series[i])));
      });
    }
    if (this.barHost?.isConnected) this.drawBars();
  }

  svg(options) {
    const windows = Object.fromEntries(
      this.charts.filter((c) => c.chart).map(({ chart }) => [chart.panel.id, chart.window]),
    );
    return figureSvg(this.figure, this.context.visibility.shows, {
      windows,
      subtitle: this.context.subtitle,
      ...options,
    });
  }

  downloads() {
    const name = (ending) => `${fileStem(this.context.stem, this.figure.id)}.${ending}`;
    const button = (label, action) =>
      element(
        'button',
        {
          type: 'button',
          class: 'download',
          'aria-label': `${this.figure.title} as ${label}`,
          onclick: action,
        },
        label,
      );
    return element(
      'span',
      { class: 'downloads' },
      button('PNG', () => savePng(name('png'), this.svg())),
      button('SVG', () => save(name('svg'), 'image/svg+xml', this.svg())),
      button('CSV', () => save(name('csv'), 'text/csv', figureCsv(this.linear ?? this.figure))),
    );
  }

  /** Lays a static drawing beside the charts for the printer. */
  beforePrint() {
    this.print.replaceChildren(
      svgElement(
        this.svg({ width: isHalfAPage(this.figure) ? kPrinted.half : kPrinted.whole, subtitle: '' }),
      ),
    );
  }
}
