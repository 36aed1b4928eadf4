// What becomes of dropped files, as elements: recognised, to be corrected, to be checked, a preview; or what is wrong.

import { begin, text, trace } from "./drawing.js";
import { make, table } from "./element.js";
import { number, tickLabels, ticks } from "./numbers.js";
import { palette } from "./palette.js";

/** The elements of a draft; `change(group, name, value)` is told what a person says. */
export function draftParts(draft, wishes, change, files) {
  return [
    heading(draft, wishes, change),
    draft.starts.length
      ? make(
          "section",
          { class: "starts" },
          make("h3", {}, "Recordings that begin in the middle"),
          make(
            "ul",
            { class: "caution-list" },
            draft.starts.map((line) => make("li", {}, line)),
          ),
        )
      : null,
    make("section", {}, make("h3", {}, "Preview"), make("div", { class: "previews" }, previews(draft))),
    make("section", {}, make("h3", {}, "Runs"), runs(draft, wishes, change)),
    draft.to_check.length
      ? make(
          "section",
          {},
          make("h3", {}, "Please check: only you know"),
          make(
            "ul",
            { class: "caution-list" },
            draft.to_check.map((line) => make("li", {}, line)),
          ),
          parameters(draft, wishes, change),
        )
      : null,
    make(
      "section",
      {},
      make("h3", {}, "What was recognised"),
      table(
        ["what", "taken as", "because"],
        draft.guesses.map((g) => [g.what, g.taken_as, g.why]),
      ),
    ),
    columns(draft.names, wishes, change, files),
    make(
      "details",
      {},
      make("summary", {}, "experiment.toml as it will be written"),
      make("pre", {}, make("code", {}, draft.toml)),
    ),
  ].filter(Boolean);
}

/** What is wrong, in words and at its cell, and below it what a person can say of it. */
export function problemParts(draft, wishes, change, files) {
  const { failed, excerpt } = draft;
  const place = [failed.file, failed.line ? `line ${failed.line}` : "", failed.column ? `column ${failed.column}` : ""]
    .filter(Boolean)
    .join(", ");
  return [
    make(
      "section",
      { class: "problem", role: "alert" },
      make("h3", {}, place || "This cannot be used yet"),
      make("p", { class: "caution" }, failed.text),
      excerpt ? rows(excerpt) : "",
    ),
    draft.benches.length ? heading(draft, wishes, change) : null,
    draft.runs.length ? make("section", {}, make("h3", {}, "Runs"), runs(draft, wishes, change)) : null,
    draft.parameters.length ? parameters(draft, wishes, change) : null,
    draft.names.length ? columns(draft.names, wishes, change, files) : null,
  ].filter(Boolean);
}

function rows(excerpt) {
  const cell = (value, i, wrong) =>
    make("td", { class: wrong && (excerpt.column === null || excerpt.column === i) ? "wrong" : "" }, value);
  const line = (cells, k) => {
    const at = excerpt.first + k,
      wrong = at === excerpt.line;
    return make(
      "tr",
      {},
      make("th", { scope: "row" }, String(at)),
      cells.map((value, i) => cell(value, i, wrong)),
    );
  };
  const head = make(
    "thead",
    {},
    make(
      "tr",
      {},
      make("th", {}, "line"),
      excerpt.header.map((name, i) => make("th", { class: i === excerpt.column ? "wrong" : "" }, name)),
    ),
  );
  return make(
    "div",
    { class: "scroll" },
    make("table", { class: "excerpt" }, head, make("tbody", {}, excerpt.rows.map(line))),
  );
}

function heading(draft, wishes, change) {
  const title = make("input", {
    type: "text",
    value: wishes.title ?? draft.title,
    "data-wish": "title",
    onchange: (e) => change("title", "", e.target.value),
  });
  const model = draft.model.split(".").at(-1);
  const bench = make(
    "select",
    { "data-wish": "model", onchange: (e) => change("model", "", e.target.value) },
    [...new Set([model, ...draft.benches])].map((name) =>
      make("option", { value: name, selected: name === model }, name || "as recognised"),
    ),
  );
  return make(
    "section",
    {},
    make("label", { class: "line" }, "title", title),
    make(
      "label",
      { class: "line" },
      "bench",
      bench,
      make("span", { class: "soft" }, wishes.model ? "" : "proposed by what was measured"),
    ),
  );
}

