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
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.editor.document.BankEdits;
import lightning.editor.document.Command;
import lightning.editor.document.Dial;
import lightning.editor.document.Kelvin;
import lightning.editor.document.LightEdits;
import lightning.editor.window.JavaFxNeeds;
import lightning.editor.window.OnStage;
import lightning.editor.window.OpenEditor;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.Refusals;
import lightning.editor.window.widget.Typing;
import lightning.sample.Slow;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxNeeds.class, OnStage.class})
@Slow
class PropertyPaneTest {
    private static final List<String> NUMBERS = List.of("intensity", "angle", "dropoff", "constant", "linear", "quadratic",
            "position", "direction", "ambience");
    private static final List<String> SCENES = List.of("ambience", "environment-intensity", "environment-rotation", "environment-lamps",
            "environment-softness");

    @TempDir
    private Path folder;
    private final BooleanProperty inFront = new SimpleBooleanProperty(true);
    private EditorModel model;
    private PropertyPane pane;

    @Start
    private void start(Stage stage) throws Exception {
        model = OpenEditor.model(folder);
        var menu = new PropertyMenu(model.editor(), model.commands(), model.arrangement());
        pane = new PropertyPane(model.editor(), model.commands(), model.bringer(), menu, inFront);
        OpenEditor.show(stage, pane);
    }

    @Stop
    private void stop() {
        model.close();
    }

    @Test
    void spot_hasEverything(FxRobot robot) {
        assertThat(disabled(robot)).isEmpty();
    }

    /** As one picture all of it is drawn again for each number. */
    @Test
    void properties_areNotKeptAsOnePicture(FxRobot robot) {
        assertThat(robot.lookup(".properties .viewport").query().isCache()).isFalse();
    }

