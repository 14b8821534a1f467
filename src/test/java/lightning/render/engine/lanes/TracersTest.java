package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Cutout;
import lightning.scene.Material;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Lanes find of shapes with holes, and of all shapes that ways cross, what plain loops find. */
class TracersTest {
    private static final int ROWS = 1024;

    /** Every other of 5 × 3 pixels is missing. */
    private static Scene pierced(Scene scene) {
        float[] rgb = new float[45];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 % 2;
        }
        return scene.withMaterial(Material.DEFAULT
                .withCutout(new Cutout(Optional.of(new TextureMap("holes.png", 3, 2, new Texture(5, 3, rgb))), 0.5)));
    }

    private static HitRows seen(Geometry geometry, Scene scene, Tracer tracer) {
        return new TileVisibility(geometry, scene, tracer).eye(0, 0, 32, (count, textured, _) -> new HitRows(count, textured));
    }

    @Property(tries = 100)
    void shapesWithHoles_areSeenAlike(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Scene scene = pierced(TraceScenes.wild(shapes, seed)).withPicture(new Picture(32, 32, 1));
        Geometry geometry = new Geometry(scene);
        HitRows expected = seen(geometry, scene, Engines.SCALAR.tracer(geometry));
        HitRows rows = seen(geometry, scene, new LaneEngine().tracer(geometry));
        assertThat(Arrays.copyOf(rows.parent, rows.count)).isEqualTo(Arrays.copyOf(expected.parent, expected.count));
        assertThat(Arrays.copyOf(rows.px, rows.count)).isEqualTo(Arrays.copyOf(expected.px, expected.count));
        assertThat(Arrays.copyOf(rows.nz, rows.count)).isEqualTo(Arrays.copyOf(expected.nz, expected.count));
    }

    @Property(tries = 100)
    void shapesWithHoles_blockAlike(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed, @ForAll boolean ends) {
        Geometry geometry = new Geometry(pierced(TraceScenes.wild(shapes, seed)));
        var rows = new HitRows(ROWS, false);
        RowWays ways = ways(geometry, rows, seed, ends);
        int[] chosen = chosen(seed);
        var all = Candidates.all(geometry.bvh());
        int[] expected = new int[chosen.length];
        int[] blocked = new int[chosen.length];
        Engines.SCALAR.tracer(geometry).blocked(rows, chosen, ways, all, expected);
        new LaneEngine().tracer(geometry).blocked(rows, chosen, ways, all, blocked);
        assertThat(blocked).isEqualTo(expected);
    }

    @Property(tries = 100)
    void ways_crossAlike(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed, @ForAll boolean ends, @ForAll boolean holes) {
        Scene scene = TraceScenes.wild(shapes, seed);
        Geometry geometry = new Geometry(holes ? pierced(scene) : scene);
        var rows = new HitRows(ROWS, false);
        RowWays ways = ways(geometry, rows, seed, ends);
        int[] chosen = chosen(seed);
        var all = Candidates.all(geometry.bvh());
        var expected = new Crossings(ROWS);
        var crossings = new Crossings(ROWS);
        Engines.SCALAR.tracer(geometry).cross(rows, chosen, ways, all, expected);
        new LaneEngine().tracer(geometry).cross(rows, chosen, ways, all, crossings);
        for (int row = 0; row < ROWS; row++) {
            assertThat(chain(crossings, row)).as("row %s", row).isEqualTo(chain(expected, row));
        }
    }

    private static List<List<Number>> chain(Crossings crossings, int row) {
        List<List<Number>> chain = new ArrayList<>();
        for (int i = crossings.first(row); i != Crossings.NONE; i = crossings.next(i)) {
            chain.add(List.of(crossings.primitive[i], crossings.part[i], crossings.t[i]));
        }
        return chain;
    }

    /** Ways from anywhere about the shapes, those of a turn to one place, through about where a shape is. */
    private static RowWays ways(Geometry geometry, HitRows rows, long seed, boolean ends) {
        Random random = new Random(seed);
        float[] boxes = Candidates.all(geometry.bvh()).boxes;
        RowWays ways = new RowWays();
        ways.open = true;
        ways.ends = ends;
        rows.count = ROWS;
        double[] place = new double[48];
        for (int k = 0; k < place.length; k++) {
            int box = 6 * random.nextInt(boxes.length / 6);
            place[k] = boxes[box + k % 3] + (random.nextDouble() * 2 - 0.5) * (boxes[box + 3 + k % 3] - boxes[box + k % 3]);
        }
        for (int i = 0; i < ROWS; i++) {
            int box = 6 * random.nextInt(boxes.length / 6);
            int turn = random.nextInt(16);
            rows.px[i] = (float) (boxes[box] + (random.nextDouble() * 3 - 1) * (boxes[box + 3] - boxes[box]));
            rows.py[i] = (float) (boxes[box + 1] + (random.nextDouble() * 3 - 1) * (boxes[box + 4] - boxes[box + 1]));
            rows.pz[i] = (float) (boxes[box + 2] + (random.nextDouble() * 3 - 1) * (boxes[box + 5] - boxes[box + 2]));
            ways.turn[i] = turn;
            ways.x[i] = place[3 * turn] - (ends ? 0 : rows.px[i]);
            ways.y[i] = place[3 * turn + 1] - (ends ? 0 : rows.py[i]);
            ways.z[i] = place[3 * turn + 2] - (ends ? 0 : rows.pz[i]);
        }
        return ways;
    }

    private static int[] chosen(long seed) {
        Random random = new Random(seed + 1);
        int[] chosen = new int[ROWS / Tracer.WORD];
        Arrays.setAll(chosen, _ -> random.nextInt(3) == 0 ? 0 : random.nextInt(1 << 16));
        return chosen;
    }
}
