package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.document.DeskScene;
import lightning.scene.shot.Shot;
import lightning.shot.HostLostException;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** No host renders these frames, so missing frames stay missing. */
class FilmStripStatusTest {
    private final FilmStripStatus status = new FilmStripStatus();
    private final ShotRelighter shot = ShotRelighter.of(1, 2, status);

    @BeforeEach
    void connect() {
        status.connect(shot, () -> {}, _ -> {});
    }

    @AfterEach
    void close() {
        shot.close();
    }

    @Test
    void lossOfNeededMachine_isReported() {
        status.edit(new ShotRevision(DeskScene.scene(), Shot.DEFAULT));
        status.hostLost(new HostLostException("gone", null));
        assertThat(status.hasLostMachine()).isTrue();
    }

    @Test
    void lossOfReplacedMachine_isNotReported() {
        status.hostLost(new HostLostException("gone", null));
        assertThat(status.hasLostMachine()).isFalse();
    }
}
