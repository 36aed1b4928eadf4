// Right: the bench, how to fit, and each parameter with its slider, bounds and interval.

import { make } from "./element.js";
import { number, plain } from "./numbers.js";
import { typed } from "./whole.js";

const STEPS = 1000; // of a slider
const DIGITS = 4; // of a value that is dragged
const SMALL = 0.05; // of a range from zero, below which a slider moves by the cube root
const USUAL = "least-squares";
const DECADES = 1.3; // of the bounds, from which on a slider moves by order of magnitude

export class Parameters {
  /** `set(values)` sends values, `ask` commands. */
  constructor(host, set, ask) {
    Object.assign(this, { host, set, ask, rows: new Map(), held: new Set(), busy: false });
  }

  study(study) {
    const key = JSON.stringify([
      study.model,
      study.benches,
      study.methods,
      study.parameters.map((p) => [p.name, p.unit, p.effect]),
    ]);
    if (key !== this.key) {
      this.key = key;
      this.build(study);
    }
    for (const p of study.parameters) this.rows.get(p.name)?.take(p);
    this.lock(this.busy);
  }

  build(study) {
    this.rows.clear();
    const rows = study.parameters.map((p) => {
      const row = new Row(p, this.set, !this.held.has(p.name), (free) =>
        free ? this.held.delete(p.name) : this.held.add(p.name),
      );
      this.rows.set(p.name, row);
      return row.element;
    });
    this.reset = make(
      "button",
      { type: "button", onclick: () => this.ask("reset", { names: [...this.rows.keys()] }) },
      "Reset",
    );
    this.host.replaceChildren(
      make("h2", {}, "Model"),
      this.bench(study),
      this.method(study),
      make("div", { class: "head" }, make("h2", {}, "Parameters"), this.reset),
      study.parameters.length
        ? make("div", { class: "parameters" }, rows)
        : make("p", { class: "soft" }, "No parameter is free: name some under [fit] in experiment.toml."),
    );
  }

  bench(study) {
    const { short } = study;
    const names = [...new Set([short, ...study.benches])];
    this.choice = make(
      "select",
      { id: "bench", onchange: (e) => this.ask("choose", { model: e.target.value }) },
      names.map((name) => make("option", { value: name, selected: name === short }, name)),
    );
    return make("label", { class: "line" }, "bench", this.choice);
  }

  method(study) {
    if (!study.methods?.length) return "";
    this.fitBy = make(
      "select",
      { id: "method" },
      study.methods.map((name) => make("option", { value: name, selected: name === USUAL }, name)),
    );
    return make("label", { class: "line" }, "fit by", this.fitBy);
  }

  /** Values while something runs. */
  values(values) {
    for (const [name, value] of Object.entries(values ?? {})) this.rows.get(name)?.move(value);
  }

  free() {
    return [...this.rows].filter(([, row]) => row.fitted.checked).map(([name]) => name);
  }

  lock(busy) {
    this.busy = busy;
    for (const control of this.host.querySelectorAll("input, select, button")) control.disabled = busy;
  }
}

/** A value with its slider; with `choose`, whether a fit may move it can be said. */
export class Row {
  constructor(p, set, free, choose) {
    Object.assign(this, { p, set });
    const label = `${p.name}${p.unit ? `, ${p.unit}` : ""}`;
    this.fitted =
      choose &&
      make("input", {
        type: "checkbox",
        checked: free,
        onchange: () => choose(this.fitted.checked),
        title: "A fit may move it",
        "aria-label": `A fit may move ${p.name}`,
      });
    this.number = make("input", {
      type: "text",
      inputmode: "decimal",
      "aria-label": label,
      onchange: () => this.typed(),
      onblur: () => this.move(this.current),
    });
    this.slider = make("input", {
      type: "range",
      min: "0",
      max: String(STEPS),
      step: "1",
      "aria-label": label,
      "data-parameter": p.name,
      oninput: () => this.dragged(),
    });
    this.band = make("div", { class: "interval" });
    this.note = make("p", { class: "note" });
    this.element = make(
      "div",
      { class: "parameter", title: p.description ?? "" },
      make(
        "div",
        { class: "parameter-head" },
        make(
          "label",
          {},
          this.fitted,
          make("span", {}, make("code", {}, p.label ?? p.name), p.effect ? make("small", {}, p.effect) : ""),
        ),
        this.number,
        make("span", { class: "unit" }, p.unit),
      ),
      make("div", { class: "track" }, this.band, this.slider),
      this.note,
    );
    this.take(p);
  }

  take(p) {
    this.p = p;
    const room = p.low > 0 && Math.log10(p.high / p.low) > DECADES;
    this.logarithmic = p.logarithmic ?? room;
    if (p.low === 0 && p.value > 0) this.power ??= p.value < SMALL * p.high ? 3 : 1;
    this.move(p.value);
    const known = Number.isFinite(p.low95) && Number.isFinite(p.high95) && p.low95 !== null && p.high95 !== null;
    this.band.hidden = !known;
    if (known) {
      const [a, b] = [p.low95, p.high95].map((v) => Math.min(1, Math.max(0, this.share(v))));
      this.band.style.left = `calc(8px + (100% - 16px) * ${a})`;
      this.band.style.width = `calc((100% - 16px) * ${Math.max(b - a, 0.004)})`;
    }
    const interval = known ? `95 %: ${number(p.low95)} … ${number(p.high95)}` : "";
    this.note.replaceChildren(
      make("span", {}, number(p.low)),
      make("span", { class: p.remark ? "remark" : "" }, [interval, p.remark].filter(Boolean).join("; ")),
      make("span", {}, number(p.high)),
    );
  }

  move(value) {
    this.current = value;
    if (document.activeElement !== this.number) this.number.value = plain(value, DIGITS);
    if (!this.held) this.slider.value = String(Math.round(STEPS * this.share(value)));
    this.slider.setAttribute("aria-valuetext", `${number(value)} ${this.p.unit}`.trim());
  }

  dragged() {
    this.held = true;
    clearTimeout(this.release);
    this.release = setTimeout(() => (this.held = false), 300);
    const value = this.at(Number(this.slider.value) / STEPS);
    this.number.value = plain(value, DIGITS);
    this.set({ [this.p.name]: Number(plain(value, DIGITS)) });
  }

  typed() {
    const value = typed(this.number.value);
    if (value !== null) this.set({ [this.p.name]: value }, true);
  }

  share(value) {
    const { low, high } = this.p;
    return this.logarithmic
      ? Math.log(value / low) / Math.log(high / low)
      : Math.max(0, (value - low) / (high - low)) ** (1 / (this.power ?? 1));
  }

  at(share) {
    const { low, high } = this.p;
    return this.logarithmic ? low * (high / low) ** share : low + share ** (this.power ?? 1) * (high - low);
  }
}
