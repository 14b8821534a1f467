package lightning.cli;

import lightning.render.relight.plan.ReflectionMode;
import picocli.CommandLine.Option;

/** The option {@code --reflections}. */
final class ReflectionsOption {
    @Option(names = "--reflections", paramLabel = "WHEN",
            description = "current (the default: edits reach mirrors at once) or stale (as in 1998, mirrors on demand: they keep showing the "
                    + "scene of their last update).")
    private ReflectionMode reflections;

    /** What was asked for, or else the default. */
    ReflectionMode value() {
        return reflections == null ? ReflectionMode.CURRENT : reflections;
    }

    /** Likewise, where mirrors are updated by a step of their own, which leaves nothing to choose. */
    ReflectionMode staleValue() throws BadInputException {
        if (reflections == ReflectionMode.CURRENT) {
            throw new BadInputException("--update-reflections updates mirrors on demand; with --reflections current they need no update");
        }
        return ReflectionMode.STALE;
    }
}
