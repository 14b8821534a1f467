package lightning.document.imports;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
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
import lightning.scene.effects.PreviewScene;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Preview renderer for each possible unit of an imported file's lights. Leaves out textures, blurred reflections and indirect light. */
public final class LightUnitPreviews {
    /** Anti-aliasing for small images, where aliasing is most visible. */
    private static final SamplingSettings EDGES = new SamplingSettings(AntialiasMode.EDGES, 4);

    private final ImportedScene imported;
    private final int size;
    private @Nullable Scene small;
    private @Nullable Geometry geometry;

    /** @param size longer side of the images in pixels, at least 1 */
    public LightUnitPreviews(ImportedScene imported, int size) {
        this.imported = imported;
        this.size = size;
    }

    /**
     * Renders an image with the lights of the file in a unit, without textures, since these are not read before the scene is written. Not
     * thread-safe.
     *
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public Film render(LightUnits units, WorkerPool workers, Progress progress) {
        if (small == null || geometry == null) {
            small = small(imported.unscaledScene(), size);
            geometry = Geometry.of(small);
        }
        Scene scene = small.withRig(imported.inUnits(units).scene().rig());
        return trace(new TraditionalTracer(scene, geometry), workers, progress);
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
        List<Material> untextured = scene.materials().stream()
                .map(Material::withoutImages).toList();
        return PreviewScene.withoutBlur(scene.withMaterials(untextured)).withPicture(small(scene.picture(), size));
    }

    /** Returns the settings of an image. */
    static PictureSettings small(PictureSettings settings, int size) {
        double scale = (double) size / Math.max(settings.width(), settings.height());
        return settings.withSize((int) Math.ceil(scale * settings.width()), (int) Math.ceil(scale * settings.height()))
                .withSampling(EDGES).withIndirect(Optional.empty());
    }
}
