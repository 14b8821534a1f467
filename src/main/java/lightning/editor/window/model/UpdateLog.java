package lightning.editor.window.model;

import java.time.LocalTime;
import java.time.ZoneId;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.collections.FXCollections;
import javafx.collections.ObservableList;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.UpdateResult;

/** Log of recent picture updates, latest first. Stores numbers only and retains no pictures. */
public final class UpdateLog {
    private static final int MAX_ENTRIES = 200;

    private final ObservableList<Entry> entries = FXCollections.observableArrayList();

    /**
     * Entry of one update.
     *
     * @param shownAt  time when the picture was shown
     * @param update  result of the update
     * @param isFinished  true if the picture had all its samples
     * @param accuracyText  guarantee of the picture, for example {@code exact}
     * @param saving  saving compared to a full trace; empty while it is not measured
     */
    public record Entry(LocalTime shownAt, UpdateResult update, boolean isFinished, String accuracyText, Optional<WarmSaving> saving) {
        /** Returns the entry as one line. */
        public String text() {
            return StatusText.of(update, isFinished, accuracyText, saving);
        }
    }

    UpdateLog(ObservableValue<RenderState> rendering) {
        rendering.subscribe(this::add);
    }

    /** Returns the entries, latest first. */
    public ObservableList<Entry> entries() {
        return FXCollections.unmodifiableObservableList(entries);
    }

    /**
     * Returns the shadow rays of each light in the update of the log that cast the most for it: a full trace, unless the log has none.
     *
     * @return rays by the light's name; none for a light that casts none
     */
    public Map<String, Long> shadowRays() {
        Map<String, Long> rays = new HashMap<>();
        entries.forEach(entry -> entry.update().rays().shadows().forEach((light, count) -> rays.merge(light, count, Math::max)));
        return rays;
    }

    /** Removes all entries: they are of a scene that is no longer open. */
    void clear() {
        entries.clear();
    }

    private void add(RenderState state) {
        Frame frame = state.frame();
        if (frame == null) {
            return;
        }
        var last = entries.isEmpty() ? null : entries.getFirst();
        if (last == null || last.update() != frame.update() || last.isFinished() != frame.isFinished()) {
            entries.addFirst(
                    new Entry(LocalTime.now(ZoneId.systemDefault()), frame.update(), frame.isFinished(),
                            frame.guarantee().text(frame.update()),
                            state.saving()));
            if (entries.size() > MAX_ENTRIES) {
                entries.removeLast();
            }
        } else if (!last.saving().equals(state.saving())) {
            entries.set(0, new Entry(last.shownAt(), last.update(), last.isFinished(), last.accuracyText(), state.saving()));
        }
    }
}
