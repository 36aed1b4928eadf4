// The curves that are shown as a file: PNG and SVG with a legend, CSV with their numbers.

import { drawAxis, drawNames } from "./axis-charts.js";
import { begin, lower, text } from "./drawing.js";
import { moment } from "./numbers.js";
import { LEFT, drawSignal } from "./signal-chart.js";

const HEAD = 18; // px for the name of a signal
const NAMES = 20,
  AXIS = 22,
  SHARP = 2; // pixels of a PNG for each of the screen

const escaped = (text) => String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");

/** What a canvas is drawn with, which keeps the strokes as SVG. */
class Recorder {
  constructor() {
    Object.assign(this, { parts: [], path: "", dashes: [], stack: [], globalAlpha: 1, lineWidth: 1, clips: 0 });
    this.measure = document.createElement("canvas").getContext("2d");
  }

  setTransform() {}
  clearRect() {}
  save() {
    this.stack.push(this.parts.length);
  }
  restore() {
    this.stack.pop();
  }
  rect() {}
  clip() {}
  beginPath() {
    this.path = "";
  }
  moveTo(x, y) {
    this.path += `M${x.toFixed(1)} ${y.toFixed(1)}`;
  }
  lineTo(x, y) {
    this.path += `L${x.toFixed(1)} ${y.toFixed(1)}`;
  }
  arc(x, y, r) {
    this.path += `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
  }
  setLineDash(dashes) {
    this.dashes = dashes;
  }
  stroke() {
    const dash = this.dashes.length ? ` stroke-dasharray="${this.dashes.join(" ")}"` : "";
    if (this.path)
      this.parts.push(
        `<path d="${this.path}" fill="none" stroke="${this.strokeStyle}" stroke-width="${this.lineWidth}"${dash}/>`,
      );
  }
  fillRect(x, y, width, height) {
    if (!(width > 0) || height === 0) return;
    const top = Math.min(y, y + height);
    this.parts.push(
      `<rect x="${x.toFixed(1)}" y="${top.toFixed(1)}" width="${width.toFixed(1)}" height="${Math.abs(height).toFixed(1)}" ` +
        `fill="${this.fillStyle}" fill-opacity="${this.globalAlpha}"/>`,
    );
  }
  measureText(text) {
    this.measure.font = this.font ?? "11px sans-serif";
    return this.measure.measureText(text);
  }
  fillText(text, x, y) {
    const anchor = { right: "end", center: "middle" }[this.textAlign] ?? "start";
    const down = this.textBaseline === "middle" ? ' dominant-baseline="central"' : "";
    const size = /(\d+)px/.exec(this.font ?? "")?.[1] ?? 11;
    const bold = /^600/.test(this.font ?? "") ? ' font-weight="600"' : "";
    this.parts.push(
      `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" font-size="${size}" text-anchor="${anchor}" ` +
        `fill="${this.fillStyle}"${down}${bold}>${escaped(text)}</text>`,
    );
  }
}

/** The parts of the picture: what draws each on a canvas, with its height; without cursor and grips. */
function lanes(curves) {
  const { signals, colours, rows } = curves;
  const frames = curves.shown();
  const view = Object.assign(Object.create(curves.view), { cursor: null, bare: true });
  const title = (signal) => `${signal.name}, ${signal.quantity ?? ""}${signal.unit ? ` [${signal.unit}]` : ""}`;
  return [
    { height: HEAD, draw: (canvas) => drawLegend(canvas, curves) },
    { height: NAMES, draw: (canvas) => drawNames(canvas, view, colours) },
    ...signals.map((signal, i) => ({
      height: rows[i].canvas.clientHeight,
      title: title(signal),
      draw: (canvas) => drawSignal(canvas, view, signal, frames, colours),
    })),
    { height: AXIS, draw: (canvas) => drawAxis(canvas, view, curves.along(), colours) },
  ];
}

