// Elements from data. Texts reach the page as text alone, never as markup.

/** An element with a class, properties, listeners ("onclick") and children (elements or texts). */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name in element && typeof value !== "string") element[name] = value;
    else if (name === "value") element.value = value;
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== ""));
  return element;
}

/** The element of the page with this id. */
export const byId = (id) => document.getElementById(id);

/** Replaces what is in an element, unless it is the same text. */
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** A table from heads and rows; a column that begins with "#" holds numbers. */
export function table(heads, rows, properties = {}) {
  const numeric = heads.map((head) => head.startsWith("#"));
  const cell = (tag, value, column) => make(tag, { class: numeric[column] ? "n" : "" }, value ?? "");
  const head = make(
    "thead",
    {},
    make(
      "tr",
      {},
      heads.map((h, i) => cell("th", h.replace(/^#/, ""), i)),
    ),
  );
  const body = make(
    "tbody",
    {},
    rows.map((row) =>
      make(
        "tr",
        {},
        row.map((value, i) => cell("td", value, i)),
      ),
    ),
  );
  return make("div", { class: "scroll" }, make("table", properties, head, body));
}

/** A table of fields, its rows made already: it scrolls sideways; on a narrow page each row is a stack of cells with
 * their heads. */
export function fields(heads, rows, tag = "div") {
  for (const row of rows) [...row.cells].forEach((cell, i) => (cell.dataset.head = heads[i] ?? ""));
  const head = make("tr", {}, heads.map((word) => make("th", {}, word)));
  return make(tag, { class: "scroll" }, make("table", { class: "fields" }, make("thead", {}, head), make("tbody", {}, rows)));
}

/** Words with commas, the last after "and". */
export const listed = (words) => [words.slice(0, -1).join(", "), words.at(-1)].filter(Boolean).join(" and ");
