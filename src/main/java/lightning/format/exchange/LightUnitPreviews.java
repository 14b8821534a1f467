package lightning.format.exchange;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;

/** Preview renderer for each possible unit of an imported file's lights. */
public final class LightUnitPreviews {
    /** Anti-aliasing for small images, where aliasing is most visible. */
    private static final SamplingSettings EDGES = new SamplingSettings(AntialiasMode.EDGES, 4);

    private LightUnitPreviews() {}

    /**
     * Renders an image for each light unit, without textures, since these are not read before the scene is written. Empty if
     * the file defines its units.
     *
     * @param size longer side in pixels, at least 1
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static Map<LightUnits, Film> render(ImportedScene imported, int size, WorkerPool workers, Progress progress) {
        Map<LightUnits, Film> films = new EnumMap<>(LightUnits.class);
        if (imported.units().isEmpty()) {
            return films;
        }
        Scene small = small(imported.unscaledScene(), size);
        var geometry = Geometry.of(small);
        for (LightUnits units : LightUnits.values()) {
            Scene scene = small.withRig(imported.inUnits(units).scene().rig());
            ProgressPart part = new ProgressPart(progress, 0, 1).section(units.ordinal(), LightUnits.values().length);
            films.put(units, trace(new TraditionalTracer(scene, geometry), workers, part));
        }
        return films;
    }

    /** Renders an image of a scene, without textures. */
    static Film render(Scene scene, int size, WorkerPool workers, Progress progress) {
        return trace(new TraditionalTracer(small(scene, size)), workers, progress);
    }

    /** Uses the scalar engine: the lanes for meshes are not compiled yet if the scene before had none, and these images are small. */
    private static Film trace(TraditionalTracer tracer, WorkerPool workers, Progress progress) {
        return tracer.withEngines(_ -> Engines.SCALAR).trace(workers, progress).film();
    }

    private static Scene small(Scene scene, int size) {
        PictureSettings settings = scene.picture();
        double scale = (double) size / Math.max(settings.width(), settings.height());
        PictureSettings small = settings.withSize((int) Math.ceil(scale * settings.width()), (int) Math.ceil(scale * settings.height()))
                .withSampling(EDGES).withIndirect(Optional.empty());
        List<Material> untextured = scene.materials().stream()
                .map(Material::withoutImages).toList();
        return scene.withMaterials(untextured).withPicture(small);
    }
}
