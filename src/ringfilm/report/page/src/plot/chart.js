// One panel as an interactive uPlot chart. The panel's plain data decide everything; this file only draws.
import uPlot from 'uplot';
import { onNewWidth } from '../dom.js';
import {
  arrowHeads,
  arrowPath,
  bandOutlines,
  deadCentre,
  freePlace,
  kDeadCentres,
  kPeakLabel,
  kRoomForPeak,
  kSpanHeight,
  kStrokeBands,
  markIndices,
  markPlaces,
  spanBars,
  xRange,
  xTicks,
  yRange,
  yTicks,
} from './scales.js';
import { caseColour, caseMark, kBandOpacity, markPath, partDash } from './palette.js';
import { tickText } from '../units.js';

const kInk = '#30343b';
const kFaint = '#5c6470';
const sansFont = (size) => `${size}px 'Segoe UI', 'Helvetica Neue', Arial, 'Liberation Sans', sans-serif`;
const kFont = sansFont(12);
const kSmallFont = sansFont(11);

/** All charts over the cycle, so that a zoom in one goes through all. */
export class CycleGroup {
  constructor() {
    this.sync = uPlot.sync('cycle');
    this.charts = [];
    this.listeners = [];
    /** Called with the crank angle under the cursor. */
    this.followers = [];
    this.isDriven = false;
  }
  moved(angle) {
    if (!this.isDriven) this.followers.forEach((follow) => follow(angle));
  }
  /** Puts the cursors of all charts at an angle. */
  point(angle) {
    this.isDriven = true;
    this.charts.forEach((chart) => chart.point(angle));
    this.isDriven = false;
  }
  remove(chart) {
    this.charts = this.charts.filter((other) => other !== chart);
    chart.plot.destroy();
  }
  zoom(low, high) {
    this.charts.forEach((chart) => chart.zoom(low, high));
    this.listeners.forEach((listener) => listener(low, high));
  }
}

function pixels(u, drawIn) {
  const ratio = devicePixelRatio;
  const { ctx } = u;
  ctx.save();
  ctx.scale(ratio, ratio);
  drawIn(ctx, {
    left: u.bbox.left / ratio,
    top: u.bbox.top / ratio,
    width: u.bbox.width / ratio,
    height: u.bbox.height / ratio,
    x: (v) => u.valToPos(v, 'x', true) / ratio,
    y: (v) => u.valToPos(v, 'y', true) / ratio,
  });
  ctx.restore();
}

function line(ctx, x1, y1, x2, y2, stroke, dash = []) {
  ctx.strokeStyle = stroke;
  ctx.lineWidth = 1;
  ctx.setLineDash(dash);
  ctx.beginPath();
  ctx.moveTo(x1, y1);
  ctx.lineTo(x2, y2);
  ctx.stroke();
}

/** Words with a white rim, legible where a curve runs behind them. */
function rimmed(ctx, label, x, y) {
  ctx.textAlign = 'left';
  ctx.fillStyle = kFaint;
  ctx.setLineDash([]);
  ctx.lineWidth = 3;
  ctx.strokeStyle = '#fff';
  ctx.strokeText(label, x, y);
  ctx.fillText(label, x, y);
}

export class Chart {
  /**
   * @param visible returns whether a series is shown; @param readOut receives the x value under the cursor,
   * null when it leaves
   */
  constructor(host, panel, { visible, readOut, group, height }) {
    Object.assign(this, { host, panel, visible, readOut, group, height });
    this.full = xRange(panel);
    this.window = this.full;
    this.plot = new uPlot(this.options(), this.data(), host);
    this.listenToTouch();
    if (group) group.charts.push(this);
    onNewWidth(host, () => this.fit());
  }

  data() {
    const { panel } = this;
    if (panel.inOrderOfTime) return [null, ...panel.series.map((s) => [s.x, s.y])];
    return uPlot.join(
      panel.series.map((s) => [s.x, s.y]),
      panel.series.map((s) => s.y.map(() => 2)),
    );
  }

