// The dialog that writes the model with its effects as a Modelica file.

import { listed, make } from "./element.js";

const LONGEST = 60; // letters of a name with all effects

export class AddDialog {
  constructor(dialog, ask) {
    Object.assign(this, { dialog, ask });
  }

  /** `on`: effects that are on; `missing`: those of the last verdict; `model`: short name of the base model. */
  open(on, missing, model) {
    const effects = on.length ? on : missing;
    const close = make(
      "button",
      { type: "button", onclick: () => this.dialog.close() },
      effects.length ? "Cancel" : "Close",
    );
    const heading = make("h2", { id: "add-heading" }, "Write the model with its effects");
    if (!effects.length) {
      this.dialog.replaceChildren(
        heading,
        make(
          "p",
          {},
          "No effect is switched on. Switch one on at the right, or take one from the ranking of a diagnosis.",
        ),
        close,
      );
      this.dialog.showModal();
      return;
    }
    this.name = make("input", {
      type: "text",
      required: true,
      value: `${brief(model, effects)}.mo`.replace(/[^\w.]/g, ""),
      "aria-label": "File",
    });
    const form = make(
      "form",
      { onsubmit: (event) => this.write(event, on.length ? null : effects) },
      make(
        "p",
        {},
        `${model} with ${listed(effects)}, as a Modelica class in the folder of the data set.` +
          (on.length ? "" : " The verdict asks for it; the values are those that were fitted."),
      ),
      make("label", { class: "line" }, "file", this.name),
      (this.problem = make("p", { class: "caution", hidden: true, role: "alert" })),
      make("p", { class: "buttons" }, close, make("button", { type: "submit", class: "main" }, "Write")),
    );
    this.dialog.replaceChildren(heading, form);
    this.dialog.showModal();
  }

  /** `taken`: effects of the verdict that the model is given first. */
  async write(event, taken) {
    event.preventDefault();
    const failed = (problem) => Object.assign(this.problem, { hidden: false, textContent: problem.text });
    if (taken && !(await this.ask("take", { candidate: taken }, failed))) return;
    await this.ask("add", { file: this.name.value.trim() }, failed);
  }

  /** The file that was written. */
  wrote({ file, text }) {
    if (!this.dialog.open) return;
    const close = make("button", { type: "button", class: "main", onclick: () => this.dialog.close() }, "Close");
    this.dialog.replaceChildren(
      make("h2", { id: "add-heading" }, `${file} is written`),
      make("pre", { tabIndex: 0 }, make("code", {}, text)),
      make("p", { class: "buttons" }, close),
    );
    close.focus();
  }
}

/** A name for the model, with its effects as long as that stays short. */
function brief(model, effects) {
  const name = model + effects.join("");
  return name.length > LONGEST ? `${model}With${effects.length}Effects` : name;
}
