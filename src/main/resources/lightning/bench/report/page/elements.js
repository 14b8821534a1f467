// The page's data, and elements with texts, never with markup.
const byId = (id) => document.getElementById(id);
// JSON has no word for some numbers.
const data = JSON.parse(byId("data").textContent, (_, v) => v?.double === undefined ? v : Number(v.double));
const results = data.results;
const settingOf = (name) => data.settings.find((setting) => setting.name === name);
const usual = settingOf(data.usual).label;

function element(kind, properties, ...children) {
  const made = Object.assign(document.createElement(kind), properties);
  made.append(...children);
  return made;
}

function svg(kind, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", kind);
  Object.entries(attributes).forEach(([name, v]) => made.setAttribute(name, typeof v === "number" ? Math.round(100 * v) / 100 : v));
  made.append(...children);
  return made;
}

// A table with a row for each item: columns have a title and a function of the text, the first that of the row's name. Losses are marked.
function table(style, caption, items, ...columns) {
  const cell = (text) => element("td", { className: text.startsWith("−") ? "loss" : "" }, text);
  return element("div", { className: "wide" }, element("table", { className: style },
    element("caption", {}, caption),
    element("thead", {}, element("tr", {}, ...columns.map(([title]) => element("th", { scope: "col" }, title)))),
    element("tbody", {}, ...items.map((item) => element("tr", {}, ...columns.map(([, text], i) =>
      i === 0 ? element("th", { scope: "row" }, text(item)) : cell(text(item) ?? "–")))))));
}

// A chart with title, description of its axes, and legend of colors and texts.
function figure(title, axes, chart, legend = []) {
  const entries = legend.map(([color, text]) => {
    const sample = element("i", {});
    sample.style.background = `var(--${color})`;
    return element("li", {}, sample, text);
  });
  return element("figure", {}, element("figcaption", {}, element("h3", {}, title), element("p", {}, axes),
    ...(entries.length > 0 ? [element("ul", { className: "legend" }, ...entries)] : [])), chart);
}
const figures = (...charts) => element("div", { className: "charts" }, ...charts);

// Shows a section that has something to show.
function fill(id, isNeeded, ...children) {
  if (isNeeded) {
    byId(id).hidden = false;
    byId(id).append(...children);
  }
}
