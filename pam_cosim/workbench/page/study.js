// The study itself: the steps that were done, saving and loading, and the script that repeats it.

import { make } from "./element.js";

export class StudyPage {
  constructor(host, ask) {
    Object.assign(this, { host, ask });
    this.steps = make("ol", { class: "steps" });
    this.notes = make("ul", {});
    this.added = make("section", { hidden: true });
    this.script = make("section", {});
    const load = make("button", { type: "button", onclick: () => ask("load") }, "Load what was saved");
    const print = make("button", { type: "button", onclick: () => this.print() }, "Show as script");
    host.append(
      make("h2", { id: "done" }, "What was done"),
      this.steps,
      make("p", {}, load, print),
      this.added,
      this.script,
      make("section", {}, make("h2", {}, "To know about the data"), this.notes),
    );
  }

  study(study) {
    this.notes.replaceChildren(...(study.notes ?? []).map((note) => make("li", {}, note)));
    if (!study.notes?.length) this.notes.replaceChildren(make("li", { class: "soft" }, "Nothing beyond the tables."));
  }

  did(steps) {
    const words = steps.map((step) => (typeof step === "string" ? step : step.text));
    const back = (i) => words.length - 1 - i;
    const button = (i) =>
      make("button", { type: "button", class: "link", onclick: () => this.ask("undo", { count: back(i) }) }, "back to here");
    this.steps.replaceChildren(
      ...words.map((text, i) => make("li", {}, make("code", {}, text), " ", back(i) ? button(i) : "")),
    );
    if (!words.length)
      this.steps.replaceChildren(make("li", { class: "soft" }, "Nothing yet: the model has its start values."));
  }

  wrote({ file, text }) {
    this.added.hidden = false;
    this.added.replaceChildren(make("h2", {}, file), make("pre", {}, make("code", {}, text)));
  }

  async print() {
    const script = await this.ask("script");
    if (!script) return;
    const file = "script.py";
    this.script.replaceChildren(
      make(
        "h2",
        {},
        "As a Python script ",
        make("a", { href: `download/${file}`, download: file, class: "button" }, "Download"),
      ),
      make("pre", {}, make("code", {}, script.python)),
    );
  }
}
