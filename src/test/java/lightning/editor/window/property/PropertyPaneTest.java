package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.AttributeNumber;
import lightning.document.LightEdits;
import lightning.document.LightGroupEdits;
import lightning.editor.Command;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.RefusalTexts;
import lightning.editor.window.widget.TextTyping;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class PropertyPaneTest {
    private static final List<String> NUMBERS = List.of("intensity", "angle", "dropoff", "constant", "linear", "quadratic",
            "position", "direction");

    @TempDir
    private Path folder;
    private final BooleanProperty tabSelected = new SimpleBooleanProperty(true);
    private EditorModel model;
    private PropertyPane pane;

    @Start
    private void start(Stage stage) throws Exception {
        model = TestEditors.model(folder);
        pane = new PropertyPane(model, new PropertyMenu(model.editor(), model.commands(), model.layout()), tabSelected);
        TestEditors.show(stage, pane);
    }

    @Stop
    private void stop() {
        model.close();
    }

    @Test
    void spot_enablesEverything(FxRobot robot) {
        assertThat(disabled(robot)).isEmpty();
    }

    /** A cached viewport would be redrawn completely for every number. */
    @Test
    void properties_areNotBitmapCached(FxRobot robot) {
        assertThat(robot.lookup(".properties .viewport").query().isCache()).isFalse();
    }

    /** No section has a choice attribute yet; adding one needs only the attribute. */
    @Test
    void choiceAttribute_isComboBoxThatEditsIt(FxRobot robot) {
        robot.interact(() -> ((VBox) ((ScrollPane) pane.getChildren().getFirst()).getContent()).getChildren()
                .addAll(pane.rows(LightAttribute.SOLO)));
        ComboBox<Boolean> box = robot.lookup("#solo").query();
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        assertThat(box.getItems()).extracting(box.getConverter()::toString).containsExactly("Yes", "No");
        assertThat(box.getValue()).isFalse();
        robot.interact(() -> box.setValue(true));
        assertThat(model.editor().selection().light().solo()).isTrue();
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.SUN));
        assertThat(box.getValue()).isFalse();
        assertThat(model.editor().selection().light().solo()).isFalse();
        robot.interact(() -> model.editor().selection().selectLight(null));
        assertThat(box.getValue()).isNull();
        assertThat(box.isDisabled()).isTrue();
    }

    /** Attributes of any section get a widget without code in the pane. */
    @Test
    void everyAttribute_hasControlEnabledWhereItApplies(FxRobot robot) {
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            robot.interact(() -> {
                var controls = new VBox();
                controls.getChildren().addAll(pane.rows(attribute));
                assertThat(controls.getChildren()).as(attribute.title()).isNotEmpty();
                model.editor().selection().selectLight(null);
                assertThat(inputs(controls)).as(attribute.title()).isNotEmpty().allMatch(Node::isDisabled);
                for (Light light : model.editor().scene().lights()) {
                    model.editor().selection().selectLight(light.name());
                    boolean acts = attribute.inactiveReason(light).isEmpty() || attribute == LightAttribute.POSITION;
                    assertThat(inputs(controls)).as(attribute.title() + " of " + light.name())
                            .allMatch(input -> input.isDisabled() != acts);
                }
            });
        }
    }

    private static List<Node> inputs(Node controls) {
        return Stream.of(".combo-box", ".menu-button", ".text-field", "#gains").flatMap(css -> controls.lookupAll(css).stream()).toList();
    }

    @Test
    void nameAttribute_isComboBoxOfSceneNames(FxRobot robot) {
        robot.interact(() -> {
            model.editor().edit(scene -> LightGroupEdits.create(scene, TestEditors.SUN));
            ((VBox) ((ScrollPane) pane.getChildren().getFirst()).getContent()).getChildren()
                    .setAll(pane.rows(LightAttribute.LIGHT_GROUP));
        });
        ComboBox<String> box = robot.lookup("#light-bank").query();
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        String bank = model.editor().scene().rig().lightGroups().getFirst().name();
        assertThat(box.getItems()).containsExactly("", bank);
        assertThat(box.getValue()).isEmpty();
        robot.interact(() -> box.setValue(bank));
        assertThat(model.editor().selection().light().lightGroup()).isEqualTo(bank);
        robot.interact(() -> box.setValue(""));
        assertThat(model.editor().selection().light().lightGroup()).isEmpty();
    }

    @Test
    void fileAttribute_belongsToSelectedLight(FxRobot robot) {
        for (LightAttribute<?> attribute : List.of(LightAttribute.GOBO, LightAttribute.PROFILE)) {
            robot.interact(() -> assertThat(pane.rows(attribute).getLast().lookup("#" + attribute.name())).isNotNull());
        }
        robot.interact(() -> assertThat(pane.rows(LightAttribute.TEXTURE).getLast().lookup("#light-texture")).isNotNull());
    }

    @Test
    void point_hasNoConeAndNoDirection(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        assertThat(disabled(robot)).containsExactlyInAnyOrder("angle", "dropoff", "direction");
        assertThat(robot.lookup("#aim").query().isDisabled()).isTrue();
    }

    @Test
    void directional_hasNoConeAndNoAttenuation(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.SUN));
        assertThat(disabled(robot)).containsExactlyInAnyOrder("angle", "dropoff", "constant", "linear", "quadratic");
    }

    @Test
    void withoutSelection_nothingIsEditable(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(null));
        assertThat(disabled(robot)).hasSameSizeAs(NUMBERS);
        assertThat(robot.lookup("#light-name").query().isDisabled()).isTrue();
    }

    @Test
    void withoutLights_showsNoOldValues(FxRobot robot) {
        for (Light light : model.editor().scene().lights()) {
            robot.interact(() -> model.editor().edit(scene -> LightEdits.delete(scene, light.name())));
        }
        Set<TextField> fields = robot
                .lookup(node -> node instanceof TextField && isIn(node, "properties"))
                .queryAllAs(TextField.class);
        assertThat(fields).hasSizeGreaterThan(10).allMatch(f -> f.getText().isEmpty());
        assertThat(robot.lookup("#light-type").queryAs(ComboBox.class).getValue()).isNull();
        assertThat(robot.lookup(".ikonli-font-icon").<Node>queryAll()).isNotEmpty().allMatch(Node::isDisabled);
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(field(robot, "intensity").getText()).isEqualTo("0.3");
    }

    @Test
    void hiddenPane_whenSelected_showsEdits(FxRobot robot) {
        robot.interact(() -> {
            tabSelected.set(false);
            String light = model.editor().selection().light().name();
            model.editor().edit(scene -> LightEdits.edit(scene, light, l -> l.withIntensity(0.75)));
        });
        assertThat(field(robot, "intensity").getText()).isNotEqualTo("0.75");
        robot.interact(() -> tabSelected.set(true));
        assertThat(field(robot, "intensity").getText()).isEqualTo("0.75");
    }

    private static boolean isIn(Node node, String id) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (id.equals(n.getId())) {
                return true;
            }
        }
        return false;
    }

    @Test
    void everyDial_showsAndSetsItsNumber(FxRobot robot) {
        List<String> others = LightAttribute.ALL.stream().filter(a -> !a.appliesTo(LightType.SPOT) || a == LightAttribute.SAMPLES
                || a.section() == LightAttribute.Section.FILTERS)
                .flatMap(AttributeNumber::ofLight).map(AttributeNumber::title).toList();
        for (AttributeNumber<?, ?> dial : AttributeNumber.ALL.stream()
                .filter(d -> d.isOfLight() && !others.contains(d.title())
                        && !List.of("red", "green", "blue").contains(d.title()))
                .toList()) {
            String value = dial.range().min() > 1.5 ? "3200" : "1.5";
            type(robot, dial.part().isEmpty() ? dial.attribute().id() : dial.part(), value);
            assertThat(dial.value(model.editor().scene(), TestEditors.SPOT)).as(dial.title()).isEqualTo(Double.parseDouble(value));
        }
    }

    @Test
    void clickOnAngleArrow_addsOneDegree(FxRobot robot) {
        Node pad = robot.lookup("#angle .arrow-pad").query();
        robot.clickOn(robot.point(pad).atPosition(Pos.CENTER).atOffset(0, -6));
        assertThat(TestEditors.light(model, TestEditors.SPOT).angle()).isEqualTo(26);
    }

    @Test
    void drag_isOneUndoStep(FxRobot robot) {
        Scene before = model.editor().scene();
        robot.drag("#intensity .arrow-pad").moveBy(0, -4).moveBy(0, -4).release(MouseButton.PRIMARY);
        assertThat(TestEditors.light(model, TestEditors.SPOT).intensity()).isEqualTo(1.2);
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(model.editor().scene()).isEqualTo(before);
        assertThat(model.commands().isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void invalidValue_showsReasonAndChangesNothing(FxRobot robot) {
        Scene before = model.editor().scene();
        type(robot, "angle", "200");
        assertThat(RefusalTexts.shown(robot)).containsExactly("cone half-angle must be from 0 to 180, was 200");
        assertThat(model.editor().scene()).isEqualTo(before);
        assertThat(model.commands().isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void selectingOtherLight_discardsTypedText(FxRobot robot) {
        type(robot, "angle", "200");
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        assertThat(RefusalTexts.shown(robot)).isEmpty();
        assertThat(field(robot, "angle").getText()).isEqualTo("30");
    }

    private void choose(FxRobot robot, String widget, String item) {
        robot.rightClickOn(widget);
        robot.clickOn(item);
    }

    @Test
    void copiedProperty_pastesToOtherLight(FxRobot robot) {
        type(robot, "intensity", "1/3");
        choose(robot, "#intensity .label", "Copy Intensity");
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        choose(robot, "#intensity .label", "Paste Intensity '0.3333333333333333'");
        assertThat(TestEditors.light(model, TestEditors.POINT).intensity()).isEqualTo(1.0 / 3);
    }

    @Test
    void copiedProperty_isNotOfferedForOtherProperty(FxRobot robot) {
        choose(robot, "#intensity .label", "Copy Intensity");
        robot.rightClickOn("#angle .label");
        MenuItem paste = Window.getWindows().stream().filter(ContextMenu.class::isInstance)
                .flatMap(w -> ((ContextMenu) w).getItems().stream()).filter(i -> i.getText().startsWith("Paste Cone half-angle"))
                .findFirst()
                .orElseThrow();
        assertThat(paste.isDisable()).isTrue();
    }

    @Test
    void reset_restoresDefault(FxRobot robot) {
        type(robot, "intensity", "7");
        choose(robot, "#intensity .label", "Reset Intensity");
        assertThat(TestEditors.light(model, TestEditors.SPOT).intensity()).isEqualTo(1);
    }

    @Test
    void undo_isShown(FxRobot robot) {
        type(robot, "intensity", "4");
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(field(robot, "intensity").getText()).isEqualTo("1");
    }

    @Test
    void lightUndo_keepsOtherLights(FxRobot robot) {
        type(robot, "intensity", "4");
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        type(robot, "intensity", "2");
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.SPOT));
        robot.clickOn("#undo-light");
        assertThat(TestEditors.light(model, TestEditors.SPOT).intensity()).isEqualTo(1);
        assertThat(TestEditors.light(model, TestEditors.POINT).intensity()).isEqualTo(2);
        robot.clickOn("#redo-light");
        assertThat(TestEditors.light(model, TestEditors.SPOT).intensity()).isEqualTo(4);
    }

    @Test
    void typedPositionAndDirection_moveTheLight(FxRobot robot) {
        type(robot, "position", "-7");
        type(robot, "direction", "0");
        Light light = TestEditors.light(model, TestEditors.SPOT);
        assertThat(light.position()).isEqualTo(new Vec3(-7, 5, 2));
        assertThat(light.direction()).isEqualTo(new Vec3(0, -4, -2));
    }

    @Test
    void typedChannel_changesColor(FxRobot robot) {
        type(robot, "color", "0.25");
        assertThat(TestEditors.light(model, TestEditors.SPOT).color()).isEqualTo(new Rgb(0.25, 1, 1));
    }

    @Test
    void temperature_isKeptNextToTheColor(FxRobot robot) {
        Light before = TestEditors.light(model, TestEditors.SPOT);
        type(robot, "temperature", "3200");
        assertThat(TestEditors.light(model, TestEditors.SPOT)).isEqualTo(before.withEmission(before.emission().withTemperature(3200)));
        robot.interact(() -> robot.lookup("Neutral").queryButton().fire());
        assertThat(TestEditors.light(model, TestEditors.SPOT)).isEqualTo(before);
    }

    @Test
    void exposureAndIntensity_bothStayAsEntered(FxRobot robot) {
        type(robot, "exposure", "3.5");
        type(robot, "intensity", "0.7");
        Light light = TestEditors.light(model, TestEditors.SPOT);
        assertThat(light.intensity()).isEqualTo(0.7);
        assertThat(light.emission().exposure()).isEqualTo(3.5);
    }

    @Test
    void attributesThatCannotAct_areNotShown(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        assertThat(robot.lookup("#angle").query().isManaged()).isFalse();
        assertThat(robot.lookup("#radius").query().isManaged()).isTrue();
        assertThat(robot.lookup("#samples").query().isManaged()).isFalse();
        assertThat(robot.lookup("#visible").query().getParent().isManaged()).isFalse();
        type(robot, "radius", "0.5");
        assertThat(robot.lookup("#samples").query().isManaged()).isTrue();
        robot.interact(() -> robot.lookup("#visible").queryComboBox().getSelectionModel().selectFirst());
        assertThat(LightAttribute.VISIBLE.get(TestEditors.light(model, TestEditors.POINT))).isTrue();
        assertThat(model.editor().editorStateProperty().get().undoLabel().orElse("")).contains("visible to camera no → yes");
        robot.interact(() -> robot.lookup("#falloff").queryComboBox().getSelectionModel().selectLast());
        assertThat(TestEditors.light(model, TestEditors.POINT).falloff()).isEqualTo(Falloff.INVERSE_SQUARE);
        assertThat(robot.lookup("#quadratic").query().isManaged()).isFalse();
    }

    @Test
    void unit_offersWhatSuitsTheLight(FxRobot robot) {
        ComboBox<IntensityUnit> units = robot.lookup("#unit").queryComboBox();
        assertThat(units.getItems()).extracting(units.getConverter()::toString).containsExactly("Relative", "Candela", "Lumen");
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.SUN));
        assertThat(units.getItems()).extracting(units.getConverter()::toString).containsExactly("Relative", "Lux");
    }

    @Test
    void typeChange_keepsSettings(FxRobot robot) {
        robot.interact(() -> robot.lookup("#light-type").queryAs(ComboBox.class).getSelectionModel().select(LightType.POINT));
        assertThat(TestEditors.light(model, TestEditors.SPOT).type()).isEqualTo(LightType.POINT);
        assertThat(TestEditors.light(model, TestEditors.SPOT).angle()).isEqualTo(25);
        assertThat(disabled(robot)).contains("angle");
    }

    @Test
    void settings_areCopiedToAnotherLight(FxRobot robot) {
        assertThat(robot.lookup("#paste-settings").query().isDisabled()).isTrue();
        robot.clickOn("#copy-settings");
        robot.interact(() -> model.editor().selection().selectLight(TestEditors.POINT));
        robot.clickOn("#paste-settings");
        Light pasted = TestEditors.light(model, TestEditors.POINT);
        assertThat(pasted.type()).isEqualTo(LightType.SPOT);
        assertThat(pasted.dropoff()).isEqualTo(4);
        assertThat(pasted.position()).isEqualTo(new Vec3(-3, 2, 4));
    }

    @Test
    void typedName_renamesLight(FxRobot robot) {
        rename(robot, "rim");
        assertThat(model.editor().selection().light().name()).isEqualTo("rim");
    }

    @Test
    void typedNameWithSpacesAndSymbols_renamesLight(FxRobot robot) {
        rename(robot, "Führungslicht 7.30");
        assertThat(model.editor().selection().light().name()).isEqualTo("Führungslicht 7.30");
        assertThat(robot.lookup("#light-name").queryAs(TextField.class).getText()).isEqualTo("Führungslicht 7.30");
    }

    @Test
    void duplicateName_showsReasonAndChangesNothing(FxRobot robot) {
        rename(robot, TestEditors.SUN);
        assertThat(RefusalTexts.shown(robot)).singleElement().asString().contains("'sun'").contains("already taken");
        assertThat(model.editor().selection().light().name()).isEqualTo(TestEditors.SPOT);
        robot.push(KeyCode.ESCAPE);
        assertThat(RefusalTexts.shown(robot)).isEmpty();
        assertThat(robot.lookup("#light-name").queryAs(TextField.class).getText()).isEqualTo(TestEditors.SPOT);
    }

    @Test
    void onToggle_saysOffWhenOff(FxRobot robot) {
        ToggleButton toggle = robot.lookup("#light-on").query();
        assertThat(toggle.getText()).isEqualTo("On");
        robot.clickOn(toggle);
        assertThat(toggle.getText()).isEqualTo("Off");
        robot.clickOn(toggle);
        assertThat(toggle.getText()).isEqualTo("On");
    }

    @Test
    void toggles_turnOffAndSolo(FxRobot robot) {
        robot.clickOn("#light-on").clickOn("#light-solo");
        Light light = TestEditors.light(model, TestEditors.SPOT);
        assertThat(light.on()).isFalse();
        assertThat(light.solo()).isTrue();
    }

    @Test
    void everyControl_isNamedForScreenReaders(FxRobot robot) {
        Set<Node> unnamed = robot.lookup(node -> node.isFocusTraversable() && node.getAccessibleText() == null
                && !(node instanceof Labeled labeled && labeled.getText() != null
                        && !labeled.getText().isEmpty())
                && !(node instanceof ScrollPane)).queryAll();
        assertThat(unnamed).isEmpty();
    }

    private static Set<String> disabled(FxRobot robot) {
        return NUMBERS.stream().filter(id -> field(robot, id).isDisabled()).collect(Collectors.toSet());
    }

    private static void rename(FxRobot robot, String name) {
        TextTyping.replace(robot, robot.lookup("#light-name").queryAs(TextField.class), name).push(KeyCode.ENTER);
    }

    /** Returns the first field of a widget. */
    private static TextField field(FxRobot robot, String id) {
        return robot.lookup("#" + id + " .number-field").queryAs(TextField.class);
    }

    private static void type(FxRobot robot, String id, String text) {
        TextTyping.replace(robot, field(robot, id), text).push(KeyCode.ENTER);
    }
}
