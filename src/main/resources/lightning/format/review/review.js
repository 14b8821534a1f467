"use strict";
(async () => {
  const byId = (id) => document.getElementById(id);
  const say = (text) => { byId("message").textContent = text; };
  const data = JSON.parse(byId("data").textContent);
  const OFF = -8;

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
  const lights = data.lights.map((light) => ({ ...light, stops: 0, tint: [1, 1, 1], mute: false, solo: false }));
  for (const light of lights) {
    if (light.group && !state.groups.has(light.group)) {
      state.groups.set(light.group, { name: light.group, stops: 0, mute: false, solo: false });
    }
  }

  function weight(light) {
    if (state.asSent) {
      return [1, 1, 1];
    }
    const group = state.groups.get(light.group);
    const solo = lights.some((l) => l.solo) || [...state.groups.values()].some((g) => g.solo);
    const shines = !light.mute && !(group && group.mute) && (!solo || light.solo || Boolean(group && group.solo));
    const stops = light.stops + (group ? group.stops : 0);
    const off = light.stops <= OFF || Boolean(group && group.stops <= OFF);
    const factor = shines && !off ? 2 ** stops : 0;
    return light.tint.map((t) => t * factor);
  }

  // The picture: a texture of one slice for each light and one for the rest, added and shown by the view transform.
  const canvas = byId("picture");
  canvas.width = data.width;
  canvas.height = data.height;
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
  if (!gl || typeof DecompressionStream === "undefined") {
    say("This page needs a newer browser, with WebGL 2: Chrome 80, Firefox 113, Safari 16.4 or later.");
    return;
  }
  const mixes = data.view.side !== undefined;
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

  function texture(unit, target) {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, gl.createTexture());
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  const slices = lights.length + 1;
  texture(0, gl.TEXTURE_2D_ARRAY);
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGB16F, data.width, data.height, slices);
  for (let i = 0; i < slices; i++) {
    say(`Reading light ${i + 1} of ${slices} …`);
    const halves = await numbers(i < lights.length ? lights[i].pixels : data.rest, 3);
    gl.activeTexture(gl.TEXTURE0);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, i, data.width, data.height, 1, gl.RGB, gl.HALF_FLOAT, halves);
  }
  texture(1, gl.TEXTURE_2D);
  texture(2, gl.TEXTURE_2D);
  texture(3, gl.TEXTURE_3D);
  if (mixes) {
    const side = data.view.side;
    gl.texImage3D(gl.TEXTURE_3D, 0, gl.RGB16UI, side, side, side, 0, gl.RGB_INTEGER, gl.UNSIGNED_SHORT, await numbers(data.view.lattice, 3));
  } else {
    const bytes = Uint8Array.from(atob(data.view.thresholds), (c) => c.charCodeAt(0));
    gl.activeTexture(gl.TEXTURE2);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, 256, 1, 0, gl.RED, gl.FLOAT, new Float32Array(bytes.buffer));
  }
  gl.uniform1i(uniform("layers"), 0);
  gl.uniform1i(uniform("weights"), 1);
  gl.uniform1i(uniform("thresholds"), 2);
  gl.uniform1i(uniform("lattice"), 3);
  gl.uniform1i(uniform("count"), slices);
  gl.uniform1i(uniform("height"), data.height);
  gl.uniform1f(uniform("side"), mixes ? data.view.side : 0);
  gl.uniform2f(uniform("stops"), data.view.minStop || 0, data.view.maxStop || 1);
  const gain = uniform("gain");
  say(gl.getError() ? "The picture does not fit into the memory of this device's graphics." : "");

  function draw() {
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
  const refreshes = [];

  function element(kind, properties, ...children) {
    const made = Object.assign(document.createElement(kind), properties);
    made.append(...children);
    return made;
  }

  function toggle(text, name, item, key) {
    const button = element("button", { type: "button", textContent: text, title: name });
    button.setAttribute("aria-label", name);
    button.addEventListener("click", () => { item[key] = !item[key]; changed(); });
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
    fader.addEventListener("input", () => { item.stops = Number(fader.value); changed(); });
    fader.addEventListener("dblclick", () => { item.stops = 0; changed(); });
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
        changed();
      });
      refreshes.push(() => { chip.value = hex(base.map((v, c) => v * item.tint[c])); });
      row.append(chip);
    } else {
      row.append(element("span", {}));
    }
    return row;
  }
  const list = byId("lights");
  for (const light of lights.filter((l) => !l.group)) {
    list.append(strip(light, false));
  }
  for (const group of state.groups.values()) {
    list.append(strip(group, true));
    lights.filter((l) => l.group === group.name).forEach((light) => list.append(strip(light, false)));
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
      const remove = element("button", { type: "button", textContent: "Delete" });
      remove.setAttribute("aria-label", `Delete note ${i + 1}`);
      remove.addEventListener("click", () => { state.notes.splice(i, 1); showNotes(); });
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
    const isChanged = (l) => l.stops !== 0 || l.mute || l.solo || l.tint && l.tint.some((t) => t !== 1);
    const described = (item) => ({ name: item.name, stops: item.stops <= OFF ? null : item.stops, mute: item.mute, solo: item.solo });
    return {
      lightning_review: data.version, scene: data.title, reviewer: byId("reviewer").value, exposure: state.exposure,
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
      Object.assign(item, { stops: 0, mute: false, solo: false }, item.tint ? { tint: [1, 1, 1] } : {});
    }
    state.exposure = 0;
    changed();
  });
  byId("exposure").addEventListener("input", () => { state.exposure = Number(byId("exposure").value); changed(); });

  function changed() {
    refreshes.forEach((refresh) => refresh());
    byId("exposure").value = String(state.exposure);
    byId("exposure-value").textContent = stopsText(state.exposure);
    byId("compare").setAttribute("aria-pressed", String(state.asSent));
    draw();
  }
  byId("title").textContent = data.title;
  document.title = `${data.title} – review`;
  changed();
  document.body.dataset.ready = "yes";
})();
