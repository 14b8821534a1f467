package lightning.cli.option;

import lightning.cli.output.BadInputException;
import lightning.render.relight.plan.ReflectionMode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Option {@code --reflections}. */
public final class ReflectionsOption {
    @Option(names = "--reflections", paramLabel = "WHEN",
            description = "current (reflections follow each edit) or stale (1998 method: reflections are updated on request only) "
                    + "(default: current).")
    private @Nullable ReflectionMode reflections;

    /** Returns the requested mode, or the default. */
    public ReflectionMode value() {
        return reflections == null ? ReflectionMode.CURRENT : reflections;
    }

    /** Returns the stale mode for a command that updates reflections in a separate step; rejects an explicit {@code current}. */
    public ReflectionMode staleValue() throws BadInputException {
        if (reflections == ReflectionMode.CURRENT) {
            throw new BadInputException("--update-reflections updates stale reflections; with --reflections current they need no update");
        }
        return ReflectionMode.STALE;
    }
}
