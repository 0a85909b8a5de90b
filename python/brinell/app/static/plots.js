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
const AXIS = { zeroline: true, zerolinecolor: "#c9d1d9", gridcolor: "#edf0f3", linecolor: "#9aa5b1", showline: true, ticks: "outside", tickcolor: "#9aa5b1", automargin: true, exponentformat: "power" };

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

/** A text in lines that fit beside a plot. */
const broken = (text, room) => (text.length + 6 > room / 9 ? text.replace(/(.{28}\S*)\s+(?=\S{3})/g, "$1<br>") : text);

/** Draws curves; each has name, x, y, and may be `before` (what a change has replaced), `measured` or a `line` without markers. */
function drawCurves(element, curves, across, up) {
  const xs = scaleOf(across.unit, largestOf(curves, "x")), ys = scaleOf(up.unit, largestOf(curves, "y"));
  const scaled = (values, { size }) => values.map((one) => (one === null ? null : one / size)); // null: not finite, no point
  const data = curves.map((curve) => ({
    x: scaled(curve.x, xs), y: scaled(curve.y, ys), name: curve.name, type: "scatter",
    mode: curve.measured ? "markers" : curve.x.length < 40 && !curve.before && !curve.line ? "lines+markers" : "lines",
    line: { color: curve.before ? BEFORE : curve.colour, dash: curve.before ? "solid" : curve.dash, width: curve.before ? 1.5 : 2 },
    marker: curve.measured ? { color: "#000", symbol: "circle-open", size: 6 } : { color: curve.colour, size: 4.5 },
  }));
  const isEmpty = !data.some(({ x, y }) => x.some((one, i) => Number.isFinite(one) && Number.isFinite(y[i])));
  const title = (column, unit, room) => ({ text: `${broken(short(column), room || 400)}${unit && !isEmpty ? `  [${unit}]` : ""}`, standoff: 8 });
  const empty = isEmpty ? { showticklabels: false, range: [0, 1] } : {};
  const nothing = { text: "Nothing to draw so far", xref: "paper", yref: "paper", x: 0.5, y: 0.5, showarrow: false, font: { color: SOFT } };
  const layout = { font: FONT, margin: { l: 70, r: 20, t: 30, b: 54 }, annotations: isEmpty ? [nothing] : [], showlegend: curves.length > 1, hovermode: "closest", uirevision: `${across.name} ${up.name} ${isEmpty}`,
    legend: { orientation: "h", x: 0, y: 1.02, yanchor: "bottom", bgcolor: "rgba(0,0,0,0)" },
    xaxis: { ...AXIS, ...empty, title: title(across, xs.unit, element.clientWidth) }, yaxis: { ...AXIS, ...empty, title: title(up, ys.unit, element.clientHeight) } };
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
  const layout = { font: FONT, margin: { l: 60, r: 10, t: 32, b: 48 }, uirevision: picture.kind }; // the buttons of the plot stand above it
  if (isSurface) {
    const three = (text) => ({ title: { text, font: { size: 12 } }, gridcolor: "#f7f9fa", zerolinecolor: "#f7f9fa", nticks: 5, tickfont: { size: 11 } });
    const back = Math.max(1, (1.5 * element.clientHeight) / (element.clientWidth || 1)); // so far that no axis is cut off
    layout.margin.l = 0;
    layout.scene = { uirevision: back.toFixed(1), bgcolor: "#e3e9ee", xaxis: three(`x on body [${picture.length}]`), yaxis: three(`y [${picture.length}]`), zaxis: { ...three(`height [${picture.unit}]`), range: [picture.low, picture.high] }, aspectmode: "manual", aspectratio: { x: 1.4, y: 1.4 * ratio(picture), z: 0.45 }, camera: { eye: { x: 0.9 * back, y: -1.25 * back, z: 1.15 * back }, center: { x: 0, y: 0, z: -0.15 } } };
  } else {
    layout.xaxis = axis(0);
    layout.yaxis = { ...axis(1), scaleanchor: "x", constrain: "domain" };
    Object.assign(layout.xaxis, { constrain: "domain", constraintoward: "right" }); // beside the bar of colours
    if (picture.kind === "section") layout.shapes = [{ type: "line", xref: "x domain", x0: 0, x1: 1, y0: 0, y1: 0, line: { color: INK, width: 1 } }];
    if (picture.parts.length > 1) layout.annotations = ["upper", "lower"].map((side, i) => ({ text: `${side} body`, xref: "x domain", yref: "y domain", x: 0.01, xanchor: "left", y: i ? 0.01 : 0.99, yanchor: i ? "bottom" : "top", showarrow: false, font: { color: "#fff", size: 12 }, bgcolor: "rgba(29,39,51,0.55)", borderpad: 3 }));
  }
  const values = picture.parts.flatMap((part) => part.values.flat()).filter(Number.isFinite);
  const range = values.length ? `from ${nice(values.reduce((a, b) => Math.min(a, b)))} to ${nice(values.reduce((a, b) => Math.max(a, b)))} ${picture.unit}` : "";
  element.setAttribute("aria-label", `${picture.title}, ${picture.state}: ${range}`);
  return Plotly.react(element, data, layout, CONFIG);
}

