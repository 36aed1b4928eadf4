// What becomes of dropped files: each question a field with the evidence beside it, and a preview; or what is wrong.

import { advice, bareName, cells } from "./advice.js";
import { begin, text, trace } from "./drawing.js";
import { fields, make } from "./element.js";
import { number, tickLabels, ticks } from "./numbers.js";
import { palette } from "./palette.js";

const WORDS = { columns: "column", parameters: "parameter", recording: "reading", roles: "role" };
const READING = {
  interval: "time between two rows, where no column is the time",
  decimal: "decimal sign",
  separator: "what separates columns",
  missing: "numbers or words that mark a missing sample",
  ignore: "columns to leave out",
  resample: "means over so much time",
};

/** The elements of a draft; `change(group, name, value)` is told what a person says. */
export function draftParts(draft, wishes, change, files) {
  const evidence = new Map(draft.guesses.map((g) => [/^[^\s[:,]+/.exec(g.taken_as)?.[0] ?? "", g]));
  const constants = draft.names.filter((n) => n.input && !evidence.has(n.name) && !draft.columns[n.name]);
  const answer = (group, name, value) => (value ? change(group, name, value) : seek(group, name));
  return [
    draft.failed ? problem(draft, answer) : null,
    said(wishes, change),
    draft.benches.length ? rig(draft, constants, wishes, change) : null,
    sentences("Please check: only you know", draft.to_check, answer),
    sentences("Recordings that begin in the middle", draft.starts, answer),
    draft.names.length ? columns(draft, evidence, wishes, change, answer, files) : null,
    draft.curves.length
      ? make("section", {}, make("h3", {}, "Preview"), make("div", { class: "previews" }, previews(draft)))
      : null,
    draft.runs.length ? runs(draft, constants, wishes, change) : null,
    reading(wishes, change),
    others(draft, answer),
    draft.toml
      ? make(
          "details",
          {},
          make("summary", {}, "experiment.toml as it will be written"),
          make("pre", {}, make("code", {}, draft.toml)),
        )
      : null,
  ].filter(Boolean);
}

/** Shows the field in which something is to be said. */
function seek(group, name) {
  const word = WORDS[group] ?? group;
  const all = [...document.querySelectorAll("#drop [data-wish]")];
  const field = all.find((one) => one.dataset.wish === `${word} ${name}`.trim()) ??
    all.find((one) => one.dataset.wish.startsWith(word));
  field?.closest("details")?.setAttribute("open", "");
  field?.scrollIntoView({ block: "center" });
  field?.focus();
}

function field(group, name, wishes, change, properties = {}) {
  return make("input", {
    type: "text",
    "aria-label": name || group,
    ...properties,
    value: (name ? wishes[group][name] : wishes[group]) ?? "",
    "data-wish": `${WORDS[group] ?? group} ${name}`.trim(),
    onchange: (e) => change(group, name, e.target.value.trim()),
  });
}

const choices = (id, values) =>
  make("datalist", { id }, [...values].map(([value, words]) => make("option", { value }, words ?? "")));

const section = (title, ...children) => make("section", {}, make("h3", {}, title), children);

function sentences(title, lines, answer) {
  if (!lines.length) return null;
  return section(title, make("ul", { class: "caution-list" }, lines.map((line) => make("li", {}, advice(line, answer)))));
}

/** What is wrong, in words and at its cell. */
function problem({ failed, excerpt }, answer) {
  const place = [failed.file, failed.line ? `line ${failed.line}` : "", failed.column ? `column ${failed.column}` : ""]
    .filter(Boolean)
    .join(", ");
  return make(
    "section",
    { class: "problem", role: "alert" },
    make("h3", {}, place || "This cannot be used yet"),
    make("p", { class: "caution" }, advice(failed.text, answer)),
    excerpt ? rows(excerpt, failed.column) : "",
  );
}

function rows(excerpt, column) {
  const [header, ...lines] = cells([...excerpt.header, ...excerpt.lines]);
  const at = column ? header.findIndex((head) => head === column || bareName(head) === column) : -1;
  const cell = (value, i, wrong) => make("td", { class: wrong && (at < 0 || at === i) ? "wrong" : "" }, value);
  const row = (values, k) =>
    make(
      "tr",
      {},
      make("th", { scope: "row" }, String(excerpt.first + k)),
      values.map((value, i) => cell(value, i, excerpt.first + k === excerpt.line)),
    );
  const heads = header.map((name, i) => make("th", { class: i === at ? "wrong" : "" }, name));
  return make(
    "div",
    { class: "scroll" },
    make(
      "table",
      { class: "excerpt" },
      make("thead", {}, make("tr", {}, make("th", {}, "line"), heads)),
      make("tbody", {}, lines.map(row)),
    ),
  );
}

/** What a person has said so far, each with a way to take it back. */
function said(wishes, change) {
  const groups = Object.entries(wishes).flatMap(([group, value]) =>
    typeof value === "string" ? (value ? [[group, "", value]] : []) : Object.entries(value).map(([n, v]) => [group, n, v]),
  );
  if (!groups.length) return null;
  const chip = ([group, name, value]) =>
    make(
      "li",
      {},
      `${name || group} = ${value} `,
      make(
        "button",
        { type: "button", class: "link", "aria-label": `Take back ${name || group}`, onclick: () => change(group, name, "") },
        "take back",
      ),
    );
  return section("You said", make("ul", { class: "chips" }, groups.map(chip)));
}

/** The bench, the muscle, its measures: with what is taken until somebody says otherwise. */
function rig(draft, constants, wishes, change) {
  const model = draft.model.split(/[\\/]/).at(-1).split(".").filter((part) => part !== "mo").at(-1) ?? "";
  const part = (role) => draft.parts.filter((one) => one.role === role);
  const rigs = part("pneumatics").flatMap((a) =>
    part("mechanics").map((b) => [`${a.name} and ${b.name}`, `${a.description}; ${b.description}`]),
  );
  const line = (label, control, words) =>
    make("label", { class: "line" }, make("span", {}, label), control, make("span", { class: "soft" }, words));
  const muscle = wishes.muscle ? part("muscle").find((one) => one.name === wishes.muscle)?.description : "";
  const shown = (p) => p.geometry || p.unit === "rad" || p.name in draft.stated || p.name in wishes.parameters;
  return section(
    "The rig",
    line("title", field("title", "", wishes, change, { placeholder: draft.title }), ""),
    line(
      "bench",
      field("model", "", wishes, change, { placeholder: model || "as recognised", list: "benches" }),
      wishes.model ? "" : model && "proposed by what was measured",
    ),
    line(
      "type of muscle",
      field("muscle", "", wishes, change, { placeholder: "the bench's own", list: "muscles" }),
      muscle || "a type, with its length in mm: DMSP-20-300; any-geometry takes a braid angle",
    ),
    line(
      "data sheet of the valves",
      field("valve", "", wishes, change, { placeholder: "0.8 mm2 at 250 mA" }),
      "an area or a flow at a current: 120 l/min at 300 mA from 40 mA",
    ),
    choices("benches", [...draft.benches.map((name) => [name, "a bench of the library"]), ...rigs]),
    choices("muscles", part("muscle").map((one) => [one.name, one.description])),
    parameters([...constants, ...draft.parameters.filter(shown)], draft, wishes, change),
    make(
      "details",
      {},
      make("summary", {}, "More of the rig that can be stated"),
      parameters(draft.parameters.filter((p) => !shown(p)), draft, wishes, change),
    ),
  );
}

function parameters(list, draft, wishes, change) {
  const row = (p) => {
    const stated = draft.stated[p.name];
    const usual = p.input ? p.unit : `${number(p.value)} ${p.unit}`.trim();
    const source = p.input ? "not recorded: a constant" : "the bench's own";
    return make(
      "tr",
      {},
      make("td", {}, make("code", {}, p.name)),
      make("td", {}, field("parameters", p.name, wishes, change, { size: 12, placeholder: String(stated ?? usual) })),
      make("td", {}, p.description),
      make("td", { class: "soft" }, wishes.parameters[p.name] ? "" : stated === undefined ? source : "follows"),
    );
  };
  return fields([], list.map(row));
}

/** Each quantity of the bench: its column or formula, and why. */
function columns(draft, evidence, wishes, change, answer, files) {
  const heads = files.flatMap((file) => cells(file.lines)[0] ?? []).filter(Boolean).map(bareName);
  const seen = [...draft.guesses.filter((g) => g.taken_as === "not read").map((g) => g.what), ...heads];
  const row = (n) => {
    const taken = draft.columns[n.name],
      guess = evidence.get(n.name);
    const now = taken?.formula ?? taken?.column ?? heads.find((head) => head === n.name);
    const unit = [n.unit, n.kind ?? (n.input ? "driven" : "measured")].filter(Boolean).join(", ");
    return make(
      "tr",
      {},
      make("td", { title: n.description }, make("b", {}, n.name), make("small", {}, unit)),
      make(
        "td",
        {},
        field("columns", n.name, wishes, change, {
          size: 34,
          list: "heads",
          title: now ? String(now) : "",
          placeholder: now ? String(now) : "a column, or a formula",
        }),
      ),
      make("td", {}, zero(n, taken ?? (now && { column: now }), wishes, change)),
      make("td", {}, guess?.why ? advice(guess.why.replace(/^guessed: /, ""), answer) : n.description),
    );
  };
  const time = { name: "time", unit: "s", kind: "", input: true, description: "the clock of the rows" };
  return section(
    "What each quantity is read from",
    choices("heads", [...new Set(seen)].map((name) => [name])),
    fields(["quantity", "column or formula", "reads zero at", "evidence"], [...draft.names.map(row), row(time)]),
    make(
      "p",
      { class: "soft" },
      `A formula is arithmetic of columns and quantities: "312.6 mm" - Weg where the heading of Weg states its unit, ` +
        `"312.6 mm" - Weg * "1 mm" where it does not.`,
    ),
  );
}

/** The reading at which a measured quantity is zero: it becomes part of the formula. */
function zero(n, taken, wishes, change) {
  const now = wishes.columns[n.name] ?? taken?.formula ?? taken?.column;
  if (n.input || !now || n.name === "time") return "";
  const { slope, rest } = split(String(now), taken, Boolean(wishes.columns[n.name]));
  if (!slope) return "";
  return make("input", {
    type: "text",
    size: 10,
    placeholder: rest || "0",
    "aria-label": `Reading at which ${n.name} is zero`,
    "data-wish": `zero ${n.name}`,
    onchange: (e) => {
      const at = e.target.value.trim().replaceAll('"', "");
      if (!at) return change("columns", n.name, "");
      change("columns", n.name, slope.startsWith("-") ? `"${at}" - ${slope.slice(1)}` : `${slope} - "${at}"`);
    },
  });
}

/** The term of a column, with its sign, and the reading that is zero, of a formula that is a column less a constant. */
function split(formula, taken, stated) {
  if (!stated && taken?.column) {
    const name = /^[A-Za-z_]\w*$/.test(taken.column) ? taken.column : `'${taken.column}'`;
    return { slope: taken.unit ? `${name} * "1 ${taken.unit}"` : name, rest: "" };
  }
  const later = /^(.+?) ([+-]) "([^"]+)"$/.exec(formula);
  if (later && /^-?['\w]/.test(later[1]))
    return { slope: later[1], rest: later[1].startsWith("-") === (later[2] === "+") ? later[3] : `-${later[3]}` };
  const first = /^"([^"]+)" - (.+)$/.exec(formula);
  if (first) return { slope: `-${first[2]}`, rest: first[1] };
  return /^-?['\w]/.test(formula) ? { slope: formula, rest: "" } : {};
}

