package lightning.edit.loop;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.accuracy.Promise;
import lightning.accuracy.WarmSaving;
import lightning.cache.PixelCache;
import lightning.image.Film;
import lightning.image.ViewTransform;
import lightning.relight.MemoryNeed;
import lightning.relight.PictureTooLarge;
import lightning.relight.Renderer;
import lightning.relight.Update;
import lightning.relight.plan.Accuracy;
import lightning.relight.plan.UpdatePlan;
import lightning.relight.tile.Options;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.shading.TraditionalTracer;
import lightning.work.Workers;

/**
 * Renders on a thread of its own, the newest wanted scene each time: Go, Live, Update Reflections and Verify of the
 * editor. All methods return at once and may be called from any thread.
 *
 * <pre>{@code
 * RenderLoop loop = new RenderLoop(Options.DEFAULT, listener);
 * loop.render(document.scene());      // Go
 * loop.updateReflections();
 * }</pre>
 */
public final class RenderLoop implements AutoCloseable {
    /** A picture of fewer pixels is there before a coarse one could be looked at. */
    private static final int COARSE_FROM = 512 * 512;
    private static final int COARSE_SHARE = 8;
    private static final long PATIENCE_MS = 10_000;

    private final RenderListener listener;
    private final RenderQueue queue = new RenderQueue();
    private final Verifier verifier;
    private final Thread thread;
    private Renderer renderer;
    private volatile ViewTransform view = ViewTransform.DEFAULT;
    private volatile Look look = Look.PLAIN;
    private final Looking looking = new Looking();
    private Update last;
    private Accuracy madeAt;
    private Scene rendered;

