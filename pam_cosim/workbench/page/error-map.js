// Where in the plane of two signals the model is wrong: the mean residual of each cell, for the times that are shown.

import { begin, lower, text } from "./drawing.js";
import { diverging } from "./palette.js";
import { tickLabels, ticks } from "./numbers.js";

const CELLS = 14; // along each side, as in the report
const FULL = 5; // noise standard deviations of the darkest colour
const AREA = { left: 40, right: 10, top: 22, bottom: 30 };

/** The plane of two modelled signals, divided into cells: which of them each sample is in. */
export class Plane {
  /** `signals`: two; `measured` and `model`: runs of frames. */
  constructor(signals, measured, model) {
    Object.assign(this, { signals, model, limits: signals.map((s) => range(model, s.name)), cells: new Map() });
    if (this.limits.some((limits) => limits === null)) return;
    for (const [run, found] of model) {
      const [x, y] = signals.map((s) => found.get(s.name)?.values);
      const [tx, ty] = signals.map((s) => measured.get(run)?.get(s.name)?.time);
      if (x && y && tx && ty) this.cells.set(run, { time: tx, cell: this.divide(x, y, tx, ty) });
    }
  }

  divide(x, y, tx, ty) {
    const [[left, right], [bottom, top]] = this.limits;
    const [fx, fy] = [CELLS / (right - left), CELLS / (top - bottom)];
    const cell = new Int16Array(x.length);
    for (let i = 0; i < x.length; i++) {
      const value = y[ty.length === tx.length ? i : Math.min(lower(ty, tx[i]), ty.length - 1)];
      const column = Math.min(CELLS - 1, ((x[i] - left) * fx) | 0),
        row = Math.min(CELLS - 1, ((value - bottom) * fy) | 0);
      cell[i] = x[i] === x[i] && value === value ? column + CELLS * row : -1;
    }
    return cell;
  }

  /** Mean residual of a signal in each cell, in noise standard deviations; NaN where nobody was. */
  mean(view, signal) {
    const sum = new Float64Array(CELLS * CELLS),
      count = new Uint32Array(CELLS * CELLS);
    this.each(view, signal, (cell, residual) => {
      sum[cell] += residual;
      count[cell] += 1;
    });
    return sum.map((s, i) => (count[i] ? s / count[i] / signal.noise : NaN));
  }

  /** Ranges of time in which the state is in a cell: `{run: [[from, to], ...]}`. */
  times(view, signal, chosen) {
    const ranges = {};
    this.each(view, signal, (cell, _, run, time, i) => {
      if (cell !== chosen) return;
      const found = (ranges[run] ??= []),
        next = time[Math.min(i + 1, time.length - 1)];
      if (found.length && time[i] <= found.at(-1)[1]) found.at(-1)[1] = next;
      else found.push([time[i], next]);
    });
    return ranges;
  }

  each(view, signal, tell) {
    for (const run of view.visible()) {
      const residual = this.model.get(run.name)?.get(signal.name)?.residual,
        there = this.cells.get(run.name);
      if (!residual || !there || residual.length !== there.cell.length) continue;
      const { time, cell } = there;
      const last = run.points ? time.length : lower(time, view.to - run.shift + 1e-9);
      for (let i = run.points ? 0 : lower(time, view.from - run.shift); i < last; i++) {
        if (cell[i] >= 0 && residual[i] === residual[i]) tell(cell[i], residual[i], run.name, time, i);
      }
    }
  }

  /** Draws the map of a signal; the box of the plane on the canvas, or null. */
  draw(canvas, view, signal, colours) {
    const { g, width, height } = begin(canvas);
    const box = {
      left: AREA.left,
      top: AREA.top,
      width: width - AREA.left - AREA.right,
      height: height - AREA.top - AREA.bottom,
    };
    if (this.limits.includes(null) || !signal.noise || box.height < 30) return null;
    g.fillStyle = colours.band;
    g.fillRect(box.left, box.top, box.width, box.height);
    g.imageSmoothingEnabled = false;
    g.drawImage(picture(this.mean(view, signal), colours), box.left, box.top, box.width, box.height);
    axes(g, this.limits, this.signals, box, colours);
    legend(g, box, colours);
    return box;
  }
}

/** The cell under a place on the canvas; -1 outside. */
export function cellAt(box, x, y) {
  const i = Math.floor(((x - box.left) / box.width) * CELLS),
    k = Math.floor(((box.top + box.height - y) / box.height) * CELLS);
  return i >= 0 && i < CELLS && k >= 0 && k < CELLS ? i + CELLS * k : -1;
}

const small = Object.assign(document.createElement("canvas"), { width: CELLS, height: CELLS });

function picture(mean, colours) {
  const g = small.getContext("2d", { willReadFrequently: true });
  const image = g.createImageData(CELLS, CELLS);
  mean.forEach((value, i) => {
    if (value !== value) return;
    const at = 4 * ((i % CELLS) + CELLS * (CELLS - 1 - Math.floor(i / CELLS)));
    image.data.set([...diverging(colours, value / FULL), 255], at);
  });
  g.putImageData(image, 0, 0);
  return small;
}

function range(frame, signal) {
  let [low, high] = [Infinity, -Infinity];
  for (const signals of frame.values()) {
    const values = signals.get(signal)?.values ?? [];
    for (let i = 0; i < values.length; i++) {
      if (values[i] < low) low = values[i];
      if (values[i] > high) high = values[i];
    }
  }
  if (!(high >= low)) return null;
  return high > low ? [low, high] : [low - 0.5, high + 0.5];
}

function legend(g, box, colours) {
  const width = box.width < 110 ? 40 : 66,
    x = box.left + box.width / 2 - width / 2,
    y = 6;
  const gradient = g.createLinearGradient(x, 0, x + width, 0);
  for (let i = 0; i <= 8; i++) gradient.addColorStop(i / 8, `rgb(${diverging(colours, i / 4 - 1).join(" ")})`);
  g.fillStyle = gradient;
  g.fillRect(x, y, width, 7);
  text(g, `−${FULL}`, x - 4, y + 7, colours.soft, { align: "right", size: 10 });
  text(g, `+${FULL} σ`, x + width + 4, y + 7, colours.soft, { size: 10 });
}

function axes(g, limits, [across, up], box, colours) {
  const name = (signal) => (signal.unit ? `${signal.name} [${signal.unit}]` : signal.name);
  const bottom = box.top + box.height;
  for (const [i, [low, high]] of limits.entries()) {
    const values = ticks(low, high, 3);
    tickLabels(values).forEach((label, k) => {
      const share = (values[k] - low) / (high - low);
      if (i)
        text(g, label, box.left - 4, bottom - share * box.height, colours.soft, {
          align: "right",
          base: "middle",
          size: 10,
        });
      else
        text(g, label, box.left + share * box.width, bottom + 11, colours.soft, {
          align: share > 0.9 ? "right" : "center",
          size: 10,
        });
    });
  }
  text(g, name(across), box.left + box.width / 2, bottom + 24, colours.soft, { align: "center", size: 10 });
  g.save();
  g.translate(9, box.top + box.height / 2);
  g.rotate(-Math.PI / 2);
  text(g, name(up), 0, 0, colours.soft, { align: "center", size: 10 });
  g.restore();
}
