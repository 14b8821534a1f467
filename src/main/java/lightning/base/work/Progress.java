package lightning.base.work;

import java.util.function.BooleanSupplier;

/** Hears how far a long work is, and may stop it. Called from any worker thread. */
public interface Progress {
    /** {@code done} of {@code total} tiles are finished. */
    void report(int done, int total);

    /** Whether the work shall stop; asked before every tile and between the lights of a tile. */
    boolean isCanceled();

    /**
     * A tile of a picture that is made from nothing is there, though the picture is not.
     *
     * @param film its red, green and blue, each {@code float[1024]}; nobody writes them any more, but finer samples may follow
     */
    default void tileFinished(int tile, float[][] film) {}

    /**
     * Hears a part of a longer work: {@code offset} tiles are finished already, {@code total} are to be done in all.
     */
    default Progress subProgress(int offset, int total) {
        Progress parent = this;
        return new Progress() {
            @Override
            public void report(int done, int ofPart) {
                parent.report(offset + done, total);
            }

            @Override
            public boolean isCanceled() {
                return parent.isCanceled();
            }
        };
    }

    /** Stops with this one and hears nothing: for the parts of a work that is shown as a whole. */
    default Progress cancellationOnly() {
        return cancellation(this::isCanceled);
    }

    /** Hears nothing, and stops when it is so: asked on any worker's thread. */
    static Progress cancellation(BooleanSupplier canceled) {
        return new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return canceled.getAsBoolean();
            }
        };
    }

    /** Hears nothing and never stops. */
    Progress NONE = cancellation(() -> false);
}
