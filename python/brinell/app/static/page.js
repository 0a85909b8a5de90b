// SPDX-License-Identifier: BSD-3-Clause
// What the buttons, menus and tabs of the page do; the page begins here.
"use strict";

// --- Sweeps ---------------------------------------------------------------------------------------------------------
function drawSweepKeys() {
  const kept = $("sweep-key").value;
  const keys = Object.keys(page.values).filter((key) => ["number", "numbers", "integer"].includes(form.fields.get(plainKey(key))?.kind) && !/\[\d+\]/.test(key));
  offer($("sweep-key"), keys.map((key) => [key, key]));
  const drive = keys.find((key) => key.startsWith(`${page.values.scenario}.`));
  $("sweep-key").value = keys.includes(kept) ? kept : drive ?? keys[0] ?? "";
  if ($("sweep-key").value !== kept) sweepRange();
}

function sweepParts() {
  const key = $("sweep-key").value, field = form.fields.get(plainKey(key)), value = page.values[key];
  const first = Array.isArray(value) ? value[0] : value;
  return { key, field, value, first, parts: split(field, first), pure: page.checked.applies[key]?.pure };
}

function sweepRange() {
  if (!$("sweep-key").value) return;
  const { parts, field, pure } = sweepParts(), middle = Number(parts.text);
  const whole = (x) => (field.kind === "integer" ? Math.max(1, Math.round(x)) : Number(x.toPrecision(3)));
  $("sweep-from").value = whole(middle / 2);
  $("sweep-to").value = whole(middle * 2);
  $("sweep-unit").textContent = pure ? "" : parts.unit ?? "";
}

async function sweep() {
  const { key, field, value, first, parts, pure } = sweepParts();
  const from = Number($("sweep-from").value), to = Number($("sweep-to").value), count = Math.round(Number($("sweep-count").value));
  const isLog = $("sweep-log").checked;
  if (!Number.isFinite(from) || !Number.isFinite(to) || from === to || !(count >= 2) || (isLog && !(from > 0 && to > 0))) { $("sweep-note").textContent = `Give two numbers${isLog ? " above 0" : ""}, and 2 or more values.`; return; }
  const places = Array.from({ length: count }, (_, i) => i / (count - 1));
  const numbers = [...new Set(places.map((at) => Number((isLog ? from * (to / from) ** at : from + (to - from) * at).toPrecision(6))).map((x) => (field.kind === "integer" ? Math.round(x) : x)))];
  const over = numbers.map((x) => (pure || typeof first === "number" || !parts.unit ? x : `${x} ${parts.unit}`)).map((x) => (Array.isArray(value) ? [x, ...value.slice(1)] : x));
  try {
    const job = await ask("POST", "/api/sweep", { values: page.values, name: `${baseName()}-sweep`, key, over });
    $("sweep-note").textContent = `${job.name}: ${over.length} runs`;
    $("sweep-figure").replaceChildren();
    await refresh();
  } catch (error) { $("sweep-note").textContent = error.message; }
}

async function showSweep(name) {
  try {
    const figures = await ask("GET", `/api/figures?name=${encodeURIComponent(name)}`);
    $("sweep-figure").replaceChildren(...figures.map(figureOf));
    $("sweep-note").textContent = figures.length ? `${name}; its table is ${name}/table.csv` : `${name}: no key number differs between its runs.`;
  } catch (error) { $("sweep-note").textContent = error.message; }
}

// --- Measured curves ------------------------------------------------------------------------------------------------
function measuredCurve() {
  const { columns, x, y, xFactor, yFactor, reverse, name } = page.measured;
  const values = (column, factor, turned) => columns[column].map((one) => one * (turned ? -factor : factor));
  return { name, measured: true, x: values(x, xFactor, reverse.x), y: values(y, yFactor, reverse.y) };
}

