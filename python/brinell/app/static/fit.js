// SPDX-License-Identifier: BSD-3-Clause
// Fits: keys of the case are found from the measured curve, by the server as `brinell fit` does.
"use strict";

const MACHINE = { "machine.compliance": ["compliance of the frame", "m/N", "0", "0.1"], "machine.first_touch": ["depth of first touch", "m", "-1", "1"], "machine.drift": ["drift of the depth, of a curve with time", "m/s", "-1", "1"] };
const LARGEST_TEXT = 800000; // of a curve that is not in the folder: bodies of requests have a limit
const fit = { unknowns: [], name: "", told: null, checked: null, asked: "", timer: 0, turn: 0 };

const columnOf = (name) => columnsOf(scenarioShown()).find((one) => one.name === name) ?? { name, unit: "", text: name };
const isActiveJob = (name) => page.jobs.some((job) => job.name === name && (job.state === "running" || job.state === "waiting"));

/** Unit in the file, by the factor that was chosen; empty: none, or that of the column. */
function unitInFile(which) {
  const { unit } = columnOf($(which).value);
  return PREFIXED.includes(unit) ? FACTORS.find(([size]) => size === page.measured[`${which}Factor`])[2] + unit : "";
}

function askedFit() {
  const { file = "", text = "", name = "", x = 0, y = 1, reverse = {} } = page.measured ?? {};
  const bound = (given, unit) => joined({ kind: "number" }, given, unit) ?? "";
  return {
    unknowns: fit.unknowns.map((one) => ({ key: one.key, low: bound(one.low, one.unit), high: bound(one.high, one.unit) })),
    file, text: file ? "" : text, name, x: x + 1, y: y + 1, columns: [$("x").value, $("y").value],
    units: page.measured ? { x: unitInFile("x"), y: unitInFile("y") } : {}, reverse: ["x", "y"].filter((which) => reverse[which]),
    noise: $("fit-noise").value.trim(), loss: $("fit-loss").value, method_error: $("fit-method").value.trim(), ...(Number($("fit-pass").value) ? { pass: Math.round(Number($("fit-pass").value)) } : {}),
  };
}

// --- What is asked for ----------------------------------------------------------------------------------------------
/** Keys that can be found: numbers of the case, entries of its lists, and those of the measurement. */
function fitKeys() {
  const keys = [];
  for (const [key, value] of Object.entries(page.values)) {
    if (!["number", "numbers"].includes(form.fields.get(plainKey(key))?.kind) || /^(grid|solver|output)\./.test(key)) continue;
    if (!Array.isArray(value)) keys.push(key);
    else if (value.length <= 20) keys.push(...value.map((_, i) => `${key}.${i}`));
  }
  return [...keys, ...(page.values.scenario === "indentation" ? Object.keys(MACHINE) : [])].filter((key) => !fit.unknowns.some((one) => one.key === key));
}

/** The present value of a key, also of an entry of a list. */
function valueAt(key) {
  const entry = /^(.*)\.(\d+)$/.exec(key);
  return key in page.values || !entry ? page.values[key] : page.values[entry[1]]?.[Number(entry[2])];
}

function addUnknown(key) {
  if (MACHINE[key]) {
    const [, unit, low, high] = MACHINE[key];
    fit.unknowns.push({ key, low, high, unit: start.units[unit].find((one) => one.startsWith("u")) ?? unit, units: start.units[unit] });
  } else {
    const field = form.fields.get(plainKey(key.replace(/\.\d+$/, ""))) ?? form.fields.get(plainKey(key)), { text, unit } = split(field, valueAt(key)), now = Number(text.replace("−", "-"));
    const units = page.checked.applies[key]?.pure ? [] : field.units;
    const round = (value) => String(Number(value.toPrecision(3)));
    const [low, high] = now > 0 ? [now / 3, now * 3] : now < 0 ? [now * 3, now / 3] : [-1, 1];
    fit.unknowns.push({ key, low: round(low), high: round(high), unit: units.length ? unit ?? "" : "", units: !unit || units.includes(unit) ? units : [unit, ...units] });
  }
  drawUnknowns();
  document.getElementById(`fit-unknowns[${fit.unknowns.length - 1}].low`).focus();
}

