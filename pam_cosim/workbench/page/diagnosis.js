// The diagnosis: what to leave out of it, what happens, the ranking as it grows, the verdict with its reasons.

import { make, say } from "./element.js";
import { ranking } from "./ranking.js";
import { verdictParts } from "./verdict.js";

const MOST_LINES = 500;

export class Diagnosis {
  constructor(host, ask) {
    Object.assign(this, { host, ask, busy: false, running: false });
    this.verdict = make("section", { class: "verdict", hidden: true, "aria-live": "polite" });
    this.ranking = make("section", { hidden: true });
    this.log = make("ol", { class: "log" });
    this.logSection = make("details", { hidden: true }, make("summary", {}, "What happened, line by line"), this.log);
    this.after = make("div", {});
    this.checked = make("section", { hidden: true });
    this.options = this.form();
    host.append(this.verdict, this.options, this.checked, this.ranking, this.after, this.logSection);
  }

  form() {
    this.limit = make("input", {
      type: "number",
      min: "0",
      step: "any",
      placeholder: "none",
      "aria-label": "Time limit in minutes",
    });
    this.exclude = make("div", { class: "families" });
    this.expect = make("div", { class: "families" });
    this.check = make("button", { type: "button", onclick: () => this.ask("check") }, "Check");
    return make(
      "details",
      { class: "options", open: true },
      make("summary", {}, "Before a diagnosis"),
      make(
        "p",
        {},
        "Diagnose refits the model, tries every effect of the catalogue beside it, and says " +
          "which one the data ask for, that nothing is missing, or that the catalogue does not hold it. " +
          "It goes on when this page is closed.",
      ),
      make("p", {}, "Check says first what these data can tell at all. ", this.check),
      make("label", { class: "line" }, "time limit", this.limit, "min"),
      make("details", {}, make("summary", {}, "Known not to be missing"), this.exclude),
      make("details", {}, make("summary", {}, "Likely to be missing"), this.expect),
    );
  }

  study(study) {
    const key = (study.families ?? []).join();
    if (!key || key === this.key) return;
    this.key = key;
    for (const host of [this.exclude, this.expect]) {
      host.replaceChildren(
        ...study.families.map((family) =>
          make("label", {}, make("input", { type: "checkbox", value: family }), family.replaceAll("_", " ")),
        ),
      );
    }
  }

  /** What the command to diagnose carries. */
  wishes() {
    const of = (host) => [...host.querySelectorAll("input:checked")].map((box) => box.value);
    const minutes = Number(this.limit.value);
    return { time_limit: minutes > 0 ? 60 * minutes : null, exclude: of(this.exclude), expect: of(this.expect) };
  }

  begin() {
    if (this.running) return;
    this.running = true;
    this.log.replaceChildren();
    this.after.replaceChildren();
    this.verdict.hidden = true;
    this.options.open = false;
    this.rank({ candidates: [], failed: [], final: false });
  }

  end() {
    this.running = false;
    if (!this.ranked?.candidates.length) this.ranking.hidden = true;
    else this.rank(this.ranked);
  }

  message(line) {
    this.logSection.hidden = false;
    this.log.append(make("li", { class: line.kind }, line.text));
    if (this.log.childElementCount > MOST_LINES) this.log.firstChild.remove();
    this.log.scrollTop = this.log.scrollHeight;
  }

  candidate(c) {
    this.latest = c.effects.join(" + ");
  }

  rank(ranked) {
    this.ranked = ranked;
    this.ranking.hidden = !this.running && !ranked.candidates.length;
    this.ranking.replaceChildren(
      ...ranking(ranked, {
        running: this.running,
        latest: this.latest,
        busy: this.busy,
        take: (effects) => this.ask("take", { candidate: effects }),
      }),
    );
  }

  show(verdict) {
    this.verdict.hidden = false;
    this.verdict.className = `verdict ${verdict.kind}`;
    const { head, rest } = verdictParts(
      verdict,
      () => this.ask("take", { candidate: verdict.effects }),
      () => this.ask("add", { learned: true }),
    );
    this.verdict.replaceChildren(...head);
    this.after.replaceChildren(...rest);
    this.options.open = false;
  }

  told(checked) {
    this.checked.hidden = false;
    this.checked.replaceChildren(make("h2", {}, "What these data can tell"), make("pre", {}, checked.text));
    this.options.open = false;
  }

  /** As before anything began: what happened is told again. */
  restart() {
    this.running = false;
    this.log.replaceChildren();
  }

  forget() {
    this.ranked = null;
    this.verdict.hidden = this.ranking.hidden = true;
    this.after.replaceChildren();
  }

  lock(busy) {
    this.busy = busy;
    for (const control of this.host.querySelectorAll(
      ".options input, .options button, .ranking button, .verdict button",
    ))
      control.disabled = busy;
  }
}
