package lightning.editor.window.timeline;

import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import lightning.editor.EditorState;
import lightning.editor.window.model.KeySelection;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.shot.Shot;

/** Shared state of the timeline's parts: the shot and the scale of its frames. */
final class TimelineModel {
    private final SceneEditor editor;
    private final KeySelection keyChoice;
    private final ObjectProperty<Shot> shot = new SimpleObjectProperty<>();
    private final ReadOnlyObjectWrapper<FrameScale> scale = new ReadOnlyObjectWrapper<>(FrameScale.of(Shot.DEFAULT, 1));
    private double width = 1;
    /** True if the view is fit to all frames. */
    private boolean showsAll = true;
    private boolean isDragging;

    TimelineModel(SceneEditor editor, KeySelection keyChoice) {
        this.editor = editor;
        this.keyChoice = keyChoice;
    }

    SceneEditor editor() {
        return editor;
    }

    /** Returns the selected keyframes. */
    KeySelection keyChoice() {
        return keyChoice;
    }

    /** Returns the shot; null if the scene has none. */
    ReadOnlyObjectProperty<Shot> shotProperty() {
        return shot;
    }

    ReadOnlyObjectProperty<FrameScale> scaleProperty() {
        return scale.getReadOnlyProperty();
    }

    void show(EditorState state) {
        Shot oldShot = shot.get();
        Shot newShot = state.shotFrame().map(m -> m.shot()).orElse(null);
        if (newShot == null || oldShot == null) {
            showsAll = true;
        }
        if (newShot != oldShot) {
            shot.set(newShot);
            updateScale();
        }
    }

    /**
     * Sets the width of the lanes.
     *
     * @param v width without the names, pixels
     */
    void setWidth(double v) {
        width = v;
        updateScale();
    }

    /** Freezes the scale while keyframes are dragged. Afterwards, the scale includes frames beyond its earlier range. */
    void setDragging(boolean v) {
        isDragging = v;
        updateScale();
    }

    private void updateScale() {
        if (shot.get() != null && !isDragging) {
            FrameScale full = fullScale();
            scale.set(showsAll ? full : scale.get().clampTo(full));
        }
    }

    private FrameScale fullScale() {
        return FrameScale.of(shot.get(), width);
    }

    void zoom(double factor, double x) {
        if (shot.get() != null) {
            FrameScale full = fullScale();
            scale.set(scale.get().zoom(factor, x, full));
            showsAll = scale.get().equals(full);
        }
    }

    void pan(double pixels) {
        if (shot.get() != null) {
            scale.set(scale.get().pan(pixels, fullScale()));
        }
    }
}
