// Binary frames of curves: what they hold is written in protocol.py.

/** The header of a frame and its arrays: `runs.get(run).get(signal)` is `{time, values, residual}`, those it has; times
 * are those of the recording's clock. */
export function readFrame(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const array = (at, n) => (at === undefined || at === null ? null : new Float32Array(buffer, 4 + length + 4 * at, n));
  const times = (run, s) => {
    const passed = array(s.time_at, s.n);
    return passed && Float64Array.from(passed, (time) => run.from + time);
  };
  const runs = new Map();
  for (const run of header.runs) {
    const signals = new Map();
    for (const s of run.signals) {
      signals.set(s.name, {
        time: times(run, s),
        values: array(s.values_at, s.n),
        residual: array(s.residual_at, s.n),
      });
    }
    runs.set(run.name, signals);
  }
  return { kind: header.kind, version: header.version, label: header.label ?? "", runs };
}
