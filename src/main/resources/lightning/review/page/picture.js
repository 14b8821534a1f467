// The picture: a texture with a slice for each layer. The graphics hardware adds them and applies the view transform.
const canvas = byId("picture");
const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
if (!gl || typeof DecompressionStream === "undefined") {
  say(tr("This page needs a newer browser, with WebGL 2: Chrome 80, Firefox 113, Safari 16.4 or later."));
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
uniform vec2 gain;
uniform float split;
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
  int shown = float(at.x) < split ? 0 : 1;
  vec3 sum = vec3(0);
  for (int i = 0; i < count; i++) {
    sum += texelFetch(weights, ivec2(i, shown), 0).rgb * texelFetch(layers, ivec3(at, i), 0).rgb;
  }
  vec3 v = max(sum, 0.0) * (shown == 0 ? gain.x : gain.y);
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

gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
["layers", "weights", "thresholds", "lattice"].forEach((name, unit) => gl.uniform1i(uniform(name), unit));

function texture(unit, target) {
  const made = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(target, made);
  gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return made;
}
texture(1, gl.TEXTURE_2D);

// Textures of the view transform; a live page gets new ones.
let viewTextures = [];
function showView(view, lattice) {
  viewTextures.forEach((old) => gl.deleteTexture(old));
  viewTextures = [texture(2, gl.TEXTURE_2D), texture(3, gl.TEXTURE_3D)];
  if (lattice) {
    const side = view.side;
    gl.texImage3D(gl.TEXTURE_3D, 0, gl.RGB16UI, side, side, side, 0, gl.RGB_INTEGER, gl.UNSIGNED_SHORT, lattice);
  } else {
    const bytes = Uint8Array.from(atob(view.thresholds), (c) => c.charCodeAt(0));
    gl.activeTexture(gl.TEXTURE2);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, 256, 1, 0, gl.RED, gl.FLOAT, new Float32Array(bytes.buffer));
  }
  gl.uniform1f(uniform("side"), lattice ? view.side : 0);
  gl.uniform2f(uniform("stops"), view.minStop || 0, view.maxStop || 1);
}
const latticeOf = async (view) => view.side === undefined ? null : numbers(view.lattice, 3);

// Makes the texture of a picture's layers, which are arrays of halves.
function upload(shown, layers) {
  const made = texture(0, gl.TEXTURE_2D_ARRAY);
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGB16F, shown.width, shown.height, layers.length);
  layers.forEach((halves, i) => gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, i, shown.width, shown.height, 1, gl.RGB, gl.HALF_FLOAT, halves));
  return made;
}

// Shows a picture in place of the last one, whose texture is dropped.
function showPicture(fresh, layers) {
  gl.deleteTexture(picture?.texture || null);
  picture = fresh;
  canvas.width = fresh.width;
  canvas.height = fresh.height;
  byId("view").style.setProperty("--aspect", String(fresh.width / fresh.height));
  fresh.texture = upload(fresh, layers);
  report("");
  say(gl.getError() ? tr("The picture does not fit into the memory of this device's graphics.") : "");
}

// Paints a picture at the lower left of the canvas.
function paint(shown, a, b, split) {
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, shown.texture);
  const values = new Float32Array(8 * shown.layers.length);
  values.set(weights(shown, a));
  values.set(weights(shown, b), 4 * shown.layers.length);
  gl.activeTexture(gl.TEXTURE1);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, shown.layers.length, 2, 0, gl.RGBA, gl.FLOAT, values);
  const exposure = (side) => 2 ** (data.view.exposure + (side === MINE ? state.exposure : 0));
  gl.uniform1i(uniform("count"), shown.layers.length);
  gl.uniform1i(uniform("height"), shown.height);
  gl.uniform2f(uniform("gain"), exposure(a), exposure(b));
  gl.uniform1f(uniform("split"), split);
  gl.viewport(0, 0, shown.width, shown.height);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}

function draw() {
  const b = state.b === NONE ? state.a : state.b;
  paint(picture, state.a, b, state.b === NONE ? picture.width : Math.round(state.wipe * picture.width));
  canvas.setAttribute("aria-label", pictureText());
}
