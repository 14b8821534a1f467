package lightning.shot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Optional;
import lightning.base.text.Texts;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/** Holds frames in this process. */
public final class LocalKeeper implements FrameKeeper {
    private final Options options;
    private final FrameShelf shelf;
    /** Those that nobody works with. */
    private final ArrayDeque<Renderer> free = new ArrayDeque<>();
    /** Of the frame that was made last: most frames show the same shapes. */
    private Geometry shapes;
    private boolean closed;

    /**
     * A keeper of what memory holds; frames farther from the focus are traced again for each edit.
     *
     * @param options threads, engines, and the bytes that a frame may take while it is worked on; all frames are exact
     * @param memory  bytes that frames may take which nobody works on
     */
    public LocalKeeper(Options options, long memory) {
        this(options, new FrameShelf(memory, null, false));
    }

    /**
     * A keeper of what memory holds, and of the rest on disk.
     *
     * @param place where a folder of files is made that is removed in the end
     * @param disk  bytes that these may take
     * @throws IOException if it cannot be made; a sentence that begins with {@code place}
     */
    public LocalKeeper(Options options, long memory, Path place, long disk) throws IOException {
        this(options, new FrameShelf(memory, new FrameFolder(place, disk), false));
    }

    /**
     * A keeper that never drops a frame for another, as those need who look at films later: a frame for which it has no room it refuses.
     *
     * @throws IOException as the constructor
     */
    public static LocalKeeper firm(Options options, long memory, Path place, long disk) throws IOException {
        return new LocalKeeper(options, new FrameShelf(memory, new FrameFolder(place, disk), true));
    }

    private LocalKeeper(Options options, FrameShelf shelf) {
        this.options = options.withAccuracy(Accuracy.EXACT).withReflections(Reflections.CURRENT).withStorage(MirrorStorage.FULL_ROWS);
        this.shelf = shelf;
    }

    @Override
    public FrameUpdate bring(int frame, Take take, Progress progress) {
        long start = System.nanoTime();
        Scene wanted = take.at(frame);
        Renderer renderer = borrow();
        try {
            PixelCache kept = shelf.get(frame);
            if (shelf.isFirm() && kept == null) {
                checkRoom(wanted);
            }
            renderer.restore(kept);
            renderer.share(kept == null ? shapes() : null);
            Update update = renderer.renderOrForget(wanted, progress);
            if (!shelf.put(frame, renderer.cache(), kept)) {
                throw refusal(MemoryNeed.of(renderer.cache()));
            }
            keepShapes(renderer.cache().geometry());
            Film film = renderer.film();
            return new FrameUpdate(frame, update.plan() instanceof UpdatePlan.FirstPass, update.plan().text(), update.rays().all(),
                    System.nanoTime() - start, () -> film);
        } finally {
            renderer.forget();
            giveBack(renderer);
        }
    }

    /** Before anything is traced in vain. */
    private void checkRoom(Scene wanted) {
        long room = shelf.room();
        if (MemoryNeed.most(wanted, options) > room) {
            long need = MemoryNeed.forecast(wanted, options);
            if (need > room) {
                throw refusal(need);
            }
        }
    }

    private FrameRefusedException refusal(long need) {
        return new FrameRefusedException(Texts.of("the frame takes about {0}, and there is room for {1} more", ShotNeed.text(need),
                ShotNeed.text(Math.max(0, shelf.room()))));
    }

    private synchronized Renderer borrow() {
        return free.isEmpty() ? new Renderer(options) : free.pop();
    }

    private synchronized void giveBack(Renderer renderer) {
        if (closed) {
            renderer.close();
        } else {
            free.push(renderer);
        }
    }

    private synchronized Geometry shapes() {
        return shapes;
    }

    private synchronized void keepShapes(Geometry geometry) {
        shapes = geometry;
    }

    @Override
    public Optional<Film> film(int frame) {
        return Optional.ofNullable(shelf.get(frame)).map(PixelCache::film);
    }

    @Override
    public void focus(int frame) {
        shelf.focus(frame);
    }

    @Override
    public void forget(int frame) {
        shelf.remove(frame);
    }

    @Override
    public KeptBytes bytes() {
        return shelf.bytes();
    }

    /** Why frames are not on disk that should be, the first reason; a sentence without its full stop. */
    public Optional<String> problem() {
        return Optional.ofNullable(shelf.problem());
    }

    @Override
    public synchronized void close() {
        closed = true;
        free.forEach(Renderer::close);
        free.clear();
        shelf.close();
        shapes = null;
    }
}
