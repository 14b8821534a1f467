// What the page shows. A picture has the layers of its lights, of the rest, and of looks that faders cannot show.
const isLive = embedded.live === true;
const OFF = -8;
// The values at which a page begins: faders in their middle.
const ZERO = { stops: 0, tint: [1, 1, 1], mute: false, solo: false };
const MINE = "mine";
const SENT = "sent";
const NONE = "";
let data;
let lights = [];
// The picture on the screen; of a shot, one of several.
let picture;
// Sides of the comparison: a is left of the wipe, b right of it. If b is none, a is everywhere.
const state = { exposure: 0, groups: new Map(), notes: [], a: MINE, b: NONE, wipe: 0.5 };
const find = (list, name) => list.find((item) => item.name === name);
const lookOf = (side, shown) => side.startsWith("look-") ? shown.looks[Number(side.slice(5))] : null;
const isFixed = (side, shown) => lookOf(side, shown)?.layer !== undefined;

// Values of a light or a group: of the faders, of the start, or of a look.
function valuesOf(item, side, shown) {
  const look = lookOf(side, shown);
  return look ? find(item.tint ? look.lights : look.groups, item.name) || ZERO : side === SENT ? item.start : item;
}

// Weights of all layers of a picture, four numbers for each.
function weights(shown, side) {
  const values = new Float32Array(4 * shown.layers.length);
  if (isFixed(side, shown)) {
    const at = lookOf(side, shown).layer;
    return values.fill(1, 4 * at, 4 * at + 4);
  }
  const now = (item) => valuesOf(item, side, shown);
  const solo = lights.some((l) => now(l).solo) || [...state.groups.values()].some((g) => now(g).solo);
  shown.lights.forEach((name, i) => {
    const light = find(lights, name);
    const group = state.groups.get(light.group);
    const own = now(light);
    const all = group ? now(group) : ZERO;
    const shines = !own.mute && !all.mute && (!solo || own.solo || all.solo);
    const off = own.stops <= OFF || all.stops <= OFF;
    const factor = shines && !off ? 2 ** (own.stops + all.stops) : 0;
    // Layers of a live page are those of other intensities and colors.
    values.set(own.tint.map((t, c) => t * factor * light.scale[c]), 4 * i);
  });
  return values.fill(1, 4 * shown.lights.length, 4 * shown.lights.length + 4);
}
