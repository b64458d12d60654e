// The head of a page: what it is, its title, the numbers that matter and the warning that matters.
import { element } from './dom.js';

/** @param kind what was computed, over the title @param operating one line under it @param parts what follows */
export function pageHead({ kind, title, operating }, ...parts) {
  return element(
    'header',
    { class: 'first-screen' },
    element('p', { class: 'kind' }, kind),
    element('h1', {}, title),
    element('p', { class: 'operating' }, operating),
    parts,
  );
}

/** One number with its heading. @param of what follows the number in the same size @param detail in small type */
export function numberCard(heading, value, { of = '', detail }) {
  return element(
    'section',
    { class: 'card' },
    element('h2', {}, heading),
    element(
      'div',
      { class: 'card-row' },
      element('span', { class: 'card-value' }, element('b', {}, String(value)), of),
      element('span', { class: 'card-detail' }, detail),
    ),
  );
}

/** The one warning on the first screen. */
export function headWarning(label, ...content) {
  return element('p', { class: 'warning', role: 'note' }, element('strong', {}, `${label}: `), content);
}
