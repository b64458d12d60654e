// Maps over two factors of a grid, and curves where only one factor is a number.
import { element } from '../dom.js';
import { colourText, heightColour } from '../plot/colour_map.js';
import { contourLines, filledBands, labelPlace } from '../plot/contour.js';
import { kOnlyCase } from '../model.js';
import { airy, frame } from '../plot/plot_frame.js';
import { axisTitle, extent } from '../plot/scales.js';
import { shortWithUnit } from './study_model.js';
import { hatching, kFaint, kInk, kLetter, line, px, rectangle, rule, text } from '../plot/svg_shapes.js';
import { number, ticks, tickText, withUnit } from '../units.js';

const kLevels = 13;
/** Place among the colours of a map that has one only. */
const kFlat = 0.6;

/** Share of a value within which it may be off: as estimated on the sample of the study, else as a study asks for. */
export function relativeError(model, name) {
  return model.error?.quantiles?.[name] ?? model.usual_accuracy;
}

/** The values of one base of a grid, by the places of its levels. */
export class GridValues {
  constructor(model, base) {
    this.model = model;
    this.axes = model.grid.bases[base].axes.map((axis) => ({ ...axis, factor: model.factors[axis.factor] }));
    this.values = model.grid.bases[base].values;
    let stride = 1;
    for (let k = this.axes.length; k-- > 0;) {
      this.axes[k].stride = stride;
      stride *= this.axes[k].levels.length;
    }
  }
  /** Axes over numbers, of more than one level. */
  numeric() {
    return this.axes.filter((axis) => axis.factor.choices.length === 0 && axis.levels.length > 1);
  }
  at(name, places) {
    return this.values[name][places.reduce((sum, place, k) => sum + place * this.axes[k].stride, 0)];
  }
}

/** What is mapped: base, the two axes (places among the factors of the grid) and the levels of the others. */
export class MapChoice {
  constructor(model) {
    this.model = model;
    this.setBase(0);
  }
  setBase(base) {
    this.base = base;
    this.grid = new GridValues(this.model, base);
    const numeric = this.grid.numeric().map((axis) => this.grid.axes.indexOf(axis));
    if (!numeric.includes(this.across) || !numeric.includes(this.up)) [this.across, this.up] = numeric;
    this.places = this.grid.axes.map((axis, k) =>
      Math.min(this.places?.[k] ?? Math.floor((axis.levels.length - 1) / 2), axis.levels.length - 1),
    );
  }
  /** What stays the same in the map, in words. @param compared place of the axis that is compared; none if omitted */
  words(compared) {
    const fixed = this.grid.axes
      .map((axis, k) =>
        k === this.across || k === this.up || k === compared
          ? null
          : `${axis.factor.name} ${this.model.levelText(axis.factor, axis.levels[this.places[k]])}`,
      )
      .filter(Boolean);
    return [...(this.model.several ? [this.model.bases[this.base].name] : []), ...fixed].join(', ');
  }
}

function axisOf(axis) {
  const levels = axis.levels.map(axis.factor.convert);
  const log = axis.factor.logarithmic && levels.every((v) => v > 0);
  return {
    levels,
    log,
    low: Math.min(...levels),
    high: Math.max(...levels),
    label: axis.factor.name,
    unit: axis.factor.shown,
    of: axis.of,
  };
}

/** The two axes of the map: across and up. */
export function mapAxes(choice) {
  return [axisOf(choice.grid.axes[choice.across]), axisOf(choice.grid.axes[choice.up])];
}

/** Scales and frame of the map at a width in pixels. */
export function mapGeometry(choice, width) {
  const [across, up] = mapAxes(choice);
  const height = Math.min(420, Math.max(290, 0.72 * width));
  return {
    across,
    up,
    height,
    ...frame({ x: 0, y: 0, width, height }, across, up, { right: 22, bottom: 46 }),
  };
}

