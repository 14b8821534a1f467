package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.document.Desk;
import lightning.scene.shot.Shot;
import lightning.shot.KeeperGoneException;
import lightning.shot.RelitShot;
import lightning.shot.Take;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Nobody holds these frames, so that each missing one stays missing. */
class StripNewsTest {
    private final StripNews news = new StripNews();
    private final RelitShot shot = RelitShot.of(1, 2, news);

    @BeforeEach
    void follow() {
        news.follow(shot, () -> {}, _ -> {});
    }

    @AfterEach
    void close() {
        shot.close();
    }

    @Test
    void lossOfWhatIsMissing_isTold() {
        news.edit(new Take(Desk.scene(), Shot.DEFAULT));
        news.gone(new KeeperGoneException("gone", null));
        assertThat(news.hasLost()).isTrue();
    }

    @Test
    void lossThatOthersHaveMadeGoodBeforeItIsHeard_isNotTold() {
        news.gone(new KeeperGoneException("gone", null));
        assertThat(news.hasLost()).isFalse();
    }
}
