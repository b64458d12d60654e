// One panel of curves that follows the pointer: the drawing of files and print, and a cursor over it.
import { element, onNewWidth, svgElement } from '../dom.js';
import { linePanel } from './line_panel.js';
import { caseColour } from './palette.js';
import { xRange } from './scales.js';
import { svgDocument } from './svg_shapes.js';

const kHeight = 312;
/** A shorter drag is a click [pixel]. */
const kShortestDrag = 4;

/** All charts over the cycle, so that cursor and zoom of one go through all. */
export class CycleGroup {
  constructor() {
    this.charts = [];
    this.listeners = [];
    /** Called with the crank angle under the cursor. */
    this.followers = [];
  }
  /** Puts the cursors of all charts at an angle; null: away. */
  point(angle) {
    this.charts.forEach((chart) => chart.point(angle));
  }
  moved(angle) {
    this.point(angle);
    if (angle !== null) this.followers.forEach((follow) => follow(angle));
  }
  remove(chart) {
    this.charts = this.charts.filter((other) => other !== chart);
  }
  zoom(low, high) {
    this.charts.forEach((chart) => chart.zoom(low, high));
    this.listeners.forEach((listener) => listener(low, high));
  }
}

/** Index of the sample nearest to `at`, -1 without samples; in the order of time that of the nearest angle. */
function nearest(series, at) {
  const xs = series.angle ?? series.x;
  let best = -1;
  for (let k = 0; k < xs.length; k++)
    if (
      xs[k] !== null &&
      series.y[k] !== null &&
      (best < 0 || Math.abs(xs[k] - at) < Math.abs(xs[best] - at))
    )
      best = k;
  return best;
}

export class Chart {
  /**
   * @param visible returns whether a series is shown; @param readOut receives the index of the sample at the
   * cursor in each series, null when the cursor leaves; @param width width of the host, where it is known
   */
  constructor(host, panel, { visible, readOut, group, width = host.clientWidth }) {
    Object.assign(this, { host, visible, readOut, group, width });
    this.line = element('div', { class: 'cursor-line' });
    this.selection = element('div', { class: 'selection' });
    this.over = element('div', { class: 'over' }, this.selection, this.line);
    this.listen();
    this.replace(panel);
    group?.charts.push(this);
    onNewWidth(
      host,
      () => {
        this.width = host.clientWidth;
        this.draw();
      },
      width,
    );
  }

  /** Another panel in the place of this one, in the same window of the same axis. */
  replace(panel) {
    const full = xRange(panel);
    if (full.join() !== this.full?.join()) this.window = full;
    Object.assign(this, { panel, full });
    this.line.hidden = Boolean(panel.inOrderOfTime);
    this.dots?.forEach((dot) => dot.remove());
    this.dots = panel.series.map((s) =>
      element('div', { class: 'cursor-dot', style: `background: ${caseColour(s.caseIndex)}` }),
    );
    this.over.append(...this.dots);
    this.draw();
  }

  draw() {
    const { panel, host } = this;
    const width = this.width || 320;
    const box = { x: 0, y: 0, width, height: kHeight };
    const { shapes, plot, x, y } = linePanel(panel, box, this.visible, this.window);
    Object.assign(this, { plot, x, y, shown: this.shownSeries() });
    this.over.style.cssText =
      `left:${plot.left}px;top:${plot.top}px;` +
      `width:${plot.right - plot.left}px;height:${plot.bottom - plot.top}px`;
    host.replaceChildren(svgElement(svgDocument({ shapes, height: kHeight }, width)), this.over);
    this.point(this.at ?? null);
  }

  shownSeries() {
    return this.panel.series.map((s) => this.visible(s)).join();
  }

  /** Draws anew after `visible` has changed its mind. */
  refresh() {
    if (this.shownSeries() !== this.shown) this.draw();
  }

