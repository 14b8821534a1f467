package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.Tracer;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests that a tile's rows of meshes equal those of the scalar engine, however its pixels are divided into squares. */
class MeshLaneTracerTest {
    @Property(tries = 100)
    void tileRows_matchScalarEngineBitForBit(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed,
            @ForAll @IntRange(min = 1, max = 32) int width, @ForAll @IntRange(min = 1, max = 32) int height, @ForAll boolean squares) {
        PictureSettings picture =
                squares ? new PictureSettings((width + 7) / 8 * 8, (height + 7) / 8 * 8, 1) : new PictureSettings(width, height, 1);
        Scene scene = TraceScenes.randomScene(shapes, seed).withPicture(picture);
        Geometry geometry = Geometry.of(scene);
        HitRows expected = rows(geometry, scene, Engines.SCALAR.tracer(geometry));
        HitRows rows = rows(geometry, scene, new MeshLaneTracer(geometry));
        assertThat(rows.count).isEqualTo(expected.count);
        assertThat(Arrays.copyOf(rows.parent, rows.count)).isEqualTo(Arrays.copyOf(expected.parent, rows.count));
        assertThat(Arrays.copyOf(rows.px, rows.count)).isEqualTo(Arrays.copyOf(expected.px, rows.count));
        assertThat(Arrays.copyOf(rows.nz, rows.count)).isEqualTo(Arrays.copyOf(expected.nz, rows.count));
        assertThat(Arrays.copyOf(rows.vy, rows.count)).isEqualTo(Arrays.copyOf(expected.vy, rows.count));
    }

    private static HitRows rows(Geometry geometry, Scene scene, Tracer tracer) {
        return new TileVisibility(geometry, scene, tracer).traceEyeRays(0, 0, 32, (count, texels, _) -> new HitRows(count, texels));
    }
}
