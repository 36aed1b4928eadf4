// The diagnosis: what to leave out of it, what happens, the ranking as it grows, the verdict with its reasons.

import { make, say, table } from "./element.js";
import { number } from "./numbers.js";
import { verdictParts } from "./verdict.js";

const MOST_LINES = 400;
const SHOWN = 14; // rows of the ranking before the rest is folded

export class Diagnosis {
  constructor(host, ask) {
    Object.assign(this, { host, ask, candidates: new Map(), lines: 0, busy: false });
    this.verdict = make("section", { class: "verdict", hidden: true, "aria-live": "polite" });
    this.ranking = make("section", { hidden: true });
    this.log = make("ol", { class: "log" });
    this.logSection = make("details", { hidden: true, open: true }, make("summary", {}, "What happened"), this.log);
    this.after = make("div", {});
    this.options = this.form();
    host.append(this.verdict, this.options, this.ranking, this.after, this.logSection);
  }

  form() {
    this.limit = make("input", { type: "number", min: "0", step: "any", size: 5, placeholder: "none", "aria-label": "Time limit in minutes" });
    this.exclude = make("div", { class: "families" });
    this.expect = make("div", { class: "families" });
    return make("details", { class: "options", open: true }, make("summary", {}, "Before a diagnosis"),
      make("p", {}, "Diagnose refits the model, tries every effect of the catalogue beside it, and says which one the data ask for, or that nothing is missing, or that the catalogue does not hold it."),
      make("label", { class: "line" }, "time limit", this.limit, "min"),
      make("details", {}, make("summary", {}, "Known not to be missing"), this.exclude),
      make("details", {}, make("summary", {}, "Likely to be missing"), this.expect));
  }

  study(study) {
    const families = study.families ?? [...new Set((study.effects ?? []).map((e) => e.family))];
    const key = families.join();
    if (!families.length || key === this.key) return;
    this.key = key;
    for (const host of [this.exclude, this.expect]) {
      host.replaceChildren(...families.map((family) => make("label", {}, make("input", { type: "checkbox", value: family }), family.replaceAll("_", " "))));
    }
  }

  /** What the command to diagnose carries. */
  wishes() {
    const of = (host) => [...host.querySelectorAll("input:checked")].map((box) => box.value);
    const minutes = Number(this.limit.value);
    return { time_limit: minutes > 0 ? 60 * minutes : null, exclude: of(this.exclude), expect: of(this.expect) };
  }

  begin() {
    this.candidates.clear();
    this.lines = 0;
    this.log.replaceChildren();
    this.after.replaceChildren();
    this.options.open = false;
    Object.assign(this.verdict, { hidden: true });
    this.drawRanking(true);
  }

  message(line) {
    this.logSection.hidden = false;
    this.log.append(make("li", { class: line.detail || line.kind === "detail" ? "detail" : "" }, line.text));
    if (++this.lines > MOST_LINES) this.log.firstChild.remove();
  }

  candidate(c) {
    this.candidates.set(c.effects.join(" + "), c);
    this.drawRanking(true);
  }

  take(ranking) {
    this.candidates = new Map(ranking.candidates.map((c) => [c.effects.join(" + "), { ...c, state: c.failure ? "failed" : "fitted", reason: c.failure }]));
    this.drawRanking(false);
  }

  drawRanking(running) {
    const all = [...this.candidates.values()];
    this.ranking.hidden = !running && !all.length;
    const order = (c) => ({ fitted: 0, trying: 1, failed: 2 })[c.state ?? "fitted"];
    if (running) all.sort((a, b) => order(a) - order(b) || (a.delta_bic ?? 0) - (b.delta_bic ?? 0));
    const rows = all.map((c) => this.row(c, running));
    const body = (part) => make("table", { class: "ranking" }, ranks(), make("tbody", {}, part));
    const title = make("h2", {}, running ? "Effects as they are tried" : "Which effects explain it");
    const waiting = running && !all.length ? make("p", { class: "soft" }, "The base model is fitted first.") : "";
    const rest = rows.slice(SHOWN);
    this.ranking.replaceChildren(title, waiting, rows.length ? body(rows.slice(0, SHOWN)) : "",
      rest.length ? make("details", {}, make("summary", {}, `${rest.length} more, with less evidence`), body(rest)) : "",
      rows.length ? make("p", { class: "soft" }, "Δ BIC: the evidence against the base model; negative is better, below −10 is very strong.") : "");
  }

  row(c, running) {
    const bar = make("meter", { min: 0, max: 1, "aria-label": "error explained" });
    bar.value = Math.max(0, Math.min(1, c.explained ?? 0));
    const share = c.state === "trying" ? "…" : c.state === "failed" ? "failed" : `${Math.round(100 * (c.explained ?? 0))} %`;
    const name = c.effects.join(" + ");
    const use = running || c.state === "failed" || !c.effects.length ? "" : make("button", { type: "button", disabled: this.busy, onclick: () => this.ask("take", { candidate: c.effects }), "aria-label": `Take ${name} into the model` }, "Take");
    return make("tr", { class: c.added ? "added" : c.state === "failed" ? "failed" : "", title: c.reason ?? (c.own ?? []).join("\n") },
      make("td", {}, make("b", {}, name), make("small", {}, `${(c.family ?? "").replaceAll("_", " ")}${c.balance ? `, ${c.balance.replaceAll("_", " ")} balance` : ""}`)),
      make("td", { class: "n" }, bar, make("span", { class: "share" }, share)),
      make("td", { class: "n" }, number(c.delta_bic)), make("td", { class: "n" }, c.chi2 ?? ""), make("td", { class: "n" }, c.holdout ?? ""), make("td", {}, use));
  }

  show(verdict) {
    this.verdict.hidden = false;
    this.verdict.className = `verdict ${verdict.kind}`;
    const { head, rest } = verdictParts(verdict);
    this.verdict.replaceChildren(...head);
    this.after.replaceChildren(...rest);
    this.options.open = false;
    this.logSection.open = false;
  }

  lock(busy) {
    this.busy = busy;
    for (const control of this.host.querySelectorAll(".options input, .ranking button")) control.disabled = busy;
  }
}

const ranks = () => make("thead", {}, make("tr", {}, make("th", {}, "effects in the model"), make("th", { class: "n" }, "error explained"),
  make("th", { class: "n" }, "Δ BIC"), make("th", { class: "n" }, "χ² fit"), make("th", { class: "n" }, "χ² held out"), make("th", {}, "")));
