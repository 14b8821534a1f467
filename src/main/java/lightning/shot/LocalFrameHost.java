package lightning.shot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Frame host in this process. */
public final class LocalFrameHost implements FrameHost {
    private final RenderOptions options;
    private final FrameStore store;
    /** Renderers that no job uses. */
    private final ArrayDeque<Renderer> idleRenderers = new ArrayDeque<>();
    /** Geometry of the last frame, because most frames show the same shapes. */
    private @Nullable Geometry sharedGeometry;
    private boolean closed;

    /**
     * Creates a host that keeps frames in memory only; frames farther from the focus are traced again for each edit.
     *
     * @param options     threads, engines, and bytes for a frame in progress; all frames are exact
     * @param memoryBytes bytes for frames not in progress
     */
    public LocalFrameHost(RenderOptions options, long memoryBytes) {
        this(options, new FrameStore(memoryBytes, null, false));
    }

    /**
     * Creates a host that keeps further frames on disk.
     *
     * @param parent    parent of the cache folder, which is removed at the end
     * @param diskBytes bytes for files
     * @throws IOException if the folder cannot be created; the message begins with {@code parent}
     */
    public LocalFrameHost(RenderOptions options, long memoryBytes, Path parent, long diskBytes) throws IOException {
        this(options, new FrameStore(memoryBytes, new FrameDiskCache(parent, diskBytes), false));
    }

    /**
     * Creates a host that never evicts a frame, for callers that fetch films later; rejects frames that do not fit.
     *
     * @throws IOException as the constructor
     */
    public static LocalFrameHost createPinned(RenderOptions options, long memoryBytes, Path parent, long diskBytes) throws IOException {
        return new LocalFrameHost(options, new FrameStore(memoryBytes, new FrameDiskCache(parent, diskBytes), true));
    }

    private LocalFrameHost(RenderOptions options, FrameStore store) {
        this.options = options.withDefaultMethod().withFades(false);
        this.store = store;
    }

    @Override
    public FrameUpdate update(int frame, ShotRevision revision, Progress progress) {
        long start = System.nanoTime();
        Scene scene = revision.sceneAt(frame);
        Renderer renderer = borrow();
        try {
            PixelCache cached = store.get(frame);
            if (store.isPinned() && cached == null) {
                checkRoom(scene);
            }
            renderer.restore(cached);
            renderer.setSharedGeometry(cached == null ? sharedGeometry() : null);
            UpdateResult update = renderer.renderOrClear(scene, progress);
            if (!store.put(frame, renderer.cache(), cached)) {
                throw rejection(MemoryEstimate.usedBytes(renderer.cache()));
            }
            shareGeometry(renderer.cache().geometry());
            Film film = renderer.film();
            return new FrameUpdate(frame, update.plan() instanceof UpdatePlan.FirstPass, update.plan().description(), update.rays().total(),
                    System.nanoTime() - start, () -> film);
        } finally {
            renderer.clear();
            release(renderer);
        }
    }

    /** Checks the space before tracing. */
    private void checkRoom(Scene scene) {
        long freeBytes = store.freeBytes();
        if (MemoryEstimate.upperBound(scene, options) > freeBytes) {
            long requiredBytes = MemoryEstimate.forecast(scene, options);
            if (requiredBytes > freeBytes) {
                throw rejection(requiredBytes);
            }
        }
    }

    private FrameRejectedException rejection(long requiredBytes) {
        return new FrameRejectedException(
                Messages.tr("the frame needs about {0}, but only {1} is free", ShotMemoryEstimate.formatBytes(requiredBytes),
                        ShotMemoryEstimate.formatBytes(Math.max(0, store.freeBytes()))));
    }

    private synchronized Renderer borrow() {
        return idleRenderers.isEmpty() ? new Renderer(options) : idleRenderers.pop();
    }

    private synchronized void release(Renderer renderer) {
        if (closed) {
            renderer.close();
        } else {
            idleRenderers.push(renderer);
        }
    }

    private synchronized @Nullable Geometry sharedGeometry() {
        return sharedGeometry;
    }

    private synchronized void shareGeometry(Geometry geometry) {
        sharedGeometry = geometry;
    }

    @Override
    public Optional<Film> film(int frame) {
        return Optional.ofNullable(store.get(frame)).map(PixelCache::film);
    }

    @Override
    public void focus(int frame) {
        store.focus(frame);
    }

    @Override
    public void drop(int frame) {
        store.remove(frame);
    }

    @Override
    public CacheUsage usage() {
        return store.usage();
    }

    /** Returns the first problem that kept frames from the disk; a sentence without its full stop. */
    public Optional<String> problem() {
        return Optional.ofNullable(store.problem());
    }

    @Override
    public synchronized void close() {
        closed = true;
        idleRenderers.forEach(Renderer::close);
        idleRenderers.clear();
        store.close();
        sharedGeometry = null;
    }
}