export function mapFigure(model, q, choice) {
  const value = (i, j) => {
    const places = [...choice.places];
    [places[choice.across], places[choice.up]] = [i, j];
    const v = choice.grid.at(q.name, places);
    return v === null ? null : q.convert(v);
  };
  // One scale of colours for all slices and bases: what is moved with a choice can then be seen.
  const whole = extent(model.grid.bases.flatMap((b) => b.values[q.name].map(q.convert))) ?? [0, 1];
  const size = whole[1] - whole[0];
  const error = relativeError(model, q.name) * Math.max(...whole.map(Math.abs));
  // Steps of colour that are finer than the numerical error would draw noise as structure.
  const steps = Math.min(kLevels, Math.floor(size / error));
  const isFlat = !(steps >= 1);
  const { values: all, step } = isFlat ? { values: [], step: 1 } : ticks(...whole, steps);
  const levels = all.filter((v) => v > whole[0] && v < whole[1]);
  const colour = (band) =>
    colourText(heightColour(levels.length ? 0.04 + (0.96 * band) / levels.length : kFlat));
  const axes = () => mapAxes(choice);
  const geometry = (width) => mapGeometry(choice, width);
  const unsolved = () =>
    axes()[0]
      .levels.flatMap((_, i) => axes()[1].levels.map((__, j) => [i, j]))
      .filter(([i, j]) => value(i, j) === null);
  return {
    id: `map-${q.name.replace(/_/g, '-')}`,
    title: axisTitle(q.short_name, q.shown),
    half: true,
    draw(width) {
      const { across, up, height, plot, x, y, shapes, edges } = geometry(width);
      const [xs, ys] = [across.levels.map(x), up.levels.map(y)];
      const [wide, tall] = [plot.right - plot.left, plot.bottom - plot.top];
      const { id, pattern } = hatching(8, 2, kFaint);
      const out = [
        pattern,
        ...shapes,
        rectangle(plot.left, plot.top, wide, tall, `class="unsolved" fill="url(#${id})"`),
      ];
      filledBands(xs, ys, value, levels).forEach((polygons, band) => {
        if (polygons.length === 0) return;
        const path = polygons
          .map((p) => `M${p.map((c) => `${c.x.toFixed(1)} ${c.y.toFixed(1)}`).join('L')}Z`)
          .join('');
        // The thin edge closes the seams between neighbours.
        out.push(
          `<path class="band" d="${path}" fill="${colour(band)}" stroke="${colour(band)}" ` +
            'stroke-width="0.7"/>',
        );
      });
      const labels = [];
      for (const level of levels) {
        const label = tickText(level, step);
        for (const points of contourLines(xs, ys, value, level)) {
          out.push(line(points, '#fff', { width: 2.4 }), line(points, '#000', { width: 1.1 }));
          const place = labelPlace(points, kLetter * label.length + 8);
          const half = (kLetter * label.length) / 2 + 2;
          if (
            place &&
            place.x - half > plot.left &&
            place.x + half < plot.right &&
            place.y > plot.top + 10 &&
            place.y < plot.bottom - 6 &&
            labels.every((p) => Math.hypot(p.x - place.x, p.y - place.y) > 26)
          ) {
            labels.push(place);
            out.push(
              `<g transform="rotate(${px(place.angle)} ${px(place.x)} ` +
                `${px(place.y)})">` +
                text(place.x, place.y + 4, label, {
                  anchor: 'middle',
                  size: 11.5,
                  weight: 600,
                  fill: '#000',
                  halo: '#fff',
                }) +
                '</g>',
            );
          }
        }
      }
      for (const [i, j] of unsolved())
        out.push(
          text(
            Math.min(plot.right - 7, Math.max(plot.left + 7, xs[i])),
            Math.min(plot.bottom - 5, Math.max(plot.top + 12, ys[j] + 4)),
            '×',
            { anchor: 'middle', weight: 600, halo: '#fff' },
          ),
        );
      const right = [
        rule(plot.right, plot.top, plot.right, plot.bottom, kInk),
        rule(plot.left, plot.top, plot.right, plot.top, kInk),
      ];
      // In the picture its first line names the axis that goes up; the value is at the bar of colours.
      const barTop = height + 4;
      const [from, to] = [plot.left, plot.right];
      const w = (to - from) / (levels.length + 1);
      const most = Math.ceil((levels.length * 52) / Math.max(1, to - from));
      const bar = Array.from({ length: levels.length + 1 }, (_, k) =>
        rectangle(from + k * w, barTop, w, 12, `fill="${colour(k)}" stroke="${kInk}" stroke-width="0.6"`),
      );
      levels.forEach((level, k) => {
        if (k % most === 0)
          bar.push(
            text(from + (k + 1) * w, barTop + 26, tickText(level, step), { anchor: 'middle', size: 11 }),
          );
      });
      return { shapes: [...out, ...edges, ...right, ...bar], height: barTop + 34 };
    },
    caption() {
      const here = axes()[0]
        .levels.flatMap((_, i) => axes()[1].levels.map((__, j) => ({ i, j, v: value(i, j) })))
        .filter(({ v }) => v !== null);
      const spot = ({ i, j, v }) =>
        `${withUnit(v, q.shown, 3)} at ${axes()
          .map((axis, k) => `${axis.label} ${shortWithUnit(axis.levels[k ? j : i], axis.unit)}`)
          .join(', ')}`;
      const lowest = here.reduce((a, b) => (b.v < a.v ? b : a), here[0]);
      const highest = here.reduce((a, b) => (b.v > a.v ? b : a), here[0]);
      const hidden = choice.grid.axes.filter((axis) => axis.levels.length < axis.of);
      const n = unsolved().length;
      return [
        `${q.short_name[0].toUpperCase()}${q.short_name.slice(1)}` +
          `${choice.words() ? `: ${choice.words()}` : ''}; ${axes()[0].levels.length} × ` +
          `${axes()[1].levels.length} scenarios, straight between them.`,
        here.length
          ? `Lowest ${spot(lowest)}; highest ${spot(highest)}.`
          : 'None of these scenarios was solved.',
        levels.length
          ? 'The steps of colour are the same for all choices.'
          : `One step of colour: the value hardly varies, by ${number(size, 2)}${q.shown ? ` ${q.shown}` : ''}, ` +
            `${isFlat ? 'less than' : 'about'} its numerical error of ` +
            `${number(100 * relativeError(model, q.name), 2)} %.`,
        n
          ? `Hatched: next to the ${n === 1 ? 'scenario' : `${n} scenarios`} (×) that ` +
            `${n === 1 ? 'was' : 'were'} not solved.`
          : '',
        hidden.length
          ? 'This page carries ' +
            hidden
              .map((axis) => `${axis.levels.length} of ${axis.of} levels of ${axis.factor.name}`)
              .join(', ') +
            '; the result file has all.'
          : '',
      ]
        .filter(Boolean)
        .join(' ');
    },
    columns() {
      const points = axes()[1].levels.flatMap((v, j) => axes()[0].levels.map((u, i) => [u, v, value(i, j)]));
      return [
        axisTitle(axes()[0].label, axes()[0].unit),
        axisTitle(axes()[1].label, axes()[1].unit),
        axisTitle(q.long_name, q.shown),
      ].map((title, k) => ({ title, values: points.map((p) => p[k]) }));
    },
    at(pointX, pointY, width) {
      const { across, up, x, y } = geometry(width);
      const inCell = (pixels, p) => {
        for (let k = 0; k + 1 < pixels.length; k++) {
          const t = (p - pixels[k]) / (pixels[k + 1] - pixels[k]);
          if (t >= 0 && t <= 1) return [k, t];
        }
        return null;
      };
      const [a, b] = [inCell(across.levels.map(x), pointX), inCell(up.levels.map(y), pointY)];
      if (!a || !b) return null;
      const corners = [
        [0, 0, (1 - a[1]) * (1 - b[1])],
        [1, 0, a[1] * (1 - b[1])],
        [0, 1, (1 - a[1]) * b[1]],
        [1, 1, a[1] * b[1]],
      ].map(([i, j, weight]) => [value(a[0] + i, b[0] + j), weight]);
      const between = (axis, [k, t]) =>
        withUnit(
          axis.log
            ? axis.levels[k] ** (1 - t) * axis.levels[k + 1] ** t
            : axis.levels[k] + t * (axis.levels[k + 1] - axis.levels[k]),
          axis.unit,
          4,
        );
      const found = corners.every(([v]) => v !== null)
        ? withUnit(
            corners.reduce((sum, [v, weight]) => sum + v * weight, 0),
            q.shown,
            4,
          )
        : 'not solved';
      const place = `${across.label} ${between(across, a)}, ${up.label} ${between(up, b)}`;
      return [`${place}: `, element('b', {}, found)];
    },
  };
}

