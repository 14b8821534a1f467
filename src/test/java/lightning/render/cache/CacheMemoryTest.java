package lightning.render.cache;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.management.JMException;
import javax.management.ObjectName;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.Accuracy;
import lightning.render.shading.layer.LightRows;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Tests the memory formula of docs/architecture.md against the arrays, and the arrays against the heap. */
@Slow
class CacheMemoryTest {
    private static final int SIZE = 512;
    private static final int PIXELS = SIZE * SIZE;
    /** Bytes per row that a plane's rows share: the normal, and one coordinate of the point. */
    private static final int PLANE = 16;
    /** One byte per row for each of four lights. */
    private static final int STATES = 4;

    /** Creates a reflective, glossy, textured floor that fills the image, lit everywhere by {@code lights} spots. */
    private static Scene sceneWithAllFeatures(int lights) {
        Texture texture = new Texture(1, 1, new float[] {1, 0.5f, 0.25f});
        Material material = Material.of("floor").withAmbient(Rgb.gray(0.1)).withDiffuse(Rgb.WHITE).withSpecular(Rgb.gray(0.5))
                .withShininess(8).withReflective(Rgb.gray(0.5)).withTexture(Optional.of(new TextureMap("t.png", 1, 1, texture)));
        return scene(material, lights, LightType.SPOT);
    }

    private static Scene scene(Material material, int lights, LightType type) {
        List<Light> all = new ArrayList<>();
        for (int i = 0; i < lights; i++) {
            all.add(Light.of("l" + i, type).withPosition(new Vec3(i, 3, 0)).withAngle(89)
                    .withAttenuation(type.hasPosition() ? new Attenuation(0.1, 1, 0.1) : Attenuation.NONE));
        }
        return new Scene(new PictureSettings(SIZE, SIZE, 3), new Camera(new Vec3(0, 4, 0), Vec3.ZERO, new Vec3(0, 0, 1), 40),
                World.DEFAULT, List.of(material),
                List.of(new Shape(Solid.PLANE, "floor", "floor", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(50, 1, 50)))), all);
    }

    private static PixelCache cache(Scene scene, Accuracy accuracy) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1).withAccuracy(accuracy))) {
            renderer.render(scene, Progress.NONE);
            return renderer.cache();
        }
    }

    @Test
    void exactCache_fourLightsOnPlane_takes82BytesPerRow() {
        PixelCache cache = cache(sceneWithAllFeatures(4), Accuracy.EXACT);
        assertThat(cache.rowCount()).isEqualTo(PIXELS);
        assertThat(cache.bytes()).isEqualTo((102L - STATES - PLANE) * PIXELS).isLessThanOrEqualTo(125L * PIXELS);
    }

    @Test
    void rowsWithoutHighlight_storeNoSpecularColumn() {
        Material polished = sceneWithAllFeatures(1).materials().getFirst().withShininess(100_000);
        // Below directional lights a mirror reflects at most a single point of the floor to the eye.
        PixelCache cache = cache(scene(polished, 2, LightType.DIRECTIONAL), Accuracy.EXACT);
        long withColumn = cache(scene(polished.withShininess(1), 2, LightType.DIRECTIONAL), Accuracy.EXACT).bytes();
        assertThat(cache.bytes()).isLessThan(withColumn - 7L * PIXELS);
    }

    @Test
    void rowsWithOneState_shareStateColumn() {
        Material matt = Material.of("floor").withDiffuse(Rgb.WHITE).withShininess(1);
        PixelCache cache = cache(scene(matt, 1, LightType.DIRECTIONAL), Accuracy.EXACT);
        byte[] first = ((LightRows) cache.tile(0).levels()[0].layers()[0]).state;
        assertThat(((LightRows) cache.tile(1).levels()[0].layers()[0]).state).isSameAs(first);
    }

    @Test
    void unneededColumns_takeNoMemory() {
        Material matt = Material.of("floor").withDiffuse(Rgb.WHITE).withShininess(1);
        PixelCache cache = cache(scene(matt, 4, LightType.DIRECTIONAL), Accuracy.EXACT);
        // No texture, no reflection; each layer has a state per row, and its cosine is shared by all rows.
        assertThat(cache.bytes()).isEqualTo((38L - PLANE) * PIXELS);
    }

    /**
     * Covers the point behind and the length inside for each row. The colors of its two secondary rays are not stored, since films are composed
     * from their rows.
     */
    @Test
    void clearMaterialRows_take16MoreBytes() {
        Material glass = Material.of("floor").withDiffuse(Rgb.WHITE).withShininess(1)
                .withTransmission(Transmission.NONE.withColor(Rgb.WHITE).withShadows(ShadowCasting.NONE));
        PixelCache cache = cache(scene(glass, 4, LightType.DIRECTIONAL), Accuracy.EXACT);
        assertThat(cache.rowCount()).isEqualTo(PIXELS);
        assertThat(cache.bytes()).isEqualTo((38L - PLANE + 16) * PIXELS);
    }

    @Test
    void ratioMode_stores24ContributionBytesPerLight() {
        PixelCache cache = cache(sceneWithAllFeatures(4), Accuracy.RATIO);
        assertThat(cache.bytes()).isEqualTo((38L - PLANE + 12 + 4 * 25) * PIXELS);
    }

    @Test
    void heap_growsByCacheAndFilmBytes() throws JMException {
        Scene scene = sceneWithAllFeatures(4);
        cache(scene, Accuracy.EXACT);
        long before = usedHeap();
        PixelCache cache = cache(scene, Accuracy.EXACT);
        long grown = usedHeap() - before;
        assertThat(grown).isCloseTo(cache.bytes() + 12L * PIXELS, withPercentage(3));
    }

    /** Returns the bytes of all live objects, without the filler objects of the collector, whose size varies. */
    private static long usedHeap() throws JMException {
        String histogram = (String) ManagementFactory.getPlatformMBeanServer().invoke(
                new ObjectName("com.sun.management:type=DiagnosticCommand"), "gcClassHistogram", new Object[] {new String[0]},
                new String[] {String[].class.getName()});
        return histogram.lines().map(String::strip).filter(line -> line.matches("\\d+: .*") && !line.contains("FillerElement"))
                .mapToLong(line -> Long.parseLong(line.split(" +")[2])).sum();
    }
}
