// Tabs by pointer and keys: arrows move between them, Back goes to the one before.

/** `changed(panel)` is told which panel is shown. */
export function tabs(list, changed) {
  const all = [...list.querySelectorAll("[role=tab]")];
  const panel = (tab) => document.getElementById(tab.getAttribute("aria-controls"));
  const show = (chosen, { focus = false, remember = true } = {}) => {
    const other = chosen.getAttribute("aria-selected") !== "true";
    for (const tab of all) {
      const on = tab === chosen;
      tab.setAttribute("aria-selected", String(on));
      tab.tabIndex = on ? 0 : -1;
      panel(tab).hidden = !on;
    }
    if (focus) chosen.focus();
    if (other && remember) history.pushState({ tab: panel(chosen).id }, "");
    changed(panel(chosen).id);
  };
  const named = (id) => all.find((tab) => tab.getAttribute("aria-controls") === id);
  for (const tab of all) {
    tab.addEventListener("click", () => show(tab));
    tab.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (step) show(all[(all.indexOf(tab) + step + all.length) % all.length], { focus: true });
    });
  }
  // Back stays on the page: below the first tab lies an entry that leads to it again
  const first = panel(all[0]).id;
  if (!history.state?.tab) {
    history.replaceState({ bottom: true }, "");
    history.pushState({ tab: first }, "");
  }
  addEventListener("popstate", ({ state }) => {
    if (!state?.tab) history.pushState({ tab: first }, "");
    show(named(state?.tab ?? first) ?? all[0], { remember: false });
  });
  return (id) => show(named(id));
}
