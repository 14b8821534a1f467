// Filmstrip of a shot. Only the layers of one frame are decoded; thumbnails have layers of their own, which follow the faders.
const film = byId("film");
const hasFilm = () => data.pictures !== undefined && data.pictures.length > 1;
let thumbnails = [];

async function decode(shown, isReported) {
  const layers = [];
  for (const id of shown.layers) {
    if (isReported) {
      report(tr("Reading layer {0} of {1} …", layers.length + 1, shown.layers.length));
    }
    layers.push(await numbers(byId(id).textContent, 3));
  }
  return layers;
}

async function showFilm() {
  film.hidden = !hasFilm();
  if (!hasFilm()) {
    return;
  }
  for (const one of data.pictures) {
    const small = { ...one.small, lights: one.lights, looks: one.looks };
    small.texture = upload(small, await decode(small, false));
    small.image = element("canvas", { width: small.width, height: small.height });
    small.image.setAttribute("aria-hidden", "true");
    thumbnails.push(small);
    const radio = element("input", { type: "radio", name: "frame", value: String(one.frame) });
    radio.addEventListener("change", () => selectFrame(one.frame));
    const name = element("span", { textContent: String(one.frame) });
    name.setAttribute("aria-hidden", "true");
    radio.setAttribute("aria-label", tr("Frame {0}", one.frame));
    byId("frames").append(element("label", {}, radio, small.image, name));
  }
}

// The newest choice wins: an older one stops after the layer that it decodes.
let wanted;
async function selectFrame(frame) {
  const chosen = data.pictures.find((one) => one.frame === frame);
  if (!chosen) {
    return;
  }
  wanted = frame;
  document.querySelector(`#frames input[value="${frame}"]`).checked = true;
  const layers = [];
  for (const id of chosen.layers) {
    layers.push(await numbers(byId(id).textContent, 3));
    if (wanted !== frame) {
      return;
    }
  }
  showPicture(chosen, layers);
  fillSides();
  changed();
  showNotes();
  announce(tr("Frame {0}", frame));
}

// Thumbnails wait until a fader rests.
let timer = 0;
function drawThumbnails() {
  clearTimeout(timer);
  if (thumbnails.length > 0) {
    timer = setTimeout(() => {
      for (const small of thumbnails) {
        paint(small, state.a, state.a, small.width);
        small.image.getContext("2d").drawImage(canvas, 0, canvas.height - small.height, small.width, small.height, 0, 0, small.width, small.height);
      }
      draw();
    }, 80);
  }
}
