package lightning.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Scene to measure.
 *
 * @param name    file name without extension; unique in a run
 * @param file    source file for cold-start processes; null if none, which skips them
 * @param options options by which {@code lightning render} shows this scene from its file
 */
public record NamedScene(String name, Scene scene, @Nullable Path file, List<String> options) {
    public NamedScene {
        options = List.copyOf(options);
    }

    /** Creates a scene as in its file. */
    public NamedScene(String name, Scene scene, @Nullable Path file) {
        this(name, scene, file, List.of());
    }

    /**
     * Returns the scene without indirect light. All parts except that of indirect light measure it, because POV-Ray's images have none, and
     * results from before stay comparable.
     */
    NamedScene withoutIndirect() {
        return scene.picture().indirect().isEmpty() ? this : new NamedScene(name, withIndirect(Optional.empty()), file,
                List.of("--no-indirect"));
    }

    /** Returns the scene with other indirect light, or without. */
    Scene withIndirect(Optional<IndirectSettings> settings) {
        return scene.withPicture(scene.picture().withIndirect(settings));
    }
}