  options() {
    const { panel } = this;
    const axisLook = {
      stroke: kInk,
      font: kFont,
      ticks: { stroke: kInk, size: 5, width: 1 },
      border: { show: true, stroke: kInk, width: 1 },
    };
    return {
      mode: panel.inOrderOfTime ? 2 : 1,
      width: this.host.clientWidth || 320,
      height: this.height,
      padding: [panel.crank ? 22 : 10, 14, 0, 0],
      legend: { show: false },
      scales: {
        x: { time: false, distr: panel.xScale === 'log' ? 3 : 1, range: () => this.window },
        y: {
          distr: panel.yScale === 'log' ? 3 : 1,
          // The panel of now: that of the options may have been replaced.
          range: () => yRange(this.panel, this.visible, this.window),
        },
      },
      axes: [
        {
          ...axisLook,
          size: panel.crank ? 44 : 30,
          gap: 4,
          grid: { show: !panel.crank, stroke: '#e3e6ea', width: 1 },
          splits: (u, i, low, high) => xTicks(panel, low, high, u.bbox.width / devicePixelRatio / 70).values,
          filter: (u, list) => list,
          values: (u, list) => {
            const { step } = xTicks(panel, ...this.window, u.bbox.width / devicePixelRatio / 70);
            return list.map((v) => [tickText(v, step), deadCentre(panel, v)].filter(Boolean).join('\n'));
          },
        },
        {
          ...axisLook,
          size: 54,
          gap: 4,
          grid: { show: true, stroke: '#e3e6ea', width: 1 },
          splits: (u, i, low, high) => yTicks(panel, low, high, u.bbox.height / devicePixelRatio / 32).values,
          filter: (u, list) => list,
          values: (u, list) => {
            const { step } = yTicks(
              panel,
              u.scales.y.min,
              u.scales.y.max,
              u.bbox.height / devicePixelRatio / 32,
            );
            return list.map((v) => tickText(v, step));
          },
        },
      ],
      series: [panel.inOrderOfTime ? null : {}, ...panel.series.map((s) => this.seriesOptions(s))],
      cursor: {
        y: false,
        points: { show: !panel.inOrderOfTime, size: 7 },
        drag: { x: !panel.inOrderOfTime, y: false, setScale: false },
        ...(this.group
          ? {
              sync: {
                key: this.group.sync.key,
                scales: ['x', null],
                setSeries: false,
                filters: { pub: (type) => type === 'mousemove' || type === 'mouseleave' },
              },
            }
          : {}),
        bind: {
          dblclick: () => () => {
            this.zoomAll(...this.full);
            return null;
          },
        },
      },
      hooks: {
        drawClear: [
          (u) =>
            pixels(u, (ctx, box) => {
              this.drawBehind(ctx, box);
              this.drawErrors(ctx, box);
            }),
        ],
        draw: [(u) => pixels(u, (ctx, box) => this.drawOver(ctx, box))],
        setCursor: [(u) => this.cursorMoved(u)],
        setSelect: [(u) => this.selected(u)],
      },
    };
  }

  seriesOptions(s) {
    // A point rounded to whole pixels would make a straight line waver.
    const look = {
      stroke: caseColour(s.caseIndex),
      width: 1.8,
      pxAlign: 0,
      dash: partDash(s.part),
      show: this.visible(s),
    };
    if (this.panel.inOrderOfTime) {
      return {
        ...look,
        facets: [
          { scale: 'x', auto: true },
          { scale: 'y', auto: true },
        ],
        paths: (u, i) => this.drawInOrder(u, i),
      };
    }
    if (s.part === 'measured')
      return {
        ...look,
        stroke: '#000',
        width: 0,
        paths: () => null,
        points: { show: true, size: 4.5, width: 1, stroke: '#000', fill: '#fff' },
      };
    // Drawn over all lines, with the marks.
    if (s.part === 'points') return { ...look, paths: () => null, points: { show: false } };
    return { ...look, points: { show: false } };
  }

  /** The errors about the curves, light and behind everything that is drawn. */
  drawErrors(ctx, box) {
    ctx.save();
    ctx.beginPath();
    ctx.rect(box.left, box.top, box.width, box.height);
    ctx.clip();
    ctx.globalAlpha = kBandOpacity;
    for (const s of this.panel.series.filter(this.visible)) {
      ctx.fillStyle = caseColour(s.caseIndex);
      for (const outline of bandOutlines(s)) {
        ctx.beginPath();
        for (const [x, y] of outline) ctx.lineTo(box.x(x), box.y(y));
        ctx.fill();
      }
    }
    ctx.restore();
  }

