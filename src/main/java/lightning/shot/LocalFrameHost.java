package lightning.shot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/** Holds frames in this process. */
public final class LocalFrameHost implements FrameHost {
    private final RenderOptions options;
    private final FrameStore store;
    /** Those that nobody works with. */
    private final ArrayDeque<Renderer> idleRenderers = new ArrayDeque<>();
    /** Of the frame that was made last: most frames show the same shapes. */
    private Geometry sharedGeometry;
    private boolean closed;

    /**
     * A keeper of what memory holds; frames farther from the focus are traced again for each edit.
     *
     * @param options threads, engines, and the bytes that a frame may take while it is worked on; all frames are exact
     * @param memoryBytes  bytes that frames may take which nobody works on
     */
    public LocalFrameHost(RenderOptions options, long memoryBytes) {
        this(options, new FrameStore(memoryBytes, null, false));
    }

    /**
     * A keeper of what memory holds, and of the rest on disk.
     *
     * @param parent where a folder of files is made that is removed in the end
     * @param diskBytes  bytes that these may take
     * @throws IOException if it cannot be made; a sentence that begins with {@code parent}
     */
    public LocalFrameHost(RenderOptions options, long memoryBytes, Path parent, long diskBytes) throws IOException {
        this(options, new FrameStore(memoryBytes, new FrameDiskCache(parent, diskBytes), false));
    }

    /**
     * A keeper that never drops a frame for another, as those need who look at films later: a frame for which it has no room it refuses.
     *
     * @throws IOException as the constructor
     */
    public static LocalFrameHost createPinned(RenderOptions options, long memoryBytes, Path parent, long diskBytes) throws IOException {
        return new LocalFrameHost(options, new FrameStore(memoryBytes, new FrameDiskCache(parent, diskBytes), true));
    }

    private LocalFrameHost(RenderOptions options, FrameStore store) {
        this.options = options.withAccuracy(Accuracy.EXACT).withReflections(ReflectionMode.CURRENT).withStorage(MirrorStorage.FULL_ROWS);
        this.store = store;
    }

    @Override
    public FrameUpdate update(int frame, ShotRevision take, Progress progress) {
        long start = System.nanoTime();
        Scene scene = take.sceneAt(frame);
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

    /** Before anything is traced in vain. */
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

    private synchronized Geometry sharedGeometry() {
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

    /** Why frames are not on disk that should be, the first reason; a sentence without its full stop. */
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
