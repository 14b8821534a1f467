package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenReader;
import lightning.format.mesh.MeshException;
import lightning.format.nff.SpdScenes;
import lightning.format.nff.Teapot;
import lightning.sample.TryFolder;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.Solid;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Import of NFF: solids are converted, polygons and patches are referenced in the source file. */
class NffImportTest {
    @TempDir
    private Path folder;

    static Stream<Arguments> databases() {
        // Spheres, cones and triangles, by the databases' definitions.
        return Stream.of(Arguments.of("balls", SpdScenes.balls(2), 1 + 9 + 81, 0, 2),
                Arguments.of("gears", SpdScenes.gears(9), 0, 0, 2 * 34 + 2 * 36),
                Arguments.of("mountain", SpdScenes.mountain(4), 4, 0, 2 * 16 * 16),
                Arguments.of("rings", SpdScenes.rings(), 20, 30, 2),
                Arguments.of("tetra", SpdScenes.tetra(3), 0, 0, 4 * 64),
                Arguments.of("tree", SpdScenes.tree(3), 1 + 3 + 9 + 27, 1 + 3 + 9 + 27, 2),
                Arguments.of("teapot", Teapot.text(4), 0, 0, 32 * 2 * 16));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("databases")
    void standardScene_isImportedCompletely(String name, String text, int spheres, int cones, int triangles) throws Exception {
        ImportedScene imported = read(name, text);
        imported.write();
        Scene scene = JenReader.read(folder.resolve(name + ".jen")).scene();
        List<Solid> solids = scene.placedShapes().stream().map(shape -> shape.shape().solid()).toList();
        assertThat(solids).filteredOn(Solid.Sphere.class::isInstance).hasSize(spheres);
        assertThat(solids).filteredOn(s -> s instanceof Solid.Frustum || s instanceof Solid.Cylinder).hasSize(cones);
        assertThat(solids.stream().mapToInt(s -> s instanceof Solid.TriangleMesh t ? t.mesh().triangleCount() : 0).sum())
                .isEqualTo(triangles);
        assertThat(imported.notes().keySet()).allMatch(note -> note.startsWith("emission of transparent materials"));
    }

    @Property
    void cone_spansItsEnds(@ForAll @DoubleRange(min = -10, max = 10) double x, @ForAll @DoubleRange(min = -10, max = 10) double y,
            @ForAll @DoubleRange(min = -10, max = 10) double z, @ForAll @DoubleRange(min = 0.01, max = 10) double r,
            @ForAll @DoubleRange(min = 0, max = 10) double s) throws Exception {
        Vec3 base = new Vec3(1, 2, 3);
        Vec3 apex = base.plus(new Vec3(x, y, z).maxAbs() < 0.1 ? Vec3.Y : new Vec3(x, y, z));
        try (TryFolder files = new TryFolder()) {
            Path file = Files.writeString(files.file("a.nff"), String.format(Locale.ROOT, "c%n1 2 3 %.17g%n%.17g %.17g %.17g %.17g%n",
                    r, apex.x(), apex.y(), apex.z(), s));
            PlacedShape cone =
                    SceneImporter.read(file, files.file("a.jen"), LightUnits.CANDELA, Progress.NONE).scene().placedShapes().getFirst();
            Vec3 wideEnd = s > r ? apex : base;
            Vec3 narrowEnd = s > r ? base : apex;
            assertNear(cone.toWorld().transformPoint(Vec3.ZERO), wideEnd);
            assertNear(cone.toWorld().transformPoint(Vec3.Y), narrowEnd);
            Vec3 outside = cone.toWorld().transformVector(new Vec3(0.6, 0, 0.8));
            assertThat(Math.abs(outside.length() - Math.max(r, s))).isLessThan(1e-7);
            assertThat(Math.abs(outside.dot(narrowEnd.minus(wideEnd)))).isLessThan(1e-6);
            double top = cone.shape().solid() instanceof Solid.Frustum f ? f.top() : cone.shape().solid() instanceof Solid.Cone ? 0 : 1;
            assertThat(Math.abs(top * Math.max(r, s) - Math.min(r, s))).isLessThan(1e-7);
        }
    }

    @Test
    void lightsWithoutColor_shareIntensity() throws Exception {
        Scene scene = read("a", "l 1 2 3\nl 4 5 6\nl 7 8 9 0.5 0.25 0\nl 0 0 9\ns 0 0 0 1\n").scene();
        assertThat(scene.lights()).extracting(Light::intensity).containsExactly(0.5, 0.5, 1.0, 0.5);
        assertThat(scene.lights().get(2).color()).isEqualTo(new Rgb(0.5, 0.25, 0));
        assertThat(scene.lights().getFirst().attenuation().isNone()).isTrue();
    }

    @Test
    void specularFill_isReflective() throws Exception {
        ImportedScene imported = read("a", "f 1 0.5 0 0.4 0.5 20 0 1.5\ns 0 0 0 1\n");
        assertThat(imported.scene().materials().getFirst()).satisfies(m -> {
            // 0.4 of the color is visible if half of all diffuse light is reflected.
            assertThat(m.diffuse()).isEqualTo(new Rgb(0.8, 0.4, 0));
            assertThat(m.reflective()).isEqualTo(Rgb.gray(0.5));
            assertThat(m.specular()).isEqualTo(Rgb.gray(0.5));
            assertThat(m.shininess()).isEqualTo(20);
            assertThat(m.transmission()).isEqualTo(Transmission.NONE);
        });
    }

    @Test
    void transmittingFill_isTransparent() throws Exception {
        ImportedScene imported = read("a", "f 1 0.5 0 0.2 0 20 0.75 1.33\ns 0 0 0 1\n");
        assertThat(imported.scene().materials().getFirst()).satisfies(m -> {
            assertThat(m.diffuse()).as("a quarter of it is seen").isEqualTo(new Rgb(0.8, 0.4, 0));
            assertThat(m.transmission().color()).isEqualTo(Rgb.gray(0.75));
            assertThat(m.transmission().ior()).isEqualTo(1.33);
            assertThat(m.transmission().thin()).isFalse();
            assertThat(m.transmission().shadows()).isEqualTo(ShadowCasting.TINTED);
        });
        assertThat(imported.scene().picture().depth()).isEqualTo(6);
    }

    @Test
    void flatShapes_areSkippedAndNoted() throws Exception {
        ImportedScene imported = read("a", "s 0 0 0 0\nc 0 0 0 1 0 0 0 1\nc 0 0 0 0 1 0 0 0\ns 0 0 0 1\n");
        assertThat(imported.scene().placedShapes()).hasSize(1);
        assertThat(imported.notes()).containsEntry("objects that are flat, too small or too large", 3);
    }

    private static void assertNear(Vec3 actual, Vec3 expected) {
        assertThat(actual.minus(expected).maxAbs()).as("%s, expected %s", actual, expected).isLessThan(1e-7);
    }

    private ImportedScene read(String name, String text) throws IOException, MeshException {
        Path file = Files.writeString(folder.resolve(name + ".nff"), text);
        return SceneImporter.read(file, folder.resolve(name + ".jen"), LightUnits.CANDELA, Progress.NONE);
    }
}