  /** Stroke bands, dead centres, the peak of the pressure. */
  drawBehind(ctx, box) {
    const { panel } = this;
    if (!panel.crank) return;
    const [from, to] = this.window;
    ctx.font = kSmallFont;
    const widest = Math.max(...kStrokeBands.map((band) => ctx.measureText(band.name).width));
    ctx.font = sansFont(Math.min(11, Math.max(8, (11 * (box.x(180) - box.x(0) - 4)) / widest)));
    ctx.textAlign = 'center';
    ctx.textBaseline = 'alphabetic';
    kStrokeBands.forEach((band, i) => {
      const [a, b] = [Math.max(band.from, from), Math.min(band.to, to)];
      if (b <= a) return;
      if (i % 2 === 1) {
        ctx.fillStyle = '#f4f6f8';
        ctx.fillRect(box.x(a), box.top, box.x(b) - box.x(a), box.height);
      }
      const room = box.x(b) - box.x(a);
      ctx.fillStyle = kFaint;
      if (room > ctx.measureText(band.name).width + 3)
        ctx.fillText(band.name, (box.x(a) + box.x(b)) / 2, box.top - 7);
    });
    for (const bar of spanBars(panel, this.window, this.visible)) {
      ctx.fillStyle = caseColour(bar.caseIndex);
      ctx.fillRect(
        box.x(bar.from),
        box.top + bar.top,
        Math.max(1, box.x(bar.to) - box.x(bar.from)),
        kSpanHeight,
      );
    }
    for (const centre of kDeadCentres) {
      if (centre.at > from && centre.at < to)
        line(
          ctx,
          box.x(centre.at),
          box.top + box.height,
          box.x(centre.at),
          box.top - (centre.at === 0 ? 5 : 0),
          '#aab1bb',
        );
    }
    for (const peak of panel.peaks ?? []) {
      if (peak.at >= from && peak.at <= to)
        line(
          ctx,
          box.x(peak.at),
          box.top + box.height,
          box.x(peak.at),
          box.top - 3,
          caseColour(peak.caseIndex),
          [3, 3],
        );
    }
    const [first] = panel.peaks ?? [];
    const roomForPeak = (box.x(180) - box.x(0)) / 2 - (box.x(first?.at ?? 0) - box.x(0)) > kRoomForPeak;
    if (first && first.at >= from && first.at <= to && roomForPeak) {
      ctx.textAlign = 'left';
      ctx.fillStyle = kFaint;
      ctx.fillText(kPeakLabel, box.x(first.at) + 3, box.top - 7);
    }
  }

  /** Zero line, limits, the marks of each case. */
  drawOver(ctx, box) {
    const { panel, plot } = this;
    const { min: bottom, max: top } = plot?.scales.y ?? {};
    if (bottom === undefined) return;
    if (panel.zeroLine && bottom < 0 && top > 0)
      line(ctx, box.left, box.y(0), box.left + box.width, box.y(0), kInk);
    ctx.setLineDash([]);
    const count = panel.series.filter((s) => s.caseIndex !== null).length;
    for (const s of panel.series.filter(this.visible)) {
      for (const k of markIndices(s, ...this.window, count, panel.xScale)) {
        const outline = new Path2D(markPath(caseMark(s.caseIndex), box.x(s.x[k]), box.y(s.y[k]), 3.4));
        ctx.fillStyle = '#fff';
        ctx.fill(outline);
        ctx.lineWidth = 1.4;
        ctx.strokeStyle = caseColour(s.caseIndex);
        ctx.stroke(outline);
      }
    }
    ctx.font = kSmallFont;
    for (const mark of markPlaces(
      panel.xMarks ?? [],
      box.x,
      (label) => ctx.measureText(label).width,
      box.left,
      box.left + box.width,
    )) {
      line(ctx, mark.line, box.top, mark.line, box.top + box.height, kFaint, [4, 3]);
      rimmed(ctx, mark.label, mark.left, box.top + 11 + 13 * mark.row);
    }
    for (const mark of panel.yMarks ?? []) {
      if (mark.at < bottom || mark.at > top) continue;
      line(ctx, box.left, box.y(mark.at), box.left + box.width, box.y(mark.at), kFaint, [2, 3]);
      ctx.font = kSmallFont;
      const place = freePlace(panel, this.visible, mark.at, ctx.measureText(mark.label).width, box);
      rimmed(ctx, mark.label, place.x, place.y);
    }
    if (this.marked) this.drawMarked(ctx, box);
  }

