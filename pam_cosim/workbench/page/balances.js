// Which balance fails: what each balance lacks, against the variables it may depend on.

import { begin, text } from "./drawing.js";
import { make, table } from "./element.js";
import { tickLabels, ticks } from "./numbers.js";
import { palette } from "./palette.js";

const AREA = { left: 50, right: 8, top: 8, bottom: 30 };

export class Balances {
  constructor(host) {
    Object.assign(this, { host, charts: [] });
    this.empty();
    new ResizeObserver(() => this.draw()).observe(host);
  }

  empty() {
    this.charts = [];
    this.host.replaceChildren(make("p", { class: "soft" }, "A diagnosis asks each balance for the term that is missing in it, before any effect is tried. Press Diagnose; the terms stand here."));
  }

  show(ledger) {
    const rows = ledger.rows.map((r) => [r.balance, r.share, r.explains, r.size, r.outside, r.note]);
    this.charts = [];
    const courses = (ledger.courses ?? []).map((course) => this.course(course));
    this.host.replaceChildren(make("h2", {}, "Which balance fails"), make("p", {}, ledger.sentence),
      table(["balance", "#share", "#explains alone", "#missing term, rms", "#outside two sd", "to know"], rows), ...courses,
      ...(ledger.meanings?.length ? [make("p", { class: "soft" }, `Signs. ${ledger.meanings.join(". ")}.`)] : []),
      ...(ledger.readings?.length ? [make("h3", {}, "If it were an instrument"), table(["reading of", "#offset", "#factor", "#lag", "#explains alone"], ledger.readings.map((r) => [r.signal, r.offset, r.factor, r.lag, r.explains]))] : []),
      make("ul", {}, (ledger.notes ?? []).map((note) => make("li", {}, note))));
    this.draw();
  }

  course(course) {
    const charts = course.variables.map((variable) => {
      const canvas = make("canvas", { class: "term", role: "img", "aria-label": `Missing term of the ${course.balance} balance over ${variable.name}` });
      this.charts.push({ canvas, course, variable });
      return canvas;
    });
    return make("section", {}, make("h3", {}, `Missing in the ${course.balance.replaceAll("_", " ")} balance`, course.unit ? ` [${course.unit}]` : ""), make("div", { class: "terms" }, charts));
  }

  draw() {
    if (this.host.hidden) return;
    const colours = palette();
    for (const chart of this.charts) drawTerm(chart, colours);
  }
}

function drawTerm({ canvas, course, variable }, colours) {
  const { g, width, height } = begin(canvas);
  const box = { left: AREA.left, right: width - AREA.right, top: AREA.top, bottom: height - AREA.bottom };
  if (box.right - box.left < 20) return;
  const low = course.low ?? course.term, high = course.high ?? course.term;
  const x = scaled(variable.values, box.left, box.right), y = scaled([...low, ...high, 0], box.bottom, box.top);
  axis(g, x, y, box, variable, colours);
  Object.assign(g, { strokeStyle: colours.line, fillStyle: colours.model });
  course.term.forEach((term, i) => {
    if (!Number.isFinite(term) || !Number.isFinite(variable.values[i])) return;
    const at = x.to(variable.values[i]);
    g.beginPath();
    g.moveTo(at, y.to(low[i]));
    g.lineTo(at, y.to(high[i]));
    g.stroke();
  });
  course.term.forEach((term, i) => Number.isFinite(term) && g.fillRect(x.to(variable.values[i]) - 1.25, y.to(term) - 1.25, 2.5, 2.5));
}

function scaled(values, from, to) {
  const known = values.filter(Number.isFinite);
  let [low, high] = [known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), -Infinity)];
  if (!(high > low)) [low, high] = [(low || 0) - 1, (high || 0) + 1];
  return { low, high, to: (value) => from + ((value - low) / (high - low)) * (to - from) };
}

function axis(g, x, y, box, variable, colours) {
  const ys = ticks(y.low, y.high, 4), xs = ticks(x.low, x.high, 4);
  g.lineWidth = 1;
  tickLabels(ys).forEach((label, i) => {
    const at = Math.round(y.to(ys[i])) + 0.5;
    g.strokeStyle = ys[i] === 0 ? colours.soft : colours.line;
    g.beginPath();
    g.moveTo(box.left, at);
    g.lineTo(box.right, at);
    g.stroke();
    text(g, label, box.left - 5, at, colours.soft, { align: "right", base: "middle", size: 10 });
  });
  tickLabels(xs).forEach((label, i) => text(g, label, x.to(xs[i]), box.bottom + 12, colours.soft, { align: "center", size: 10 }));
  text(g, variable.unit ? `${variable.name} [${variable.unit}]` : variable.name, (box.left + box.right) / 2, box.bottom + 26, colours.soft, { align: "center", size: 11 });
}
