// Left: the runs with role and error, and the rules that say where the error sits.

import { make } from "./element.js";
import { number } from "./numbers.js";

export class Runs {
  /** `ask` sends commands. */
  constructor(host, view, ask) {
    Object.assign(this, { host, view, ask, rows: new Map() });
    view.listeners.push((onlyCursor) => onlyCursor || this.mark());
  }

  study(study) {
    const key = JSON.stringify([study.runs.map((r) => [r.name, r.role]), study.signals.map((s) => [s.name, s.unit])]);
    this.signals = study.signals;
    if (key === this.key) return;
    this.key = key;
    this.rows.clear();
    const names = study.signals.map((s) => make("th", { class: "n" }, s.name, s.unit ? make("small", {}, s.unit) : ""));
    const head = make(
      "thead",
      {},
      make(
        "tr",
        {},
        make("th", {}, "run"),
        make(
          "th",
          { class: "n", title: "No parameter is fitted to a run that is held out" },
          "held",
          make("small", {}, "out"),
        ),
        names,
      ),
    );
    const body = make(
      "tbody",
      {},
      study.runs.map((run) => this.row(run, study.signals)),
    );
    this.host.replaceChildren(make("table", { class: "run-table" }, head, body));
    if (this.scores) this.show(this.scores);
  }

  row(run, signals) {
    const cells = signals.map(() => make("td", { class: "n" }));
    const name = make(
      "button",
      { type: "button", class: "link", title: run.describe ?? "", onclick: () => this.zoom(run.name) },
      run.name,
    );
    const role = make("input", {
      type: "checkbox",
      checked: run.role === "holdout",
      "aria-label": `Hold out ${run.name}`,
      onchange: (e) => this.ask("roles", { roles: { [run.name]: e.target.checked ? "holdout" : "fit" } }),
    });
    const element = make("tr", { class: "run" }, make("td", {}, name), make("td", { class: "n" }, role), cells);
    this.rows.set(run.name, { element, cells });
    return element;
  }

  zoom(name) {
    const run = this.view.runs.find((r) => r.name === name);
    const alone =
      run &&
      Math.abs(this.view.to - this.view.from - 1.01 * run.span) < 0.05 * run.span &&
      this.view.from > run.start - 0.1 * run.span &&
      this.view.to < run.start + 1.1 * run.span;
    if (alone && this.view.runs.length > 1) this.view.whole();
    else this.view.showRun(name);
  }

  show(scores) {
    this.scores = scores;
    const failed = new Map((scores.failed ?? []).map((f) => [f.run, f.text]));
    for (const [name, { element, cells }] of this.rows) {
      const words = failed.get(name);
      element.classList.toggle("failed", Boolean(words));
      element.title = words ?? "";
      this.signals.forEach((signal, i) => {
        const error = scores.runs?.[name]?.[signal.name];
        cells[i].textContent = words ? (i ? "" : "failed") : number(error);
        cells[i].classList.toggle("far", !words && signal.noise > 0 && error > 2 * signal.noise);
      });
    }
  }

  mark() {
    const visible = new Set(this.view.isWhole() ? [] : this.view.visible().map((r) => r.name));
    for (const [name, { element }] of this.rows) element.classList.toggle("shown", visible.has(name));
  }
}

export class Rules {
  constructor(host, view) {
    Object.assign(this, { host, view, lit: null });
    this.none("No run has been simulated yet.");
  }

  none(words) {
    this.host.replaceChildren(make("p", { class: "soft" }, words));
  }

  show(where) {
    const lit = this.lit;
    this.lit = null;
    if (!where.rules.length) this.none("No part of the measurement holds more than its share of the error.");
    else
      this.host.replaceChildren(
        make(
          "ul",
          { class: "rules" },
          where.rules.map((rule) => make("li", {}, this.button(rule, lit))),
        ),
      );
    if (this.lit === null) this.view.light(null);
  }

  button(rule, lit) {
    const key = `${rule.signal}: ${rule.rule}`;
    const share = `${percent(rule.error_share)} of its error in ${percent(rule.time_share)} of the samples`;
    const button = make(
      "button",
      { type: "button", "aria-pressed": "false", onclick: () => this.press(button, rule, key) },
      make("span", {}, make("b", {}, rule.signal), ` ${rule.rule}`),
      make("small", {}, share),
    );
    if (key === lit) this.press(button, rule, key);
    return button;
  }

  press(button, rule, key) {
    const on = button.getAttribute("aria-pressed") !== "true";
    for (const other of this.host.querySelectorAll("button")) other.setAttribute("aria-pressed", "false");
    button.setAttribute("aria-pressed", String(on));
    this.lit = on ? key : null;
    this.view.light(on ? rule.ranges : null);
  }
}

const percent = (share) => `${Math.round(100 * share)} %`;
