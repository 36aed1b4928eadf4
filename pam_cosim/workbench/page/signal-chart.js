// One signal over time: measured and model above, what is left of it below, on one canvas.

import { begin, lower, text, trace, within } from "./drawing.js";
import { number, tickLabels, ticks } from "./numbers.js";

export const LEFT = 52,
  RIGHT = 8; // px, the same in all charts, so that times stand above each other
const SHARE = 0.66; // of the height for the curves, the rest for the residual
const GRIP = { reach: 6, width: 3, height: 14 }; // px of the end of a run, which can be dragged
const DOTS = 6; // px between samples from which on each is a dot
const PADDING = 0.06;

/** The place on the canvas of a value of the common axis, and back. */
export function scale(view, width) {
  const factor = (width - LEFT - RIGHT) / (view.to - view.from);
  return { to: (place) => LEFT + (place - view.from) * factor, back: (x) => view.from + (x - LEFT) / factor };
}

/**
 * Draws one signal. `curves` holds `measured`, `model` and `reference`: what `readFrame` gives as `runs`, or null.
 */
export function drawSignal(canvas, view, signal, curves, colours) {
  const { g, width, height } = begin(canvas);
  if (width < LEFT + 20) return;
  const across = scale(view, width);
  const runs = view
    .visible()
    .map((run) => ({ run, ...ofRun(curves, run.name, signal.name) }))
    .filter((r) => r.measured?.time);
  const upper = { top: 6, bottom: Math.round(height * SHARE) - 4 };
  const under = { top: Math.round(height * SHARE) + 6, bottom: height - 4 };
  const shapes = runs.map((r) => ({
    ...r,
    range: r.run.points
      ? [0, r.measured.time.length]
      : within(r.measured.time, view.from - r.run.shift, view.to - r.run.shift),
  }));

  grounds(g, view, across, height, colours, width);
  const value = linear(limits(shapes, upperArrays), upper);
  const left = linear(symmetric(shapes, signal.noise), under);
  gridLines(g, value, upper, width, colours, Math.min(7, Math.max(2, Math.floor((upper.bottom - upper.top) / 28))));
  noiseBand(g, left, signal, view, across, colours);
  residualAxis(g, left, under, width, colours);

  g.save();
  g.beginPath();
  g.rect(LEFT, 0, width - LEFT - RIGHT, height);
  g.clip();
  for (const s of shapes) {
    const toX = (t) => across.to(t + s.run.shift);
    measured(g, s, toX, value, colours);
    if (s.reference?.values) line(g, s, s.reference.values, toX, value, colours.before, 1.2, [4, 3]);
    if (s.found?.values) line(g, s, s.found.values, toX, value, colours.found, 1.3, [6, 3]);
    if (s.model?.values) line(g, s, s.model.values, toX, value, colours.model, 1.7, [], s.run.points);
    if (s.reference?.residual) line(g, s, s.reference.residual, toX, left, colours.before, 0.8, []);
    if (s.found?.residual) line(g, s, s.found.residual, toX, left, colours.found, 0.9, []);
    if (s.model?.residual)
      line(g, s, s.model.residual, toX, left, colours.model, 1.1, [], s.run.points || areApart(s, toX));
  }
  cuts(g, view, across, height, colours);
  cursorLine(g, view, across, height, colours);
  g.restore();
}

/** The end of a run at a place on the canvas, that can be dragged: `{run, side}`, or null. */
export function handleAt(view, width, x) {
  const across = scale(view, width);
  let found = null,
    nearest = GRIP.reach;
  for (const run of view.visible()) {
    if (run.points) continue;
    for (const [side, place] of Object.entries(view.kept(run))) {
      const far = Math.abs(across.to(place) - x);
      if (far <= nearest) [found, nearest] = [{ run, side }, far];
    }
  }
  return found;
}

/** What does not count of a run is pale; its ends have grips. */
function cuts(g, view, across, height, colours) {
  for (const run of view.visible()) {
    if (run.points) continue;
    const { begin, end } = view.kept(run);
    const [first, last, low, high] = [run.start, run.start + run.span, begin, end].map(across.to);
    Object.assign(g, { fillStyle: colours.ground, globalAlpha: 0.75 });
    if (low - first > 1) g.fillRect(first, 0, low - first, height);
    if (last - high > 1) g.fillRect(high, 0, last - high, height);
    Object.assign(g, { fillStyle: colours.soft, globalAlpha: 0.9 });
    if (low - first > 1) g.fillRect(low - 0.5, 0, 1, height);
    if (last - high > 1) g.fillRect(high - 0.5, 0, 1, height);
    if (!view.bare) {
      g.fillRect(low, 0, GRIP.width, GRIP.height);
      g.fillRect(high - GRIP.width, 0, GRIP.width, GRIP.height);
    }
    g.globalAlpha = 1;
  }
}

/** What stands at the cursor: `{at, measured, model, residual}`, or null. */
export function readOut(view, signal, curves) {
  const there = view.cursor === null ? null : view.at(view.cursor);
  if (!there) return null;
  const { measured: m, model, reference, found } = ofRun(curves, there.run.name, signal.name);
  if (!m?.time?.length) return null;
  const i = there.run.points ? nearest(m.time, there.value) : nearestSorted(m.time, there.value);
  return {
    run: there.run,
    at: m.time[i],
    measured: m.values[i],
    model: model?.values?.[i],
    residual: model?.residual?.[i],
    before: reference?.values?.[i],
    found: found?.values?.[i],
  };
}

function nearestSorted(times, value) {
  const i = Math.min(lower(times, value), times.length - 1);
  return i > 0 && value - times[i - 1] < times[i] - value ? i - 1 : i;
}