/** Lays a text with columns over the curves; `file`: where it lies in the folder, if it does. */
function readMeasured(name, text, file = "") {
  try {
    const found = measuredOf(text);
    page.measured = { ...found, name, text, file, x: 0, y: 1, xFactor: factorOf(found.titles[0]), yFactor: factorOf(found.titles[1]), reverse: { x: false, y: false } };
  } catch (error) { tell(`${name}: ${error.message}`); $("fit-note").textContent = `${name}: ${error.message}`; return; }
  drawMeasuredControls();
  drawShown();
  drawCurve();
}

/** What the columns of the measured curve are, beside the curves and among what a fit asks for: two places, one choice. */
function drawMeasuredControls() {
  const select = (of, label, entries, set) => h("select", { "aria-label": label, "data-measured": of, onchange: (event) => { set(Number(event.target.value)); tellMeasured(); drawCurve(); } }, entries.map(([value, text]) => h("option", { value }, text)));
  const axis = (which, label) => h("span", {},
    select(which, `Column of the file for ${label}`, page.measured.titles.map((title, i) => [i, title]), (i) => Object.assign(page.measured, { [which]: i, [`${which}Factor`]: factorOf(page.measured.titles[i]) })),
    " in ", select(`${which}Factor`, `Unit of ${label} in the file`, FACTORS, (size) => { page.measured[`${which}Factor`] = size; }), " ");
  $("measured-controls").replaceChildren("Measured: across ", axis("x", "across"), "up ", axis("y", "up"));
  $("measured-controls").hidden = false;
  for (const [which, label] of [["x", "across"], ["y", "up"]]) $(`fit-column-${which}`).replaceChildren("is ", axis(which, label));
  tellMeasured();
}

function tellMeasured() {
  for (const one of document.querySelectorAll("[data-measured]")) one.value = page.measured[one.dataset.measured];
  for (const which of ["x", "y"]) $(`fit-reverse-${which}`).checked = page.measured.reverse[which];
}

// --- Dialogues ------------------------------------------------------------------------------------------------------
/** Asks for texts; `done` gets them, and may throw what is then shown. */
function dialogue(title, labels, done) {
  $("dialog-title").textContent = title;
  $("dialog-error").textContent = "";
  const inputs = labels.map(([label, value]) => h("input", { type: "text", value, required: true, "aria-label": label }));
  $("dialog-body").replaceChildren(...labels.map(([label], i) => h("label", {}, label, inputs[i])));
  $("dialog-ok").onclick = async (event) => {
    event.preventDefault();
    try { await done(...inputs.map((input) => input.value)); $("dialog").close(); } catch (error) { $("dialog-error").textContent = error.message; }
  };
  $("dialog").showModal();
}

function save() {
  let replaces = "";
  dialogue("Save the case", [["File in the folder", page.name || `${baseName()}.toml`]], async (given) => {
    const name = given.endsWith(".toml") ? given : `${given}.toml`;
    try {
      await ask("PUT", "/api/case", { name, values: page.values, replace: replaces === name });
    } catch (error) {
      if (!/exists already/.test(error.message)) throw error;
      replaces = name;
      throw new Error(`${error.message}. OK replaces it, with comments that it has.`);
    }
    Object.assign(page, { name, changed: false });
    $("case-name").textContent = name;
    drawCase();
    await refresh();
  });
}

function material(table, name) {
  const changes = {};
  for (const key of Object.keys(page.values)) if (key.startsWith(`${table}.`)) changes[key] = undefined;
  for (const [key, value] of Object.entries(start.materials.find((one) => one.name === name)?.values ?? {})) changes[`${table}.${key}`] = value;
  change(changes, false);
}

function storeMaterial(values) {
  dialogue("Keep this material", [["Name", ""], ["Where its constants come from", ""]], async (name, source) => {
    start.materials = (await ask("PUT", "/api/material", { name, source, values })).materials;
    drawCase();
  });
}

async function dropMaterial(name) {
  start.materials = (await ask("DELETE", "/api/material", { name })).materials;
  drawCase();
}

