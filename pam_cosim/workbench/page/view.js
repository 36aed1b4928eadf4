// The part of the data that all charts show: runs lie end to end on one axis, and a window moves over it.

const GAP = 0.02; // between runs, of all that is shown
const CLOSEST = 1e-4; // of all that can be shown at once

export class View {
  constructor() {
    Object.assign(this, { runs: [], from: 0, to: 1, end: 1, cursor: null, cutting: null, lit: [], listeners: [] });
  }

  /** Lays the runs end to end: `[{name, role, low, high}]` with the first and last value of each on its own axis. */
  lay(runs) {
    const before = this.runs.map((run) => `${run.name} ${run.low} ${run.high}`).join();
    const spans = runs.map((run) => Math.max(run.high - run.low, 1e-9));
    const gap = runs.length > 1 ? (GAP * spans.reduce((a, b) => a + b, 0)) / Math.sqrt(runs.length) : 0;
    let start = 0;
    this.runs = runs.map((run, i) => {
      const laid = { ...run, start, span: spans[i], shift: start - run.low };
      start += spans[i] + gap;
      return laid;
    });
    const short = shortened(this.runs.map((run) => run.name));
    this.runs.forEach((run, i) => (run.short = short[i]));
    this.end = Math.max(start - gap, 1e-9);
    if (before !== this.runs.map((run) => `${run.name} ${run.low} ${run.high}`).join()) this.whole();
  }

  whole() {
    this.show(0, this.end);
  }

  showRun(name) {
    const run = this.runs.find((r) => r.name === name);
    if (run) this.show(run.start - 0.005 * run.span, run.start + 1.005 * run.span);
  }

  show(from, to) {
    const span = Math.min(Math.max(to - from, CLOSEST * this.end), 1.02 * this.end);
    const start = Math.min(Math.max(from, -0.01 * this.end), 1.01 * this.end - span);
    Object.assign(this, { from: start, to: start + span });
    this.tell();
  }

  zoom(factor, at = (this.from + this.to) / 2) {
    this.show(at - (at - this.from) * factor, at + (this.to - at) * factor);
  }

  pan(share) {
    const by = share * (this.to - this.from);
    this.show(this.from + by, this.to + by);
  }

  isWhole() {
    return this.to - this.from > 0.999 * this.end;
  }

  point(at) {
    this.cursor = at;
    this.tell(true);
  }

  /** Lights up ranges: `{run: [[from, to], ...]}` on the axes of the runs. */
  light(ranges) {
    this.lit = [];
    for (const run of this.runs)
      for (const [a, b] of ranges?.[run.name] ?? []) this.lit.push([a + run.shift, b + run.shift]);
    this.tell();
  }

  /** The run at a place of the axis, and where that is in the run. */
  at(place) {
    const run = this.runs.find((r) => place >= r.start && place <= r.start + r.span);
    return run ? { run, value: place - run.shift } : null;
  }

  /** First and last place of a run that count, as they are or as they are being dragged. */
  kept(run) {
    const { run: name, side, at } = this.cutting ?? {};
    const ends = { begin: run.begins + run.shift, end: run.ends + run.shift };
    return name === run.name ? { ...ends, [side]: at } : ends;
  }

  visible() {
    return this.runs.filter((r) => r.start + r.span >= this.from && r.start <= this.to);
  }

  tell(onlyCursor = false) {
    for (const listener of this.listeners) listener(onlyCursor);
  }
}

/** Names without what all of them begin and end with, up to a sign between words. */
function shortened(names) {
  if (names.length < 2) return names;
  const [first, ...others] = names;
  const alike = (from) => {
    let count = 0;
    while (count < first.length && others.every((name) => from(name, count) === from(first, count))) count++;
    return count;
  };
  const begin = first.slice(0, alike((name, i) => name[i])).replace(/[\p{L}\p{N}]*$/u, "").length;
  return names.map((name) => name.slice(begin) || name);
}
