package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.control.TitledPane;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.TextTyping;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import org.junit.jupiter.api.Test;

class MaterialPaneTest extends EditorFixture {
    private static final Vec3 BALL = new Vec3(0, 1, 0);

    private Material material(String name) {
        return model().editor().scene().materialsByName().get(name);
    }

    private String edited() {
        return robot.lookup("#material-name").<ComboBox<String>>query().getValue();
    }

    private String tab() {
        return robot.lookup("#side").<TabPane>query().getSelectionModel().getSelectedItem().getId();
    }

    /** Unfolds the section of the node, as a user would. */
    private void unfold(String widget) {
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        robot.interact(() -> section(widget).setExpanded(true));
    }

    private TitledPane section(String widget) {
        return Stream.iterate(robot.lookup("#" + widget).<Node>query(), Node::getParent).filter(TitledPane.class::isInstance)
                .map(TitledPane.class::cast).findFirst().orElseThrow();
    }

    private void type(String field, String value) {
        unfold(field);
        TextTyping.replace(robot, robot.lookup("#" + field).queryAs(TextField.class), value).push(KeyCode.ENTER);
    }

    private void typeRed(String color, String value) {
        unfold(color);
        TextField red = robot.lookup("#" + color + " .number-field").queryAll().stream()
                .filter(n -> (color + " red").equals(n.getAccessibleText())).map(TextField.class::cast).findFirst().orElseThrow();
        TextTyping.replace(robot, red, value).push(KeyCode.ENTER);
    }

    private void chooseFromMenu() {
        waitFor("the menu is open", () -> robot.lookup("Edit Material matt of ball").tryQuery().isPresent());
        robot.clickOn("Edit Material matt of ball");
        waitFor("the material tab is selected", () -> tab().equals("material-tab"));
    }

