// The colours of a map beside their numbers.
import { colourText, kHeightColours } from './colour_map.js';
import { kInk, newId, px, rectangle, rule, scaler, text } from './svg_shapes.js';
import { ticks, tickText } from '../units.js';

const kEdge = `stroke="${kInk}" stroke-width="0.8"`;
/** Length of a pointed end [pixel]. */
const kPoint = 9;

function gradient(id, upright) {
  const stops = kHeightColours
    .filter((_, k) => k % 15 === 0)
    .map(
      (colour, k, all) =>
        `<stop offset="${px((100 * k) / (all.length - 1))}%" stop-color="${colourText(colour)}"/>`,
    );
  return (
    `<linearGradient id="${id}" ` +
    `${upright ? 'x1="0" y1="1" x2="0" y2="0"' : 'x1="0" y1="0" x2="1" y2="0"'}>${stops.join('')}` +
    '</linearGradient>'
  );
}

/** The bar alone; a pointed end where values lie above or below the colours. */
export function colourBar({ left, top, width, height }, upright, { above = false, below = false } = {}) {
  const id = newId('map-colours');
  const [right, low] = [left + width, top + height];
  /** A point beyond the end of the bar at `from`, to the side of `sign`. */
  const point = (from, sign, colour) => {
    const [a, b] = upright ? [left, right] : [top, low];
    const corners = [
      [from, a],
      [from, b],
      [from + sign * kPoint, (a + b) / 2],
    ].map(([along, across]) => (upright ? [across, along] : [along, across]));
    return `<path d="M${corners.map((c) => c.map(px).join(' ')).join('L')}Z" fill="${colourText(colour)}" ${kEdge}/>`;
  };
  return [
    gradient(id, upright),
    rectangle(left, top, width, height, `class="colour-bar" fill="url(#${id})" ${kEdge}`),
    above ? point(upright ? top : right, upright ? -1 : 1, kHeightColours[kHeightColours.length - 1]) : '',
    below ? point(upright ? low : left, upright ? 1 : -1, kHeightColours[0]) : '',
  ];
}

/** Numbers along an upright bar, to its right. */
export function numbersBeside(box, [from, to]) {
  const y = scaler(false, from, to, box.top + box.height, box.top);
  const { values, step } = ticks(from, to, box.height / 40);
  const right = box.left + box.width;
  return values.flatMap((v) => [
    rule(right, y(v), right + 5, y(v), kInk),
    text(right + 8, y(v) + 4, tickText(v, step)),
  ]);
}

/** Numbers under a lying bar. */
export function numbersBelow(box, [from, to]) {
  const x = scaler(false, from, to, box.left, box.left + box.width);
  const { values, step } = ticks(from, to, box.width / 60);
  const low = box.top + box.height;
  return values.flatMap((v) => [
    rule(x(v), low, x(v), low + 4, kInk),
    text(x(v), low + 16, tickText(v, step), { anchor: 'middle' }),
  ]);
}
