package lightning.render.measure;

import java.util.stream.IntStream;
import lightning.render.engine.Engine;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.SurfelShader;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.ScratchColumns;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/** Light of what the rays of a batch hit, by the kernels of the picture. Holds scratch memory: use one instance per thread. */
final class HitShader {
    private static final int[] RAYS_BY_INDEX = IntStream.range(0, RayBatch.MAX_RAYS).toArray();

    private final LightKernel kernel;
    private final SurfelShader shader;
    private final WeightedLight[] lights;
    private final float ambience;
    private final ScratchColumns columns = new ScratchColumns();
    /** Lights' diffuse sum where each ray hits: red, green and blue. */
    final float[][] direct = new float[3][RayBatch.MAX_RAYS];
    /** Share of the light that is sent back. */
    final float[][] albedo = new float[3][RayBatch.MAX_RAYS];
    /** Light that the surface emits itself, without bulbs. */
    final float[][] glow = new float[3][RayBatch.MAX_RAYS];
    /** Light that a picture shows of the surface, without the light that it gathers. */
    final float[][] seen = new float[3][RayBatch.MAX_RAYS];

    HitShader(Scene scene, Geometry geometry, Engine engine, Tracer tracer) {
        kernel = new LightKernel(geometry, tracer, engine.terms(), ViewEffects.ALL);
        shader = new SurfelShader(geometry.materials(), engine.sums());
        lights = WeightedLight.ofScene(scene);
        ambience = (float) scene.world().ambience();
    }

    /** Returns the hits of the traced rays of a batch. */
    static HitRows rows(RayBatch batch) {
        return batch.rows((hits, texels, transparent) -> new HitRows(hits, texels, transparent, false, true));
    }

    /** Writes all columns at the rays that hit. */
    void shade(HitRows rows) {
        columns.reset();
        LightLayer[] layers = new LightLayer[lights.length];
        for (int l = 0; l < lights.length; l++) {
            layers[l] = lights[l].isDark() ? null : kernel.recompute(rows, lights[l].source(), columns);
        }
        shader.writeDirectLight(rows, lights, layers, RAYS_BY_INDEX, direct);
        shadeUnlit(rows);
        shader.addShownLight(rows, lights, layers, RAYS_BY_INDEX, seen, seen);
    }

    /** Writes all columns but the lights' sum. */
    void shadeUnlit(HitRows rows) {
        shader.writeReflection(rows, RAYS_BY_INDEX, albedo, glow, seen, ambience);
    }
}
