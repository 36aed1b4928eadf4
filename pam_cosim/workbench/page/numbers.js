// Numbers as a person reads them.

/** Three significant digits, "–" for a number that does not exist. */
export function number(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text;
  if (size >= 1e6 || size < 1e-4) text = exponential(value, digits);
  else if (size >= 10 ** digits) text = Number(value.toPrecision(digits)).toFixed(0);
  else text = value.toPrecision(digits);
  if (text.includes("e")) text = exponential(value, digits);
  return text.replace("-", "−");
}

function exponential(value, digits) {
  return value.toExponential(digits - 1).replace("e+", "e");
}

/** A number with its unit. */
export function quantity(value, unit, digits = 3) {
  const text = number(value, digits);
  return unit && text !== "–" ? `${text} ${unit}` : text;
}

/** A number for an input field: as many digits as tell it apart, no more. */
export function plain(value, digits = 5) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(digits))) : "";
}

/** A time [s] to about 1e-4 of the span of its run, whatever clock it is of. */
export function moment(time, span) {
  const decimals = Math.ceil(4 - Math.log10(span));
  return Number(time.toFixed(Math.min(12, Math.max(0, decimals))));
}

/** At most `most` round numbers from `low` to `high`. */
export function ticks(low, high, most) {
  const span = high - low;
  if (!(span > 0) || most < 1) return [];
  const rough = span / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((s) => s >= rough * 0.999);
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; i++) found.push(i * step);
  return found;
}

/** Labels of ticks, all with the same number of decimals. */
export function tickLabels(values) {
  if (values.length === 0) return [];
  const step = values.length > 1 ? values[1] - values[0] : Math.abs(values[0]) || 1;
  const decimals = Math.min(6, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  return values.map((value) => (Math.abs(value) < step * 1e-6 ? 0 : value).toFixed(decimals).replace("-", "−"));
}

/** Seconds as a clock: "0:42". */
export function clock(seconds) {
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** How long something took: "4.7 s", "1:05 min". */
export function lasted(seconds) {
  return seconds < 60 ? `${seconds.toFixed(1)} s` : `${clock(seconds)} min`;
}
