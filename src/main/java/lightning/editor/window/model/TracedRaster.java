package lightning.editor.window.model;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderListener;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Display pixels of the traced picture. Packs only the tiles whose film changed; a new size allocates new pixels.
 *
 * <p>Thread-safe. Readers may see tiles of the next picture early, but never a torn pixel.
 */
public final class TracedRaster implements RenderListener {
    /** @param pixels  {@code int[width * height]}, opaque 0xFFRRGGBB, top row first */
    public record Pixels(int width, int height, int[] pixels) {}

    /** Changed columns and rows, [left, right) and [top, bottom). */
    public record DirtyRect(int left, int top, int right, int bottom) {
        public static final DirtyRect NONE = new DirtyRect(Integer.MAX_VALUE, Integer.MAX_VALUE, 0, 0);

        public boolean isEmpty() {
            return left >= right;
        }

        public DirtyRect plus(int l, int t, int r, int b) {
            return new DirtyRect(Math.min(left, l), Math.min(top, t), Math.max(right, r), Math.max(bottom, b));
        }
    }

    /** Minimum interval between reports of new tiles, nanoseconds. Limits repainting. */
    private static final long REPORT_INTERVAL_NS = 40_000_000;

    private @Nullable Pixels pixels;
    private @Nullable Film shownFilm;
    private @Nullable Film coarseFilm;
    /** Film that another machine rendered of the scene being traced, and that scene; null if none is shown. */
    private @Nullable Film remoteFilm;
    private @Nullable Scene remoteScene;
    /** Scene of the last displayed picture if it has all samples, else null. */
    private @Nullable Scene finishedScene;
    private ViewTransform view = ViewTransform.DEFAULT;
    private DirtyRect dirty = DirtyRect.NONE;
    private DirtyRect patch = DirtyRect.NONE;
    /** State of an unfinished picture: whether tiles were shown, which tiles are not reported yet, and the time of the last report. */
    private boolean isUnfinished;
    /** Finished tiles over a coarse or earlier film, by number. */
    private final Map<Integer, float[][]> tiles = new HashMap<>();
    /** True after a cancellation, until the next render starts. */
    private boolean isCanceled;
    private DirtyRect unreported = DirtyRect.NONE;
    private long lastReportNs;

    /** Returns the current pixels, or null before the first picture. */
    public synchronized @Nullable Pixels pixels() {
        return pixels;
    }

    @Override
    public synchronized void rendered(Frame frame) {
        finishedScene = frame.isFinished() ? frame.scene() : null;
        // The remote film already has all samples.
        if (frame.isFinished() || !isOfRemoteScene(frame) || !frame.displayMode().isFullPicture()) {
            show(frame.displayed());
        } else {
            shownFilm = frame.displayed();
        }
    }

    /** Returns whether a frame shows the remote scene, or its direct light. */
    private boolean isOfRemoteScene(Frame frame) {
        return remoteScene != null && (frame.scene() == remoteScene || frame.showsDirectLightOf(remoteScene));
    }

    @Override
    public synchronized void coarseRendered(Film film, Scene scene) {
        if (scene == remoteScene) {
            return;
        }
        showCoarse(film, scene.picture().width(), scene.picture().height());
    }

    /** Packs a tile over the coarse or previous picture. Ignored without one, since the whole picture follows soon. */
    @Override
    public synchronized void tileRendered(Scene scene, int tile, float[][] film) {
        int width = scene.picture().width();
        int height = scene.picture().height();
        if (!hasSize(width, height) || scene == remoteScene) {
            return;
        }
        int tilesAcross = Film.tilesAlong(width);
        int left = tile % tilesAcross * Film.TILE_SIZE;
        int top = tile / tilesAcross * Film.TILE_SIZE;
        view.packTile(film[0], film[1], film[2], left, top, width, currentPixels().pixels());
        tiles.put(tile, film);
        isUnfinished = true;
        unreported = unreported.plus(left, top, Math.min(left + Film.TILE_SIZE, width), Math.min(top + Film.TILE_SIZE, height));
        long now = System.nanoTime();
        if (now - lastReportNs > REPORT_INTERVAL_NS) {
            dirty = dirty.plus(unreported.left(), unreported.top(), unreported.right(), unreported.bottom());
            unreported = DirtyRect.NONE;
            lastReportNs = now;
        }
    }

    @Override
    public synchronized void started(UpdatePlan plan) {
        isCanceled = false;
    }

    @Override
    public synchronized void canceled() {
        isCanceled = true;
    }

    /** Restores the previous picture after a failed render. After a canceled one, keeps what is shown. */
    @Override
    public synchronized void idle() {
        if (!isUnfinished() || isCanceled) {
            return;
        }
        if (shownFilm != null) {
            show(shownFilm);
        }
    }

    /** Returns whether a part of the picture is coarse, or newer than the last frame. */
    public synchronized boolean isUnfinished() {
        return coarseFilm != null || isUnfinished;
    }

    /** Shows a remote film of the scene being traced until the local render is finished or canceled. Ignored if it is finished. */
    public synchronized void showRemote(Film film, Scene scene) {
        if (scene == finishedScene) {
            return;
        }
        clearRemote();
        coarseFilm = null;
        resize(film.width(), film.height());
        pack(film, IntStream.range(0, film.tileCount()).toArray());
        remoteFilm = film;
        remoteScene = scene;
        isUnfinished = true;
        tiles.clear();
        unreported = DirtyRect.NONE;
        patch = DirtyRect.NONE;
    }

