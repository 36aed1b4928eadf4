// Files of a measurement dropped on the page become a data set: what was recognised, what is asked, what is wrong.

import { make, table } from "./element.js";

export class DropPage {
  constructor(host, ask) {
    Object.assign(this, { host, ask, files: new Map() });
    this.input = make("input", { type: "file", multiple: true, accept: ".csv,.tsv,.txt,.tdms,.mat,.h5,.parquet", onchange: () => this.take(this.input.files), id: "files", class: "hidden-input" });
    this.zone = make("label", { class: "zone", for: "files" }, make("b", {}, "Drop the recordings here"), make("span", {}, "or choose files: a CSV for each run, with a time column"), this.input);
    this.found = make("div", {});
    host.append(make("h2", {}, "A data set from your files"), this.zone, this.found);
    for (const name of ["dragover", "dragleave", "drop"]) this.zone.addEventListener(name, (event) => this.drag(event));
  }

  study() {}

  drag(event) {
    event.preventDefault();
    this.zone.classList.toggle("over", event.type === "dragover");
    if (event.type === "drop") this.take(event.dataTransfer.files);
  }

  async take(files) {
    for (const file of files) {
      const answer = await fetch(`drop?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file });
      if (!answer.ok) this.problem(await answer.json().catch(() => ({ text: `${file.name} was refused` })));
    }
    const draft = await this.ask("draft", {}, (problem) => this.problem(problem));
    if (draft) this.draft(draft);
  }

  problem(problem) {
    this.found.replaceChildren(make("p", { class: "caution", role: "alert" }, [problem.file, problem.line ? `line ${problem.line}` : "", problem.column ? `column ${problem.column}` : ""].filter(Boolean).join(", "), ": ", problem.text));
  }

  draft() {}
}
