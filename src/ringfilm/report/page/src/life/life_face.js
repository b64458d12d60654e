// The face over the running time: the first one, the chosen one, and how they are known.
import { element } from '../dom.js';
import { kOnlyCase } from '../model.js';
import { converted, number } from '../units.js';
import { right, table } from '../tables.js';
import { hoursText, kStateOrigins } from './life_words.js';

const inMicrometres = (values) => converted(values, 'um');

/** Every so many places of a measured face have a dot. */
const kDotsOfAFace = 40;

function measuredSeries(x, measured) {
  const step = Math.max(1, Math.round(x.length / kDotsOfAFace));
  const isDot = (_, i) => i % step === 0;
  return [
    {
      caseIndex: null,
      part: 'measured',
      label: 'measured face',
      x: x.filter(isDot),
      y: inMicrometres(measured.face_height).filter(isDot),
    },
  ];
}

/** The face of reported state k beside the first one; of a face that wears also as it lies on the first one. */
export function faceFigure(life, k) {
  const x = converted(life.x, 'mm');
  const [first, state] = [life.states[0], life.states[k]];
  const label = `${hoursText(state.hours)}, ${state.state_origin}`;
  const measured = (life.measured_faces ?? []).find((face) => face.hours === state.hours);
  const series = [
    {
      caseIndex: null,
      part: 'viscous',
      label: hoursText(first.hours),
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
  if (measured) series.push(...measuredSeries(x, measured));
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
      `The face after ${hoursText(state.hours)} (${kStateOrigins[state.state_origin]}) and at the start (dotted), ` +
      'each counted from its own lowest point. Heights are the gap to a straight liner: where a face wears they grow.' +
      (measured ? ' Dots: the face that was measured after this time.' : ''),
  };
}

/** How far the face of a scenario is from the measured ones; null without any. */
export function distanceTable(life) {
  const compared = life.states.filter((state) => state.measured_face_distance && state.hours > 0);
  if (compared.length === 0) return null;
  const widths = compared[0].measured_face_distance.map((row) => row.half_width);
  return table(
    'Distance from the measured face, rms, offset and tilt free',
    [
      'running time',
      ...widths.map((width) => right(`within ${number(converted(width, 'mm'), 2)} mm of the middle`)),
    ],
    compared.map((state) => [
      hoursText(state.hours),
      ...state.measured_face_distance.map((row) => right(`${number(converted(row.rms, 'um'), 2)} µm`)),
    ]),
    { folds: true },
  );
}

/** Edges of all faces, and their distance from the last measured one where the face wears. */
export function facesOf(life) {
  const edges = (state) =>
    `${number(converted(state.face_height_chamber_edge, 'um'), 3)} µm at the chamber edge, ` +
    `${number(converted(state.face_height_crankcase_edge, 'um'), 3)} µm at the crankcase edge`;
  return element(
    'ul',
    {},
    life.states.map((state) => element('li', {}, `${hoursText(state.hours)}: ${edges(state)}`)),
  );
}
