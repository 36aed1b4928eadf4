// A verdict in words and tables: reasons, parameters, next experiment, learned term.

import { listed, make, table } from "./element.js";

/**
 * The head of a verdict and what stands below the ranking; `take()` makes what it found the model, `addLearned()`
 * writes the learned formula.
 */
export function verdictParts(v, take, addLearned) {
  const said = (text, tag = "p", properties = {}) => (text ? make(tag, properties, text) : "");
  const head = [
    said(v.kind_name, "p", { class: "kind" }),
    said(v.headline || v.families?.join(" and "), "h2"),
    said(v.instrument),
    said(v.error),
    said(v.probability),
    families(v.table),
    said(v.small, "p", { class: "soft" }),
    probabilities(v.probabilities),
    said([v.reason, v.compared, v.disagreement].filter(Boolean).join(" ")),
    ...(v.doubts ?? []).map((doubt) => said(`LOOK FIRST: ${doubt}`, "p", { class: "caution" })),
    said(v.not_tried, "p", { class: "soft" }),
    v.complete ? make("p", { class: "steps-on" }, takeButton(v, take), reportLink()) : "",
  ];
  return {
    head: head.filter(Boolean),
    rest: [
      summary(v),
      parameters(v),
      meaning(v),
      next(v.next),
      learned(v.learned, addLearned),
      missing(v.missing),
    ].filter(Boolean),
  };
}

/** The families that may be missing, each whatever else is: as in the terminal and in the report. */
function families(rows) {
  if (!rows?.length) return "";
  const heads = ["may be missing", "#probability", "worth"];
  return table(heads, rows.map((row) => [row.families, row.probability, row.worth]), { class: "family-table" });
}

const percent = (share) => `${share > 0 && share < 0.005 ? "< 1" : Math.round(100 * share)} %`;

/** A bar for each thing that may be missing; what the verdict names stands out. */
function probabilities(rows) {
  if (!rows?.length) return "";
  const bar = (share) => {
    const whole = make("div", { class: "share-bar" }, make("div", {}));
    whole.firstChild.style.width = `${100 * share}%`;
    return whole;
  };
  const line = (row) =>
    make(
      "tr",
      { class: row.named ? "named" : "" },
      make("th", { scope: "row" }, row.what),
      make("td", {}, bar(row.probability)),
      make("td", { class: "n" }, percent(row.probability)),
    );
  return make(
    "table",
    { class: "probabilities", "aria-label": "Probability of what may be missing" },
    make("tbody", {}, rows.map(line)),
  );
}

function takeButton(v, take) {
  if (!v.effects?.length) return "";
  const kind = v.kind === "identified" ? "main" : "";
  return make(
    "button",
    { type: "button", class: kind, onclick: take },
    `Take ${listed(v.effects)} into the model`,
  );
}

function reportLink() {
  return make("a", { href: "download/report.html", download: "report.html", class: "button" }, "Download the report");
}

function summary(v) {
  if (!v.summary?.length) return null;
  const after = v.summary.some((s) => s.after && s.after !== "–");
  const heads = [
    "signal",
    "runs",
    "#base model",
    ...(after ? ["#with effect"] : []),
    "#noise",
    "#χ² before",
    ...(after ? ["#χ² after"] : []),
  ];
  const rows = v.summary.map((s) => [
    s.name,
    s.role,
    s.before,
    ...(after ? [s.after] : []),
    s.noise,
    s.chi2_before,
    ...(after ? [s.chi2_after] : []),
  ]);
  return make("section", {}, make("h2", {}, "Root mean square error"), table(heads, rows));
}

function parameters(v) {
  if (!v.parameters?.length) return null;
  const rows = v.parameters.map((p) => [p.name, p.origin, p.base, p.value, p.interval, p.unit, p.remark]);
  return make(
    "section",
    {},
    make("h2", {}, "Parameters"),
    table(["parameter", "belongs to", "#base model", "#value", "#95 % interval", "unit", ""], rows),
    make(
      "p",
      { class: "soft" },
      "A base parameter that moves far when the effect is added had been bent to stand in for it.",
    ),
  );
}

function meaning(v) {
  return v.meaning ? make("section", {}, make("h2", {}, "What this verdict means"), make("p", {}, v.meaning)) : null;
}

function next(plan) {
  if (!plan) return null;
  const rows = plan.rows.map(([name, value]) => make("tr", {}, make("th", {}, name), make("td", {}, value)));
  const file = make(
    "a",
    { href: "download/next.csv", download: "next.csv", class: "button" },
    "Download the run table",
  );
  return make(
    "section",
    {},
    make("h2", {}, "The next experiment"),
    make("table", {}, make("tbody", {}, rows)),
    plan.table?.length
      ? [
          make("p", {}, `What to drive (${plan.course}): `, file),
          make(
            "details",
            {},
            make("summary", {}, "The table"),
            table(
              plan.heads.map((h) => `#${h}`),
              plan.table,
            ),
            plan.left_out ? make("p", { class: "soft" }, `${plan.left_out} more rows are in the file.`) : "",
          ),
        ]
      : "",
  );
}

function learned(term, add) {
  if (!term) return null;
  const rows = term.rows.map((s) => [s.name, s.role, s.before, s.after, s.noise]);
  const beside = term.beside ? `It stands beside ${term.beside}. ` : "";
  return make(
    "section",
    {},
    make("h2", {}, "What is missing, described"),
    make("pre", { class: "formula" }, make("code", {}, term.formula)),
    make(
      "p",
      {},
      `${beside}It acts in the ${term.balance} balance and explains ${term.score} of the mean square error in runs that ` +
        `were not asked for it, ${term.fit_score} in those that were.`,
    ),
    make("p", { class: "caution" }, term.caution),
    table(["signal", "runs", "#before", "#with the formula", "#noise"], rows),
    make("p", {}, make("button", { type: "button", onclick: add }, `Write ${term.name}.mo`)),
    make(
      "details",
      {},
      make("summary", {}, `Modelica text of ${term.name}`),
      make("pre", {}, make("code", {}, term.source)),
    ),
  );
}

function missing(term) {
  if (!term?.rows?.length) return null;
  return make(
    "section",
    {},
    make("h2", {}, "What is left"),
    term.balance
      ? make("p", {}, `Of the effects that were tried, those of the ${term.balance} balance come closest.`)
      : "",
    table(
      ["signal", "#error left", "#in noise standard deviations", "goes with", "#correlation"],
      term.rows.map((s) => [s.name, s.rmse, s.size, s.with, s.correlation]),
    ),
  );
}
