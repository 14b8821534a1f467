package lightning.render.gather.ray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.engine.choice.Engines;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.Geometry;
import lightning.render.trace.RayBatch;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.BumpMapping;
import org.junit.jupiter.api.Test;

class SurfaceNormalsTest {
    private static final float[] LEVEL = {0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
    private static final float[] SLOPE = {0, 0, 0, 0.5f, 0.5f, 0.5f, 1, 1, 1};

    /** Returns the z component of the surface's normal where that of a unit ball is (0.6, 0, 0.8); NaN if it is shaded by this normal. */
    private static float normal(float[] heights) throws JenException {
        Scene smooth = JenReader.read("""
                jen 1
                camera { from 0 0 4  to 0 0 0 }
                material white { diffuse 0.8 0.8 0.8 }
                sphere ball { material white }
                """, "ball.jen", Path.of("")).scene();
        var map = new TextureMap("bumps.png", 1, 1, new Texture(3, 1, heights));
        Scene scene = smooth.withMaterials(
                List.of(smooth.materials().getFirst().withBumpMapping(BumpMapping.NONE.withBump(Optional.of(map)))));
        Geometry geometry = Geometry.of(scene);
        SurfaceColumns surface = new SurfaceColumns();
        // Points are relative to the camera.
        surface.add(0.606f, 0, 0.808f - 4, 0.6f, 0, 0.8f, 0);
        RaySources points = new RaySources(null, surface, false);
        points.reserveNormals(1);
        new SurfaceNormals(new RayBatch(geometry, scene, Engines.SCALAR.tracer(geometry))).find(points, 0, 1);
        return points.geometricZ[0];
    }

    @Test
    void tiltedNormal_differsFromSurface() throws JenException {
        assertThat(normal(SLOPE)).isCloseTo(0.8f, within(1e-6f));
    }

    /** A map without slopes leaves the picture as it is, also if effects are forced, which adds such a map. */
    @Test
    void levelBumps_leaveNormal() throws JenException {
        assertThat(normal(LEVEL)).isNaN();
    }
}