    /** No section of the pane has a choice now; one that gets one needs no other line than that of the attribute. */
    @Test
    void choiceOfALight_isABoxOfItsWordsThatEditsIt(FxRobot robot) {
        robot.interact(() -> ((VBox) ((ScrollPane) pane.getChildren().getFirst()).getContent()).getChildren()
                .addAll(pane.widgets(LightAttribute.SOLO)));
        ComboBox<String> box = robot.lookup("#solo").query();
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        assertThat(box.getItems()).containsExactly("Yes", "No");
        assertThat(box.getValue()).isEqualTo("No");
        robot.interact(() -> box.setValue("Yes"));
        assertThat(model.editor().selection().light().solo()).isTrue();
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.SUN));
        assertThat(box.getValue()).isEqualTo("No");
        assertThat(model.editor().selection().light().solo()).isFalse();
        robot.interact(() -> model.editor().selection().selectLight(null));
        assertThat(box.getValue()).isNull();
        assertThat(box.isDisabled()).isTrue();
    }

    /** Whatever its section: a table's attribute needs no line of the pane's. */
    @Test
    void everyAttribute_hasAControlThatCanBeUsedWhereItActs(FxRobot robot) {
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            robot.interact(() -> {
                var controls = new VBox();
                controls.getChildren().addAll(pane.widgets(attribute));
                assertThat(controls.getChildren()).as(attribute.title()).isNotEmpty();
                model.editor().selection().selectLight(null);
                assertThat(inputs(controls)).as(attribute.title()).isNotEmpty().allMatch(Node::isDisabled);
                for (Light light : model.editor().scene().lights()) {
                    model.editor().selection().selectLight(light.name());
                    boolean acts = attribute.acts(light.type()) || attribute == LightAttribute.POSITION;
                    assertThat(inputs(controls)).as(attribute.title() + " of " + light.name())
                            .allMatch(input -> input.isDisabled() != acts);
                }
            });
        }
    }

    private static List<Node> inputs(Node controls) {
        return Stream.of(".combo-box", ".menu-button", ".text-field").flatMap(css -> controls.lookupAll(css).stream()).toList();
    }

    @Test
    void nameOfALight_isABoxOfTheNamesInTheScene(FxRobot robot) {
        robot.interact(() -> {
            model.editor().edit(scene -> BankEdits.add(scene, OpenEditor.SUN));
            ((VBox) ((ScrollPane) pane.getChildren().getFirst()).getContent()).getChildren()
                    .setAll(pane.widgets(LightAttribute.BANK));
        });
        ComboBox<String> box = robot.lookup("#light-bank").query();
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        String bank = model.editor().scene().rig().banks().getFirst().name();
        assertThat(box.getItems()).containsExactly("", bank);
        assertThat(box.getValue()).isEmpty();
        robot.interact(() -> box.setValue(bank));
        assertThat(model.editor().selection().light().bank()).isEqualTo(bank);
        robot.interact(() -> box.setValue(""));
        assertThat(model.editor().selection().light().bank()).isEmpty();
    }

    @Test
    void fileOfALight_isItsOwn(FxRobot robot) {
        for (LightAttribute<?> attribute : List.of(LightAttribute.GOBO, LightAttribute.PROFILE)) {
            robot.interact(() -> assertThat(pane.widgets(attribute).getLast().lookup("#" + attribute.name())).isNotNull());
        }
    }

    @Test
    void point_hasNoConeAndNoDirection(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        assertThat(disabled(robot)).containsExactlyInAnyOrder("angle", "dropoff", "direction");
        assertThat(robot.lookup("#aim").query().isDisabled()).isTrue();
    }

    @Test
    void directional_hasNoConeAndNoAttenuation(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.SUN));
        assertThat(disabled(robot)).containsExactlyInAnyOrder("angle", "dropoff", "constant", "linear", "quadratic");
    }

    @Test
    void withoutASelection_onlyTheSceneCanBeEdited(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight(null));
        assertThat(disabled(robot)).hasSize(NUMBERS.size() - 1).doesNotContain("ambience");
        assertThat(robot.lookup("#light-name").query().isDisabled()).isTrue();
        type(robot, "ambience", "0.5");
        assertThat(model.editor().scene().world().ambience()).isEqualTo(0.5);
    }

    @Test
    void withoutLights_nothingOfTheLastOneIsShown(FxRobot robot) {
        for (Light light : model.editor().scene().lights()) {
            robot.interact(() -> model.editor().edit(scene -> LightEdits.delete(scene, light.name())));
        }
        Set<TextField> fields = robot
                .lookup(node -> node instanceof TextField && isIn(node, "properties") && SCENES.stream().noneMatch(id -> isIn(node, id)))
                .queryAllAs(TextField.class);
        assertThat(fields).hasSizeGreaterThan(10).allMatch(f -> f.getText().isEmpty());
        assertThat(robot.lookup("#light-type").queryAs(ComboBox.class).getValue()).isNull();
        assertThat(robot.lookup(".ikonli-font-icon").<Node>queryAll()).isNotEmpty().allMatch(Node::isDisabled);
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(field(robot, "intensity").getText()).isEqualTo("0.3");
    }

    @Test
    void behindAnother_showsWhatWasEditedWhenItComesInFront(FxRobot robot) {
        robot.interact(() -> {
            inFront.set(false);
            String light = model.editor().selection().light().name();
            model.editor().edit(scene -> LightEdits.with(scene, light, l -> l.withIntensity(0.75)));
        });
        assertThat(field(robot, "intensity").getText()).isNotEqualTo("0.75");
        robot.interact(() -> inFront.set(true));
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
        List<String> others = LightAttribute.ALL.stream().filter(a -> !a.acts(LightType.SPOT) || a == LightAttribute.SAMPLES)
                .flatMap(a -> Dial.of(a).stream()).map(Dial::title).toList();
        for (Dial dial : Dial.ALL.stream()
                .filter(d -> d != Dial.DEPTH && !d.title().startsWith("environment") && !others.contains(d.title())
                        && !List.of("red", "green", "blue").contains(d.title()))
                .toList()) {
            type(robot, dial.label(), "1.5");
            assertThat(dial.value(model.editor().scene(), OpenEditor.SPOT)).as(dial.title()).isEqualTo(1.5);
        }
    }

    @Test
    void clickOnTheAnglesArrow_turnsItByADegree(FxRobot robot) {
        Node pad = robot.lookup("#angle .arrow-pad").query();
        robot.clickOn(robot.point(pad).atPosition(Pos.CENTER).atOffset(0, -6));
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).angle()).isEqualTo(26);
    }

    @Test
    void drag_isOneStepToUndo(FxRobot robot) {
        Scene before = model.editor().scene();
        robot.drag("#intensity .arrow-pad").moveBy(0, -4).moveBy(0, -4).release(MouseButton.PRIMARY);
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).intensity()).isEqualTo(1.2);
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(model.editor().scene()).isEqualTo(before);
        assertThat(model.commands().isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void illegalValue_isMarkedWithTheReasonAndChangesNothing(FxRobot robot) {
        Scene before = model.editor().scene();
        type(robot, "angle", "200");
        assertThat(Refusals.shown(robot)).containsExactly("angle must be from 0 to 180, was 200");
        assertThat(model.editor().scene()).isEqualTo(before);
        assertThat(model.commands().isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void selectingAnotherLight_forgetsWhatWasTyped(FxRobot robot) {
        type(robot, "angle", "200");
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        assertThat(Refusals.shown(robot)).isEmpty();
        assertThat(field(robot, "angle").getText()).isEqualTo("30");
    }

    private void choose(FxRobot robot, String widget, String item) {
        robot.rightClickOn(widget);
        robot.clickOn(item);
    }

    @Test
    void copiedProperty_isPastedToAnotherLightAsTheFileWritesIt(FxRobot robot) {
        type(robot, "intensity", "1/3");
        choose(robot, "#intensity .label", "Copy Intensity");
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        choose(robot, "#intensity .label", "Paste Intensity '0.3333333333333333'");
        assertThat(OpenEditor.light(model, OpenEditor.POINT).intensity()).isEqualTo(1.0 / 3);
    }

    @Test
    void copiedProperty_isNotOfferedToAnother(FxRobot robot) {
        choose(robot, "#intensity .label", "Copy Intensity");
        robot.rightClickOn("#angle .label");
        MenuItem paste = Window.getWindows().stream().filter(ContextMenu.class::isInstance)
                .flatMap(w -> ((ContextMenu) w).getItems().stream()).filter(i -> i.getText().startsWith("Paste Angle")).findFirst()
                .orElseThrow();
        assertThat(paste.isDisable()).isTrue();
    }

    @Test
    void reset_bringsTheValueOfANewLight(FxRobot robot) {
        type(robot, "intensity", "7");
        choose(robot, "#intensity .label", "Reset Intensity");
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).intensity()).isEqualTo(1);
    }

    @Test
    void undo_isShown(FxRobot robot) {
        type(robot, "intensity", "4");
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(field(robot, "intensity").getText()).isEqualTo("1");
    }

    @Test
    void undoOfTheLight_leavesTheOthers(FxRobot robot) {
        type(robot, "intensity", "4");
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        type(robot, "intensity", "2");
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.SPOT));
        robot.clickOn("#undo-light");
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).intensity()).isEqualTo(1);
        assertThat(OpenEditor.light(model, OpenEditor.POINT).intensity()).isEqualTo(2);
        robot.clickOn("#redo-light");
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).intensity()).isEqualTo(4);
    }

    @Test
    void typedPositionAndDirection_moveTheLight(FxRobot robot) {
        type(robot, "position", "-7");
        type(robot, "direction", "0");
        Light light = OpenEditor.light(model, OpenEditor.SPOT);
        assertThat(light.position()).isEqualTo(new Vec3(-7, 5, 2));
        assertThat(light.direction()).isEqualTo(new Vec3(0, -4, -2));
    }

    @Test
    void typedChannel_coloursTheLight(FxRobot robot) {
        type(robot, "color", "0.25");
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).color()).isEqualTo(new Rgb(0.25, 1, 1));
    }

    @Test
    void temperature_keepsTheLightsBrightness(FxRobot robot) {
        robot.clickOn("Kelvin");
        type(robot, "color", "3200");
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).color()).isEqualTo(Kelvin.rgb(3200));
    }

    @Test
    void type_isChangedAndKeepsTheSettings(FxRobot robot) {
        robot.interact(() -> robot.lookup("#light-type").queryAs(ComboBox.class).getSelectionModel().select(LightType.POINT));
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).type()).isEqualTo(LightType.POINT);
        assertThat(OpenEditor.light(model, OpenEditor.SPOT).angle()).isEqualTo(25);
        assertThat(disabled(robot)).contains("angle");
    }

    @Test
    void settings_areCopiedToAnotherLight(FxRobot robot) {
        assertThat(robot.lookup("#paste-settings").query().isDisabled()).isTrue();
        robot.clickOn("#copy-settings");
        robot.interact(() -> model.editor().selection().selectLight(OpenEditor.POINT));
        robot.clickOn("#paste-settings");
        Light pasted = OpenEditor.light(model, OpenEditor.POINT);
        assertThat(pasted.type()).isEqualTo(LightType.SPOT);
        assertThat(pasted.dropoff()).isEqualTo(4);
        assertThat(pasted.position()).isEqualTo(new Vec3(-3, 2, 4));
    }

    @Test
    void typedName_renames(FxRobot robot) {
        rename(robot, "rim");
        assertThat(model.editor().selection().light().name()).isEqualTo("rim");
    }

    @Test
    void typedNameOfSpacesAndAnyLetters_renames(FxRobot robot) {
        rename(robot, "Führungslicht 7.30");
        assertThat(model.editor().selection().light().name()).isEqualTo("Führungslicht 7.30");
        assertThat(robot.lookup("#light-name").queryAs(TextField.class).getText()).isEqualTo("Führungslicht 7.30");
    }

    @Test
    void takenName_isMarkedWithTheReasonAndChangesNothing(FxRobot robot) {
        rename(robot, OpenEditor.SUN);
        assertThat(Refusals.shown(robot)).singleElement().asString().contains("'sun'").contains("already taken");
        assertThat(model.editor().selection().light().name()).isEqualTo(OpenEditor.SPOT);
        robot.push(KeyCode.ESCAPE);
        assertThat(Refusals.shown(robot)).isEmpty();
        assertThat(robot.lookup("#light-name").queryAs(TextField.class).getText()).isEqualTo(OpenEditor.SPOT);
    }

    @Test
    void switches_turnOffAndMakeSolo(FxRobot robot) {
        robot.clickOn("#light-on").clickOn("#light-solo");
        Light light = OpenEditor.light(model, OpenEditor.SPOT);
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
        Typing.over(robot, robot.lookup("#light-name").queryAs(TextField.class), name).push(KeyCode.ENTER);
    }

    /** The first field of a widget. */
    private static TextField field(FxRobot robot, String id) {
        return robot.lookup("#" + id + " .number-field").queryAs(TextField.class);
    }

    private static void type(FxRobot robot, String id, String text) {
        Typing.over(robot, field(robot, id), text).push(KeyCode.ENTER);
    }
}
