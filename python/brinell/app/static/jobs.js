// SPDX-License-Identifier: BSD-3-Clause
// Runs: they are begun, followed, stopped and resumed.
"use strict";

const MOST_LEFT = 5; // unfinished runs with a row each
/** What the page knows of jobs beside what the server tells: which it has seen at work, and since when; which are stopping; whose rows are gone. */
const seen = { begun: new Map(), stopping: new Set(), dismissed: new Set(), last: null };
const END_OF_SERVER = "The server has ended; its runs are in the folder. Start brinell app again, and open its new address.";

function run() {
  const same = page.jobs.find((job) => job.name === seen.last?.name && isActiveJob(job.name) && seen.last.values === JSON.stringify(page.values));
  if (same) dialogue(`${same.name} computes this very case. Run it once more?`, [], beginRun);
  else beginRun().catch((error) => tell(error.message));
}

async function beginRun() {
  const values = JSON.stringify(page.values);
  const job = await ask("POST", "/api/run", { values: page.values, name: baseName() });
  seen.last = { name: job.name, values };
  for (const one of page.jobs) if (one.state === "finished") seen.dismissed.add(rowName(one));
  seen.begun.set(job.name, null);
  preview.abort?.abort();
  Object.assign(page, { live: null, before: null });
  tell("");
  await refresh();
  show(job.name);
}

async function refresh() {
  const { entries, jobs } = await ask("GET", "/api/files");
  Object.assign(page, { entries, jobs });
  const names = (kind) => entries.filter((one) => one.kind === kind);
  offer($("open"), [["", "a case of the folder"], ...names("case").map((one) => [one.name, one.name])]);
  const runs = names("run").filter(isOwn).map((one) => one.name);
  offer($("add-run"), [["", runs.length ? "…" : "none yet"], ...runs.map((name) => [name, name])]);
  $("data-files").replaceChildren(...names("data").map((one) => h("option", { value: one.name })));
  const results = [...runs, ...names("sweep").map((one) => one.name), ...names("fit").map((one) => one.name)];
  offer($("figures-of"), results.map((name) => [name, name]));
  drawJobs();
}

/** Whether a run is one by itself and none of a sweep. */
const isOwn = ({ name }) => !/\/runs\/\d+$/.test(name);
const rowName = (job) => `${job.state} ${job.name}`;

function drawJobs() {
  const known = new Set(page.jobs.map((job) => job.name));
  const left = page.entries.filter((one) => one.kind === "run" && !one.complete && isOwn(one) && !known.has(one.name)).map(({ name }) => ({ name, state: "not finished", kind: "run" }));
  const isTold = (job) => !seen.dismissed.has(rowName(job)) && (job.state !== "finished" || seen.begun.has(job.name));
  const all = [...page.jobs, ...left.slice(0, MOST_LEFT)].filter(isTold), rows = new Map([...$("jobs").children].map((row) => [row.dataset.state, row]));
  const drawn = all.map((job) => told(rows.get(rowName(job)) ?? jobRow(job), job));
  if (drawn.length !== $("jobs").children.length || drawn.some((row, i) => row !== $("jobs").children[i])) $("jobs").replaceChildren(...drawn);
}

/** A job without its progress: it stays while its state does, so that its button can be clicked and keeps the focus. */
function jobRow(job) {
  const button = (text, path) => h("button", { onclick: () => act(path, job.name) }, text);
  const isLive = job.state === "running" || job.state === "waiting", isLeft = job.kind !== "sweep" && ["stopped", "not finished", "failed"].includes(job.state);
  const dismiss = () => { seen.dismissed.add(rowName(job)); drawJobs(); };
  return h("div", { class: "job", "data-state": rowName(job) }, h("span", {}, job.name),
    job.state === "running" ? h("progress", { "aria-label": `Progress of ${job.name}` }) : null,
    h("span", { class: job.state === "failed" ? "error" : "quiet" }),
    isLeft ? button(job.kind === "fit" ? "Begin again" : "Go on", "/api/resume") : null, isLive ? button("Stop", "/api/stop") : null,
    isLive ? null : h("button", { class: "dismiss", "aria-label": `Take the line of ${job.name} away; its files stay`, title: "Take this line away; the files stay", onclick: dismiss }, "×"));
}

