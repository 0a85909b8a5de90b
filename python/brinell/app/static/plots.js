// SPDX-License-Identifier: BSD-3-Clause
// Curves, maps, sections and surfaces, drawn by plotly.js. Colours are those of brinell.plot: Okabe and Ito's, safe for
// colour-blind readers; curves differ in their dashes, too.
"use strict";

const COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"];
const DASHES = ["solid", "dash", "dot", "dashdot", "longdash", "longdashdot"];
const INK = "#1d2733", SOFT = "#5b6876", BEFORE = "#b3bdc7";
const FONT = { family: 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif', size: 13, color: INK };
// Results stay on this machine: no button that sends a picture with its data to a server.
const CONFIG = { displaylogo: false, plotlyServerURL: "", modeBarButtonsToRemove: ["sendChartToCloud", "lasso2d", "select2d", "autoScale2d"] };
const AXIS = { zeroline: true, zerolinecolor: "#c9d1d9", gridcolor: "#edf0f3", linecolor: "#9aa5b1", showline: true, ticks: "outside", tickcolor: "#9aa5b1", automargin: true };

const PREFIXES = [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"]];
const PREFIXED = ["m", "Pa", "N", "J", "s", "m/s", "N/m", "W", "A", "V", "ohm", "Hz"];

/** Size and name of the unit in which a value of a column is shown. */
function scaleOf(unit, largest) {
  if (unit === "1" || !unit) return { size: 1, unit: "" };
  if (!PREFIXED.includes(unit) || !(largest > 0)) return { size: 1, unit };
  const found = PREFIXES.find(([size]) => largest >= size * 0.9999) ?? PREFIXES.at(-1);
  return { size: found[0], unit: found[1] + unit };
}

const largestOf = (curves, axis) => Math.max(0, ...curves.flatMap((curve) => curve[axis].filter(Number.isFinite).map(Math.abs)));

/** Name of a column for an axis: its text up to the first comma or bracket. */
const short = (column) => column.text.split(/[,;(:]/)[0].trim().replace(/^./, (letter) => letter.toUpperCase());

/** Draws curves; each has name, x, y, and may be `before` (what a change has replaced), `measured` or a `line` without markers. */
function drawCurves(element, curves, across, up) {
  const xs = scaleOf(across.unit, largestOf(curves, "x")), ys = scaleOf(up.unit, largestOf(curves, "y"));
  const data = curves.map((curve) => ({
    x: curve.x.map((one) => one / xs.size), y: curve.y.map((one) => one / ys.size), name: curve.name, type: "scatter",
    mode: curve.measured ? "markers" : curve.x.length < 40 && !curve.before && !curve.line ? "lines+markers" : "lines",
    line: { color: curve.before ? BEFORE : curve.colour, dash: curve.before ? "solid" : curve.dash, width: curve.before ? 1.5 : 2 },
    marker: curve.measured ? { color: "#000", symbol: "circle-open", size: 6 } : { color: curve.colour, size: 4.5 },
  }));
  const title = (column, unit) => ({ text: `${short(column)}${unit ? `  [${unit}]` : ""}`, standoff: 8 });
  const layout = { font: FONT, margin: { l: 70, r: 20, t: 14, b: 54 }, showlegend: curves.length > 1, hovermode: "closest", uirevision: `${across.name} ${up.name}`,
    legend: { orientation: "h", x: 0, y: 1.02, yanchor: "bottom", bgcolor: "rgba(0,0,0,0)" },
    xaxis: { ...AXIS, title: title(across, xs.unit) }, yaxis: { ...AXIS, title: title(up, ys.unit) } };
  const last = (curve) => (curve.y.length ? `${curve.name}, ${curve.y.length} points, ${up.name} from ${nice(Math.min(...curve.y.filter(Number.isFinite)) / ys.size)} to ${nice(Math.max(...curve.y.filter(Number.isFinite)) / ys.size)} ${ys.unit}` : `${curve.name}, no points`);
  element.setAttribute("aria-label", `${short(up)} over ${short(across)}: ${curves.filter((curve) => !curve.before).map(last).join("; ") || "no curve yet"}`);
  return Plotly.react(element, data, layout, CONFIG);
}

const nice = (value) => (Number.isFinite(value) ? Number(value.toPrecision(4)).toString() : "–");

/** Draws a picture that the server has computed. */
function drawPicture(element, picture) {
  const isSurface = picture.kind === "surface";
  const bar = { title: { text: picture.unit ? `[${picture.unit}]` : "", side: "top" }, thickness: 14, len: 0.9, outlinewidth: 0 };
  const common = { colorscale: picture.colours, [isSurface ? "cmin" : "zmin"]: picture.low, [isSurface ? "cmax" : "zmax"]: picture.high };
  const data = picture.parts.map((part, i) => ({
    ...common, type: isSurface ? "surface" : "heatmap", x: part.x, y: part.y, z: part.values, name: part.name, showscale: i === 0, colorbar: bar,
    ...(isSurface ? { contours: { z: { show: false } }, lighting: { ambient: 0.75, diffuse: 0.5, specular: 0.05 } } : { zsmooth: false }), // the cells, as computed
    hovertemplate: `%{z:.4g} ${picture.unit}<br>${picture.axes[0]} %{x:.4g}, ${picture.axes[1]} %{y:.4g} ${picture.length}<extra>${part.name}</extra>`,
  }));
  const axis = (i) => ({ ...AXIS, zeroline: false, showgrid: false, title: { text: `${picture.axes[i]}  [${picture.length}]`, standoff: 6 } });
  const layout = { font: FONT, margin: { l: 60, r: 10, t: 10, b: 48 }, uirevision: picture.kind };
  if (isSurface) {
    const three = (text) => ({ title: { text }, gridcolor: "#f7f9fa", zerolinecolor: "#f7f9fa" });
    layout.scene = { bgcolor: "#e3e9ee", xaxis: three(`x [${picture.length}]`), yaxis: three(`y [${picture.length}]`), zaxis: three(`height [${picture.unit}]`), aspectmode: "manual", aspectratio: { x: 1.4, y: 1.4 * ratio(picture), z: 0.45 }, camera: { eye: { x: 0.9, y: -1.25, z: 1.15 }, center: { x: 0, y: 0, z: -0.15 } } };
  } else {
    layout.xaxis = axis(0);
    layout.yaxis = { ...axis(1), scaleanchor: "x", constrain: "domain" };
    layout.xaxis.constrain = "domain";
    if (picture.kind === "section") layout.shapes = [{ type: "line", xref: "x domain", x0: 0, x1: 1, y0: 0, y1: 0, line: { color: INK, width: 1 } }];
    if (picture.parts.length > 1) layout.annotations = ["upper", "lower"].map((side, i) => ({ text: `${side} body`, xref: "x domain", yref: "y domain", x: 0.01, xanchor: "left", y: i ? 0.01 : 0.99, yanchor: i ? "bottom" : "top", showarrow: false, font: { color: "#fff", size: 12 }, bgcolor: "rgba(29,39,51,0.55)", borderpad: 3 }));
  }
  const values = picture.parts.flatMap((part) => part.values.flat()).filter(Number.isFinite);
  const range = values.length ? `from ${nice(values.reduce((a, b) => Math.min(a, b)))} to ${nice(values.reduce((a, b) => Math.max(a, b)))} ${picture.unit}` : "";
  element.setAttribute("aria-label", `${picture.title}, ${picture.state}: ${range}`);
  return Plotly.react(element, data, layout, CONFIG);
}

/** Gives pictures of one field the same range of colours, so that they can be compared. */
function shareColours(pictures) {
  const first = pictures[0];
  if (!pictures.every((one) => one.name === first.name && one.unit === first.unit && one.kind !== "surface")) return;
  const low = Math.min(...pictures.map((one) => one.low)), high = Math.max(...pictures.map((one) => one.high));
  for (const one of pictures) Object.assign(one, { low, high });
}

/** Draws plots anew before the browser paints them in another size; Plots.resize waits for a while, and an axis is cut off so long. */
const RESIZED = new ResizeObserver((entries) => { for (const { target } of entries) if (target.data && target.clientWidth) Plotly.relayout(target, { autosize: true }); });

/** Width over y by that over x. */
function ratio(picture) {
  const { x, y } = picture.parts[0];
  return Math.min(1.2, Math.max(0.3, (y.at(-1) - y[0]) / (x.at(-1) - x[0] || 1)));
}

/** Sizes of units with their names in menus and their letters. */
const FACTORS = [[1, "SI", ""], [1e-3, "milli (mm, mN)", "m"], [1e-6, "micro (µm)", "u"], [1e-9, "nano (nm)", "n"], [1e3, "kilo (kN)", "k"], [1e6, "mega (MPa)", "M"], [1e9, "giga (GPa)", "G"]];

/** Size of the unit that a title names, as in "depth [um]" or "load in mN"; 1 if it names none. */
function factorOf(title) {
  const unit = (/[[(]\s*([^\])]+?)\s*[\])]|\bin\s+(\S+)$/.exec(title)?.slice(1).find(Boolean) ?? "").replace(/^[µμ]/, "u");
  const isPrefixed = ["m", "N", "Pa", "s"].some((base) => unit.length === base.length + 1 && unit.endsWith(base));
  return (isPrefixed && FACTORS.find(([, , letter]) => letter === unit[0])?.[0]) || 1;
}

/** A measured curve of a text file: columns of numbers, with the names of a line of titles before them. */
function measuredOf(text) {
  const rows = [], titles = [];
  for (const line of text.split(/\r?\n/)) {
    if (!line.trim() || line.trim().startsWith("#")) continue;
    const separator = line.includes(";") ? ";" : line.includes("\t") ? "\t" : line.includes(",") ? "," : /\s+/;
    const cells = line.trim().split(separator).map((cell) => cell.trim());
    const numbers = cells.map((cell) => Number(separator === ";" ? cell.replace(",", ".") : cell));
    if (numbers.every(Number.isFinite) && cells.every(Boolean)) rows.push(numbers);
    else if (!rows.length) titles.splice(0, titles.length, ...cells);
  }
  const count = Math.min(...rows.map((row) => row.length));
  if (rows.length < 2 || count < 2) throw new Error("this file has no two columns of numbers");
  const columns = Array.from({ length: count }, (_, i) => rows.map((row) => row[i]));
  return { columns, titles: columns.map((_, i) => titles[i] || `column ${i + 1}`) };
}
