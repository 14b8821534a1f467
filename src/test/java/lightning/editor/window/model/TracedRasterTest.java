package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class TracedRasterTest {
    private static final int WIDTH = 70;
    private static final int HEIGHT = 40;

    private final TracedRaster raster = new TracedRaster();
    private final Film first = filled(0.5f);

    /** Returns a film of a single gray. */
    private static Film filled(float value) {
        return filled(WIDTH, HEIGHT, value);
    }

    private static Film filled(int width, int height, float value) {
        float[] rgb = new float[width * height * 3];
        java.util.Arrays.fill(rgb, value);
        return Film.ofScanlines(width, height, rgb);
    }

    /** Returns the first film with one tile replaced. */
    private Film withTile(int tile, float value) {
        Film other = filled(value);
        float[][] red = new float[first.tileCount()][];
        for (int t = 0; t < red.length; t++) {
            red[t] = t == tile ? other.red(t) : first.red(t);
        }
        float[][] green = new float[red.length][];
        float[][] blue = new float[red.length][];
        for (int t = 0; t < red.length; t++) {
            green[t] = first.green(t);
            blue[t] = first.blue(t);
        }
        return new Film(WIDTH, HEIGHT, red, green, blue);
    }

    /** Returns a film with all channels of one tile replaced. */
    private static Film withTile(int tile, float value, Film base) {
        Film other = filled(value);
        float[][][] rgb = new float[3][base.tileCount()][];
        for (int t = 0; t < base.tileCount(); t++) {
            Film from = t == tile ? other : base;
            rgb[0][t] = from.red(t);
            rgb[1][t] = from.green(t);
            rgb[2][t] = from.blue(t);
        }
        return new Film(WIDTH, HEIGHT, rgb[0], rgb[1], rgb[2]);
    }

    @BeforeEach
    void show() {
        raster.show(first);
        raster.takeDirty();
    }

    private int[] pixels() {
        return raster.pixels().pixels();
    }

    @Test
    void changedTile_isOnlyDirtyArea() {
        Film next = withTile(4, 0.9f);
        raster.show(next);
        assertThat(raster.takeDirty()).isEqualTo(new TracedRaster.DirtyRect(32, 32, 64, 40));
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(next));
    }

    @Test
    void dirtyArea_isReturnedOnce() {
        raster.show(filled(0.1f));
        assertThat(raster.takeDirty().isEmpty()).isFalse();
        assertThat(raster.takeDirty().isEmpty()).isTrue();
    }

    @Test
    void sameSize_keepsThePixels() {
        TracedRaster.Pixels before = raster.pixels();
        raster.show(filled(0.9f));
        assertThat(raster.pixels()).isSameAs(before);
    }

    private static Scene scene(int width, int height) {
        return new Scene(PictureSettings.DEFAULT.withSize(width, height), Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of());
    }

    private static float[][] tile(float value) {
        Film film = filled(32, 32, value);
        return new float[][] {film.red(0), film.green(0), film.blue(0)};
    }

    @Test
    void tileOfUnfinishedPicture_isDrawnOverCoarsePicture() {
        raster.showCoarse(filled(4, 2, 0.2f), WIDTH, HEIGHT);
        raster.takeDirty();
        raster.tileRendered(scene(WIDTH, HEIGHT), 4, tile(0.9f));
        assertThat(raster.takeDirty()).isEqualTo(new TracedRaster.DirtyRect(32, 32, 64, 40));
        assertThat(pixels()[32 * WIDTH + 32]).isEqualTo(ViewTransform.DEFAULT.toPixels(filled(0.9f))[0]);
        assertThat(pixels()[31 * WIDTH + 32]).isEqualTo(ViewTransform.DEFAULT.toPixels(filled(0.2f))[0]);
    }

    private static Frame frame(Film film, Scene scene, boolean finished) {
        return new Frame(film, film, DisplayMode.FULL_PICTURE, scene, scene, null, null, null, Frame.Step.ALL_LIGHT, finished);
    }

    private void assertShows(Film film) {
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(film));
    }

    @Test
    void remoteFilm_staysWhileSceneIsTraced() {
        Scene scene = scene(WIDTH, HEIGHT);
        Film elsewhere = filled(0.7f);
        raster.coarseRendered(filled(4, 2, 0.2f), scene);
        raster.showRemote(elsewhere, scene);
        raster.coarseRendered(filled(4, 2, 0.3f), scene);
        raster.tileRendered(scene, 4, tile(0.9f));
        raster.rendered(frame(filled(0.1f), scene, false));
        assertShows(elsewhere);
        raster.rendered(frame(filled(0.7f), scene, true));
        assertShows(elsewhere);
        raster.setView(ViewTransform.DEFAULT.withExposure(1));
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.withExposure(1).toPixels(elsewhere));
    }

    @Test
    void remoteFilm_isReplacedByOtherSceneAndRemovedOnCancel() {
        Film elsewhere = filled(0.7f);
        raster.showRemote(elsewhere, scene(WIDTH, HEIGHT));
        raster.setView(ViewTransform.DEFAULT.withExposure(1));
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.withExposure(1).toPixels(elsewhere));
        raster.setView(ViewTransform.DEFAULT);
        raster.idle();
        assertShows(first);
        raster.showRemote(elsewhere, scene(WIDTH, HEIGHT));
        raster.rendered(frame(filled(0.1f), scene(WIDTH, HEIGHT), false));
        assertShows(filled(0.1f));
    }

    @Test
    void remoteFilm_isIgnoredForFinishedPicture() {
        Scene scene = scene(WIDTH, HEIGHT);
        raster.rendered(frame(filled(0.1f), scene, true));
        raster.showRemote(filled(0.7f), scene);
        assertShows(filled(0.1f));
    }

    @Test
    void rapidTiles_areReportedWithPicture() {
        for (int tile = 0; tile < 6; tile++) {
            raster.tileRendered(scene(WIDTH, HEIGHT), tile, tile(0.9f));
        }
        raster.show(withTile(4, 0.1f));
        assertThat(raster.takeDirty()).isEqualTo(new TracedRaster.DirtyRect(0, 0, WIDTH, HEIGHT));
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(withTile(4, 0.1f)));
    }

    @Test
    void tileOfAnotherSize_isNotShown() {
        raster.tileRendered(scene(WIDTH, HEIGHT + 1), 0, tile(0.9f));
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(first));
    }

    @Test
    void failedPicture_isReplacedByPreviousPicture() {
        raster.showCoarse(filled(4, 2, 0.2f), 100, 50);
        raster.tileRendered(scene(100, 50), 0, tile(0.9f));
        raster.idle();
        assertThat(raster.pixels().width()).isEqualTo(WIDTH);
        assertShows(first);
    }

    @Test
    void failedFirstPicture_keepsItsCoarsePicture() {
        raster.pictureDropped(1);
        raster.showCoarse(filled(4, 2, 0.2f), 100, 50);
        raster.idle();
        assertThat(raster.pixels().width()).isEqualTo(100);
    }

    @Test
    void canceledPicture_keepsWhatIsShownUntilNextPicture() {
        raster.showCoarse(filled(4, 2, 0.2f), WIDTH, HEIGHT);
        raster.tileRendered(scene(WIDTH, HEIGHT), 4, tile(0.9f));
        int[] shown = pixels().clone();
        raster.canceled();
        raster.idle();
        raster.idle();
        assertThat(pixels()).isEqualTo(shown);
        assertThat(raster.isUnfinished()).isTrue();
        raster.show(first);
        assertShows(first);
        assertThat(raster.isUnfinished()).isFalse();
    }

    @Test
    void failureAfterCanceledPicture_restoresPreviousPicture() {
        raster.showCoarse(filled(4, 2, 0.2f), WIDTH, HEIGHT);
        raster.canceled();
        raster.idle();
        raster.started(new UpdatePlan.Nothing());
        raster.idle();
        assertShows(first);
    }

    @Test
    void exposureChangeOfUnfinishedPicture_keepsItsTiles() {
        var brighter = new ViewTransform(1);
        raster.tileRendered(scene(WIDTH, HEIGHT), 4, tile(0.9f));
        raster.setView(brighter);
        assertThat(pixels()).isEqualTo(brighter.toPixels(withTile(4, 0.9f, first)));
        raster.showCoarse(filled(4, 2, 0.2f), WIDTH, HEIGHT);
        raster.tileRendered(scene(WIDTH, HEIGHT), 4, tile(0.9f));
        raster.setView(ViewTransform.DEFAULT);
        assertShows(withTile(4, 0.9f, filled(0.2f)));
    }

    @Test
    void coarsePicture_fillsFinalSize() {
        raster.showCoarse(filled(4, 2, 0.2f), 100, 50);
        assertThat(raster.pixels().width()).isEqualTo(100);
        assertThat(pixels()).containsOnly(ViewTransform.DEFAULT.toPixels(filled(1, 1, 0.2f))[0]);
    }

    @Test
    void pictureAfterCoarseOne_isPackedCompletely() {
        raster.showCoarse(filled(4, 2, 0.2f), WIDTH, HEIGHT);
        raster.show(first);
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(first));
    }

    @Test
    void patch_showsOnlyItsPartUntilNextPicture() {
        raster.patch(filled(0.9f), new TracedRaster.DirtyRect(10, 10, 20, 12));
        assertThat(raster.isPatched()).isTrue();
        assertThat(pixels()[10 * WIDTH + 10]).isNotEqualTo(pixels()[0]);
        assertThat(pixels()[12 * WIDTH + 10]).isEqualTo(pixels()[0]);
        raster.show(first);
        assertThat(raster.isPatched()).isFalse();
        assertThat(pixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(first));
    }

    @Test
    void patchOfAnotherSize_isNotShown() {
        raster.patch(filled(20, 20, 0.9f), new TracedRaster.DirtyRect(0, 0, 20, 20));
        assertThat(raster.isPatched()).isFalse();
    }

    @Test
    void exposureChange_repacksAllPixels() {
        var brighter = new ViewTransform(1);
        raster.setView(brighter);
        assertThat(pixels()).isEqualTo(brighter.toPixels(first));
    }

    @Test
    void exposureChange_keepsCoarsePicture() {
        raster.showCoarse(filled(4, 2, 0.2f), WIDTH, HEIGHT);
        var brighter = new ViewTransform(1);
        raster.setView(brighter);
        assertThat(pixels()).containsOnly(brighter.toPixels(filled(1, 1, 0.2f))[0]);
    }
}
