package lightning.editor.window.timeline;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;
import lightning.shot.ShotRevision;

/**
 * Small pictures of the frames of a shot that are seen, which follow every edit: the frame that is looked at first. Belongs to the window's
 * thread; the work is done on others.
 */
final class FilmStrip implements AutoCloseable {
    /** Of a picture, pixels. */
    static final int HEIGHT = 72;
    private static final int MAX_WIDTH = 256;

    private final FilmStripFrames frames;
    private final FilmStripStatus status;
    private final Executor windowExecutor;
    private final Runnable onChanged;
    private final Map<Integer, Thumbnail> thumbnails = new ConcurrentHashMap<>();
    /** By frame, which of its films could not be had: that is told by the next. */
    private final Map<Integer, Long> failedVersions = new ConcurrentHashMap<>();
    /** A film may be on a machine that has fallen silent: other frames do not wait for it. */
    private final ExecutorService thumbnailThreads = DedicatedThread.virtualThreadExecutor("lightning-strip");
    private final Set<Integer> busyFrames = ConcurrentHashMap.newKeySet();
    private final ExecutorService fetcher = DedicatedThread.sequentialExecutor("lightning-strip-film");
    private final ExecutorService focusThread = DedicatedThread.sequentialExecutor("lightning-strip-focus");
    private final AtomicBoolean notifyPending = new AtomicBoolean();
    private volatile boolean closed;
    private volatile ViewTransform view;
    private volatile List<Integer> visibleFrames = List.of();
    private AnimatedScene shownScene;

    /**
     * A picture as the display shows it.
     *
     * @param film   what it was made of
     * @param version which film of its frame that is
     * @param view   how it is shown
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     */
    record Thumbnail(Film film, long version, ViewTransform view, int[] pixels) {
        // An array in a record: written once by its maker, never after.
    }

    /**
     * Begins nothing before {@link #show}.
     *
     * @param frames  closed with this
     * @param status    hears of them
     * @param windowExecutor  runs tasks in turn on the window's thread
     * @param onChanged called there after pictures or states changed
     * @param onMessage    gets there what else is to be told
     */
    FilmStrip(FilmStripFrames frames, FilmStripStatus status, ViewTransform view, Executor windowExecutor, Runnable onChanged,
            Consumer<String> onMessage) {
        this.frames = frames;
        this.status = status;
        this.view = view;
        this.windowExecutor = windowExecutor;
        this.onChanged = onChanged;
        status.connect(frames.shot(), () -> {
            updateThumbnails();
            notifyChanged();
        }, message -> windowExecutor.execute(() -> onMessage.accept(message)));
    }

    /** The scene as a picture of the strip. */
    static Scene thumbnailScene(Scene scene) {
        PictureSettings picture = scene.picture();
        Downscale small = Downscale.fit(picture.width(), picture.height(), MAX_WIDTH, HEIGHT);
        return scene.withPicture(picture.withSize(small.width(), small.height()));
    }

    private void notifyChanged() {
        if (notifyPending.compareAndSet(false, true)) {
            windowExecutor.execute(() -> {
                notifyPending.set(false);
                if (!closed) {
                    onChanged.run();
                }
            });
        }
    }

    /** Brings all frames to a scene, which has a shot of the same frames. */
    void show(AnimatedScene scene, int frame) {
        if (scene != shownScene) {
            shownScene = scene;
            status.edit(new ShotRevision(frames.frameScene(scene.base()), scene.shot().orElseThrow()));
            notifyChanged();
        }
        // Others are told, which may wait for them.
        execute(focusThread, () -> frames.shot().focus(frame));
    }

    private static void execute(ExecutorService thread, Runnable task) {
        try {
            thread.execute(task);
        } catch (RejectedExecutionException e) {
            // Closed meanwhile.
        }
    }

    /** Shows the pictures in another way. */
    void setView(ViewTransform v) {
        view = v;
        updateThumbnails();
    }

    /** Which frames are seen, those first whose pictures are wanted first; of others none are kept. */
    void setVisibleFrames(List<Integer> newFrames) {
        if (!newFrames.equals(visibleFrames)) {
            visibleFrames = List.copyOf(newFrames);
            thumbnails.keySet().retainAll(Set.copyOf(newFrames));
            updateThumbnails();
        }
    }

