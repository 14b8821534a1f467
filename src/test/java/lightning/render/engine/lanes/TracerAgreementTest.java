package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.render.engine.choice.Engines;
import lightning.render.shading.layer.RowBits;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Material;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests that lanes and scalar code agree for shapes with cutouts, and for all hits of shadow rays. */
class TracerAgreementTest {
    private static final int ROWS = 1024;

    /** Cuts out every other one of 5 × 3 pixels. */
    private static Scene withHoles(Scene scene) {
        float[] rgb = new float[45];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 % 2;
        }
        return scene.withMaterial(Material.DEFAULT
                .withCutout(new AlphaCutout(Optional.of(new TextureMap("holes.png", 3, 2, new Texture(5, 3, rgb))), 0.5)));
    }

    private static HitRows eyeRows(Geometry geometry, Scene scene, Tracer tracer) {
        return new TileVisibility(geometry, scene, tracer).traceEyeRays(0, 0, 32, (count, texels, _) -> new HitRows(count, texels));
    }

    @Property(tries = 100)
    void shapesWithHoles_sameVisibilityOnBothEngines(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Scene scene = withHoles(TraceScenes.randomScene(shapes, seed)).withPicture(new PictureSettings(32, 32, 1));
        Geometry geometry = Geometry.of(scene);
        HitRows expected = eyeRows(geometry, scene, Engines.SCALAR.tracer(geometry));
        HitRows rows = eyeRows(geometry, scene, new LaneEngine().tracer(geometry));
        assertThat(Arrays.copyOf(rows.parent, rows.count)).isEqualTo(Arrays.copyOf(expected.parent, expected.count));
        assertThat(Arrays.copyOf(rows.px, rows.count)).isEqualTo(Arrays.copyOf(expected.px, expected.count));
        assertThat(Arrays.copyOf(rows.nz, rows.count)).isEqualTo(Arrays.copyOf(expected.nz, expected.count));
    }

    @Property(tries = 100)
    void shapesWithHoles_sameOcclusionOnBothEngines(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed,
            @ForAll boolean toPoints) {
        Geometry geometry = Geometry.of(withHoles(TraceScenes.randomScene(shapes, seed)));
        var rows = new HitRows(ROWS, TexelColumns.NONE);
        RowShadowRays shadowRays = randomShadowRays(geometry, rows, seed, toPoints);
        int[] selected = selectedRows(seed);
        var candidates = CandidateList.fromBvh(geometry.bvh());
        int[] expected = new int[selected.length];
        int[] blocked = new int[selected.length];
        Engines.SCALAR.tracer(geometry).findBlocked(rows, selected, shadowRays, candidates, expected);
        new LaneEngine().tracer(geometry).findBlocked(rows, selected, shadowRays, candidates, blocked);
        assertThat(blocked).isEqualTo(expected);
    }

    @Property(tries = 100)
    void shadowRays_sameHitsOnBothEngines(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed, @ForAll boolean toPoints,
            @ForAll boolean holes) {
        Scene scene = TraceScenes.randomScene(shapes, seed);
        Geometry geometry = Geometry.of(holes ? withHoles(scene) : scene);
        var rows = new HitRows(ROWS, TexelColumns.NONE);
        RowShadowRays shadowRays = randomShadowRays(geometry, rows, seed, toPoints);
        int[] selected = selectedRows(seed);
        var rays = new ShadowRayBatch();
        rays.toPoints = toPoints;
        for (int i = 0; i < ROWS; i++) {
            if (RowBits.contains(selected, i)) {
                rays.add(rows, i, shadowRays.x[i], shadowRays.y[i], shadowRays.z[i], 0);
            }
        }
        var candidates = CandidateList.fromBvh(geometry.bvh());
        var expected = new ShadowRayHits(ROWS);
        var hits = new ShadowRayHits(ROWS);
        Engines.SCALAR.tracer(geometry).findHits(rays, candidates, expected);
        new LaneEngine().tracer(geometry).findHits(rays, candidates, hits);
        for (int k = 0; k < rays.count; k++) {
            assertThat(hitsOf(hits, k)).as("ray %s", k).isEqualTo(hitsOf(expected, k));
        }
    }

    private static List<List<Number>> hitsOf(ShadowRayHits hits, int row) {
        List<List<Number>> result = new ArrayList<>();
        for (int i = hits.first(row); i != ShadowRayHits.END; i = hits.next(i)) {
            result.add(List.of(hits.primitive[i], hits.part[i], hits.t[i]));
        }
        return result;
    }

    /** Creates shadow rays from random points around the shapes, with one target per rotation, that pass near a shape. */
    private static RowShadowRays randomShadowRays(Geometry geometry, HitRows rows, long seed, boolean toPoints) {
        Random random = new Random(seed);
        float[] boxes = CandidateList.fromBvh(geometry.bvh()).boxes;
        RowShadowRays shadowRays = new RowShadowRays();
        shadowRays.isOffSurface = true;
        shadowRays.toPoints = toPoints;
        rows.count = ROWS;
        double[] positions = new double[48];
        for (int k = 0; k < positions.length; k++) {
            int box = 6 * random.nextInt(boxes.length / 6);
            positions[k] = boxes[box + k % 3] + (random.nextDouble() * 2 - 0.5) * (boxes[box + 3 + k % 3] - boxes[box + k % 3]);
        }
        for (int i = 0; i < ROWS; i++) {
            int box = 6 * random.nextInt(boxes.length / 6);
            int rotation = random.nextInt(16);
            rows.px[i] = (float) (boxes[box] + (random.nextDouble() * 3 - 1) * (boxes[box + 3] - boxes[box]));
            rows.py[i] = (float) (boxes[box + 1] + (random.nextDouble() * 3 - 1) * (boxes[box + 4] - boxes[box + 1]));
            rows.pz[i] = (float) (boxes[box + 2] + (random.nextDouble() * 3 - 1) * (boxes[box + 5] - boxes[box + 2]));
            shadowRays.pattern[i] = rotation;
            shadowRays.x[i] = positions[3 * rotation] - (toPoints ? 0 : rows.px[i]);
            shadowRays.y[i] = positions[3 * rotation + 1] - (toPoints ? 0 : rows.py[i]);
            shadowRays.z[i] = positions[3 * rotation + 2] - (toPoints ? 0 : rows.pz[i]);
        }
        return shadowRays;
    }

    private static int[] selectedRows(long seed) {
        Random random = new Random(seed + 1);
        int[] chosen = new int[ROWS / Tracer.ROWS_PER_WORD];
        Arrays.setAll(chosen, _ -> random.nextInt(3) == 0 ? 0 : random.nextInt(1 << 16));
        return chosen;
    }
}
