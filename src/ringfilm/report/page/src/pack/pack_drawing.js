// Rings, grooves and liner of a pack, drawn from the numbers of the case, with the gas pressures at one crank angle.
import { kFaint, kInk, px, rectangle, rule, text } from '../plot/svg_shapes.js';
import { caseColour } from '../plot/palette.js';
import { converted, number } from '../units.js';
import { inputOf, regionWords } from './pack_model.js';
import { kTiltFactor, sectionCorners, twistAt } from './ring_outline.js';

export const kPackWidth = 470;
const kMargin = { top: 54, bottom: 34 };
/** Height of the pack from the first groove to below the last ring [pixel]. */
const kPackHeight = 330;
const kLiner = 300;
/** Room of the rings beside the liner [pixel]. */
const kDepth = 190;
/** Height of a side clearance, which is far smaller than the ring [pixel]. */
const kClearance = 9;
/** Gap between piston and liner: not to scale [pixel]. */
const kLandGap = 16;

const kPiston = '#c9ced6';
const kWall = '#dfe2e7';
/** From the lowest pressure to the highest. */
const kLow = [219, 232, 244];
const kHigh = [226, 120, 74];

const bar = (p) => `${number(converted(p, 'bar'), 3)}\u00a0bar`;

const box = (x, y, width, height, fill, stroke = 'none') =>
  rectangle(x, y, width, height, `fill="${fill}" stroke="${stroke}"`);

/** Colour of a pressure between the extremes of the cycle, by its logarithm. */
function gasColour(p, [low, high]) {
  const share = high > low ? Math.log(p / low) / Math.log(high / low) : 0;
  const at = Math.min(1, Math.max(0, share));
  return `rgb(${kLow.map((v, i) => Math.round(v + at * (kHigh[i] - v))).join(',')})`;
}

/** Heights of rings and piston lands from the top edge of the first ring [m]. */
export function heights(packed) {
  const { cases, pack } = packed;
  let top = 0;
  return cases.map((c, i) => {
    const corners = sectionCorners(c);
    const width = corners ? extent(corners, 0) : (inputOf(c, 'ring.face_width') ?? 1e-3);
    const isRailAbove = pack.ring_numbers[i] === pack.ring_numbers[i + 1];
    const rail = isRailAbove ? (inputOf(c, 'ring.land_below') ?? width) : null;
    const land = rail ?? inputOf(c, 'ring.land_below') ?? width;
    const ring = { top, width, land, isRailAbove };
    top += width + land;
    return ring;
  });
}

/** Extremes of all pressures of the cycle [Pa]. */
function extremes(packed) {
  const all = packed.regions.flatMap((region) => region.pressure).filter((p) => p > 0);
  return [Math.min(...all), Math.max(...all)];
}

/** The pressure of the region of that name at an angle; null where there is no such region. */
function pressureOf(packed, name, angle) {
  const region = packed.regions.find((one) => one.name === name);
  return region ? packed.pressureAt(region, angle) : null;
}

/** Regions above, in the groove and below each ring [Pa]. */
export function pressuresAt(packed, angle) {
  let above = pressureOf(packed, 'chamber', angle);
  return packed.cases.map((c, i) => {
    const below = packed.pressureAt(packed.regionBelow(i), angle);
    const isOil = c.inputs.some((entry) => entry.key === 'ring.kind' && entry.shown === 'oil');
    const groove = pressureOf(packed, `groove ${i + 1}`, angle) ?? (isOil ? below : above);
    const ring = { above, groove, below };
    above = below;
    return ring;
  });
}

/** Axial (0) or radial (1) extent of a section [m]. */
function extent(corners, k) {
  const list = corners.map((corner) => corner[k]);
  return Math.max(...list) - Math.min(...list);
}

/** A section in a rectangle, turned about its middle. */
function outline(corners, { x, y, width, height }, tilt, stroke) {
  const [tall, thick] = [0, 1].map((k) => extent(corners, k));
  const [first, front] = [0, 1].map((k) => Math.min(...corners.map((corner) => corner[k])));
  const [xc, yc] = [x - width / 2, y + height / 2];
  const points = corners.map(([axial, radial]) => {
    const [px0, py0] = [x - (width * (radial - front)) / thick, y + (height * (axial - first)) / tall];
    return [px0 + tilt * (py0 - yc), py0 - tilt * (px0 - xc)];
  });
  const path = points.map(([px0, py0], k) => `${k ? 'L' : 'M'}${px(px0)} ${px(py0)}`).join('');
  return `<path d="${path}Z" fill="#f4f6f8" stroke="${stroke}" stroke-width="1.6"/>`;
}

