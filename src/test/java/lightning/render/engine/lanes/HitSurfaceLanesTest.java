package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import lightning.base.math.PowerFunction;
import lightning.format.jen.JenReader;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.Scene;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;

/** Tests that lanes compute the surfaces that shadow rays cross, and powers, with the bits of the scalar functions. */
class HitSurfaceLanesTest {
    private static final int RAYS = ShadowRayBatch.MAX_RAYS;
    /** Runs long enough for the optimizing compiler, since interpreted vector code proves nothing about its bits. */
    private static final int BATCHES = 60;

    @Test
    void surfacesOfGlass_matchScalarBits() throws Exception {
        Scene scene = JenReader.read(Path.of("scenes/product.jen")).scene();
        Geometry geometry = Geometry.of(scene).shadowGeometry(ShapeLinks.ALL);
        Tracer scalar = Engines.SCALAR.tracer(geometry);
        Tracer lanes = new LaneEngine().tracer(geometry);
        var candidates = CandidateList.fromBvh(geometry.tintBvh(), geometry.tintCasters());
        var rays = new ShadowRayBatch();
        var expected = new ShadowRayHits(RAYS);
        var hits = new ShadowRayHits(RAYS);
        var random = new Random(1);
        int fromInside = 0;
        int grazing = 0;
        for (int n = 0; n < BATCHES; n++) {
            fill(rays, candidates, random);
            expected.clear();
            hits.clear();
            scalar.findHits(rays, candidates, expected);
            lanes.findHits(rays, candidates, hits);
            scalar.writeHitSurfaces(rays, expected);
            lanes.writeHitSurfaces(rays, hits);
            for (int k = 0; k < rays.count; k++) {
                int i = hits.first(k);
                for (int e = expected.first(k); e != ShadowRayHits.END; e = expected.next(e)) {
                    assertThat(hits.part[i]).isEqualTo(expected.part[e]);
                    assertThat(hits.inside[i]).isEqualTo(expected.inside[e]);
                    assertThat(Float.floatToRawIntBits(hits.reflectance[i])).isEqualTo(Float.floatToRawIntBits(expected.reflectance[e]));
                    fromInside += hits.inside[i] ? 1 : 0;
                    grazing += hits.reflectance[i] > 0.9 ? 1 : 0;
                    i = hits.next(i);
                }
                assertThat(i).isEqualTo(ShadowRayHits.END);
            }
        }
        assertThat(fromInside).isGreaterThan(1000);
        assertThat(grazing).isGreaterThan(50);
    }

    /** Fills a batch with rays between points near glass shapes. */
    private static void fill(ShadowRayBatch rays, CandidateList candidates, Random random) {
        var rows = new HitRows(1024, TexelColumns.NONE);
        rays.clear();
        rays.toPoints = true;
        while (rays.count < RAYS) {
            int i = rays.count % 1024;
            rows.px[i] = (float) coordinate(candidates, random, 0);
            rows.py[i] = (float) coordinate(candidates, random, 1);
            rows.pz[i] = (float) coordinate(candidates, random, 2);
            rays.add(rows, i, coordinate(candidates, random, 0), coordinate(candidates, random, 1), coordinate(candidates, random, 2), 0);
        }
    }

    private static double coordinate(CandidateList candidates, Random random, int axis) {
        int box = 6 * random.nextInt(candidates.count) + axis;
        return candidates.boxes[box] + (1.4 * random.nextDouble() - 0.2) * (candidates.boxes[box + 3] - candidates.boxes[box]);
    }

    @Test
    void exponentials_matchScalarBits() {
        var random = new Random(2);
        for (int n = 0; n < 3000; n++) {
            double[] values = new double[100 + Tracer.EXPONENTIALS_OVERRUN];
            for (int i = 0; i < 100; i++) {
                values[i] = switch (random.nextInt(10)) {
                    case 0 -> Double.NEGATIVE_INFINITY;
                    case 1 -> -0.0;
                    default -> -Math.exp(20 * random.nextDouble() - 12);
                };
            }
            double[] expected = values.clone();
            PowerLanes.exponentials(values, 100);
            for (int i = 0; i < 100; i++) {
                expected[i] = PowerFunction.exponential(expected[i]);
            }
            assertThat(Arrays.copyOf(values, 100)).isEqualTo(Arrays.copyOf(expected, 100));
        }
    }
}
