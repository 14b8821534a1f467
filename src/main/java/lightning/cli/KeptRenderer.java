package lightning.cli;

import java.util.Optional;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.UpdatePlan;
import org.jspecify.annotations.Nullable;

/** Renderer of the commands that one process runs one after the other: each starts from the picture of the one before. */
final class KeptRenderer implements AutoCloseable {
    private @Nullable Renderer renderer;

    /** Returns the renderer with the options of a command. The command does not close it. */
    Renderer with(RenderOptions options) {
        if (renderer == null) {
            renderer = new Renderer(options);
        } else {
            renderer.setOptions(options);
        }
        return renderer;
    }

    /** Returns the renderer, if a command used one. */
    Optional<Renderer> current() {
        return Optional.ofNullable(renderer);
    }

    /** Returns what an update did for the first picture of a command. */
    static String title(UpdateResult update) {
        return update.plan() instanceof UpdatePlan.FirstPass ? "first pass" : "update";
    }

    /** Discards the picture, for commands that need the memory. */
    @Override
    public void close() {
        if (renderer != null) {
            renderer.close();
            renderer = null;
        }
    }
}
