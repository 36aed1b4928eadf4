// Wheel, drag and keys on charts that share a view.

import { moment } from "./numbers.js";
import { handleAt, scale } from "./signal-chart.js";

const SMALLEST = 5; // px that a drag must be long to be a range

/**
 * Wheel zooms, drag shows a range, drag with Shift moves, double click shows all, moving reads out; an end of a run
 * that is dragged cuts it, which `cut(run, {begin or end})` is told.
 */
export function followPointer(canvas, view, select, cut) {
  let begun = null;
  const handle = (event) => handleAt(view, canvas.clientWidth, event.offsetX);
  const dragEnd = (event) => {
    const { run, side } = begun.handle;
    const at = Math.min(run.start + run.span, Math.max(run.start, place(event)));
    view.cutting = { run: run.name, side, at };
    view.tell();
  };
  const cutEnd = () => {
    const { run, side } = begun.handle,
      at = view.cutting?.at;
    view.cutting = begun = null;
    view.tell();
    if (at !== undefined) cut(run.name, { [side]: moment(at - run.shift, run.span) });
  };
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return scale(view, box.width).back(event.clientX - box.left);
  };
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) view.pan(event.deltaX / 800);
      else view.zoom(1.0015 ** event.deltaY, place(event));
    },
    { passive: false },
  );
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    const { clientX: x, shiftKey: moves } = event;
    begun = { x, last: x, from: place(event), moves, handle: moves ? null : handle(event) };
  });
  canvas.addEventListener("pointermove", (event) => {
    canvas.classList.toggle("at-end", Boolean(begun ? begun.handle : handle(event)));
    if (begun?.handle) dragEnd(event);
    else if (begun?.moves) {
      view.pan((begun.last - event.clientX) / canvas.clientWidth);
      begun.last = event.clientX;
    } else if (begun) select([begun.from, place(event)]);
    view.point(place(event));
  });
  canvas.addEventListener("pointerup", (event) => {
    if (begun?.handle) return cutEnd();
    const range =
      begun && !begun.moves && Math.abs(event.clientX - begun.x) >= SMALLEST ? [begun.from, place(event)] : null;
    begun = null;
    select(null);
    if (range) view.show(Math.min(...range), Math.max(...range));
  });
  canvas.addEventListener("pointercancel", () => ((begun = view.cutting = null), select(null)));
  canvas.addEventListener("pointerleave", () => view.point(null));
  canvas.addEventListener("dblclick", () => view.whole());
}

/** Arrows move, plus and minus zoom, Home shows all, Shift and arrows read out. */
export function followKeys(element, view) {
  element.addEventListener("keydown", (event) => {
    const step = event.key === "ArrowLeft" ? -1 : 1;
    const done = {
      ArrowLeft: () => (event.shiftKey ? readOn(view, step) : view.pan(0.1 * step)),
      ArrowRight: () => (event.shiftKey ? readOn(view, step) : view.pan(0.1 * step)),
      "+": () => view.zoom(1 / 1.4),
      "=": () => view.zoom(1 / 1.4),
      "-": () => view.zoom(1.4),
      Home: () => view.whole(),
      Escape: () => view.point(null),
    }[event.key];
    if (!done || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    done();
  });
}

function readOn(view, step) {
  const at = view.cursor ?? (view.from + view.to) / 2;
  view.point(Math.min(view.to, Math.max(view.from, at + (step * (view.to - view.from)) / 200)));
}
