// The ring of a static closure in its bore, as a polar drawing.
import { polarBore } from '../plot/polar_bore.js';
import { number } from '../units.js';

/** What is less than this share of the largest clearance is contact: rounding on the page. */
const kTouches = 1e-4;

/** null where the measurement is not a closure, or the bore is round. */
export function boreFigure(measurement) {
  const shape = measurement.curves.find((curve) => curve.name === 'bore_around');
  if (!shape || shape.series.length !== 2) return null;
  const [bore, ring] = shape.series.map((series) => series.y);
  if (bore.length !== ring.length) return null;
  const turns = shape.series[0].x;
  const clearance = bore.map((deviation, j) => Math.max(deviation - ring[j], 0));
  const widest = Math.max(...clearance);
  const most = Math.max(...bore.map(Math.abs), ...ring.map(Math.abs));
  if (!(most > 0)) return null;
  const isApart = clearance.map((one) => one > kTouches * widest);
  return {
    id: 'ring-in-bore',
    title: 'The ring in its bore',
    draw: (width) => polarBore({ turns, bore, clearance, isApart, apart: 'apart', most, gap: 0 }, width),
    caption: () =>
      'Bore and ring, their deviations from the dashed circle enlarged: the scale is in the middle. Angles count ' +
      'from the middle of the end gap in the direction of those of the bore. Orange where the ring is apart from ' +
      `the bore, by up to ${number(widest, 3)} µm.`,
    columns: () => [
      { title: 'angle [degree]', values: turns },
      { title: 'bore [um]', values: bore },
      { title: 'ring [um]', values: ring },
      { title: 'clearance [um]', values: clearance },
    ],
  };
}
