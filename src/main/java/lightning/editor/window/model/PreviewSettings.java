package lightning.editor.window.model;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.LongProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleLongProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.document.manipulation.PreviewCamera;

/** Display settings and camera of the preview, which are not part of the scene. */
public final class PreviewSettings {
    private static final String GLOWING_TEXTURES = "glowing textures";

    private final BooleanProperty glowingTextures = new SimpleBooleanProperty();
    private final BooleanProperty shadows = new SimpleBooleanProperty(true);
    private final BooleanProperty gizmosHidden = new SimpleBooleanProperty();
    private final BooleanProperty fogHandles = new SimpleBooleanProperty();
    private final ObjectProperty<GizmoSize> gizmoSize = new SimpleObjectProperty<>(GizmoSize.NORMAL);
    private final ObjectProperty<CameraNavigation> navigation = new SimpleObjectProperty<>(CameraNavigation.LIGHTNING);
    private final ObjectProperty<PreviewCamera> camera = new SimpleObjectProperty<>();
    private final LongProperty frames = new SimpleLongProperty();

    public ObjectProperty<PreviewCamera> cameraProperty() {
        return camera;
    }

    /** Number of frames that the preview has drawn. */
    public LongProperty framesProperty() {
        return frames;
    }

    /** True if textures are emissive, as in 1998; false if lights shade them. */
    public BooleanProperty glowingTexturesProperty() {
        return glowingTextures;
    }

    /** True if the preview shows the shadows of the selected light. */
    public BooleanProperty shadowsProperty() {
        return shadows;
    }

    /** True if the lights' wireframes and markers are hidden and cannot be picked. */
    public BooleanProperty gizmosHiddenProperty() {
        return gizmosHidden;
    }

    /** True while the settings of the world are shown, so that the box of the fog has handles. Not stored. */
    public BooleanProperty fogHandlesProperty() {
        return fogHandles;
    }

    public ObjectProperty<GizmoSize> gizmoSizeProperty() {
        return gizmoSize;
    }

    /** Mouse buttons that move the view. */
    public ObjectProperty<CameraNavigation> navigationProperty() {
        return navigation;
    }

    /** Restores the settings, except that gizmos are always shown at startup. */
    public void restore(Preferences preferences) {
        glowingTextures.set(preferences.hasValue("preview", GLOWING_TEXTURES));
        gizmoSize.set(preferences.enumValue("gizmos", GizmoSize.NORMAL));
        shadows.set(!preferences.hasValue("preview-shadows", "false"));
        navigation.set(preferences.enumValue("navigation", CameraNavigation.LIGHTNING));
    }

    public void save(Preferences preferences) {
        preferences.set("preview", glowingTextures.get() ? GLOWING_TEXTURES : "");
        preferences.set("gizmos", gizmoSize.get().name());
        preferences.set("preview-shadows", shadows.get());
        preferences.set("navigation", navigation.get().name());
    }
}
