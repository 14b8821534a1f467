package lightning.editor.window;

import java.nio.file.Path;
import lightning.base.file.CacheFolder;
import lightning.base.file.ShippedFile;

/** Paths of the editor's data folder and of its default scene. */
final class EditorPaths {
    private EditorPaths() {}

    /**
     * Returns the folder of preferences and unsaved scenes: the system property {@code lightning.data}, or {@code .lightning} in the user's
     * home.
     */
    static Path dataFolder() {
        String property = System.getProperty("lightning.data");
        return property != null ? Path.of(property) : Path.of(System.getProperty("user.home"), ".lightning");
    }

    /**
     * Returns the folder of kept pictures: in the data folder that {@code lightning.data} names, else where the system keeps what programs can
     * compute again.
     */
    static Path pictureFolder() {
        return System.getProperty("lightning.data") != null ? dataFolder().resolve("pictures") : CacheFolder.ofUser().resolve("pictures");
    }

    /** Returns the scene that opens when none is named. */
    static Path defaultScene() {
        return ShippedFile.resolve(ShippedFile.SCENES.resolve("stage.jen"));
    }
}
