// Pressure, film and film content along the face at the crank angle that the reader picks.
import { FigureView } from './figure_view.js';
import { element } from '../dom.js';
import { fieldAngles, fieldFigure } from './other_figures.js';
import { angleInWords, wrapped } from '../units.js';

export class FaceView {
  constructor(model, context) {
    this.model = model;
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
      oninput: () => this.show(Number(this.slider.value)),
    });
    this.angleText = element('output', { for: 'face-angle' });
    const row = element(
      'div',
      { class: 'slider' },
      element('label', { for: 'face-angle' }, 'Crank angle'),
      this.slider,
      this.angleText,
    );
    this.view.heading.after(row);
    this.node = this.view.node;
    this.showAngle();
  }

  showAngle() {
    const words = angleInWords(this.angles[this.index]);
    this.angleText.textContent = words.replace(/^at /, '');
    this.slider.setAttribute('aria-valuetext', words);
  }

  show(index) {
    this.index = index;
    const next = fieldFigure(this.model, this.angles[index]);
    const same =
      next.panels.length === this.view.figure.panels.length &&
      next.panels.every(
        (panel, i) =>
          panel.series.map((s) => s.label).join() ===
          this.view.figure.panels[i].series.map((s) => s.label).join(),
      );
    this.view.figure = next;
    this.view.title.textContent = next.title;
    this.showAngle();
    if (!same) {
      // Another set of cases has fields at this angle: the charts are laid anew.
      this.view.charts = [];
      this.view.body.replaceChildren();
      next.panels.forEach((panel, i) => this.view.body.append(this.view.chartPanel(panel, i)));
      this.view.start();
      return;
    }
    next.panels.forEach((panel, i) => this.view.charts[i].chart.replace(panel));
  }

  start() {
    this.view.start();
  }
  beforePrint() {
    this.view.beforePrint();
  }
}
