package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PreviewSettingsTest {
    @TempDir
    Path folder;

    private PreviewSettings reload(PreviewSettings saved) {
        var preferences = new Preferences(folder, Runnable::run);
        saved.save(preferences);
        preferences.save();
        var look = new PreviewSettings();
        look.restore(new Preferences(folder, Runnable::run));
        return look;
    }

    @Test
    void noPreferences_useLitTexturesAndNormalGizmos() {
        var look = new PreviewSettings();
        look.restore(new Preferences(folder, Runnable::run));
        assertThat(look.glowingTexturesProperty().get()).isFalse();
        assertThat(look.gizmosHiddenProperty().get()).isFalse();
        assertThat(look.gizmoSizeProperty().get()).isEqualTo(GizmoSize.NORMAL);
    }

    @Test
    void glowingTextures_areRestored() {
        var look = new PreviewSettings();
        look.glowingTexturesProperty().set(true);
        PreviewSettings next = reload(look);
        assertThat(next.glowingTexturesProperty().get()).isTrue();
        next.glowingTexturesProperty().set(false);
        assertThat(reload(next).glowingTexturesProperty().get()).isFalse();
    }

    @Test
    void gizmoSize_isRestored() {
        for (GizmoSize size : GizmoSize.values()) {
            var look = new PreviewSettings();
            look.gizmoSizeProperty().set(size);
            assertThat(reload(look).gizmoSizeProperty().get()).isEqualTo(size);
        }
    }

    @Test
    void navigation_isRestored() {
        for (CameraNavigation navigation : CameraNavigation.values()) {
            var look = new PreviewSettings();
            look.navigationProperty().set(navigation);
            assertThat(reload(look).navigationProperty().get()).isEqualTo(navigation);
        }
    }

    @Test
    void hiddenGizmos_areShownInTheNextRun() {
        var look = new PreviewSettings();
        look.gizmosHiddenProperty().set(true);
        assertThat(reload(look).gizmosHiddenProperty().get()).isFalse();
    }
}
