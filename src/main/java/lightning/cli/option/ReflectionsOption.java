package lightning.cli.option;

import lightning.cli.output.BadInputException;
import lightning.render.RenderOptions;
import lightning.render.relight.paper.ReflectionMode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Option {@code --reflections}. */
public final class ReflectionsOption {
    @Option(names = "--reflections", paramLabel = "WHEN",
            description = "current (reflections follow each edit) or stale (1998 method: reflections are updated on request only) "
                    + "(default: current).")
    private @Nullable ReflectionMode reflections;

    /** Returns whether reflections are updated on request only. */
    public boolean isStale() {
        return reflections == ReflectionMode.STALE;
    }

    /** Returns the options with the requested mode, or the default. */
    public RenderOptions apply(RenderOptions options) {
        return reflections == null ? options : options.withReflections(reflections);
    }

    /** Returns the options in stale mode for a command that updates reflections in a separate step; rejects an explicit {@code current}. */
    RenderOptions applyStale(RenderOptions options) throws BadInputException {
        if (reflections == ReflectionMode.CURRENT) {
            throw new BadInputException("--update-reflections updates stale reflections; with --reflections current they need no update");
        }
        return options.withReflectionsOnRequest();
    }
}
