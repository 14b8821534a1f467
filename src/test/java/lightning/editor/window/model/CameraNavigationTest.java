package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.document.manipulation.CameraDrag;
import org.junit.jupiter.api.Test;

class CameraNavigationTest {
    private static MouseEvent press(MouseButton button, boolean shift, boolean control, boolean alt) {
        return new MouseEvent(MouseEvent.MOUSE_PRESSED, 0, 0, 0, 0, button, 1, shift, control, alt, false, button == MouseButton.PRIMARY,
                button == MouseButton.MIDDLE, button == MouseButton.SECONDARY, false, false, true, null);
    }

    @Test
    void lightning_movesViewWithShiftOnly() {
        assertThat(CameraNavigation.LIGHTNING.movesView(press(MouseButton.PRIMARY, true, false, false))).isTrue();
        assertThat(CameraNavigation.LIGHTNING.action(press(MouseButton.PRIMARY, true, false, false))).isEmpty();
        assertThat(CameraNavigation.LIGHTNING.movesView(press(MouseButton.PRIMARY, false, false, true))).isFalse();
        assertThat(CameraNavigation.LIGHTNING.movesView(press(MouseButton.MIDDLE, false, false, false))).isFalse();
    }

    @Test
    void alt_orbitsPansAndZoomsByButton() {
        assertThat(CameraNavigation.ALT.action(press(MouseButton.PRIMARY, false, false, true))).isEqualTo(Optional.of(CameraDrag.ORBIT));
        assertThat(CameraNavigation.ALT.action(press(MouseButton.MIDDLE, false, false, true))).isEqualTo(Optional.of(CameraDrag.PAN));
        assertThat(CameraNavigation.ALT.action(press(MouseButton.SECONDARY, false, false, true))).isEqualTo(Optional.of(CameraDrag.ZOOM));
        assertThat(CameraNavigation.ALT.movesView(press(MouseButton.MIDDLE, false, false, false))).isFalse();
    }

    @Test
    void middle_orbitsPansAndZoomsByModifier() {
        assertThat(CameraNavigation.MIDDLE.action(press(MouseButton.MIDDLE, false, false, false))).isEqualTo(Optional.of(CameraDrag.ORBIT));
        assertThat(CameraNavigation.MIDDLE.action(press(MouseButton.MIDDLE, true, false, false))).isEqualTo(Optional.of(CameraDrag.PAN));
        assertThat(CameraNavigation.MIDDLE.action(press(MouseButton.MIDDLE, false, true, false))).isEqualTo(Optional.of(CameraDrag.ZOOM));
        assertThat(CameraNavigation.MIDDLE.movesView(press(MouseButton.PRIMARY, false, false, true))).isFalse();
    }
}
