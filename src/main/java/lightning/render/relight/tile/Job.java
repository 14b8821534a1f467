package lightning.render.relight.tile;

import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.shading.Luminaire;
import lightning.render.trace.ShapeChange;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/**
 * What all threads of one update share, made ready once.
 *
 * @param shown    what the first level shall show
 * @param mirrored what the mirror levels shall show: the same where they are updated too, and in a first pass
 * @param top      the update of the first level; null in a first pass
 * @param mirrors  the update of the mirror levels; null where they stay, and in a first pass
 * @param shapes   what became of the shapes
 * @param depthBefore the depth of the picture before; that of the scene in a first pass
 * @param coding   whether anti-aliasing looks for edges
 */
public record Job(PreparedScene shown, PreparedScene mirrored, Options options, LevelJob top, LevelJob mirrors, ShapeChange shapes,
        int depthBefore, boolean coding,
        Progress progress) {

    Scene scene() {
        return shown.scene();
    }

    /** Whether mirror levels are kept as full rows. */
    boolean keepsRows() {
        return options.storage() == MirrorStorage.FULL_ROWS;
    }

    /** Whether rows must know whose they are. */
    boolean owned() {
        return Luminaire.anyLinked(shown.lights()) || Luminaire.anyLinked(mirrored.lights());
    }

    int depth() {
        return scene().picture().depth();
    }

    Sampling sampling() {
        return scene().picture().sampling();
    }

    int tilesX() {
        return Film.tilesAlong(scene().picture().width());
    }

    int tileCount() {
        return tilesX() * Film.tilesAlong(scene().picture().height());
    }
}
