// Right, below: effects of the catalogue as switches, with their equation and fingerprint.

import { make } from "./element.js";

export class Effects {
  constructor(host, ask) {
    Object.assign(this, { host, ask, busy: false, open: new Set() });
    this.search = make("input", {
      type: "search",
      placeholder: "search effects",
      "aria-label": "Search effects",
      oninput: () => this.list(),
    });
    this.all = make("div", { class: "effect-list" });
    host.append(make("div", { class: "head" }, make("h2", {}, "Effects"), this.search), this.all);
  }

  study(study) {
    const effects = study.effects?.length ? study.effects : (this.effects ?? []);
    const key = JSON.stringify(effects.map((e) => [e.name, e.on, e.fits]));
    if (key === this.key) return;
    Object.assign(this, { effects, key });
    this.list();
  }

  on() {
    return (this.effects ?? []).filter((e) => e.on).map((e) => e.name);
  }

  list() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fitting = (this.effects ?? []).filter((e) => e.on || (e.fits && words.every((w) => searched(e).includes(w))));
    const on = fitting.filter((e) => e.on),
      families = new Map();
    for (const e of fitting.filter((e) => !e.on)) families.set(e.family, [...(families.get(e.family) ?? []), e]);
    const groups = [...families].map(([family, members]) => this.family(family, members, words.length > 0));
    this.all.replaceChildren(...on.map((e) => this.effect(e)), ...groups);
    if (!fitting.length)
      this.all.append(
        make(
          "p",
          { class: "soft" },
          words.length ? "No effect has these words." : "No effect finds a place in this model.",
        ),
      );
    this.lock(this.busy);
  }

  family(family, members, open) {
    const details = make(
      "details",
      {
        class: "family",
        open: open || this.open.has(family),
        ontoggle: () => (details.open ? this.open.add(family) : this.open.delete(family)),
      },
      make("summary", {}, family.replaceAll("_", " "), make("small", { class: "soft" }, ` ${members.length}`)),
      members.map((e) => this.effect(e)),
    );
    return details;
  }

  effect(e) {
    const box = make("input", {
      type: "checkbox",
      checked: e.on,
      "data-effect": e.name,
      onchange: () => this.switch(e.name, box),
    });
    const equation = Array.isArray(e.equation) ? e.equation.join("\n") : e.equation;
    const about = make(
      "details",
      { class: "about" },
      make("summary", {}, "equation and fingerprint"),
      equation ? make("pre", {}, make("code", {}, equation)) : "",
      e.fingerprint ? make("p", {}, e.fingerprint) : "",
      e.source ? make("p", { class: "soft" }, e.source) : "",
    );
    return make(
      "div",
      { class: e.on ? "effect on" : "effect" },
      make("label", {}, box, make("span", {}, e.name)),
      e.description ? make("p", { class: "soft" }, e.description) : "",
      about,
    );
  }

  async switch(name, box) {
    const on = new Set(this.on());
    if (box.checked) on.add(name);
    else on.delete(name);
    if (!(await this.ask("switch", { effects: [...on] }))) box.checked = !box.checked;
  }

  lock(busy) {
    this.busy = busy;
    for (const box of this.all.querySelectorAll("input")) box.disabled = busy;
  }
}

const searched = (e) =>
  `${e.name} ${e.family.replaceAll("_", " ")} ${e.balance} ${e.description ?? ""} ${e.fingerprint ?? ""}`.toLowerCase();
