package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.document.imports.ImportPreviews;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfFixtures;
import lightning.format.jen.JenReader;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Studio and sky around imported files of any size. */
class ImportLightingTest {
    private static final String BOX = """
            v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 3 -1\nv 1 3 -1\nv 1 3 1\nv -1 3 1
            f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1
            """;
    private static final String FLOOR = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nf 9 10 11 12\n";

    @TempDir
    private Path folder;

    private ImportedScene read(String obj, double scale) throws Exception {
        var text = new StringBuilder();
        for (String line : obj.strip().split("\n")) {
            String[] words = line.split(" ");
            text.append(words[0]);
            for (int i = 1; i < words.length; i++) {
                text.append(' ').append(words[0].equals("v") ? String.valueOf(Double.parseDouble(words[i]) * scale) : words[i]);
            }
            text.append('\n');
        }
        Path file = Files.writeString(folder.resolve("model.obj"), text);
        return SceneImporter.read(file, folder.resolve("model.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private static Film trace(Scene scene) throws Exception {
        try (var workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene.withPicture(scene.picture().withSize(64, 36))).trace(workers, Progress.NONE).film();
        }
    }

    /** Returns displayed brightness, 0 … 255, averaged over blocks of 4×4 pixels. */
    private static double[] blocks(Film film) {
        int[] pixels = ViewTransform.DEFAULT.toPixels(film);
        return IntStream.range(0, 16 * 9).mapToDouble(b -> IntStream.range(0, 16)
                .map(i -> pixels[(b / 16 * 4 + i / 4) * 64 + b % 16 * 4 + i % 4] >> 8 & 0xFF).average().orElseThrow()).toArray();
    }

    @ParameterizedTest
    @CsvSource({"STUDIO, 2000", "STUDIO, 0.01", "SKY, 2000", "SKY, 0.01"})
    void picture_isSameForEverySizeOfModel(ImportLighting lighting, double scale) throws Exception {
        double[] expected = blocks(trace(lighting.apply(read(BOX, 1)).scene()));
        double[] actual = blocks(trace(lighting.apply(read(BOX, scale)).scene()));
        assertThat(IntStream.range(0, expected.length).mapToDouble(i -> Math.abs(expected[i] - actual[i])).average().orElseThrow())
                .isLessThan(3);
        // Neither dark nor washed out.
        assertThat(IntStream.range(0, actual.length).mapToDouble(i -> actual[i]).average().orElseThrow()).isBetween(60.0, 220.0);
    }

    @ParameterizedTest
    @EnumSource(value = ImportLighting.class, names = {"STUDIO", "SKY"})
    void wholeSubject_isInThePictureAndFillsIt(ImportLighting lighting) throws Exception {
        ImportedScene imported = lighting.apply(read(BOX, 50));
        Camera camera = imported.scene().camera();
        Vec3 back = camera.from().minus(camera.to()).normalized();
        Vec3 right = Vec3.Y.cross(back).normalized();
        Vec3 up = back.cross(right);
        double tangent = Math.tan(Math.toRadians(camera.fov() / 2));
        double highest = imported.subject().corners().mapToDouble(corner -> {
            Vec3 p = corner.minus(camera.from());
            assertThat(Math.abs(p.dot(right) / -p.dot(back) / tangent)).isLessThan(16.0 / 9);
            return Math.abs(p.dot(up) / -p.dot(back) / tangent);
        }).max().orElseThrow();
        assertThat(highest).isBetween(0.7, 0.95);
    }

    private static final String SOFT_SPOT = GltfFixtures.LIT_JSON.replace("'type': 'point'",
            "'type': 'spot', 'spot': {'innerConeAngle': 0.349, 'outerConeAngle': 0.5}");

    private ImportedScene readGltf(String json) throws Exception {
        Path file = Files.write(folder.resolve("lit.gltf"), GltfFixtures.text(json, GltfFixtures.SQUARE));
        return SceneImporter.read(file, folder.resolve("lit.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private List<String> filesBeside(ImportedScene imported) throws Exception {
        imported.write();
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).filter(name -> !name.startsWith("lit.")).toList();
        }
    }

    @ParameterizedTest
    @EnumSource(value = ImportLighting.class, names = {"STUDIO", "SKY"})
    void profilesOfTheLightsOfTheFile_areNotWrittenWithout(ImportLighting lighting) throws Exception {
        assertThat(filesBeside(lighting.apply(readGltf(SOFT_SPOT)))).isEmpty();
    }

    /** Runs a test as in an installed program, which has images. */
    private static void installed(ThrowingRunnable test) throws Exception {
        System.setProperty("lightning.home", Path.of("").toAbsolutePath().toString());
        try {
            test.run();
        } finally {
            System.clearProperty("lightning.home");
        }
    }

    @FunctionalInterface
    private interface ThrowingRunnable {
        void run() throws Exception;
    }

    @ParameterizedTest
    @EnumSource(value = ImportLighting.class, names = {"SOFTBOXES", "STRIPS", "RING"})
    void photoStudio_isAnEnvironmentBesideTheScene(ImportLighting lighting) throws Exception {
        installed(() -> {
            ImportedScene lit = lighting.apply(readGltf(GltfFixtures.LIT_JSON));
            String image = "studio_" + lighting.name().toLowerCase(Locale.ROOT) + ".hdr";
            assertThat(filesBeside(lit)).containsExactly(image);
            Scene read = JenReader.read(folder.resolve("lit.jen")).scene();
            assertThat(read.lights()).isEmpty();
            assertThat(read.world().environments()).extracting(dome -> dome.image().orElseThrow().file()).containsExactly(image);
            assertThat(Arrays.stream(blocks(trace(read))).average().orElseThrow()).isBetween(60.0, 220.0);
        });
    }

    @Test
    void photoStudioWithoutItsImage_isRefused() throws Exception {
        ImportedScene imported = readGltf(GltfFixtures.LIT_JSON);
        assertThat(ImportLighting.RING.isAvailable()).isFalse();
        assertThatThrownBy(() -> ImportLighting.RING.apply(imported)).isInstanceOf(RefusalException.class)
                .hasMessage("studio_ring.hdr: comes with the installed program only");
    }

    @Test
    void profileOfASpot_hasAShortName() throws Exception {
        assertThat(filesBeside(readGltf(SOFT_SPOT))).containsExactly("spot 28.648 inner 19.996.ies");
    }

    /** Lights that reach nothing give black pictures, in each unit the same. */
    @Test
    void picturesThatShowNothing_orLookAlike_areNotUseful() throws Exception {
        ImportedScene imported = readGltf(GltfFixtures.LIT_JSON.replace("'intensity': 100", "'intensity': 0"));
        ImportedScene dark = imported.withObjects(scene -> scene.withWorld(scene.world().withAmbience(0).withBackground(Rgb.BLACK)));
        var previews = new ImportPreviews(dark, 40);
        try (var workers = new WorkerPool(1)) {
            for (ImportPreviews.Choice choice : previews.choices()) {
                previews.render(choice, workers, Progress.NONE);
                assertThat(previews.isUseful(choice)).as("%s", choice).isEqualTo(choice.lighting() != ImportLighting.FILE);
            }
        }
    }

    /** A camera below the ground would see nothing else. */
    @ParameterizedTest
    @EnumSource(value = ImportLighting.class, names = {"STUDIO", "SKY"})
    void cameraBelowTheGround_isReplacedWithANote(ImportLighting lighting) throws Exception {
        String json = GltfFixtures.LIT_JSON.replace("'children': [1]", "'children': [1, 2]")
                .replace("{'light': 0}}}],", "{'light': 0}}}, {'camera': 0, 'translation': [0.5, -20, 0.1], "
                        + "'rotation': [0.70710678, 0, 0, 0.70710678]}], 'cameras': [{'type': 'perspective', 'perspective': "
                        + "{'yfov': 0.7, 'znear': 0.1}}],");
        ImportedScene imported = readGltf(json);
        assertThat(imported.subject().hasCamera()).isTrue();
        ImportedScene lit = lighting.apply(imported);
        assertThat(lit.scene().camera().from().y()).isGreaterThan(imported.subject().min().y());
        assertThat(lit.notes()).containsKey("the camera is below the ground of the lighting; another was added");
        assertThat(Arrays.stream(blocks(trace(lit.scene()))).max().orElseThrow()).isGreaterThan(60);
    }

    @ParameterizedTest
    @EnumSource(value = ImportLighting.class, names = {"STUDIO", "SKY"})
    void scene_canBeWrittenAndReadBack(ImportLighting lighting) throws Exception {
        ImportedScene imported = lighting.apply(read(BOX, 2000));
        imported.write();
        Scene scene = JenReader.read(folder.resolve("model.jen")).scene();
        assertThat(scene.lights()).isEqualTo(imported.scene().lights());
        assertThat(scene.picture().sampling().antialias()).isEqualTo(AntialiasMode.EDGES);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("added one"));
        assertThat(imported.text()).doesNotContain("this one was added");
    }

