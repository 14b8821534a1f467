// A page of a file has its layers as blocks of data.
async function fromFile() {
  data = embedded;
  lights = data.lights.map((light) => ({ ...light, ...ZERO, start: ZERO, scale: [1, 1, 1] }));
  for (const light of lights.filter((l) => l.group)) {
    state.groups.set(light.group, { name: light.group, ...ZERO, tint: undefined, start: ZERO });
  }
  const first = data.pictures[0];
  showView(data.view, await latticeOf(data.view));
  showPicture(first, await decode(first, true));
  if (!hasFilm()) {
    // The texture has them now.
    first.layers.forEach((id) => byId(id).remove());
  }
  await showFilm();
  if (hasFilm()) {
    document.querySelector("#frames input").checked = true;
  }
  begin();
}

function begin() {
  showStrips();
  fillSides();
  showNotes();
  byId("title").textContent = data.title;
  document.title = tr("{0} – review", data.title);
  changed();
  document.body.dataset.ready = "yes";
}
