// The face over the running time: the first one, the chosen one, and how they are known.
import { element } from '../dom.js';
import { kOnlyCase } from '../model.js';
import { number } from '../units.js';
import { kStandings } from './life_words.js';

const kMillimetre = 1e-3;
const kMicrometre = 1e-6;

const inMicrometres = (values) => values.map((value) => value / kMicrometre);

/** The face of reported state k beside the first one; of a face that wears also as it lies on the first one. */
export function faceFigure(life, k) {
  const x = life.x.map((place) => place / kMillimetre);
  const [first, state] = [life.states[0], life.states[k]];
  const label = `${number(state.hours, 4)} h, ${state.standing}`;
  const series = [
    {
      caseIndex: null,
      part: 'viscous',
      label: `${number(first.hours, 4)} h`,
      x,
      y: inMicrometres(first.face_height),
    },
    { caseIndex: kOnlyCase, part: null, label, x, y: inMicrometres(state.face_height) },
  ];
  if (state.worn_depth) {
    series.push({
      caseIndex: null,
      part: 'boundary',
      label: 'worn depth',
      x,
      y: inMicrometres(state.worn_depth),
    });
  }
  return {
    id: 'face-over-hours',
    title: 'Face above its lowest point',
    layout: 'row',
    panels: [
      {
        id: 'face-heights',
        xLabel: 'place on the face, from the chamber edge',
        xUnit: 'mm',
        yLabel: 'height',
        yUnit: 'µm',
        fromZero: true,
        series,
      },
    ],
    caption:
      `The face after ${number(state.hours, 4)} h (${kStandings[state.standing]}) and at the start (dotted), each ` +
      'counted from its own lowest point. Heights are the gap to a straight liner: where a face wears they grow.',
  };
}

/** Edges of all faces, and their distance from the last measured one where the face wears. */
export function facesOf(life) {
  const edges = (state) =>
    `${number(state.face_height_chamber_edge / kMicrometre, 3)} µm at the chamber edge, ` +
    `${number(state.face_height_crankcase_edge / kMicrometre, 3)} µm at the crankcase edge`;
  return element(
    'ul',
    {},
    life.states.map((state) => element('li', {}, `${number(state.hours, 4)} h: ${edges(state)}`)),
  );
}
