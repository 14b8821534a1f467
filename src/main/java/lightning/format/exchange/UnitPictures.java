package lightning.format.exchange;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.scene.Antialias;
import lightning.scene.Cutout;
import lightning.scene.Material;
import lightning.scene.Picture;
import lightning.scene.Relief;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/** What a scene looks like with its lights' numbers taken as each of what they may be. */
public final class UnitPictures {
    /** Small pictures show their pixels most. */
    private static final Sampling EDGES = new Sampling(Antialias.EDGES, 4);

    private UnitPictures() {}

    /**
     * A picture for each choice, without textures, which are not read before the scene is written; none where the file says what the
     * numbers are.
     *
     * @param size pixels of the longer side, at least 1
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static Map<LightUnits, Film> of(Import read, int size, Workers workers, Progress progress) {
        Map<LightUnits, Film> films = new EnumMap<>(LightUnits.class);
        if (read.units().isEmpty()) {
            return films;
        }
        Picture picture = read.asRead().picture();
        double scale = (double) size / Math.max(picture.width(), picture.height());
        Picture small = picture.withSize((int) Math.ceil(scale * picture.width()), (int) Math.ceil(scale * picture.height()))
                .withSampling(EDGES);
        List<Material> plain = read.asRead().materials().stream()
                .map(m -> m.withTexture(Optional.empty()).withCutout(Cutout.NONE).withRelief(Relief.NONE)).toList();
        Geometry geometry = null;
        for (LightUnits units : LightUnits.values()) {
            Scene scene = read.in(units).scene().withMaterials(plain).withPicture(small);
            geometry = geometry == null ? new Geometry(scene) : geometry;
            films.put(units, new TraditionalTracer(scene, geometry).trace(workers, progress).film());
        }
        return films;
    }
}
