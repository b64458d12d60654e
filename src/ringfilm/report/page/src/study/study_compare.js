// Bases and choices side by side.
import { caseColour } from '../plot/palette.js';
import { airy, frame } from '../plot/plot_frame.js';
import { axisTitle } from '../plot/scales.js';
import { panelGrid } from './study_spread.js';
import { fitted, mark, rule, text, titled } from '../plot/svg_shapes.js';
import { percent, withUnit } from '../units.js';

const kRow = 22;

/** Median of a group, of operating points their weighted mean; null where a point was not solved. */
export function middleOf(model, s) {
  if (model.has_sample) return s.quantiles[2][0];
  return 'weighted_mean' in s ? s.weighted_mean : s.median;
}

/** What the middle of the groups is. */
export function middleWord(model) {
  const first = model.mainValues.flatMap((q) => model.comparison[q.name] ?? []).find(Boolean);
  return first && 'weighted_mean' in first ? 'weighted mean' : 'median';
}

/** Middle, inner and outer ends of a group, in the unit that people read; null without a value. */
function spread(model, q, s) {
  if (!s) return null;
  if (!model.has_sample)
    return {
      middle: q.convert(middleOf(model, s)),
      outer: [s.lowest, s.highest].map(q.convert),
      inner: null,
      n: s.n,
    };
  const [low, lower, middle, upper, high] = s.quantiles.map(([v]) => q.convert(v));
  return { middle, outer: [low, high], inner: [lower, upper], n: s.n };
}

export function comparisonFigure(model) {
  const groups = model.comparison_groups;
  const shown = model.mainValues.filter((q) => model.comparison[q.name]);
  if (groups.length < 2 || shown.length === 0) return null;
  // One colour for each base; where there is but one, for each group.
  const colourOf = (g) => (model.several ? groups[g].base : g);
  const kHeight = 26 + 46 + kRow * groups.length;
  const longest = Math.max(...groups.map((g) => g.name.length));
  const panel = (q, box) => {
    const all = model.comparison[q.name].map((s) => spread(model, q, s));
    const room = Math.min(Math.max(90, 7.2 * longest + 10), 0.55 * box.width);
    const range = airy(all.flatMap((s) => (s ? [s.middle, ...s.outer] : [])));
    const { plot, x, shapes, edges } = frame(
      box,
      range,
      { low: 0, high: 1, bare: true, label: q.short_name, unit: q.shown },
      { left: room, bottom: 30 },
    );
    const out = [...shapes];
    all.forEach((s, g) => {
      const at = plot.top + ((plot.bottom - plot.top) * (g + 0.5)) / groups.length;
      const name = fitted(groups[g].name, room - 14, 7);
      out.push(`<g>${text(plot.left - 8, at + 4, name, { anchor: 'end' })}${titled(groups[g].name)}</g>`);
      if (!s) {
        out.push(text(plot.left + 6, at + 4, 'not solved', { size: 11 }));
        return;
      }
      const colour = caseColour(colourOf(g));
      const middle = model.valueText(q, middleOf(model, model.comparison[q.name][g]));
      const tooltip = `${groups[g].name}: ${middle} (${s.n} scenarios)`;
      out.push(rule(x(s.outer[0]), at, x(s.outer[1]), at, colour, 1.6));
      if (s.inner) out.push(rule(x(s.inner[0]), at, x(s.inner[1]), at, colour, 7));
      if (s.middle !== null) out.push(mark(colourOf(g), [[x(s.middle), at]], 4.6, { tooltip }));
    });
    return [...out, ...edges];
  };
  const most = Math.max(...shown.flatMap((q) => model.comparison[q.name].map((s) => s?.n ?? 0)));
  return {
    id: 'comparison-figure',
    title: `${middleWord(model) === 'median' ? 'Median' : 'Weighted mean'} and spread of the main values`,
    draw(width) {
      const kLongName = 16;
      const grid = panelGrid(
        shown.length,
        longest > kLongName ? Math.min(width, 900) : width,
        kHeight,
        0,
        width,
      );
      return { shapes: shown.flatMap((q, i) => panel(q, grid.at(i))), height: grid.bottom };
    },
    caption() {
      const [q] = shown;
      const ranked = model.comparison[q.name]
        .map((s, g) => ({ s: spread(model, q, s), name: groups[g].name }))
        .filter(({ s }) => s && s.middle !== null)
        .sort((a, b) => a.s.middle - b.s.middle);
      const nameAndValue = ({ s, name }) =>
        `${name.replace(/-/g, '\u2011')} (${withUnit(s.middle, q.shown, 3)})`;
      const ends =
        ranked.length > 1
          ? ` Lowest ${q.short_name}: ${nameAndValue(ranked[0])}; highest: ` +
            `${nameAndValue(ranked[ranked.length - 1])}.`
          : '';
      return (
        (model.has_sample
          ? 'Mark: median; thick: 25 % to 75 % of the scenarios; thin: 5 % to 95 %.'
          : most > 1
            ? `Mark: ${middleWord(model)}; thin line: from the lowest to the highest of the scenarios.`
            : 'Each mark is one scenario.') + ends
      );
    },
    columns: () => [
      { title: 'group', values: groups.map((g) => g.name) },
      ...shown.flatMap((q) => {
        const all = model.comparison[q.name].map((s) => spread(model, q, s));
        return [
          [middleWord(model), (s) => s.middle],
          [model.has_sample ? '5 %' : 'lowest', (s) => s.outer[0]],
          [model.has_sample ? '95 %' : 'highest', (s) => s.outer[1]],
        ].map(([words, of]) => ({
          title: axisTitle(`${q.short_name}: ${words}`, q.shown),
          values: all.map((s) => (s ? of(s) : null)),
        }));
      }),
    ],
  };
}

/** Difference of a group to the first: { text, sure }, of the same points where these are paired. */
export function differenceOf(model, q, g) {
  const [first, own] = [model.comparison[q.name][0], model.comparison[q.name][g]];
  if (g === 0 || !first || !own) return null;
  if (own.difference) {
    const [value, low, high] = own.difference;
    return {
      text: percent(value),
      interval: `${percent(low)} to ${percent(high)}`,
      sure: low > 0 || high < 0,
    };
  }
  const [firstMiddle, ownMiddle] = [middleOf(model, first), middleOf(model, own)];
  return firstMiddle && ownMiddle !== null
    ? {
        text: percent((ownMiddle - firstMiddle) / Math.abs(firstMiddle), 1, firstMiddle > 0),
        interval: null,
        sure: null,
      }
    : null;
}
