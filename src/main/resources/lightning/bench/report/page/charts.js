// Three kinds of charts: error against time, lines, and bars.
// A chart is as wide as a narrow page, so that its text stays large.
const chartWidth = Math.min(560, Math.max(440, document.querySelector("main").clientWidth));
const isPlausible = (v) => v > 1e-15 && v < 1e15;
const isPlausibleOrZero = (v) => v === 0 || isPlausible(v);
const isShare = (v) => Math.abs(v) < 1e15;
// Returns the least and the greatest of values, or what to take if there are none.
const range = (values, low, high) => values.length > 0 ? [Math.min(...values), Math.max(...values)] : [low, high];

const INKS = ["ours", "red", "green", "purple", "orange", "sky", "text", "muted"];
const SETTING_INKS = ["orange", "red", "muted", "muted", "purple", "sky", "green", "ours", "text"];
// Shapes in the order of the accuracy settings, for prints without color.
const SHAPES = ["M-4-4H4V4H-4Z", "M0-5 5 4H-5Z", "M-6 0 0-3 6 0 0 3Z", "M-6-3 0 0 6-3V3L0 0-6 3Z", "M0-5.5 5.5 0 0 5.5-5.5 0Z",
  "M-4 0a4 4 0 0 0 8 0a4 4 0 0 0-8 0Z", "M0 5 5-4H-5Z", "M-5 0a5 5 0 0 0 10 0a5 5 0 0 0-10 0Z", "M-2-6H2V6H-2Z"];

// Returns the points that no other point beats in both time and error, fastest first.
function paretoFront(all) {
  const front = [];
  for (const p of [...all].sort((a, b) => a.median - b.median || a.error - b.error)) {
    if (front.length === 0 || p.error < front.at(-1).error) {
      front.push(p);
    }
  }
  return front;
}

// Chart of error against time in ms: points { label, ink, shape, isFilled, time, error }, quartiles of time as whiskers, and the Pareto
// front. Images without any error have a line of their own.
function paretoChart(name, measured, width, height, errorText) {
  const shown = measured.map(({ time, ...p }) => ({ ...p, lower: time.lowerQuartile, median: time.median, upper: time.upperQuartile }))
    .filter((p) => isPlausible(p.lower) && p.lower <= p.median && p.median <= p.upper && isPlausible(p.upper) && isPlausibleOrZero(p.error));
  if (shown.length === 0) {
    return emptyChart(name, width, height);
  }
  const [least, most] = range(shown.map((p) => p.error).filter((v) => v > 0), 1e-7, 1e-7);
  const hasZero = shown.some((p) => p.error === 0);
  const zero = hasZero ? 10 ** (Math.floor(Math.log10(least)) - 1) : least / 1.2;
  const top = hasZero ? 3 * Math.max(most, 10 * zero) : 1.6 * most;
  const frame = plot(name, width, height,
    { low: Math.min(...shown.map((p) => p.lower)) / 1.6, high: Math.max(...shown.map((p) => p.upper)) * 2.2, text: tick },
    { low: hasZero ? zero / 2.4 : zero / 1.4, high: top, text: (at) => hasZero && at < 1.5 * zero ? "0" : errorText(at) });
  const { chart, x, y } = frame;
  const yOf = (p) => y(p.error || zero);
  const front = paretoFront(shown).map((p, i) => i === 0 ? `M${points([x(p.median), yOf(p)])}` : `H${points([x(p.median)])}V${points([yOf(p)])}`);
  chart.append(path(front.join(""), "muted", 1.25, { "stroke-dasharray": "4 3" }));
  shown.forEach((p) => chart.append(
    path([p.lower, p.upper].map((at) => `M${points([x(at), yOf(p) - 2])}v4`).join("") + `M${points([x(p.lower), yOf(p)])}H${points([x(p.upper)])}`,
      p.ink, 0.75),
    svg("path", { d: p.shape, transform: `translate(${points([x(p.median), yOf(p)])})`, ...(p.isFilled ? { fill: color(p.ink) }
      : { fill: "none", stroke: color(p.ink), "stroke-width": 1.25 }) })));
  addLabels(frame, shown.map((p) => ({ x: x(p.median), y: yOf(p), ink: "text", text: p.label })), false);
  return chart;
}

function emptyChart(name, width, height) {
  const chart = drawing(name, width, height);
  chart.append(write(width / 2, height / 2, "middle", "muted", "no measurements"));
  return chart;
}

