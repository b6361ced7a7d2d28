// The language of the page: the files speak English, and other words are looked up.
import { german } from "./de.js";
import { failures } from "./errors.js";

const known = { en: {}, de: german };
const kept = "calib.language";

function chosen() {
  try {
    return localStorage.getItem(kept);
  } catch {
    return null;
  }
}

/** English or German: what was chosen here, else what the browser asks for first. */
let language = [chosen(), ...navigator.languages.map((one) => one.slice(0, 2))].find((one) => one in known) || "en";

export const current = () => language;

/** A text in the language of the page; {0}, {1} ... are the values. One it does not know stays English. */
export function say(text, ...values) {
  const found = known[language][text] || text;
  return found.replace(/\{(\d)\}/g, (_, place) => values[place]);
}

/** Failures the server tells of: an expression for what it says, and what the page says. */
const told = Object.entries(failures).map(([text, words]) => {
  const [en, de] = Array.isArray(words) ? words : [text, words];
  const parts = text.split(/\{\d\}/).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  return { expression: new RegExp("^" + parts.join("(.+?)") + "$", "s"), en, de, open: parts.length - 1 };
});
// What has no places for values says most.
told.sort((a, b) => a.open - b.open);

function known_failure(text) {
  for (const one of told) {
    const found = one.expression.exec(text);
    if (found) return one[language].replace(/\{(\d)\}/g, (_, place) => tell(found[Number(place) + 1]));
  }
  return null;
}

/** What the server says of a failure, in words of the page: a place before a colon, a message, and on a line of its own
 *  what to do about it. What it does not know stays as it is. */
export function tell(text) {
  const [message, ...hints] = text.split("\n");
  if (hints.length) return tell(message) + ": " + tell(hints.join("\n"));
  const whole = known[language][text] || known_failure(text);
  if (whole) return whole;
  const at = text.indexOf(": ");
  return at < 0 ? text : (known_failure(text.slice(0, at)) || text.slice(0, at)) + ": " + tell(text.slice(at + 2));
}

const formats = new Map();

function format(key, options) {
  const name = language + key;
  if (!formats.has(name)) formats.set(name, new Intl.NumberFormat(language, { useGrouping: false, signDisplay: "negative", ...options }));
  return formats.get(name);
}

/** A number with so many decimals. */
export const decimals = (value, count) =>
  format("." + count, { minimumFractionDigits: count, maximumFractionDigits: count }).format(value);

/** A sensitivity with four decimals, more where it is small. */
export const sensitivity = (value) => decimals(value, 4 + Math.min(6, Math.max(0, Math.ceil(-Math.log10(Math.abs(value) || 1)))));

/** A number with at most so many figures. */
export const figures = (value, count) => format("#" + count, { maximumSignificantDigits: count }).format(value);

const attributes = ["placeholder", "aria-label"];
let places = null;

/** Where the page itself has words: text and attributes, with what they say in English. */
function find_places() {
  const all = [], walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) {
    const node = walk.currentNode, text = node.data.trim();
    if (/\p{L}/u.test(text)) all.push((words) => { node.data = node.data.replace(node.data.trim(), () => words(text)); });
  }
  for (const name of attributes) {
    for (const element of document.querySelectorAll("[" + name + "]")) {
      const text = element.getAttribute(name);
      all.push((words) => element.setAttribute(name, words(text)));
    }
  }
  return all;
}

/** Puts the words of the language in place of those of the files. */
export function translate() {
  places = places || find_places();
  for (const put of places) put(say);
  document.documentElement.lang = language;
}

/** Changes to this language, and keeps it for the next visit. */
export function choose(wanted) {
  language = wanted;
  try {
    localStorage.setItem(kept, wanted);
  } catch {
    // The choice lasts as long as the page.
  }
  translate();
}