function drawUnknowns() {
  const row = (one, i) => {
    const input = (end, label) => h("label", {}, `${label} `, h("input", { id: `fit-unknowns[${i}].${end}`, value: one[end], size: 9, "aria-describedby": `fit-error-unknowns[${i}]`, "aria-label": `${label === "from" ? "Lower" : "Upper"} bound of ${one.key}`, oninput: (event) => { one[end] = event.target.value; drawFit(); } }));
    const unit = one.units.length ? h("select", { "aria-label": `Unit of the bounds of ${one.key}`, onchange: (event) => { one.unit = event.target.value; drawFit(); } }, one.units.map((name) => h("option", { value: name, selected: name === one.unit }, name || "1"))) : null;
    const remove = h("button", { type: "button", "aria-label": `Do not look for ${one.key}`, onclick: () => { fit.unknowns.splice(i, 1); drawUnknowns(); $("fit-add").focus(); } }, "×");
    return h("div", { class: "fit-row", "data-fit": `unknowns[${i}]` }, h("code", {}, one.key), input("low", "from"), input("high", "to"), unit, remove, h("div", { class: "under", id: `fit-error-unknowns[${i}]` }));
  };
  $("fit-unknowns").replaceChildren(...fit.unknowns.map(row));
  drawFit();
}

/** Draws the view of fits, and has the server check what has changed. */
function drawFit() {
  if ($("fit").hidden || !start) return;
  const files = page.entries.filter((one) => one.kind === "data").map((one) => one.name);
  const { file, name } = page.measured ?? {};
  offer($("fit-file"), [["", "choose"], ["load", "from elsewhere …"], ...(page.measured && !file ? [["loaded", `${name}, as loaded`]] : []), ...files.map((one) => [`f ${one}`, one])]);
  $("fit-file").value = !page.measured ? "" : file ? `f ${file}` : "loaded";
  for (const which of ["x", "y"]) {
    offer($(`fit-${which}`), [...$(which).options].map((one) => [one.value, one.text, one.title]));
    $(`fit-${which}`).value = $(which).value;
    $(`fit-column-${which}`).hidden = !page.measured;
  }
  offer($("fit-add"), [["", "a key …"], ...fitKeys().map((key) => [key, MACHINE[key] ? `${key} (${MACHINE[key][0]})` : key])]);
  offer($("fit-of"), [["", "none"], ...page.entries.filter((one) => one.kind === "fit").map((one) => [one.name, one.complete ? one.name : `${one.name} (not finished)`])]);
  $("fit-of").value = fit.name;
  const asked = JSON.stringify([page.values, { ...askedFit(), text: page.measured?.text?.length ?? 0 }]);
  if (asked !== fit.asked) {
    fit.asked = asked;
    $("fit-run").disabled = true;
    clearTimeout(fit.timer);
    fit.timer = setTimeout(checkFit, 250);
  }
}

async function checkFit() {
  const mine = ++fit.turn, asked = askedFit();
  let checked;
  if (asked.text.length > LARGEST_TEXT) checked = { errors: [{ field: "file", text: `the file is larger than ${LARGEST_TEXT / 1000} kB; put it into the folder of this page and choose it here` }], x: [], y: [], text: "" };
  else try { checked = await ask("POST", "/api/fit-check", { values: page.values, fit: asked }); } catch (error) { checked = { errors: [{ field: "", text: error.message }], x: [], y: [], text: "" }; }
  if (mine !== fit.turn) return;
  fit.checked = checked;
  drawFitErrors();
  drawFitPlot();
}

