package lightning.format.exchange;

import lightning.format.exchange.assembly.ImportedScene;

/** Choice whether an imported scene has indirect light. */
public enum IndirectChoice {
    /** Only if the camera is in a closed room, or the file says so. */
    AUTO,
    ON,
    OFF;

    /** Returns the scene with this choice. Takes a moment for large scenes. */
    public ImportedScene apply(ImportedScene imported) {
        return switch (this) {
            case ON -> imported.withIndirect();
            case OFF -> imported.withoutIndirect();
            case AUTO -> imported.hasIndirect() || ClosedRoom.contains(imported.scene()) ? imported.withIndirect() : imported;
        };
    }
}
