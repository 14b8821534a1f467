// Faders.
const stopsText = (v) => v <= OFF ? tr("off")
  : v.toLocaleString(document.documentElement.lang, { minimumFractionDigits: 2, maximumFractionDigits: 2, signDisplay: "exceptZero" }).replace("−", "-");
const linear = (code) => { const v = code / 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; };
const coded = (v) => Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
const hex = (color) => "#" + color.map((v) => coded(Math.min(1, Math.max(0, v))).toString(16).padStart(2, "0")).join("");
const normalized = (color) => { const max = Math.max(...color); return max > 0 ? color.map((v) => v / max) : [1, 1, 1]; };
const spoken = (v) => v <= OFF ? tr("off") : tr("by {0} stops", stopsText(v));
let refreshes = [];

function toggle(text, name, item, key) {
  const button = element("button", { type: "button", textContent: text, title: name });
  button.setAttribute("aria-label", name);
  button.addEventListener("click", () => { item[key] = !item[key]; edited(item); });
  refreshes.push(() => button.setAttribute("aria-pressed", String(item[key])));
  return button;
}

let nextId = 0;
function strip(item, isGroup) {
  const id = `fader-${nextId++}`;
  const row = element("div", { className: isGroup ? "strip group" : "strip" });
  row.setAttribute("role", "group");
  row.setAttribute("aria-label", isGroup ? tr("Light group {0}", item.name) : tr("Light {0}", item.name));
  const label = element("label", { htmlFor: id, textContent: item.name });
  const fader = element("input", { type: "range", id, min: String(OFF), max: "4", step: "0.05" });
  // The fader itself speaks its value.
  const value = element("span", { className: "value" });
  value.setAttribute("aria-hidden", "true");
  fader.addEventListener("input", () => { item.stops = Number(fader.value); edited(item); });
  fader.addEventListener("dblclick", () => { item.stops = 0; edited(item); });
  refreshes.push(() => {
    fader.value = String(item.stops);
    fader.setAttribute("aria-valuetext", spoken(item.stops));
    value.textContent = stopsText(item.stops);
  });
  row.append(label, fader, value, toggle("S", tr("Solo {0}", item.name), item, "solo"), toggle("M", tr("Mute {0}", item.name), item, "mute"));
  if (item.color) {
    // The hue of the temperature stays, as in the editor.
    const base = normalized(item.color.map((v, c) => v * item.white[c]));
    const name = tr("Color of {0}", item.name);
    const chip = element("input", { type: "color", title: name });
    chip.setAttribute("aria-label", name);
    chip.addEventListener("input", () => {
      const chosen = [1, 3, 5].map((at) => linear(parseInt(chip.value.slice(at, at + 2), 16)));
      item.tint = base.map((v, c) => v > 0 ? chosen[c] / v : 1);
      edited(item);
    });
    refreshes.push(() => { chip.value = hex(base.map((v, c) => v * item.tint[c])); });
    row.append(chip);
  } else {
    row.append(element("span", {}));
  }
  return row;
}

function showStrips() {
  refreshes = [];
  const list = byId("lights");
  list.replaceChildren(...lights.filter((l) => !l.group).map((light) => strip(light, false)));
  for (const group of state.groups.values()) {
    list.append(strip(group, true));
    lights.filter((l) => l.group === group.name).forEach((light) => list.append(strip(light, false)));
  }
}

// The picture in words: what differs from the picture as it was sent.
function pictureText() {
  const parts = [...lights, ...state.groups.values()].filter(isChanged).map((item) => item.mute ? tr("{0} is muted", item.name)
    : item.solo ? tr("{0} is solo", item.name) : `${item.name} ${spoken(item.stops)}`);
  const mine = parts.length > 0 ? parts.join(", ") : tr("no light is changed");
  const side = (name) => name === MINE ? `${sideText(MINE)}: ${mine}` : sideText(name);
  const shown = state.b === NONE ? side(state.a) : tr("Left {0}, right {1}", side(state.a), side(state.b));
  const what = picture.frame === undefined ? data.title : tr("{0}, frame {1}", data.title, picture.frame);
  return tr("Picture of {0}. {1}. Click to pin a note.", what, shown);
}

const isChanged = (l) => l.stops !== l.start.stops || l.mute !== l.start.mute || l.solo !== l.start.solo
  || l.tint && l.tint.some((t, c) => t !== l.start.tint[c]);

byId("exposure").addEventListener("input", () => { state.exposure = Number(byId("exposure").value); edited(state); });
byId("reset").addEventListener("click", () => {
  for (const item of [...lights, ...state.groups.values()]) {
    Object.assign(item, item.start);
    edited(item);
  }
  state.exposure = 0;
  edited(state);
  announce(tr("All faders are reset."));
});

function changed() {
  refreshes.forEach((refresh) => refresh());
  byId("exposure").value = String(state.exposure);
  byId("exposure").setAttribute("aria-valuetext", spoken(state.exposure));
  byId("exposure-value").textContent = stopsText(state.exposure);
  showSides();
  draw();
  drawThumbnails();
}

// What a page's reader changed: an item of a light or a group, or the state for the exposure.
const unsent = new Set();
function edited(item) {
  unsent.add(item);
  if (state.a !== MINE && state.b !== MINE) {
    state.a = MINE;
  }
  changed();
  send();
}