// Chart of lines { name, ink, isDashed, points: [x, y] … }, each labeled at its end; one without a name is thin. Values of 0 have a line of
// their own.
function curveChart(name, all, height, xText, yText) {
  const curves = all.map((curve) => ({ ...curve, points: curve.points.filter((p) => p.every(isPlausibleOrZero)) }))
    .filter((curve) => curve.points.length > 0);
  if (curves.length === 0) {
    return emptyChart(name, chartWidth, height);
  }
  const values = (i) => curves.flatMap((curve) => curve.points.map((p) => p[i]));
  const [left, last] = range(values(0).filter((v) => v > 0), 1, 10);
  const right = Math.max(last, 1.5 * left);
  const [low, most] = range(values(1).filter((v) => v > 0), 1e-7, 1);
  const hasZeroX = values(0).includes(0);
  const hasZeroY = values(1).includes(0);
  const zero = hasZeroY ? 10 ** (Math.floor(Math.log10(low)) - 1) : low / 1.6;
  const start = hasZeroX ? left / 2 : left;
  const frame = plot(name, chartWidth, height,
    { low: start / 1.15, high: 1.01 * right, text: (at) => hasZeroX && at < 0.9 * left ? "0" : xText(at) },
    { low: hasZeroY ? zero / 1.6 : zero, high: 2 * Math.max(2 * low, most), text: (at) => hasZeroY && at < 1.5 * zero ? "0" : yText(at) },
    Math.max(...curves.map((curve) => widthOf(curve.name))) + 8);
  const { chart, x, y } = frame;
  const at = ([px, py]) => [x(px || start), y(py || zero)];
  for (const curve of curves) {
    chart.append(path(`M${curve.points.map((p) => points(at(p))).join("L")}`, curve.ink, !curve.name ? 0.75 : curve.isDashed ? 1.25 : 1.75,
      curve.isDashed ? { "stroke-dasharray": "4 3" } : { "stroke-linecap": "round", "stroke-linejoin": "round" }));
    if (curve.name && !curve.isDashed) {
      curve.points.forEach((p) => chart.append(svg("circle", { cx: at(p)[0], cy: at(p)[1], r: 2.25, fill: color(curve.ink) })));
    }
  }
  addLabels(frame, curves.filter((curve) => curve.name).map((curve) => {
    const [px, py] = at(curve.points.at(-1));
    return { x: px, y: py, ink: curve.ink, text: curve.name };
  }), true);
  return chart;
}

// Chart of bars in percent: rows { name, paper, ours, stale, limit }, in which missing values are NaN.
function shareChart(name, rows) {
  const kinds = [["paper", "paper"], ["ours", "ours"], ["stale", "sky"]];
  const most = Math.max(100, ...rows.flatMap((row) => kinds.map(([kind]) => row[kind])).filter(isShare));
  const decade = 10 ** Math.floor(Math.log10(most / 6));
  const step = decade * ([1, 2, 5].find((digit) => most / 6 <= digit * decade) || 10);
  const left = Math.max(0, ...rows.map((row) => widthOf(row.name))) + 8;
  const bottom = 26 + 44 * rows.length;
  const scale = (chartWidth - 8 - left) / (1.2 * most);
  const x = (v) => left + scale * v;
  const chart = drawing(name, chartWidth, bottom);
  for (let v = 0; v <= 1.2 * most; v += step) {
    chart.append(path(`M${points([x(v), 24])}V${bottom}`, "grid", 0.75), write(x(v), 12, "middle", "muted", grouped(v)));
  }
  rows.forEach((row, i) => {
    const top = 28 + 44 * i;
    chart.append(write(left - 5, top + 19, "end", "text", row.name));
    kinds.forEach(([kind, ink], j) => {
      if (isShare(row[kind])) {
        chart.append(svg("rect", { x: left, y: top + LINE * j, width: Math.max(0, scale * row[kind]), height: 12, fill: color(ink) }),
          write(x(Math.max(0, row[kind])) + 3, top + LINE * j + 6, "start", "text", percent(row[kind])));
      }
    });
    if (isShare(row.limit)) {
      chart.append(path(`M${points([x(row.limit), top + LINE])}v12`, "text", 1.5));
    }
  });
  chart.append(path(`M${points([x(100), 24])}V${bottom}`, "muted", 0.75));
  return chart;
}
