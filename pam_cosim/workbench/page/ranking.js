// The ranking: a line for each model that was tried, best first.

import { make, table } from "./element.js";

const SHOWN = 12; // rows before the rest is folded

/** Elements of the ranking; `how`: whether it is `running`, the `latest` model, `busy`, and `take(effects)`. */
export function ranking(ranked, how) {
  const rows = ranked.candidates.map((c) => row(c, how));
  const rest = rows.slice(SHOWN);
  const body = (part) => make("div", { class: "scroll" }, make("table", { class: "ranking" }, heads(), make("tbody", {}, part)));
  return [
    make("h2", {}, how.running ? "Effects as they are tried" : "Which effects explain it"),
    how.running && !rows.length
      ? make(
          "p",
          { class: "soft" },
          "The base model is fitted first, and every balance is asked for what it lacks; then effects are tried.",
        )
      : "",
    how.running ? marginals(ranked.candidates) : "",
    rows.length ? body(rows.slice(0, SHOWN)) : "",
    rest.length ? make("details", {}, make("summary", {}, `${rest.length} more, with less evidence`), body(rest)) : "",
    rows.length
      ? make(
          "p",
          { class: "soft" },
          "Δ BIC: evidence against the base model; the more negative, the better; below −10 is very strong.",
        )
      : "",
    failed(ranked.failed),
  ].filter(Boolean);
}

const heads = () =>
  make(
    "thead",
    {},
    make(
      "tr",
      {},
      make("th", {}, "effects in the model"),
      make("th", {}, "error explained"),
      make("th", { class: "n" }, "Δ BIC"),
      make("th", { class: "n" }, "χ² fit"),
      make("th", { class: "n" }, "χ² held out"),
      make("th", {}, ""),
    ),
  );

function row(c, { running, latest, busy, take }) {
  const bar = make("div", { class: "share-bar" }, make("div", {}));
  bar.firstChild.style.width = `${100 * Math.max(0, Math.min(1, c.share ?? 0))}%`;
  const button = running
    ? ""
    : make(
        "button",
        {
          type: "button",
          disabled: busy,
          onclick: () => take(c.effects),
          "aria-label": `Take ${c.effect} into the model`,
        },
        "Take",
      );
  const about = [c.family, c.place ?? "", c.brief ? "first steps of its fit" : ""]
    .filter(Boolean)
    .join(", ");
  return make(
    "tr",
    {
      class: [c.added ? "added" : "", running && c.effect === latest ? "latest" : ""].join(" ").trim(),
      title: (c.own ?? []).join("\n"),
    },
    make("td", {}, make("b", {}, c.effect), make("small", {}, about)),
    make("td", {}, make("div", { class: "share" }, bar, make("span", {}, c.explained))),
    make("td", { class: "n" }, c.delta_bic),
    make("td", { class: "n" }, c.chi2),
    make("td", { class: "n" }, c.holdout),
    make("td", { class: "n" }, button),
  );
}

function failed(rows) {
  if (!rows?.length) return null;
  return make(
    "details",
    {},
    make("summary", {}, `${rows.length} could not be fitted`),
    table(
      ["effects in the model", "family", "reason"],
      rows.map((r) => [r.effect, r.family, r.reason]),
    ),
  );
}

/** How probable each family is by the models that were tried so far, whatever else is missing. */
function marginals(candidates) {
  const family = new Map(candidates.filter((c) => c.effects.length === 1).map((c) => [c.effects[0], c.family]));
  const sums = new Map();
  for (const c of candidates)
    for (const name of new Set(c.effects.map((effect) => family.get(effect) ?? c.family)))
      sums.set(name, (sums.get(name) ?? 0) + (c.probability ?? 0));
  const rows = [...sums].filter(([, share]) => share >= 0.005).sort((a, b) => b[1] - a[1]);
  if (!rows.length) return "";
  const bar = (share) => {
    const whole = make("div", { class: "share-bar" }, make("div", {}));
    whole.firstChild.style.width = `${100 * Math.min(1, share)}%`;
    return whole;
  };
  return make(
    "table",
    { class: "probabilities", "aria-label": "Probability of each family by the models that were tried so far" },
    make(
      "tbody",
      {},
      rows.map(([name, share]) =>
        make(
          "tr",
          {},
          make("th", { scope: "row" }, `${name}, so far`),
          make("td", {}, bar(share)),
          make("td", { class: "n" }, `${Math.round(100 * Math.min(1, share))} %`),
        ),
      ),
    ),
  );
}
