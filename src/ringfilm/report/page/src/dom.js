// Elements are made of text and attributes only: nothing from a result is ever read as HTML.

/** element('p', { class: 'note' }, 'text', child) */
export function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith('on')) node.addEventListener(key.slice(2), value);
    else node.setAttribute(key, value === true ? '' : String(value));
  }
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return node;
}

/** An SVG text of our own renderer as an element. */
export function svgElement(text) {
  return document.importNode(new DOMParser().parseFromString(text, 'image/svg+xml').documentElement, true);
}

/**
 * Acts when a node has got another width, in the next frame: within the observer it would change the sizes
 * being reported.
 */
export function onNewWidth(node, act, known = node.clientWidth) {
  let width = known;
  new ResizeObserver(() =>
    requestAnimationFrame(() => {
      if (node.clientWidth === width) return;
      width = node.clientWidth;
      act();
    }),
  ).observe(node);
}

export function section(id, heading, ...content) {
  return element('section', { id, class: 'section' }, element('h2', {}, heading), content);
}

/** A key or setting in type of its own, which may break after a dot, an underscore or an equals sign only. */
export function code(text, attributes = {}) {
  const pieces = String(text).match(/[^._=/]*[._=/]|[^._=/]+$/g) ?? [];
  return element(
    'code',
    attributes,
    pieces.flatMap((piece, i) => (i === 0 ? [piece] : [element('wbr'), piece])),
  );
}

/** Text in which the index of a symbol of one letter is set low: h_s, p_e; keys such as end_gap stay. */
export function withSubscripts(text) {
  return text
    .split(/(?<=(?<![\p{L}\d_.])\p{L})(_[A-Za-z]{1,5})(?![\w.])/u)
    .map((piece, i) => (i % 2 ? element('sub', {}, piece.slice(1)) : piece));
}

/** Starts the views of a page, and readies them and all folds for print. */
export function startViews(views) {
  // All widths before the first drawing, after which each question for one would lay the page out anew.
  views.forEach((view) => view.measure?.());
  views.forEach((view) => view.start());
  window.addEventListener('beforeprint', () => {
    document.querySelectorAll('details.fold').forEach((fold) => {
      fold.open = true;
    });
    views.forEach((view) => view.beforePrint());
  });
}
