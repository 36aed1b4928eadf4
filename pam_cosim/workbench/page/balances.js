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
    this.host.replaceChildren(
      make(
        "p",
        { class: "soft" },
        "A diagnosis asks each balance for the term that is missing in it, before any effect is tried. " +
          "Press Diagnose; the terms stand here.",
      ),
    );
  }

  show(ledger) {
    const rows = ledger.rows.map((r) => [r.balance, r.share, r.explains, r.size, r.outside, r.note]);
    this.charts = [];
    const courses = (ledger.courses ?? []).map((course) => this.course(course));
    this.host.replaceChildren(
      make("h2", {}, "Which balance fails"),
      make("p", {}, ledger.sentence),
      table(["balance", "#share", "#explains alone", "#missing term, rms", "#outside two sd", "to know"], rows),
      ...courses,
      ...(ledger.meanings?.length ? [make("p", { class: "soft" }, `Signs. ${ledger.meanings.join(". ")}.`)] : []),
      make(
        "ul",
        {},
        (ledger.notes ?? []).map((note) => make("li", {}, note)),
      ),
    );
    this.draw();
  }

  course(course) {
    const charts = course.against.map((variable) => {
      const canvas = make("canvas", {
        class: "term",
        role: "img",
        "aria-label": `Missing term of the ${course.balance} balance over ${variable.name}`,
      });
      this.charts.push({ canvas, variable });
      return canvas;
    });
    const unit = course.unit ? ` [${course.unit}]` : "";
    return make(
      "section",
      {},
      make("h3", {}, `What is missing in the ${course.balance} balance${unit}`),
      make("div", { class: "terms" }, charts),
      make("p", { class: "soft" }, "Dots: instants. Line: means with two standard deviations."),
    );
  }

  draw() {
    if (this.host.hidden) return;
    const colours = palette();
    for (const chart of this.charts) drawTerm(chart, colours);
  }
}

function drawTerm({ canvas, variable }, colours) {
  const { g, width, height } = begin(canvas);
  const box = { left: AREA.left, right: width - AREA.right, top: AREA.top, bottom: height - AREA.bottom };
  if (box.right - box.left < 20) return;
  const {
    points: [xs, ys],
    at,
    mean,
    low,
    high,
  } = variable;
  const x = scaled(xs, box.left, box.right),
    y = scaled([...ys, ...low, ...high, 0], box.bottom, box.top);
  axis(g, x, y, box, variable, colours);
  g.fillStyle = colours.edge;
  xs.forEach((value, i) => g.fillRect(x.to(value) - 1, y.to(ys[i]) - 1, 2, 2));
  Object.assign(g, { strokeStyle: colours.model, fillStyle: colours.model, lineWidth: 1.5 });
  g.beginPath();
  at.forEach((value, i) => g.lineTo(x.to(value), y.to(mean[i])));
  at.forEach((value, i) => {
    g.moveTo(x.to(value), y.to(low[i]));
    g.lineTo(x.to(value), y.to(high[i]));
  });
  g.stroke();
  at.forEach((value, i) => g.fillRect(x.to(value) - 2, y.to(mean[i]) - 2, 4, 4));
}

function scaled(values, from, to) {
  const known = values.filter(Number.isFinite);
  let [low, high] = [
    known.reduce((a, b) => Math.min(a, b), Infinity),
    known.reduce((a, b) => Math.max(a, b), -Infinity),
  ];
  if (!(high > low)) [low, high] = [(low || 0) - 1, (high || 0) + 1];
  return { low, high, to: (value) => from + ((value - low) / (high - low)) * (to - from) };
}

function axis(g, x, y, box, variable, colours) {
  const ys = ticks(y.low, y.high, 4),
    xs = ticks(x.low, x.high, 4);
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
  tickLabels(xs).forEach((label, i) =>
    text(g, label, x.to(xs[i]), box.bottom + 12, colours.soft, { align: "center", size: 10 }),
  );
  text(
    g,
    variable.unit ? `${variable.name} [${variable.unit}]` : variable.name,
    (box.left + box.right) / 2,
    box.bottom + 26,
    colours.soft,
    { align: "center", size: 11 },
  );
}
