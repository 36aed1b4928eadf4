// The middle of the page: for each signal measured against model, residual and error map, all zoomed together.

import { drawAxis, drawNames } from "./axis-charts.js";
import { Detail } from "./detail.js";
import { make, say } from "./element.js";
import { Plane, cellAt } from "./error-map.js";
import { quantity } from "./numbers.js";
import { palette } from "./palette.js";
import { followKeys, followPointer } from "./pointer.js";
import { drawSignal, readOut, scale } from "./signal-chart.js";

const MAP =
  "Mean of measured − model in the times that are shown, in standard deviations of the noise (σ). " +
  "Click a cell to light up when the rig was there.";
const BELOW = "below: measured − model, band ± 2 σ of the noise";
const SCREEN = 16; // ms between two pictures of a screen: what comes later than that is drawn at once
const KEYS = "Curves. Arrows move, plus and minus zoom, Home shows all runs, Shift and arrows read values.";

export class Curves {
  /** `cut(run, {begin, end})` is told the end of a run that was dragged; `ask` sends commands. */
  constructor(host, view, cut, ask) {
    Object.assign(this, {
      host,
      view,
      cut,
      ask,
      signals: [],
      rows: [],
      frames: {},
      labels: {},
      asked: 0,
      drawn: 0,
      colours: palette(),
      version: -1,
    });
    this.detail = new Detail(ask, () => this.later());
    this.names = make("canvas", { class: "names", "aria-hidden": "true" });
    this.axis = make("canvas", { class: "axis", "aria-hidden": "true" });
    this.stack = make("div", { class: "stack", tabIndex: 0, role: "group", "aria-label": KEYS });
    host.append(this.names, this.stack, this.axis);
    followKeys(this.stack, view);
    view.listeners.push(() => this.later());
    new ResizeObserver(() => this.later()).observe(host);
    matchMedia("(resolution: 1dppx)").addEventListener("change", () => this.later());
  }

  /** Runs and signals of a study. */
  study(study) {
    const key = JSON.stringify(study.signals.map((s) => [s.name, s.unit, s.quantity, s.noise, s.use]));
    this.runs = study.runs;
    if (key !== this.key) {
      this.key = key;
      this.signals = study.signals;
      this.rows = study.signals.map((signal) => this.row(signal));
      this.stack.replaceChildren(...this.rows.map((row) => row.element));
    }
    this.lay();
  }

  /** A frame of curves. */
  frame(frame) {
    if (frame.kind === "model" && frame.version < this.version) return;
    if (frame.kind === "model") this.version = frame.version;
    this.frames[frame.kind] = frame.runs.size ? frame.runs : null;
    this.detail.forget();
    this.labels[frame.kind] = frame.label;
    if (frame.kind === "measured") this.lay();
    if (frame.kind === "model" && performance.now() - this.drawn > SCREEN) this.draw();
    else this.later();
  }

  lay() {
    const measured = this.frames.measured;
    if (!measured || !this.runs) return;
    this.view.lay(
      this.runs
        .filter((run) => measured.has(run.name))
        .map((run) => {
          const times = [...measured.get(run.name).values()].map((s) => s.time).filter((time) => time?.length);
          const limits = run.static ? times.flatMap((t) => [...t]) : times.flatMap((t) => [t[0], t.at(-1)]);
          const [low, high] = [Math.min(...limits), Math.max(...limits)];
          const { name, role, begins, ends } = run;
          return { name, role, low, high, begins, ends, points: run.static, ...quantityOf(run.along) };
        }),
    );
  }

  theme() {
    this.colours = palette();
    this.later();
  }

