package lightning.format.exchange;

import lightning.format.exchange.assembly.ImportedScene;

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
            case STUDIO -> imported.withLighting("lights of the file replaced by a studio", StudioBuilder.of(imported).studio());
            case SKY -> imported.withLighting("lights of the file replaced by a sky", StudioBuilder.of(imported).sky());
        };
    }
}
