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
import org.jspecify.annotations.Nullable;

/**
 * Thumbnails of the visible frames of a shot, updated after every edit, the current frame first. Confined to the window's thread;
 * background threads do the work.
 */
final class FilmStrip implements AutoCloseable {
    /** Maximum height of a thumbnail, pixels. */
    static final int HEIGHT = 72;
    private static final int MAX_WIDTH = 256;

    private final FilmStripFrames frames;
    private final FilmStripStatus status;
    private final Executor windowExecutor;
    private final Runnable onChanged;
    private final Map<Integer, Thumbnail> thumbnails = new ConcurrentHashMap<>();
    /** For each frame, the film version that could not be fetched; only a newer version is fetched again. */
    private final Map<Integer, Long> failedVersions = new ConcurrentHashMap<>();
    /** One thread per request: a film may be on a host that does not respond, and must not delay other frames. */
    private final ExecutorService thumbnailThreads = DedicatedThread.virtualThreadExecutor("lightning-strip");
    private final Set<Integer> busyFrames = ConcurrentHashMap.newKeySet();
    private final ExecutorService fetcher = DedicatedThread.sequentialExecutor("lightning-strip-film");
    private final ExecutorService focusThread = DedicatedThread.sequentialExecutor("lightning-strip-focus");
    private final AtomicBoolean notifyPending = new AtomicBoolean();
    private volatile boolean closed;
    private volatile ViewTransform view;
    private volatile List<Integer> visibleFrames = List.of();
    private @Nullable AnimatedScene shownScene;

    /**
     * Thumbnail of a frame in display colors.
     *
     * @param film film from which it was created
     * @param version version of the film
     * @param view view transform of the pixels
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     */
    record Thumbnail(Film film, long version, ViewTransform view, int[] pixels) {
        // Immutable by convention: the array is written only before construction.
    }

    /**
     * Creates the film strip; work starts with {@link #show}.
     *
     * @param frames source of the frames; closed with this object
     * @param status receives the events of the frames
     * @param windowExecutor runs tasks in order on the window's thread
     * @param onChanged called on the window's thread after thumbnails or states changed
     * @param onMessage receives other messages on the window's thread
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

    /** Returns the scene at the size of a thumbnail. */
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

    /** Updates all frames to a scene. Its shot must have the same frames. */
    void show(AnimatedScene scene, int frame) {
        if (scene != shownScene) {
            shownScene = scene;
            status.edit(new ShotRevision(frames.frameScene(scene.base()), scene.shot().orElseThrow()));
            notifyChanged();
        }
        // Runs in the background: a remote host may block this call.
        execute(focusThread, () -> frames.shot().focus(frame));
    }

    private static void execute(ExecutorService thread, Runnable task) {
        try {
            thread.execute(task);
        } catch (RejectedExecutionException e) {
            // The film strip was closed.
        }
    }

    /** Changes the view transform of the thumbnails. */
    void setView(ViewTransform v) {
        view = v;
        updateThumbnails();
    }

    /** Sets the visible frames in order of priority. Drops the thumbnails of all others. */
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

    /** Starts to create a frame's thumbnail unless that is already running. */
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
                // A new version may have arrived after the loop ended and before the frame was removed.
                startThumbnail(frame);
            });
        }
    }

    private boolean needsUpdate(int frame) {
        Thumbnail thumbnail = thumbnails.get(frame);
        return !closed && visibleFrames.contains(frame) && (isOutdated(frame, thumbnail) || thumbnail != null && thumbnail.view != view);
    }

    /** Returns whether a newer film version exists that has not failed. */
    private boolean isOutdated(int frame, @Nullable Thumbnail thumbnail) {
        long version = status.version(frame);
        return version != (thumbnail == null ? 0 : thumbnail.version) && version != failedVersions.getOrDefault(frame, 0L);
    }

    private void updateThumbnail(int frame) {
        Thumbnail thumbnail = thumbnails.get(frame);
        ViewTransform currentView = view;
        if (thumbnail != null && !isOutdated(frame, thumbnail)) {
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
     * Fetches the full-size film of a frame on a background thread, one request after the other. Does not call the consumer if the film no
     * longer exists.
     *
     * @param isNeeded checked when the request starts; if false, the request is skipped
     * @param consumer receives the film on the background thread
     */
    void fetch(int frame, BooleanSupplier isNeeded, Consumer<Film> consumer) {
        execute(fetcher, () -> {
            if (isNeeded.getAsBoolean()) {
                frames.shot().film(frame).ifPresent(consumer);
            }
        });
    }

    /** Returns whether the shot has the same frame range. */
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

    /** Returns the state of a frame. A frame is current if its film is, even if its thumbnail is still being created. */
    FrameState state(int frame) {
        FrameState state = frames.shot().state(frame);
        return state == FrameState.CURRENT && !status.isCurrent(frame) ? FrameState.STALE : state;
    }

    /** Returns whether the thumbnail of a frame shows the newest edit. */
    boolean isUpToDate(int frame) {
        Thumbnail thumbnail = thumbnails.get(frame);
        return thumbnail != null && thumbnail.version == status.version(frame) && state(frame) == FrameState.CURRENT;
    }

    /** Returns the number of frames in a state. */
    int count(FrameState state) {
        int count = 0;
        for (int frame = frames.shot().first(); frame <= frames.shot().last(); frame++) {
            count += state(frame) == state ? 1 : 0;
        }
        return count;
    }

    /** Returns immediately; a separate thread closes the frames. */
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