function runs(draft, wishes, change) {
  const row = (run) => {
    const role = make(
      "select",
      {
        "aria-label": `Role of ${run.name}`,
        "data-wish": `role ${run.name}`,
        onchange: (e) => change("roles", run.name, e.target.value),
      },
      [
        ["fit", "fit"],
        ["holdout", "hold out"],
      ].map(([value, words]) => make("option", { value, selected: value === (wishes.roles[run.name] ?? run.role) }, words)),
    );
    return make("tr", {}, make("td", {}, run.name), make("td", {}, role), make("td", {}, run.describe));
  };
  return make("div", { class: "scroll" }, make("table", {}, make("tbody", {}, draft.runs.map(row))));
}

function parameters(draft, wishes, change) {
  const row = (p) => {
    const field = make("input", {
      type: "text",
      size: 10,
      value: wishes.parameters[p.name] ?? "",
      placeholder: `${number(p.value)} ${p.unit}`.trim(),
      "aria-label": p.name,
      "data-wish": `parameter ${p.name}`,
      onchange: (e) => change("parameters", p.name, e.target.value.trim()),
    });
    return make(
      "tr",
      {},
      make("td", {}, make("code", {}, p.name)),
      make("td", {}, field),
      make("td", {}, p.description),
    );
  };
  return make(
    "details",
    {},
    make("summary", {}, "State what you know, with its unit (such as 3 kg)"),
    make("table", {}, make("tbody", {}, draft.parameters.map(row))),
  );
}

function columns(names, wishes, change, files) {
  const heads = [...new Set(files.flatMap((file) => file.header))];
  const row = (n) => {
    const choice = make(
      "select",
      {
        "aria-label": `Column of ${n.name}`,
        "data-wish": `column ${n.name}`,
        onchange: (e) => change("columns", n.name, e.target.value),
      },
      make("option", { value: "" }, "as recognised"),
      heads.map((head) => make("option", { value: bare(head), selected: wishes.columns[n.name] === bare(head) }, head)),
    );
    return make(
      "tr",
      {},
      make("td", {}, make("b", {}, n.name)),
      make("td", {}, n.unit),
      make("td", {}, n.input ? "driven" : "measured"),
      make("td", {}, choice),
      make("td", {}, n.description),
    );
  };
  return make(
    "details",
    {},
    make("summary", {}, "Take other columns"),
    make("table", {}, make("tbody", {}, names.map(row))),
  );
}

/** The name of a column without its unit. */
const bare = (head) => head.replace(/\s*[[(].*$/, "").trim() || head;

function previews(draft) {
  const signals = new Map();
  for (const curve of draft.curves) signals.set(curve.signal, [...(signals.get(curve.signal) ?? []), curve]);
  return [...signals].map(([name, curves]) => {
    const canvas = make("canvas", { class: "preview", role: "img", "aria-label": `${name} of all runs` });
    requestAnimationFrame(() => drawPreview(canvas, curves, palette()));
    return make(
      "figure",
      {},
      make("figcaption", {}, make("b", {}, name), curves[0].unit ? ` [${curves[0].unit}]` : ""),
      canvas,
    );
  });
}

function drawPreview(canvas, curves, colours) {
  const { g, width, height } = begin(canvas);
  const box = { left: 44, right: width - 6, top: 6, bottom: height - 18 };
  const known = (values) => values.filter((value) => value !== null);
  const times = curves.flatMap((c) => known(c.time)),
    values = curves.flatMap((c) => known(c.values));
  const scale = (all, from, to) => {
    const low = Math.min(...all),
      high = Math.max(...all);
    return { low, high, to: (value) => from + ((value - low) / (high - low || 1)) * (to - from) };
  };
  const x = scale(times, box.left, box.right),
    y = scale(values, box.bottom, box.top);
  const marks = ticks(y.low, y.high, 3),
    seconds = ticks(x.low, x.high, 5);
  tickLabels(marks).forEach((label, i) => {
    g.fillStyle = colours.line;
    g.fillRect(box.left, Math.round(y.to(marks[i])), box.right - box.left, 1);
    text(g, label, box.left - 5, y.to(marks[i]), colours.soft, { align: "right", base: "middle", size: 10 });
  });
  tickLabels(seconds).forEach((label, i) =>
    text(g, i === seconds.length - 1 ? `${label} s` : label, x.to(seconds[i]), height - 4, colours.soft, {
      align: x.to(seconds[i]) > box.right - 12 ? "right" : "center",
      size: 10,
    }),
  );
  Object.assign(g, { strokeStyle: colours.model, lineWidth: 1.3 });
  for (const curve of curves) {
    g.beginPath();
    trace(
      g,
      curve.time,
      curve.values.map((value) => value ?? NaN),
      0,
      curve.time.length,
      x.to,
      y.to,
    );
    g.stroke();
  }
}
