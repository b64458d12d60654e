// A figure as an SVG document: to take away, and in print.
import { linePanel, swatch } from './line_panel.js';
import { barPanel, rankedHeight, rankedPanel, sharesHeight, sharesPanel } from './svg_bars.js';
import { legend, svgDocument } from './svg_shapes.js';

const kPanelHeight = 262;

function panelHeight(panel) {
  if (panel.parts) return sharesHeight(panel);
  return panel.ranked ? rankedHeight(panel) : kPanelHeight;
}

function drawnPanel(panel, box, visible, window) {
  if (panel.parts) return sharesPanel(panel, box, visible);
  if (panel.ranked) return rankedPanel(panel, box, visible);
  return panel.bars ? barPanel(panel, box, visible) : linePanel(panel, box, visible, window).shapes;
}

/** Names of what is shown, each once, with its part of friction where the name does not have it. */
function entries(figure, visible) {
  const named = new Map();
  // Shares have the colours of their parts, with a legend of their own.
  for (const { bars, groups, series } of figure.panels.filter((panel) => !panel.parts)) {
    for (const { label, caseIndex, part = null, dash } of (bars ? groups : series).filter(visible)) {
      const isSaid = !part || ['measured', 'total', 'points'].includes(part) || label.includes(part);
      const entry = { caseIndex, part, dash, bars };
      if (!named.has(`${label}, ${part}`))
        named.set(`${label}, ${part}`, {
          label: isSaid ? label : `${label}, ${part}`,
          swatch: (x, y) => swatch(entry, x, y),
        });
    }
  }
  return [...named.values()];
}

/**
 * The figure as an SVG document.
 * @param visible which series are shown; @param options width, heading (title and legend inside), windows: x
 * window by panel id
 */
export function figureSvg(
  figure,
  visible,
  { width = 760, heading = true, windows = {}, subtitle = '' } = {},
) {
  const named = heading ? legend(entries(figure, visible), width) : { shapes: [], height: 0 };
  const shapes = [...named.shapes];
  let y = named.height + 4;
  const perRow = figure.layout === 'row' && width >= 600 ? Math.min(2, figure.panels.length) : 1;
  for (let first = 0; first < figure.panels.length; first += perRow) {
    const row = figure.panels.slice(first, first + perRow);
    const whole = row.reduce((sum, panel) => sum + (panel.weight ?? 1), 0);
    const height = Math.max(...row.map(panelHeight));
    let x = 0;
    for (const panel of row) {
      const box = { x, y, width: (width * (panel.weight ?? 1)) / whole, height };
      shapes.push(...drawnPanel(panel, box, visible, windows[panel.id]));
      x += box.width;
    }
    y += height;
  }
  return svgDocument({ shapes, height: y + 4 }, width, heading ? { title: figure.title, subtitle } : {});
}