/** Which line is which. */
function drawLegend(canvas, { frames, labels, colours }) {
  const { g } = begin(canvas);
  const words = { measured: "measured", model: "model", reference: labels.reference || "before", found: labels.found };
  let x = LEFT;
  for (const [kind, name] of Object.entries(words)) {
    if (!frames[kind]) continue;
    const dashes = { reference: [4, 3], found: [6, 3] }[kind] ?? [];
    Object.assign(g, { strokeStyle: colours[kind === "reference" ? "before" : kind], lineWidth: 1.7 });
    g.setLineDash(dashes);
    g.beginPath();
    g.moveTo(x, HEAD / 2);
    g.lineTo(x + 20, HEAD / 2);
    g.stroke();
    text(g, name, x + 26, HEAD / 2, colours.ink, { base: "middle" });
    x += 44 + g.measureText(name).width;
  }
}

/** The curves as they are shown, as the text of an SVG, with its size. */
function picture(curves) {
  const width = curves.rows[0].canvas.clientWidth;
  let top = 0;
  const parts = lanes(curves).map(({ height, title, draw }, i) => {
    const recorder = new Recorder();
    const canvas = { clientWidth: width, clientHeight: height, width, height, getContext: () => recorder };
    draw(canvas);
    const head = title ? HEAD : 0;
    const clip = `<clipPath id="lane-${i}"><rect width="${width}" height="${height}"/></clipPath>`;
    const name = title
      ? `<text x="4" y="${top + 13}" font-size="12" fill="${curves.colours.ink}">${escaped(title)}</text>`
      : "";
    const made = `${name}${clip}<g transform="translate(0 ${top + head})" clip-path="url(#lane-${i})">${recorder.parts.join("")}</g>`;
    top += head + height;
    return made;
  });
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${top}" viewBox="0 0 ${width} ${top}" ` +
    `font-family="system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif">` +
    `<rect width="${width}" height="${top}" fill="${curves.colours.ground}"/>${parts.join("")}</svg>`;
  return { svg, width, height: top };
}

/** A picture as pixels, `SHARP` for each of the screen. */
async function pixels({ svg, width, height }) {
  const image = Object.assign(new Image(), { src: `data:image/svg+xml,${encodeURIComponent(svg)}` });
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: SHARP * width, height: SHARP * height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

/** The samples that are shown: a row for each sample of each signal. */
export function csvOf(curves) {
  const { view, signals } = curves;
  const frames = curves.shown();
  const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const value = (one) => (one === undefined || Number.isNaN(one) ? "" : String(Number(one.toPrecision(7))));
  const lines = ["run,signal,unit,time,measured,model,residual"];
  for (const run of view.visible())
    for (const signal of signals) {
      const of = (kind) => frames[kind]?.get(run.name)?.get(signal.name);
      const { time, values } = of("measured") ?? { time: [] };
      const model = of("model");
      const [first, last] = run.points
        ? [0, time.length]
        : [lower(time, view.from - run.shift), lower(time, view.to - run.shift + 1e-9)];
      for (let i = first; i < last; i++)
        lines.push(
          [quoted(run.name), signal.name, signal.unit, moment(time[i], run.span), value(values[i]), value(model?.values?.[i]), value(model?.residual?.[i])].join(),
        );
    }
  return `${lines.join("\n")}\n`;
}

function save(name, content) {
  const address = URL.createObjectURL(content);
  const link = Object.assign(document.createElement("a"), { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/** Saves what is shown: "png", "svg" or "csv". */
export async function download(curves, kind, title) {
  const name = `${title.replace(/[^\p{L}\p{N}_-]+/gu, "-") || "curves"}.${kind}`;
  if (kind === "csv") save(name, new Blob([csvOf(curves)], { type: "text/csv" }));
  else if (kind === "svg") save(name, new Blob([picture(curves).svg], { type: "image/svg+xml" }));
  else save(name, await pixels(picture(curves)));
}
