// The outline of a ring's section from the keys of its case, and its tilt at a crank angle.
import { nearestAngle } from '../units.js';
import { inputOf } from './pack_model.js';

/** How many times its twist a ring is drawn turned. */
export const kTiltFactor = 10;

const kMetres = { m: 1, mm: 1e-3, um: 1e-6 };

/** Corners that a case states: [["0 mm", "0 mm"], ...]. */
function statedCorners(shown) {
  const lengths = [...shown.matchAll(/(-?[\d.eE+-]+) (m|mm|um)\b/g)].map(([, v, unit]) => v * kMetres[unit]);
  return lengths.flatMap((axial, k) => (k % 2 === 0 ? [[axial, lengths[k + 1]]] : []));
}

function corneredForms({ height, thickness, length, side }) {
  const tangent = (key) => Math.tan(length(key) ?? 0);
  const bevel = length('ring.bevel_width');
  const depth = bevel * tangent('ring.bevel_angle');
  const foot = height - length('ring.step_height');
  const taper = tangent('ring.taper_angle');
  const rise = thickness * Math.tan((length('ring.keystone_angle') ?? 0) / (side === 'both' ? 2 : 1));
  const [above, below] = [side !== 'crankcase', side !== 'chamber'];
  return {
    rectangular: () => [
      [0, 0],
      [height, 0],
      [height, thickness],
      [0, thickness],
    ],
    'inner-bevel': () => [
      [0, 0],
      [height, 0],
      ...(below
        ? [
            [height, thickness - bevel],
            [height - depth, thickness],
          ]
        : [[height, thickness]]),
      ...(above
        ? [
            [depth, thickness],
            [0, thickness - bevel],
          ]
        : [[0, thickness]]),
    ],
    napier: () => [
      [0, foot * taper],
      [foot, 0],
      [foot, length('ring.step_depth')],
      [height, length('ring.step_depth')],
      [height, thickness],
      [0, thickness],
    ],
    taper: () => [
      [0, height * taper],
      [height, 0],
      [height, thickness],
      [0, thickness],
    ],
    keystone: () => [
      [0, 0],
      [height, 0],
      [height - (below ? rise : 0), thickness],
      [above ? rise : 0, thickness],
    ],
  };
}

/** Corners of the section, axial from the chamber side and radial from the face inwards [m]; null without a section. */
export function sectionCorners(c) {
  const shown = (key) => c.inputs.find((entry) => entry.key === key)?.shown;
  if (shown('ring.section')) {
    const corners = statedCorners(shown('ring.section'));
    return corners.length > 2 ? corners : null;
  }
  const form = shown('ring.section_form');
  const thickness = inputOf(c, 'ring.radial_thickness');
  const width = inputOf(c, 'ring.face_width');
  if (!form || form === 'none' || !thickness || !width) return null;
  const radians = (key) => inputOf(c, key) * (key.endsWith('_angle') ? Math.PI / 180 : 1);
  const length = (key) => (inputOf(c, key) === null ? null : radians(key));
  const height =
    inputOf(c, 'ring.section_height') ?? width + (form === 'napier' ? length('ring.step_height') : 0);
  const side = shown(form === 'keystone' ? 'ring.keystone_side' : 'ring.bevel_side') ?? 'chamber';
  return corneredForms({ height, thickness, length, side })[form]?.() ?? null;
}

/** Twist of the ring at a crank angle [rad], positive where its face turns towards the chamber; null without one. */
export function twistAt(c, angle) {
  const k = c.curves.twist ? nearestAngle(c.curves.crank_angle, angle) : -1;
  return k >= 0 ? (c.curves.twist[k] ?? null) : null;
}
