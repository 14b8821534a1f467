package lightning.render.relight.tile;

import lightning.render.image.Film;
import lightning.render.shading.FilmParts;
import lightning.render.shading.composition.FilmMixer;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.effects.SceneEffects;

/** Memory of the films that the tiles of a picture keep. */
public final class FilmMemory {
    /** With so many films, reading them is much faster than composing them again. */
    private static final int MANY_FILMS = 8;

    private FilmMemory() {}

    /** Returns whether keeping the films of pixel centers pays from the start: composing them gathers light, crosses fog, or reads the rows of many lights. */
    static boolean pays(Scene scene) {
        boolean hasManyRows = scene.picture().sampling().isSupersampled() || SceneEffects.of(scene).spawnsSecondaryRays();
        return scene.world().fog().isPresent() || GatherSettings.of(scene).isPresent()
                || hasManyRows && FilmParts.of(scene).shining().cardinality() >= MANY_FILMS;
    }

    /** Returns the maximum bytes of the films of pixel centers. */
    static long centerBytes(Scene scene) {
        return bytes(scene, 1);
    }

    /** Returns the maximum bytes of the films of finer samples: means of two groups of samples, and their mean. */
    public static long maxSampleBytes(Scene scene) {
        return scene.picture().sampling().isSupersampled() ? bytes(scene, 3) : 0;
    }

    /** Returns the maximum bytes of all films that are kept, before weights are edited. */
    public static long maxBytes(Scene scene, boolean centersOnly) {
        return (pays(scene) ? centerBytes(scene) : 0) + (centersOnly ? 0 : maxSampleBytes(scene));
    }

    /** Returns whether there are many films, and memory for the sums of branches beside one of them: one for each level of the tree. */
    static boolean canKeepBranches(Scene scene, int films, long memory) {
        long columns = 2L * scene.picture().width() * scene.picture().height() * (Integer.SIZE - Integer.numberOfLeadingZeros(films));
        return films > MANY_FILMS && 3L * Float.BYTES * columns <= memory / 8;
    }

    private static long bytes(Scene scene, int copies) {
        PictureSettings picture = scene.picture();
        long tiles = (long) Film.tilesAlong(picture.width()) * Film.tilesAlong(picture.height());
        return copies * tiles * Film.TILE_PIXELS * (bytesPerPixel(scene) + 3L * Float.BYTES * FilmMixer.EARLIER_FILMS);
    }

    /** Returns the maximum bytes of all films of a pixel, if mirrors are current. */
    public static long bytesPerPixel(Scene scene) {
        return 3L * Float.BYTES * FilmParts.of(scene).shining().cardinality();
    }
}