/** Gives pictures of one field the same unit and the same range of colours, so that they can be compared. */
function shareColours(pictures) {
  const first = pictures[0], { size, unit } = pictures.reduce((a, b) => (b.size > a.size ? b : a));
  if (!pictures.every((one) => one.kind === first.kind && (one.kind === "surface" || one.name === first.name))) return;
  for (const one of pictures.filter((other) => other.unit !== unit)) {
    const times = one.size / size, scaled = (value) => (value === null ? null : value * times);
    Object.assign(one, { unit, size, low: one.low * times, high: one.high * times, parts: one.parts.map((part) => ({ ...part, values: part.values.map((row) => row.map(scaled)) })) });
  }
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

/** Sizes of units with their prefixes as shown, and as letters. */
const FACTORS = [[1, "", ""], [1e-3, "m", "m"], [1e-6, "µ", "u"], [1e-9, "n", "n"], [1e3, "k", "k"], [1e6, "M", "M"], [1e9, "G", "G"]];

/** Units in which a file may have values of a column: [size, name]. */
const factorsOf = (unit) => (PREFIXED.includes(unit) ? FACTORS.map(([size, prefix]) => [size, prefix + unit]) : [[1, !unit || unit === "1" ? "as it is" : unit]]);

/** Size of the unit that a title names, as in "depth [um]" or "load in mN", for values in `of`; and what it names, if that is no such unit. */
function factorOf(title, of) {
  const named = /[[(]\s*([^\])]+?)\s*[\])]|\bin\s+(\S+)$/.exec(title)?.slice(1).find(Boolean) ?? "", unit = named.replace(/^[µμ]/, "u");
  if (!unit || unit === of || (of === "1" && unit === "-")) return { size: 1, wrong: "" };
  const found = PREFIXED.includes(of) && unit.endsWith(of) && FACTORS.find(([, , letter]) => letter && letter + of === unit);
  return found ? { size: found[0], wrong: "" } : { size: 1, wrong: named };
}

/** A measured curve of a text file: columns of numbers, with the names of a line of titles before them. */
function measuredOf(text) {
  const rows = [], titles = [], left = [];
  for (const [i, line] of text.split(/\r?\n/).entries()) {
    if (!line.trim() || line.trim().startsWith("#")) continue;
    const separator = line.includes(";") ? ";" : line.includes("\t") ? "\t" : line.includes(",") ? "," : /\s+/;
    const cells = line.trim().split(separator).map((cell) => cell.trim());
    const numbers = cells.map((cell) => Number(separator === ";" ? cell.replace(",", ".") : cell));
    if (numbers.every(Number.isFinite) && cells.every(Boolean)) rows.push(numbers);
    else if (!rows.length) titles.splice(0, titles.length, ...cells);
    else left.push(`line ${i + 1}, "${line.trim().slice(0, 40)}"`);
  }
  const count = Math.min(...rows.map((row) => row.length));
  if (rows.length < 2 || count < 2) throw new Error("this file has no two columns of numbers");
  const columns = Array.from({ length: count }, (_, i) => rows.map((row) => row[i]));
  return { columns, left, titles: columns.map((_, i) => titles[i] || `column ${i + 1}`) };
}