  row(signal) {
    const canvas = make("canvas", { class: "curve", role: "img", "aria-label": `${signal.name}, measured and model` });
    const map = make("canvas", {
      class: "map",
      role: "img",
      "aria-label": `Mean residual of ${signal.name} over the plane of two signals`,
      title: MAP,
    });
    const readout = make("span", { class: "readout" });
    const unit = signal.unit ? ` [${signal.unit}]` : "";
    const use =
      signal.use === "compared"
        ? [
            "compared, not fitted ",
            make(
              "button",
              { type: "button", class: "link", onclick: () => this.ask("signal", { name: signal.name }) },
              "fit it",
            ),
          ]
        : "";
    const head = make(
      "div",
      { class: "row-head" },
      make("span", { class: "name" }, signal.name),
      make("span", { class: "quantity" }, `${signal.quantity ?? ""}${unit}`.trim()),
      make("span", { class: "soft" }, use),
      readout,
    );
    const element = make("div", { class: "signal" }, head, make("div", { class: "charts" }, canvas, map));
    const row = { signal, canvas, map, readout, element, box: null };
    followPointer(canvas, this.view, (range) => this.select(range), this.cut);
    map.addEventListener("click", (event) => this.cell(row, event));
    return row;
  }

  select(range) {
    this.range = range;
    this.later();
  }

  cell(row, event) {
    const cell = row.box ? cellAt(row.box, event.offsetX, event.offsetY) : -1;
    this.view.light(cell < 0 ? null : this.plane.times(this.view, row.signal, cell));
  }

  /** The plane of the first two signals, divided anew for each model. */
  divided() {
    const { measured, model } = this.frames;
    if (this.signals.length < 2 || !model) return null;
    if (this.plane?.model !== model || this.plane.signals[0] !== this.signals[0])
      this.plane = new Plane(this.signals.slice(0, 2), measured, model);
    return this.plane;
  }

  later() {
    this.asked ||= requestAnimationFrame(() => {
      this.asked = 0;
      this.draw();
    });
  }

  draw() {
    if (this.host.hidden || !this.frames.measured) return;
    const { view, colours } = this;
    const frames = this.shown();
    drawNames(this.names, view, colours);
    const plane = this.divided();
    this.host.classList.toggle("flat", !plane);
    for (const row of this.rows) {
      drawSignal(row.canvas, view, row.signal, frames, colours);
      this.selection(row.canvas);
      row.box = plane?.draw(row.map, view, row.signal, colours) ?? null;
      say(
        row.readout,
        this.words(readOut(view, row.signal, frames), row.signal) || (row === this.rows[0] ? BELOW : ""),
      );
    }
    drawAxis(this.axis, view, this.along(), colours);
    this.detail.want(view, this.frames.measured);
    this.drawn = performance.now();
    document.dispatchEvent(new CustomEvent("drawn", { detail: { version: this.version } }));
  }

  /** The frames, with every sample of what is zoomed in on. */
  shown() {
    return this.detail.over(this.frames, this.view);
  }

  /** What the curves are drawn over. */
  along() {
    const [first, ...others] = this.view.runs;
    if (!first?.points) return "time [s]";
    if (!others.every((run) => run.along === first.along)) return "";
    return first.unit ? `${first.along} [${first.unit}]` : first.along || "point";
  }

  selection(canvas) {
    if (!this.range) return;
    const across = scale(this.view, canvas.clientWidth),
      g = canvas.getContext("2d");
    const [a, b] = this.range.map(across.to);
    Object.assign(g, { fillStyle: this.colours.soft, globalAlpha: 0.25 });
    g.fillRect(Math.min(a, b), 0, Math.abs(b - a), canvas.clientHeight);
    g.globalAlpha = 1;
  }

  words(there, signal) {
    if (!there) return "";
    const { run } = there;
    const digits = Math.min(9, Math.max(3, Math.ceil(3 - Math.log10(this.view.to - this.view.from))));
    const at = !run.points
      ? `${there.at.toFixed(digits)} s`
      : run.along
        ? `${run.along} = ${quantity(there.at, run.unit)}`
        : `point ${there.at}`;
    const part = (word, value) => (value === undefined ? "" : `${word} ${quantity(value, signal.unit)}`);
    return [
      `${there.run.name}, ${at}`,
      part("measured", there.measured),
      part("model", there.model),
      part("difference", there.residual),
      part("before", there.before),
      part("found", there.found),
    ]
      .filter(Boolean)
      .join(" · ");
  }
}

/** "p [kPa]" as name and unit. */
function quantityOf(along) {
  const [, name, unit] = /^(.*?)(?: \[(.*)\])?$/.exec(along ?? "");
  return { along: name, unit: unit === "1" ? "" : (unit ?? "") };
}