    @Test
    void backdrop_isAddedOnlyWithoutFloor() throws Exception {
        assertThat(ImportLighting.STUDIO.apply(read(BOX, 1)).scene().stage().hasNode("backdrop")).isTrue();
        assertThat(ImportLighting.STUDIO.apply(read(BOX + FLOOR, 1)).scene().stage().hasNode("backdrop")).isFalse();
        assertThat(ImportLighting.SKY.apply(read(BOX + FLOOR, 1)).scene().stage().hasNode("backdrop")).isFalse();
    }

    /** Lights outside a room would not reach it. */
    @Test
    void closedRoom_isLitFromItsCeiling() throws Exception {
        String room = """
                v
                from 0 0 190
                at 0 0 -100
                up 0 1 0
                angle 60
                hither 0.01
                resolution 64 36
                l 0 50 0
                f 0.6 0.6 0.6 1 0 0 0 1
                p 4\n-200 -50 -200\n200 -50 -200\n200 50 -200\n-200 50 -200
                p 4\n-200 -50 200\n200 -50 200\n200 50 200\n-200 50 200
                p 4\n-200 -50 -200\n-200 -50 200\n-200 50 200\n-200 50 -200
                p 4\n200 -50 -200\n200 -50 200\n200 50 200\n200 50 -200
                p 4\n-200 -50 -200\n200 -50 -200\n200 -50 200\n-200 -50 200
                p 4\n-200 50 -200\n200 50 -200\n200 50 200\n-200 50 200
                """;
        Path file = Files.writeString(folder.resolve("room.nff"), room);
        Scene scene = ImportLighting.STUDIO.apply(SceneImporter.read(file, folder.resolve("room.jen"), LightUnits.CANDELA, Progress.NONE))
                .scene();
        assertThat(scene.lights()).extracting(Light::name).containsExactly("ceiling");
        assertThat(scene.lights().getFirst().position().y()).isBetween(40.0, 50.0);
        assertThat(Arrays.stream(blocks(trace(scene))).average().orElseThrow()).isBetween(50.0, 220.0);
    }

