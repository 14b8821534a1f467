package lightning.editor.window.preview;

import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import lightning.base.math.Vec3;
import lightning.base.work.OwnThread;
import lightning.base.work.Progress;
import lightning.editor.document.PreviewCamera;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.PlannedUpdate;
import lightning.render.relight.Renderer;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * Draws the preview on a thread of its own, the newest wish each time: the engine without shadows and mirrors. A light's edit
 * is an update of the sharp picture; while the camera moves, a coarser picture comes at once and the sharp one when the camera
 * rests. Render space stays where it is meanwhile, so that no shape and no box is moved.
 */
final class PreviewLoop implements AutoCloseable {
    private static final Options OPTIONS = Options.DEFAULT.withView(ViewEffects.PREVIEW);
    /** How long a moving picture may take; its coarseness follows what the last one took. */
    private static final double WANTED_MS = 25;
    private static final int COARSEST = 8;
    private static final long PATIENCE_MS = 10_000;

    /**
     * What is to be drawn.
     *
     * @param width pixels; likewise {@code height}
     * @param effects which effects are shown
     * @param moving whether a better wish follows soon
     * @param known  what is known elsewhere of the scene's shapes; null where nothing is
     */
    record Wish(Scene scene, PreviewCamera camera, int width, int height, ViewTransform view, ViewEffects effects, boolean moving,
            Geometry known) {
        private Vec3 eye() {
            return camera.camera().from();
        }

        private Scene at(int coarseness, Vec3 origin) {
            return scene.withCamera(camera.camera().withOrigin(origin)).withPicture(scene.picture()
                    .withSize(Math.max(1, width / coarseness), Math.max(1, height / coarseness)));
        }
    }

    /** A drawn picture: {@code int[width * height]}, opaque. */
    record Picture(Wish wish, int width, int height, int[] pixels, double milliseconds) {
        boolean isSharp() {
            return width == wish.width() && height == wish.height();
        }
    }

    private final Consumer<Picture> heard;
    private final Consumer<Throwable> failed;
    private final Thread thread;
    private final Renderer sharp = new Renderer(OPTIONS);
    private final Renderer quick = new Renderer(OPTIONS);
    private int coarseness = 2;
    /** What the preview was drawn with last; null before the first. */
    private Geometry last;
    private Wish newest;
    private boolean closed;

    /** @param heard hears on the drawing thread; likewise {@code failed} */
    PreviewLoop(Consumer<Picture> heard, Consumer<Throwable> failed) {
        this.heard = heard;
        this.failed = failed;
        thread = OwnThread.of("lightning-preview", this::run);
        thread.start();
    }

    synchronized void draw(Wish wish) {
        newest = wish;
        notifyAll();
    }

    private synchronized Wish take() throws InterruptedException {
        while (newest == null && !closed) {
            wait();
        }
        Wish taken = closed ? null : newest;
        newest = null;
        return taken;
    }

    private synchronized boolean isOutdated() {
        return newest != null || closed;
    }

    private void run() {
        try {
            for (Wish wish = take(); wish != null; wish = take()) {
                attempt(wish);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            sharp.close();
            quick.close();
        }
    }

    private void attempt(Wish wish) {
        try {
            sharp.change(OPTIONS.withView(wish.effects()));
            quick.change(OPTIONS.withView(wish.effects()));
            Geometry shared = shared(wish);
            sharp.share(shared);
            quick.share(shared);
            Vec3 origin = shared != null && shared.servesEye(wish.scene(), wish.eye()) ? shared.origin() : wish.eye();
            draw(wish, origin, sharp.plan(wish.at(1, origin)));
        } catch (CancellationException e) {
            // The newer wish is next.
        } catch (RuntimeException | OutOfMemoryError e) {
            failed.accept(e);
        }
    }

    /** The traced picture's shapes serve while the eye is not far from them, and else those of the preview that was drawn last. */
    private Geometry shared(Wish wish) {
        return wish.known() != null && wish.known().servesEye(wish.scene(), wish.eye()) || last == null ? wish.known() : last;
    }

    private void draw(Wish wish, Vec3 origin, PlannedUpdate inFull) {
        boolean fresh = inFull.update() instanceof UpdatePlan.FirstPass;
        if (fresh && wish.moving()) {
            double took = render(quick, wish, quick.plan(wish.at(coarseness, origin)), Progress.NONE);
            adapt(took);
        } else {
            render(sharp, wish, inFull, fresh ? new UntilOutdated() : Progress.NONE);
        }
    }

    private double render(Renderer renderer, Wish wish, PlannedUpdate planned, Progress progress) {
        double milliseconds = renderer.render(planned, progress).milliseconds();
        Film film = renderer.film();
        last = renderer.cache().geometry();
        heard.accept(new Picture(wish, film.width(), film.height(), wish.view().toPixels(film), milliseconds));
        return milliseconds;
    }

    private void adapt(double took) {
        if (took > WANTED_MS && coarseness < COARSEST) {
            coarseness++;
        } else if (took < WANTED_MS / 4 && coarseness > 1) {
            coarseness--;
        }
    }

    /** A sharp picture is given up for a newer wish. */
    private final class UntilOutdated implements Progress {
        @Override
        public void tiles(int done, int total) {}

        @Override
        public boolean isCancelled() {
            return isOutdated();
        }
    }

    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            notifyAll();
        }
        try {
            thread.join(PATIENCE_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
