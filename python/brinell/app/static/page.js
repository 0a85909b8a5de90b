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
  const isWrong = { "sweep-from": !isGiven("sweep-from") || (isLog && !(from > 0)), "sweep-to": !isGiven("sweep-to") || from === to || (isLog && !(to > 0)), "sweep-count": !(count >= 2 && count <= 200) };
  const wrong = Object.keys(isWrong).filter((id) => isWrong[id]);
  for (const id of Object.keys(isWrong)) $(id).setAttribute("aria-invalid", String(isWrong[id]));
  tellOfSweep(wrong.length ? `Give two different numbers${isLog ? " above 0" : ""}, and 2 to 200 values.` : "", true);
  if (wrong.length) { $(wrong[0]).focus(); return; }
  const places = Array.from({ length: count }, (_, i) => i / (count - 1));
  const numbers = [...new Set(places.map((at) => Number((isLog ? from * (to / from) ** at : from + (to - from) * at).toPrecision(6))).map((x) => (field.kind === "integer" ? Math.round(x) : x)))];
  const over = numbers.map((x) => (pure || typeof first === "number" || !parts.unit ? x : `${x} ${parts.unit}`)).map((x) => (Array.isArray(value) ? [x, ...value.slice(1)] : x));
  try {
    const job = await ask("POST", "/api/sweep", { values: page.values, name: `${baseName()}-sweep`, key, over });
    tellOfSweep(`${job.name}: ${over.length} runs`);
    $("sweep-figure").replaceChildren();
    await refresh();
  } catch (error) { tellOfSweep(error.message, true); }
}

const isGiven = (id) => $(id).value.trim() !== "" && Number.isFinite(Number($(id).value));

function tellOfSweep(text, isWrong = false) {
  $("sweep-note").textContent = text;
  $("sweep-note").className = isWrong ? "complaint" : "quiet";
}

async function showSweep(name) {
  try {
    const figures = await ask("GET", `/api/figures?name=${encodeURIComponent(name)}`);
    $("sweep-figure").replaceChildren(...figures.map(figureOf));
    tellOfSweep(figures.length ? `${name}; its table is ${name}/table.csv` : `${name}: no key number differs between its runs.`);
  } catch (error) { tellOfSweep(error.message, true); }
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
    page.measured = { ...found, name, text, file, x: 0, y: 1, xFactor: 1, yFactor: 1, of: {}, wrong: {}, reverse: { x: false, y: false } };
  } catch (error) { tellOfMeasured([`${name}: ${error.message}`]); return; }
  drawMeasuredControls();
  drawShown();
  drawCurve();
}

/** What the columns of the measured curve are, beside the curves and among what a fit asks for: two places, one choice. */
function drawMeasuredControls() {
  const select = (of, label, entries, set) => h("select", { "aria-label": label, "data-measured": of, onchange: (event) => { set(Number(event.target.value)); tellMeasured(); drawCurve(); } }, entries.map(([value, text]) => h("option", { value }, text)));
  const axis = (which, label) => h("span", {},
    select(which, `Column of the file for ${label}`, page.measured.titles.map((title, i) => [i, title]), (i) => { page.measured[which] = i; }),
    " in ", select(`${which}Factor`, `Unit of ${label} in the file`, [], (size) => { page.measured[`${which}Factor`] = size; page.measured.wrong[which] = ""; }), " ");
  $("measured-controls").replaceChildren("Measured: across ", axis("x", "across"), "up ", axis("y", "up"));
  $("measured-controls").hidden = false;
  for (const [which, label] of [["x", "across"], ["y", "up"]]) $(`fit-column-${which}`).replaceChildren("is ", axis(which, label));
  tellMeasured();
}

/** Takes the units of the file from its titles, where its columns, or those over which they are laid, have changed. */
function settleMeasured(columns) {
  const { measured } = page;
  for (const which of ["x", "y"]) {
    const column = columns[which], title = measured.titles[measured[which]], of = `${column.name} ${measured[which]}`;
    if (measured.of[which] === of) continue;
    const { size, wrong } = factorOf(title, column.unit);
    measured.of[which] = of;
    measured[`${which}Factor`] = size;
    measured.wrong[which] = wrong ? `"${title}": ${wrong} is no unit of ${column.name}, which is ${!column.unit || column.unit === "1" ? "a pure number" : `in ${column.unit}`}; choose the unit of the file.` : "";
    for (const select of document.querySelectorAll(`[data-measured=${which}Factor]`)) offer(select, factorsOf(column.unit));
  }
  tellMeasured();
  const { left } = measured;
  tellOfMeasured([...Object.values(measured.wrong), left.length ? `Left out, as there are not only numbers: ${left.slice(0, 3).join("; ")}${left.length > 3 ? `; and ${left.length - 3} more` : ""}.` : ""]);
}

function tellOfMeasured(texts) {
  const text = texts.filter(Boolean).join(" ");
  if ($("measured-note").textContent !== text) for (const id of ["measured-note", "fit-measured-note"]) $(id).textContent = text;
}

function dropMeasured() {
  page.measured = null;
  $("measured-controls").hidden = true;
  tellOfMeasured([]);
  drawShown();
  drawAll();
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
  $("dialog-cancel").onclick = () => $("dialog").close(); // no button of the form, which Enter would press
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
  if (name === "figures") { showLatestFigures(); drawFigures(); }
  if (name === "fit") { drawFit(); drawFitPlot(); }
}

/** Figures are first those of the run that was shown last. */
function showLatestFigures() {
  const menu = $("figures-of"), { latest } = menu.dataset;
  if (latest && [...menu.options].some((one) => one.value === latest)) menu.value = latest;
  delete menu.dataset.latest;
}

/** A button beside each text that copies it. */
function addCopyButtons() {
  for (const text of document.querySelectorAll("pre[id]")) {
    const title = document.getElementById(text.getAttribute("aria-labelledby")), button = h("button", { class: "copy", "aria-label": `Copy: ${title.textContent}` }, "Copy");
    button.onclick = async () => {
      await navigator.clipboard.writeText(text.textContent).catch(() => getSelection().selectAllChildren(text)); // what may not be copied can be by hand
      button.textContent = getSelection().containsNode(text, true) ? "Selected" : "Copied";
      setTimeout(() => { button.textContent = "Copy"; }, 2000);
    };
    title.append(" ", button);
  }
}

function connect() {
  addCopyButtons();
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
    if (file) try { open((await ask("POST", "/api/parse", { text: await file.text() })).values, "", file.name); } catch (error) { tell(`${file.name}: ${error.message}`); }
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

addEventListener("beforeunload", (event) => { if (page.changed) event.preventDefault(); }); // the browser asks
addEventListener("DOMContentLoaded", () => begin().catch((error) => { $("problems").textContent = error.message; }));
