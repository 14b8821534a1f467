package lightning.cli;

import lightning.render.relight.plan.Reflections;
import picocli.CommandLine.Option;

/** The option {@code --reflections}. */
final class ReflectionsOption {
    @Option(names = "--reflections", paramLabel = "WHEN",
            description = "current (the default: edits reach mirrors at once) or stale (as in 1998, mirrors on demand: they keep showing the "
                    + "scene of their last update).")
    private Reflections chosen;

    /** What was asked for, or else the default. */
    Reflections value() {
        return chosen == null ? Reflections.CURRENT : chosen;
    }

    /** Likewise, where mirrors are updated by a step of their own, which leaves nothing to choose. */
    Reflections onDemand() throws BadInput {
        if (chosen == Reflections.CURRENT) {
            throw new BadInput("--update-reflections updates mirrors on demand; with --reflections current they need no update");
        }
        return Reflections.STALE;
    }
}
