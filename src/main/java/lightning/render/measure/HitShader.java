package lightning.render.measure;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import lightning.render.engine.Engine;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightWeight;
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
    private final FilmParts parts;
    private final BitSet shining;
    private final float[][] film = new float[3][RayBatch.MAX_RAYS];
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
        parts = FilmParts.of(scene);
        shining = parts.shining();
    }

    /** Returns the hits of the traced rays of a batch. */
    static HitRows rows(RayBatch batch) {
        return batch.rows((hits, texels, transparent) -> new HitRows(hits, texels, transparent, false, true));
    }

    /** Writes all columns at the rays that hit. */
    void shade(HitRows rows) {
        columns.reset();
        WeightedLight[] lights = parts.lights();
        LightLayer[] layers = new LightLayer[lights.length];
        for (int l = 0; l < lights.length; l++) {
            layers[l] = lights[l].isDark() ? null : kernel.recompute(rows, lights[l].source(), columns);
        }
        shadeUnlit(rows);
        shader.start(rows);
        clear(direct);
        for (int part = shining.nextSetBit(0); part >= 0; part = shining.nextSetBit(part + 1)) {
            clear(film);
            if (shader.writeDirectLight(rows, parts, part, layers, RAYS_BY_INDEX, film)) {
                addTo(direct, parts.get(part).weight());
            }
            clear(film);
            shader.addShownLight(rows, parts, part, layers, RAYS_BY_INDEX, film);
            addTo(seen, parts.get(part).weight());
        }
    }

    /** Writes all columns but the lights' sum. */
    void shadeUnlit(HitRows rows) {
        shader.writeAlbedo(rows, RAYS_BY_INDEX, albedo);
        clear(seen);
        for (int part = shining.nextSetBit(0); part >= 0; part = shining.nextSetBit(part + 1)) {
            shader.writeEmission(rows, parts, part, RAYS_BY_INDEX, film);
            addTo(seen, parts.get(part).weight());
            if (parts.get(part).kind() == FilmPart.Kind.REST) {
                shader.writeEmission(rows, parts, part, RAYS_BY_INDEX, glow);
            }
        }
    }

    private static void clear(float[][] columns) {
        for (float[] column : columns) {
            Arrays.fill(column, 0);
        }
    }

    private void addTo(float[][] columns, LightWeight weight) {
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < columns[c].length; i++) {
                columns[c][i] += weight.channel(c) * film[c][i];
            }
        }
    }
}
