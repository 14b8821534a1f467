package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Optional;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javax.imageio.ImageIO;
import lightning.document.LightEdits;
import lightning.editor.window.EditorFixture;
import lightning.scene.Scene;
import lightning.scene.asset.LightTexture;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class LightTextureFieldTest extends EditorFixture {
    private MenuButton choice() {
        return robot.lookup("#light-texture").query();
    }

    private void choose(String name) {
        robot.interact(() -> choice().getOnShowing().handle(null));
        waitFor("the menu lists the file", () -> choice().getItems().stream().anyMatch(i -> name.equals(i.getText())));
        MenuItem item = choice().getItems().stream().filter(i -> name.equals(i.getText())).findFirst().orElseThrow();
        robot.interact(item::fire);
    }

    private Optional<String> file() {
        return light("stage").texture().map(LightTexture::file);
    }

    @Test
    void imageNextToScene_isShownOnTheFace_andUndone() throws IOException {
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xff8000);
        ImageIO.write(image, "png", Files.createDirectories(folder.resolve("textures")).resolve("film.png").toFile());
        robot.interact(() -> {
            model().editor().selection().selectLight("stage");
            model().editor().edit(scene -> LightEdits.setType(scene, "stage", LightType.RECT));
        });
        Scene before = model().editor().scene();
        choose("film.png");
        waitFor("the file is read", () -> file().equals(Optional.of("film.png")));
        assertThat(choice().getText()).isEqualTo("film.png");
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(before);
        choose("film.png");
        waitFor("the file is read", () -> file().isPresent());
        choose("None");
        waitFor("the file is removed", () -> file().isEmpty());
    }
}
