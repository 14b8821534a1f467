package lightning.editor.window.preview;

import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import lightning.base.math.Vec3;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.document.manipulation.PreviewCamera;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.PlannedUpdate;
import lightning.render.relight.Renderer;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Renders the preview on a separate thread, always the newest request. An edit of a light updates the
 * sharp picture. While the camera moves, coarser pictures follow immediately, and a sharp one when it rests. The origin of render space
 * stays fixed meanwhile, so that no shape or bounding box has to be transformed again.
 */
final class PreviewLoop implements AutoCloseable {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withView(ViewEffects.PREVIEW);
    /** Target time of a picture while the camera moves, milliseconds. The resolution adapts to the last picture's time. */
    private static final double TARGET_MS = 25;
    private static final int COARSEST = 8;
    private static final long JOIN_TIMEOUT_MS = 10_000;

    /**
     * Request for a picture.
     *
     * @param width pixels
     * @param height pixels
     * @param effects visible effects
     * @param isMoving true if another request will follow soon
     * @param knownGeometry geometry of the scene from another renderer; null if there is none
     * @param tracedFilm traced picture of the same scene and camera, whose brightness the preview takes; null to keep the last brightness
     */
    record Request(Scene scene, PreviewCamera camera, int width, int height, ViewTransform view, ViewEffects effects, boolean isMoving,
            @Nullable Geometry knownGeometry, @Nullable Film tracedFilm) {
        private Vec3 eye() {
            return camera.camera().from();
        }

        private Scene sceneAt(int coarseness, Vec3 origin) {
            return scene.withCamera(camera.camera().withOrigin(origin)).withPicture(scene.picture()
                    .withSize(Math.max(1, width / coarseness), Math.max(1, height / coarseness)));
        }
    }

    /** Rendered picture: {@code int[width * height]}, opaque. */
    record Picture(Request request, int width, int height, int[] pixels, double milliseconds) {
        boolean isSharp() {
            return width == request.width() && height == request.height();
        }
    }

    private final Consumer<Picture> onPicture;
    private final Consumer<Throwable> onFailure;
    private final Thread thread;
    private final Renderer sharp = new Renderer(OPTIONS);
    private final Renderer coarse = new Renderer(OPTIONS);
    private int coarseness = 2;
    private double brightnessStops;
    /** Geometry of the last picture; null before the first. */
    private @Nullable Geometry lastGeometry;
    private @Nullable Request latest;
    private boolean closed;

    /**
     * Starts the thread.
     *
     * @param onPicture called on the rendering thread
     * @param onFailure called on the rendering thread
     */
    PreviewLoop(Consumer<Picture> onPicture, Consumer<Throwable> onFailure) {
        this.onPicture = onPicture;
        this.onFailure = onFailure;
        thread = DedicatedThread.create("lightning-preview", this::run);
        thread.start();
    }

    synchronized void draw(Request request) {
        latest = request;
        notifyAll();
    }

    private synchronized @Nullable Request nextRequest() throws InterruptedException {
        while (latest == null && !closed) {
            wait();
        }
        Request request = closed ? null : latest;
        latest = null;
        return request;
    }

    private synchronized boolean isOutdated() {
        return latest != null || closed;
    }

    private void run() {
        try {
            for (Request request = nextRequest(); request != null; request = nextRequest()) {
                tryDraw(request);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            sharp.close();
            coarse.close();
        }
    }

    private void tryDraw(Request request) {
        try {
            sharp.setOptions(OPTIONS.withView(request.effects()));
            coarse.setOptions(OPTIONS.withView(request.effects()));
            Geometry geometry = sharedGeometry(request);
            sharp.setSharedGeometry(geometry);
            coarse.setSharedGeometry(geometry);
            Vec3 origin = geometry != null && geometry.canServeEye(request.scene(), request.eye()) ? geometry.origin() : request.eye();
            draw(request, origin, sharp.plan(request.sceneAt(1, origin)));
        } catch (CancellationException e) {
            // The next iteration renders the newer request.
        } catch (RuntimeException | OutOfMemoryError e) {
            onFailure.accept(e);
        }
    }

    /** Returns the geometry of the traced picture if it can serve the preview's eye, otherwise that of the last preview. */
    private @Nullable Geometry sharedGeometry(Request request) {
        return request.knownGeometry() != null && request.knownGeometry().canServeEye(request.scene(), request.eye())
                || lastGeometry == null ? request.knownGeometry() : lastGeometry;
    }

    private void draw(Request request, Vec3 origin, PlannedUpdate fullUpdate) {
        boolean isFirstPass = fullUpdate.update() instanceof UpdatePlan.FirstPass;
        if (isFirstPass && request.isMoving()) {
            double elapsedMs = render(coarse, request, coarse.plan(request.sceneAt(coarseness, origin)), Progress.NONE);
            adaptCoarseness(elapsedMs);
        } else {
            render(sharp, request, fullUpdate, isFirstPass ? new OutdatedCheck() : Progress.NONE);
        }
    }

    private double render(Renderer renderer, Request request, PlannedUpdate planned, Progress progress) {
        double milliseconds = renderer.render(planned, progress).milliseconds();
        Film film = renderer.film();
        lastGeometry = renderer.cache().geometry();
        if (request.tracedFilm() != null) {
            brightnessStops = BrightnessMatch.stops(film, request.tracedFilm(), request.view().gain());
        }
        onPicture.accept(new Picture(request, film.width(), film.height(),
                BrightnessMatch.exposed(request.view(), brightnessStops).toPixels(film), milliseconds));
        return milliseconds;
    }

    private void adaptCoarseness(double elapsedMs) {
        if (elapsedMs > TARGET_MS && coarseness < COARSEST) {
            coarseness++;
        } else if (elapsedMs < TARGET_MS / 4 && coarseness > 1) {
            coarseness--;
        }
    }

    /** Cancels a sharp picture when a newer request arrives. */
    private final class OutdatedCheck implements Progress {
        @Override
        public void report(int done, int total) {}

        @Override
        public boolean isCanceled() {
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
            thread.join(JOIN_TIMEOUT_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