/** Points at rest come in the order in which they were measured. */
function nearest(places, value) {
  return places.reduce((best, place, i) => (Math.abs(place - value) < Math.abs(places[best] - value) ? i : best), 0);
}

function ofRun(curves, run, signal) {
  const of = (kind) => curves[kind]?.get(run)?.get(signal);
  return { measured: of("measured"), model: of("model"), reference: of("reference"), found: of("found") };
}

const upperArrays = (s) => [s.measured.values, s.model?.values, s.reference?.values, s.found?.values];
const residualArrays = (s) => [s.model?.residual, s.reference?.residual, s.found?.residual];

function limits(shapes, arrays) {
  let [low, high] = [Infinity, -Infinity];
  for (const s of shapes) {
    for (const values of arrays(s)) {
      if (!values) continue;
      for (let i = s.range[0]; i < s.range[1]; i++) {
        const v = values[i];
        if (v < low) low = v;
        if (v > high) high = v;
      }
    }
  }
  if (!(high >= low)) return [0, 1];
  const room = PADDING * (high - low) || Math.abs(high) * 0.1 || 1;
  return [low - room, high + room];
}

function symmetric(shapes, noise) {
  const [low, high] = limits(shapes, residualArrays);
  const most = Math.max(-low, high, 3 * (noise ?? 0)) || 1;
  return [-most, most];
}

function linear([low, high], { top, bottom }) {
  const factor = (bottom - top) / (high - low);
  return { low, high, to: (value) => bottom - (value - low) * factor };
}

function grounds(g, view, across, height, colours, width) {
  for (const run of view.visible()) {
    const [a, b] = [Math.max(across.to(run.start), LEFT), Math.min(across.to(run.start + run.span), width - RIGHT)];
    g.fillStyle = run.role === "holdout" ? colours.band : colours.ground;
    if (b > a) g.fillRect(a, 0, b - a, height);
  }
  g.fillStyle = colours.lit;
  for (const [from, to] of view.lit) {
    const [a, b] = [Math.max(across.to(from), LEFT), Math.min(across.to(to), width - RIGHT)];
    if (b >= a) g.fillRect(a, 0, Math.max(b - a, 1), height);
  }
}

function gridLines(g, y, area, width, colours, most) {
  const values = ticks(y.low, y.high, most);
  const labels = tickLabels(values);
  g.lineWidth = 1;
  values.forEach((value, i) => {
    const at = Math.round(y.to(value)) + 0.5;
    if (at < area.top || at > area.bottom) return;
    horizontal(g, at, width, colours.line);
    text(g, labels[i], LEFT - 6, at, colours.soft, { align: "right", base: "middle" });
  });
}

function horizontal(g, at, width, colour) {
  g.strokeStyle = colour;
  g.beginPath();
  g.moveTo(LEFT, at);
  g.lineTo(width - RIGHT, at);
  g.stroke();
}

function noiseBand(g, y, signal, view, across, colours) {
  if (!signal.noise) return;
  g.fillStyle = colours.noise;
  for (const run of view.visible()) {
    const [a, b] = [
      Math.max(across.to(run.start), LEFT),
      Math.min(across.to(run.start + run.span), across.to(view.to)),
    ];
    g.fillRect(a, y.to(2 * signal.noise), b - a, y.to(-2 * signal.noise) - y.to(2 * signal.noise));
  }
}

function residualAxis(g, y, area, width, colours) {
  horizontal(g, Math.round(y.to(0)) + 0.5, width, colours.soft);
  const value = ticks(0, y.high, 5).findLast((v) => v <= 0.85 * y.high) || y.high;
  const label = number(value, 2);
  for (const [v, words] of [
    [value, label],
    [0, "0"],
    [-value, `−${label}`],
  ]) {
    text(g, words, LEFT - 6, y.to(v), colours.soft, { align: "right", base: "middle", size: 10 });
  }
}

/** Whether the samples that are shown stand so far apart that each is seen. */
function areApart({ measured: { time, values }, range: [first, last] }, toX) {
  let count = 0;
  for (let i = first; i < last; i++) if (values[i] === values[i]) count++;
  return count < 2 || (toX(time[last - 1]) - toX(time[first])) / (count - 1) >= DOTS;
}

function measured(g, s, toX, y, colours) {
  const { time, values } = s.measured;
  const [first, last] = s.range;
  Object.assign(g, { strokeStyle: colours.measured, fillStyle: colours.measured, lineWidth: 1.4 });
  if (!s.run.points) {
    g.beginPath();
    trace(g, time, values, first, last, toX, y.to);
    g.stroke();
  }
  if (s.run.points || areApart(s, toX)) {
    for (let i = first; i < last; i++) {
      if (values[i] === values[i]) g.fillRect(toX(time[i]) - 1.75, y.to(values[i]) - 1.75, 3.5, 3.5);
    }
  }
}

function line(g, s, values, toX, y, colour, thick, dashes, points = false) {
  Object.assign(g, { strokeStyle: colour, lineWidth: thick, lineJoin: "bevel" });
  g.setLineDash(dashes);
  g.beginPath();
  trace(g, s.measured.time, values, ...s.range, toX, y.to);
  g.stroke();
  g.setLineDash([]);
  if (!points) return;
  for (let i = s.range[0]; i < s.range[1]; i++) {
    if (values[i] !== values[i]) continue;
    g.beginPath();
    g.arc(toX(s.measured.time[i]), y.to(values[i]), 2.6, 0, 7);
    g.stroke();
  }
}

function cursorLine(g, view, across, height, colours) {
  if (view.cursor === null) return;
  g.strokeStyle = colours.ink;
  g.lineWidth = 1;
  g.beginPath();
  const x = Math.round(across.to(view.cursor)) + 0.5;
  g.moveTo(x, 0);
  g.lineTo(x, height);
  g.stroke();
}