    private void picture(String name) throws IOException {
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xff8000);
        ImageIO.write(image, "png", Files.createDirectories(folder.resolve("textures")).resolve(name).toFile());
    }

    /** Scrolls to the node first if needed. */
    private void scrollTo(String widget) {
        robot.interact(() -> {
            Node node = robot.lookup(widget).query();
            ScrollPane pane = (ScrollPane) Stream.iterate(node, Node::getParent).filter(ScrollPane.class::isInstance).findFirst()
                    .orElseThrow();
            pane.layout();
            Bounds at = pane.getContent().sceneToLocal(node.localToScene(node.getBoundsInLocal()));
            double room = pane.getViewportBounds().getHeight();
            pane.setVvalue(Math.clamp((at.getCenterY() - room / 2) / (pane.getContent().getBoundsInLocal().getHeight() - room), 0, 1));
            pane.layout();
        });
    }

    private void chooseProperty(String widget, String item) {
        scrollTo(widget);
        robot.rightClickOn(widget + " .label");
        waitFor("the menu is open", () -> robot.lookup(item).tryQuery().isPresent());
        robot.clickOn(item);
    }

    @Test
    void copiedProperty_pastesToOtherMaterialAndResets() {
        robot.interact(() -> model().materials().choose("matt"));
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        chooseProperty("#shininess", "Copy Shininess");
        robot.interact(() -> model().materials().choose("mirror"));
        chooseProperty("#shininess", "Paste Shininess '20'");
        assertThat(material("mirror").shininess()).isEqualTo(20);
        assertThat(model().editor().editorStateProperty().get().undoLabel())
                .hasValueSatisfying(step -> assertThat(step).contains("mirror: shininess"));
        chooseProperty("#shininess", "Reset Shininess");
        assertThat(material("mirror").shininess()).isEqualTo(MaterialAttribute.SHININESS.initial());
        assertGoShowsTheScene();
    }

    private Path pictureInOtherFolder(int rgb) throws IOException {
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, rgb);
        Path file = Files.createDirectories(folder.resolve("elsewhere/deep")).resolve("tiles.png");
        ImageIO.write(image, "png", file.toFile());
        return file;
    }

    private void browse() {
        robot.interact(() -> robot.lookup("#texture-found").<MenuButton>query().getItems().stream()
                .filter(item -> "Browse…".equals(item.getText())).findFirst().orElseThrow().fire());
    }

    @Test
    void browsedPicture_isCopiedToTextures_andReplacesOnlyAfterConfirmation() throws IOException {
        robot.interact(() -> model().materials().choose("matt"));
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        // Otherwise the textures of a parent folder would be used.
        Files.createDirectories(folder.resolve("textures"));
        answer = pictureInOtherFolder(0xff8000);
        browse();
        waitFor("the texture is loaded", () -> material("matt").texture().isPresent());
        assertThat(material("matt").texture().orElseThrow().file()).isEqualTo("tiles.png");
        Path copy = folder.resolve("textures/tiles.png");
        assertThat(copy).hasSameBinaryContentAs(answer);
        byte[] first = Files.readAllBytes(copy);
        pictureInOtherFolder(0x0080ff);
        browse();
        waitFor("the conflict is shown", () -> text("texture-refusal").contains("Choose the file again to overwrite it"));
        assertThat(copy).hasBinaryContent(first);
        browse();
        waitFor("the file is overwritten", () -> text("texture-refusal").isEmpty());
        assertThat(copy).hasSameBinaryContentAs(answer);
        assertGoShowsTheScene();
    }

    @Test
    void droppedPicture_isCopiedToTexturesAndShown() throws IOException {
        robot.interact(() -> model().materials().choose("matt"));
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        Files.createDirectories(folder.resolve("textures"));
        Path picture = pictureInOtherFolder(0xff8000);
        waitFor("the texture field is there", () -> robot.lookup("#texture").tryQuery().isPresent());
        TextureField field = Stream.iterate((Node) robot.lookup("#texture").query(), Node::getParent)
                .filter(TextureField.class::isInstance).map(TextureField.class::cast).findFirst().orElseThrow();
        var taken = new AtomicBoolean(true);
        robot.interact(() -> taken.set(field.drop(List.of(folder.resolve("a.txt").toFile()))));
        assertThat(taken).isFalse();
        robot.interact(() -> taken.set(field.drop(List.of(folder.resolve("a.txt").toFile(), picture.toFile()))));
        assertThat(taken).isTrue();
        waitFor("the texture is loaded", () -> material("matt").texture().isPresent());
        assertThat(material("matt").texture().orElseThrow().file()).isEqualTo("tiles.png");
        assertThat(folder.resolve("textures/tiles.png")).hasSameBinaryContentAs(picture);
    }

    @Test
    void copiedPosition_pastesToOtherShape() {
        robot.interact(() -> model().editor().selection().selectNode("ball"));
        chooseProperty("#shape-at", "Copy Position");
        robot.interact(() -> model().editor().selection().selectNode("floor"));
        chooseProperty("#shape-at", "Paste Position '0 1 0'");
        assertThat(model().editor().scene().stage().node("floor").orElseThrow().placement().position()).isEqualTo(new Vec3(0, 1, 0));
        chooseProperty("#shape-at", "Reset Position");
        assertThat(model().editor().scene().stage().node("floor").orElseThrow().placement().position()).isEqualTo(Vec3.ZERO);
    }

    @Test
    void rightClickInPicture_offersMaterial() {
        assertThat(tab()).isEqualTo("light-tab");
        robot.clickOn("#traced-picture", MouseButton.SECONDARY);
        chooseFromMenu();
        assertThat(edited()).isEqualTo("matt");
        assertThat(text("material-users")).isEqualTo("Used by ball");
    }

    @Test
    void rightClickInPreview_offersMaterial() {
        robot.interact(() -> model().materials().choose("mirror"));
        robot.clickOn(toScreen(BALL), MouseButton.SECONDARY);
        chooseFromMenu();
        assertThat(edited()).isEqualTo("matt");
    }

    @Test
    void pickedShape_showsMaterialUntilLightIsSelected() {
        robot.interact(() -> model().materials().choose("mirror"));
        robot.interact(() -> model().commands().run(Command.PICK_MATERIAL));
        assertThat(text("prompt")).startsWith("Click an object to edit its material");
        robot.clickOn("#traced-picture");
        waitFor("the material tab is selected", () -> tab().equals("material-tab"));
        assertThat(edited()).isEqualTo("matt");
        robot.interact(() -> model().editor().selection().selectLight("sun"));
        assertThat(tab()).isEqualTo("light-tab");
    }

    @Test
    void diffuse_isRenderedByGoAndUndone() {
        Scene before = model().editor().scene();
        robot.interact(() -> model().materials().choose("matt"));
        long frames = model().previewSettings().framesProperty().get();
        typeRed("diffuse", "0.25");
        assertThat(material("matt").diffuse()).isEqualTo(new Rgb(0.25, 0.7, 0.6));
        waitFor("the preview is drawn", () -> model().previewSettings().framesProperty().get() > frames);
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(isEnabled(Command.GO)).isTrue();
    }

    @Test
    void everyNumber_canBeEdited() {
        robot.interact(() -> model().materials().choose("matt"));
        typeRed("specular", "0.5");
        typeRed("reflective", "0.75");
        typeRed("ambient", "2000");
        typeRed("glow", "30");
        type("shininess .number-field", "40");
        Material matt = material("matt");
        assertThat(matt.specular().r()).isEqualTo(0.5);
        assertThat(matt.reflective().r()).isEqualTo(0.75);
        assertThat(matt.ambient().r()).isEqualTo(2000);
        assertThat(matt.glow().r()).isEqualTo(30);
        assertThat(matt.shininess()).isEqualTo(40);
    }

    @Test
    void valueOutOfRange_isRefused() {
        Scene before = model().editor().scene();
        typeRed("diffuse", "2");
        assertThat(robot.lookup("diffuse red must be from 0 to 1, was 2").tryQuery()).isPresent();
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void texture_isLoadedPlacedAndRemoved() throws IOException {
        picture("dots.png");
        robot.interact(() -> {
            model().materials().choose("matt");
            model().editor().materialShownProperty().set(true);
        });
        assertThat(robot.lookup("#repeat-u .number-field").query().isDisabled()).isTrue();
        type("texture", "dots.png");
        waitFor("the file is read", () -> material("matt").texture().isPresent());
        type("repeat-u .number-field", "3");
        assertThat(material("matt").texture().orElseThrow().repeatU()).isEqualTo(3);
        type("texture-offset-v .number-field", "0.25");
        type("texture-rotation .number-field", "30");
        assertThat(material("matt").texture().orElseThrow().placement()).isEqualTo(new TexturePlacement(0, 0.25, 30));
        click("go");
        waitForPicture();
        type("texture", " ");
        assertThat(material("matt").texture()).isEmpty();
    }

    @Test
    void bumpMap_isLoadedScaledAndRemoved() throws IOException {
        picture("dots.png");
        robot.interact(() -> {
            model().materials().choose("matt");
            model().editor().materialShownProperty().set(true);
        });
        assertThat(robot.lookup("#bump-repeat-u .number-field").query().isDisabled()).isTrue();
        type("bump", "dots.png");
        waitFor("the file is read", () -> material("matt").bumpMapping().bump().isPresent());
        type("height .number-field", "0.2");
        assertThat(material("matt").bumpMapping().height()).isEqualTo(0.2);
        assertThat(material("matt").texture()).isEmpty();
        click("go");
        waitForPicture();
        type("bump", " ");
        assertThat(material("matt").bumpMapping().bump()).isEmpty();
    }

    @Test
    void unusedSection_isFolded_untilItIsUsedOrUnfolded() {
        robot.interact(() -> {
            model().materials().choose("matt");
            model().editor().materialShownProperty().set(true);
        });
        assertThat(section("diffuse").isExpanded()).isTrue();
        assertThat(section("transparency").isExpanded()).isFalse();
        robot.interact(() -> model().editor()
                .edit(scene -> EditOutcome.edit(scene, new SceneElement.OfMaterial("matt"),
                        material -> MaterialAttribute.TRANSMISSION_COLOR.with(material, Rgb.WHITE))));
        assertThat(section("transparency").isExpanded()).isTrue();
        robot.interact(() -> model().materials().choose("mirror"));
        assertThat(section("transparency").isExpanded()).isFalse();
        unfold("transparency");
        click("undo");
        robot.interact(() -> model().materials().choose("matt"));
        assertThat(section("transparency").isExpanded()).isTrue();
    }

    @Test
    void missingTexture_showsError() {
        type("texture", "missing.png");
        waitFor("the file is refused",
                () -> text("texture-refusal").startsWith("material 'matt': there is no texture 'missing.png' in the folder"));
        assertThat(isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void texturesNextToScene_areOffered() throws IOException {
        picture("dots.png");
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        MenuButton found = robot.lookup("#texture-found").query();
        robot.interact(() -> found.getOnShowing().handle(null));
        waitFor("the menu lists the file", () -> found.getItems().stream().anyMatch(i -> "dots.png".equals(i.getText())));
        MenuItem dots = found.getItems().stream().filter(i -> "dots.png".equals(i.getText())).findFirst().orElseThrow();
        assertThat(dots.getGraphic()).isInstanceOf(ImageView.class);
        robot.interact(dots::fire);
        waitFor("the file is read", () -> material(edited()).texture().isPresent());
    }
}