    @Test
    void lightSizes_followTheSubject() throws Exception {
        Map<String, Double> widths = ImportLighting.STUDIO.apply(read(BOX, 2000)).scene().lights().stream()
                .collect(Collectors.toMap(Light::name, light -> light.area().width()));
        // Twice the half edges are 2, 3 and 2; the key is 2.2 wide for a radius of 1.6.
        assertThat(widths.get("key")).isCloseTo(2.2 / 1.6 * 2000 * Math.sqrt(17) / 2, Percentage.withPercentage(0.1));
    }

    @Test
    void ownLights_leaveTheSceneAsItIs() throws Exception {
        ImportedScene imported = read(BOX, 1);
        assertThat(ImportLighting.FILE.apply(imported)).isSameAs(imported);
    }

    @Test
    void previews_areOfEachChoice() throws Exception {
        var previews = new ImportPreviews(read(BOX, 1), 40);
        assertThat(previews.choices()).extracting(ImportPreviews.Choice::lighting).containsExactly(ImportLighting.STUDIO,
                ImportLighting.SKY);
        try (var workers = new WorkerPool(1)) {
            assertThat(previews.choices()).allMatch(choice -> previews.render(choice, workers, Progress.NONE).film().width() == 40);
        }
        assertThat(previews.picture().width()).isEqualTo(40);
    }

    @Test
    void preview_isRenderedOnce() throws Exception {
        var previews = new ImportPreviews(read(BOX, 1), 40);
        ImportPreviews.Choice choice = previews.choices().getFirst();
        try (var workers = new WorkerPool(1)) {
            assertThat(previews.render(choice, workers, Progress.NONE)).isSameAs(previews.render(choice, workers, Progress.NONE));
        }
    }

    @Test
    void canceledPreview_canBeRenderedLater() throws Exception {
        var previews = new ImportPreviews(read(BOX, 1), 40);
        ImportPreviews.Choice choice = previews.choices().getFirst();
        try (var workers = new WorkerPool(1)) {
            assertThatThrownBy(() -> previews.render(choice, workers, Progress.cancellation(() -> true)))
                    .isInstanceOf(CancellationException.class);
            assertThat(previews.render(choice, workers, Progress.NONE).film().width()).isEqualTo(40);
        }
    }

    private static double exposure(double value) {
        float[] rgb = new float[3 * 8 * 8];
        Arrays.fill(rgb, 3 * 40, rgb.length, (float) value);
        return ImportPreviews.Preview.exposed(Film.ofScanlines(8, 8, rgb)).exposure();
    }

    /** Most pixels are black: they show no light, so they do not count. */
    @Test
    void whiteOrBlackPreviews_areExposed() {
        assertThat(exposure(64)).isEqualTo(-8);
        assertThat(exposure(0.001)).isEqualTo(8);
        assertThat(exposure(0.5)).isZero();
        assertThat(exposure(0)).isZero();
        assertThat(exposure(1e30)).isEqualTo(-64);
    }

    @Test
    void exposureOfPreview_isOfTheScene() throws Exception {
        ImportedScene imported = read(BOX, 1);
        assertThat(imported.withExposure(-8).scene().picture().view().exposure()).isEqualTo(-8);
        assertThat(imported.withExposure(0)).isSameAs(imported);
    }
}
