package lightning.editor.window.mixer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Labeled;
import javafx.scene.control.TextField;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.base.math.Rgb;
import lightning.document.EditOutcome;
import lightning.document.LightGroupEdits;
import lightning.document.MixerEdits;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.editor.window.ScreenBounds;
import lightning.editor.window.widget.PercentText;
import lightning.render.image.Film;
import lightning.render.relight.ContributionScene;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

@OwnEditor
class MixerPaneTest extends EditorFixture {
    private Scene first;

    @BeforeEach
    void openMixer() {
        first = model().editor().scene();
        floatPanels();
        robot.push(KeyCode.F4);
        waitFor("the strips have thumbnails", () -> robot.lookup("#thumbnail-stage").<ImageView>query().getImage() != null);
    }

    private Fader fader(String name) {
        return robot.lookup("#fader-" + name).query();
    }

    /** Returns the center of a fader's cap for a value in stops. */
    private Point2D faderPoint(String name, double stops) {
        Fader fader = fader(name);
        Bounds at = ScreenBounds.of(fader);
        return new Point2D(at.getCenterX(), at.getMinY() + fader.capY(stops));
    }

    private void press(String name, double from, double to) {
        robot.moveTo(faderPoint(name, from)).press(MouseButton.PRIMARY).moveTo(dragPoint(name, from, to));
    }

    /** Returns the end of a drag between two values in stops, beyond the fader if it is low. */
    private Point2D dragPoint(String name, double from, double to) {
        double range = name.equals("master") ? 5 : 10;
        var scale = new FaderScale(range);
        double position = Math.abs(to) > range ? 1.02 * Math.signum(to) : scale.position(to);
        double pixels = (position - scale.position(from)) / FaderScale.drag(1, fader(name).capY(-range) - fader(name).capY(range));
        return faderPoint(name, from).subtract(0, pixels);
    }

    private void drag(String name, double from, double to) {
        press(name, from, to);
        robot.release(MouseButton.PRIMARY);
    }

    private void type(String field, String text) {
        robot.clickOn("#" + field);
        robot.interact(() -> robot.lookup("#" + field).<TextField>query().setText(text));
        robot.push(KeyCode.ENTER);
    }

    /** Waits for the picture of the current scene and compares it with the reference tracer's. */
    private void assertPictureShowsTheScene() {
        waitForPicture();
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
    }

    private List<String> strips() {
        return robot.lookup(".strip").queryAllAs(Node.class).stream().filter(n -> n instanceof MixerStrip)
                .sorted((a, b) -> Double.compare(a.getLayoutX(), b.getLayoutX()))
                .map(n -> ((MixerStrip) n).channel().title(model().editor().scene())).toList();
    }

    private Node head(String name) {
        return robot.lookup("#strip-head-" + name).query();
    }

