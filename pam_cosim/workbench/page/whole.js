// The whole study: every parameter with its source, every signal with its switch, every run with its role and times.

import { fields, make } from "./element.js";
import { number, plain } from "./numbers.js";

const GIVEN = /^\s*[-+]?[\d.]+(e[-+]?\d+)?\s*$/i;

/** What was typed: a number in the shown unit, or a text with a unit, which the server reads; null: nothing. */
export function typed(text) {
  const number = Number(text);
  return text.trim() === "" ? null : GIVEN.test(text) && Number.isFinite(number) ? number : text.trim();
}

export class Whole {
  /** `set(values, typed)` sends values, `ask` commands. */
  constructor(host, set, ask) {
    Object.assign(this, { host, set, ask, busy: false });
    this.search = make("input", {
      type: "search",
      placeholder: "filter by name",
      "aria-label": "Filter parameters",
      oninput: () => this.filter(),
    });
    this.tables = make("div", {});
    host.append(make("h2", {}, "The whole study"), this.tables);
  }

  study(study) {
    const key = JSON.stringify([study.parameters, study.held, study.signals, study.runs]);
    if (key === this.key) return;
    Object.assign(this, { key, now: study });
    const focus = document.activeElement?.getAttribute("aria-label");
    this.tables.replaceChildren(
      make("div", { class: "head" }, make("h3", {}, "Parameters"), this.search),
      fields(["free", "parameter", "value", "unit", "bounds", "where it comes from"], this.parameters(study), "fieldset"),
      make("h3", {}, "Signals"),
      fields(["fitted", "signal", "noise σ", "unit", ""], study.signals.map((one) => this.signal(one)), "fieldset"),
      make("h3", {}, "Runs"),
      fields(["held out", "run", "from", "to", ""], study.runs.map((one) => this.run(one)), "fieldset"),
    );
    this.filter();
    this.lock(this.busy);
    if (focus) [...this.tables.querySelectorAll("input")].find((one) => one.getAttribute("aria-label") === focus)?.focus();
  }

  parameters({ parameters, held }) {
    const free = parameters.filter((p) => !p.effect).map((p) => p.name);
    const rows = [
      ...parameters.map((p) => ({
        ...p,
        is_free: true,
        bounded: !p.effect,
        source: p.effect ? `effect ${p.effect}` : "free",
        bounds: `${number(p.low)} … ${number(p.high)}`,
      })),
      ...held,
    ];
    return rows.map((p) => {
      const several = held.filter((one) => one.name === p.name).length > 1;
      const box = make("input", {
        type: "checkbox",
        checked: Boolean(p.is_free),
        disabled: !p.bounded || several,
        title: several ? "runs have values of their own" : p.bounded ? "" : p.effect ? "an effect's own" : "it has no bounds",
        "aria-label": `Leave ${p.name} free`,
        onchange: () =>
          this.ask("free", { names: box.checked ? [...free, p.name] : free.filter((one) => one !== p.name) }),
      });
      const field = make("input", {
        type: "text",
        size: 10,
        value: plain(p.value),
        "aria-label": `Value of ${p.name}`,
        onchange: () => this.say(field, this.set({ [p.name]: typed(field.value) }, true)),
      });
      const name = make("td", { title: p.description }, make("code", {}, p.name), make("small", {}, p.description));
      return make(
        "tr",
        { "data-name": `${p.name} ${p.description}`.toLowerCase() },
        make("td", {}, box),
        name,
        make("td", {}, field),
        make("td", {}, p.unit),
        make("td", {}, p.bounds ?? ""),
        make("td", {}, p.source),
      );
    });
  }

  signal(s) {
    const box = make("input", {
      type: "checkbox",
      checked: s.use === "fitted",
      "aria-label": `Fit ${s.name}`,
      onchange: () => this.ask("signal", { name: s.name, fitted: box.checked }),
    });
    const field = make("input", {
      type: "text",
      size: 10,
      value: plain(s.noise),
      "aria-label": `Noise of ${s.name}`,
      onchange: () => this.say(field, this.ask("signal", { name: s.name, sigma: typed(field.value) })),
    });
    return make(
      "tr",
      {},
      make("td", {}, box),
      make("td", {}, make("b", {}, s.name)),
      make("td", {}, field),
      make("td", {}, s.unit),
      make("td", {}, s.quantity),
    );
  }

  run(r) {
    const role = make("input", {
      type: "checkbox",
      checked: r.role === "holdout",
      "aria-label": `Hold out the run ${r.name}`,
      onchange: (e) => this.ask("roles", { roles: { [r.name]: e.target.checked ? "holdout" : "fit" } }),
    });
    const ends = { begin: r.begins, end: r.ends };
    const field = (side) =>
      make("input", {
        type: "text",
        size: 8,
        disabled: r.static,
        value: r.static ? "" : String(Number(ends[side].toPrecision(10))),
        "aria-label": `${side === "begin" ? "Beginning" : "End"} of ${r.name}, s`,
        onchange: (e) => this.say(e.target, this.ask("cut", { run: r.name, ...ends, [side]: typed(e.target.value) })),
      });
    return make(
      "tr",
      {},
      make("td", {}, role),
      make("td", {}, make("b", {}, r.name)),
      make("td", {}, field("begin")),
      make("td", {}, field("end")),
      make("td", { class: "soft" }, r.describe),
    );
  }

  /** What was typed stays, marked, where the server refused it; else the field shows the value that holds. */
  async say(field, answer) {
    const taken = await answer;
    field.setAttribute("aria-invalid", String(!taken));
    if (!taken) return;
    this.key = null;
    this.study(this.now);
  }

  filter() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of this.tables.querySelectorAll("tr[data-name]"))
      row.hidden = !words.every((word) => row.dataset.name.includes(word));
  }

  lock(busy) {
    this.busy = busy;
    for (const field of this.tables.querySelectorAll("fieldset")) field.disabled = busy;
  }
}
