package lightning.editor.window.timeline;

import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import lightning.editor.document.Situation;
import lightning.editor.window.model.KeyChoice;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.shot.Shot;

/** What the parts of the timeline share: the shot, and where its frames stand. */
final class Timeline {
    private final SceneEditor editor;
    private final KeyChoice keyChoice;
    private final ObjectProperty<Shot> shot = new SimpleObjectProperty<>();
    private final ReadOnlyObjectWrapper<FrameScale> scale = new ReadOnlyObjectWrapper<>(FrameScale.of(Shot.DEFAULT, 1));
    private double width = 1;
    /** Whether all frames are seen, however many they are. */
    private boolean all = true;
    private boolean held;

    Timeline(SceneEditor editor, KeyChoice keyChoice) {
        this.editor = editor;
        this.keyChoice = keyChoice;
    }

    SceneEditor editor() {
        return editor;
    }

    /** Which keys are chosen. */
    KeyChoice keyChoice() {
        return keyChoice;
    }

    /** Null where the scene has none. */
    ReadOnlyObjectProperty<Shot> shotProperty() {
        return shot;
    }

    ReadOnlyObjectProperty<FrameScale> scaleProperty() {
        return scale.getReadOnlyProperty();
    }

    void show(Situation now) {
        Shot before = shot.get();
        Shot after = now.moment().map(m -> m.shot()).orElse(null);
        if (after == null || before == null) {
            all = true;
        }
        if (after != before) {
            shot.set(after);
            fit();
        }
    }

    /** @param v of the lines beside the names, pixels */
    void setWidth(double v) {
        width = v;
        fit();
    }

    /** While keys are dragged the frames stay where they are; afterwards those that came into the timeline are seen. */
    void hold(boolean v) {
        held = v;
        fit();
    }

    private void fit() {
        if (shot.get() != null && !held) {
            FrameScale whole = whole();
            scale.set(all ? whole : scale.get().within(whole));
        }
    }

    private FrameScale whole() {
        return FrameScale.of(shot.get(), width);
    }

    void zoom(double factor, double x) {
        if (shot.get() != null) {
            FrameScale whole = whole();
            scale.set(scale.get().zoomed(factor, x, whole));
            all = scale.get().equals(whole);
        }
    }

    void move(double pixels) {
        if (shot.get() != null) {
            scale.set(scale.get().moved(pixels, whole()));
        }
    }
}
