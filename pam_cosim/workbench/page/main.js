// Puts the page together: what comes from the server goes to the parts that show it, what is pressed goes back.

import { AddDialog } from "./add.js";
import { Balances } from "./balances.js";
import { Connection, Newest } from "./connection.js";
import { Curves } from "./curves.js";
import { Diagnosis } from "./diagnosis.js";
import { DropPage } from "./drop.js";
import { Effects } from "./effects.js";
import { download } from "./export.js";
import { byId, make, say } from "./element.js";
import { Ladder } from "./ladder.js";
import { clock, lasted } from "./numbers.js";
import { Parameters } from "./parameters.js";
import { Rules, Runs } from "./runs.js";
import { Starts } from "./starts.js";
import { StudyPage } from "./study.js";
import { tabs } from "./tabs.js";
import { theme } from "./theme.js";
import { View } from "./view.js";
import { Whole } from "./whole.js";

const view = new View();
const NAMES = { fit: "The fit", diagnose: "The diagnosis", check: "The check" };
const ENDS = { done: "is done", stopped: "was ended", failed: "has failed" };
const WORKING = "Working …",
  PATIENCE = 500; // ms, after which it is said that a command takes long
const done = new Set(); // what was done in this study: it says what comes next
let study = null,
  busy = null,
  verdict = null,
  told = null, // the last step
  warned = "", // of runs that the model cannot begin as they do
  connected = false;

/** Sends a command; what is wrong is said at the top, or to `failed`. The answer, or null. */
async function ask(what, values = {}, failed = alert) {
  const slow = setTimeout(() => status(WORKING), PATIENCE);
  try {
    const answer = await connection.ask(what, values);
    if (failed === alert && byId("alert").dataset.of === "command") byId("alert").hidden = true;
    return answer ?? {};
  } catch (problem) {
    failed(problem);
    return null;
  } finally {
    clearTimeout(slow);
    if (byId("status-text").textContent === WORKING) status(busy ? busy.text : told || "Ready");
  }
}

const newest = new Newest((values) => ask("set", { values, dragged: true }));
const set = (values, typed = false) => (typed ? ask("set", { values }) : newest.give(values));

const parts = {
  curves: new Curves(byId("curves"), view, (run, ends) => parts.starts.cut(run, ends), ask),
  ladder: new Ladder(byId("ladder")),
  runs: new Runs(byId("run-list"), view, ask),
  starts: new Starts(byId("starts"), view, set, ask),
  rules: new Rules(byId("rule-list"), view),
  parameters: new Parameters(byId("parameters"), set, ask),
  effects: new Effects(byId("effects"), ask),
  diagnosis: new Diagnosis(byId("diagnosis"), ask),
  balances: new Balances(byId("balances")),
  whole: new Whole(byId("study"), set, ask),
  study: new StudyPage(byId("study"), ask),
  add: new AddDialog(byId("add-dialog"), ask),
  drop: new DropPage(byId("drop"), ask, alert),
};

const showTab = tabs(byId("tabs"), (id) => {
  byId("whole").hidden = byId("legend").hidden = byId("download").hidden = id !== "curves";
  if (id === "curves") parts.curves.later();
  if (id === "balances") parts.balances.draw();
});

const hear = {
  study(event) {
    study = event;
    const drop = event.state === "drop";
    byId("drop").hidden = !drop;
    byId("desk").hidden = byId("ladder").hidden = drop;
    byId("actions").classList.toggle("none", drop);
    say(byId("title"), event.title || "Workbench");
    say(byId("model"), drop ? "" : [event.short, event.with_effects].filter(Boolean).join(", "));
    document.title = `${event.title || "Workbench"} – pam-cosim`;
    if (drop) parts.drop.study(event);
    else
      for (const part of [
        parts.curves,
        parts.ladder,
        parts.runs,
        parts.starts,
        parts.parameters,
        parts.effects,
        parts.diagnosis,
        parts.whole,
        parts.study,
      ])
        part.study(event);
    lock();
  },
  scores(event) {
    parts.ladder.show(event);
    parts.runs.show(event);
    parts.parameters.values(event.values);
    const warnings = (event.warnings ?? []).map((text) => make("p", { class: "caution" }, `LOOK FIRST: ${text}`));
    byId("look-first").replaceChildren(...warnings);
  },
  starts(event) {
    parts.starts.show(event);
    const failed = new Set((parts.runs.scores?.failed ?? []).map(({ run }) => run)); // it is said of these already
    const impossible = event.runs.filter((one) => one.warning && !failed.has(one.run)).map((one) => one.text);
    if (impossible.join() !== warned) {
      warned = impossible.join();
      if (warned) alert({ text: impossible.join("; ") });
    }
  },
  where: (event) => parts.rules.show(event),
  busy(event) {
    busy = event;
    if (event.what === "diagnose" && !event.held) {
      if (!parts.diagnosis.running) showTab("diagnosis");
      parts.diagnosis.begin();
    }
    status(event.held ? `Stopped: ${event.text}. Resume lets it go on, End gives it up.` : event.text);
    lock();
  },
  idle(event) {
    busy = null;
    if (event.what === "diagnose") parts.diagnosis.end();
    status(
      ENDS[event.end]
        ? `${NAMES[event.what] ?? event.what} ${ENDS[event.end]} after ${lasted(event.seconds)}`
        : "Ready",
    );
    lock();
  },
  progress(event) {
    parts.parameters.values(event.values);
    if (event.text) status(event.text);
  },
  message(event) {
    if (busy?.what !== "fit") parts.diagnosis.message(event);
    if (busy && !busy.held) status(event.text);
  },
  no_diagnosis() {
    verdict = null;
    parts.diagnosis.forget();
    legend();
    parts.balances.empty();
    lock();
  },
  candidate: (event) => parts.diagnosis.candidate(event),
  ranking: (event) => parts.diagnosis.rank(event),
  verdict(event) {
    verdict = event;
    parts.diagnosis.show(event);
    legend();
    lock();
  },
  checked(event) {
    parts.diagnosis.told(event);
    showTab("diagnosis");
  },
  ledger: (event) => parts.balances.show(event),
  added(event) {
    parts.add.wrote(event);
    parts.study.wrote(event);
    status(`${event.file} is written`);
  },
  saved: (event) => status(`Saved as ${event.file}`),
  steps(event) {
    const last = event.steps.at(-1)?.text ?? "";
    if (!busy && told !== null && last !== told) status(last || "Ready");
    told = last;
    done.clear();
    parts.study.did(event.steps);
    for (const { text } of event.steps) done.add(text.split(" ")[0]);
    byId("undo").dataset.none = String(!event.steps.length);
    say(byId("save"), event.saved && event.steps.length ? "Saved" : "Save");
    lock();
  },
  dropped: (event) => parts.drop.dropped(event),
  draft: (event) => parts.drop.draft(event),
  failed: alert,
};

