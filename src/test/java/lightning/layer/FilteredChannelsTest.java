package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Alpha and surface data that are averaged over a pixel's samples. */
@Slow
class FilteredChannelsTest {
    private static final List<String> NAMES = List.of("N_filtered.X", "N_filtered.Y", "N_filtered.Z", "P_filtered.X", "P_filtered.Y",
            "P_filtered.Z", "Z_filtered.Z", "albedo_filtered.R", "albedo_filtered.G", "albedo_filtered.B");
    private static final int GRID = 3;

    private static Scene scene(AntialiasMode mode) {
        Scene studio = StudioScene.of(LightType.SPOT);
        Light lamp = StudioScene.key(LightType.POINT);
        Light ball = lamp.withName("lamp").withPosition(new Vec3(1.7, 1, 1)).withArea(lamp.area().withRadius(0.4)
                .withVisibility(FaceVisibility.GLOWING));
        return studio.withLights(List.of(studio.lights().getFirst(), ball))
                .withWorld(studio.world().withBackground(new Rgb(0.5, 0.25, 2)))
                .withPicture(studio.picture().withSampling(new SamplingSettings(mode, GRID)));
    }

    /** Where rays hit nothing the background shows, so each pixel shows it with the weight 1 − alpha. */
    @ParameterizedTest
    @EnumSource
    void background_hasTheWeightThatAlphaLeaves(AntialiasMode mode) throws IOException {
        Scene scene = scene(mode);
        ExrValues file = ExrValues.of(scene, Optional.empty());
        float[] alpha = file.channel("A");
        int partial = 0;
        for (int i = 0; i < alpha.length; i++) {
            for (int c = 0; c < 3; c++) {
                double background = new double[] {0.5, 0.25, 2}[c];
                // At most 9 samples are added, and their sums are rounded to 2⁻²⁴.
                assertThat(file.channel("background." + "RGB".charAt(c))[i]).isCloseTo((float) ((1 - alpha[i]) * background),
                        within((float) (16 * 0x1p-24 * background)));
            }
            partial += alpha[i] > 0 && alpha[i] < 1 ? 1 : 0;
        }
        assertThat(partial > 0).isEqualTo(mode != AntialiasMode.OFF);
        assertThat(alpha).contains(0, 1);
    }

    /** Compared with a mean over all samples, traced without BVH. */
    @Test
    void channels_areMeansOfTheSamples() throws IOException {
        Scene scene = scene(AntialiasMode.EVERY);
        ExrValues file = ExrValues.of(scene, Optional.empty());
        Geometry geometry = Geometry.of(scene);
        PixelRays rays = new PixelRays(scene);
        Vec3 view = scene.camera().to().minus(scene.camera().from()).normalized();
        for (int i = 0; i < file.width * file.height; i++) {
            double[] sums = new double[NAMES.size()];
            int hits = 0;
            for (int sample = 0; sample < GRID * GRID; sample++) {
                Ray ray = rays.ray(i % file.width, i / file.width, sample, GRID);
                int primitive = BruteForce.nearest(geometry, ray);
                if (primitive >= 0) {
                    hits++;
                    add(geometry, primitive, ray, view, sums);
                }
            }
            assertThat(file.channel("A")[i]).isEqualTo(hits / 9f);
            for (int v = 0; v < sums.length; v++) {
                boolean isPlace = v >= 3 && v <= 6;
                double expected = hits == 0 ? v == 6 ? 1e10 : 0 : sums[v] / (isPlace ? hits : 9);
                // Values below 16: four roundings of sums of 9, and two of the shares of samples, each by at most 2⁻²⁴.
                assertThat((double) file.channel(NAMES.get(v))[i]).as(NAMES.get(v)).isCloseTo(expected,
                        within(hits == 0 ? 0 : 6 * 9 * 16 * 0x1p-24));
            }
        }
    }

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    /** Materials of all kinds, with textures and maps: colors and normals have the values that a sample without stored rows has. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void colorsAndNormals_areMeansInAnyScene(@ForAll("sessions") EditSession session) throws IOException {
        Scene last = session.scenes().getLast();
        Scene scene = last.withPicture(last.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 2)));
        ExrValues file = ExrValues.of(scene, Optional.empty());
        Geometry geometry = Geometry.of(scene);
        PixelRays rays = new PixelRays(scene);
        for (int i = 0; i < file.width * file.height; i++) {
            double[] sums = new double[NAMES.size()];
            for (int sample = 0; sample < 4; sample++) {
                Ray ray = rays.ray(i % file.width, i / file.width, sample, 2);
                int primitive = BruteForce.nearest(geometry, ray);
                if (primitive >= 0) {
                    add(geometry, primitive, ray, Vec3.ZERO, sums);
                }
            }
            for (int v : new int[] {0, 1, 2, 7, 8, 9}) {
                // Values of at most 1: two roundings of sums of 4, and one of a color of two terms.
                assertThat((double) file.channel(NAMES.get(v))[i]).as(NAMES.get(v)).isCloseTo(sums[v] / 4, within(3 * 0x1p-23));
            }
        }
    }

    private static void add(Geometry geometry, int primitive, Ray ray, Vec3 view, double[] sums) {
        SurfacePoint at = BruteForce.surface(geometry, primitive, ray);
        Vec3 position = new Vec3(at.px(), at.py(), at.pz());
        Vec3 point = geometry.toScene(position);
        double[] values = {at.nx(), at.ny(), at.nz(), point.x(), point.y(), point.z(), position.dot(view), 0, 0, 0};
        for (int c = 0; c < 3; c++) {
            values[7 + c] = geometry.isLightFace(primitive) ? 0 : Math.min(1, at.diffuse()[c] + at.specular()[c]);
        }
        for (int v = 0; v < values.length; v++) {
            sums[v] += values[v];
        }
    }

    @Test
    void averages_areOnlyInAntialiasedPictures() throws IOException {
        assertThat(ExrValues.of(scene(AntialiasMode.OFF), Optional.empty()).values.keySet()).contains("A")
                .doesNotContainAnyElementsOf(NAMES);
        assertThat(ExrValues.of(scene(AntialiasMode.EDGES), Optional.empty()).values.keySet()).contains("A").containsAll(NAMES);
    }
}