/** Each error stands at its field; those that have none stand below. */
function drawFitErrors() {
  const rows = [...document.querySelectorAll("[data-fit]")], { errors } = fit.checked;
  const placeOf = ({ field }) => rows.find((row) => field === row.dataset.fit || field.startsWith(`${row.dataset.fit}.`) || field.endsWith(`.${row.dataset.fit}`)) ?? rows.at(-1);
  const isAsked = fit.unknowns.length > 0 && page.measured;
  for (const row of rows) {
    const here = errors.filter((one) => placeOf(one) === row && (isAsked || !["add", "file"].includes(one.field) || (one.field === "file" && page.measured)));
    row.classList.toggle("wrong", here.length > 0);
    row.querySelector(".under").replaceChildren(...here.map((one) => h("div", { class: "error" }, one.text)));
    for (const input of row.querySelectorAll("input, select")) input.setAttribute("aria-invalid", String(here.some((one) => input.id === `fit-${one.field}` || input.id === `fit-${row.dataset.fit}`)));
  }
  $("fit-run").disabled = errors.length > 0;
}

async function beginFit() {
  try {
    const job = await ask("POST", "/api/fit", { values: page.values, name: `${baseName()}-fit`, fit: askedFit() });
    await refresh();
    await showFit(job.name);
  } catch (error) { $("fit-note").textContent = error.message; }
}

// --- What is known of a fit -----------------------------------------------------------------------------------------
async function showFit(name) {
  Object.assign(fit, { name, told: null });
  if (name) await followFit();
  drawFit();
  drawFitTold();
}

/** Reads how far the fit is that is shown. */
async function followFit() {
  if (!fit.name || (fit.told?.complete && !isActiveJob(fit.name))) return;
  const { name } = fit;
  try {
    const told = await ask("GET", `/api/fit?name=${encodeURIComponent(name)}`);
    if (fit.name !== name) return;
    const same = JSON.stringify(told) === JSON.stringify(fit.told);
    fit.told = told;
    if (!same || !told.complete) drawFitTold();
  } catch (error) { $("fit-note").textContent = error.message; }
}

function drawFitTold() {
  const told = fit.told, job = page.jobs.find((one) => one.name === fit.name), isLive = isActiveJob(fit.name) || told?.running;
  const values = Object.entries(told?.values ?? {}).map(([name, value]) => `${name} ${value}`).join(", ");
  const misfit = Number.isFinite(told?.misfit) ? `, misfit ${nice(told.misfit)} standard deviations` : "";
  $("fit-note").textContent = !told ? "" : told.complete ? `${told.runs} runs in ${nice(told.seconds)} s${misfit}` : `${isLive ? "" : "Not finished. "}${told.stage ?? ""}: ${told.runs ?? 0} runs${misfit}${values ? `; best so far: ${values}` : ""}${!isLive && job?.error ? `; ${job.error}` : ""}`;
  $("fit-again").hidden = !told || told.complete || Boolean(isLive);
  const rows = told?.complete ? told.rows : [], [head, ...body] = rows;
  $("fit-table").replaceChildren(...(head ? [
    h("table", {}, h("caption", {}, told.title), h("thead", {}, h("tr", {}, head.map((cell) => h("th", { scope: "col" }, cell)))), h("tbody", {}, body.map(([name, ...cells]) => h("tr", {}, h("th", { scope: "row" }, name), cells.map((cell) => h("td", {}, cell)))))),
    told.findings.length ? h("ul", { class: "findings" }, told.findings.map((text) => h("li", {}, text))) : "",
    h("p", {}, h("button", { type: "button", id: "fit-take", onclick: takeFit }, "Take these values into the case"), " ", h("span", { id: "fit-taken", class: "quiet", role: "status" }))] : []));
  drawFitPlot();
}

