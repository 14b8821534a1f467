// Comparison: the faders, the picture as it was sent, and looks of the scene; one of them, or two with a wipe between them.
const sideText = (side) => side === MINE ? tr("Your Light") : side === SENT ? tr("As Sent")
  : isFixed(side, picture) ? tr("{0} (fixed picture)", data.looks[Number(side.slice(5))]) : data.looks[Number(side.slice(5))];

function fillSides() {
  const sides = [MINE, SENT, ...(data.looks || []).map((_, i) => `look-${i}`)];
  const option = (side) => element("option", { value: side, textContent: sideText(side) });
  byId("side-a").replaceChildren(...sides.map(option));
  byId("side-b").replaceChildren(element("option", { value: NONE, textContent: tr("Nothing") }), ...sides.map(option));
}

function showSides() {
  byId("side-a").value = state.a;
  byId("side-b").value = state.b;
  byId("as-sent").setAttribute("aria-pressed", String(state.a === SENT && state.b === NONE));
  const compares = state.b !== NONE;
  ["swap", "wipe-row", "divider", "tag-a", "tag-b"].forEach((id) => { byId(id).hidden = !compares; });
  byId("tag-a").textContent = compares ? sideText(state.a) : "";
  byId("tag-b").textContent = compares ? sideText(state.b) : "";
  byId("divider").style.left = `${100 * state.wipe}%`;
  byId("wipe").value = String(Math.round(100 * state.wipe));
  byId("wipe").setAttribute("aria-valuetext", tr("{0} percent {1}", Math.round(100 * state.wipe), sideText(state.a)));
  const look = lookOf(state.a, picture);
  byId("use-look").hidden = !look || look.layer !== undefined;
  byId("fixed").hidden = ![state.a, state.b].some((side) => isFixed(side, picture));
}

function choose(a, b) {
  state.a = a;
  state.b = b;
  changed();
  announce(b === NONE ? tr("Shows {0}", sideText(a)) : tr("Left {0}, right {1}", sideText(a), sideText(b)));
}
byId("side-a").addEventListener("change", () => choose(byId("side-a").value, state.b));
byId("side-b").addEventListener("change", () => choose(state.a, byId("side-b").value));
byId("as-sent").addEventListener("click", () => choose(state.a === SENT && state.b === NONE ? MINE : SENT, NONE));
const swap = () => { if (state.b !== NONE) { choose(state.b, state.a); } };
byId("swap").addEventListener("click", swap);
document.addEventListener("keydown", (e) => {
  const isTyping = e.target.matches("select, textarea, input[type=text]");
  if (!isTyping && !e.ctrlKey && !e.metaKey && !e.altKey && e.key.toLowerCase() === "x") {
    swap();
  }
});

function wipe(share) {
  state.wipe = Math.min(1, Math.max(0, share));
  showSides();
  draw();
}
byId("wipe").addEventListener("input", () => wipe(Number(byId("wipe").value) / 100));
const divider = byId("divider");
divider.addEventListener("pointerdown", (e) => { divider.setPointerCapture(e.pointerId); e.preventDefault(); });
divider.addEventListener("pointermove", (e) => {
  if (divider.hasPointerCapture(e.pointerId)) {
    const box = canvas.getBoundingClientRect();
    wipe((e.clientX - box.left) / box.width);
  }
});

// Moves the faders to where they show the look.
byId("use-look").addEventListener("click", () => {
  const name = sideText(state.a);
  for (const item of [...lights, ...state.groups.values()]) {
    const { stops, mute, solo, tint } = valuesOf(item, state.a, picture);
    Object.assign(item, { stops, mute, solo }, item.tint ? { tint } : {});
    unsent.add(item);
  }
  state.exposure = 0;
  state.a = MINE;
  edited(state);
  byId("side-a").focus();
  announce(tr("The faders show {0}.", name));
});
