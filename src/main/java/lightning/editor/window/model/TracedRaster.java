package lightning.editor.window.model;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.editor.loop.Frame;
import lightning.editor.loop.RenderListener;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;

/**
 * The traced picture as display pixels, packed tile by tile where the film changed. A new size makes new pixels. Safe for
 * several threads; readers may see tiles of the next picture a moment early, never half a pixel.
 */
public final class TracedRaster implements RenderListener {
    /** @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB, the top row first */
    public record Pixels(int width, int height, int[] pixels) {}

    /** The columns and rows that changed, [left, right) and [top, bottom). */
    public record Dirty(int left, int top, int right, int bottom) {
        public static final Dirty NONE = new Dirty(Integer.MAX_VALUE, Integer.MAX_VALUE, 0, 0);

        public boolean isEmpty() {
            return left >= right;
        }

        public Dirty plus(int l, int t, int r, int b) {
            return new Dirty(Math.min(left, l), Math.min(top, t), Math.max(right, r), Math.max(bottom, b));
        }
    }

    /** Tiles of an unfinished picture are told of together, so that a window does not draw all the time, nanoseconds. */
    private static final long STEP_NS = 40_000_000;

    private Pixels pixels;
    private Film shown;
    private Film coarse;
    /** What another machine made of the scene that is being traced; null where that shows none. Likewise the scene. */
    private Film ahead;
    private Scene aheadOf;
    /** The scene whose picture is shown last, with all its samples; null where it lacks some. */
    private Scene finished;
    private ViewTransform view = ViewTransform.DEFAULT;
    private Dirty dirty = Dirty.NONE;
    private Dirty patch = Dirty.NONE;
    /** Tiles of a picture that is not whole yet: whether there are any, what of them was not told, and when the last was. */
    private boolean unfinished;
    private Dirty untold = Dirty.NONE;
    private long toldAt;

    /** The pixels now; null before the first picture. */
    public synchronized Pixels pixels() {
        return pixels;
    }

    @Override
    public synchronized void rendered(Frame frame) {
        finished = frame.finished() ? frame.scene() : null;
        // What it lacks is seen already.
        if (frame.finished() || frame.scene() != aheadOf || !frame.look().isPlain()) {
            show(frame.seen());
        } else {
            shown = frame.seen();
        }
    }

    @Override
    public synchronized void coarse(Film film, Scene scene) {
        if (scene == aheadOf) {
            return;
        }
        coarse(film, scene.picture().width(), scene.picture().height());
    }

    /** A tile comes into what a coarse picture shows; where none did, the whole picture is there soon. */
    @Override
    public synchronized void tile(Scene scene, int tile, float[][] film) {
        int width = scene.picture().width();
        int height = scene.picture().height();
        if (!fits(width, height) || scene == aheadOf) {
            return;
        }
        int across = Film.tilesAlong(width);
        int left = tile % across * Film.TILE;
        int top = tile / across * Film.TILE;
        view.packTile(film[0], film[1], film[2], left, top, width, pixels.pixels());
        unfinished = true;
        untold = untold.plus(left, top, Math.min(left + Film.TILE, width), Math.min(top + Film.TILE, height));
        long now = System.nanoTime();
        if (now - toldAt > STEP_NS) {
            dirty = dirty.plus(untold.left(), untold.top(), untold.right(), untold.bottom());
            untold = Dirty.NONE;
            toldAt = now;
        }
    }

    /** Goes back from a picture that was given up to the one before. */
    @Override
    public synchronized void idle() {
        if (coarse == null && !unfinished) {
            return;
        }
        if (shown == null) {
            forget();
        } else {
            show(shown);
        }
    }

    /**
     * Shows the picture of a scene that is being traced, as it was made elsewhere, until it is finished here or given up; nothing where it is
     * finished.
     */
    public synchronized void ahead(Film film, Scene scene) {
        if (scene == finished) {
            return;
        }
        forgetAhead();
        coarse = null;
        size(film.width(), film.height());
        pack(film, IntStream.range(0, film.tileCount()).toArray());
        ahead = film;
        aheadOf = scene;
        unfinished = true;
        untold = Dirty.NONE;
        patch = Dirty.NONE;
    }

