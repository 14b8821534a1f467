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
          report(tr("Reading layer {0} of {1} …", layers.length + 1, ids.length));
        }
        layers.push(await layer(id));
      }
      const lattice = await latticeOf(fresh.view);
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
        return item(find(lights, part.name), value, start, { group: part.group, scale, ...(part.environment ? { environment: part.environment } : { color: [1, 1, 1], white: part.white }) });
      });
      state.groups = groups;
      fresh.view.exposure = fresh.start.exposure;
      data = fresh;
      adopt(fresh.state);
      fresh.looks = [];
      showView(fresh.view, lattice);
      showPicture({ width: fresh.width, height: fresh.height, lights: lights.map((light) => light.name), layers: ids, looks: [] }, layers);
      byId("mode").textContent = fresh.edits ? tr("Live: your changes move the scene") : tr("Live: your changes stay in this page");
      if (names === structure() && document.body.dataset.ready) {
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
      say(tr("The change did not arrive: the connection is lost."));
    }
  }
  isSending = false;
}

function connect() {
  say(tr("Waiting for the picture …"));
  const events = new EventSource("events");
  events.addEventListener("picture", () => load());
  events.addEventListener("state", (e) => {
    const values = JSON.parse(e.data);
    if (data && values.page !== ownName) {
      adopt(values);
      changed();
    }
  });
  events.addEventListener("end", () => { events.close(); byId("mode").textContent = tr("The live review has ended."); });
  events.addEventListener("error", () => { byId("mode").textContent = tr("The connection is lost; trying again …"); });
  events.addEventListener("open", () => load());
}
