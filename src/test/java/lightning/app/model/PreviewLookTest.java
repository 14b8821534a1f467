package lightning.app.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PreviewLookTest {
    @TempDir
    Path folder;

    private PreviewLook inTheNextRun(PreviewLook left) {
        var preferences = new Preferences(folder);
        left.remember(preferences);
        preferences.save();
        var look = new PreviewLook();
        look.restore(new Preferences(folder));
        return look;
    }

    @Test
    void withoutPreferences_lightFallsOnTexturesAndGizmosAreNormal() {
        var look = new PreviewLook();
        look.restore(new Preferences(folder));
        assertThat(look.litProperty().get()).isTrue();
        assertThat(look.gizmosProperty().get()).isTrue();
        assertThat(look.sizeProperty().get()).isEqualTo(GizmoSize.NORMAL);
    }

    @Test
    void glowingTextures_areKept() {
        var look = new PreviewLook();
        look.litProperty().set(false);
        PreviewLook next = inTheNextRun(look);
        assertThat(next.litProperty().get()).isFalse();
        next.litProperty().set(true);
        assertThat(inTheNextRun(next).litProperty().get()).isTrue();
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
        look.gizmosProperty().set(false);
        assertThat(inTheNextRun(look).gizmosProperty().get()).isTrue();
    }
}