function ringShapes(packed, i, at, scale, colour) {
  const c = packed.cases[i];
  const { top, width, isRailAbove } = at.heights[i];
  const y = kMargin.top + scale * top;
  const height = Math.max(6, scale * width);
  const clearance = inputOf(c, 'ring.side_clearance');
  const position = packed.positionAt(i, at.angle);
  const lift = clearance && position !== null ? kClearance * Math.min(1, position / clearance) : 0;
  const thickness = inputOf(c, 'ring.radial_thickness');
  const depth = thickness ? Math.min(kDepth, 2 * scale * thickness) : 0.45 * kDepth;
  const { groove } = at.pressures[i];
  const stroke = caseColour(packed.cases[i].series);
  const isRail = packed.pack.ring_numbers.filter((n) => n === packed.pack.ring_numbers[i]).length > 1;
  const room = isRailAbove ? scale * at.heights[i].land : 0;
  const corners = isRail ? null : sectionCorners(c);
  const tilt = kTiltFactor * (corners ? (twistAt(c, at.angle) ?? 0) : 0);
  const ring = corners
    ? [outline(corners, { x: kLiner, y: y - lift, width: depth, height }, tilt, stroke)]
    : [
        box(
          kLiner - (isRail ? 0.6 * kDepth : depth),
          y - lift,
          isRail ? 0.6 * kDepth : depth,
          height,
          '#f4f6f8',
          stroke,
        ),
        box(kLiner - 3, y - lift, 3, height, stroke),
      ];
  return [
    box(
      kLiner - kLandGap - kDepth - 18,
      y - kClearance,
      kDepth + 18,
      height + kClearance + room,
      colour(groove),
    ),
    box(kLiner - kLandGap, y, kLandGap, height, colour(at.pressures[i].below)),
    ...ring,
  ];
}

function labels(packed, at, scale) {
  const out = [];
  let last = -Infinity;
  const label = (words, y) => {
    const place = Math.max(y, last + 14);
    last = place;
    out.push(
      rule(kLiner - 6, y - 4, kLiner + 14, place - 4, kFaint, 0.7),
      text(kLiner + 18, place, words, { size: 11 }),
    );
  };
  label(`cylinder ${bar(at.pressures[0].above)}`, 24);
  packed.cases.forEach((c, i) => {
    const { top, width, land } = at.heights[i];
    const y = kMargin.top + scale * top;
    const { groove, below } = at.pressures[i];
    const n = packed.pack.ring_numbers[i];
    const isRail = packed.pack.ring_numbers.filter((one) => one === n).length > 1;
    label(
      isRail
        ? `ring ${n}, rail${at.heights[i].isRailAbove ? '' : ', drained groove'}`
        : `ring ${n}, groove ${bar(groove)}`,
      y + (scale * width) / 2 + 4,
    );
    if (at.heights[i].isRailAbove) return;
    label(`${regionWords(packed.regionBelow(i).name)} ${bar(below)}`, y + scale * (width + land / 2) + 4);
  });
  return out;
}

/** The pack at a crank angle. */
export function packDrawing(packed, angle) {
  const list = heights(packed);
  const last = list[list.length - 1];
  const scale = kPackHeight / (last.top + last.width + last.land);
  const at = { angle, heights: list, pressures: pressuresAt(packed, angle) };
  const range = extremes(packed);
  const colour = (p) => (p === null ? '#fff' : gasColour(p, range));
  const height = kMargin.top + kPackHeight + kMargin.bottom;
  const gap = (from, to, p) => box(kLiner - kLandGap, from, kLandGap, to - from, colour(p));
  const lands = list.map(({ top, width, land }, i) => {
    const from = kMargin.top + scale * (top + width);
    return gap(from, i + 1 === list.length ? height : from + scale * land, at.pressures[i].below);
  });
  const shapes = [
    box(0, 0, kLiner, height, colour(at.pressures[0].above)),
    box(0, 34, kLiner - kLandGap, height - 34, kPiston),
    gap(0, kMargin.top, at.pressures[0].above),
    ...lands,
    ...packed.cases.flatMap((c, i) => ringShapes(packed, i, at, scale, colour)),
    box(kLiner, 0, 12, height, kWall),
    rule(kLiner, 0, kLiner, height, kInk, 1.4),
    text(8, 52, 'piston', { fill: kFaint, size: 11 }),
    text(8, 22, 'combustion chamber', { fill: kInk, size: 11 }),
    text(kLiner + 18, height - 8, 'liner', { fill: kFaint, size: 11 }),
    ...labels(packed, at, scale),
  ];
  return { shapes, height };
}
