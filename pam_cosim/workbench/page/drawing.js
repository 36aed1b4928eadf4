// What every chart draws: lines thinned to pixels, bands, axes.

const FONT = "system-ui, sans-serif";

/** Makes a canvas as sharp as the screen; its size in CSS pixels. */
export function begin(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = canvas;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  const g = canvas.getContext("2d");
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.clearRect(0, 0, width, height);
  return { g, width, height };
}

/** Text at a place; `align` and `base` as in a canvas. */
export function text(g, words, x, y, colour, { align = "left", base = "alphabetic", size = 11, bold = false } = {}) {
  Object.assign(g, { fillStyle: colour, textAlign: align, textBaseline: base, font: `${bold ? "600 " : ""}${size}px ${FONT}` });
  g.fillText(words, x, y);
}

/** A path through the samples between two indices, thinned to the lowest and highest of each pixel column. */
export function trace(g, xs, ys, first, last, toX, toY) {
  let column = NaN, low = 0, high = 0, leave = 0, pen = false;
  const flush = () => {
    if (Number.isNaN(column)) return;
    if (high > low) {
      g.lineTo(column, low);
      g.lineTo(column, high);
      g.lineTo(column, leave);
    }
  };
  for (let i = first; i < last; i++) {
    const value = ys[i];
    if (value !== value) {
      flush();
      column = NaN;
      pen = false;
      continue;
    }
    const x = Math.round(2 * toX(xs[i])) / 2, y = toY(value);
    if (x !== column) {
      flush();
      if (pen) g.lineTo(x, y);
      else g.moveTo(x, y);
      [column, low, high, pen] = [x, y, y, true];
    } else {
      if (y < low) low = y;
      if (y > high) high = y;
    }
    leave = y;
  }
  flush();
}

/** Indices [first, last) of the sorted `xs` that lie in a range, with a neighbour on each side. */
export function within(xs, from, to) {
  return [Math.max(0, lower(xs, from) - 1), Math.min(xs.length, lower(xs, to) + 2)];
}

/** The index of the first of the sorted `xs` that is not below a value. */
export function lower(xs, value) {
  let a = 0, b = xs.length;
  while (a < b) {
    const middle = (a + b) >> 1;
    if (xs[middle] < value) a = middle + 1;
    else b = middle;
  }
  return a;
}