    /** The headless platform's mouse ignores pressed modifier keys. */
    private void ctrlClick(String name) {
        robot.interact(() -> Stream.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED).forEach(type -> Event.fireEvent(head(name),
                new MouseEvent(type, 1, 1, 0, 0, MouseButton.PRIMARY, 1, false, true, false, false, true, false, false, true, false, true,
                        null))));
    }

    @Test
    void strip_showsContributionAndPercentage() {
        Film share = new ReferenceTracer(ContributionScene.of(first, "stage")).trace();
        int[] all = model().picture().viewProperty().get().toPixels(share);
        var image = robot.lookup("#thumbnail-stage").<ImageView>query().getImage();
        int[] shown = new int[64 * 48];
        image.getPixelReader().getPixels(0, 0, 64, 48, PixelFormat.getIntArgbInstance(), shown, 0, 64);
        assertThat(shown).isEqualTo(all);
        double part = brightness(share) / brightness(model().picture().frame().film());
        assertThat(part).isBetween(0.01, 0.99);
        assertThat(robot.lookup("#part-stage").<Labeled>query().getText()).isEqualTo(PercentText.format(part));
    }

    /** Without waiting for a picture: its thumbnails with indirect light take seconds. */
    @Test
    void shares_followTheEdit() {
        waitFor("the shares of all pixels are known", () -> mixer().shares().isPresent());
        double before = mixer().shares().orElseThrow().of(Contribution.of(model().editor().scene().lights().getFirst()));
        robot.interact(() -> {
            Scene scene = model().editor().scene();
            Light light = scene.lights().getFirst();
            model().editor().editOrReport(s -> EditOutcome.of(() -> s.withLight(light.withIntensity(light.intensity() / 64))), null);
            assertThat(robot.lookup("#part-" + light.name()).<Labeled>query().getText())
                    .isEqualTo(PercentText.format(before / 64 / (1 - before + before / 64)));
        });
    }

    private MixerPane mixer() {
        return robot.lookup("#mixer").query();
    }

    private static double brightness(Film film) {
        double sum = 0;
        float[] rgb = film.toScanlines();
        for (int i = 0; i < rgb.length; i += 3) {
            sum += new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]).luminance();
        }
        return sum;
    }

    @Test
    void draggedFader_updatesPictureLiveInOneUndoStep() {
        press("lamp", 0, 1);
        double half = light("lamp").intensity();
        assertThat(half).isBetween(1.8, 2.2);
        assertPictureShowsTheScene();
        robot.moveTo(dragPoint("lamp", 0, 2));
        assertPictureShowsTheScene();
        robot.release(MouseButton.PRIMARY);
        assertThat(light("lamp").intensity()).isBetween(3.7, 4.3);
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(model().editor().scene()).isEqualTo(first);
    }

    @Test
    void undoInMixer_updatesPictureImmediately() {
        drag("lamp", 0, 1);
        waitForPicture();
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(model().editor().scene()).isEqualTo(first);
        assertPictureShowsTheScene();
    }

    @Test
    void refusedText_showsMessageInMixer() {
        type("intensity-lamp", "abc");
        assertThat(robot.lookup("#mixer-message").<Labeled>query().getText()).contains("'abc'");
    }

    @Test
    void longNumber_afterCommit_showsItsStart() {
        type("intensity-lamp", "1/3");
        TextField field = robot.lookup("#intensity-lamp").query();
        assertThat(field.getText()).isEqualTo("0.3333333333333333");
        assertThat(field.getSelectedText()).isEqualTo(field.getText());
        assertThat(field.getCaretPosition()).isZero();
    }

    @Test
    void draggedFader_ofSelectedLight_keepsMaterialTab() {
        drag("lamp", 0, 1);
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        drag("lamp", 1, 2);
        assertThat(light("lamp").intensity()).isBetween(3.7, 4.3);
        assertThat(model().editor().materialShownProperty().get()).isTrue();
    }

    @Test
    void pressAfterDrag_isNoDoubleClick() {
        mouse("lamp", MouseEvent.MOUSE_PRESSED, 0, 1);
        mouse("lamp", MouseEvent.MOUSE_DRAGGED, 1, 1);
        mouse("lamp", MouseEvent.MOUSE_RELEASED, 1, 1);
        double dragged = light("lamp").intensity();
        assertThat(dragged).isGreaterThan(first.light("lamp").orElseThrow().intensity());
        mouse("lamp", MouseEvent.MOUSE_PRESSED, 1, 2);
        mouse("lamp", MouseEvent.MOUSE_RELEASED, 1, 2);
        assertThat(light("lamp").intensity()).isEqualTo(dragged);
        mouse("lamp", MouseEvent.MOUSE_PRESSED, 1, 2);
        assertThat(light("lamp").intensity()).isEqualTo(1);
    }

    private void mouse(String name, EventType<MouseEvent> type, double stops, int clicks) {
        Fader fader = fader(name);
        robot.interact(() -> Event.fireEvent(fader, new MouseEvent(type, fader.getWidth() / 2, fader.capY(stops), 0, 0,
                MouseButton.PRIMARY, clicks, false, false, false, false, true, false, false, true, false, true, null)));
    }

    @Test
    void editOfOneLight_keepsOtherImages() {
        var ofStage = robot.lookup("#thumbnail-stage").<ImageView>query().getImage();
        var ofLamp = robot.lookup("#thumbnail-lamp").<ImageView>query().getImage();
        drag("lamp", 0, 1);
        waitForPicture();
        waitFor("the thumbnail of the lamp is updated", () -> robot.lookup("#thumbnail-lamp").<ImageView>query().getImage() != ofLamp);
        assertThat(robot.lookup("#thumbnail-stage").<ImageView>query().getImage()).isSameAs(ofStage);
    }

    @Test
    void escape_duringDrag_cancelsIt() {
        press("lamp", 0, 3);
        robot.push(KeyCode.ESCAPE);
        robot.release(MouseButton.PRIMARY);
        assertThat(model().editor().scene()).isEqualTo(first);
        assertThat(isShown("mixer")).isTrue();
    }

    @Test
    void faderAtLowerEnd_turnsLightOffAndBackOn() {
        drag("lamp", 0, -14);
        assertThat(light("lamp").intensity()).isZero();
        assertThat(robot.lookup("#stops-lamp").<TextField>query().isDisabled()).isTrue();
        robot.interact(() -> fader("lamp").requestFocus());
        robot.push(KeyCode.UP);
        assertThat(light("lamp").intensity()).isEqualTo(MixerEdits.intensityOfStops(-9.9));
    }

    /** As a light in watts has; a drag once jumped to the end of the range. */
    @Test
    void valueBeyondTheFader_isDraggedFromThere() {
        type("stops-lamp", "15");
        robot.moveTo(faderPoint("lamp", 15)).press(MouseButton.PRIMARY).moveTo(faderPoint("lamp", 15).add(0, 8))
                .release(MouseButton.PRIMARY);
        assertThat(MixerEdits.stops(light("lamp").intensity())).isBetween(14.0, 14.9);
    }

    @Test
    void typedStopsAndNumbers_setTheIntensity() {
        type("stops-lamp", "-1");
        assertThat(light("lamp").intensity()).isEqualTo(0.5);
        type("intensity-lamp", "0.25");
        assertThat(robot.lookup("#stops-lamp").<TextField>query().getText()).isEqualTo("-2");
        assertPictureShowsTheScene();
    }

    @Test
    void severalStrips_changeRelativelyOrAbsolutely() {
        robot.clickOn(head("lamp"));
        ctrlClick("sun");
        type("stops-lamp", "2");
        assertThat(List.of(light("lamp").intensity(), light("sun").intensity(), light("stage").intensity()))
                .isEqualTo(List.of(4.0, 1.6, 1.5));
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(first);
        click("mixer-absolute");
        type("intensity-sun", "3");
        assertThat(List.of(light("lamp").intensity(), light("sun").intensity(), light("stage").intensity()))
                .isEqualTo(List.of(3.0, 3.0, 1.5));
        assertPictureShowsTheScene();
    }

    @Test
    void relativeEdit_ofDarkStrip_explainsAlternatives() {
        type("intensity-lamp", "0");
        robot.clickOn(head("lamp"));
        ctrlClick("sun");
        type("intensity-lamp", "1");
        assertThat(light("lamp").intensity()).isZero();
        assertThat(text("mixer-message")).contains("Choose Absolute");
    }

    @Test
    void master_scalesEveryLightAndResetsToZero() {
        drag("master", 0, 1);
        double factor = light("lamp").intensity();
        assertThat(factor).isBetween(1.8, 2.2);
        assertThat(light("stage").intensity() / 1.5).isCloseTo(factor, org.assertj.core.data.Percentage.withPercentage(1e-3));
        assertThat(fader("master").stops()).isZero();
        assertPictureShowsTheScene();
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(first);
        type("stops-master", "-1");
        assertThat(first.lights().stream().map(Light::intensity).map(i -> i / 2).toList())
                .isEqualTo(model().editor().scene().lights().stream().map(Light::intensity).toList());
    }

    @Test
    void soloAndMute_applyToSelection() {
        click("mute-lamp");
        assertThat(light("lamp").on()).isFalse();
        robot.clickOn(head("sun"));
        ctrlClick("stage");
        click("solo-stage");
        assertThat(light("sun").solo()).isTrue();
        assertThat(light("stage").solo()).isTrue();
        assertThat(light("lamp").solo()).isFalse();
        assertPictureShowsTheScene();
    }

    @Test
    void draggedHead_reordersLights() {
        assertThat(strips()).containsExactly("lamp", "sun", "stage");
        Bounds to = ScreenBounds.of(head("lamp"));
        robot.moveTo(head("stage")).press(MouseButton.PRIMARY).moveBy(-20, 0).moveTo(to.getMinX() + 2, to.getCenterY())
                .release(MouseButton.PRIMARY);
        assertThat(model().editor().scene().lights().stream().map(Light::name)).containsExactly("stage", "lamp", "sun");
        assertThat(strips()).containsExactly("stage", "lamp", "sun");
        assertThat(model().commands().disabledReason(Command.UNDO)).isEmpty();
        assertThat(model().editor().editorStateProperty().get().undoLabel()).hasValue("order of lights");
        String text = model().editor().document().text(model().editor().document().content());
        assertThat(text.indexOf("light stage")).isLessThan(text.indexOf("light lamp"));
        assertPictureShowsTheScene();
        click("undo");
        assertThat(strips()).containsExactly("lamp", "sun", "stage");
    }

    @Test
    void draggedGroupHead_reordersGroups() {
        robot.interact(() -> {
            model().editor().edit(scene -> LightGroupEdits.create(scene, "sun"));
            model().editor().edit(scene -> LightGroupEdits.create(scene, "stage"));
        });
        assertThat(strips()).containsExactly("lamp", "group", "sun", "group2", "stage");
        Bounds to = ScreenBounds.of(head("group"));
        robot.moveTo(head("group2")).press(MouseButton.PRIMARY).moveBy(-20, 0).moveTo(to.getMinX() + 2, to.getCenterY())
                .release(MouseButton.PRIMARY);
        assertThat(strips()).containsExactly("lamp", "group2", "stage", "group", "sun");
        assertThat(model().editor().editorStateProperty().get().undoLabel()).hasValue("order of light groups");
        String text = model().editor().document().text(model().editor().document().content());
        assertThat(text.indexOf("\nbank group2")).isPositive().isLessThan(text.indexOf("\nbank group "));
        assertPictureShowsTheScene();
        click("undo");
        assertThat(strips()).containsExactly("lamp", "group", "sun", "group2", "stage");
    }

    @Test
    void lightGroup_hasMasterStripAndAcceptsLights() {
        robot.interact(() -> model().editor().edit(scene -> LightGroupEdits.create(scene, "stage")));
        assertThat(strips()).containsExactly("lamp", "sun", "group", "stage");
        type("stops-group", "1");
        assertThat(model().editor().scene().rig().lightGroup("group").orElseThrow().intensity()).isEqualTo(2);
        assertThat(light("stage").intensity()).isEqualTo(1.5);
        assertPictureShowsTheScene();
        Bounds to = ScreenBounds.of(head("stage"));
        robot.moveTo(head("lamp")).press(MouseButton.PRIMARY).moveBy(20, 0).moveTo(to.getMaxX() - 4, to.getCenterY())
                .release(MouseButton.PRIMARY);
        assertThat(light("lamp").lightGroup()).isEqualTo("group");
        assertThat(strips()).containsExactly("sun", "group", "stage", "lamp");
    }

    @Test
    void color_appliesToSelection() {
        robot.clickOn(head("lamp"));
        ctrlClick("sun");
        click("color-sun");
        waitFor("the color popup is open", () -> robot.lookup("#color-popup").tryQuery().isPresent());
        TextField red = robot.lookup("#color-popup .text-field").queryAllAs(TextField.class).stream()
                .filter(n -> "red".equals(n.getAccessibleText())).findFirst().orElseThrow();
        robot.clickOn(red);
        robot.interact(() -> red.setText("0.25"));
        robot.push(KeyCode.ENTER);
        assertThat(Stream.of("lamp", "sun", "stage").map(n -> light(n).color().r())).containsExactly(0.25, 0.25, 1.0);
        assertPictureShowsTheScene();
    }

    @Test
    void searchAndFilter_showMatchingStrips() {
        robot.clickOn("#mixer-search").write("spot");
        assertThat(strips()).containsExactly("stage");
        assertThat(text("mixer-count")).isEqualTo("1 of 3 strips");
        robot.interact(() -> robot.lookup("#mixer-search").<TextField>query().clear());
        click("mute-sun");
        robot.interact(() -> robot.lookup("#mixer-filter").<ChoiceBox<StripFilter>>query().setValue(StripFilter.MUTED));
        assertThat(strips()).containsExactly("sun");
    }

    @Test
    void renamedLight_keepsItsPicture() {
        robot.interact(() -> model().editor().edit(scene -> lightning.document.LightEdits.rename(scene, "stage", "key")));
        assertThat(robot.lookup("#thumbnail-key").<ImageView>query().getImage()).isNotNull();
    }

    /** Muting set the environment's intensity to 0, which made the background black. */
    @Test
    void mutedEnvironment_keepsItsImageAndReturnsToItsGain() {
        float[] rgb = new float[8 * 4 * 3];
        Arrays.fill(rgb, 0.5f);
        var environment = new Environment("sky.hdr", new EnvironmentMap(8, 4, rgb));
        robot.interact(() -> model().editor().edit(scene -> new EditOutcome.Applied(
                scene.withWorld(
                        scene.world().withEnvironment(Optional.of(environment)).withOwn(own -> own.withIntensity(2).withGain(0.5))))));
        Scene lit = model().editor().scene();
        click("mute-environment");
        assertThat(model().editor().scene().world()).isEqualTo(lit.world().withOwn(own -> own.withGain(0)));
        assertPictureShowsTheScene();
        click("mute-environment");
        assertThat(model().editor().scene()).isEqualTo(lit);
        assertPictureShowsTheScene();
    }
}
