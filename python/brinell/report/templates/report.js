// SPDX-License-Identifier: BSD-3-Clause
// The pictures that can be turned and moved. Their data lie in the page, 32-bit floats as base64.
(function () {
  "use strict";
  const { surfaces, volumes } = JSON.parse(document.getElementById("data").textContent);
  // Results stay on this machine: no button that sends a picture with its data to a server.
  const removed = ["sendChartToCloud", "select2d", "lasso2d"];
  const config = { responsive: true, displaylogo: false, plotlyServerURL: "", modeBarButtonsToRemove: removed };
  const SURFACE = { width: 1.6, height: 0.5 }; // of the relief, in units of its scene
  const font = { family: 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif', size: 13, color: "#1d2733" };
  const element = (id) => document.getElementById(id);

  function floats(text) {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    return new Float32Array(bytes.buffer);
  }

  // Rows of a table of values; at(row, column) is an index into them.
  const rows = (values, height, width, at) =>
    Array.from({ length: height }, (_, j) => Array.from({ length: width }, (_, i) => values[at(j, i)]));

  function fill(select, names) {
    select.replaceChildren(...names.map((name, index) => new Option(name, index)));
  }

  // Reads like an axis of the figures: letter in italics, unit in brackets.
  const title = (letter, unit, before = "") => ({ text: `${before}<i>${letter}</i>  [${unit}]` });

  // --- Relief of a surface ---------------------------------------------------------------------------------------------

  function drawSurface(one) {
    const heights = floats(one.heights);
    const [nx, ny] = [one.x.length, one.y.length];
    const [width, depth] = [one.x[nx - 1] - one.x[0], one.y[ny - 1] - one.y[0]];
    const larger = Math.max(width, depth);
    const lowest = heights.reduce((a, b) => Math.min(a, b), 0);
    const highest = heights.reduce((a, b) => Math.max(a, b), 0);
    const factor = (SURFACE.height / (highest - lowest)) / (SURFACE.width / larger) / one.heightOverLength;
    element("surface-factor").textContent = Number(factor.toPrecision(2)).toLocaleString("en");
    const trace = {
      type: "surface",
      x: one.x,
      y: one.y,
      z: rows(heights, ny, nx, (j, i) => j * nx + i),
      colorscale: one.colours,
      cmin: lowest,
      cmax: highest,
      colorbar: { title: { text: `height  [${one.heightUnit}]`, side: "right" }, thickness: 16, len: 0.7 },
      lighting: { ambient: 0.75, diffuse: 0.5, specular: 0.05 },
      hovertemplate: `x %{x} ${one.unit}<br>y %{y} ${one.unit}<br>height %{z:.4g} ${one.heightUnit}<extra></extra>`,
    };
    const scene = {
      xaxis: { title: title("x", one.unit) },
      yaxis: { title: title("y", one.unit) },
      zaxis: { title: { text: `height  [${one.heightUnit}]` }, range: [lowest, highest], nticks: 5 },
      aspectmode: "manual",
      aspectratio: { x: (SURFACE.width * width) / larger, y: (SURFACE.width * depth) / larger, z: SURFACE.height },
      camera: { eye: { x: 0.85, y: -1.75, z: 1.15 }, center: { x: 0, y: 0, z: -0.2 } },
    };
    const layout = { margin: { l: 0, r: 0, t: 0, b: 0 }, font, scene, uirevision: "kept" };
    Plotly.react("surface", [trace], layout, config);
  }

  if (surfaces.length) {
    fill(element("surface-body"), surfaces.map((one) => one.body));
    element("surface-body").addEventListener("change", (event) => drawSurface(surfaces[event.target.value]));
    drawSurface(surfaces[0]);
  }

  // --- Slices of a volume ----------------------------------------------------------------------------------------------

  const bodies = [...new Set(volumes.map((one) => one.body))];
  let choices = []; // fields of the chosen body, in all its states
  let values = null; // of the chosen field

  const nearest = (list, value) =>
    list.reduce((best, one, index) => (Math.abs(one - value) < Math.abs(list[best] - value) ? index : best), 0);

  function chooseBody() {
    const before = choices.length ? element("slice-field").selectedOptions[0].text : null;
    choices = volumes
      .filter((one) => one.body === bodies[element("slice-body").value])
      .flatMap((volume) => volume.fields.map((field) => ({ volume, field })));
    const names = choices.map(({ volume, field }) => `${field.title}, ${volume.state}`);
    fill(element("slice-field"), names);
    element("slice-field").value = Math.max(0, names.indexOf(before));
    chooseField();
  }

  function chooseField() {
    values = floats(choices[element("slice-field").value].field.values);
    choosePlane();
  }

  // Starts in the middle, or where most has yielded; a depth, where the field is largest.
  function choosePlane() {
    const { volume } = choices[element("slice-field").value];
    const plane = element("slice-plane").value;
    const places = volume[plane];
    let start = nearest(places, plane === "y" ? volume.first_y : 0);
    if (plane === "z") {
      const largest = values.reduce((best, one, at) => (Math.abs(one) > Math.abs(values[best]) ? at : best), 0);
      start = Math.floor(largest / (volume.x.length * volume.y.length));
    }
    element("slice-place").max = places.length - 1;
    element("slice-place").value = start;
    drawSlice();
  }

  function drawSlice() {
    const { volume, field } = choices[element("slice-field").value];
    const plane = element("slice-plane").value;
    const at = Number(element("slice-place").value);
    const [nx, ny] = [volume.x.length, volume.y.length];
    const across = plane === "x" ? "y" : "x";
    const along = plane === "z" ? "y" : "z";
    const index = { y: (j, i) => (j * ny + at) * nx + i, z: (j, i) => (at * ny + j) * nx + i, x: (j, i) => (j * ny + i) * nx + at };
    const trace = {
      type: "heatmap",
      x: volume[across],
      y: volume[along],
      z: rows(values, volume[along].length, volume[across].length, index[plane]),
      zmin: field.low,
      zmax: field.high,
      zsmooth: "best",
      colorscale: field.colours,
      colorbar: { title: { text: `${field.title}  [${field.unit}]`, side: "right" }, thickness: 16 },
      hovertemplate: `${across} %{x} ${volume.unit}<br>${along} %{y} ${volume.unit}<br>%{z:.4g} ${field.unit}<extra></extra>`,
    };
    const layout = {
      margin: { l: 70, r: 20, t: 20, b: 55 },
      font,
      xaxis: { title: title(across, volume.unit), constrain: "domain", zeroline: false },
      yaxis: {
        title: title(along, volume.unit, along === "z" ? "depth " : ""),
        autorange: along === "z" ? "reversed" : true,
        scaleanchor: "x",
        constrain: "domain",
        zeroline: false,
      },
    };
    const place = `${plane} = ${volume[plane][at]} ${volume.unit}`.replace("-", "\u2212");
    element("slice-label").textContent = place;
    element("slice-place").setAttribute("aria-valuetext", place);
    Plotly.react("slice", [trace], layout, config);
  }

  if (volumes.length) {
    fill(element("slice-body"), bodies);
    element("slice-body").addEventListener("change", chooseBody);
    element("slice-field").addEventListener("change", chooseField);
    element("slice-plane").addEventListener("change", choosePlane);
    element("slice-place").addEventListener("input", drawSlice);
    chooseBody();
  }
})();
