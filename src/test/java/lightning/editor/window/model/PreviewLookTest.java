package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PreviewLookTest {
    @TempDir
    Path folder;

    private PreviewLook inTheNextRun(PreviewLook left) {
        var preferences = new Preferences(folder, Runnable::run);
        left.remember(preferences);
        preferences.save();
        var look = new PreviewLook();
        look.restore(new Preferences(folder, Runnable::run));
        return look;
    }

    @Test
    void withoutPreferences_lightFallsOnTexturesAndGizmosAreNormal() {
        var look = new PreviewLook();
        look.restore(new Preferences(folder, Runnable::run));
        assertThat(look.glowingProperty().get()).isFalse();
        assertThat(look.gizmosHiddenProperty().get()).isFalse();
        assertThat(look.sizeProperty().get()).isEqualTo(GizmoSize.NORMAL);
    }

    @Test
    void glowingTextures_areKept() {
        var look = new PreviewLook();
        look.glowingProperty().set(true);
        PreviewLook next = inTheNextRun(look);
        assertThat(next.glowingProperty().get()).isTrue();
        next.glowingProperty().set(false);
        assertThat(inTheNextRun(next).glowingProperty().get()).isFalse();
    }

    @Test
    void sizeOfTheGizmos_isKept() {
        for (GizmoSize size : GizmoSize.values()) {
            var look = new PreviewLook();
            look.sizeProperty().set(size);
            assertThat(inTheNextRun(look).sizeProperty().get()).isEqualTo(size);
        }
    }

    @Test
    void hiddenGizmos_areShownInTheNextRun() {
        var look = new PreviewLook();
        look.gizmosHiddenProperty().set(true);
        assertThat(inTheNextRun(look).gizmosHiddenProperty().get()).isFalse();
    }
}
