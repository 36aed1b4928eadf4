// Where in the plane of two signals the model is wrong: the mean residual of each cell, for the times that are shown.

import { begin, lower, text } from "./drawing.js";
import { diverging } from "./palette.js";
import { tickLabels, ticks } from "./numbers.js";

const CELLS = 14;
const FULL = 5; // noise standard deviations of the darkest colour
const AREA = { left: 40, right: 8, top: 22, bottom: 30 };

/** The cells of one signal over the plane of two: mean residual in noise standard deviations, and the plane's edges. */
export function cellsOf(view, signal, plane, curves) {
  const [across, up] = plane.map((s) => range(curves.model, s.name));
  if (!across || !up || !signal.noise) return null;
  const sum = new Float64Array(CELLS * CELLS), count = new Uint32Array(CELLS * CELLS);
  eachSample(view, signal, plane, curves, [across, up], (cell, residual) => {
    sum[cell] += residual;
    count[cell] += 1;
  });
  return { across, up, mean: sum.map((s, i) => (count[i] ? s / count[i] / signal.noise : NaN)) };
}

/** Ranges of time in which the state is in a cell: `{run: [[from, to], ...]}`. */
export function timesIn(cell, view, signal, plane, curves) {
  const limits = plane.map((s) => range(curves.model, s.name));
  const ranges = {};
  eachSample(view, signal, plane, curves, limits, (there, _, run, time, next) => {
    if (there !== cell) return;
    const found = (ranges[run] ??= []);
    if (found.length && time - found.at(-1)[1] < 1e-9 + (next - time)) found.at(-1)[1] = next;
    else found.push([time, next]);
  });
  return ranges;
}

export function drawMap(canvas, map, plane, colours) {
  const { g, width, height } = begin(canvas);
  const box = { left: AREA.left, top: AREA.top, width: width - AREA.left - AREA.right, height: height - AREA.top - AREA.bottom };
  if (!map || box.height < 30) return null;
  g.fillStyle = colours.band;
  g.fillRect(box.left, box.top, box.width, box.height);
  const [w, h] = [box.width / CELLS, box.height / CELLS];
  map.mean.forEach((mean, i) => {
    if (mean !== mean) return;
    g.fillStyle = diverging(colours, mean / FULL);
    g.fillRect(box.left + (i % CELLS) * w, box.top + box.height - (Math.floor(i / CELLS) + 1) * h, w + 0.6, h + 0.6);
  });
  axes(g, map, plane, box, colours);
  legend(g, box, colours);
  return box;
}

/** The cell under a place on the canvas; -1 outside. */
export function cellAt(box, x, y) {
  const i = Math.floor(((x - box.left) / box.width) * CELLS), k = Math.floor(((box.top + box.height - y) / box.height) * CELLS);
  return i >= 0 && i < CELLS && k >= 0 && k < CELLS ? i + CELLS * k : -1;
}

function eachSample(view, signal, plane, curves, [across, up], tell) {
  for (const run of view.visible()) {
    const measured = curves.measured?.get(run.name), model = curves.model?.get(run.name);
    const residual = model?.get(signal.name)?.residual, time = measured?.get(signal.name)?.time;
    const [x, y] = plane.map((s) => ({ time: measured?.get(s.name)?.time, values: model?.get(s.name)?.values }));
    if (!residual || !x.values || !y.values) continue;
    const first = lower(time, view.from - run.shift), last = lower(time, view.to - run.shift + 1e-9);
    for (let i = first; i < last; i++) {
      if (residual[i] !== residual[i]) continue;
      const at = [[x, across], [y, up]].map(([s, limits]) => cellOf(s.values[sameTime(s.time, time, i)], limits));
      if (at[0] >= 0 && at[1] >= 0) tell(at[0] + CELLS * at[1], residual[i], run.name, time[i], time[Math.min(i + 1, time.length - 1)]);
    }
  }
}

const sameTime = (own, other, i) => (own.length === other.length ? i : Math.min(lower(own, other[i]), own.length - 1));

function cellOf(value, [low, high]) {
  return value === value ? Math.min(CELLS - 1, Math.max(0, Math.floor(((value - low) / (high - low)) * CELLS))) : -1;
}

function range(frame, signal) {
  let [low, high] = [Infinity, -Infinity];
  for (const signals of frame?.values() ?? []) {
    for (const value of signals.get(signal)?.values ?? []) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (!(high >= low)) return null;
  return high > low ? [low, high] : [low - 0.5, high + 0.5];
}

function legend(g, box, colours) {
  const width = 66, x = box.left + box.width / 2 - width / 2, y = 6;
  for (let i = 0; i < width; i++) {
    g.fillStyle = diverging(colours, (2 * i) / width - 1);
    g.fillRect(x + i, y, 1.5, 7);
  }
  text(g, `−${FULL}`, x - 4, y + 7, colours.soft, { align: "right", size: 10 });
  text(g, `+${FULL} σ`, x + width + 4, y + 7, colours.soft, { size: 10 });
}

function axes(g, map, [across, up], box, colours) {
  const name = (signal) => (signal.unit ? `${signal.name} [${signal.unit}]` : signal.name);
  const bottom = box.top + box.height;
  for (const [i, values] of [map.across, map.up].map((limits) => ticks(...limits, 3)).entries()) {
    const [low, high] = i ? map.up : map.across;
    tickLabels(values).forEach((label, k) => {
      const share = (values[k] - low) / (high - low);
      if (i) text(g, label, box.left - 4, bottom - share * box.height, colours.soft, { align: "right", base: "middle", size: 10 });
      else text(g, label, box.left + share * box.width, bottom + 11, colours.soft, { align: "center", size: 10 });
    });
  }
  text(g, name(across), box.left + box.width / 2, bottom + 24, colours.soft, { align: "center", size: 10 });
  g.save();
  g.translate(9, box.top + box.height / 2);
  g.rotate(-Math.PI / 2);
  text(g, name(up), 0, 0, colours.soft, { align: "center", size: 10 });
  g.restore();
}
