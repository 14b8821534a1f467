package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javax.imageio.ImageIO;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.scene.Scene;
import lightning.scene.asset.Gobo;
import org.junit.jupiter.api.Test;

class GoboFieldTest extends EditorFixture {
    private MenuButton choice() {
        return robot.lookup("#gobo").query();
    }

    private void select(String light) {
        robot.interact(() -> model().editor().selection().selectLight(light));
    }

    private void picture(String name) throws IOException {
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xffffff);
        image.setRGB(1, 1, 0xffffff);
        ImageIO.write(image, "png", Files.createDirectories(folder.resolve("textures")).resolve(name).toFile());
    }

    private void choose(String name) {
        robot.interact(() -> choice().getOnShowing().handle(null));
        waitFor("the menu lists the file", () -> choice().getItems().stream().anyMatch(i -> name.equals(i.getText())));
        MenuItem item = choice().getItems().stream().filter(i -> name.equals(i.getText())).findFirst().orElseThrow();
        robot.interact(item::fire);
    }

    @Test
    void otherTextures_areInSubmenuBelowGobos() throws IOException {
        picture("brick.png");
        picture("gobo_leaves.png");
        picture("window_gobo.png");
        select("stage");
        robot.interact(() -> choice().getOnShowing().handle(null));
        waitFor("the menu lists the files", () -> choice().getItems().stream().anyMatch(i -> "gobo_leaves.png".equals(i.getText())));
        assertThat(choice().getItems().stream().map(MenuItem::getText).filter(Objects::nonNull))
                .containsExactly("None", "Browse…", "gobo_leaves.png", "window_gobo.png", "Other Textures");
        MenuItem brick = ((Menu) choice().getItems().getLast()).getItems().getFirst();
        assertThat(brick.getText()).isEqualTo("brick.png");
        robot.interact(brick::fire);
        waitFor("the file is read", () -> light("stage").gobo().map(Gobo::file).orElse("").equals("brick.png"));
    }

    @Test
    void pictureNextToScene_isProjectedAndUndone() throws IOException {
        picture("dots.png");
        Scene before = model().editor().scene();
        select("stage");
        choose("dots.png");
        waitFor("the file is read", () -> light("stage").gobo().map(Gobo::file).orElse("").equals("dots.png"));
        assertThat(choice().getText()).isEqualTo("dots.png");
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(choice().getText()).isEqualTo("none");
    }

    @Test
    void browsedPicture_isCopiedToTexturesAndProjected_unlessBroken() throws IOException {
        // Otherwise the textures of a parent folder would be used.
        Files.createDirectories(folder.resolve("textures"));
        select("stage");
        answer = Files.write(Files.createDirectories(folder.resolve("elsewhere")).resolve("torn.png"), new byte[] {(byte) 137, 80});
        choose("Browse…");
        waitFor("the refusal is shown", () -> model().editor().message().textProperty().get().contains("'torn.png'"));
        assertThat(folder.resolve("textures/torn.png")).doesNotExist();
        picture("dots.png");
        answer = Files.move(folder.resolve("textures/dots.png"), folder.resolve("elsewhere/dots.png"));
        choose("Browse…");
        waitFor("the file is read", () -> light("stage").gobo().map(Gobo::file).orElse("").equals("dots.png"));
        assertThat(folder.resolve("textures/dots.png")).hasSameBinaryContentAs(answer);
        assertGoShowsTheScene();
    }

    /** With an editor of its own, since it takes the place of the file dialog. */
    @Test
    @OwnEditor
    void menu_whenBrowsing_isHidden() {
        select("stage");
        List<Boolean> open = new ArrayList<>();
        robot.interact(() -> model().fileImporter().setFilePrompt((_, _) -> {
            open.add(choice().isShowing());
            return Optional.empty();
        }));
        // The headless platform cannot draw a menu that is partly off the screen.
        robot.interact(() -> {
            choice().show();
            choice().getItems().get(1).fire();
            choice().hide();
        });
        assertThat(open).containsExactly(false);
    }

    @Test
    void none_removesGobo() throws IOException {
        picture("dots.png");
        select("stage");
        choose("dots.png");
        waitFor("the file is read", () -> light("stage").gobo().isPresent());
        choose("None");
        waitFor("the file is removed", () -> light("stage").gobo().isEmpty());
    }

    @Test
    void nonSpotLight_disablesGoboWithReason() {
        select("lamp");
        assertThat(choice().isDisabled()).isTrue();
        select("stage");
        assertThat(choice().isDisabled()).isFalse();
    }

    @Test
    void missingPicture_showsError() throws IOException {
        picture("dots.png");
        select("stage");
        robot.interact(() -> choice().getOnShowing().handle(null));
        // A later listing may no longer have the item.
        var item = new AtomicReference<MenuItem>();
        waitFor("the menu lists the file", () -> {
            choice().getItems().stream().filter(i -> "dots.png".equals(i.getText())).findFirst().ifPresent(item::set);
            return item.get() != null;
        });
        Files.delete(folder.resolve("textures").resolve("dots.png"));
        robot.interact(item.get()::fire);
        waitFor("the file is refused", () -> model().editor().message().textProperty().get().contains("dots.png"));
        assertThat(light("stage").gobo()).isEmpty();
        assertThat(isEnabled(Command.UNDO)).isFalse();
    }
}
