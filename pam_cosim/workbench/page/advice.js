// What the terminal tells to type, as something to press: an option in a sentence becomes a button at its field.

import { make } from "./element.js";

const OPTION = /--(title|model|muscle|valve|column|parameter|recording|role)[ =]('(?:[^']|'"'"')*'|"(?:[^"\\]|\\.)*"|[^\s,;:)=]*=[^\s,;)]*|[A-Z][^\s,;:)]*|)/g;
const GROUPS = { column: "columns", parameter: "parameters", recording: "recording", role: "roles" };
const EXAMPLES = ["muscle", "valve", "parameter"]; // whose values in a sentence are those of some other rig
const LIST = /'pam-cosim bench --list'( has the types)?/g;

/**
 * A sentence of the terminal as elements. `answer(group, name, value)` is told what a person takes of it; a value that
 * the sentence leaves open is "".
 */
export function advice(sentence, answer) {
  const words = sentence.replace(/ ?\('pam-cosim[^)]*\)/g, "").replace(LIST, "the field lists them");
  const parts = [];
  let at = 0;
  for (const found of words.matchAll(OPTION)) {
    parts.push(words.slice(at, found.index), button(found[1], bare(found[2]), answer), found[2] ? "" : " ");
    at = found.index + found[0].length;
  }
  return [...parts, words.slice(at)];
}

function button(option, value, answer) {
  const pair = option in GROUPS && /^([^=]+)=([^]*)$/.exec(value);
  const group = GROUPS[option] ?? option;
  const [name, text] = group === option ? ["", value] : pair ? [pair[1], pair[2]] : ["", value];
  const open = !text || /^(NAME|\.\.\.|COLUMN|VALUE|FORMULA|TYPE)/.test(text) || (EXAMPLES.includes(option) && text !== "0");
  const known = name && !/^(NAME|KEY)/.test(name) ? name : "";
  const example = text.includes(" ") ? `${option}: ${text}` : `state the ${option}`;
  const label = open ? (known ? `${group === "columns" ? "column of" : "state"} ${known}` : example) : known ? `${known} = ${text}` : text;
  return make(
    "button",
    { type: "button", class: "advice", onclick: () => answer(group, known, open ? "" : text) },
    label,
  );
}

/** A word of a shell without its quotes. */
function bare(word) {
  if (word.startsWith("'")) return word.slice(1, -1).replaceAll(`'"'"'`, "'");
  if (word.startsWith('"')) return word.slice(1, -1).replace(/\\(.)/g, "$1");
  return word;
}

/** A line of a text file in cells, by the separator that the lines have most of. */
export function cells(lines) {
  const all = lines.join("\n");
  const count = (mark) => all.split(mark).length;
  const mark = ["\t", ";", ","].reduce((best, one) => (count(one) > count(best) ? one : best));
  return lines.map((line) => line.split(mark).map((cell) => cell.trim().replace(/^"(.*)"$/, "$1")));
}

/** The name of a column without its unit. */
export const bareName = (head) => head.replace(/\s*[[(].*$/, "").trim() || head;
