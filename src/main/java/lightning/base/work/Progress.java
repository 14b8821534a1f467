package lightning.base.work;

import java.util.function.BooleanSupplier;

/** Hears how far a long work is, and may stop it. Called from any worker thread. */
public interface Progress {
    /** {@code done} of {@code total} tiles are finished. */
    void tiles(int done, int total);

    /** Whether the work shall stop; asked before every tile and between the lights of a tile. */
    boolean isCancelled();

    /**
     * A tile of a picture that is made from nothing is there, though the picture is not.
     *
     * @param film its red, green and blue, each {@code float[1024]}; nobody writes them any more, but finer samples may follow
     */
    default void made(int tile, float[][] film) {}

    /**
     * Hears a part of a longer work: {@code before} tiles are finished already, {@code total} are to be done in all.
     */
    default Progress part(int before, int total) {
        Progress whole = this;
        return new Progress() {
            @Override
            public void tiles(int done, int ofPart) {
                whole.tiles(before + done, total);
            }

            @Override
            public boolean isCancelled() {
                return whole.isCancelled();
            }
        };
    }

    /** Stops with this one and hears nothing: for the parts of a work that is shown as a whole. */
    default Progress silent() {
        return until(this::isCancelled);
    }

    /** Hears nothing, and stops when it is so: asked on any worker's thread. */
    static Progress until(BooleanSupplier stops) {
        return new Progress() {
            @Override
            public void tiles(int done, int total) {}

            @Override
            public boolean isCancelled() {
                return stops.getAsBoolean();
            }
        };
    }

    /** Hears nothing and never stops. */
    Progress NONE = until(() -> false);
}