/** A job's row with how far it is. */
function told(row, job) {
  const bar = row.querySelector("progress"), begins = job.kind !== "fit" && job.of > 0;
  if (bar && begins) Object.assign(bar, { max: job.of, value: job.done }); // of others nobody knows how much there is
  row.children[bar ? 2 : 1].textContent = jobText(job);
  return row;
}

function jobText(job) {
  const things = job.kind === "run" ? "steps" : "runs", seconds = job.seconds ? ` in ${nice(Number(job.seconds.toPrecision(3)))} s` : "";
  if (job.state === "failed") return job.error;
  if (job.state === "finished") return `finished${job.of ? `: ${job.of} ${things}` : ""}${seconds}`;
  if (job.state === "stopped") return job.of ? `stopped after ${job.done} of ${job.of} ${things}` : "stopped";
  if (job.state !== "running") return job.state;
  if (seen.stopping.has(job.name)) return `stops after this ${job.kind === "run" ? "step" : "run"} …`;
  if (job.kind === "fit") return job.done ? `${job.done} runs, ${job.place}` : "begins";
  if (job.elsewhere) return `${job.done} steps so far; begun by another server or command`;
  return job.of ? `${job.done} of ${job.of} ${things}${timeLeft(job)}` : "begins";
}

/** Time that a job still takes if it goes on as since the page has seen it first. */
function timeLeft(job) {
  const now = performance.now() / 1000, { at, done } = seen.begun.get(job.name) ?? {};
  if (at === undefined || done > job.done) { seen.begun.set(job.name, { at: now, done: job.done }); return ""; }
  const took = now - at, rest = ((job.of - job.done) * took) / (job.done - done);
  return took < 2 || !Number.isFinite(rest) ? "" : `, about ${rest < 90 ? `${Math.ceil(rest)} s` : `${Math.round(rest / 60)} min`} left`;
}

async function act(path, name) {
  if (path === "/api/stop") { seen.stopping.add(name); drawJobs(); }
  if (path === "/api/resume") seen.begun.set(name, null);
  try { await ask("POST", path, { name }); } catch (error) { seen.stopping.delete(name); tell(error.message); }
  await refresh().catch(() => {});
}

/** Follows what runs, also runs of other tabs. */
async function watch() {
  const busy = page.jobs.some((job) => job.state === "running" || job.state === "waiting");
  try {
    const before = JSON.stringify(page.jobs);
    await refresh();
    isThere(true);
    for (const one of page.shown) if (!one.complete) await more(one);
    const begun = page.jobs.find((job) => job.kind === "fit" && isActiveJob(job.name));
    if (begun && !fit.name) await showFit(begun.name); // perhaps from another tab
    await followFit();
    drawFit();
    if (before !== JSON.stringify(page.jobs)) await ended(JSON.parse(before));
  } catch (error) { if (error.gone) isThere(false); else tell(error.message); }
  setTimeout(watch, busy || page.jobs.some((job) => job.state === "running") ? 250 : 2000);
}

/** Says whether the server is there; without it nothing can be begun. */
function isThere(is) {
  if ($("server-note").hidden === is) return;
  $("server-note").hidden = is;
  $("server-note").textContent = is ? "" : END_OF_SERVER;
  document.body.classList.toggle("alone", !is);
  for (const id of ["run", "save", "sweep-run", "fit-run"]) $(id).disabled = !is;
  if (is) { fit.asked = ""; drawCase(); }
}

async function ended(before) {
  for (const job of page.jobs) {
    const was = before.find((one) => one.name === job.name);
    if (job.state !== "running") seen.stopping.delete(job.name);
    if (job.kind === "sweep" && job.state === "finished" && was?.state !== "finished") showSweep(job.name);
  }
}