function runs(draft, constants, wishes, change) {
  const loads = draft.parameters.filter((p) => p.geometry && p.unit === "kg");
  const usual = (p) => draft.stated[p.name] ?? (p.input ? p.unit : `${number(p.value)} ${p.unit}`);
  const all = new Map([...loads, ...constants].map((p) => [p.name, usual(p)]));
  const own = [...new Set([...draft.runs.flatMap((run) => Object.keys(run.own)), ...all.keys()])];
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
    const guess = draft.guesses.find((g) => g.what.startsWith(`${run.name}.`));
    const values = own.map((name) =>
      make(
        "td",
        {},
        field("parameters", `${name}@${run.name}`, wishes, change, { size: 8, placeholder: String(run.own[name] ?? all.get(name) ?? "") }),
      ),
    );
    return make(
      "tr",
      { title: run.describe },
      make("td", {}, run.name),
      make("td", {}, role),
      values,
      make("td", { class: "soft" }, guess?.why.replace(/^guessed: /, "") ?? ""),
    );
  };
  return section("Runs", fields(["run", "role", ...own, "evidence"], draft.runs.map(row)));
}

/** How the files are to be read, where they do not show it. */
function reading(wishes, change) {
  const names = new Set([...Object.keys(READING), ...Object.keys(wishes.recording)]);
  const row = (name) =>
    make(
      "tr",
      {},
      make("td", {}, name),
      make("td", {}, field("recording", name, wishes, change, { size: 12 })),
      make("td", {}, READING[name] ?? ""),
    );
  return make(
    "details",
    {},
    make("summary", {}, "How the files are to be read"),
    fields([], [...names].map(row)),
  );
}

/** What else was guessed: noise, constants, columns that are not read. */
function others(draft, answer) {
  const names = new Set([...draft.names.map((n) => n.name), "time"]);
  const runs = draft.runs.map((run) => `${run.name}.`);
  const rest = draft.guesses.filter(
    (g) => !names.has(/^[^\s[:,]+/.exec(g.taken_as)?.[0]) && !runs.some((run) => g.what.startsWith(run)),
  );
  if (!rest.length) return null;
  const row = (g) =>
    make(
      "tr",
      {},
      make("td", {}, g.what),
      make("td", {}, g.taken_as),
      make("td", {}, advice(g.why.replace(/^guessed: /, ""), answer)),
    );
  return section("What else was taken", fields([], rest.map(row)));
}

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
