// Colours of the charts, from the style sheet, so that light and dark are decided in one place.

const NAMES = [
  "ink",
  "soft",
  "line",
  "band",
  "ground",
  "edge",
  "noise",
  "measured",
  "model",
  "before",
  "found",
  "lit",
  "cold",
  "warm",
  "middle",
];

/** The colours of the theme that holds now. */
export function palette() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** A colour [red, green, blue] from cold over the middle to warm for -1 ... 1. */
export function diverging(colours, value) {
  const share = Math.min(1, Math.abs(value)) ** 0.75;
  const [from, to] = [rgb(colours.middle), rgb(value < 0 ? colours.cold : colours.warm)];
  return from.map((c, i) => Math.round(c + (to[i] - c) * share));
}

function rgb(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}
