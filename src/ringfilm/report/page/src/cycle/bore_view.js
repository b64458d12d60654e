// The drawing of the ring in its bore on the page: crank angle as the reader picks it.
import { boreDrawing, enlargement } from './bore_drawing.js';
import { AngleSlider } from '../figure/choices.js';
import { DrawingView } from '../figure/drawing_view.js';
import { number } from '../units.js';

/** @param one a case with a bore that is not round: { name, data, peakAngle } */
export function boreView(model, { name, data, peakAngle }, context) {
  const slider = new AngleSlider({
    id: 'bore-angle',
    spoken: 'crank angle of the ring in its bore',
    angles: data.stripAngles,
    at: peakAngle,
    group: context.group,
    show: () => view.redraw(),
  });
  const title = `The ring in its bore${model.several ? `, ${name}` : ''}`;
  const figure = {
    id: 'ring-in-bore',
    named: 'Ring in its bore',
    title,
    host: 'bore-drawing',
    get savedTitle() {
      return `${title} ${slider.words}`;
    },
    get spoken() {
      return `${title} ${slider.words}`;
    },
    draw: (width) => boreDrawing(data, slider.k, width),
    caption: () =>
      'Bore and face of the ring, their deviations from a circle enlarged ' +
      `${number(enlargement(data), 3)} times over the bore (scale in the middle), the same at all ` +
      'crank angles; dashed the round bore. Between them the smallest film thickness of each strip, ' +
      'orange where the ring is lifted off: where it carries less than a tenth of what presses it on. ' +
      'Loads and friction per length around the ring; next to its ends they may exceed the scale.',
  };
  const view = new DrawingView(figure, context, [slider.node]);
  return view;
}