    /** Starts the thread; nothing is rendered until a scene is wanted. */
    public RenderLoop(Options options, RenderListener listener) {
        this.listener = listener;
        renderer = new Renderer(options);
        verifier = new Verifier(options.threads(), listener);
        thread = new Thread(new RenderTurns(queue, hands(), listener), "lightning-render");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Brings the picture to a scene. Replaces a scene that still waits. A trace of another picture (size, camera, shapes) is
     * cancelled; an update that runs is finished first, so that a picture comes even while edits never pause.
     */
    public void render(Scene scene) {
        queue.render(scene);
    }

    /** Makes the mirrors show the scene rendered last, after a scene that waits. Nothing happens before a first picture. */
    public void updateReflections() {
        queue.reflections();
    }

    /** Traces the scene rendered last in full, beside all other work, and compares. Nothing happens before a first picture. */
    public void verify() {
        queue.verify();
    }

    /** Another way of working. What is known of the picture serves on as far as it can: see {@link Renderer#change}. */
    public void reopen(Options options) {
        queue.reopen(options);
    }

    /** Another way of working, and another scene. */
    public void reopen(Options options, Scene scene) {
        queue.reopen(options, scene);
    }

    /** See {@link Renderer#setView}; counts from the next update. */
    public void setView(ViewTransform v) {
        view = v;
    }

    /** Shows the picture in another way; nothing of it changes. */
    public void setLook(Look v) {
        look = v;
        queue.look();
    }

    /** Stops what runs, a verification too, and forgets what waits. The last picture stays. */
    public void cancel() {
        queue.cancel();
        verifier.cancel();
    }

    /** Stops everything, drops all that is known of the picture, and renders another document's scene. */
    public void open(Scene scene) {
        queue.open(scene);
        verifier.cancel();
    }

    /** Whether the picture is being worked at. A verification runs beside and does not count. */
    public boolean isBusy() {
        return queue.isBusy();
    }

    /** Whether a verification runs or waits. */
    public boolean isVerifying() {
        return queue.isVerifying() || verifier.isBusy();
    }

    /** Whether its thread still runs: until it is closed. */
    boolean isAlive() {
        return thread.isAlive();
    }

    private RenderTurns.Hands hands() {
        return new RenderTurns.Hands() {
            @Override
            public void work(RenderQueue.Work work, RenderQueue.Stop stop) {
                RenderLoop.this.work(work, stop);
            }

            @Override
            public Scene rendered() {
                return rendered;
            }

            @Override
            public void rest() {
                measure();
            }

            @Override
            public void close() {
                renderer.close();
                looking.close();
            }
        };
    }

    private void work(RenderQueue.Work work, RenderQueue.Stop stop) {
        verifier.pause();
        switch (work) {
            case RenderQueue.Work.Render r -> renderScene(r.scene(), stop);
            case RenderQueue.Work.Reopen r -> reopen(r, stop);
            case RenderQueue.Work.Reflections _ -> mirror(stop);
            case RenderQueue.Work.Looks _ -> lookAgain(stop);
            case RenderQueue.Work.Verify _ -> handToVerifier(stop);
            case RenderQueue.Work.Forget _ -> drop();
        }
    }

    /** While nobody works, what the last update saves. */
    private void measure() {
        verifier.measure();
    }

    private void reopen(RenderQueue.Work.Reopen work, RenderQueue.Stop stop) {
        renderer.change(work.options());
        if (work.scene() != null) {
            renderScene(work.scene(), stop);
        }
    }

    private void renderScene(Scene scene, RenderQueue.Stop stop) {
        UpdatePlan plan = renderer.plan(scene);
        listener.started(plan);
        if (plan instanceof UpdatePlan.FirstPass) {
            makeRoom(scene);
            coarse(scene, stop);
        }
        make((r, progress) -> r.render(scene, progress), stop);
    }

    /**
     * Lets go of the picture before where the new one does not fit beside it; then a pass that is cancelled has none to go back to.
     *
     * @throws PictureTooLarge if it does not fit even so; nothing is let go of then
     */
    private void makeRoom(Scene scene) {
        renderer.check(scene, 0);
        long kept = (renderer.hasPicture() ? MemoryNeed.of(renderer.cache()) : 0) + looking.bytes();
        try {
            renderer.check(scene, kept);
        } catch (PictureTooLarge e) {
            letGo();
        }
    }

    private void letGo() {
        renderer.forget();
        looking.close();
        rendered = null;
        last = null;
        verifier.done(Optional.empty());
    }

    /** Updates the picture in a way that can be done again, to measure what it saves. */
    private void make(WarmSaving.Step step, RenderQueue.Stop stop) {
        PixelCache start = known();
        ViewTransform shown = view;
        WarmSaving.Step whole = (r, progress) -> {
            r.setView(shown.exposure(), shown.curve());
            return step.on(r, progress);
        };
        Update update = whole.on(renderer, stop);
        verifier.done(WarmSaving.Edit.of(update, start, renderer.options(), whole));
        madeAt = renderer.options().accuracy();
        show(update, stop);
    }

    /** What an update starts from; null where it cannot start from there again, as it is of another accuracy. */
    private PixelCache known() {
        return renderer.hasPicture() && renderer.options().accuracy() == madeAt ? renderer.cache() : null;
    }

    private void drop() {
        letGo();
        listener.forgotten();
    }

    private void mirror(RenderQueue.Stop stop) {
        if (rendered != null && !renderer.reflectionsAreCurrent()) {
            make(Renderer::updateReflections, stop);
        }
    }

    private void lookAgain(RenderQueue.Stop stop) {
        if (rendered != null) {
            show(last, stop);
        }
    }

    private void show(Update update, RenderQueue.Stop stop) {
        rendered = renderer.scene();
        last = update;
        Look wanted = look;
        try {
            tell(wanted.isPlain() ? looking.plain(renderer) : looking.film(renderer, wanted, stop.silent()), wanted);
        } catch (CancellationException e) {
            // The picture itself is finished.
            tell(renderer.film(), Look.PLAIN);
        } catch (PictureTooLarge | OutOfMemoryError e) {
            tell(looking.plain(renderer), Look.PLAIN);
            throw e;
        }
    }

    private void tell(Film seen, Look shown) {
        listener.rendered(new Frame(renderer.film(), seen, shown, rendered, renderer.cache().mirroredScene(), last));
    }

    /** One pixel of 64: a look at the picture in a fraction of its time. */
    private void coarse(Scene scene, RenderQueue.Stop stop) {
        Picture picture = scene.picture();
        if ((long) picture.width() * picture.height() < COARSE_FROM) {
            return;
        }
        Scene small = scene.withPicture(picture.withSize(Math.max(1, picture.width() / COARSE_SHARE),
                Math.max(1, picture.height() / COARSE_SHARE)));
        try (var workers = new Workers(renderer.options().threads())) {
            Film film = new TraditionalTracer(small).trace(workers, stop).film();
            listener.coarse(film, scene);
        }
    }

    private void handToVerifier(RenderQueue.Stop stop) {
        if (rendered != null) {
            verifier.verify(Promise.of(renderer, last), renderer.film().copy(), stop);
        }
    }

    /** Stops everything and waits for the threads to end. */
    @Override
    public void close() {
        queue.close();
        verifier.close();
        try {
            thread.join(PATIENCE_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