/** The measured points, and the best curve so far; before the fit begins the present case. */
function drawFitPlot() {
  if ($("fit").hidden) return;
  const told = fit.told, { x, y, text } = fit.checked ?? { x: [], y: [], text: "" };
  const known = told?.curves?.[0]?.columns, names = known?.length === 2 ? known : told?.curves?.length ? ["approach", "F_n"] : [$("x").value, $("y").value];
  const curves = (told?.curves ?? []).flatMap((one, i) => [{ name: `${one.name}, fitted`, line: true, x: one.x, y: one.fitted, colour: COLOURS[(i + 1) % COLOURS.length], dash: "solid" }, { name: `${one.name}, measured`, measured: true, x: one.x, y: one.measured }]);
  if (!curves.length && x.length) curves.push({ name: page.measured?.name ?? "", measured: true, x, y });
  if (!told && page.live) curves.push({ name: "this case", x: page.live.columns[names[0]] ?? [], y: page.live.columns[names[1]] ?? [], colour: COLOURS[0], dash: "solid" });
  drawCurves($("fit-plot"), curves, columnOf(names[0]), columnOf(names[1]));
  const folder = told ? fit.name : `results/${baseName()}-fit`;
  $("fit-command").textContent = `${told ? "" : "# after Fit has written the file, the case and the curve\n"}brinell fit ${quoted(`${folder}/fit.toml`)} -o ${quoted(folder)}`;
  $("fit-text").textContent = told ? told.text : text;
}

/** Gives the case the values that were found, in the units that it has. */
async function takeFit() {
  const changes = {}, taken = [], left = [];
  for (const { key, sizes } of fit.told.values) {
    const entry = /^(.*)\.(\d+)$/.exec(key), now = valueAt(key);
    if (now === undefined) { left.push(key); continue; }
    const field = form.fields.get(plainKey(key)) ?? form.fields.get(plainKey(entry?.[1] ?? key)), { unit } = split(field, Array.isArray(now) ? now[0] : now);
    const found = typeof now === "string" && unit in sizes && unit ? `${sizes[unit]} ${unit}` : sizes[""];
    if (key in page.values) changes[key] = found;
    else changes[entry[1]] = (changes[entry[1]] ?? page.values[entry[1]]).map((one, i) => (i === Number(entry[2]) ? found : one));
    taken.push(`${key} = ${found}`);
  }
  if (taken.length) await change(changes, false);
  $("fit-taken").textContent = [taken.length ? `Taken: ${taken.join(", ")}.` : "", left.length ? `No key of this case: ${left.join(", ")}.` : ""].join(" ");
}

function connectFit() {
  for (const which of ["x", "y"]) {
    $(`fit-${which}`).onchange = () => { $(which).value = $(`fit-${which}`).value; drawCurve(); };
    $(`fit-reverse-${which}`).onchange = () => { if (page.measured) page.measured.reverse[which] = $(`fit-reverse-${which}`).checked; drawCurve(); };
  }
  $("fit-file").onchange = async () => {
    const chosen = $("fit-file").value;
    if (chosen === "load") $("measured-file").click();
    else if (chosen.startsWith("f ")) try { readMeasured(chosen.slice(2), (await ask("GET", `/api/curve?name=${encodeURIComponent(chosen.slice(2))}`)).text, chosen.slice(2)); } catch (error) { $("fit-note").textContent = error.message; }
    drawFit();
  };
  for (const id of ["fit-noise", "fit-method", "fit-pass"]) $(id).oninput = drawFit;
  $("fit-loss").onchange = drawFit;
  $("fit-add").onchange = () => { const key = $("fit-add").value; $("fit-add").value = ""; if (key) addUnknown(key); };
  $("fit-run").onclick = beginFit;
  $("fit-of").onchange = () => showFit($("fit-of").value);
  $("fit-again").onclick = async () => { try { await ask("POST", "/api/resume", { name: fit.name }); await refresh(); await followFit(); } catch (error) { $("fit-note").textContent = error.message; } };
  for (const row of document.querySelectorAll("#fit [data-fit]")) {
    const id = row.querySelector(".under").id = `fit-error-${row.dataset.fit}`;
    for (const input of row.querySelectorAll("input, select")) input.setAttribute("aria-describedby", id);
  }
  RESIZED.observe($("fit-plot"));
}
