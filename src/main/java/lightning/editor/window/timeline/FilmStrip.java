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
import lightning.base.work.OwnThread;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;
import lightning.shot.Take;

/**
 * Small pictures of the frames of a shot that are seen, which follow every edit: the frame that is looked at first. Belongs to the window's
 * thread; the work is done on others.
 */
final class FilmStrip implements AutoCloseable {
    /** Of a picture, pixels. */
    static final int HEIGHT = 72;
    private static final int MOST_WIDTH = 256;

    private final StripFrames frames;
    private final StripNews news;
    private final Executor window;
    private final Runnable changed;
    private final Map<Integer, Small> pictures = new ConcurrentHashMap<>();
    /** By frame, which of its films could not be had: that is told by the next. */
    private final Map<Integer, Long> missed = new ConcurrentHashMap<>();
    /** A film may be on a machine that has fallen silent: other frames do not wait for it. */
    private final ExecutorService painters = OwnThread.forEach("lightning-strip");
    private final Set<Integer> painted = ConcurrentHashMap.newKeySet();
    private final ExecutorService fetcher = OwnThread.inTurn("lightning-strip-film");
    private final ExecutorService looks = OwnThread.inTurn("lightning-strip-focus");
    private final AtomicBoolean told = new AtomicBoolean();
    private volatile boolean closed;
    private volatile ViewTransform view;
    private volatile List<Integer> seen = List.of();
    private AnimatedScene shown;

    /**
     * A picture as the display shows it.
     *
     * @param film   what it was made of
     * @param number which film of its frame that is
     * @param view   how it is shown
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     */
    record Small(Film film, long number, ViewTransform view, int[] pixels) {
        // An array in a record: written once by its maker, never after.
    }

    /**
     * Begins nothing before {@link #show}.
     *
     * @param frames  closed with this
     * @param news    hears of them
     * @param window  runs tasks in turn on the window's thread
     * @param changed called there after pictures or states changed
     * @param said    gets there what else is to be told
     */
    FilmStrip(StripFrames frames, StripNews news, ViewTransform view, Executor window, Runnable changed, Consumer<String> said) {
        this.frames = frames;
        this.news = news;
        this.view = view;
        this.window = window;
        this.changed = changed;
        news.follow(frames.shot(), () -> {
            paint();
            tell();
        }, sentence -> window.execute(() -> said.accept(sentence)));
    }

    /** The scene as a picture of the strip. */
    static Scene small(Scene scene) {
        Picture picture = scene.picture();
        Downscale small = Downscale.into(picture.width(), picture.height(), MOST_WIDTH, HEIGHT);
        return scene.withPicture(picture.withSize(small.width(), small.height()));
    }

    private void tell() {
        if (told.compareAndSet(false, true)) {
            window.execute(() -> {
                told.set(false);
                if (!closed) {
                    changed.run();
                }
            });
        }
    }

    /** Brings all frames to a scene, which has a shot of the same frames. */
    void show(AnimatedScene scene, int frame) {
        if (scene != shown) {
            shown = scene;
            news.edit(new Take(frames.kept(scene.still()), scene.shot().orElseThrow()));
            tell();
        }
        // Others are told, which may wait for them.
        execute(looks, () -> frames.shot().focus(frame));
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
        paint();
    }

    /** Which frames are seen, those first whose pictures are wanted first; of others none are kept. */
    void see(List<Integer> now) {
        if (!now.equals(seen)) {
            seen = List.copyOf(now);
            pictures.keySet().retainAll(Set.copyOf(now));
            paint();
        }
    }

    private void paint() {
        seen.forEach(this::begin);
    }

    /** Has a frame's picture made, unless that is being done. */
    private void begin(int frame) {
        if (isWanted(frame) && painted.add(frame)) {
            execute(painters, () -> {
                try {
                    while (isWanted(frame)) {
                        paint(frame);
                        tell();
                    }
                } finally {
                    painted.remove(frame);
                }
                // What came while the last was put away.
                begin(frame);
            });
        }
    }

    private boolean isWanted(int frame) {
        Small small = pictures.get(frame);
        return !closed && seen.contains(frame) && (isOld(frame, small) || small != null && small.view != view);
    }

    /** Whether there is a newer film that can be had. */
    private boolean isOld(int frame, Small small) {
        long number = news.films(frame);
        return number != (small == null ? 0 : small.number) && number != missed.getOrDefault(frame, 0L);
    }

    private void paint(int frame) {
        Small small = pictures.get(frame);
        ViewTransform now = view;
        if (!isOld(frame, small)) {
            put(frame, new Small(small.film, small.number, now, now.toPixels(small.film)));
            return;
        }
        long number = news.films(frame);
        Optional<Film> film = frames.shot().film(frame, MOST_WIDTH, HEIGHT);
        if (film.isEmpty()) {
            missed.put(frame, number);
        } else {
            put(frame, new Small(film.get(), number, now, now.toPixels(film.get())));
        }
    }

    private void put(int frame, Small small) {
        if (seen.contains(frame)) {
            pictures.put(frame, small);
        }
    }

    /**
     * Has the film of a frame at its full size brought, one after the other: it is given on another thread, or nothing is where it is gone.
     *
     * @param wanted whether it still is, when its turn has come
     */
    void fetch(int frame, BooleanSupplier wanted, Consumer<Film> then) {
        execute(fetcher, () -> {
            if (wanted.getAsBoolean()) {
                frames.shot().film(frame).ifPresent(then);
            }
        });
    }

    /** Whether it is of a shot's frames. */
    boolean isOf(Shot shot) {
        return frames.shot().first() == shot.first() && frames.shot().last() == shot.last();
    }

    StripFrames frames() {
        return frames;
    }

    StripNews news() {
        return news;
    }

    Optional<Small> picture(int frame) {
        return Optional.ofNullable(pictures.get(frame));
    }

    /** What there is of a frame; one is current whose film is, though its picture may be on the way. */
    FrameState state(int frame) {
        FrameState state = frames.shot().state(frame);
        return state == FrameState.CURRENT && !news.isCurrent(frame) ? FrameState.STALE : state;
    }

    /** Whether the picture of a frame shows the newest edit. */
    boolean showsNewest(int frame) {
        Small small = pictures.get(frame);
        return small != null && small.number == news.films(frame) && state(frame) == FrameState.CURRENT;
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
        frames.setUrgent(false);
        painters.shutdownNow();
        fetcher.shutdownNow();
        looks.shutdown();
        OwnThread.of("lightning-strip-close", frames::close).start();
    }
}
