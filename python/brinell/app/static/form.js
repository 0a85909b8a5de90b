// SPDX-License-Identifier: BSD-3-Clause
// The form of a case, made of the schema that the server sends. No key is named here, but for the order of the groups.
"use strict";

/** An element with attributes and children; texts stay texts, whatever they say. */
function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

/** Gives a menu entries [value, text, title]. One that has them stays as it is, as new ones close it while it is open. */
function offer(select, entries) {
  if (JSON.stringify([...select.options].map((one) => [one.value, one.text])) === JSON.stringify(entries.map(([value, text]) => [String(value), text.trim()]))) return;
  const kept = select.value;
  select.replaceChildren(...entries.map(([value, text, title]) => h("option", { value, title }, text)));
  if (entries.some(([value]) => String(value) === kept)) select.value = kept;
}

const plainKey = (key) => key.replace(/\[\d+\]/g, "");
const tableOf = (key) => key.slice(0, Math.max(0, key.lastIndexOf(".")));
const sentence = (word) => word.charAt(0).toUpperCase() + word.slice(1).replaceAll("_", " ");

const QUANTITY = /^\s*([-+−]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$/;

/** Text and unit of a value; the unit is null where the text says it itself. */
function split(field, value) {
  if (Array.isArray(value)) {
    const parts = value.map((one) => split(field, one));
    const units = new Set(parts.filter((one) => !/^[-+]?0(\.0*)?$/.test(one.text)).map((one) => one.unit));
    if (units.size <= 1) return { text: parts.map((one) => one.text).join(", "), unit: [...units][0] ?? parts[0]?.unit ?? field.bare };
    return { text: value.join(", "), unit: null };
  }
  if (typeof value === "number") return { text: String(value), unit: field.bare };
  const found = QUANTITY.exec(String(value));
  return found ? { text: found[1], unit: found[2] } : { text: String(value), unit: null };
}

/** The value of the case for a text and a unit; undefined for no value. */
function joined(field, text, unit) {
  const isList = field.kind === "numbers" || field.kind === "vector3";
  const one = (part) => {
    const found = QUANTITY.exec(part);
    const number = found ? Number(found[1].replace("−", "-").replaceAll("_", "")) : NaN;
    if (!Number.isFinite(number) || found[2]) return part.trim();
    return unit && number !== 0 ? `${found[1]} ${unit}` : number;
  };
  if (!text.trim()) return undefined;
  const parts = text.split(/[,;]/).filter((part) => part.trim());
  if (isList && (parts.length > 1 || field.kind === "vector3")) return parts.map(one);
  return one(text);
}

class Form {
  /** @param element where the form stands; @param on what is done for a change: change, slide, release, material. */
  constructor(element, sections, on) {
    this.element = element;
    this.sections = sections;
    this.on = on;
    this.fields = new Map(sections.flatMap((section) => section.fields.map((field) => [field.key, field])));
    this.sliders = new Map(); // the value about which each slider was made
    this.units = new Map(); // the last unit of each value that was right
    this.helped = new Set();
    this.opened = new Map();
  }

  /** Draws the form for a case and what was found in it; the place of the cursor stays. */
  draw(values, checked, materials) {
    Object.assign(this, { values, checked, materials });
    for (const details of this.element.querySelectorAll("details")) this.opened.set(details.dataset.fold, details.open); // its event may still be on its way
    const held = this.held(), scroll = this.element.parentElement.scrollTop;
    const groups = new Map();
    const applies = checked.applies;
    const wrong = checked.errors.map((one) => one.key).filter((key) => this.fields.has(plainKey(key)));
    const keys = [...new Set([...Object.keys(applies), ...Object.keys(values), ...wrong])];
    const byTable = new Map();
    for (const key of keys) {
      const table = tableOf(key);
      if (!byTable.has(table)) byTable.set(table, []);
      byTable.get(table).push(key);
    }
    const order = new Map(this.sections.map((section, i) => [section.table, i]));
    const known = [...byTable].sort((a, b) => (order.get(plainKey(a[0])) ?? 999) - (order.get(plainKey(b[0])) ?? 999) || a[0].localeCompare(b[0]));
    for (const [table, here] of known) {
      const group = this.group(table);
      if (!groups.has(group)) groups.set(group, []);
      groups.get(group).push(this.table(table, here));
    }
    this.element.replaceChildren(...[...groups].map(([name, tables], i) => this.drawnGroup(name, tables, i)));
    this.element.parentElement.scrollTop = scroll;
    if (held) this.hold(held);
  }

  /** Where the cursor is, with a text that is being typed. */
  held() {
    const one = document.activeElement;
    if (!one?.id || !this.element.contains(one)) return null;
    const isTyped = one.type === "text" && one.value !== one.defaultValue;
    return { id: one.id, text: isTyped ? one.value : null, selection: one.type === "text" ? [one.selectionStart, one.selectionEnd] : null };
  }

  hold({ id, text, selection }) {
    const one = document.getElementById(id);
    if (!one) return;
    if (text !== null) {
      one.value = text;
      one.addEventListener("blur", () => { if (one.value !== one.defaultValue && one.isConnected) one.dispatchEvent(new Event("change")); }, { once: true });
    }
    one.focus({ preventScroll: true });
    if (selection) one.setSelectionRange(...selection);
  }

  group(table) {
    if (!table) return "Case";
    const top = table.split(/[.[]/)[0];
    return top === "lower" || top === "upper" ? `${sentence(top)} body` : sentence(top);
  }

  drawnGroup(name, tables, i) {
    const hasError = tables.some((table) => table.querySelector(".wrong"));
    const isOpen = this.opened.get(name) ?? (i < 4 || hasError);
    const used = tables.filter((table) => table.dataset.used), idle = tables.filter((table) => !table.dataset.used);
    const details = h("details", { class: "group", "data-fold": name, open: isOpen || hasError }, h("summary", {}, name), h("div", { role: "group", "aria-label": name }, used, idle.length ? this.idle(name, idle) : null));
    details.addEventListener("toggle", () => this.opened.set(name, details.open));
    return details;
  }

  /** Tables of which nothing is given, behind one line that names them. */
  idle(group, tables) {
    const id = `idle ${group}`, names = tables.map((table) => table.dataset.name.toLowerCase()).filter(Boolean);
    if (tables.length === 1 && !names.length) return tables[0]; // it has a fold of its own
    const details = h("details", { class: "more", "data-fold": id, open: this.opened.get(id) ?? false }, h("summary", {}, `More: ${names.join(", ")}`), tables);
    details.addEventListener("toggle", () => {
      this.opened.set(id, details.open);
      if (details.open && tables.length === 1) for (const inner of details.querySelectorAll("details")) inner.open = true;
    });
    return details;
  }

  table(table, keys) {
    const section = this.sections.find((one) => one.table === plainKey(table));
    const inOrder = section ? section.fields.map((field) => keys.find((key) => plainKey(key) === field.key)).filter(Boolean) : [];
    const all = [...inOrder, ...keys.filter((key) => !inOrder.includes(key))];
    const has = new Set([...this.checked.errors, ...this.checked.warnings].map((one) => one.key));
    const isMain = (key) => key in this.values || has.has(key) || this.sliders.has(key) || this.fields.get(plainKey(key))?.required;
    const main = all.filter((key) => isMain(key)), more = all.filter((key) => !isMain(key));
    const parts = [], ofTable = this.checked.errors.filter((one) => plainKey(one.key) === plainKey(table) && table);
    if (tableOf(table) || /\[/.test(table)) parts.push(this.heading(table, section));
    if (/^(lower|upper)\.material$/.test(table)) parts.push(this.material(table));
    parts.push(...ofTable.map((one, i) => h("div", { class: "error wrong", id: i ? null : `f-${one.key}`, tabindex: -1 }, one.text)));
    parts.push(...main.map((key) => this.field(key)));
    if (more.length) {
      const id = `more ${table}`;
      const isOpen = this.opened.get(id) ?? (!main.length && more.length <= 2 && Boolean(table.includes(".")));
      const label = this.namesOf(more);
      const details = h("details", { class: "more", "data-fold": id, open: isOpen }, h("summary", {}, label));
      if (isOpen) details.append(...more.map((key) => this.field(key)));
      details.addEventListener("toggle", () => {
        this.opened.set(id, details.open);
        if (details.open && details.children.length === 1) details.append(...more.map((key) => this.field(key)));
      });
      parts.push(details);
    }
    return h("div", { class: "table", "data-used": main.length || ofTable.length ? "yes" : null, "data-name": this.nameOf(table), role: this.nameOf(table) ? "group" : null, "aria-label": this.nameOf(table) || null }, parts);
  }

  /** What a fold holds, by the labels of its first fields. */
  namesOf(keys) {
    const labels = keys.map((key) => (this.fields.get(plainKey(key))?.label ?? key).toLowerCase());
    const rest = labels.length - 3;
    return `More: ${labels.slice(0, 3).join(", ")}${rest > 0 ? ` and ${rest} ${rest === 1 ? "other" : "others"}` : ""}`;
  }

  heading(table, section) {
    const number = /\[(\d+)\]$/.exec(table), label = this.nameOf(table);
    const buttons = [];
    if (section?.repeats && number) {
      const isThere = this.exists(table, number[1]);
      buttons.push(h("button", { type: "button", class: "link", onclick: () => this.add(table) }, isThere ? "add another" : "add"));
      if (isThere) buttons.push(h("button", { type: "button", class: "link", onclick: () => this.remove(table) }, "remove"));
    }
    return h("h3", {}, label, buttons);
  }

  nameOf(table) {
    const number = /\[(\d+)\]$/.exec(table);
    const counted = number && (Number(number[1]) || this.exists(table, 1)) ? ` ${Number(number[1]) + 1}` : "";
    return table.includes(".") ? sentence(plainKey(table).split(".").at(-1)) + counted : "";
  }

  exists(table, number) {
    return Object.keys(this.values).some((key) => key.startsWith(`${table.replace(/\[\d+\]$/, `[${number}]`)}.`));
  }

  add(table) {
    const stem = table.replace(/\[\d+\]$/, "");
    let number = 0;
    while (this.exists(table, number)) number += 1;
    const field = this.sections.find((section) => section.table === plainKey(table)).fields[0];
    const start = field.choices[1] ?? field.choices[0] ?? 0;
    this.on.change({ [`${stem}[${number}]${field.key.slice(plainKey(table).length)}`]: start }, true);
  }

  remove(table) {
    const stem = table.replace(/\[\d+\]$/, ""), gone = Number(/\[(\d+)\]$/.exec(table)[1]);
    const change = {};
    for (const [key, value] of Object.entries(this.values)) {
      if (!key.startsWith(`${stem}[`)) continue;
      const number = Number(/\[(\d+)\]/.exec(key.slice(stem.length))[1]);
      if (number >= gone && !(key in change)) change[key] = undefined;
      if (number > gone) change[key.replace(`${stem}[${number}]`, `${stem}[${number - 1}]`)] = value;
    }
    this.on.change(change, true);
  }

  material(table) {
    const id = `material-${table}`;
    const own = this.materials.filter((one) => one.own), standard = this.materials.filter((one) => !one.own);
    const mine = Object.fromEntries(Object.entries(this.values).filter(([key]) => key.startsWith(`${table}.`)).map(([key, value]) => [key.slice(table.length + 1), value]));
    const same = this.materials.find((one) => sameValues(one.values, mine));
    const option = (one) => h("option", { value: one.name, selected: one === same }, one.name);
    const select = h("select", { class: "value", id, onchange: () => this.on.material(table, select.value) },
      h("option", { value: "" }, same ? "none" : "own constants"),
      own.length ? h("optgroup", { label: "Own" }, own.map(option)) : null, h("optgroup", { label: "Standards" }, standard.map(option)));
    const store = h("button", { type: "button", class: "link", title: "Keep these constants among the own materials", onclick: () => this.on.store(mine) }, "keep …");
    const drop = same?.own ? h("button", { type: "button", class: "link", onclick: () => this.on.drop(same.name) }, "remove") : null;
    return h("div", { class: "field" }, h("label", { for: id }, "Taken from"), h("div", { class: "inputs" }, select, same && !same.own ? null : store, drop),
      same?.source ? h("div", { class: "under help" }, same.source) : null);
  }

  field(key) {
    const field = this.fields.get(plainKey(key)) ?? { key, label: key, kind: "unknown", units: [], choices: [], default: "", help: "The schema has no such key.", range: "", bare: "" };
    const id = `f-${key}`;
    const errors = this.checked.errors.filter((one) => one.key === key), warnings = this.checked.warnings.filter((one) => one.key === key);
    const box = h("div", { class: `field${errors.length ? " wrong" : ""}${key in this.values ? "" : " unset"}`, "data-key": key });
    const described = `d-${key}`;
    const attributes = { id, "aria-describedby": described, "aria-invalid": errors.length ? "true" : null, "aria-required": field.required ? "true" : null };
    const control = this.control(key, field, attributes);
    const help = h("button", { type: "button", class: "small", "aria-label": `What is ${field.label}?`, "aria-expanded": String(this.helped.has(key)),
      onclick: () => { this.helped.has(key) ? this.helped.delete(key) : this.helped.add(key); box.replaceWith(this.field(key)); document.querySelector(`[data-key="${CSS.escape(key)}"] [aria-expanded]`)?.focus(); } }, "?");
    const inputs = h("div", { class: "inputs" }, control, this.canSlide(key, field) ? this.slideButton(key, field, box) : null, help);
    const isGroup = field.kind === "words";
    box.append(h(isGroup ? "span" : "label", isGroup ? { class: "label" } : { for: id, title: key }, field.label), inputs);
    if (this.sliders.has(key)) box.append(this.slider(key, field));
    const below = h("div", { class: "under", id: described });
    const said = (one) => (one.text.startsWith(key) ? one.text.slice(key.length).replace(/^ = /, "").trim() : one.text); // the key stands there already
    below.append(...errors.map((one) => h("div", { class: "error" }, said(one))), ...warnings.map((one) => h("div", { class: "warning" }, said(one))));
    if (this.helped.has(key)) below.append(h("div", { class: "help" }, field.help, field.range ? ` Allowed: ${field.range}${field.bare ? `, in ${field.bare}` : ""}.` : "", field.default ? ` Without a value: ${field.default}.` : "", h("br"), h("code", {}, key)));
    box.append(below);
    return box;
  }

  control(key, field, attributes) {
    const value = this.values[key], set = (given, parks = false) => this.on.change({ [key]: given }, parks);
    if (field.kind === "choice" || field.kind === "boolean") return this.choice(field, value, attributes, set);
    if (field.kind === "words") return this.words(field, value, attributes, set);
    const isNumeric = ["number", "numbers", "vector3", "integer"].includes(field.kind);
    const units = this.checked.applies[key]?.pure ? [] : field.units;
    if (isNumeric) return this.number(key, field, value, attributes, units);
    const shown = value === undefined ? "" : typeof value === "string" ? value : JSON.stringify(value);
    const isText = field.kind === "text" || field.kind === "snapshots";
    const input = h("input", { type: "text", ...attributes, value: shown, placeholder: this.without(field), list: field.is_file ? "data-files" : null,
      onchange: () => set(input.value === "" ? undefined : isText ? listOr(input.value, field.kind) : parsedOr(input.value)) });
    return input;
  }

  number(key, field, value, attributes, units) {
    if (Array.isArray(value) && value.length > 60) return h("span", { ...attributes }, `${value.length} values`);
    const given = this.given(key, field, value, units);
    const choices = units.length && given.unit !== null && !units.includes(given.unit) ? [given.unit, ...units] : units;
    const unit = units.length ? h("select", { class: "unit", "aria-label": `Unit of ${field.label}` }, given.unit === null ? h("option", { value: "" }, "–") : null,
      choices.map((one) => h("option", { value: one, selected: one === given.unit }, one === "" ? "1" : one))) : null;
    const change = () => this.on.change({ [key]: joined(field, input.value, unit?.value ?? "") }, false);
    const input = h("input", { type: "text", ...attributes, inputmode: "decimal", value: units.length ? given.text : value === undefined ? "" : [].concat(value).join(", "),
      placeholder: field.required ? "" : this.without(field), onchange: change });
    unit?.addEventListener("change", () => { if (input.value) change(); });
    return unit ? [input, unit] : input;
  }

  /** What holds without a value, in this scenario and in short. */
  without(field) {
    const here = new RegExp(`, in ${this.values.scenario} ([^,;]+)`).exec(field.default)?.[1];
    const short = here ?? field.default.split(/;|, in (?=[a-z]+ [\d.]+)/)[0];
    return short.replace(/-?\d+\.\d{6,}/g, (number) => String(Number(Number(number).toPrecision(4))));
  }

  /** Text and unit as they are shown: a text that is no quantity stands whole, beside the unit that held before it. */
  given(key, field, value, units) {
    const usual = this.units.get(key) ?? units[0] ?? "";
    if (value === undefined) return { text: "", unit: usual };
    const found = split(field, value), isWrong = this.checked.errors.some((one) => one.key === key);
    if (units.length && isWrong && !Array.isArray(value) && found.unit !== usual && !units.includes(found.unit)) return { text: String(value), unit: usual };
    if (units.length && !isWrong && found.unit !== null) this.units.set(key, found.unit);
    return found;
  }

  choice(field, value, attributes, set) {
    const isBoolean = field.kind === "boolean";
    const choices = isBoolean ? [true, false] : field.choices.slice();
    if (field.per_axis) choices.push([field.choices[0], field.choices[1]], [field.choices[1], field.choices[0]]);
    const text = (one) => (isBoolean ? (one === true ? "yes" : one === false ? "no" : String(one)) : [].concat(one).join(", "));
    const asText = choices.map((one) => JSON.stringify(one));
    if (value !== undefined && !asText.includes(JSON.stringify(value))) { choices.push(value); asText.push(JSON.stringify(value)); }
    const without = field.default.replaceAll('"', "").replace(/^true$/, "yes").replace(/^false$/, "no");
    const select = h("select", { class: "value", ...attributes, onchange: () => set(select.value ? JSON.parse(select.value) : undefined, true) },
      field.required && value !== undefined ? null : h("option", { value: "" }, field.required ? "choose" : `${without} (default)`),
      choices.map((one, i) => h("option", { value: asText[i], selected: JSON.stringify(value) === asText[i] }, text(one))));
    return select;
  }

  words(field, value, attributes, set) {
    const chosen = new Set([].concat(value ?? []));
    const one = (word) => {
      const box = h("input", { type: "checkbox", checked: chosen.has(word), onchange: () => {
        box.checked ? chosen.add(word) : chosen.delete(word);
        set(chosen.size ? field.choices.filter((choice) => chosen.has(choice)) : undefined);
      } });
      return h("label", {}, box, ` ${word.replaceAll("_", " ")}`);
    };
    return h("fieldset", { class: "words", ...attributes, "aria-label": field.label }, field.choices.map(one), chosen.size ? null : h("span", { class: "quiet" }, `None is chosen; this then holds: ${field.default}`));
  }

  canSlide(key, field) {
    const value = this.values[key];
    const first = Array.isArray(value) ? value[0] : value;
    return ["number", "numbers", "integer"].includes(field.kind) && first !== undefined && !(Array.isArray(value) && value.length > 60) && QUANTITY.test(String(first));
  }

  slideButton(key, field, box) {
    return h("button", { type: "button", class: "small", "aria-label": `Slider for ${field.label}`, "aria-pressed": String(this.sliders.has(key)), title: "Slider",
      onclick: () => {
        this.sliders.has(key) ? this.sliders.delete(key) : this.sliders.set(key, null);
        box.replaceWith(this.field(key));
        const there = document.querySelector(`[data-key="${CSS.escape(key)}"]`);
        (there.querySelector("input[type=range]") ?? there.querySelector("[aria-pressed]"))?.focus();
      } }, "⇿");
  }

  /** A slider about the present value: a quarter to four times, or the whole of a closed range. */
  slider(key, field) {
    const value = this.values[key];
    const first = split(field, Array.isArray(value) ? value[0] : value);
    const now = Number(first.text.replace("−", "-")), made = this.sliders.get(key);
    const isWithin = made !== null && made.unit === first.unit && (made.middle > 0 ? now >= made.middle / 4.01 && now <= made.middle * 4.01 : now === made.middle);
    if (!isWithin) this.sliders.set(key, { middle: now, unit: first.unit });
    const { middle } = this.sliders.get(key);
    const range = /^in ([[(])(-?[\d.e+-]+), (-?[\d.e+-]+)([\])])$/.exec(field.range);
    const inUnit = (this.checked.applies[key]?.pure || first.unit === field.bare || !field.units.length) && field.kind !== "integer";
    const closed = range && inUnit && Number(range[3]) - Number(range[2]) <= 100 ? [Number(range[2]), Number(range[3])] : null;
    const isLog = !closed && middle > 0;
    const [low, high] = closed ?? (isLog ? [middle / 4, middle * 4] : middle ? [4 * middle, 0] : [-1, 1]);
    const place = (at) => {
      const found = isLog ? low * (high / low) ** at : low + (high - low) * at;
      if (field.kind === "integer") return String(Math.max(1, Math.round(found)));
      if (closed && at === 0 && range[1] === "(") return Number((low + (high - low) * 0.001).toPrecision(4)).toString();
      if (closed && at === 1 && range[4] === ")") return Number((high - (high - low) * 0.001).toPrecision(4)).toString();
      return Number(found.toPrecision(3)).toString();
    };
    const start = isLog ? Math.log(now / low) / Math.log(high / low) : (now - low) / (high - low);
    const pure = this.checked.applies[key]?.pure;
    const output = h("output", { class: "quiet" }, `${first.text} ${pure ? "" : first.unit ?? ""}`);
    const given = () => {
      const one = joined({ ...field, kind: "number" }, place(Number(input.value)), pure ? "" : typeof (Array.isArray(value) ? value[0] : value) === "number" ? "" : first.unit);
      return Array.isArray(value) ? [one, ...value.slice(1)] : one;
    };
    const tell = () => {
      output.textContent = `${place(Number(input.value))} ${pure ? "" : first.unit ?? ""}`;
      input.setAttribute("aria-valuetext", output.textContent);
      const box = document.getElementById(`f-${key}`);
      if (box) box.value = Array.isArray(value) ? split(field, given()).text : place(Number(input.value));
    };
    const input = h("input", { type: "range", min: 0, max: 1, step: 0.005, value: start, "aria-valuetext": output.textContent, "aria-label": `Slider for ${field.label}`, id: `s-${key}`,
      oninput: () => { tell(); this.on.slide(key, given()); }, onchange: () => { tell(); this.on.release(key, given()); } });
    return h("div", { class: "under slider" }, input, output);
  }

  /** Leads to the field of a problem. */
  show(key) {
    const find = () => document.getElementById(`f-${key}`) ?? document.querySelector(`[data-key^="${CSS.escape(`${key}.`)}"] input, [data-key^="${CSS.escape(`${key}.`)}"] select`);
    const group = [...this.element.querySelectorAll("details")];
    for (const details of group) details.open ||= Boolean(details.querySelector(`[data-key="${CSS.escape(key)}"]`));
    const found = find();
    found?.closest("details.group")?.setAttribute("open", "");
    found?.scrollIntoView({ block: "center" });
    found?.focus({ preventScroll: true });
  }
}

const parsedOr = (text) => { try { return JSON.parse(text); } catch { return text; } };
const listOr = (text, kind) => (kind === "snapshots" && /^\[?[\d,\s]+\]?$/.test(text) ? text.replace(/[[\]\s]/g, "").split(",").filter(Boolean).map(Number) : text);
const sameValues = (a, b) => Object.keys(a).length === Object.keys(b).length && Object.keys(a).every((key) => JSON.stringify(a[key]) === JSON.stringify(b[key]));
