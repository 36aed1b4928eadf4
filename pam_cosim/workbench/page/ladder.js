// The error ladder: for each signal the error on fitted and held-out runs, step by step, over the noise.

import { begin, text } from "./drawing.js";
import { make, say } from "./element.js";
import { number } from "./numbers.js";
import { palette } from "./palette.js";

const WIDEST = 46; // px, of a bar
const ROLES = ["fit", "holdout"];
const WORDS = { fit: "fitted runs", holdout: "held out" };

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
    this.later();
  }

  show(scores) {
    this.scores = scores;
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

  draw(colours) {
    this.panels.forEach(({ canvas, figures }, i) => {
      const signal = this.signals[i];
      const of = (role) => this.scores.scores[role]?.[signal.name];
      for (const role of ROLES) {
        const score = of(role);
        say(figures[role], score ? `${WORDS[role]} ${score.text}` : "");
      }
      say(figures.noise, signal.noise ? `noise ${signal.noise_text}` : "");
      drawBars(canvas, this.scores.ladder, signal, colours);
    });
  }
}

function panel(signal) {
  const figures = Object.fromEntries([...ROLES, "noise"].map((what) => [what, make("span", { class: what, "data-signal": signal.name })]));
  const canvas = make("canvas", { class: "bars", role: "img", "aria-label": `Error of ${signal.name}, step by step` });
  const head = make("p", {}, make("span", { class: "name" }, signal.name), figures.fit, figures.holdout, figures.noise);
  return { element: make("div", { class: "rungs" }, head, canvas), canvas, figures };
}

function drawBars(canvas, rungs, signal, colours) {
  const { g, width, height } = begin(canvas);
  if (!rungs?.length) return;
  const base = height - 16, top = 16;
  const values = rungs.flatMap((rung) => ROLES.map((role) => error(rung, role, signal))).filter(Number.isFinite);
  const most = Math.max(...values, 1.15 * (signal.noise ?? 0), 1e-12);
  const y = (value) => base - (value / most) * (base - top);
  const step = width / Math.max(rungs.length, 2.5);
  const bar = Math.min(WIDEST, (step - 12) / 2);
  g.fillStyle = colours.line;
  g.fillRect(0, base, width, 1);
  rungs.forEach((rung, i) => {
    const roles = ROLES.filter((role) => Number.isFinite(error(rung, role, signal)));
    const colour = i === 0 ? colours.before : colours.model;
    roles.forEach((role, k) => {
      const value = error(rung, role, signal), x = i * step + 4 + k * (bar + 2);
      paintBar(g, x, y(value), bar, base, colour, role === "holdout");
      text(g, number(value), x + bar / 2, y(value) - 3, colours.ink, { align: "center", size: bar < 30 ? 9 : 10 });
    });
    text(g, shortened(g, rung.label, step - 6), i * step + 4, height - 3, colours.soft, { size: 10 });
  });
  noiseLine(g, signal.noise ? y(signal.noise) : null, width, colours);
}

const error = (rung, role, signal) => rung[role]?.[signal.name]?.rms;

function paintBar(g, x, top, width, base, colour, hollow) {
  Object.assign(g, { fillStyle: colour, strokeStyle: colour, lineWidth: 1 });
  if (!hollow) return g.fillRect(x, top, width, base - top);
  g.save();
  g.beginPath();
  g.rect(x, top, width, base - top);
  g.clip();
  g.beginPath();
  for (let d = -(base - top); d < width; d += 5) {
    g.moveTo(x + d, base);
    g.lineTo(x + d + (base - top), top);
  }
  g.stroke();
  g.restore();
  return g.strokeRect(x + 0.5, top + 0.5, width - 1, Math.max(base - top - 1, 0));
}

function noiseLine(g, y, width, colours) {
  if (y === null) return;
  g.strokeStyle = colours.ink;
  g.setLineDash([3, 2]);
  g.beginPath();
  g.moveTo(0, Math.round(y) + 0.5);
  g.lineTo(width, Math.round(y) + 0.5);
  g.stroke();
  g.setLineDash([]);
}

function shortened(g, words, room) {
  g.font = "10px system-ui, sans-serif";
  let kept = words;
  while (kept.length > 2 && g.measureText(kept).width > room) kept = `${kept.slice(0, -2)}…`;
  return kept;
}