/** As many as there are colours, and ways to draw a line. */
const kMostCurves = 8;
const kBaseDashes = ['', '8 4', '2 3', '10 3 2 3'];

/**
 * Where one factor alone is a number: a curve for each base and choice. With several of both a colour for
 * each choice and a dash for each base.
 */
export function gridCurvesFigure(model, q) {
  const curves = [];
  model.grid.bases.forEach((_, b) => {
    const grid = new GridValues(model, b);
    const [axis] = grid.numeric();
    if (!axis) return;
    const at = grid.axes.indexOf(axis);
    let combinations = [grid.axes.map(() => 0)];
    grid.axes.forEach((other, k) => {
      if (k !== at)
        combinations = combinations.flatMap((places) =>
          other.levels.map((__, i) => places.map((p, n) => (n === k ? i : p))),
        );
    });
    combinations.forEach((places, combination) => {
      const label = [
        ...(model.several ? [model.bases[b].name] : []),
        ...grid.axes
          .map((other, k) =>
            k === at || other.levels.length < 2
              ? null
              : model.levelText(other.factor, other.levels[places[k]]),
          )
          .filter(Boolean),
      ].join(', ');
      curves.push({
        base: b,
        combination,
        label: label || model.bases[b].name,
        axis: axisOf(axis),
        values: axis.levels.map((__, i) => {
          const v = grid.at(
            q.name,
            places.map((p, k) => (k === at ? i : p)),
          );
          return v === null ? null : q.convert(v);
        }),
      });
    });
  });
  if (curves.length === 0) return null;
  const isCrossed =
    model.several && model.bases.length <= kBaseDashes.length && curves.some((c) => c.combination > 0);
  const shown = (
    isCrossed ? curves.filter((c) => c.combination < kMostCurves) : curves.slice(0, kMostCurves)
  ).map((c, i) => ({
    ...c,
    look: isCrossed ? c.combination : i,
    dash: isCrossed ? kBaseDashes[c.base] : '',
  }));
  const { axis } = shown[0];
  const ends = extent(shown.flatMap((c) => c.values)) ?? [null, null];
  const isAlone = shown.length === 1;
  const across = airy(axis.levels, { log: axis.log });
  return {
    id: `map-${q.name.replace(/_/g, '-')}`,
    title: axisTitle(q.short_name, q.shown),
    panels: [
      {
        id: q.name,
        xScale: axis.log ? 'log' : 'linear',
        xRange: [across.low, across.high],
        xLabel: axis.label,
        xUnit: axis.unit,
        yLabel: q.short_name,
        yUnit: q.shown,
        fromZero: true,
        series: shown.map((c) => ({
          caseIndex: isAlone ? kOnlyCase : c.look,
          label: c.label,
          dash: c.dash,
          isSampled: true,
          x: c.axis.levels,
          y: c.values,
        })),
      },
    ],
    caption:
      `${q.short_name[0].toUpperCase()}${q.short_name.slice(1)} against ${axis.label}, ` +
      `${isAlone ? 'one curve' : `${shown.length} curves`}: ` +
      `${ends.map((v) => withUnit(v, q.shown, 3)).join(' to ')}.` +
      (curves.length > shown.length
        ? ` The first ${shown.length} of ${curves.length} curves; the result file has all.`
        : '') +
      (axis.levels.length < axis.of
        ? ` This page carries ${axis.levels.length} of ${axis.of} levels; the result file has all.`
        : '') +
      (shown.some((c) => c.values.includes(null)) ? ' Gaps: not solved.' : ''),
  };
}
