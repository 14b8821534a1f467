package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Display of updates, with a clock that the tests set. */
class ProgressiveDisplayTest {
    private static final int TILES = 100;
    private static final float[][] TILE = new float[3][1024];

    private final List<String> events = new ArrayList<>();
    private final Scene scene = DeskScene.scene();
    private final RenderListener listener = new RenderListener() {
        @Override
        public void tileRendered(Scene of, int tile, float[][] film) {
            events.add("tile " + tile);
        }
    };
    private long now;

    private ProgressiveDisplay display(boolean canShow) {
        return new ProgressiveDisplay(Progress.NONE, scene, listener, () -> events.add("slow"),
                isReplaceable -> events.add(isReplaceable ? "replaceable" : "not replaceable"), canShow, () -> now);
    }

    private void finish(ProgressiveDisplay display, int tile, double millisecondsPassed) {
        now = (long) (millisecondsPassed * 1e6);
        display.tileFinished(tile, TILE);
        display.report(tile + 1, TILES);
    }

    @Test
    void fastUpdate_appearsOnlyWhenComplete() {
        ProgressiveDisplay display = display(true);
        for (int tile = 0; tile < TILES; tile++) {
            finish(display, tile, 2.5 * (tile + 1));
        }
        assertThat(events).isEmpty();
    }

    @Test
    void slowUpdate_showsCoarseImageThenItsTiles() {
        ProgressiveDisplay display = display(true);
        finish(display, 0, 50);
        assertThat(events).isEmpty();
        finish(display, 1, 100);
        assertThat(events).containsExactly("slow", "tile 0", "tile 1", "replaceable");
        finish(display, 2, 150);
        assertThat(events).endsWith("tile 2", "replaceable");
    }

    /** An update that is fast without its display must not count as slow. */
    @Test
    void timeOfTilesThatAreShown_isKnown() {
        double milliseconds = 7;
        var slowListener = new RenderListener() {
            @Override
            public void tileRendered(Scene of, int tile, float[][] film) {
                now += (long) (milliseconds * 1e6);
            }
        };
        var display = new ProgressiveDisplay(Progress.NONE, scene, slowListener, () -> now += (long) (milliseconds * 1e6), _ -> {}, true,
                () -> now);
        finish(display, 0, 50);
        assertThat(display.displayNs()).isZero();
        finish(display, 1, 100);
        assertThat(display.displayNs()).isEqualTo((long) (3 * milliseconds * 1e6));
        finish(display, 2, 150);
        assertThat(display.displayNs()).isEqualTo((long) (4 * milliseconds * 1e6));
    }

    @Test
    void slowUpdateNearItsEnd_isNotReplaced() {
        ProgressiveDisplay display = display(true);
        finish(display, 0, 100);
        finish(display, TILES - 2, 9900);
        assertThat(events).endsWith("not replaceable");
    }

    /** The display shows a scene that waits instead of further tiles, once. */
    @Test
    void keptWork_isNotReplacedFromAQuarterOn() {
        List<String> waiting = new ArrayList<>(List.of("coarse"));
        ProgressiveDisplay display = display(true).showingTiles(true)
                .keepingWork(() -> !waiting.isEmpty() && events.add(waiting.removeFirst()));
        finish(display, 20, 2000);
        assertThat(events).containsExactly("tile 20", "replaceable");
        finish(display, 24, 2500);
        assertThat(events).endsWith("tile 24", "not replaceable", "coarse");
        finish(display, 25, 2600);
        assertThat(events).endsWith("coarse", "not replaceable");
    }

    @Test
    void slowUpdateInOtherView_isNotShown() {
        ProgressiveDisplay display = display(false);
        finish(display, 0, 100);
        finish(display, 1, 200);
        assertThat(events).containsExactly("slow");
    }

    @Test
    void sceneThatIsShownAlready_showsTilesFromStart() {
        ProgressiveDisplay display = display(true).showingTiles(true);
        finish(display, 0, 1);
        assertThat(events).containsExactly("tile 0", "not replaceable");
        finish(display, 1, 100);
        assertThat(events).endsWith("tile 1", "replaceable").doesNotContain("slow");
    }
}
