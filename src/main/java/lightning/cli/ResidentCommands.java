package lightning.cli;

import static java.util.Objects.requireNonNull;

import java.io.PrintStream;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.cli.output.Console;
import lightning.render.relight.Renderer;
import lightning.render.warmup.WarmUp;
import lightning.serve.resident.ResidentServer;

/**
 * Commands of a resident process, one after the other. They share the picture of the command before. Between them, one thread of low priority
 * warms up the lanes with its scene, until they are in use.
 */
final class ResidentCommands implements ResidentServer.CommandRunner, AutoCloseable {
    private final KeptRenderer kept = new KeptRenderer();
    private final ExecutorService idleThread = DedicatedThread.lowPriorityExecutor("lightning-idle");
    private volatile boolean idle;

    @Override
    public int run(PrintStream out, PrintStream err, boolean terminal, String... arguments) {
        idle = false;
        if (arguments.length > 0 && arguments[0].equals("shot")) {
            // A shot has caches of its own, and may use the whole memory.
            kept.close();
        }
        int exit = Lightning.run(new Console(out, err, terminal), kept, arguments);
        idle = true;
        kept.current().filter(renderer -> renderer.state().hasPicture()).ifPresent(renderer -> idleThread.execute(() -> warmUp(renderer)));
        return exit;
    }

    private void warmUp(Renderer renderer) {
        try {
            var cache = requireNonNull(renderer.state().newest());
            WarmUp.run(cache.scene(), cache.geometry(), Progress.cancellation(() -> !idle));
        } catch (CancellationException e) {
            // Code that was compiled by now stays compiled.
        } catch (RuntimeException | OutOfMemoryError e) {
            // The next command tells what is wrong with the scene.
        }
    }

    @Override
    public void close() {
        idle = false;
        idleThread.shutdown();
        kept.close();
    }
}
