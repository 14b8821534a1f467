// Axes, texts and labels of charts, in units in which text is 11 high. Colors are variables of the style sheet.
const pen = document.createElement("canvas").getContext("2d");
pen.font = '11px Verdana, "DejaVu Sans", sans-serif';
const widthOf = (text) => pen.measureText(text).width;
const LINE = 13;

const color = (name) => `var(--${name})`;
// Every text has the width for which the chart was laid out, for any font of a reader of the chart as a file.
const write = (x, y, anchor, ink, text) =>
  svg("text", { x, y: y + 4, "text-anchor": anchor, fill: color(ink), ...(text ? { textLength: widthOf(text) } : {}) }, text);
const path = (d, ink, width, more) => svg("path", { d, fill: "none", stroke: color(ink), "stroke-width": width, ...more });
const points = (numbers) => numbers.map((v) => Math.round(100 * v) / 100).join(" ");

const drawing = (name, width, height) =>
  svg("svg", { class: "chart", viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": name });

// Ticks of a logarithmic axis at round numbers: whole decades, or 1, 2 and 5 of each if there are few decades.
function ticks(low, high) {
  const first = Math.floor(Math.log10(low));
  const last = Math.ceil(Math.log10(high));
  const step = Math.max(1, Math.ceil((last - first) / 7));
  const found = [];
  for (let exponent = first; exponent <= last; exponent += step) {
    for (const digit of last - first <= 3 ? [1, 2, 5] : [1]) {
      const at = Number(`${digit}e${exponent}`);
      if (at >= low * (1 - 1e-9) && at <= high * (1 + 1e-9)) {
        found.push(at);
      }
    }
  }
  return found;
}

// Grid and tick labels of two logarithmic axes, { low, high, text } each; `margin` is free on the right. Only whole decades are labeled
// if more would overlap.
function plot(name, width, height, horizontal, vertical, margin = 0) {
  const rows = ticks(vertical.low, vertical.high).map((at) => ({ at, text: vertical.text(at) }));
  const left = 8 + Math.max(0, ...rows.map((row) => widthOf(row.text)));
  const right = width - 8;
  const bottom = height - 20;
  const along = (axis, v) => Math.log(v / axis.low) / Math.log(axis.high / axis.low);
  const x = (v) => left + (right - margin - left) * along(horizontal, v);
  const y = (v) => bottom + (6 - bottom) * along(vertical, v);
  const chart = drawing(name, width, height);
  const columns = ticks(horizontal.low, horizontal.high).map((at) => ({ at, text: horizontal.text(at) }));
  const isCrowded = columns.some((c, i) => i > 0 && x(c.at) - x(columns[i - 1].at) < (widthOf(c.text) + widthOf(columns[i - 1].text)) / 2 + 6);
  columns.filter(({ at }) => !isCrowded || at.toExponential().startsWith("1e")).forEach(({ at, text }) => chart.append(
    path(`M${points([x(at), 6])}V${points([bottom])}`, "grid", 0.75), write(x(at), bottom + 12, "middle", "muted", text)));
  rows.forEach(({ at, text }) => chart.append(
    path(`M${points([left, y(at)])}H${points([right])}`, "grid", 0.75), write(left - 5, y(at), "end", "muted", text)));
  return { chart, x, y, area: { left, right, top: 6, bottom } };
}

// Labels of points, moved so that they cover neither each other nor a point, with a line to a distant one. They are right of points where
// lines end, otherwise above and below, clear of whiskers.
function addLabels({ chart, area }, labels, isRight) {
  const occupied = labels.map(({ x, y }) => ({ left: x - 4.5, right: x + 4.5, top: y - 4.5, bottom: y + 4.5 }));
  labels.forEach((label) => {
    const place = freePlace(label, widthOf(label.text), area, occupied, isRight);
    occupied.push(place);
    const middle = (place.top + place.bottom) / 2;
    if (Math.abs(label.y - middle) > 1.6 * LINE) {
      const end = place.left > label.x ? place.left - 2 : place.right + 2;
      chart.append(path(`M${points([label.x, label.y])}L${points([end, middle])}`, "muted", 0.75));
    }
    chart.append(write(place.left, middle, "start", label.ink, label.text));
  });
}

// Returns the nearest free place of a label, line by line; the first one if all are taken.
function freePlace({ x, y }, width, area, occupied, isRight) {
  const places = [];
  for (let n = isRight ? 0 : 1; n <= 16; n++) {
    const top = y + (n % 2 === 0 ? 1 : -1) * ((n + 1) >> 1) * LINE - LINE / 2;
    for (const left of isRight ? [x + 8] : [x - 4, x - width + 4]) {
      places.push({ left, right: left + width, top, bottom: top + LINE });
    }
  }
  return places.find((p) => p.left >= area.left && p.right <= area.right && p.top >= area.top && p.bottom <= area.bottom
    && !occupied.some((o) => p.left < o.right && o.left < p.right && p.top < o.bottom && o.top < p.bottom)) || places[0];
}
