// What every chart draws: lines thinned to pixels, bands, axes.

const OUT = 0.6; // px by which a sample must stand out of its column to be drawn
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
  Object.assign(g, {
    fillStyle: colour,
    textAlign: align,
    textBaseline: base,
    font: `${bold ? "600 " : ""}${size}px ${FONT}`,
  });
  g.fillText(words, x, y);
}

/**
 * A path through the samples between two indices, thinned to a point for each pixel column, and to its lowest and
 * highest where these stand out: strokes are what costs time.
 */
export function trace(g, xs, ys, first, last, toX, toY) {
  const origin = xs[first], // not zero: a clock may be far from it
    offset = toX(origin),
    factor = toX(origin + 1) - offset;
  let column = NaN,
    low = 0,
    high = 0,
    enter = 0,
    leave = 0;
  const flush = () => {
    if (low < Math.min(enter, leave) - OUT) g.lineTo(column, low);
    if (high > Math.max(enter, leave) + OUT) g.lineTo(column, high);
    g.lineTo(column, leave);
  };
  for (let i = first; i < last; i++) {
    const value = ys[i];
    if (value !== value) {
      if (column === column) flush();
      column = NaN;
      continue;
    }
    const exact = offset + factor * (xs[i] - origin),
      y = toY(value);
    const x = Math.round(exact);
    if (x === column) {
      if (y < low) low = y;
      else if (y > high) high = y;
      leave = y;
    } else {
      if (column === column) flush();
      else g.moveTo(x, y);
      column = x;
      low = high = enter = leave = y;
    }
  }
  if (column === column) flush();
}

/** Indices [first, last) of the sorted `xs` that lie in a range, with a neighbour on each side. */
export function within(xs, from, to) {
  return [Math.max(0, lower(xs, from) - 1), Math.min(xs.length, lower(xs, to) + 2)];
}

/** The index of the first of the sorted `xs` that is not below a value. */
export function lower(xs, value) {
  let a = 0,
    b = xs.length;
  while (a < b) {
    const middle = (a + b) >> 1;
    if (xs[middle] < value) a = middle + 1;
    else b = middle;
  }
  return a;
}
