// Recordings dropped on the page become a data set: what was recognised, what is asked, what is wrong and where.

import { cells } from "./advice.js";
import { draftParts } from "./draft.js";
import { make, say, table } from "./element.js";

const PAUSE = 600; // ms after the last change, when what becomes of the files is asked for again

export class DropPage {
  /** `ask` sends commands; `alert` says what is wrong. */
  constructor(host, ask, alert) {
    Object.assign(this, { host, ask, alert, wishes: { columns: {}, parameters: {}, recording: {}, roles: {} } });
    this.input = make("input", {
      type: "file",
      multiple: true,
      id: "recordings",
      class: "hidden-input",
      onchange: () => this.send(this.input.files),
    });
    this.zone = make(
      "label",
      { class: "zone", for: "recordings" },
      make("b", {}, "Drop the recordings of your rig here"),
      make(
        "span",
        { class: "soft" },
        "or press Enter to choose files: CSV, tab-separated text, TDMS, MAT, HDF5, Parquet; one for each run",
      ),
      this.input,
    );
    this.list = make("ul", { class: "files" });
    this.found = make("div", { class: "draft", "aria-live": "polite" });
    this.name = make("b", {});
    host.append(make("h2", {}, "A new data set: ", this.name), this.zone, this.list, this.found);
    for (const kind of ["dragenter", "dragover", "dragleave", "drop"])
      host.addEventListener(kind, (event) => this.drag(event));
  }

  study(study) {
    say(this.name, study.folder);
  }

  drag(event) {
    event.preventDefault();
    this.zone.classList.toggle("over", event.type === "dragover" || event.type === "dragenter");
    if (event.type === "drop") this.send(event.dataTransfer.files);
  }

  async send(files) {
    let taken = false;
    for (const file of [...files]) {
      say(this.found, `Reading ${file.name} …`);
      const answer = await fetch(`drop?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file });
      if (answer.ok) taken = true;
      else this.alert((await answer.json().catch(() => null))?.failed ?? { text: `${file.name} was refused` });
    }
    this.input.value = "";
    // The list of files comes over the socket, and may come later than this answer.
    if (taken || this.files?.length) this.request();
    else this.found.replaceChildren();
  }

  dropped(event) {
    this.files = event.files;
    const remove = (name) =>
      make(
        "button",
        { type: "button", class: "link", "aria-label": `Remove ${name}`, onclick: () => this.remove(name) },
        "remove",
      );
    this.list.replaceChildren(
      ...event.files.map((file) =>
        make(
          "li",
          {},
          make(
            "details",
            {},
            make("summary", {}, file.name, make("small", {}, ` ${size(file.bytes)}`), " ", remove(file.name)),
            file.lines.length
              ? table(cells(file.lines)[0], cells(file.lines).slice(1))
              : make("p", { class: "soft" }, "no text: it is read whole"),
          ),
        ),
      ),
    );
    if (!event.files.length) this.found.replaceChildren();
  }

  async remove(name) {
    if (await this.ask("remove", { names: [name] })) this.again();
  }

  /** Asks anew what becomes of the files, a moment after the last change. */
  later() {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.again(), PAUSE);
  }

  again() {
    if (this.files?.length !== 0) this.request();
  }

  request() {
    this.found.classList.add("waiting");
    this.ask("draft", { wishes: this.wishes });
  }

  draft(draft) {
    this.found.classList.remove("waiting");
    const focus = document.activeElement?.dataset?.wish;
    const change = (group, name, value) => this.wish(group, name, value);
    const open = new Set([...this.found.querySelectorAll("details[open] > summary")].map((one) => one.textContent));
    const parts = draftParts(draft, this.wishes, change, this.files ?? []);
    this.create = make(
      "button",
      { type: "button", class: "main", disabled: Boolean(draft.failed), onclick: () => this.make() },
      "Make the data set",
    );
    this.found.replaceChildren(...parts, make("p", { class: "buttons" }, this.create));
    for (const summary of this.found.querySelectorAll("details > summary"))
      summary.parentElement.open = open.has(summary.textContent);
    if (focus) this.found.querySelector(`[data-wish="${CSS.escape(focus)}"]`)?.focus();
  }

  /** What a person says goes before what was recognised; "" takes it back. */
  wish(group, name, value) {
    if (!name) this.wishes[group] = value;
    else if (value) this.wishes[group][name] = value;
    else delete this.wishes[group][name];
    this.later();
  }

  async make() {
    this.create.disabled = true;
    this.create.textContent = "Making it …";
    if (!(await this.ask("create", { wishes: this.wishes }))) {
      this.create.disabled = false;
      this.create.textContent = "Make the data set";
    }
  }
}

function size(bytes) {
  return bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}
