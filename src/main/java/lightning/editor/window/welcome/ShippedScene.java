package lightning.editor.window.welcome;

import java.nio.file.Path;
import java.util.List;
import javafx.scene.image.Image;
import lightning.base.file.ShippedFile;
import lightning.base.text.Messages;
import lightning.format.jen.JenFile;

/**
 * Scene that comes with the program, with its thumbnail.
 *
 * @param name name of the scene's file, without its ending
 * @param title English title
 */
record ShippedScene(String name, String title) {
    /** Size of a stored thumbnail, pixels: twice the displayed size, for screens at scale 2. */
    static final int THUMBNAIL_WIDTH = 304;
    static final int THUMBNAIL_HEIGHT = 190;

    /** All scenes, in the order of the page: the most attractive first, those of the 1998 paper last. */
    static final List<ShippedScene> ALL = List.of(
            new ShippedScene("stage", Messages.key("Theater Stage")),
            new ShippedScene("concert", Messages.key("Concert in Haze (Shot)")),
            new ShippedScene("shop_window", Messages.key("Shop Window")),
            new ShippedScene("product", Messages.key("Glass and Cognac")),
            new ShippedScene("still_life", Messages.key("Still Life")),
            new ShippedScene("window", Messages.key("Room by a Window")),
            new ShippedScene("hall", Messages.key("Hall of Columns")),
            new ShippedScene("softbox", Messages.key("Soft Shadows")),
            new ShippedScene("arbor", Messages.key("Arbor")),
            new ShippedScene("night", Messages.key("Street at Night")),
            new ShippedScene("landscape", Messages.key("Mountain Lake")),
            new ShippedScene("dusk", Messages.key("Dusk (Shot)")),
            new ShippedScene("lanterns", Messages.key("Lanterns")),
            new ShippedScene("orange", Messages.key("Key, Fill and Rim")),
            new ShippedScene("spaceship", Messages.key("Spaceship")),
            new ShippedScene("desk", Messages.key("Desk")),
            new ShippedScene("house", Messages.key("House")),
            new ShippedScene("balls", Messages.key("Mirror Balls")),
            new ShippedScene("bird", Messages.key("Bird")));

    /** Returns the path of the scene. */
    Path file() {
        return ShippedFile.resolve(ShippedFile.SCENES.resolve(name + JenFile.EXTENSION));
    }

    /** Starts to load the thumbnail in the background. */
    Image thumbnail() {
        return new Image(String.valueOf(ShippedScene.class.getResource(name + ".jpg")), true);
    }
}
