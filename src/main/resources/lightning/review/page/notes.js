// Notes. Those of a shot belong to a frame.
const noteName = (note, i) => note.frame === undefined ? tr("Note {0}", i + 1) : tr("Note {0}, frame {1}", i + 1, note.frame);

function showNotes(focus) {
  byId("pins").replaceChildren(...state.notes.flatMap((note, i) => {
    if (note.frame !== picture.frame) {
      return [];
    }
    const pin = element("button", { type: "button", className: "pin", id: `pin-${i}`, textContent: String(i + 1), title: note.text });
    pin.style.left = `${100 * note.x}%`;
    pin.style.top = `${100 * note.y}%`;
    pin.setAttribute("aria-label", noteName(note, i));
    pin.addEventListener("click", () => byId("notes").children[i].querySelector("textarea").focus());
    return [pin];
  }));
  byId("notes").replaceChildren(...state.notes.map((note, i) => {
    const text = element("textarea", { value: note.text, maxLength: 2000 });
    text.setAttribute("aria-label", tr("Text of note {0}", i + 1));
    text.addEventListener("input", () => {
      note.text = text.value;
      if (byId(`pin-${i}`)) {
        byId(`pin-${i}`).title = text.value;
      }
    });
    text.addEventListener("change", () => send());
    const remove = element("button", { type: "button", textContent: tr("Delete Note") });
    remove.setAttribute("aria-label", tr("Delete note {0}", i + 1));
    remove.addEventListener("click", () => {
      state.notes.splice(i, 1);
      showNotes();
      announce(tr("Note {0} is deleted.", i + 1));
      (byId("notes").children[Math.min(i, state.notes.length - 1)]?.querySelector("textarea") || byId("add-note")).focus();
      send();
    });
    const row = element("li", {}, text, remove);
    if (note.frame !== undefined && hasFilm()) {
      const go = element("button", { type: "button", textContent: tr("Frame {0}", note.frame) });
      go.setAttribute("aria-label", tr("Show frame {0} of note {1}", note.frame, i + 1));
      go.addEventListener("click", () => selectFrame(note.frame));
      row.append(" ", go);
    }
    return row;
  }));
  document.querySelectorAll("#frames label").forEach((label) => {
    const isNoted = state.notes.some((note) => String(note.frame) === label.querySelector("input").value);
    label.classList.toggle("noted", isNoted);
  });
  byId("notes").hidden = state.notes.length === 0;
  if (focus) {
    byId("notes").lastElementChild.querySelector("textarea").focus();
  }
}

function addNote(x, y) {
  state.notes.push({ ...(picture.frame === undefined ? {} : { frame: picture.frame }), x, y, text: "" });
  showNotes(true);
}
canvas.addEventListener("click", (e) => addNote(e.offsetX / canvas.clientWidth, e.offsetY / canvas.clientHeight));
byId("add-note").addEventListener("click", () => addNote(0.5, 0.5));
