package lightning.editor.window.model;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.LongProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleLongProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.editor.document.PreviewCamera;

/** How the preview looks, which is no part of the scene. */
public final class PreviewLook {
    private static final String GLOWING = "glowing textures";

    private final BooleanProperty glowing = new SimpleBooleanProperty();
    private final BooleanProperty hidden = new SimpleBooleanProperty();
    private final ObjectProperty<GizmoSize> size = new SimpleObjectProperty<>(GizmoSize.NORMAL);
    private final ObjectProperty<PreviewCamera> camera = new SimpleObjectProperty<>();
    private final LongProperty frames = new SimpleLongProperty();

    public ObjectProperty<PreviewCamera> cameraProperty() {
        return camera;
    }

    /** Counts the frames that the preview has drawn. */
    public LongProperty framesProperty() {
        return frames;
    }

    /** Whether textures glow, as in 1998; else lights fall on them. */
    public BooleanProperty glowingProperty() {
        return glowing;
    }

    /** Whether the lights' wireframes and markers are hidden; what is hidden cannot be taken by the mouse. */
    public BooleanProperty gizmosHiddenProperty() {
        return hidden;
    }

    public ObjectProperty<GizmoSize> sizeProperty() {
        return size;
    }

    /** As it was left. Gizmos are shown in any case: without them nobody would find the lights. */
    public void restore(Preferences preferences) {
        glowing.set(preferences.is("preview", GLOWING));
        size.set(preferences.choice("gizmos", GizmoSize.NORMAL));
    }

    public void remember(Preferences preferences) {
        preferences.set("preview", glowing.get() ? GLOWING : "");
        preferences.set("gizmos", size.get().name());
    }
}
