// Which of several choices, such as oils, has the lowest value at each place of a map.
import { caseColour } from '../plot/palette.js';
import { lowestRegions } from '../plot/contour.js';
import { axisTitle } from '../plot/scales.js';
import { hatching, kFaint, kInk, legend, px, rectangle, rule } from '../plot/svg_shapes.js';
import { number } from '../units.js';
import { mapAxes, mapGeometry, relativeError } from './study_map.js';

/** Share of a case's colour in that of its region, the rest is white. */
const kTint = 0.55;

/** Place of the axis whose choices are compared: the first of several choices; -1 where there is none. */
export function comparedAxis(choice) {
  return choice.grid.axes.findIndex((axis) => axis.factor.choices.length > 0 && axis.levels.length > 1);
}

/** The map of the choice with the lowest value of a quantity; null where no choices are compared. */
export function lowestFigure(model, q, choice) {
  if (comparedAxis(choice) < 0) return null;
  const factor = () => choice.grid.axes[comparedAxis(choice)].factor;
  const names = () => {
    const axis = choice.grid.axes[comparedAxis(choice)];
    return axis.levels.map((level) => model.levelText(axis.factor, level));
  };
  const value = (k, i, j) => {
    const places = [...choice.places];
    [places[choice.across], places[choice.up], places[comparedAxis(choice)]] = [i, j, k];
    return choice.grid.at(q.name, places);
  };
  /** Value of a choice over the lowest of the others, less one; null where one of them was not solved. */
  const excess = (k) => (i, j) => {
    const all = names().map((_, n) => value(n, i, j));
    if (all.includes(null)) return null;
    return all[k] / Math.min(...all.filter((_, n) => n !== k)) - 1;
  };
  const scenarios = () =>
    mapAxes(choice)[0].levels.flatMap((_, i) => mapAxes(choice)[1].levels.map((__, j) => [i, j]));
  // Opaque, so that neither the hatching nor a seam is seen through it.
  const tint = (k) =>
    `#${[1, 3, 5]
      .map((n) => 255 - kTint * (255 - parseInt(caseColour(k).slice(n, n + 2), 16)))
      .map((v) => Math.round(v).toString(16).padStart(2, '0'))
      .join('')}`;
  return {
    id: `lowest-${q.name.replace(/_/g, '-')}`,
    title: `${factor().name} with the lowest ${q.short_name}`,
    half: true,
    draw(width) {
      const { across, up, height, plot, x, y, shapes, edges } = mapGeometry(choice, width);
      const [xs, ys] = [across.levels.map(x), up.levels.map(y)];
      const { id, pattern } = hatching(8, 2, kFaint);
      const [wide, tall] = [plot.right - plot.left, plot.bottom - plot.top];
      const out = [
        pattern,
        ...shapes,
        rectangle(plot.left, plot.top, wide, tall, `class="unsolved" fill="url(#${id})"`),
      ];
      const at = (p) => `${px(p.x)} ${px(p.y)}`;
      const { regions, borders } = lowestRegions(
        xs,
        ys,
        names().map((_, k) => (i, j) => value(k, i, j)),
      );
      regions.forEach((polygons, k) => {
        if (polygons.length === 0) return;
        const path = polygons.map((polygon) => `M${polygon.map(at).join('L')}Z`).join('');
        // The thin edge closes the seams between neighbours.
        out.push(
          `<path class="lowest" d="${path}" fill="${tint(k)}" stroke="${tint(k)}" stroke-width="0.7"/>`,
        );
      });
      const border = borders.map(([a, b]) => `M${at(a)}L${at(b)}`).join('');
      out.push(
        `<path class="border" d="${border}" stroke="#000" stroke-width="1.4" stroke-linecap="round"/>`,
      );
      const right = [
        rule(plot.right, plot.top, plot.right, plot.bottom, kInk),
        rule(plot.left, plot.top, plot.right, plot.top, kInk),
      ];
      const entries = names().map((label, k) => ({
        label,
        swatch: (left, middle) =>
          rectangle(left, middle - 5, 28, 10, `fill="${tint(k)}" stroke="${kInk}" stroke-width="0.6"`),
      }));
      const below = legend(entries, width, height + 2);
      return { shapes: [...out, ...edges, ...right, ...below.shapes], height: height + 2 + below.height };
    },
    caption() {
      const solved = scenarios().filter(([i, j]) => excess(0)(i, j) !== null);
      const error = relativeError(model, q.name);
      const parts = names().map((name, k) => {
        const won = solved.map(([i, j]) => -excess(k)(i, j)).filter((lead) => lead > 0);
        return won.length
          ? `${name} at ${won.length} of ${solved.length}, by up to ${number(100 * Math.max(...won), 2)} %`
          : `${name} at none`;
      });
      const close = solved.filter(([i, j]) => names().some((_, k) => Math.abs(excess(k)(i, j)) < error));
      const varied = choice.words(comparedAxis(choice));
      return [
        `${factor().name[0].toUpperCase()}${factor().name.slice(1)} with the lowest ${q.short_name}` +
          `${varied ? `: ${varied}` : ''}; lines where it changes, straight between the scenarios.`,
        solved.length ? `${parts.join('; ')}.` : 'No scenario was solved with each of them.',
        `Nothing but ${[mapAxes(choice)[0].label, mapAxes(choice)[1].label, factor().name].join(', ')} varies.`,
        close.length
          ? `At ${close.length} of ${solved.length} scenarios the two lowest differ by less than their numerical ` +
            `error of ${number(100 * error, 2)} %.`
          : '',
      ]
        .filter(Boolean)
        .join(' ');
    },
    columns() {
      const [across, up] = mapAxes(choice);
      const at = up.levels.flatMap((v, j) => across.levels.map((u, i) => ({ u, v, i, j })));
      return [
        { title: axisTitle(across.label, across.unit), values: at.map((p) => p.u) },
        { title: axisTitle(up.label, up.unit), values: at.map((p) => p.v) },
        ...names().map((name, k) => ({
          title: axisTitle(`${q.long_name}, ${name}`, q.shown),
          values: at.map((p) => q.convert(value(k, p.i, p.j))),
        })),
      ];
    },
  };
}