    private void forgetAhead() {
        ahead = null;
        aheadOf = null;
    }

    /** The picture of another document is none of this one. */
    @Override
    public synchronized void forgotten(long number) {
        forget();
    }

    private void forget() {
        pixels = null;
        shown = null;
        coarse = null;
        forgetAhead();
        finished = null;
        unfinished = false;
        untold = Dirty.NONE;
        dirty = Dirty.NONE;
        patch = Dirty.NONE;
    }

    /** What changed since the last call. */
    public synchronized Dirty takeDirty() {
        Dirty taken = dirty;
        dirty = Dirty.NONE;
        return taken;
    }

    /** Shows another picture; tiles that it shares with the one before are not packed again. */
    synchronized void show(Film film) {
        boolean fresh = shown == null || coarse != null || unfinished || !patch.isEmpty() || !fits(film.width(), film.height());
        size(film.width(), film.height());
        pack(film, IntStream.range(0, film.tileCount()).filter(tile -> fresh || film.red(tile) != shown.red(tile)
                || film.green(tile) != shown.green(tile) || film.blue(tile) != shown.blue(tile)).toArray());
        shown = film;
        coarse = null;
        forgetAhead();
        unfinished = false;
        untold = Dirty.NONE;
        patch = Dirty.NONE;
    }

    /** Shows a part of another picture of the same size, until the next picture comes. */
    public synchronized void patch(Film film, Dirty part) {
        if (!fits(film.width(), film.height())) {
            return;
        }
        int[] all = pixels.pixels();
        for (int y = part.top(); y < part.bottom(); y++) {
            for (int x = part.left(); x < part.right(); x++) {
                all[y * film.width() + x] = view.pack(film.red(x, y), film.green(x, y), film.blue(x, y));
            }
        }
        patch = patch.plus(part.left(), part.top(), part.right(), part.bottom());
        dirty = dirty.plus(part.left(), part.top(), part.right(), part.bottom());
    }

    /** Whether a part shows another picture than the rest. */
    public synchronized boolean isPatched() {
        return !patch.isEmpty();
    }

    /** Shows a small picture, enlarged to the size of the one that is being traced. */
    synchronized void coarse(Film film, int width, int height) {
        size(width, height);
        forgetAhead();
        coarse = film;
        int[] small = view.toPixels(film);
        int[] large = pixels.pixels();
        for (int y = 0; y < height; y++) {
            int from = (int) ((long) y * film.height() / height) * film.width();
            for (int x = 0; x < width; x++) {
                large[y * width + x] = small[from + (int) ((long) x * film.width() / width)];
            }
        }
        dirty = dirty.plus(0, 0, width, height);
    }

    /** Another exposure: everything is packed again. */
    synchronized void setView(ViewTransform v) {
        view = v;
        if (ahead != null) {
            pack(ahead, IntStream.range(0, ahead.tileCount()).toArray());
        } else if (coarse != null) {
            coarse(coarse, pixels.width(), pixels.height());
        } else if (shown != null) {
            Film film = shown;
            shown = null;
            show(film);
        }
    }

    public synchronized ViewTransform view() {
        return view;
    }

    private boolean fits(int width, int height) {
        return pixels != null && pixels.width() == width && pixels.height() == height;
    }

    private void size(int width, int height) {
        if (!fits(width, height)) {
            patch = Dirty.NONE;
            pixels = new Pixels(width, height, new int[Math.multiplyExact(width, height)]);
            dirty = Dirty.NONE.plus(0, 0, width, height);
        }
    }

    /** All processors share the work: it takes as long as a small edit does. */
    private void pack(Film film, int[] tiles) {
        Arrays.stream(tiles).parallel().forEach(tile -> view.packTile(film, tile, pixels.pixels()));
        for (int tile : tiles) {
            int left = tile % film.tilesX() * Film.TILE;
            int top = tile / film.tilesX() * Film.TILE;
            dirty = dirty.plus(left, top, Math.min(left + Film.TILE, film.width()), Math.min(top + Film.TILE, film.height()));
        }
    }
}
