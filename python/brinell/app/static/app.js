// SPDX-License-Identifier: BSD-3-Clause
// The page: the case, its runs, and what is shown of them.
"use strict";

const TOKEN = new URLSearchParams(location.search).get("token") ?? "";
const TAB = crypto.randomUUID();
const LIVE_SECONDS = 5; // a case that is foretold to take no longer follows its changes
const FIRST_AXES = { tugging: ["X", "F_X"], indentation: ["approach", "F_n"], rolling: ["x", "F_X"], fretting: ["displacement", "F_x"], sliding: ["way", "friction"] };
const $ = (id) => document.getElementById(id);

const page = { values: {}, parked: {}, changed: false, checked: { errors: [], warnings: [], applies: {}, text: "", report: "", forecast: "", seconds: 0 }, name: "", shown: [], live: null, before: null, outlines: new Map(), measured: null, entries: [], jobs: [], pictures: new Map() };
let start = null, form = null;

/** What the server answers; an error has its text, and is `gone` if nobody answers. */
async function ask(method, path, body, signal) {
  const answer = await fetch(path, { method, signal, headers: { "X-Brinell-Token": TOKEN, ...(body ? { "Content-Type": "application/json" } : {}) }, body: body ? JSON.stringify(body) : undefined })
    .catch((error) => { throw error.name === "AbortError" ? error : Object.assign(new Error("The server does not answer."), { gone: true }); });
  if (path === "/api/preview" && answer.ok) return answer;
  const content = await answer.json().catch(() => ({ error: `the server answers ${answer.status}` }));
  if (!answer.ok) throw new Error(content.error ?? `the server answers ${answer.status}`);
  return content;
}

const tell = (text) => { $("curve-note").textContent = text; };

// --- The case -------------------------------------------------------------------------------------------------------
/** Opens a case; `from`: the file that it is from, where this is none of the folder. */
async function open(values, name, from = "") {
  Object.assign(page, { values, parked: {}, name, live: null, before: null, changed: false });
  $("case-name").textContent = name || (from ? `from ${from}` : "new case");
  form.sliders.clear();
  form.units.clear();
  await check(false);
  chooseAxes();
  follow();
}

let changing = 0; // changes of which the check has not answered

/** Takes over changes of values; with `parks`, values that no longer apply are put aside, and come back later. */
async function change(changes, parks) {
  changing += 1;
  try { await changed(changes, parks); } finally { changing -= 1; }
}

async function changed(changes, parks) {
  page.changed = true;
  for (const [key, value] of Object.entries(changes)) value === undefined ? delete page.values[key] : (page.values[key] = value);
  const scenario = changes.scenario;
  if (scenario && form.sections.some((section) => section.table === scenario)) return open((await ask("GET", `/api/template?scenario=${scenario}`)).values, "");
  await check(parks);
  follow();
}

let turn = 0;
async function check(parks) {
  const mine = ++turn;
  let checked;
  try {
    checked = await ask("POST", "/api/check", { values: page.values, park: Boolean(parks) });
    if (mine !== turn) return;
    const back = Object.keys(page.parked).filter((key) => checked.applies[key] && !(key in page.values));
    for (const [key, value] of Object.entries(checked.parked)) { page.parked[key] = value; delete page.values[key]; }
    if (parks && back.length) {
      for (const key of back) { page.values[key] = page.parked[key]; delete page.parked[key]; }
      checked = await ask("POST", "/api/check", { values: page.values, park: false });
      if (mine !== turn) return;
    }
  } catch (error) {
    checked = { ...page.checked, errors: [{ key: "", line: 0, text: error.message }] };
  }
  page.checked = checked;
  drawCase();
}

function drawCase() {
  const { errors, warnings, forecast } = page.checked;
  form.draw(page.values, page.checked, start.materials);
  $("run").disabled = errors.length > 0 || !$("server-note").hidden;
  $("forecast").textContent = errors.length ? `${errors.length} ${errors.length === 1 ? "problem" : "problems"}` : forecast;
  const item = (one) => h("li", {}, one.key ? h("button", { type: "button", class: "link", onclick: () => form.show(one.key) }, one.text) : one.text);
  const unplaced = warnings.filter((one) => !document.querySelector(`[data-key="${CSS.escape(one.key)}"]`));
  $("problems").replaceChildren(
    errors.length ? h("div", { class: "wrong" }, h("strong", {}, errors.length === 1 ? "One problem" : `${errors.length} problems`), h("ul", {}, errors.map(item))) : "",
    unplaced.length ? h("div", { class: "warn" }, h("strong", {}, "To be known of the result"), h("ul", {}, unplaced.map(item))) : "");
  drawTexts();
  drawSweepKeys();
  drawFit();
}

