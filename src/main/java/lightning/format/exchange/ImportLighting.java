package lightning.format.exchange;

import java.util.function.Function;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.scene.Scene;

/** Lighting of an imported scene. */
public enum ImportLighting {
    /** The lights of the file, or one light if it has none. */
    FILE,
    /** Soft key, fill and rim lights and a cyclorama, in the size of the subject. */
    STUDIO,
    /** Sun, light from the whole sky, and ground. */
    SKY;

    /** Returns the scene with this lighting. Takes a moment for large scenes. */
    public ImportedScene apply(ImportedScene imported) {
        return switch (this) {
            case FILE -> imported;
            case STUDIO -> light(imported, "lights of the file replaced by a studio", StudioBuilder::studio);
            case SKY -> light(imported, "lights of the file replaced by a sky", StudioBuilder::sky);
        };
    }

    private static ImportedScene light(ImportedScene imported, String comment, Function<StudioBuilder, Scene> lighting) {
        StudioBuilder builder = StudioBuilder.of(imported);
        return imported.withLighting(comment, lighting.apply(builder), builder.notes());
    }
}