// --- Tabs -----------------------------------------------------------------------------------------------------------
const tabs = () => [...document.querySelectorAll('[role="tab"]')];

function chooseTab(tab) {
  for (const one of tabs()) {
    const is = one === tab;
    one.setAttribute("aria-selected", String(is));
    one.tabIndex = is ? 0 : -1;
    $(one.getAttribute("aria-controls")).hidden = !is;
  }
  const name = tab.getAttribute("aria-controls");
  if (name === "curves") drawCurve();
  if (name === "fields") drawPictures();
  if (name === "numbers") drawNumbers();
  if (name === "text") drawTexts();
  if (name === "figures") drawFigures();
  if (name === "fit") { drawFit(); drawFitPlot(); }
}

function connect() {
  for (const tab of tabs()) {
    tab.onclick = () => chooseTab(tab);
    tab.onkeydown = (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      const all = tabs(), next = event.key === "Home" ? all[0] : event.key === "End" ? all.at(-1) : step ? all[(all.indexOf(tab) + step + all.length) % all.length] : null;
      if (next) { event.preventDefault(); next.focus(); chooseTab(next); }
    };
  }
  RESIZED.observe($("curve"));
  $("form").onsubmit = (event) => event.preventDefault();
  $("new").onchange = async () => { const scenario = $("new").value; $("new").value = ""; if (scenario) open((await ask("GET", `/api/template?scenario=${scenario}`)).values, ""); };
  $("open").onchange = async () => {
    const name = $("open").value;
    $("open").value = "";
    if (!name) return;
    try { open((await ask("GET", `/api/case?name=${encodeURIComponent(name)}`)).values, name); } catch (error) { tell(error.message); }
  };
  $("open-file").onclick = () => $("file").click();
  $("file").onchange = async () => {
    const file = $("file").files[0];
    $("file").value = "";
    if (file) try { open((await ask("POST", "/api/parse", { text: await file.text() })).values, ""); } catch (error) { tell(`${file.name}: ${error.message}`); }
  };
  $("save").onclick = save;
  $("run").onclick = run;
  $("follow").onchange = () => follow();
  $("add-run").onchange = () => { const name = $("add-run").value; $("add-run").value = ""; if (name) show(name); };
  $("add-measured").onclick = () => $("measured-file").click();
  $("measured-file").onchange = () => { const file = $("measured-file").files[0]; $("measured-file").value = ""; if (file) file.text().then((text) => readMeasured(file.name, text)); };
  for (const id of ["x", "y"]) $(id).onchange = () => drawCurve();
  for (const id of ["kind", "field", "state"]) $(id).onchange = () => { if (id === "kind") $("field").replaceChildren(); drawPictures(); };
  $("figures-of").onchange = drawFigures;
  $("sweep-key").onchange = sweepRange;
  $("sweep-run").onclick = sweep;
  connectFit();
}

async function begin() {
  start = await ask("GET", "/api/start");
  document.title = `brinell: ${start.folder}`;
  form = new Form($("form"), start.form.sections, {
    change, material, store: storeMaterial, drop: dropMaterial,
    slide: (key, value) => { Object.assign(page, { changed: true }).values[key] = value; follow(true); },
    release: async (key, value) => { changing += 1; page.values[key] = value; follow(); await preview.running; await check(false); changing -= 1; },
  });
  const scenarios = form.fields.get("scenario").choices;
  $("new").append(...scenarios.map((scenario) => h("option", { value: scenario }, scenario)));
  connect();
  await refresh();
  const first = scenarios.includes("indentation") ? "indentation" : scenarios[0];
  await open((await ask("GET", `/api/template?scenario=${first}`)).values, "");
  document.body.dataset.ready = "yes";
  setTimeout(watch, 1000);
}

addEventListener("DOMContentLoaded", () => begin().catch((error) => { $("problems").textContent = error.message; }));
