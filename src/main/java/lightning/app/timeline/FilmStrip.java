package lightning.app.timeline;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import lightning.image.Film;
import lightning.image.ViewTransform;
import lightning.relight.MemoryNeed;
import lightning.relight.plan.Reflections;
import lightning.relight.tile.Options;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.LocalKeeper;
import lightning.shot.RelitShot;
import lightning.shot.ShotListener;
import lightning.shot.Take;
import lightning.work.OwnThread;
import lightning.work.Workers;

/**
 * Small pictures of all frames of a shot, exact at their size, which follow every edit: the frame that is looked at first. It gives way to
 * the large picture wherever that is worked at. Belongs to the window's thread; the work is done on others.
 */
final class FilmStrip implements AutoCloseable {
    /** Of a picture, pixels. */
    static final int HEIGHT = 72;
    private static final int MOST_WIDTH = 256;

    private final Executor window;
    private final Runnable changed;
    private final RelitShot frames;
    private final Map<Integer, Small> pictures = new ConcurrentHashMap<>();
    private final AtomicBoolean told = new AtomicBoolean();
    private volatile boolean urgent;
    private volatile boolean closed;
    private volatile ViewTransform view;
    private AnimatedScene shown;

    /**
     * A picture as the display shows it.
     *
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     */
    record Small(int width, int height, int[] pixels) {
        // An array in a record: written once by its maker, never after.
    }

    /**
     * Begins nothing before {@link #show}.
     *
     * @param window  runs tasks in turn on the window's thread
     * @param changed called there after pictures or states changed
     */
    FilmStrip(Shot shot, Scene scene, ViewTransform view, Executor window, Runnable changed) {
        this.window = window;
        this.changed = changed;
        this.view = view;
        int threads = Math.max(1, Workers.available() - 1);
        var keeper = new LocalKeeper(options().withThreads(threads), bytes(scene, shot));
        frames = RelitShot.of(shot.first(), shot.last(), new PatientKeeper(keeper, () -> urgent), new ShotListener() {
            @Override
            public void updated(FrameUpdate update, FrameState state) {
                pictures.put(update.frame(), picture(update.film()));
                tell();
            }

            @Override
            public void failed(int frame, Throwable problem) {
                tell();
            }

            @Override
            public void idle() {
                tell();
            }
        });
    }

    private static Options options() {
        return Options.DEFAULT.withReflections(Reflections.CURRENT);
    }

    /** The most bytes that the pictures of a shot take with all that they are relit from. */
    static long bytes(Scene scene, Shot shot) {
        Scene small = small(scene);
        Picture picture = small.picture();
        long each = MemoryNeed.most(small, options()) + 4L * picture.width() * picture.height();
        return each * ((long) shot.last() - shot.first() + 1);
    }

    /** The scene as a picture of the strip. */
    static Scene small(Scene scene) {
        Picture picture = scene.picture();
        double shrink = Math.min(1, Math.min((double) HEIGHT / picture.height(), (double) MOST_WIDTH / picture.width()));
        return scene.withPicture(picture.withSize(side(picture.width() * shrink), side(picture.height() * shrink)));
    }

    private static int side(double pixels) {
        return (int) Math.max(1, Math.rint(pixels));
    }

    private Small picture(Film film) {
        return new Small(film.width(), film.height(), view.toPixels(film));
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
        frames.focus(frame);
        if (scene != shown) {
            shown = scene;
            frames.edit(new Take(small(scene.still()), scene.shot().orElseThrow()));
            tell();
        }
    }

    /** Whether the large picture is worked at. */
    void setUrgent(boolean v) {
        urgent = v;
    }

    /** Shows the pictures in another way; takes a while, on a thread of its own. */
    void setView(ViewTransform v) {
        view = v;
        OwnThread.of("lightning-strip", () -> {
            for (int frame = frames.first(); frame <= frames.last() && !closed && v == view; frame++) {
                int number = frame;
                frames.film(frame).ifPresent(film -> pictures.put(number, picture(film)));
            }
            tell();
        }).start();
    }

    /** Whether it is of a shot's frames. */
    boolean isOf(Shot shot) {
        return frames.first() == shot.first() && frames.last() == shot.last();
    }

    Optional<Small> picture(int frame) {
        return Optional.ofNullable(pictures.get(frame));
    }

    FrameState state(int frame) {
        return frames.state(frame);
    }

    /** Returns at once; what is under way ends on a thread of its own. */
    @Override
    public void close() {
        closed = true;
        urgent = false;
        OwnThread.of("lightning-strip-close", frames::close).start();
    }
}