const connection = new Connection(
  (event) => hear[event.event]?.(event),
  (frame) => {
    parts.curves.frame(frame);
    if (frame.kind !== "measured") legend();
  },
  (open) => {
    connected = open;
    if (open) forget();
    status(open ? "Ready" : "The connection is lost; trying again …");
    lock();
  },
);

/** What a server tells anew to each connection: what it does not tell, it no longer has. */
function forget() {
  busy = null;
  parts.diagnosis.restart();
  parts.curves.frames.reference = parts.curves.frames.found = null;
  hear.no_diagnosis();
}

function alert(problem) {
  const place = [
    problem.file,
    problem.line ? `line ${problem.line}` : "",
    problem.column ? `column ${problem.column}` : "",
  ]
    .filter(Boolean)
    .join(", ");
  say(byId("alert-text"), [place, problem.text].filter(Boolean).join(": "));
  Object.assign(byId("alert"), { hidden: false }).dataset.of = "command";
}

function status(text) {
  say(byId("status-text"), text ?? "");
}

function lock() {
  const held = Boolean(busy && !busy.held) || !connected;
  for (const id of ["fit", "diagnose", "add", "undo", "save"]) byId(id).disabled = held || !study;
  byId("undo").disabled ||= byId("undo").dataset.none === "true";
  say(byId("stop"), busy?.held ? "Resume" : "Stop");
  byId("stop").disabled = !busy || !connected;
  byId("discard").hidden = !busy?.held;
  for (const part of [parts.parameters, parts.starts, parts.effects, parts.diagnosis, parts.whole]) part.lock(held);
  document.body.classList.toggle("busy", Boolean(busy));
  const next = verdict?.kind === "identified" ? "add" : done.has("fit") || done.has("diagnose") ? "diagnose" : "fit";
  for (const id of ["fit", "diagnose", "add"]) byId(id).classList.toggle("main", id === next);
}

function legend() {
  const { reference: before, found } = parts.curves.frames;
  const entry = (name, words) => make("span", { class: `key ${name}`, title: words }, words);
  parts.ladder.found(found && verdict ? verdict.found : null);
  byId("legend").replaceChildren(
    entry("measured", "measured"),
    entry("model", "model"),
    before ? entry("before", parts.curves.labels.reference || "before") : "",
    found ? entry("found", parts.curves.labels.found) : "",
  );
}

byId("fit").addEventListener("click", () =>
  ask("fit", { method: parts.parameters.fitBy?.value ?? "least-squares", free: parts.parameters.free() }),
);
byId("diagnose").addEventListener("click", () => ask("diagnose", parts.diagnosis.wishes()));
byId("stop").addEventListener("click", () => ask(busy?.held ? "resume" : "stop"));
byId("discard").addEventListener("click", () => ask("discard"));
byId("add").addEventListener("click", () =>
  parts.add.open(parts.effects.on(), verdict?.effects ?? [], study.short),
);
byId("undo").addEventListener("click", () => ask("undo"));
byId("save").addEventListener("click", () => ask("save"));
byId("whole").addEventListener("click", () => view.whole());
byId("download").addEventListener("change", ({ target }) => {
  if (target.value) download(parts.curves, target.value, study?.title ?? "");
  target.value = "";
});
byId("alert-close").addEventListener("click", () => (byId("alert").hidden = true));
theme(byId("theme"), () => {
  parts.curves.theme();
  parts.ladder.theme();
  parts.balances.draw();
});
setInterval(
  () => say(byId("status-time"), busy && !busy.held ? clock(Math.max(0, Date.now() / 1000 - busy.began)) : ""),
  500,
);
