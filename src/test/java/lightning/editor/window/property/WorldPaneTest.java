package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ComboBox;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.FastRobot;
import lightning.render.image.DisplayCurve;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Properties of the world: each is an undoable edit, and those without effect are not shown. */
class WorldPaneTest extends EditorFixture {
    @BeforeEach
    void showWorld() {
        click("world-tab");
        FastRobot.settle();
    }

    private Scene scene() {
        return model().editor().scene();
    }

    private void type(String widget, String number) {
        TextField field = robot.from(robot.lookup("#" + widget).<Node>query()).lookup((Node n) -> n instanceof TextField).query();
        robot.interact(() -> {
            field.requestFocus();
            field.setText(number);
        });
        robot.push(KeyCode.ENTER);
    }

    private boolean isVisibleInWindow(String id) {
        Node node = robot.lookup("#" + id).query();
        while (node != null && node.isVisible()) {
            node = node.getParent();
        }
        return node == null;
    }

    private Optional<String> undoLabel() {
        return model().editor().editorStateProperty().get().undoLabel();
    }

    @Test
    void world_hasWholeHeightUntilLightIsSelected() {
        assertThat(robot.lookup("#side").tryQuery()).isEmpty();
        robot.interact(() -> model().editor().selection().selectLight("sun"));
        waitFor("the light's properties are shown", () -> robot.lookup("#side").tryQuery().isPresent());
        robot.push(KeyCode.SHIFT, KeyCode.F2);
        waitFor("the world is shown", () -> robot.lookup("#side").tryQuery().isEmpty());
        click("shapes-tab");
        assertThat(robot.lookup("#side").tryQuery()).isPresent();
    }

    @Test
    void camera_isSavedChosenAndDeleted() {
        robot.interact(() -> robot.lookup("#camera-name").<TextField>query().setText("front"));
        robot.interact(() -> robot.lookup("#save-camera").<Button>query().fire());
        Scene saved = scene();
        assertThat(saved.namedCamera("front")).contains(saved.camera());
        type("camera-fov", "20");
        ComboBox<String> list = robot.lookup("#cameras").query();
        assertThat(list.getValue()).isNull();
        robot.interact(() -> list.setValue("front"));
        assertThat(scene()).isEqualTo(saved);
        robot.interact(() -> robot.lookup("#delete-camera").<Button>query().fire());
        assertThat(scene().cameras()).isEmpty();
        assertThat(scene().camera()).isEqualTo(saved.camera());
    }

    @Test
    void ambienceAndBackground_areEdited() {
        type("ambience", "0.5");
        assertThat(scene().world().ambience()).isEqualTo(0.5);
        assertThat(undoLabel()).contains("ambient light 0.2 → 0.5");
        Rgb before = scene().world().background();
        TextField red = robot.from(robot.lookup("#world-background").<Node>query()).lookup((Node n) -> n instanceof TextField)
                .queryAllAs(TextField.class).iterator().next();
        robot.interact(() -> {
            red.requestFocus();
            red.setText("0.75");
        });
        robot.push(KeyCode.ENTER);
        assertThat(scene().world().background()).isEqualTo(new Rgb(0.75, before.g(), before.b()));
        assertThat(undoLabel()).hasValueSatisfying(label -> assertThat(label).contains("background"));
    }

    @Test
    void indirectLight_showsSettingsWhileOn() {
        assertThat(isVisibleInWindow("world-indirect-bounces")).isFalse();
        robot.interact(() -> model().editor().liveProperty().set(false));
        robot.interact(() -> robot.lookup("#world-indirect").<javafx.scene.control.ToggleButton>query().fire());
        assertThat(scene().picture().indirect()).contains(IndirectSettings.INITIAL);
        assertThat(isVisibleInWindow("world-indirect-bounces")).isTrue();
        type("world-indirect-bounces", "3");
        type("world-indirect-spacing", "12");
        robot.interact(() -> robot.lookup("#world-indirect-rays").<ComboBox<Integer>>query().setValue(256));
        assertThat(scene().picture().indirect())
                .contains(IndirectSettings.INITIAL.withBounces(3).withSpacing(12).withRays(256));
        type("world-indirect-bounces", "2.5");
        type("world-indirect-bounces", "9");
        assertThat(scene().picture().indirect().orElseThrow().bounces()).as("invalid values are refused").isEqualTo(3);
    }

    @Test
    void view_isEditedAndFollowsHeader() {
        robot.interact(() -> robot.lookup("#world-curve").<ComboBox<DisplayCurve>>query().setValue(DisplayCurve.FILMIC));
        assertThat(scene().picture().view().curve()).isEqualTo(ViewCurve.FILMIC);
        type("world-exposure", "-1.5");
        assertThat(scene().picture().view().exposure()).isEqualTo(-1.5);
        robot.interact(() -> model().viewActions().setExposure(2, null));
        TextField exposure = robot.from(robot.lookup("#world-exposure").<Node>query()).lookup((Node n) -> n instanceof TextField).query();
        waitFor("the field follows", () -> exposure.getText().equals("2"));
    }

    private void setSun(String time) {
        robot.interact(() -> {
            robot.lookup("#sky-date").<javafx.scene.control.DatePicker>query().setValue(java.time.LocalDate.of(2003, 10, 17));
            for (var entry : java.util.Map
                    .of("sky-latitude", "39.742476", "sky-longitude", "-105.1786", "sky-offset", "-7", "sky-time", time).entrySet()) {
                robot.lookup("#" + entry.getKey()).<TextField>query().setText(entry.getValue());
            }
            robot.lookup("#sky-set-sun").<javafx.scene.control.Button>query().fire();
        });
    }

    /** The example of SunPositionTest. */
    @Test
    void sun_isSetByDateAndPlace() {
        robot.interact(() -> robot.lookup("#world-sky").<javafx.scene.control.CheckBox>query().fire());
        robot.interact(() -> robot.lookup("#sky-place").<javafx.scene.control.TitledPane>query().setExpanded(true));
        waitFor("the fields are shown", () -> robot.lookup("#sky-set-sun").tryQuery().isPresent());
        setSun("12:30");
        assertThat(scene().world().sky().elevation()).isBetween(39.8, 40.0);
        assertThat(scene().world().sky().azimuth()).isBetween(194.0, 194.5);
        setSun("1:00");
        assertThat(model().editor().message().textProperty().get()).contains("below the horizon");
        assertThat(scene().world().sky().elevation()).as("a dark night is refused").isBetween(39.8, 40.0);
    }

    @Test
    void focalLength_isThatOfAFilm24MillimetersHigh() {
        type("camera-focal-length", "12");
        assertThat(scene().camera().fov()).isCloseTo(90, within(1e-9));
    }

    @Test
    void roll_turnsThePictureAboutTheView() {
        Vec3 from = scene().camera().from();
        type("camera-roll", "90");
        Vec3 view = scene().camera().to().minus(from).normalized();
        assertThat(scene().camera().from()).isEqualTo(from);
        assertThat(scene().camera().up().normalized().minus(view.cross(Vec3.Y).normalized()).length()).isLessThan(1e-9);
        type("camera-roll", "0");
        assertThat(scene().camera().up().dot(view.cross(Vec3.Y))).isCloseTo(0, within(1e-9));
    }
}