  /** Value of x at a distance from the left edge of the plot. */
  valueAt(left) {
    const [low, high] = this.window;
    const share = left / (this.plot.right - this.plot.left);
    return this.panel.xScale === 'log' ? low * (high / low) ** share : low + share * (high - low);
  }

  /** In the order of time the angle of the point nearest to the pointer, elsewhere the value of x under it. */
  target({ left, top }) {
    if (!this.panel.inOrderOfTime) return this.valueAt(left);
    let best = { distance: Infinity, angle: null };
    for (const s of this.panel.series.filter(this.visible)) {
      s.x.forEach((v, k) => {
        if (v === null || s.y[k] === null) return;
        const distance = Math.hypot(this.x(v) - this.plot.left - left, this.y(s.y[k]) - this.plot.top - top);
        if (distance < best.distance) best = { distance, angle: s.angle[k] };
      });
    }
    return best.angle;
  }

  /** Puts the cursor at an x value, in the order of time at an angle; away where the window does not show it. */
  point(at) {
    const { panel, plot, window } = this;
    const isShown = at !== null && (panel.inOrderOfTime || (at >= window[0] && at <= window[1]));
    this.at = isShown ? at : null;
    this.over.classList.toggle('pointed', isShown);
    if (!isShown) {
      this.readOut(null);
      return;
    }
    if (!panel.inOrderOfTime) this.line.style.transform = `translateX(${this.x(at) - plot.left}px)`;
    const places = panel.series.map((s) => nearest(s, at));
    panel.series.forEach((s, i) => {
      const k = places[i];
      const [left, top] = k < 0 ? [NaN, NaN] : [this.x(s.x[k]) - plot.left, this.y(s.y[k]) - plot.top];
      const isInside = left >= -1 && left <= plot.right - plot.left + 1 && Number.isFinite(top);
      const { style } = this.dots[i];
      style.display = isInside && this.visible(s) ? '' : 'none';
      style.transform = `translate(${left}px, ${top}px)`;
    });
    this.readOut(places);
  }

  move(at) {
    if (this.group) this.group.moved(at);
    else this.point(at);
  }

  zoomAll(low, high) {
    if (this.group) this.group.zoom(low, high);
    else this.zoom(low, high);
  }

  zoom(low, high) {
    this.window = [Math.max(low, this.full[0]), Math.min(high, this.full[1])];
    this.draw();
  }

  /** A mouse moves the cursor and drags a zoom; a finger moves the cursor sideways, and the page up and down. */
  listen() {
    const { over, selection } = this;
    let from = null;
    const placeOf = (event) => {
      const box = over.getBoundingClientRect();
      const within = (v, most) => Math.min(most, Math.max(0, v));
      return {
        left: within(event.clientX - box.left, box.width),
        top: within(event.clientY - box.top, box.height),
      };
    };
    over.addEventListener('pointermove', (event) => {
      const place = placeOf(event);
      if (from !== null) {
        selection.style.left = `${Math.min(from, place.left)}px`;
        selection.style.width = `${Math.abs(place.left - from)}px`;
      }
      this.move(this.target(place));
    });
    over.addEventListener('pointerleave', (event) => {
      if (event.pointerType !== 'touch') this.move(null);
    });
    over.addEventListener('pointerdown', (event) => {
      if (event.pointerType === 'touch' || event.button !== 0 || this.panel.inOrderOfTime) return;
      over.setPointerCapture(event.pointerId);
      from = placeOf(event).left;
      event.preventDefault();
    });
    over.addEventListener('pointerup', (event) => {
      if (from === null) return;
      const ends = [from, placeOf(event).left].sort((a, b) => a - b);
      from = null;
      selection.style.width = '0';
      if (ends[1] - ends[0] >= kShortestDrag) this.zoomAll(...ends.map((left) => this.valueAt(left)));
    });
    over.addEventListener('pointercancel', () => {
      from = null;
      selection.style.width = '0';
    });
    over.addEventListener('dblclick', () => this.zoomAll(...this.full));
  }
}
