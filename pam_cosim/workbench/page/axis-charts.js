// The strip with the names of the runs above the curves, and the axis below them.

import { begin, text } from "./drawing.js";
import { tickLabels, ticks } from "./numbers.js";
import { LEFT, RIGHT, scale } from "./signal-chart.js";

const APART = 8; // px between the names of runs
const PER_TICK = 46; // px

/** Names and roles of the runs, where there is room. */
export function drawNames(canvas, view, colours) {
  const { g, width, height } = begin(canvas);
  const across = scale(view, width);
  for (const run of view.visible()) {
    const [a, b] = [Math.max(across.to(run.start), LEFT), Math.min(across.to(run.start + run.span), width - RIGHT)];
    const role = run.role === "holdout" ? "held out" : "";
    for (const words of [[run.name, role].filter(Boolean).join(", "), run.name, run.short, run.short.slice(0, 3)]) {
      g.font = "600 11px system-ui, sans-serif";
      if (g.measureText(words).width + APART > b - a) continue;
      text(g, words, a + 2, height - 5, role ? colours.soft : colours.ink, { bold: true });
      break;
    }
  }
}

/** Round values on the axis of each run. */
export function drawAxis(canvas, view, unit, colours) {
  const { g, width, height } = begin(canvas);
  const across = scale(view, width);
  const right = width - RIGHT;
  const room = unit ? g.measureText(unit).width + 14 : 0;
  let free = LEFT - 20;
  for (const run of view.visible()) {
    const [a, b] = [Math.max(across.to(run.start), LEFT), Math.min(across.to(run.start + run.span), right)];
    if (b - a < 1.2 * PER_TICK && view.visible().length > 1) continue;
    const back = (x) => across.back(x) - run.shift;
    const values = ticks(back(a), back(b), Math.max(1, Math.round((b - a) / PER_TICK)));
    const labels = tickLabels(values);
    values.forEach((value, i) => {
      const x = across.to(value + run.shift);
      g.fillStyle = colours.soft;
      g.fillRect(Math.round(x), 0, 1, 4);
      const half = g.measureText(labels[i]).width / 2;
      const ends = run !== view.runs.at(-1) && x + half > b;
      if (x - half < free || x + half > right - room || ends) return;
      text(g, labels[i], x, height - 4, colours.soft, { align: "center" });
      free = x + half + 8;
    });
  }
  text(g, unit, right, height - 4, colours.soft, { align: "right" });
}
