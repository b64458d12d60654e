// Pressure, film and film content along the face at the crank angle that the reader picks: with the slider, by
// play, or under the cursor of the charts over the cycle.
import { FigureView } from './figure_view.js';
import { code, element } from '../dom.js';
import { yRange } from '../plot/scales.js';
import { fieldAngles, fieldFigure } from './other_figures.js';
import { angleInWords, wrapped } from '../units.js';

/** The figure with given ranges of its y axes, by panel. */
function withRanges(figure, ranges) {
  const panels = figure.panels.map((panel) => ({ ...panel, yRange: ranges.get(panel.id) }));
  return { ...figure, panels };
}

/** Time that play shows one angle [ms]. */
const kPlayStep = 80;

/** How to store the fields, where a result has none. */
export function howToStoreFields() {
  return element(
    'p',
    { class: 'how across' },
    'This result has no fields along the face. Run the case again with ',
    code("--set output.fields='all'"),
    ' (or a list of crank angles), and pressure, film and asperity pressure are shown here at each angle.',
  );
}

export class FaceView {
  constructor(model, context) {
    this.model = model;
    this.group = context.group;
    this.angles = fieldAngles(model);
    // The peak of the gas pressure is where most readers look first.
    const peak = wrapped(model.cases[0].values.peak_gas_pressure_angle ?? 0) ?? 0;
    this.index = this.angles.reduce(
      (best, a, k) => (Math.abs(a - peak) < Math.abs(this.angles[best] - peak) ? k : best),
      0,
    );
    this.view = new FigureView(fieldFigure(model, this.angles[this.index]), context);
    this.slider = element('input', {
      type: 'range',
      min: 0,
      max: this.angles.length - 1,
      step: 1,
      value: this.index,
      id: 'face-angle',
      'aria-label': 'crank angle of the fields along the face',
      oninput: () => {
        this.stop();
        this.choose(Number(this.slider.value));
      },
    });
    this.playButton = element(
      'button',
      { type: 'button', class: 'download', onclick: () => (this.timer ? this.stop() : this.play()) },
      'Play',
    );
    context.group.followers.push((angle) => this.follow(angle));
    this.angleText = element('output', { for: 'face-angle' });
    const row = element(
      'div',
      { class: 'slider' },
      element('label', { for: 'face-angle' }, 'Crank angle'),
      this.slider,
      this.angleText,
      this.playButton,
    );
    this.view.heading.after(row);
    this.node = this.view.node;
    this.showAngle();
  }

  /** Shows an angle here and under the cursors of the charts over the cycle. */
  choose(index) {
    this.show(index);
    this.group.point(this.angles[index]);
  }

  /** Shows the angle nearest to that under a cursor, once a frame; not while it plays. */
  follow(angle) {
    if (this.timer) return;
    const turned = (a) => Math.abs(wrapped(a - angle));
    const nearest = this.angles.reduce((best, a, k) => (turned(a) < turned(this.angles[best]) ? k : best), 0);
    const isWaiting = this.next !== undefined;
    this.next = nearest;
    if (isWaiting) return;
    requestAnimationFrame(() => {
      if (this.next !== this.index) this.show(this.next);
      this.slider.value = this.index;
      this.next = undefined;
    });
  }

  /** Ranges of each panel over all angles: play keeps its axes. */
  wholeRanges() {
    const ranges = new Map();
    for (const angle of this.angles) {
      const { panels } = fieldFigure(this.model, angle);
      for (const panel of panels) {
        const [low, high] = yRange(panel, () => true, panel.xRange);
        const [lowest, highest] = ranges.get(panel.id) ?? [low, high];
        ranges.set(panel.id, [Math.min(low, lowest), Math.max(high, highest)]);
      }
    }
    return ranges;
  }

  play() {
    this.ranges ??= this.wholeRanges();
    this.playButton.textContent = 'Pause';
    this.timer = window.setInterval(() => {
      this.choose((this.index + 1) % this.angles.length);
      this.slider.value = this.index;
    }, kPlayStep);
  }

  stop() {
    window.clearInterval(this.timer);
    const wasPlaying = this.timer;
    this.timer = null;
    this.playButton.textContent = 'Play';
    if (wasPlaying) this.show(this.index);
  }

  showAngle() {
    const words = angleInWords(this.angles[this.index]);
    this.angleText.textContent = words.replace(/^at /, '');
    this.slider.setAttribute('aria-valuetext', words);
  }

  show(index) {
    this.index = index;
    const next = this.timer
      ? withRanges(fieldFigure(this.model, this.angles[index]), this.ranges)
      : fieldFigure(this.model, this.angles[index]);
    const same =
      next.panels.length === this.view.figure.panels.length &&
      next.panels.every(
        (panel, i) =>
          panel.series.map((s) => s.label).join() ===
          this.view.figure.panels[i].series.map((s) => s.label).join(),
      );
    this.view.title.textContent = next.title;
    this.showAngle();
    // Another set of cases has fields at this angle: the charts are laid anew.
    if (!same) {
      this.view.replace(next);
      return;
    }
    this.view.figure = next;
    next.panels.forEach((panel, i) => this.view.charts[i].chart.replace(panel));
  }

  start() {
    this.view.start();
  }
  beforePrint() {
    this.view.beforePrint();
  }
}
