// Saving: absolute values, so that the picture does not depend on later edits of the scene.
function review() {
  const described = (item) => ({ name: item.name, stops: item.stops <= OFF ? null : item.stops, mute: item.mute, solo: item.solo });
  return {
    lightning_review: embedded.version, scene: data.title, reviewer: byId("reviewer").value, exposure: state.exposure,
    lights: lights.filter(isChanged).map((l) => ({ ...described(l), ...(l.environment ? { environment: l.environment } : {}), tint: l.tint, intensity: l.intensity, color: l.color })),
    groups: [...state.groups.values()].filter(isChanged).map(described),
    notes: state.notes.filter((n) => n.text.trim() !== ""),
  };
}
byId("save").addEventListener("click", () => {
  const file = new Blob([JSON.stringify(review(), null, 1)], { type: "application/json" });
  const link = element("a", { href: URL.createObjectURL(file), download: "review.json" });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  say(tr("Saved review.json. Send it to the artist."));
});