    private void updateThumbnails() {
        visibleFrames.forEach(this::startThumbnail);
    }

    /** Has a frame's picture made, unless that is being done. */
    private void startThumbnail(int frame) {
        if (needsUpdate(frame) && busyFrames.add(frame)) {
            execute(thumbnailThreads, () -> {
                try {
                    while (needsUpdate(frame)) {
                        updateThumbnail(frame);
                        notifyChanged();
                    }
                } finally {
                    busyFrames.remove(frame);
                }
                // What came while the last was put away.
                startThumbnail(frame);
            });
        }
    }

    private boolean needsUpdate(int frame) {
        Thumbnail thumbnail = thumbnails.get(frame);
        return !closed && visibleFrames.contains(frame) && (isOutdated(frame, thumbnail) || thumbnail != null && thumbnail.view != view);
    }

    /** Whether there is a newer film that can be had. */
    private boolean isOutdated(int frame, Thumbnail thumbnail) {
        long version = status.version(frame);
        return version != (thumbnail == null ? 0 : thumbnail.version) && version != failedVersions.getOrDefault(frame, 0L);
    }

    private void updateThumbnail(int frame) {
        Thumbnail thumbnail = thumbnails.get(frame);
        ViewTransform currentView = view;
        if (!isOutdated(frame, thumbnail)) {
            store(frame, new Thumbnail(thumbnail.film, thumbnail.version, currentView, currentView.toPixels(thumbnail.film)));
            return;
        }
        long version = status.version(frame);
        Optional<Film> film = frames.shot().film(frame, MAX_WIDTH, HEIGHT);
        if (film.isEmpty()) {
            failedVersions.put(frame, version);
        } else {
            store(frame, new Thumbnail(film.get(), version, currentView, currentView.toPixels(film.get())));
        }
    }

    private void store(int frame, Thumbnail thumbnail) {
        if (visibleFrames.contains(frame)) {
            thumbnails.put(frame, thumbnail);
        }
    }

    /**
     * Has the film of a frame at its full size brought, one after the other: it is given on another thread, or nothing is where it is gone.
     *
     * @param isNeeded whether it still is, when its turn has come
     */
    void fetch(int frame, BooleanSupplier isNeeded, Consumer<Film> consumer) {
        execute(fetcher, () -> {
            if (isNeeded.getAsBoolean()) {
                frames.shot().film(frame).ifPresent(consumer);
            }
        });
    }

    /** Whether it is of a shot's frames. */
    boolean matches(Shot shot) {
        return frames.shot().first() == shot.first() && frames.shot().last() == shot.last();
    }

    FilmStripFrames frames() {
        return frames;
    }

    FilmStripStatus status() {
        return status;
    }

    Optional<Thumbnail> thumbnail(int frame) {
        return Optional.ofNullable(thumbnails.get(frame));
    }

    /** What there is of a frame; one is current whose film is, though its picture may be on the way. */
    FrameState state(int frame) {
        FrameState state = frames.shot().state(frame);
        return state == FrameState.CURRENT && !status.isCurrent(frame) ? FrameState.STALE : state;
    }

    /** Whether the picture of a frame shows the newest edit. */
    boolean isUpToDate(int frame) {
        Thumbnail thumbnail = thumbnails.get(frame);
        return thumbnail != null && thumbnail.version == status.version(frame) && state(frame) == FrameState.CURRENT;
    }

    /** How many frames are in a state. */
    int count(FrameState state) {
        int count = 0;
        for (int frame = frames.shot().first(); frame <= frames.shot().last(); frame++) {
            count += state(frame) == state ? 1 : 0;
        }
        return count;
    }

    /** Returns at once; what is under way ends on a thread of its own. */
    @Override
    public void close() {
        closed = true;
        frames.setPictureBusy(false);
        thumbnailThreads.shutdownNow();
        fetcher.shutdownNow();
        focusThread.shutdown();
        DedicatedThread.create("lightning-strip-close", frames::close).start();
    }
}
