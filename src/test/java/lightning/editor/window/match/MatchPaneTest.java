package lightning.editor.window.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.base.work.Progress;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.ScreenBounds;
import lightning.editor.window.widget.PictureView;
import lightning.format.image.ImageFile;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MatchPaneTest extends EditorFixture {
    @TempDir
    private Path folder;

    private MatchPane open() {
        robot.push(KeyCode.SHIFT, KeyCode.F6);
        waitFor("the panel is open", () -> robot.lookup("#match").tryQuery().isPresent());
        // Tests of a class share their editor.
        if (robot.lookup("#match-close").<Button>query().isVisible()) {
            click("match-close");
        }
        return robot.lookup("#match").query();
    }

    private Path picture(Scene scene, String name) throws IOException {
        return write(film(scene), name);
    }

    private Path write(Film film, String name) throws IOException {
        ImageFile.write(folder.resolve(name), film, ViewTransform.DEFAULT);
        return folder.resolve(name);
    }

    private static Film film(Scene scene) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    private boolean canMatch() {
        return !robot.lookup("#match-run").<Button>query().isDisabled();
    }

    @Test
    void reference_setsTheLights_andUndoRestoresThem() throws IOException {
        Scene before = model().editor().scene();
        Light lamp = light("lamp");
        MatchPane pane = open();
        assertThat(canMatch()).isFalse();
        Path file = picture(before.withLight(lamp.withIntensity(2.5 * lamp.intensity())), "look.pfm");
        robot.interact(() -> pane.open(file));
        waitFor("the reference is open", () -> text("match-file").equals("look.pfm") && canMatch());
        click("match-run");
        waitFor("the lights are matched", () -> text("match-result").startsWith("Difference:"));
        assertThat(light("lamp").intensity()).isCloseTo(2.5 * lamp.intensity(), within(5e-3 * lamp.intensity()));
        assertThat(light("sun").intensity()).isCloseTo(before.light("sun").orElseThrow().intensity(), within(1e-3));
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void paint_setsTheLights() {
        Scene before = model().editor().scene();
        open();
        click("match-darker");
        PictureView picture = robot.lookup("#match-picture").query();
        Bounds at = ScreenBounds.of(picture);
        robot.moveTo(at.getCenterX() - 60, at.getCenterY() + 30).press(MouseButton.PRIMARY).moveBy(120, 20).release(MouseButton.PRIMARY);
        waitFor("the paint is there", this::canMatch);
        click("match-run");
        waitFor("the lights are matched", () -> text("match-result").startsWith("Difference:"));
        double sum = 0;
        for (Light light : model().editor().scene().lights()) {
            sum += light.intensity() - before.light(light.name()).orElseThrow().intensity();
        }
        assertThat(sum).isNegative();
        assertThat(canMatch()).as("the paint is gone").isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"match-open", "match-lights", "match-changes"})
    void escape_closesThePanel_whereverTheFocusIs(String id) {
        MatchPane pane = open();
        robot.interact(() -> pane.lookup("#" + id).requestFocus());
        robot.type(KeyCode.ESCAPE);
        waitFor("the panel is closed", () -> !pane.getScene().getWindow().isShowing());
    }

    /** The focus leaves the button, which is disabled meanwhile. */
    @Test
    void escapeAfterAMatch_closesThePanel() throws IOException {
        MatchPane pane = open();
        Path file = picture(model().editor().scene(), "same.pfm");
        robot.interact(() -> pane.open(file));
        waitFor("the reference is open", () -> text("match-file").equals("same.pfm") && canMatch());
        click("match-run");
        waitFor("the lights are matched", () -> text("match-result").startsWith("Difference:"));
        robot.type(KeyCode.ESCAPE);
        waitFor("the panel is closed", () -> !pane.getScene().getWindow().isShowing());
    }

    @Test
    void referenceOfAnotherShape_disablesTheButtonWithAReason() throws IOException {
        MatchPane pane = open();
        ImageFile.write(folder.resolve("wide.pfm"), Film.black(40, 4), ViewTransform.DEFAULT);
        robot.interact(() -> pane.open(folder.resolve("wide.pfm")));
        waitFor("the reference is open", () -> text("match-file").equals("wide.pfm"));
        assertThat(canMatch()).isFalse();
        click("match-close");
        assertThat(text("match-file")).isEmpty();
    }

    @Test
    void damagedReference_getsASentence() {
        MatchPane pane = open();
        robot.interact(() -> pane.open(folder.resolve("missing.png")));
        waitFor("the failure is shown", () -> text("match-result").contains("missing.png"));
    }

    @Test
    void freeExposure_isOfferedForImagesOnly() throws IOException {
        MatchPane pane = open();
        CheckBox exposure = robot.lookup("#match-exposure").query();
        assertThat(exposure.isVisible()).isFalse();
        Path file = picture(model().editor().scene(), "same.png");
        robot.interact(() -> pane.open(file));
        waitFor("the reference is open", () -> exposure.isVisible());
    }

    @Test
    void reference_isShownBesideThePicture() throws IOException {
        MatchPane pane = open();
        Path file = picture(model().editor().scene(), "beside.pfm");
        robot.interact(() -> pane.open(file));
        waitFor("the reference is open", () -> text("match-file").equals("beside.pfm"));
        ComboBox<MatchView.Arrangement> arrangement = robot.lookup("#match-arrangement").query();
        robot.interact(() -> arrangement.setValue(MatchView.Arrangement.SIDE_BY_SIDE));
        assertThat(robot.lookup("#match-reference").tryQuery()).isNotEqualTo(Optional.empty());
        robot.interact(() -> arrangement.setValue(MatchView.Arrangement.WIPE));
        assertThat(robot.lookup("#match-reference").tryQuery()).isEqualTo(Optional.empty());
    }

    @Test
    void mixedReference_isHalfOfEachPixel() throws IOException {
        MatchPane pane = open();
        Scene scene = model().editor().scene();
        PictureView picture = robot.lookup("#match-picture").query();
        waitFor("the picture is shown", () -> !picture.isEmpty());
        int before = picture.pixels()[0] & 0xff;
        Path file = write(white(scene.picture().width(), scene.picture().height()), "white.pfm");
        robot.interact(() -> pane.open(file));
        waitFor("the reference is open", () -> text("match-file").equals("white.pfm"));
        ComboBox<MatchView.Arrangement> arrangement = robot.lookup("#match-arrangement").query();
        robot.interact(() -> arrangement.setValue(MatchView.Arrangement.MIXED));
        assertThat(picture.pixels()[0] & 0xff).isCloseTo((before + 255) / 2, within(1));
    }

    /** Outside the region the reference is white, which no lamp could reach. */
    @Test
    void region_countsAlone() throws IOException {
        MatchPane pane = open();
        Scene before = model().editor().scene();
        Light lamp = before.light("lamp").orElseThrow();
        int width = before.picture().width();
        float[] rgb = film(before.withLight(lamp.withIntensity(2 * lamp.intensity()))).toScanlines();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 % width < width / 2 ? rgb[i] : 50;
        }
        Path file = write(Film.ofScanlines(width, before.picture().height(), rgb), "half.pfm");
        robot.interact(() -> pane.open(file));
        waitFor("the reference is open", () -> text("match-file").equals("half.pfm") && canMatch());
        click("match-region");
        PictureView picture = robot.lookup("#match-picture").query();
        Bounds shown = picture.localToScreen(picture.pictureBoundsProperty().getValue());
        robot.moveTo(shown.getMinX() + 2, shown.getMinY() + 2).press(MouseButton.PRIMARY)
                .moveTo(shown.getCenterX() - 4, shown.getMaxY() - 2).release(MouseButton.PRIMARY);
        click("match-run");
        waitFor("the lights are matched", () -> text("match-result").startsWith("Difference:"));
        assertThat(light("lamp").intensity()).isCloseTo(2 * lamp.intensity(), within(0.02 * lamp.intensity()));
    }

    private static Film white(int width, int height) {
        float[] rgb = new float[3 * width * height];
        Arrays.fill(rgb, 1);
        return Film.ofScanlines(width, height, rgb);
    }
}
