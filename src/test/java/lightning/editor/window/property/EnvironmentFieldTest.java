package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javafx.event.EventType;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.text.Text;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

class EnvironmentFieldTest extends EditorFixture {
    @BeforeEach
    void showWorld() {
        robot.interact(() -> model().commands().run(Command.EDIT_WORLD));
    }

    private MenuButton choice() {
        return robot.lookup("#environment").query();
    }

    private World world() {
        return model().editor().scene().world();
    }

    private String choiceText() {
        return world().environment().map(Environment::file).orElse("");
    }

    /** Environment of two pixels: warm on the left, dim on the right. */
    private void writeEnvironmentMap(String name) throws IOException {
        var bytes = new ByteArrayOutputStream();
        bytes.writeBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n".getBytes(StandardCharsets.ISO_8859_1));
        bytes.writeBytes(new byte[] {(byte) 128, 96, 64, (byte) 129, 16, 16, 32, (byte) 128});
        Files.write(Files.createDirectories(folder.resolve("textures")).resolve(name), bytes.toByteArray());
    }

    private void choose(String name) {
        robot.interact(() -> choice().getOnShowing().handle(null));
        waitFor("the menu lists the file", () -> item(name).isPresent());
        robot.interact(item(name).orElseThrow()::fire);
    }

    /** Reads the menu in the window's thread, which may be filling it. */
    private Optional<MenuItem> item(String name) {
        return WaitForAsyncUtils.waitForAsyncFx(TimeUnit.SECONDS.toMillis(10),
                () -> choice().getItems().stream().filter(i -> name.equals(i.getText())).findFirst());
    }

    private void type(String dial, String number) {
        TextField field = robot.from(robot.lookup("#" + dial).<Node>query()).lookup((Node n) -> n instanceof TextField).query();
        robot.interact(() -> {
            field.requestFocus();
            field.setText(number);
        });
        robot.push(KeyCode.ENTER);
    }

    @Test
    void laterEnvironment_keepsTheSettings() throws IOException {
        writeEnvironmentMap("a.hdr");
        writeEnvironmentMap("b.hdr");
        choose("a.hdr");
        waitFor("the file is read", () -> choiceText().equals("a.hdr"));
        assertThat(world().own().lightCount()).isEqualTo(16);
        type("environment-bright-lights", "20");
        choose("b.hdr");
        waitFor("the file is read", () -> choiceText().equals("b.hdr"));
        assertThat(world().own().lightCount()).isEqualTo(20);
    }

    @Test
    void studioOfTheProgram_isCopiedNextToTheScene() throws IOException {
        Files.createDirectories(folder.resolve("textures"));
        System.setProperty("lightning.home", Path.of("").toAbsolutePath().toString());
        try {
            choose("studio_ring.hdr");
            waitFor("the file is read", () -> choiceText().equals("studio_ring.hdr"));
        } finally {
            System.clearProperty("lightning.home");
        }
        assertThat(folder.resolve("textures/studio_ring.hdr")).hasSameBinaryContentAs(Path.of("textures/studio_ring.hdr"));
    }

    private Tab tab(String id) {
        return robot.lookup("#lists").queryAs(TabPane.class).getTabs().stream().filter(t -> id.equals(t.getId())).findFirst().orElseThrow();
    }

    @Test
    void solo_darkensLightsUntilItIsUndone() throws IOException {
        writeEnvironmentMap("a.hdr");
        choose("a.hdr");
        waitFor("the file is read", () -> choiceText().equals("a.hdr"));
        click("world-solo");
        assertThat(world().own().solo()).isTrue();
        assertThat(model().editor().scene().lights()).noneMatch(model().editor().scene()::isActive);
        assertThat(tab("world-tab").getGraphic()).as("mark of the solo, also while the lights are listed").isNotNull();
        assertThat(tab("world-tab").getTooltip().getText()).contains("mutes all lights");
        assertThat(model().editor().editorStateProperty().get().undoLabel().orElse("")).startsWith("environment solo no → yes");
        click("undo");
        assertThat(world().own().solo()).isFalse();
        assertThat(tab("world-tab").getGraphic()).isNull();
        assertThat(robot.lookup("#world-solo").queryAs(CheckBox.class).isSelected()).isFalse();
    }

