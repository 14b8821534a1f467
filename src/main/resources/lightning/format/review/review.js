"use strict";
(async () => {
  const byId = (id) => document.getElementById(id);
  const say = (text) => { byId("message").textContent = text; };
  const embedded = JSON.parse(byId("data").textContent);
  const isLive = embedded.live === true;
  const OFF = -8;
  let data;
  let lights = [];

  // Numbers of 16 bits as HalfPlanes writes them.
  async function numbers(text, stride) {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    const count = bytes.length / 2;
    const result = new Uint16Array(count);
    for (let i = 0; i < count; i++) {
      const before = i < stride ? 0 : result[i - stride];
      result[i] = (bytes[i] + before) & 255 | ((bytes[count + i] + (before >> 8)) & 255) << 8;
    }
    return result;
  }

  const state = { exposure: 0, groups: new Map(), notes: [], asSent: false };
  // The values at which a page begins: faders in their middle.
  const ZERO = { stops: 0, tint: [1, 1, 1], mute: false, solo: false };
  const find = (list, name) => list.find((item) => item.name === name);

  // Values of an item: its present ones, or those of the start.
  const now = (item) => state.asSent ? item.start : item;

  function weight(light) {
    const group = state.groups.get(light.group);
    const own = now(light);
    const all = group ? now(group) : ZERO;
    const solo = lights.some((l) => now(l).solo) || [...state.groups.values()].some((g) => now(g).solo);
    const shines = !own.mute && !all.mute && (!solo || own.solo || all.solo);
    const off = own.stops <= OFF || all.stops <= OFF;
    const factor = shines && !off ? 2 ** (own.stops + all.stops) : 0;
    // Layers of a live page are those of other intensities and colors.
    return own.tint.map((t, c) => t * factor * light.scale[c]);
  }

  // The picture: a texture of one slice for each light and one for the rest, added and shown by the view transform.
  const canvas = byId("picture");
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
  if (!gl || typeof DecompressionStream === "undefined") {
    say("This page needs a newer browser, with WebGL 2: Chrome 80, Firefox 113, Safari 16.4 or later.");
    return;
  }
  const fragment = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2DArray;
precision highp usampler3D;
precision highp sampler2D;
uniform sampler2DArray layers;
uniform sampler2D weights;
uniform sampler2D thresholds;
uniform usampler3D lattice;
uniform int count;
uniform int height;
uniform float gain;
uniform float side;
uniform vec2 stops;
out vec4 color;
float code(float v) {
  int low = 0;
  int high = 256;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (v >= texelFetch(thresholds, ivec2(middle, 0), 0).r) { low = middle; } else { high = middle; }
  }
  return float(low) / 255.0;
}
vec3 mixed(vec3 v) {
  vec3 at = clamp((log2(max(v, exp2(stops.x))) - stops.x) / (stops.y - stops.x), 0.0, 1.0) * (side - 1.0);
  ivec3 first = ivec3(min(floor(at), side - 2.0));
  vec3 part = at - vec3(first);
  vec3 sum = vec3(0);
  for (int i = 0; i < 8; i++) {
    ivec3 corner = ivec3(i & 1, i >> 1 & 1, i >> 2);
    vec3 share = mix(1.0 - part, part, vec3(corner));
    sum += share.x * share.y * share.z * vec3(texelFetch(lattice, first + corner, 0).rgb);
  }
  return floor(sum / 65535.0 * 255.0 + 0.5) / 255.0;
}
void main() {
  ivec2 at = ivec2(int(gl_FragCoord.x), height - 1 - int(gl_FragCoord.y));
  vec3 sum = vec3(0);
  for (int i = 0; i < count; i++) {
    sum += texelFetch(weights, ivec2(i, 0), 0).rgb * texelFetch(layers, ivec3(at, i), 0).rgb;
  }
  vec3 v = max(sum, 0.0) * gain;
  color = vec4(side > 0.0 ? mixed(v) : vec3(code(v.r), code(v.g), code(v.b)), 1);
}`;
  const vertex = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }`;

  function shader(kind, source) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, source);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) {
      throw new Error(gl.getShaderInfoLog(made));
    }
    return made;
  }
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, vertex));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, fragment));
  gl.linkProgram(program);
  gl.useProgram(program);
  const uniform = (name) => gl.getUniformLocation(program, name);

  const textures = new Map();
  function texture(unit, target) {
    gl.deleteTexture(textures.get(unit) || null);
    textures.set(unit, gl.createTexture());
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, textures.get(unit));
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  texture(1, gl.TEXTURE_2D);
  gl.uniform1i(uniform("layers"), 0);
  gl.uniform1i(uniform("weights"), 1);
  gl.uniform1i(uniform("thresholds"), 2);
  gl.uniform1i(uniform("lattice"), 3);
  const gain = uniform("gain");

  // Makes the textures of a picture, and of its view transform. Layers are arrays of halves.
  function show(fresh, layers, lattice) {
    canvas.width = fresh.width;
    canvas.height = fresh.height;
    texture(0, gl.TEXTURE_2D_ARRAY);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGB16F, fresh.width, fresh.height, layers.length);
    layers.forEach((halves, i) => gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, i, fresh.width, fresh.height, 1, gl.RGB, gl.HALF_FLOAT, halves));
    texture(2, gl.TEXTURE_2D);
    texture(3, gl.TEXTURE_3D);
    if (lattice) {
      const side = fresh.view.side;
      gl.texImage3D(gl.TEXTURE_3D, 0, gl.RGB16UI, side, side, side, 0, gl.RGB_INTEGER, gl.UNSIGNED_SHORT, lattice);
    } else {
      const bytes = Uint8Array.from(atob(fresh.view.thresholds), (c) => c.charCodeAt(0));
      gl.activeTexture(gl.TEXTURE2);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, 256, 1, 0, gl.RED, gl.FLOAT, new Float32Array(bytes.buffer));
    }
    gl.uniform1i(uniform("count"), layers.length);
    gl.uniform1i(uniform("height"), fresh.height);
    gl.uniform1f(uniform("side"), lattice ? fresh.view.side : 0);
    gl.uniform2f(uniform("stops"), fresh.view.minStop || 0, fresh.view.maxStop || 1);
    say(gl.getError() ? "The picture does not fit into the memory of this device's graphics." : "");
  }

  function draw() {
    const slices = lights.length + 1;
    const values = new Float32Array(4 * slices).fill(1);
    lights.forEach((light, i) => values.set(weight(light), 4 * i));
    gl.activeTexture(gl.TEXTURE1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, slices, 1, 0, gl.RGBA, gl.FLOAT, values);
    gl.uniform1f(gain, 2 ** (data.view.exposure + (state.asSent ? 0 : state.exposure)));
    gl.viewport(0, 0, data.width, data.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // Faders.
  const stopsText = (v) => v <= OFF ? "off" : (v > 0 ? "+" : "") + v.toFixed(2);
  const linear = (code) => { const v = code / 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; };
  const coded = (v) => Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  const hex = (color) => "#" + color.map((v) => coded(Math.min(1, Math.max(0, v))).toString(16).padStart(2, "0")).join("");
  const normalized = (color) => { const max = Math.max(...color); return max > 0 ? color.map((v) => v / max) : [1, 1, 1]; };
  let refreshes = [];

  function element(kind, properties, ...children) {
    const made = Object.assign(document.createElement(kind), properties);
    made.append(...children);
    return made;
  }

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
    const label = element("label", { htmlFor: id, textContent: item.name });
    const fader = element("input", { type: "range", id, min: String(OFF), max: "4", step: "0.05" });
    const value = element("output", { htmlFor: id });
    fader.addEventListener("input", () => { item.stops = Number(fader.value); edited(item); });
    fader.addEventListener("dblclick", () => { item.stops = 0; edited(item); });
    refreshes.push(() => {
      fader.value = String(item.stops);
      fader.setAttribute("aria-valuetext", stopsText(item.stops) + " stops");
      value.textContent = stopsText(item.stops);
    });
    row.append(label, fader, value, toggle("S", `Solo ${item.name}`, item, "solo"), toggle("M", `Mute ${item.name}`, item, "mute"));
    if (item.color) {
      const base = normalized(item.color);
      const chip = element("input", { type: "color", title: `Color of ${item.name}` });
      chip.setAttribute("aria-label", `Color of ${item.name}`);
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

  // Notes.
  function showNotes(focus) {
    byId("pins").replaceChildren(...state.notes.map((note, i) => {
      const pin = element("button", { type: "button", className: "pin", textContent: String(i + 1), title: note.text });
      pin.style.left = `${100 * note.x}%`;
      pin.style.top = `${100 * note.y}%`;
      pin.setAttribute("aria-label", `Note ${i + 1}`);
      pin.addEventListener("click", () => byId("notes").children[i].querySelector("textarea").focus());
      return pin;
    }));
    byId("notes").replaceChildren(...state.notes.map((note, i) => {
      const text = element("textarea", { value: note.text, maxLength: 2000 });
      text.setAttribute("aria-label", `Note ${i + 1}`);
      text.addEventListener("input", () => { note.text = text.value; byId("pins").children[i].title = text.value; });
      text.addEventListener("change", () => send());
      const remove = element("button", { type: "button", textContent: "Delete" });
      remove.setAttribute("aria-label", `Delete note ${i + 1}`);
      remove.addEventListener("click", () => { state.notes.splice(i, 1); showNotes(); send(); });
      return element("li", {}, text, remove);
    }));
    if (focus) {
      byId("notes").lastElementChild.querySelector("textarea").focus();
    }
  }
  function addNote(x, y) {
    state.notes.push({ x, y, text: "" });
    showNotes(true);
  }
  canvas.addEventListener("click", (e) => addNote(e.offsetX / canvas.clientWidth, e.offsetY / canvas.clientHeight));
  byId("add-note").addEventListener("click", () => addNote(0.5, 0.5));

  // Saving: absolute values, so that the picture does not depend on later edits of the scene.
  function review() {
    const isChanged = (l) => l.stops !== l.start.stops || l.mute !== l.start.mute || l.solo !== l.start.solo
      || l.tint && l.tint.some((t, c) => t !== l.start.tint[c]);
    const described = (item) => ({ name: item.name, stops: item.stops <= OFF ? null : item.stops, mute: item.mute, solo: item.solo });
    return {
      lightning_review: embedded.version, scene: data.title, reviewer: byId("reviewer").value, exposure: state.exposure,
      lights: lights.filter(isChanged).map((l) => ({ ...described(l), tint: l.tint, intensity: l.intensity, color: l.color })),
      groups: [...state.groups.values()].filter(isChanged).map(described),
      notes: state.notes.filter((n) => n.text.trim() !== ""),
    };
  }
  byId("save").addEventListener("click", () => {
    const file = new Blob([JSON.stringify(review(), null, 1)], { type: "application/json" });
    const link = element("a", { href: URL.createObjectURL(file), download: "review.json" });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    say("Saved review.json. Send it to the artist.");
  });

  byId("compare").addEventListener("click", () => { state.asSent = !state.asSent; changed(); });
  byId("reset").addEventListener("click", () => {
    for (const item of [...lights, ...state.groups.values()]) {
      Object.assign(item, item.start);
      edited(item);
    }
    state.exposure = 0;
    edited(state);
  });
  byId("exposure").addEventListener("input", () => { state.exposure = Number(byId("exposure").value); edited(state); });

  function changed() {
    refreshes.forEach((refresh) => refresh());
    byId("exposure").value = String(state.exposure);
    byId("exposure-value").textContent = stopsText(state.exposure);
    byId("compare").setAttribute("aria-pressed", String(state.asSent));
    draw();
  }
  // What a page's reader changed: an item of a light or a group, or the state for the exposure.
  const unsent = new Set();
  function edited(item) {
    unsent.add(item);
    changed();
    send();
  }

  async function fromFile() {
    data = embedded;
    lights = data.lights.map((light) => ({ ...light, ...ZERO, start: ZERO, scale: [1, 1, 1] }));
    for (const light of lights.filter((l) => l.group)) {
      state.groups.set(light.group, { name: light.group, ...ZERO, tint: undefined, start: ZERO });
    }
    const layers = [];
    for (const text of [...lights.map((light) => light.pixels), data.rest]) {
      say(`Reading light ${layers.length + 1} of ${lights.length + 1} …`);
      layers.push(await numbers(text, 3));
    }
    show(data, layers, data.view.side === undefined ? null : await numbers(data.view.lattice, 3));
    begin();
  }

  function begin() {
    showStrips();
    byId("title").textContent = data.title;
    document.title = `${data.title} – review`;
    changed();
    document.body.dataset.ready = "yes";
  }

  // Live pages: the server sends values of the scene at once, and names layers when they are ready.
  const ownName = Math.random().toString(36).slice(2);
  const loaded = new Map();
  let isSending = false;
  let mustSend = false;

  // Values of a scene as this page's faders show them: stops from the start, and a color in place of a tint.
  function faders(value, start) {
    const from = start && start.intensity > 0 ? start.intensity : 1;
    const stops = value.intensity > 0 ? Math.log2(value.intensity / from) : OFF;
    return { stops: Math.max(OFF, stops), mute: value.mute, solo: value.solo, ...(value.color ? { tint: value.color } : {}) };
  }

  function item(old, value, start, more) {
    const kept = { start: faders(start || value, start || value), from: (start || value).intensity || 1, ...more };
    return old ? Object.assign(old, kept) : { name: value.name, ...faders(value, start || value), ...kept };
  }

  // Takes values of the scene. If changes stay in this page, only new values of the scene replace them.
  const seen = new Map();
  function isNew(key, value) {
    const text = JSON.stringify(value);
    const known = seen.get(key) === text;
    seen.set(key, text);
    return data.edits || !known;
  }

  function adopt(values) {
    const items = [...values.lights.map((value) => [find(lights, value.name), value, "light " + value.name]),
      ...values.groups.map((value) => [state.groups.get(value.name), value, "group " + value.name])];
    for (const [target, value, key] of items) {
      if (isNew(key, value) && target && !unsent.has(target)) {
        Object.assign(target, faders(value, { intensity: target.from }));
      }
    }
    if (isNew("exposure", values.exposure) && !unsent.has(state)) {
      state.exposure = values.exposure - data.start.exposure;
    }
  }

  async function layer(id) {
    if (!loaded.has(id)) {
      const answer = await fetch(`layer/${id}`);
      if (!answer.ok) {
        throw new Error("outdated");
      }
      loaded.set(id, await numbers(await answer.text(), 3));
    }
    return loaded.get(id);
  }

  const structure = () => JSON.stringify(lights.map((light) => [light.name, light.group]));
  let isLoading = false;
  let mustLoad = false;
  async function load() {
    mustLoad = true;
    if (isLoading) {
      return;
    }
    isLoading = true;
    while (mustLoad) {
      mustLoad = false;
      try {
        const answer = await fetch("data");
        if (!answer.ok) {
          continue;
        }
        const fresh = await answer.json();
        const ids = [...fresh.lights.map((light) => light.layer), fresh.rest];
        const layers = [];
        for (const id of ids) {
          if (!loaded.has(id)) {
            say(`Reading light ${layers.length + 1} of ${ids.length} …`);
          }
          layers.push(await layer(id));
        }
        const lattice = fresh.view.side === undefined ? null : await numbers(fresh.view.lattice, 3);
        [...loaded.keys()].filter((id) => !ids.includes(id)).forEach((id) => loaded.delete(id));
        const groups = new Map();
        for (const value of fresh.state.groups.filter((g) => fresh.lights.some((light) => light.group === g.name))) {
          groups.set(value.name, item(state.groups.get(value.name), value, find(fresh.start.groups, value.name), {}));
        }
        const names = structure();
        lights = fresh.lights.map((part) => {
          const value = find(fresh.state.lights, part.name);
          const start = find(fresh.start.lights, part.name);
          const from = (start || value).intensity || 1;
          const group = groups.get(part.group);
          const scale = part.color.map((c) => from * (group ? group.from : 1) / (part.intensity * c));
          return item(find(lights, part.name), value, start, { group: part.group, scale, ...(part.environment ? {} : { color: [1, 1, 1] }) });
        });
        state.groups = groups;
        fresh.view.exposure = fresh.start.exposure;
        data = fresh;
        adopt(fresh.state);
        show(fresh, layers, lattice);
        byId("mode").textContent = fresh.edits ? "Live: your changes move the scene" : "Live: your changes stay in this page";
        if (names === structure()) {
          changed();
        } else {
          begin();
        }
      } catch (e) {
        // A newer picture replaced a layer meanwhile: the next event loads it.
        if (e.message !== "outdated") {
          throw e;
        }
        mustLoad = true;
      }
    }
    isLoading = false;
  }

  // Sends what changed since the last time; one request at a time, so a drag never queues up.
  async function send() {
    if (!isLive || !data || !data.edits) {
      unsent.clear();
      return;
    }
    mustSend = true;
    if (isSending) {
      return;
    }
    isSending = true;
    while (mustSend) {
      mustSend = false;
      const items = [...unsent];
      unsent.clear();
      const value = (i) => ({ name: i.name, intensity: i.stops <= OFF ? 0 : i.from * 2 ** i.stops, mute: i.mute, solo: i.solo });
      const change = {
        page: ownName, reviewer: byId("reviewer").value,
        lights: items.filter((i) => lights.includes(i)).map((l) => ({ ...value(l), color: l.tint })),
        groups: items.filter((i) => [...state.groups.values()].includes(i)).map(value),
        notes: state.notes.filter((n) => n.text.trim() !== ""),
        ...(items.includes(state) ? { exposure: data.start.exposure + state.exposure } : {}),
      };
      try {
        const answer = await fetch("change", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(change) });
        say(answer.ok ? "" : await answer.text());
      } catch (e) {
        say("The change did not arrive: the connection is lost.");
      }
    }
    isSending = false;
  }

  function connect() {
    say("Waiting for the picture …");
    const events = new EventSource("events");
    events.addEventListener("picture", () => load());
    events.addEventListener("state", (e) => {
      const values = JSON.parse(e.data);
      if (data && values.page !== ownName) {
        adopt(values);
        changed();
      }
    });
    events.addEventListener("end", () => { events.close(); byId("mode").textContent = "The live review has ended."; });
    events.addEventListener("error", () => { byId("mode").textContent = "The connection is lost; trying again …"; });
    events.addEventListener("open", () => load());
  }

  if (isLive) {
    byId("mode").hidden = false;
    connect();
  } else {
    await fromFile();
  }
})();