  /** A curve whose x does not only grow: drawn in the order of its points, with arrows. */
  drawInOrder(u, i) {
    const s = this.panel.series[i - 1];
    pixels(u, (ctx, box) => {
      const points = s.x.map((v, k) => (v === null || s.y[k] === null ? null : [box.x(v), box.y(s.y[k])]));
      ctx.beginPath();
      ctx.rect(box.left, box.top, box.width, box.height);
      ctx.clip();
      ctx.strokeStyle = ctx.fillStyle = caseColour(s.caseIndex);
      ctx.lineWidth = 1.8;
      ctx.lineJoin = 'round';
      ctx.beginPath();
      let pen = false;
      for (const p of points) {
        if (p) ctx[pen ? 'lineTo' : 'moveTo'](...p);
        pen = p !== null;
      }
      ctx.stroke();
      for (const head of arrowHeads(points, 6)) ctx.fill(new Path2D(arrowPath(head, 6)));
    });
    return null;
  }

  /** In a chart in the order of time the read-out belongs to the nearest point, not to an x value. */
  drawMarked(ctx, box) {
    for (const { s, k } of this.marked) {
      ctx.beginPath();
      ctx.arc(box.x(s.x[k]), box.y(s.y[k]), 4.5, 0, 2 * Math.PI);
      ctx.fillStyle = caseColour(s.caseIndex);
      ctx.fill();
    }
  }

  cursorMoved(u) {
    const { left, top } = u.cursor;
    if (left === undefined || left < 0) {
      if (this.marked) {
        this.marked = null;
        u.redraw(false, false);
      }
      return this.readOut(null);
    }
    if (!this.panel.inOrderOfTime) {
      const at = u.posToVal(left, 'x');
      this.group?.moved(at);
      return this.readOut(at);
    }
    let best = null;
    for (const s of this.panel.series.filter(this.visible)) {
      s.x.forEach((v, k) => {
        if (v === null || s.y[k] === null) return;
        const distance = Math.hypot(u.valToPos(v, 'x') - left, u.valToPos(s.y[k], 'y') - top);
        if (!best || distance < best.distance) best = { distance, angle: s.angle[k] };
      });
    }
    if (!best) return undefined;
    // The same instant in every case, for a comparison.
    this.marked = this.panel.series
      .filter(this.visible)
      .map((s) => ({ s, k: s.angle.indexOf(best.angle) }))
      .filter(({ s, k }) => k >= 0 && s.x[k] !== null);
    u.redraw(false, false);
    return this.readOut(best.angle);
  }

  selected(u) {
    const { left, width } = u.select;
    if (width < 4) return;
    const [low, high] = [u.posToVal(left, 'x'), u.posToVal(left + width, 'x')];
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.zoomAll(low, high);
  }

  zoomAll(low, high) {
    if (this.group) this.group.zoom(low, high);
    else this.zoom(low, high);
  }

  zoom(low, high) {
    this.window = [Math.max(low, this.full[0]), Math.min(high, this.full[1])];
    this.plot.setScale('x', { min: this.window[0], max: this.window[1] });
  }

  /** Puts the cursor at an x value; away where the window does not show it. */
  point(at) {
    const { plot } = this;
    const isShown = at >= this.window[0] && at <= this.window[1];
    const away = { left: -10, top: -10 };
    plot.setCursor(isShown ? { left: plot.valToPos(at, 'x'), top: 0 } : away, true, false);
  }

  /** Shows and hides series after `visible` has changed its mind. */
  refresh() {
    this.panel.series.forEach((s, i) => {
      if (this.plot.series[i + 1].show !== this.visible(s))
        this.plot.setSeries(i + 1, { show: this.visible(s) });
    });
  }

  /** New numbers for the same series. */
  replace(panel) {
    this.panel = panel;
    this.plot.setData(this.data());
  }

  fit() {
    const width = this.host.clientWidth;
    if (width > 0 && width !== this.plot.width) this.plot.setSize({ width, height: this.height });
  }

  /** A finger moves the cursor sideways; the page still scrolls up and down. */
  listenToTouch() {
    const { over } = this.plot;
    over.style.touchAction = 'pan-y';
    over.addEventListener('pointermove', (event) => {
      if (event.pointerType !== 'touch') return;
      const box = over.getBoundingClientRect();
      this.plot.setCursor({ left: event.clientX - box.left, top: event.clientY - box.top }, true, true);
    });
  }
}
