package lightning.editor.loop;

import java.lang.ref.WeakReference;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import lightning.base.work.Progress;
import lightning.bench.accuracy.Promise;
import lightning.bench.accuracy.WarmSaving;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.PlannedUpdate;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/** Does the work of a {@link RenderLoop} with a renderer, on the loop's thread; other threads set only how the picture is shown. */
final class RenderWorker implements RenderTurns.WorkHandler {
    private final RenderListener listener;
    private final RenderQueue queue;
    private final Verifier verifier;
    private final Renderer renderer;
    private final Looking looking = new Looking();
    private volatile ViewTransform view = ViewTransform.DEFAULT;
    private volatile Look look = Look.PLAIN;
    /** What is seen of the first scene; none after that. */
    private volatile Future<Optional<CoarsePicture>> begun = CompletableFuture.completedFuture(Optional.empty());
    private Update last;
    private Accuracy madeAt;
    private Scene rendered;
    /** What is kept of the picture told last, as long as the renderer keeps it: who looks at it must not hold it in memory. */
    private volatile WeakReference<PixelCache> told = new WeakReference<>(null);

    RenderWorker(Options options, RenderQueue queue, Verifier verifier, RenderListener listener) {
        renderer = new Renderer(options);
        this.queue = queue;
        this.verifier = verifier;
        this.listener = listener;
    }

    /** See {@link RenderLoop#begin}. */
    void begin(Future<Optional<CoarsePicture>> seen) {
        begun = seen;
    }

    void setView(ViewTransform v) {
        view = v;
    }

    void setLook(Look v) {
        look = v;
    }

    /** See {@link RenderLoop#known}. */
    Optional<PixelCache> known() {
        return Optional.ofNullable(told.get());
    }

    @Override
    public void work(RenderQueue.Work work, RenderQueue.Stop stop) {
        verifier.pause();
        switch (work) {
            case RenderQueue.Work.Render r -> renderScene(r.scene(), stop);
            case RenderQueue.Work.Reopen r -> reopen(r, stop);
            case RenderQueue.Work.Reflections _ -> mirror(stop);
            case RenderQueue.Work.Looks _ -> lookAgain(stop);
            case RenderQueue.Work.Finish _ -> finish(stop);
            case RenderQueue.Work.Verify _ -> handToVerifier(stop);
            case RenderQueue.Work.Forget f -> drop(f.number());
        }
    }

    @Override
    public Scene rendered() {
        return rendered;
    }

    @Override
    public void rest() {
        if (rendered != null) {
            verifier.rest(rendered, renderer.cache().geometry());
        }
    }

    private void reopen(RenderQueue.Work.Reopen work, RenderQueue.Stop stop) {
        renderer.change(work.options());
        if (!renderer.hasPicture()) {
            letGo();
        }
        if (work.scene() != null) {
            renderScene(work.scene(), stop);
        }
    }

    private void renderScene(Scene scene, RenderQueue.Stop stop) {
        PlannedUpdate planned = renderer.plan(scene);
        listener.started(planned.update());
        if (planned.update() instanceof UpdatePlan.FirstPass) {
            makeRoom(scene);
            coarse(scene, stop);
        }
        make((r, progress) -> r.renderCenters(planned, watched(scene, progress)), (r, progress) -> r.render(scene, progress), stop);
        if (!renderer.isFinished()) {
            queue.finish();
        }
    }

    /** Makes the samples that the picture lacks; nothing where it lacks none. */
    private void finish(RenderQueue.Stop stop) {
        if (!renderer.isFinished()) {
            Scene scene = renderer.scene();
            make((r, progress) -> r.finish(watched(scene, progress)), (r, progress) -> r.render(scene, progress), stop);
        }
    }

    /**
     * Lets go of the picture before where the new one does not fit beside it; then a pass that is cancelled has none to go back to.
     *
     * @throws PictureTooLarge if it does not fit even so; nothing is let go of then
     */
    private void makeRoom(Scene scene) {
        renderer.check(scene, 0);
        long kept = renderer.bytes() + looking.bytes();
        try {
            renderer.check(scene, kept);
        } catch (PictureTooLarge e) {
            letGo();
        }
    }

    private void letGo() {
        renderer.forget();
        looking.close();
        told = new WeakReference<>(null);
        rendered = null;
        last = null;
        verifier.done(Optional.empty());
    }

    /**
     * Updates the picture.
     *
     * @param again does the same from the beginning, planning included, to measure what it saves
     */
    private void make(WarmSaving.Step step, WarmSaving.Step again, RenderQueue.Stop stop) {
        PixelCache start = start();
        ViewTransform shown = view;
        renderer.setView(shown.exposure(), shown.steepest());
        Update update = step.on(renderer, stop);
        verifier.done(!renderer.isFinished() ? Optional.empty()
                : WarmSaving.Edit.of(update, start, renderer.options(), (r, progress) -> {
                    r.setView(shown.exposure(), shown.steepest());
                    return again.on(r, progress);
                }));
        madeAt = renderer.options().accuracy();
        show(update, stop);
    }

    /** What an update starts from; null where it cannot start from there again, as it is of another accuracy. */
    private PixelCache start() {
        return renderer.hasPicture() && renderer.options().accuracy() == madeAt ? renderer.finishedCache() : null;
    }

    private void drop(long number) {
        letGo();
        listener.forgotten(number);
    }

    private void mirror(RenderQueue.Stop stop) {
        if (rendered != null && !renderer.reflectionsAreCurrent()) {
            make(Renderer::updateReflections, Renderer::updateReflections, stop);
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
        told = new WeakReference<>(renderer.cache());
        listener.rendered(new Frame(renderer.film(), seen, shown, rendered, renderer.cache().mirroredScene(), last,
                renderer.cache().geometry(), renderer.isFinished()));
    }

    /** Tells of the tiles, where it is a first pass. */
    private Progress watched(Scene scene, Progress progress) {
        return new Progress() {
            @Override
            public void tiles(int done, int total) {
                progress.tiles(done, total);
            }

            @Override
            public void made(int tile, float[][] film) {
                listener.tile(scene, tile, film);
            }

            @Override
            public boolean isCancelled() {
                return progress.isCancelled();
            }
        };
    }

    /** A look at all of the picture in a fraction of its time, then a better one. */
    private void coarse(Scene scene, RenderQueue.Stop stop) {
        Optional<CoarsePicture> first = begun().filter(seen -> seen.scene() == scene);
        first.ifPresent(seen -> {
            renderer.share(seen.geometry());
            listener.coarse(seen.film(), scene);
        });
        CoarsePicture.sizes(scene.picture()).stream().skip(first.isPresent() ? 1 : 0).forEach(pixels -> listener
                .coarse(CoarsePicture.of(scene, pixels, renderer::prepare, renderer.options().threads(), stop).film(), scene));
    }

    private Optional<CoarsePicture> begun() {
        try {
            return begun.get();
        } catch (ExecutionException | CancellationException e) {
            return Optional.empty();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.empty();
        } finally {
            begun = CompletableFuture.completedFuture(Optional.empty());
        }
    }

    private void handToVerifier(RenderQueue.Stop stop) {
        if (rendered != null) {
            finish(stop);
            verifier.verify(Promise.of(renderer, last), renderer.film().copy(), stop);
        }
    }

    @Override
    public void close() {
        renderer.close();
        looking.close();
    }
}
