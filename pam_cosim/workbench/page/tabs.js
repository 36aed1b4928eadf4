// Tabs by pointer and keys: arrows move between them.

/** `changed(panel)` is told which panel is shown. */
export function tabs(list, changed) {
  const all = [...list.querySelectorAll("[role=tab]")];
  const panel = (tab) => document.getElementById(tab.getAttribute("aria-controls"));
  const show = (chosen, focus = false) => {
    for (const tab of all) {
      const on = tab === chosen;
      tab.setAttribute("aria-selected", String(on));
      tab.tabIndex = on ? 0 : -1;
      panel(tab).hidden = !on;
    }
    if (focus) chosen.focus();
    changed(panel(chosen).id);
  };
  for (const tab of all) {
    tab.addEventListener("click", () => show(tab));
    tab.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (step) show(all[(all.indexOf(tab) + step + all.length) % all.length], true);
    });
  }
  return (id) => show(all.find((tab) => tab.getAttribute("aria-controls") === id));
}
