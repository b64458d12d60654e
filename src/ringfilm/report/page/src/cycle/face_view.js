// Pressure, film and film content along the face at the crank angle that the reader picks: with the slider, by
// play, or under the cursor of the charts over the cycle.
import { code, element } from '../dom.js';
import { ChartView } from '../figure/chart_view.js';
import { AngleSlider } from '../figure/choices.js';
import { yRange } from '../plot/scales.js';
import { fieldAngles, fieldFigure } from './other_figures.js';

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

/** Ranges of each panel over all angles: play keeps its axes. */
function wholeRanges(model, angles) {
  const ranges = new Map();
  for (const panel of angles.flatMap((angle) => fieldFigure(model, angle).panels)) {
    const [low, high] = yRange(panel, () => true, panel.xRange);
    const [lowest, highest] = ranges.get(panel.id) ?? [low, high];
    ranges.set(panel.id, [Math.min(low, lowest), Math.max(high, highest)]);
  }
  return ranges;
}

/** The view of the fields; null without any. */
export function faceView(model, context) {
  const angles = fieldAngles(model);
  if (angles.length === 0) return null;
  let [timer, ranges] = [null, null];
  const figureAt = (angle) => {
    const figure = fieldFigure(model, angle);
    return timer
      ? { ...figure, panels: figure.panels.map((panel) => ({ ...panel, yRange: ranges.get(panel.id) })) }
      : figure;
  };
  const stop = () => {
    window.clearInterval(timer);
    timer = null;
    playButton.textContent = 'Play';
  };
  const play = () => {
    ranges ??= wholeRanges(model, angles);
    playButton.textContent = 'Pause';
    timer = window.setInterval(() => slider.choose((slider.index + 1) % angles.length), kPlayStep);
  };
  const playButton = element(
    'button',
    {
      type: 'button',
      class: 'download',
      onclick: () => {
        if (!timer) return play();
        stop();
        return slider.set(slider.index);
      },
    },
    'Play',
  );
  const slider = new AngleSlider({
    id: 'face-angle',
    spoken: 'crank angle of the fields along the face',
    angles,
    // The peak of the gas pressure is where most readers look first.
    at: model.cases[0].values.peak_gas_pressure_angle,
    group: context.group,
    show: () => view.replace(figureAt(slider.angle)),
    more: playButton,
    isFree: () => !timer,
  });
  slider.input.addEventListener('input', stop, { capture: true });
  const view = new ChartView(figureAt(slider.angle), context, [slider.node]);
  return view;
}
