// Texts in the language of the page: that of the option, or of the browser. They are data and become text nodes.
const byId = (id) => document.getElementById(id);
const embedded = JSON.parse(byId("data").textContent);
const language = (embedded.language || (navigator.languages && navigator.languages[0]) || navigator.language || "en").slice(0, 2).toLowerCase();
const words = new Map(Object.entries(embedded.texts[language] || {}));
// Returns a text whose {0}, {1} … are replaced by values.
function tr(english, ...values) {
  return (words.get(english) || english).replace(/\{(\d)\}/g, (all, i) => i < values.length ? String(values[i]) : all);
}
const say = (text) => { byId("message").textContent = text; };
// Shows how far the page is, without a word to screen readers for each step.
const report = (text) => { byId("progress").textContent = text; };
// Tells screen readers about a change that others see.
const announce = (text) => { byId("announcement").textContent = text; };

function translatePage() {
  document.documentElement.lang = words.size > 0 ? language : "en";
  document.querySelectorAll("[data-text]").forEach((e) => { e.textContent = tr(e.dataset.text); });
  document.querySelectorAll("[data-label]").forEach((e) => e.setAttribute("aria-label", tr(e.dataset.label)));
  document.querySelectorAll("[data-title]").forEach((e) => { e.title = tr(e.dataset.title); });
}
translatePage();

function element(kind, properties, ...children) {
  const made = Object.assign(document.createElement(kind), properties);
  made.append(...children);
  return made;
}