    private void clearRemote() {
        remoteFilm = null;
        remoteScene = null;
    }

    /** Clears the raster when another document is opened. */
    @Override
    public synchronized void pictureDropped(long number) {
        clear();
    }

    private void clear() {
        pixels = null;
        shownFilm = null;
        coarseFilm = null;
        clearRemote();
        finishedScene = null;
        isUnfinished = false;
        isCanceled = false;
        tiles.clear();
        unreported = DirtyRect.NONE;
        dirty = DirtyRect.NONE;
        patch = DirtyRect.NONE;
    }

    /** Returns the area that changed since the last call. */
    public synchronized DirtyRect takeDirty() {
        DirtyRect result = dirty;
        dirty = DirtyRect.NONE;
        return result;
    }

    /** Shows a picture. Tiles shared with the previous one are not packed again. */
    synchronized void show(Film film) {
        boolean isNew =
                shownFilm == null || coarseFilm != null || isUnfinished || !patch.isEmpty() || !hasSize(film.width(), film.height());
        resize(film.width(), film.height());
        pack(film, IntStream.range(0, film.tileCount()).filter(tile -> isNew || film.red(tile) != requireNonNull(shownFilm).red(tile)
                || film.green(tile) != shownFilm.green(tile) || film.blue(tile) != shownFilm.blue(tile)).toArray());
        shownFilm = film;
        coarseFilm = null;
        clearRemote();
        isUnfinished = false;
        tiles.clear();
        unreported = DirtyRect.NONE;
        patch = DirtyRect.NONE;
    }

    /** Shows part of another picture of equal size until the next picture arrives. */
    public synchronized void patch(Film film, DirtyRect part) {
        if (!hasSize(film.width(), film.height())) {
            return;
        }
        int[] all = currentPixels().pixels();
        for (int y = part.top(); y < part.bottom(); y++) {
            for (int x = part.left(); x < part.right(); x++) {
                all[y * film.width() + x] = view.pack(film.red(x, y), film.green(x, y), film.blue(x, y));
            }
        }
        patch = patch.plus(part.left(), part.top(), part.right(), part.bottom());
        dirty = dirty.plus(part.left(), part.top(), part.right(), part.bottom());
    }

    /** Returns whether a part shows another picture. */
    public synchronized boolean isPatched() {
        return !patch.isEmpty();
    }

    /** Shows a small picture scaled up to the size of the picture being traced. */
    synchronized void showCoarse(Film film, int width, int height) {
        resize(width, height);
        clearRemote();
        coarseFilm = film;
        tiles.clear();
        packCoarse(film, width, height);
    }

    private void packCoarse(Film film, int width, int height) {
        int[] small = view.toPixels(film);
        if (view.curve() == DisplayCurve.FALSE || view.marksClipping()) {
            CoarseScaling.repeat(small, film.width(), film.height(), currentPixels().pixels(), width, height);
        } else {
            CoarseScaling.smooth(small, film.width(), film.height(), currentPixels().pixels(), width, height);
        }
        dirty = dirty.plus(0, 0, width, height);
    }

    /** Sets the view transform and packs everything again. */
    synchronized void setView(ViewTransform v) {
        view = v;
        if (pixels == null) {
            return;
        }
        Film base = remoteFilm != null ? remoteFilm : shownFilm;
        if (remoteFilm == null && coarseFilm != null) {
            packCoarse(coarseFilm, pixels.width(), pixels.height());
        } else if (base != null && hasSize(base.width(), base.height())) {
            pack(base, IntStream.range(0, base.tileCount()).toArray());
        }
        int tilesAcross = Film.tilesAlong(pixels.width());
        tiles.forEach((tile, film) -> view.packTile(film[0], film[1], film[2], tile % tilesAcross * Film.TILE_SIZE,
                tile / tilesAcross * Film.TILE_SIZE, pixels.width(), pixels.pixels()));
        patch = DirtyRect.NONE;
    }

    public synchronized ViewTransform view() {
        return view;
    }

    private boolean hasSize(int width, int height) {
        return pixels != null && pixels.width() == width && pixels.height() == height;
    }

    private void resize(int width, int height) {
        if (!hasSize(width, height)) {
            patch = DirtyRect.NONE;
            pixels = new Pixels(width, height, new int[Math.multiplyExact(width, height)]);
            dirty = DirtyRect.NONE.plus(0, 0, width, height);
        }
    }

    /** Packs tiles in parallel: packing takes as long as a small edit. */
    private void pack(Film film, int[] tiles) {
        Arrays.stream(tiles).parallel().forEach(tile -> view.packTile(film, tile, currentPixels().pixels()));
        for (int tile : tiles) {
            int left = tile % film.tilesX() * Film.TILE_SIZE;
            int top = tile / film.tilesX() * Film.TILE_SIZE;
            dirty = dirty.plus(left, top, Math.min(left + Film.TILE_SIZE, film.width()), Math.min(top + Film.TILE_SIZE, film.height()));
        }
    }

    /** Returns the pixels, which exist while there are tiles or films. */
    private Pixels currentPixels() {
        return requireNonNull(pixels);
    }
}
