// What all pages have: the head with the numbers and the warning that matter, contents and sections.
import { element } from './dom.js';
import { fold } from './tables.js';

/** @param kind what was computed, over the title @param operating lines under it @param parts what follows */
export function pageHead({ kind, title, operating }, ...parts) {
  return element(
    'header',
    { class: 'first-screen' },
    element('p', { class: 'kind' }, kind),
    element('h1', {}, title),
    [operating].flat().map((line) => element('p', { class: 'operating' }, line)),
    parts,
  );
}

/** The page of a head and its parts { id, label, node }, which the contents list; null: not there. */
export function showPage(head, parts, { contents = true } = {}) {
  const there = parts.filter((part) => part?.node);
  const links = there
    .filter(({ label }) => label)
    .map(({ id, label }) => element('a', { href: `#${id}` }, label));
  const nav = element('nav', { class: 'contents', 'aria-label': 'Contents' }, links);
  document
    .getElementById('report')
    .replaceChildren(head, ...(contents ? [nav] : []), ...there.map(({ node }) => node));
}

/** Two in a row where there is room. */
export function charts(views) {
  return element(
    'div',
    { class: 'charts' },
    views.map((view) => view?.node ?? view),
  );
}

export function card(heading, ...content) {
  return element('section', { class: 'card' }, element('h2', {}, heading), content);
}

/** A value with what follows it in the same size. */
export function cardValue(value, after = '') {
  return element('span', { class: 'card-value' }, element('b', {}, String(value)), after);
}

/** @param name what the value is of, as nodes; null where it is alone @param detail in small type, null: none */
export function cardRow(name, value, detail, more = null) {
  return element(
    'div',
    { class: 'card-row' },
    name && element('span', { class: 'card-name' }, name),
    value,
    detail === null ? null : element('span', { class: 'card-detail' }, detail),
    more,
  );
}

/** One number with its heading. @param of what follows the number in the same size @param detail in small type */
export function numberCard(heading, value, { of = '', detail }) {
  return card(heading, cardRow(null, cardValue(value, of), detail));
}

export function cards(...list) {
  return element('div', { class: 'cards' }, list);
}

/** The one warning on the first screen. */
export function headWarning(label, ...content) {
  return element('p', { class: 'warning', role: 'note' }, element('strong', {}, `${label}: `), content);
}

/** What went wrong, before any number. */
export function alarm(label, content, ...more) {
  return element(
    'div',
    { class: 'warning stopped', role: 'alert' },
    element('p', {}, element('strong', {}, label), content),
    more,
  );
}

/** More notes than these are folded away. */
const kNotesShown = 4;

export function noteList(notes) {
  return element(
    'ul',
    { class: 'notes' },
    notes.map((note) => element('li', {}, note)),
  );
}

/** Notes as a warning; null without any. */
export function notesBox(notes) {
  if (notes.length === 0) return null;
  const others = notes.slice(kNotesShown);
  const words = `${others.length} more ${others.length === 1 ? 'note' : 'notes'}`;
  return element(
    'div',
    { class: 'warning', role: 'note' },
    element('strong', {}, 'Warning: '),
    noteList(notes.slice(0, kNotesShown)),
    others.length ? fold(words, false, noteList(others)) : null,
  );
}