/** The case as text, and the command and the Python that run it. */
function drawTexts() {
  const { text, report } = page.checked;
  const file = page.name || "case.toml", folder = `results/${baseName()}`;
  $("toml").textContent = text;
  $("report").textContent = report.replaceAll(`${start.folder}/case.toml`, file) || "There are problems.";
  const first = page.name && !page.changed ? "" : "# after the case is saved\n";
  $("command").textContent = `${first}brinell run ${quoted(file)} -o ${quoted(folder)}`;
  $("python").textContent = `${first}import brinell\n\ncase = brinell.Case.from_file(${JSON.stringify(file)})\nrun = case.run(${JSON.stringify(folder)})\nprint(run.history[${JSON.stringify($("y").value || "step")}])`;
}

const quoted = (text) => (/^[\w./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
const baseName = () => (page.name.replace(/\.toml$/, "").replace(/\/case$/, "").split("/").at(-1) || page.values.scenario || "case").replace(/^\.+/, "");

// --- Small cases follow their changes -------------------------------------------------------------------------------
const preview = { abort: null, next: null, running: null };

/** Runs the case at once if it is small; `waits`: after the present run, as while a slider moves. */
function follow(waits = false) {
  const { errors, seconds } = page.checked, isShort = seconds > 0 && seconds <= LIVE_SECONDS;
  if (!$("follow").checked || errors.length || !isShort) {
    preview.abort?.abort();
    if (!errors.length && page.live) { page.live = null; drawShown(); drawCurve(); }
    if (page.live) { drawShown(); drawCurve(); }
    tell(!$("follow").checked ? "" : errors.length ? (page.live ? "The curve is that of the case before its problems." : "") : "This case takes too long to follow its changes; run it.");
    return;
  }
  if (waits && preview.abort) { preview.next = { ...page.values }; return; }
  preview.next = null;
  preview.abort?.abort();
  preview.running = stream({ ...page.values });
}

async function stream(values) {
  const abort = (preview.abort = new AbortController());
  const begun = performance.now(), live = { columns: {}, done: false, picture: null };
  try {
    const answer = await ask("POST", "/api/preview", { values, shown: { kind: $("kind").value, name: $("field").value }, tab: TAB }, abort.signal);
    const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
    for (let text = "", part = await reader.read(); !part.done; part = await reader.read()) {
      text += part.value;
      const lines = text.split("\n");
      text = lines.pop();
      for (const line of lines) take(JSON.parse(line), live, begun, values.scenario);
    }
    live.done = true;
  } catch (error) {
    if (error.name !== "AbortError") tell(error.message);
  }
  if (preview.abort !== abort) return;
  preview.abort = null;
  if (preview.next) { const next = preview.next; preview.next = null; stream(next); }
}

function take(thing, live, begun, scenario) {
  if (thing.error) return tell(thing.error);
  if (thing.picture) { live.picture = thing.picture; if (page.live === live) drawPictures(); return; }
  for (const [name, values] of Object.entries(thing.columns ?? {})) live.columns[name] = [...(live.columns[name] ?? []), ...values];
  if (page.live !== live) { page.before = page.live?.done && page.live.scenario === scenario ? page.live : page.before; Object.assign(live, { scenario }); page.live = live; chooseAxes(); drawShown(); }
  live.done = thing.seconds !== undefined;
  live.notes = thing.notes ?? [];
  if (!live.done) tell(`${live.columns.step?.length ?? 0} of about ${thing.of} steps`);
  drawCurve().then(() => {
    if (!live.done) return;
    const took = (performance.now() - begun) / 1000;
    document.body.dataset.took = took.toFixed(3);
    tell(`${live.columns.step?.length ?? 0} steps in ${took.toFixed(2)} s, as drawn`);
  });
}

// --- What is shown ----------------------------------------------------------------------------------------------------
/** Shows a run beside the others. */
async function show(name) {
  if (page.shown.some((one) => one.name === name)) return;
  const used = new Set(page.shown.map((one) => one.place));
  let place = 0;
  while (used.has(place)) place += 1;
  const one = { name, place, columns: {}, complete: false, outline: null };
  page.shown.push(one);
  $("figures-of").dataset.latest = name;
  await more(one);
  drawShown();
}

/** Reads on in the history of a run. */
async function more(one) {
  const count = one.columns.step?.length ?? 0;
  const { columns, complete } = await ask("GET", `/api/history?name=${encodeURIComponent(one.name)}&from=${count}`);
  const fresh = columns.step?.length ?? 0;
  for (const [name, values] of Object.entries(columns)) one.columns[name] = [...(one.columns[name] ?? []), ...values];
  const finished = complete && !one.complete;
  one.complete = complete;
  if (finished || fresh) {
    one.outline = await ask("GET", `/api/outline?name=${encodeURIComponent(one.name)}`).catch(() => null) ?? one.outline;
    if (one.outline && one === page.shown[0]) chooseAxes();
  }
  if (fresh || finished) { drawCurve(); drawStates(); if (!$("fields").hidden) drawPictures(); if (!$("numbers").hidden) drawNumbers(); }
}

function drawShown() {
  const item = (name, colour, remove) => h("li", {}, h("i", { style: `background:${colour}` }), name, h("button", { "aria-label": `Show ${name} no more`, onclick: remove }, "×"));
  const items = page.shown.map((one) => item(shortName(one), colourOf(one.place + 1), () => { page.shown = page.shown.filter((other) => other !== one); drawShown(); drawAll(); }));
  if (page.live) items.unshift(h("li", {}, h("i", { style: `background:${COLOURS[0]}` }), liveName()));
  if (page.measured) items.push(item(page.measured.name, "#000", dropMeasured));
  $("shown").replaceChildren(...items);
  drawStates();
}

/** The small case that follows its changes; while it has problems what is known is that before them. */
const liveName = () => (page.checked.errors.length ? "this case before its problems" : "this case");
const shortName = (one) => one.name.replace(/^results\//, "");

/** What is known of the quality of results, each with its name. */
const notesOf = (runs) => runs.filter((one) => one.outline).flatMap((one) => one.outline.notes.map((text) => h("li", {}, `${shortName(one)}: ${text}`)));

const colourOf = (place) => COLOURS[place % COLOURS.length];
const scenarioShown = () => page.live?.scenario ?? page.shown[0]?.outline?.scenario ?? page.values.scenario;
const columnsOf = (scenario) => start.columns[scenario] ?? [];

/** The columns of the scenario's first curve are chosen; the menus offer those that have values. */
function chooseAxes() {
  const scenario = scenarioShown();
  if (!scenario || $("x").dataset.scenario === scenario) return;
  const columns = columnsOf(scenario), [x, y] = FIRST_AXES[scenario] ?? [];
  for (const [select, wanted, otherwise] of [[$("x"), x, "step"], [$("y"), y, "F_n"]]) {
    offer(select, columns.map(columnEntry));
    select.value = columns.some((one) => one.name === wanted) ? wanted : otherwise;
  }
  $("x").dataset.scenario = scenario;
  drawAxes();
}

const columnEntry = (one) => [one.name, `${short(one)} (${one.name})`, one.text];

/** The columns with a value other than zero in one of the results that are shown; all while there is none. */
function filledColumns() {
  const results = [page.live, ...page.shown].filter((one) => one?.columns.step?.length);
  return columnsOf(scenarioShown()).filter((column) => !results.length || results.some((one) => one.columns[column.name]?.some(Boolean)));
}

/** Leaves out of the menus what is empty in all results that are shown, but for what is chosen, and says so. */
function drawAxes() {
  const all = columnsOf(scenarioShown()), filled = filledColumns();
  const left = all.filter((one) => !filled.includes(one));
  for (const select of [$("x"), $("y")]) {
    offer(select, all.filter((one) => filled.includes(one) || one.name === select.value).map(columnEntry));
    select.title = left.length ? `Left out, as they are empty in what is shown: ${left.map((one) => one.name).join(", ")}` : "";
  }
}

function drawCurve() {
  drawAxes();
  const columns = columnsOf(scenarioShown());
  const [x, y] = [$("x").value, $("y").value].map((name) => columns.find((one) => one.name === name) ?? { name, unit: "", text: name });
  const curve = (name, from, place, extra = {}) => ({ name, x: from[x.name] ?? [], y: from[y.name] ?? [], colour: colourOf(place), dash: DASHES[place % DASHES.length], ...extra });
  const lacking = (one) => (one.columns.step?.length ? [x, y].filter(({ name }) => !one.columns[name]).map(({ name }) => name) : []);
  const curves = [], left = page.shown.filter((one) => lacking(one).length), drawn = page.shown.filter((one) => !left.includes(one));
  $("left-out").textContent = left.map((one) => `${shortName(one)} has no ${lacking(one).join(" and ")} and is not drawn.`).join(" ");
  if (page.measured) settleMeasured({ x, y });
  if (page.before && page.live) curves.push(curve("before the change", page.before.columns, 0, { before: true }));
  if (page.live) curves.push(curve(liveName(), page.live.columns, 0));
  curves.push(...drawn.map((one) => curve(shortName(one), one.columns, one.place + 1)));
  if (page.measured) curves.push(measuredCurve(x, y));
  drawFit();
  if (!fit.told) drawFitPlot();
  $("notes").replaceChildren(...(page.live?.notes ?? []).map((text) => h("li", {}, `this case: ${text}`)), ...notesOf(page.shown));
  return drawCurves($("curve"), curves, x, y);
}

// --- Fields, numbers, figures ---------------------------------------------------------------------------------------
/** The states of all runs that are shown; where one run is, with its place and load. */
function drawStates() {
  const runs = page.shown.filter((one) => one.outline);
  const steps = [...new Set(runs.flatMap((one) => one.outline.steps))].sort((a, b) => a - b);
  offer($("state"), [["aligned", "the loaded state"], ["final", "the last state"], ...steps.map((step) => [step, stateText(step, runs)])]);
}

function stateText(step, runs) {
  if (runs.length > 1) {
    const having = runs.filter((one) => one.outline.steps.includes(step));
    return `step ${step}${having.length < runs.length ? ` of ${having.map(shortName).join(", ")}` : ""}`;
  }
  const [{ columns, outline: { scenario } }] = runs, row = columns.step?.indexOf(step) ?? -1;
  const said = [FIRST_AXES[scenario]?.[0], "F_n"].map((name) => columnsOf(scenario).find((one) => one.name === name)).filter((one) => one && Number.isFinite(columns[one.name]?.[row]));
  return `step ${step}${said.map((one) => `, ${one.name} ${numberText(columns[one.name][row], one.unit)}`).join("")}`;
}

let picturing = 0, pictured = 0; // numbers of the request and of what is drawn
async function drawPictures() {
  if ($("fields").hidden) return;
  const mine = ++picturing, shown = { kind: $("kind").value, name: $("field").value };
  const found = [];
  if (page.live?.picture) {
    const fits = page.live.picture.kind === shown.kind && (!shown.name || page.live.picture.name === shown.name);
    if (!fits && page.live.done && !preview.abort) { page.before = null; return stream({ ...page.values }); }
    found.push([liveName(), page.live.picture]);
  }
  for (const one of page.shown.slice(0, 4)) {
    const state = $("state").value || "aligned", isStored = !/^\d+$/.test(state) || !one.outline || one.outline.steps.includes(Number(state));
    try { found.push([one.name, isStored ? await ask("POST", "/api/picture", { name: one.name, state, shown }) : `step ${state} is not stored; choose another one at "at"`]); } catch (error) { found.push([one.name, error.message]); }
    if (mine !== picturing) return;
  }
  const drawn = found.map(([, picture]) => picture).filter((picture) => picture?.names);
  if (drawn.length) { drawFieldMenus(drawn); shareColours(drawn); }
  const box = $("pictures");
  if (box.firstElementChild?.tagName === "P") box.replaceChildren();
  while (box.children.length > found.length) box.lastChild.remove();
  while (box.children.length < found.length) box.append(h("figure", {}, h("figcaption"), h("div", { class: "plot", role: "img" }))); // all, as they share the width
  found.forEach(([name, picture], i) => {
    const figure = box.children[i], [caption, plot] = figure.children;
    if (picture === null) { // just written to, or nothing is stored so far: what is there stays
      if (figure.dataset.of !== name) { caption.textContent = `${name}: nothing is stored so far`; Plotly.purge(plot); }
      return;
    }
    figure.dataset.of = name;
    if (typeof picture === "string") { caption.textContent = `${name}: ${picture}`; Plotly.purge(plot); return; }
    caption.textContent = `${name.replace(/^results\//, "")}: ${[picture.title, picture.state, picture.plane].filter(Boolean).join(", ")}`;
    if (plot.dataset.kind !== picture.kind) Plotly.purge(plot);
    plot.dataset.kind = picture.kind;
    RESIZED.observe(plot);
    drawPicture(plot, picture);
  });
  if (!found.length) box.replaceChildren(h("p", { class: "quiet" }, "Nothing is shown. Run a case, or add a run."));
  pictured = mine;
}

/** The fields to choose from: those with a value other than zero in one of the states that are shown, and the chosen one. */
function drawFieldMenus(drawn) {
  const [first] = drawn, kept = $("field").value;
  const filled = (kind) => first.names[kind].filter((name) => drawn.some((one) => one.names[kind].includes(name) && !one.empty[kind].includes(name)));
  const chosen = first.names[first.kind].includes(kept) ? kept : first.name;
  const names = first.names[first.kind].filter((name) => name === chosen || filled(first.kind).includes(name));
  offer($("field"), names.map((name) => [name, start.titles[name] ?? `${name} body`]));
  $("field").value = chosen;
  for (const option of $("kind").options) option.disabled = option.value !== first.kind && !filled(option.value).length;
  $("kind").value = first.kind;
}

function drawNumbers() {
  const runs = page.shown.filter((one) => one.outline);
  if (!runs.length) { $("numbers").replaceChildren(h("p", { class: "quiet" }, "Add runs to compare their key numbers and what differs between them.")); return; }
  const head = h("thead", {}, h("tr", {}, h("th", { scope: "col" }, ""), runs.map((one) => h("th", { scope: "col" }, shortName(one)))));
  const row = (name, cells, differs) => h("tr", {}, h("th", { scope: "row" }, name), cells.map((cell) => h("td", { class: differs ? "differs" : "" }, cell)));
  const keys = [...new Set(runs.flatMap((one) => Object.keys(one.outline.values)))].filter((key) => new Set(runs.map((one) => JSON.stringify(one.outline.values[key]))).size > 1);
  const names = [...new Set(runs.flatMap((one) => one.outline.numbers.map((number) => number.name)))];
  const unitOf = (key, { pure }) => (pure.includes(key) ? "" : form.fields.get(plainKey(key))?.bare ?? "");
  const inputs = keys.map((key) => row(key, runs.map(({ outline }) => valueText(outline.values[key], unitOf(key, outline))), true));
  const numbers = names.map((name) => row(name, runs.map((one) => { const found = one.outline.numbers.find((number) => number.name === name); return found ? numberText(found.value, found.unit) : "–"; })));
  const intervals = runs.flatMap((one) => one.outline.intervals.map((found) => row(`${found.name} of ${shortName(one)}`, [found.value, `${found.low} to ${found.high}`, found.error])));
  const heads = h("thead", {}, h("tr", {}, ["", "finest cells", "interval", "error"].map((text) => h("th", { scope: "col" }, text))));
  $("numbers").replaceChildren(
    runs.length > 1 ? h("table", {}, h("caption", {}, "What differs"), head.cloneNode(true), h("tbody", {}, inputs.length ? inputs : row("nothing", []))) : "",
    h("table", {}, h("caption", {}, "Key numbers"), head, h("tbody", {}, numbers)),
    intervals.length ? h("table", {}, h("caption", {}, "Accuracy"), heads, h("tbody", {}, intervals)) : "",
    h("div", {}, h("h2", {}, "To be known of these results"), h("ul", {}, notesOf(runs))));
}

function numberText(value, unit) {
  if (unit === "%") return `${nice(100 * value)} %`;
  const scale = scaleOf(unit, Math.abs(value));
  return `${nice(value / scale.size)} ${scale.unit}`;
}

const valueText = (value, unit) => (value === undefined ? "–" : typeof value === "number" && unit ? numberText(value, unit) : Array.isArray(value) ? value.map((one) => valueText(one, unit)).join(", ") : String(value));

async function drawFigures() {
  const name = $("figures-of").value;
  $("gallery").replaceChildren();
  $("figures-note").textContent = name ? "They are being drawn …" : "There is no result in the folder yet.";
  if (!name) return;
  try {
    const figures = await ask("GET", `/api/figures?name=${encodeURIComponent(name)}`);
    if ($("figures-of").value !== name) return;
    $("gallery").replaceChildren(...figures.map(figureOf));
    $("figures-note").textContent = figures.length ? `brinell plot ${quoted(name)} writes them` : "There are none.";
  } catch (error) { $("figures-note").textContent = error.message; }
}

const figureOf = (one) => h("figure", {}, h("img", { src: one.source, alt: one.caption }), h("figcaption", {}, one.caption));

function drawAll() { drawCurve(); drawPictures(); if (!$("numbers").hidden) drawNumbers(); }
