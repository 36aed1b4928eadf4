// Left: how each run begins and from when to when it goes, its start values as sliders.

import { make, say } from "./element.js";
import { moment } from "./numbers.js";
import { Row } from "./parameters.js";

export class Starts {
  /** `set(values)` sends values, `ask` commands; `view` knows from when to when runs were recorded. */
  constructor(host, view, set, ask) {
    Object.assign(this, { host, view, set, ask, parts: new Map(), runs: new Map(), busy: false });
  }

  /** Runs of a study. */
  study(study) {
    this.runs = new Map(study.runs.map((run) => [run.name, run]));
    for (const part of this.parts.values()) part.ends(this.runs.get(part.name));
  }

  /** How they begin. */
  show(event) {
    const key = JSON.stringify(event.runs.map((s) => [s.run, s.modes, s.values.map((v) => [v.name, v.unit])]));
    if (key !== this.key) {
      this.key = key;
      const open = new Set([...this.parts.values()].filter((part) => part.element.open).map((part) => part.name));
      this.parts = new Map(event.runs.map((start) => [start.run, new Part(this, start, open.has(start.run))]));
      this.host.hidden = !event.runs.length;
      this.host.replaceChildren(make("h2", {}, "Where runs begin"), ...[...this.parts.values()].map((p) => p.element));
    }
    for (const start of event.runs) this.parts.get(start.run).take(start);
    this.lock(this.busy);
  }

  /** Keeps of a run what lies between two times [s]. */
  cut(name, { begin, end }) {
    const run = this.runs.get(name),
      laid = this.view.runs.find((one) => one.name === name);
    const near = 1e-4 * laid.span;
    const from = begin ?? run.begins,
      to = end ?? run.ends;
    this.ask("cut", { run: name, begin: from <= laid.low + near ? null : from, end: to >= laid.high - near ? null : to });
  }

  lock(busy) {
    this.busy = busy;
    for (const control of this.host.querySelectorAll("input, select")) control.disabled = busy;
  }
}

/** One run. */
class Part {
  constructor(starts, start, open) {
    this.name = start.run;
    this.modes = start.modes;
    this.said = make("small", {});
    this.text = make("p", { class: "soft" });
    this.mode = make("select", {
      "aria-label": `How ${this.name} begins`,
      onchange: (e) => starts.ask("begin", { run: this.name, mode: e.target.value }),
    });
    this.fields = ["begin", "end"].map((side) =>
      make("input", {
        type: "number",
        step: "any",
        "aria-label": `${side === "begin" ? "First" : "Last"} time of ${this.name}, s`,
        onchange: (e) => this.typed(starts, side, e.target),
      }),
    );
    this.rows = new Map(start.values.map((value) => [value.name, new Row(value, starts.set)]));
    this.element = make(
      "details",
      { class: "start", "data-run": this.name, open },
      make("summary", {}, make("b", {}, this.name), " ", this.said),
      this.text,
      make("label", { class: "line" }, "begins", this.mode),
      make("div", { class: "line" }, "from", this.fields[0], "to", this.fields[1], "s"),
      ...[...this.rows.values()].map((row) => row.element),
    );
    this.ends(starts.runs.get(this.name));
  }

  take(start) {
    const kinds = [...new Set([start.mode, ...this.modes])];
    const key = kinds.join();
    if (key !== this.key) {
      this.key = key;
      this.mode.replaceChildren(...kinds.map((kind) => make("option", { value: kind }, kind)));
    }
    this.mode.value = start.mode;
    say(this.said, brief(start));
    say(this.text, start.text);
    this.text.hidden = start.text.endsWith(brief(start));
    this.element.classList.toggle("warning", start.warning);
    for (const value of start.values) this.rows.get(value.name)?.take(value);
  }

  /** From when to when it goes. */
  ends(run) {
    if (!run) return;
    this.run = run;
    for (const [i, value] of [run.begins, run.ends].entries())
      if (document.activeElement !== this.fields[i]) this.fields[i].value = String(moment(value, run.ends - run.begins));
  }

  typed(starts, side, field) {
    const value = Number(field.value);
    if (field.value.trim() === "" || !Number.isFinite(value)) this.ends(this.run);
    else starts.cut(this.name, { [side]: value });
  }
}

/** The sentence without the name that stands before it. */
function brief(start) {
  const begins = `${start.run} begins `;
  return start.values.length && start.mode !== "rest" && start.mode !== "by hand" && start.text.startsWith(begins)
    ? start.text.slice(begins.length)
    : start.mode;
}
