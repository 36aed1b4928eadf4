// Long runs come thinned; where the page is zoomed in on a part of one, every sample of that part is asked for.

import { readFrame } from "./frames.js";

const MOST = 4000; // points of a curve that comes thinned
const PAUSE = 150; // ms without a new curve or another zoom, after which it is asked
const AROUND = 0.5; // of what is shown, on both sides of it, that comes with it
const COARSE = 4; // times what is shown, from which on thinned samples are asked for anew

export class Detail {
  /** `ask` sends commands; `come()` is called when samples have come. */
  constructor(ask, come) {
    Object.assign(this, { ask, come, parts: new Map(), round: 0 });
  }

  /** A curve is another: what came is of the one before. */
  forget() {
    this.parts.clear();
    this.round++;
  }

  /** The curves by kind and run, with the samples that came in place of the thinned ones. */
  over(frames, view) {
    const parts = [...this.parts].filter(([name, part]) => covers(part, shown(view, name)));
    if (!parts.length) return frames;
    const kinds = Object.entries(frames).map(([kind, runs]) => [
      kind,
      runs && new Map([...runs, ...parts.map(([name, part]) => [name, part.kinds[kind] ?? new Map()])]),
    ]);
    return Object.fromEntries(kinds);
  }

  /** Asks for the samples of what is shown, a moment later. */
  want(view, measured) {
    clearTimeout(this.waiting);
    const runs = view.visible().filter((run) => !run.points && isThinned(measured.get(run.name)));
    const missing = runs
      .map((run) => [run, shown(view, run.name)])
      .filter(([, part]) => part.to > part.from)
      .filter(([run, part]) => ![thinnedWhole(run), this.parts.get(run.name)].some((one) => serves(one, part)))
      .map(([run, part]) => [run.name, part]);
    if (missing.length) this.waiting = setTimeout(() => missing.forEach(([name, part]) => this.fetch(name, part)), PAUSE);
  }

  async fetch(run, { from, to }) {
    const { round } = this;
    const part = { from: from - AROUND * (to - from), to: to + AROUND * (to - from) };
    const answer = await this.ask("samples", { run, begin: part.from, end: part.to }, () => {});
    if (!answer || round !== this.round) return;
    const frames = answer.frames.map((text) => readFrame(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer));
    const kinds = Object.fromEntries(frames.map((frame) => [frame.kind, frame.runs.get(run)]));
    this.parts.set(run, { ...part, kinds, thinned: isThinned(kinds.measured) });
    this.come();
  }
}

const isThinned = (signals) => [...(signals?.values() ?? [])].some((s) => s.time?.length >= MOST);

/** From when to when a run is shown, on its own clock. */
function shown(view, name) {
  const run = view.runs.find((one) => one.name === name);
  return { from: Math.max(view.from - run.shift, run.low), to: Math.min(view.to - run.shift, run.high) };
}

const thinnedWhole = (run) => ({ from: run.low, to: run.high, thinned: true });

const covers = (part, { from, to }) => part.from <= from && to <= part.to;

const serves = (part, now) =>
  part && covers(part, now) && (!part.thinned || part.to - part.from < COARSE * (now.to - now.from));
