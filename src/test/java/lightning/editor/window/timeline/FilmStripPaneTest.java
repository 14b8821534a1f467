package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.util.Arrays;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import lightning.document.DeskScene;
import lightning.document.EditOutcome;
import lightning.document.OpenDocument;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

class FilmStripPaneTest extends EditorFixture {
    private static final String SHOT = "shot { frames 1 4  light lamp { intensity { 1 0.5  4 2.5 } } }";

    @BeforeEach
    void openStrip() throws Exception {
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + SHOT);
        OpenDocument opened = OpenDocument.open(file);
        robot.interact(() -> model().open(opened));
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.FILM_STRIP));
    }

    private void startStrip() {
        click("strip-begin");
        waitForStrip();
    }

    private void waitForStrip() {
        waitFor("all frames are up to date", () -> text("strip-progress").isEmpty() && pixels(1).length > 0
                && robot.lookup(".strip-slot").queryAll().stream().noneMatch(FilmStripPaneTest::isStale));
    }

    private Node slot(int frame) {
        return robot.lookup("#strip-" + frame).query();
    }

    private boolean isStale(int frame) {
        return isStale(slot(frame));
    }

    private static boolean isStale(Node slot) {
        return slot.getPseudoClassStates().contains(PseudoClass.getPseudoClass("stale"));
    }

    private int[] pixels(int frame) {
        Image image = ((ImageView) slot(frame).lookup(".image-view")).getImage();
        if (image == null) {
            return new int[0];
        }
        int width = (int) image.getWidth();
        int[] pixels = new int[width * (int) image.getHeight()];
        image.getPixelReader().getPixels(0, 0, width, (int) image.getHeight(), PixelFormat.getIntArgbInstance(), pixels, 0, width);
        return pixels;
    }

    private void assertExact(int frame) {
        var scene = FilmStrip.thumbnailScene(model().editor().document().content().sceneAt(frame));
        int[] shown = WaitForAsyncUtils.waitFor(WaitForAsyncUtils.asyncFx(() -> pixels(frame)));
        assertThat(shown).as("frame " + frame)
                .isEqualTo(model().picture().viewProperty().get().toPixels(new ReferenceTracer(scene).trace()));
    }

    @Test
    void strip_beforeStart_showsMemoryAndCachesNothing() {
        waitFor("the memory is measured", () -> text("strip-cost").matches("Caches 4 thumbnails .*\\(about \\d+ MB\\)\\."));
        assertThat(robot.lookup("#strip-1").tryQuery()).isEmpty();
        startStrip();
        assertThat(robot.lookup("#strip-cost").query().getParent().isVisible()).isFalse();
        robot.interact(() -> model().commands().run(Command.FILM_STRIP));
        assertThat(robot.lookup("#strip").tryQuery()).isEmpty();
    }

    /** The bound of the estimate is 50 MB for a thumbnail with 8 × 8 samples at edges, although few pixels have them. */
    @Test
    void cost_isThatOfARenderedThumbnail() {
        robot.interact(() -> model().editor().edit(scene -> new EditOutcome.Applied(scene.withPicture(scene.picture().withSize(300, 200)
                .withSampling(new SamplingSettings(AntialiasMode.EDGES, 8))))));
        waitFor("the memory is measured", () -> text("strip-cost").contains("about"));
        long megabytes = Long.parseLong(text("strip-cost").replaceAll(".*about (\\d+) MB.*", "$1"));
        assertThat(megabytes).isBetween(1L, 60L);
    }

    /** The bound of the memory of paths is far above what a thumbnail takes. */
    @Test
    void indirectLight_leavesRoomForThumbnails() {
        robot.interact(() -> model().editor().edit(scene -> new EditOutcome.Applied(scene.withPicture(
                scene.picture().withDepth(5).withIndirect(Optional.of(IndirectSettings.DEFAULT.withRays(1024)))))));
        assertThat(text("strip-cost")).contains("Caches 4 thumbnails").doesNotContain("Not enough");
        assertThat(robot.lookup("#strip-begin").query().isDisabled()).isFalse();
    }

    @Test
    void frames_afterEdit_areExact() {
        startStrip();
        assertExact(1);
        assertExact(4);
        int[] before = WaitForAsyncUtils.waitFor(WaitForAsyncUtils.asyncFx(() -> pixels(4)));
        robot.interact(() -> {
            model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 2));
            // Such small frames may already be rendered before the stale state is shown.
            assertThat(isStale(4) || !Arrays.equals(pixels(4), before)).isTrue();
        });
        waitForStrip();
        assertExact(1);
        assertExact(4);
        assertThat(WaitForAsyncUtils.waitFor(WaitForAsyncUtils.asyncFx(() -> pixels(4)))).isNotEqualTo(before);
    }

    @Test
    void click_showsFrame() {
        startStrip();
        robot.clickOn("#strip-4");
        assertThat(model().editor().document().shotFrame().orElseThrow().frame()).isEqualTo(4);
    }

    @Test
    void otherFrameRange_asksAgain() {
        startStrip();
        robot.interact(() -> model().editor().editShot(s -> s.withShot(s.shot().orElseThrow().withFrames(1, 30)), null));
        assertThat(robot.lookup("#strip-1").tryQuery()).isEmpty();
        assertThat(text("strip-cost")).contains("Caches 30 thumbnails");
    }
}
