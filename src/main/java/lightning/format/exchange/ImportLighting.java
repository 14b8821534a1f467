package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.file.FileErrorMessage;
import lightning.base.file.ParentFolder;
import lightning.base.file.ShippedFile;
import lightning.base.text.RefusalException;
import lightning.format.exchange.assembly.AssetCopy;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.jen.asset.EnvironmentReader;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;

/** Lighting of an imported scene. */
public enum ImportLighting {
    /** The lights of the file, or one light if it has none. */
    FILE(""),
    /** Soft key, fill and rim lights and a cyclorama, in the size of the subject. */
    STUDIO(""),
    /** Sun, light from the whole sky, and ground. */
    SKY(""),
    /** Image of a studio with three softboxes, and ground. */
    SOFTBOXES("studio_softboxes.hdr"),
    /** Image of a studio with strip lights, and ground. */
    STRIPS("studio_strips.hdr"),
    /** Image of a studio with a ring of lamps, and ground. */
    RING("studio_ring.hdr");

    /** Image that comes with the program; empty for none. */
    private final String image;

    ImportLighting(String image) {
        this.image = image;
    }

    /** Returns whether the image of this lighting is there: in every process of an installed program. */
    public boolean isAvailable() {
        return image.isEmpty() || ShippedFile.textures().isPresent();
    }

    /**
     * Returns the scene with this lighting. Takes a moment for large scenes.
     *
     * @throws RefusalException if the image of this lighting is missing or cannot be read
     */
    public ImportedScene apply(ImportedScene imported) {
        return switch (this) {
            case FILE -> imported;
            case STUDIO -> light(imported, "lights of the file replaced by a studio", StudioBuilder::studio, Optional.empty());
            case SKY -> light(imported, "lights of the file replaced by a sky", StudioBuilder::sky, Optional.empty());
            case SOFTBOXES, STRIPS, RING -> light(imported);
        };
    }

    private static ImportedScene light(ImportedScene imported, String comment, Function<StudioBuilder, Scene> lighting,
            Optional<AssetCopy> copy) {
        StudioBuilder builder = StudioBuilder.of(imported);
        return imported.withLighting(comment, lighting.apply(builder), copy, builder.notes());
    }

    private ImportedScene light(ImportedScene imported) {
        Path file = ShippedFile.textures().map(textures -> textures.resolve(image))
                .orElseThrow(() -> new RefusalException(image + ": comes with the installed program only"));
        try {
            var environment = new Environment(image, EnvironmentReader.read(image, file, 0, _ -> {}));
            var copy = new AssetCopy(ParentFolder.of(imported.sceneFile()).resolve(image), file, null);
            return light(imported, "lights of the file replaced by the image of a studio", builder -> builder.inside(environment),
                    Optional.of(copy));
        } catch (IOException e) {
            throw new RefusalException(FileErrorMessage.of(e));
        }
    }
}
