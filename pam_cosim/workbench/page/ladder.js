// The error ladder: for each signal the error on fitted and held-out runs, step by step, over the noise.

import { begin, text } from "./drawing.js";
import { make, say } from "./element.js";
import { number } from "./numbers.js";
import { palette } from "./palette.js";

const WIDEST = 150; // px, of a step
const LONGEST = 44; // px, of a rung
const LOWEST = 0.75; // of the smallest error, where the scale begins
const ROLES = ["fit", "holdout"];
const WORDS = { fit: "fitted", holdout: "held out" };

export class Ladder {
  constructor(host) {
    Object.assign(this, { host, signals: [], panels: [], scores: null, asked: 0 });
    new ResizeObserver(() => this.later()).observe(host);
  }

  study(study) {
    const key = JSON.stringify(study.signals.map((s) => [s.name, s.unit]));
    this.signals = study.signals;
    if (key !== this.key) {
      this.key = key;
      this.panels = study.signals.map((signal) => panel(signal));
      this.host.replaceChildren(...this.panels.map((p) => p.element));
    }
    this.write();
  }

  show(scores) {
    this.scores = scores;
    this.write();
  }

  /** The model that a diagnosis found, as a rung beyond the standing one; null: none. */
  found(rung) {
    this.beyond = rung ?? null;
    this.later();
  }

  theme() {
    this.later();
  }

  later() {
    this.asked ||= requestAnimationFrame(() => {
      this.asked = 0;
      if (this.scores) this.draw(palette());
    });
  }

  /** The figures at once, the bars with the next frame: what is said to be done stands there already. */
  write() {
    if (!this.scores) return;
    this.panels.forEach(({ figures }, i) => {
      const signal = this.signals[i];
      for (const role of ROLES) {
        const score = this.scores.scores[role]?.[signal.name];
        say(figures[role], score ? `${WORDS[role]} ${score.text}` : "");
      }
      say(figures.noise, signal.noise ? `noise ${signal.noise_text}` : "");
    });
    this.later();
  }

  draw(colours) {
    const rungs = [...(this.scores.ladder ?? []), ...(this.beyond ? [this.beyond] : [])];
    this.panels.forEach(({ canvas }, i) => drawRungs(canvas, rungs, this.signals[i], colours, this.beyond));
  }
}

function panel(signal) {
  const figures = Object.fromEntries(
    [...ROLES, "noise"].map((what) => [what, make("span", { class: what, "data-signal": signal.name })]),
  );
  const canvas = make("canvas", { class: "bars", role: "img", "aria-label": `Error of ${signal.name}, step by step` });
  const head = make("p", {}, make("span", { class: "name" }, signal.name), figures.fit, figures.holdout, figures.noise);
  return { element: make("div", { class: "rungs" }, head, canvas), canvas, figures };
}

/** The rungs on a logarithmic scale, so that a fall to the noise is seen from however far it comes. */
function drawRungs(canvas, rungs, signal, colours, beyond) {
  const { g, width, height } = begin(canvas);
  const known = rungs.flatMap((rung) => ROLES.map((role) => error(rung, role, signal))).filter((value) => value > 0);
  if (!known.length) return;
  const noise = signal.noise > 0 ? signal.noise : null;
  const low = Math.log(LOWEST * Math.min(...known, noise ?? Infinity)),
    high = Math.log(Math.max(...known, noise ?? 0));
  const base = height - 15;
  const y = (value) => Math.round(base - ((Math.log(value) - low) / (high - low || 1)) * (base - 16));
  if (noise) noiseLine(g, y(noise) + 0.5, width, colours);
  const step = Math.floor(Math.min(width / rungs.length, WIDEST)),
    long = Math.floor(Math.min(LONGEST, (step - 14) / 2));
  rungs.forEach((rung, i) => {
    const colour = rungs[i] === beyond ? colours.found : i === 0 && rungs.length > 1 ? colours.before : colours.model;
    ROLES.forEach((role, k) => {
      const value = error(rung, role, signal),
        x = i * step + k * (long + 5);
      if (!(value > 0)) return;
      drawRung(g, x, y(value), long, colour, role === "holdout");
      text(g, number(value), x + long / 2, y(value) - 5, i === rungs.length - 1 ? colours.ink : colours.soft, {
        align: "center",
        size: 10,
      });
    });
    text(g, shortened(g, rung.label, step - 8), i * step, height - 2, colours.soft, { size: 10 });
  });
}

function drawRung(g, x, y, long, colour, hollow) {
  Object.assign(g, { fillStyle: colour, strokeStyle: colour, lineWidth: 1 });
  if (hollow) g.strokeRect(x + 0.5, y - 1.5, long - 1, 4);
  else g.fillRect(x, y - 2, long, 5);
}

const error = (rung, role, signal) => rung[role]?.[signal.name]?.rms;

function noiseLine(g, y, width, colours) {
  Object.assign(g, { strokeStyle: colours.ink, lineWidth: 1 });
  g.setLineDash([3, 2]);
  g.beginPath();
  g.moveTo(0, y);
  g.lineTo(width, y);
  g.stroke();
  g.setLineDash([]);
  text(g, "noise", width, y - 3, colours.soft, { align: "right", size: 10 });
}

function shortened(g, words, room) {
  g.font = "10px system-ui, sans-serif";
  let kept = words;
  while (kept.length > 2 && g.measureText(kept).width > room) kept = `${kept.slice(0, -2)}…`;
  return kept;
}