    @Test
    void picture_rotatesEnvironmentByDragAndKeys() throws IOException {
        writeEnvironmentMap("a.hdr");
        assertThat(isShown("environment-picture")).isFalse();
        choose("a.hdr");
        waitFor("the picture is shown", () -> isShown("environment-picture"));
        Node picture = robot.lookup("#environment-picture").query();
        robot.interact(() -> {
            fire(picture, MouseEvent.MOUSE_PRESSED, 100);
            fire(picture, MouseEvent.MOUSE_DRAGGED, 120);
            fire(picture, MouseEvent.MOUSE_DRAGGED, 172);
            fire(picture, MouseEvent.MOUSE_RELEASED, 172);
        });
        // A quarter of its width to the right.
        assertThat(world().own().rotation().rotation()).isEqualTo(-90);
        robot.push(KeyCode.LEFT);
        assertThat(world().own().rotation().rotation()).isEqualTo(-85);
        click("undo");
        click("undo");
        assertThat(world().own().rotation().rotation()).isZero();
    }

    private static void fire(Node node, EventType<MouseEvent> type, double x) {
        node.fireEvent(new MouseEvent(type, x, 10, x, 10, MouseButton.PRIMARY, 1, false, false, false, false, true, false, false, false,
                false, true, null));
    }

    @Test
    void environmentMapNextToScene_lightsItAndIsUndone() throws IOException {
        writeEnvironmentMap("red_dusk.hdr");
        Scene before = model().editor().scene();
        choose("red_dusk.hdr");
        waitFor("the file is read", () -> choiceText().equals("red_dusk.hdr"));
        assertThat(robot.from(choice()).lookup((Node n) -> n instanceof Text t && t.getText().equals("red_dusk.hdr")).tryQuery())
                .as("name with underscore").isPresent();
        assertThat(model().editor().editorStateProperty().get().undoLabel().orElse(""))
                .startsWith("environment none → red_dusk.hdr");
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(choice().getText()).isEqualTo("none");
    }

    @Test
    void environmentNumbers_withoutEnvironment_areNotShown() throws IOException {
        Stream.of("intensity", "rotation", "bright-lights", "shadow-smoothing").map(n -> robot.lookup("#environment-" + n).<Node>query())
                .forEach(dial -> assertThat(dial.getParent().isVisible()).isFalse());
        writeEnvironmentMap("dusk.hdr");
        choose("dusk.hdr");
        waitFor("the file is read", () -> choiceText().equals("dusk.hdr"));
        robot.interact(() -> model().editor().selection().selectLight(null));
        type("environment-intensity", "2.5");
        type("environment-rotation", "-30");
        type("environment-shadow-smoothing", "0.5");
        type("environment-bright-lights", "7");
        assertThat(world().own().intensity()).isEqualTo(2.5);
        assertThat(world().own().rotation().rotation()).isEqualTo(-30);
        assertThat(world().own().lightCount()).isEqualTo(7);
        assertThat(world().own().softness()).isEqualTo(0.5);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("environment bright lights 16 → 7");
        choose("None");
        waitFor("the file is removed", () -> choiceText().isEmpty());
        assertThat(world().own().rotation().rotation()).as("rotation is kept").isEqualTo(-30);
    }

    @Test
    void invalidEnvironmentMap_showsError() throws IOException {
        Files.writeString(Files.createDirectories(folder.resolve("textures")).resolve("fake.hdr"), "no picture");
        choose("fake.hdr");
        waitFor("the file is refused", () -> model().editor().message().textProperty().get().contains("fake.hdr"));
        assertThat(choiceText()).isEmpty();
        assertThat(isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void environmentInMixer_isNamedOnOneLine() throws IOException {
        writeEnvironmentMap("red_dusk.hdr");
        choose("red_dusk.hdr");
        waitFor("the file is read", () -> choiceText().equals("red_dusk.hdr"));
        floatPanels();
        robot.push(KeyCode.F4);
        Label name = robot.from(robot.lookup("#strip-head-environment").<Node>query()).lookup((Node n) -> n instanceof Label).query();
        waitFor("the strip is laid out", () -> name.getWidth() > 0);
        assertThat(name.getWidth()).isGreaterThanOrEqualTo(name.prefWidth(-1));
    }

    @Test
    void muteInMixer_keepsIntensity() throws IOException {
        writeEnvironmentMap("dusk.hdr");
        choose("dusk.hdr");
        waitFor("the file is read", () -> choiceText().equals("dusk.hdr"));
        type("environment-intensity", "2.5");
        floatPanels();
        robot.push(KeyCode.F4);
        waitFor("the strip exists", () -> robot.lookup("#mute-environment").tryQuery().isPresent());
        click("mute-environment");
        assertThat(world().own().gain()).isZero();
        assertThat(world().own().intensity()).isEqualTo(2.5);
        click("mute-environment");
        assertThat(world().own().gain()).isEqualTo(1);
        click("solo-environment");
        assertThat(world().own().solo()).isTrue();
    }
}
