package lightning.cli.option;

import lightning.cli.output.BadInputException;
import lightning.render.RenderOptions;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Options that choose between today's updates and those of 1998: accuracy, reflections and their cache. */
public final class UpdateOptions {
    @Option(names = "--accuracy", paramLabel = "ACCURACY", defaultValue = "exact",
            description = "exact (bit-identical to a full trace) or ratio (fast, approximate 1998 method with an error bound) "
                    + "(default: exact).")
    private Accuracy accuracy;
    @Mixin
    private ReflectionsOption reflections;
    @Option(names = "--update-reflections",
            description = "Keep reflections stale until the last edit, then update them in a separate step (1998 method).")
    private boolean updateReflections;
    private MirrorStorage storage = MirrorStorage.FULL_ROWS;

    /** Command-line names of {@link MirrorStorage}. */
    enum Storage { ROWS, SHAPES }

    @Option(names = "--storage", paramLabel = "WHAT", defaultValue = "rows",
            description = "Cache for reflections: rows (fast) or shapes (small) (default: rows).")
    private void setStorage(Storage value) {
        storage = switch (value) {
            case ROWS -> MirrorStorage.FULL_ROWS;
            case SHAPES -> MirrorStorage.SMALLEST;
        };
    }

    /** Returns whether reflections are updated in a step of their own after the last edit. */
    public boolean updatesReflectionsLast() {
        return updateReflections;
    }

    /** @throws BadInputException if reflections are to be updated separately and with each edit */
    public RenderOptions apply(RenderOptions options) throws BadInputException {
        RenderOptions chosen = options.withAccuracy(accuracy).withStorage(storage);
        return updateReflections ? reflections.applyStale(chosen) : reflections.apply(chosen);
    }
}
