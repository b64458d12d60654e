// The film around the ring on the page: case, view, colours and crank angle as the reader picks them.
import {
  fieldCaption,
  fieldColumns,
  fieldMaps,
  stripCaption,
  stripColumns,
  stripMaps,
} from './around_figures.js';
import { element } from '../dom.js';
import { AngleSlider, buttons } from '../figure/choices.js';
import { DrawingView } from '../figure/drawing_view.js';
import { angle, number, withUnit, wrapped } from '../units.js';

/** @param cases those with an unrolled film: { name, data, peakAngle, face } */
export function aroundView(model, cases, context) {
  const chosen = { case: cases[0], ends: false, own: false };
  const pick = (key, label, options) =>
    buttons(label, options, chosen[key], (value) => {
      chosen[key] = value;
      view.redraw();
    });
  const ownChoice = pick('own', 'Colours', [
    ['Colours of all angles', false],
    ['Of this angle', true],
  ]);
  const viewChoice = pick('ends', 'Part of the ring', [
    ['Whole ring', false],
    ['Ends of the gap', true],
  ]);
  const caseChoice =
    cases.length > 1
      ? buttons(
          'Case',
          cases.map((one) => [one.name, one]),
          chosen.case,
          (one) => showCase(one),
        )
      : null;
  const slider = new AngleSlider({
    id: 'around-angle',
    spoken: 'crank angle of the maps around the ring',
    angles: chosen.case.data.angles,
    at: chosen.case.peakAngle,
    show: () => view.redraw(),
  });
  const prepare = () => {
    const { data } = chosen.case;
    slider.node.hidden = ownChoice.hidden = !data.hasFields;
    viewChoice.hidden = data.closed;
    if (data.closed) chosen.ends = false;
  };
  const showCase = (one) => {
    chosen.case = one;
    prepare();
    slider.setAngles(one.data.angles, one.peakAngle);
    view.redraw();
  };
  const maps = () => {
    const { data, face } = chosen.case;
    return data.hasFields ? fieldMaps(data, slider.k, chosen) : stripMaps(data, { ends: chosen.ends, face });
  };
  let shown = null;
  let canvases = [];
  const figure = {
    id: 'around-the-ring',
    named: 'Around the ring',
    host: 'map maps',
    get title() {
      return (shown ??= maps()).title;
    },
    get spoken() {
      return `${shown.title}: ${shown.spoken()}`;
    },
    caption() {
      const { data, name } = chosen.case;
      const caseName = cases.length > 1 || model.several ? name : '';
      return data.hasFields ? fieldCaption(data, caseName) : stripCaption(data, caseName);
    },
    draw: (width, isFile) => shown.draw(width, isFile),
    /** The fields themselves: pixels, which a drawing would take too long to make while the slider moves. */
    under(width) {
      shown = maps();
      const { plots } = shown.layout(width);
      canvases = shown.maps.map((map, n) =>
        shown.canvas(map, plots[n], Math.min(2, devicePixelRatio || 1), canvases[n]),
      );
      canvases.forEach((canvas, n) => {
        const { left, top, width: w, height } = plots[n];
        canvas.style.cssText = `left:${left}px;top:${top}px;width:${w}px;height:${height}px`;
      });
      return canvases;
    },
    at(x, y, width) {
      const found = shown.at(x, y, width);
      return found && valuesAt(chosen.case.data, slider.k, found);
    },
    columns: () => {
      const { data } = chosen.case;
      return data.hasFields ? fieldColumns(data, slider.k) : stripColumns(data);
    },
  };
  prepare();
  const choices = element('div', { class: 'choices' }, caseChoice, viewChoice, ownChoice);
  const view = new DrawingView(figure, context, [slider.node, choices]);
  return view;
}

/** What lies at a place of the maps: the place and all values of its node. */
function valuesAt(data, k, { column, row, atRow, atColumn }) {
  const atRing = data.hasFields ? atColumn : atRow;
  const j = data.hasFields ? column : row;
  if (j < 0) return ['in the gap of the ring'];
  const y = data.y[j];
  const place = `y ${withUnit(y, 'mm', 4)} (${angle(data.around(y))}° around the bore)`;
  const nameAndValue = (name, value) => [`${name} `, element('b', {}, value)];
  if (!data.hasFields) {
    if (column < 0) return [];
    return [
      `at ${angle(wrapped(data.stripAngles[column]))}°, ${place}: `,
      ...Object.entries(data.strips)
        .slice(0, 4)
        .flatMap(([name, { unit, longName }], n) => [
          n ? ', ' : '',
          ...nameAndValue(longName.split(',')[0], withUnit(data.stripValue(name, column, j), unit, 3)),
        ]),
    ];
  }
  if (row < 0 || atRing === null) return [];
  const { fields } = data;
  const value = (name) => data.value(name, k, j, row);
  return [
    `x ${withUnit(data.x[row], 'mm', 3)}, ${place}: `,
    ...nameAndValue('p', withUnit(value('film_pressure'), fields.film_pressure.unit, 4)),
    ...(fields.film_content ? [', ', ...nameAndValue('θ', number(value('film_content'), 3))] : []),
    ...(fields.film_thickness
      ? [', ', ...nameAndValue('h', withUnit(value('film_thickness'), fields.film_thickness.unit, 3))]
      : []),
  ];
}
