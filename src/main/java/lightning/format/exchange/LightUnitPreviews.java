package lightning.format.exchange;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.scene.AlphaCutout;
import lightning.scene.AntialiasMode;
import lightning.scene.BumpMapping;
import lightning.scene.Material;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/** What a scene looks like with its lights' numbers taken as each of what they may be. */
public final class LightUnitPreviews {
    /** Small pictures show their pixels most. */
    private static final SamplingSettings EDGES = new SamplingSettings(AntialiasMode.EDGES, 4);

    private LightUnitPreviews() {}

    /**
     * A picture for each choice, without textures, which are not read before the scene is written; none where the file says what the
     * numbers are.
     *
     * @param size pixels of the longer side, at least 1
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static Map<LightUnits, Film> render(ImportedScene imported, int size, WorkerPool workers, Progress progress) {
        Map<LightUnits, Film> films = new EnumMap<>(LightUnits.class);
        if (imported.units().isEmpty()) {
            return films;
        }
        PictureSettings settings = imported.unscaledScene().picture();
        double scale = (double) size / Math.max(settings.width(), settings.height());
        PictureSettings small = settings.withSize((int) Math.ceil(scale * settings.width()), (int) Math.ceil(scale * settings.height()))
                .withSampling(EDGES);
        List<Material> untextured = imported.unscaledScene().materials().stream()
                .map(m -> m.withTexture(Optional.empty()).withCutout(AlphaCutout.NONE).withBumpMapping(BumpMapping.NONE)).toList();
        Geometry geometry = null;
        for (LightUnits units : LightUnits.values()) {
            Scene scene = imported.inUnits(units).scene().withMaterials(untextured).withPicture(small);
            geometry = geometry == null ? new Geometry(scene) : geometry;
            films.put(units, new TraditionalTracer(scene, geometry).trace(workers, progress).film());
        }
        return films;
    }
}
