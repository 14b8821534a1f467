package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrReader;
import lightning.format.image.CubeLutReader;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.image.Log2Shaper;
import lightning.render.image.ViewTransform;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RenderCommandTest {
    @TempDir
    Path folder;
    private Path scene;

    @BeforeEach
    void write() throws Exception {
        scene = CliResult.scene(folder);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--threads=1", "--threads=3", "--traditional"})
    void pfm_matchesReference(String option) throws Exception {
        Path picture = folder.resolve("a.pfm");
        CliResult.run("render", scene, "-o", picture, option).assertSuccess();
        assertThat(ImageFile.read(picture).hasSameBits(new ReferenceTracer(JenReader.read(scene).scene()).trace())).isTrue();
    }

    @Test
    void namedCamera_isThatOfThePicture() throws Exception {
        Path picture = folder.resolve("a.pfm");
        Files.writeString(scene, Files.readString(scene) + "camera side { from 8 3 0  to 0 1 0 }\n");
        CliResult.run("render", scene, "-o", picture, "--camera", "side").assertSuccess();
        Scene read = JenReader.read(scene).scene();
        assertThat(
                ImageFile.read(picture).hasSameBits(new ReferenceTracer(read.withCamera(read.namedCamera("side").orElseThrow())).trace()))
                .isTrue();
    }

    @Test
    void sizeAndDepth_overrideScene() throws Exception {
        Path picture = folder.resolve("a.pfm");
        CliResult.run("render", scene, "-o", picture, "--size", "20x30", "--depth", "0").assertSuccess();
        Scene read = JenReader.read(scene).scene();
        Scene expected = read.withPicture(read.picture().withSize(20, 30).withDepth(0));
        assertThat(ImageFile.read(picture).hasSameBits(new ReferenceTracer(expected).trace())).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"--threads, 0x2", "--threads, 010b", "--threads, ٣", "--threads, 2.5", "--threads, 99999999999", "--depth, '#2'",
        "--exposure, 1d",
        "--exposure, 0x1p3", "--exposure, NaN", "--threads, 1e999999999", "--threads, 1e99999999999"})
    void nonNumericOption_isRejected(String option, String word) {
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), option, word).assertRejected(option, "number, found '" + word + "'");
    }

    @Test
    void integerOption_acceptsSceneNotation() throws Exception {
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--threads", "+2.0", "--depth", "010").assertSuccess();
    }

    @Test
    void noIndirect_leavesIndirectLightOut() throws Exception {
        Path lit = folder.resolve("lit.jen");
        Path plain = folder.resolve("plain.jen");
        String text = "material m { diffuse 0.8 0.8 0.8 }\nsphere a { material m }\nplane b { material m  at 0 -1 0  scale 9 1 9 }\n"
                + "camera { from 0 2 4  to 0 0 0 }\nlight l point { at 0 3 1 }\n";
        Files.writeString(lit, "jen 1\npicture { size 24 16  indirect { rays 16 } }\n" + text);
        Files.writeString(plain, "jen 1\npicture { size 24 16 }\n" + text);
        Path expected = folder.resolve("plain.pfm");
        CliResult.run("render", plain, "-o", expected).assertSuccess();
        Path with = folder.resolve("with.pfm");
        CliResult.run("render", lit, "-o", with).assertSuccess();
        assertThat(with).isRegularFile();
        assertThat(Files.mismatch(with, expected)).isNotEqualTo(-1);
        Path without = folder.resolve("without.pfm");
        CliResult.run("render", lit, "-o", without, "--no-indirect").assertSuccess();
        assertThat(without).hasSameBinaryContentAs(expected);
    }

    @Test
    void without_leavesEffectsOut() throws Exception {
        String text = "material m { model %s  base 0.9 0.7 0.3  metalness 1  roughness 0.3 }\nsphere a { material m }\n"
                + "plane b { material m  at 0 -1 0  scale 9 1 9 }\ncamera { from 0 2 4  to 0 0 0 }\nlight l point { at 0 3 1  attenuation 1 %s 0 }\n";
        Path full = Files.writeString(folder.resolve("full.jen"),
                "jen 1\npicture { size 24 16 }\n" + text.replaceFirst("%s", "principled").replace("%s", "0.1"));
        Path simple = Files.writeString(folder.resolve("simple.jen"),
                "jen 1\npicture { size 24 16 }\n" + text.replaceFirst("%s", "metallic").replace("%s", "0"));
        Path expected = folder.resolve("expected.pfm");
        CliResult.run("render", simple, "-o", expected).assertSuccess();
        Path without = folder.resolve("without.pfm");
        CliResult.run("render", full, "-o", without, "--without", "blurred-reflections,attenuation").assertSuccess();
        assertThat(without).hasSameBinaryContentAs(expected);
        CliResult.run("render", full, "-o", without, "--without", "fancy").assertRejected("--without", "blurred-reflections", "was fancy");
    }

    @Test
    void indirect_isSwitchedOnAndOff() throws Exception {
        String text = "material m { diffuse 0.8 0.8 0.8 }\nsphere a { material m }\nplane b { material m  at 0 -1 0  scale 9 1 9 }\n"
                + "camera { from 0 2 4  to 0 0 0 }\nlight l point { at 0 3 1 }\n";
        Path lit = Files.writeString(folder.resolve("lit.jen"), "jen 1\npicture { size 24 16  indirect { bounces 4 } }\n" + text);
        Path plain = Files.writeString(folder.resolve("plain.jen"), "jen 1\npicture { size 24 16 }\n" + text);
        Path[] pictures = new Path[4];
        for (int i = 0; i < 4; i++) {
            pictures[i] = folder.resolve(i + ".pfm");
            CliResult.run("render", i < 2 ? lit : plain, "-o", pictures[i], "--indirect", i % 2 == 0 ? "on" : "off").assertSuccess();
        }
        assertThat(pictures[2]).hasSameBinaryContentAs(pictures[0]);
        assertThat(pictures[3]).hasSameBinaryContentAs(pictures[1]);
        assertThat(Files.mismatch(pictures[0], pictures[1])).isNotEqualTo(-1);
        CliResult.run("render", lit, "-o", pictures[0], "--indirect", "perhaps").assertRejected("--indirect");
    }

    @Test
    void layers_areWrittenWithSamePicture() throws Exception {
        Path layers = folder.resolve("a.exr");
        Path picture = folder.resolve("a.pfm");
        CliResult.run("render", scene, "-o", layers, "--layers", "--bits", "32").assertSuccess();
        CliResult.run("render", scene, "-o", picture).assertSuccess();
        CliResult.run("compare", layers, picture).assertSuccess();
        try (ExrReader reader = new ExrReader(layers)) {
            assertThat(reader.header().channels()).extracting(ExrChannel::name).contains("ambient.R", "reflections.G", "Z");
        }
    }

    @Test
    void mattes_areWrittenBesideThePictureOrIntoItsFile() throws Exception {
        Path picture = folder.resolve("a.exr");
        Path mattes = folder.resolve("m.exr");
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--cryptomatte", mattes).assertSuccess();
        CliResult
                .run("render", scene, "-o", picture, "--bits", "32", "--cryptomatte", folder.resolve("./a.exr"), "--cryptomatte-levels",
                        "2")
                .assertSuccess();
        assertThat(channels(mattes)).hasSize(3 + 3 * 3 * 4).contains("R", "CryptoObject00.R", "CryptoMaterial02.A", "CryptoAsset01.G");
        assertThat(channels(picture)).hasSize(3 + 3 * 4).contains("R", "CryptoObject00.R");
        CliResult crowded = CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--size", "2x2", "--antialias", "every",
                "--cryptomatte", mattes, "--cryptomatte-levels", "2").assertSuccess();
        assertThat(crowded.err()).contains("with too many objects or materials for 2 levels", "--cryptomatte-levels=4 has room for all");
    }

    private static List<String> channels(Path file) throws Exception {
        try (ExrReader reader = new ExrReader(file)) {
            return reader.header().channels().stream().map(ExrChannel::name).toList();
        }
    }

    @Test
    void layersInUnsupportedFormat_areRejected() {
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--layers").assertRejected("layers are written to .exr");
        CliResult.run("render", scene, "-o", folder.resolve("a.exr"), "--layers", "--traditional")
                .assertRejected("a trace without a cache has no layers");
        CliResult.run("render", scene, "-o", folder.resolve("a.exr"), "--cryptomatte", folder.resolve("m.exr"), "--traditional")
                .assertRejected("a trace without a cache has no mattes");
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--cryptomatte", folder.resolve("m.png"))
                .assertRejected("mattes are written to .exr");
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--cryptomatte", folder.resolve("no/m.exr")).assertRejected("no");
        CliResult.run("render", scene, "-o", folder.resolve("a.exr"), "--cryptomatte-levels", "5").assertRejected("an even number");
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--bits", "12").assertRejected("8 or 16 bits, not 12");
    }

    /** With or without layers, the picture keeps its bits. */
    @Test
    void storageOfExr_keepsThePicture() throws Exception {
        Path picture = folder.resolve("a.pfm");
        Path parts = folder.resolve("parts.exr");
        Path plain = folder.resolve("plain.exr");
        CliResult.run("render", scene, "-o", picture).assertSuccess();
        CliResult.run("render", scene, "-o", parts, "--layers", "--bits", "32", "--exr-parts", "--exr-compression", "rle").assertSuccess();
        CliResult.run("render", scene, "-o", plain, "--bits", "32", "--exr-compression", "none").assertSuccess();
        CliResult.run("compare", parts, picture).assertSuccess();
        CliResult.run("compare", plain, picture).assertSuccess();
        assertThat(channels(parts)).containsExactly("A", "B", "G", "R");
        assertThat(channels(plain)).containsExactly("B", "G", "R");
    }

    @Test
    void crop_hasThePixelsOfItsRectangle() throws Exception {
        Path whole = folder.resolve("whole.exr");
        Path part = folder.resolve("part.exr");
        CliResult.run("render", scene, "-o", whole, "--size", "20x18", "--bits", "32").assertSuccess();
        CliResult.run("render", scene, "-o", part, "--size", "20x18", "--bits", "32", "--crop", "3,5,11,7").assertSuccess();
        float[] expected = new float[20 * 18];
        try (ExrReader reader = new ExrReader(whole); ExrReader cropped = new ExrReader(part)) {
            reader.read(List.of("G"), (x, y, v) -> expected[y * 20 + x] = v[0]);
            int[] count = new int[1];
            cropped.read(List.of("G"), (x, y, v) -> {
                assertThat(v[0]).isEqualTo(expected[y * 20 + x]);
                assertThat(x >= 3 && x < 14 && y >= 5 && y < 12).isTrue();
                count[0]++;
            });
            assertThat(count[0]).isEqualTo(11 * 7);
            assertThat(List.of(cropped.header().width(), cropped.header().height())).containsExactly(20, 18);
        }
    }

    @Test
    void unsuitableStorage_isRejected() {
        Path exr = folder.resolve("a.exr");
        Path png = folder.resolve("a.png");
        CliResult.run("render", scene, "-o", exr, "--exr-compression", "piz")
                .assertRejected("expected none, rle, zips, zip, dwaa, found 'piz'");
        CliResult.run("render", scene, "-o", exr, "--exr-compression", "dwaa", "--bits", "32").assertRejected("stores colors of 16 bits");
        CliResult.run("render", scene, "-o", png, "--exr-parts").assertRejected("--exr-parts needs an .exr file");
        CliResult.run("render", scene, "-o", png, "--cryptomatte", exr, "--crop", "0,0,2,2").assertRejected("--crop needs an .exr file");
        CliResult.run("render", scene, "-o", exr, "--size", "20x18", "--crop", "3,5,18,7")
                .assertRejected("--crop: expected a rectangle inside the picture of 20 x 18 pixels, found 3,5,18,7");
        CliResult.run("render", scene, "-o", exr, "--exr-compression", "rle", "--traditional").assertRejected("cannot be combined");
    }

    @Test
    void radiancePicture_isWrittenAndCompared() throws Exception {
        Path picture = folder.resolve("a.hdr");
        CliResult.run("render", scene, "-o", picture).assertSuccess();
        CliResult.run("compare", picture, picture).assertSuccess();
    }

    @Test
    void exposure_brightensPng() throws Exception {
        Path plain = folder.resolve("plain.png");
        Path bright = folder.resolve("bright.png");
        CliResult.run("render", scene, "-o", plain).assertSuccess();
        CliResult.run("render", scene, "-o", bright, "--exposure", "1").assertSuccess();
        Film a = ImageFile.read(plain);
        Film b = ImageFile.read(bright);
        assertThat(b.red(0, 0) / a.red(0, 0)).isBetween(1.9f, 2.1f);
    }

    @Test
    void view1998_writesLinearValues() throws Exception {
        Path linear = folder.resolve("linear.pfm");
        Path shown = folder.resolve("shown.png");
        CliResult.run("render", scene, "-o", linear).assertSuccess();
        CliResult.run("render", scene, "-o", shown, "--view", "1998", "--exposure", "1").assertSuccess();
        int[] codes = new ViewTransform(1, DisplayCurve.LINEAR).toPixels(ImageFile.read(linear));
        assertThat(ViewTransform.DEFAULT.toPixels(ImageFile.read(shown))).isEqualTo(codes);
    }

    @Test
    void cubeView_appliesTable() throws Exception {
        Path linear = folder.resolve("linear.pfm");
        Path table = Files.writeString(folder.resolve("inverse.cube"), "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
        CliResult.run("render", scene, "-o", linear).assertSuccess();
        for (String view : List.of(table.toString(), "aces+" + table)) {
            Path shown = folder.resolve("shown.png");
            CliResult.run("render", scene, "-o", shown, "--view", view, "--exposure", "1").assertSuccess();
            ViewTransform expected = new ViewTransform(1, view.startsWith("aces") ? DisplayCurve.ACES : DisplayCurve.SRGB)
                    .withLut(Optional.of(CubeLutReader.read(table)));
            assertThat(ViewTransform.DEFAULT.toPixels(ImageFile.read(shown))).isEqualTo(expected.toPixels(ImageFile.read(linear)));
        }
        Files.writeString(table, "LUT_1D_SIZE 2\n1 1 one\n");
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--view", table.toString())
                .assertRejected("inverse.cube, line 2: expected three numbers from -10⁹ to 10⁹, found '1 1 one'");
    }

    @Test
    void log2View_bringsLogarithmsToTable() throws Exception {
        Path linear = folder.resolve("linear.pfm");
        Path table = Files.writeString(folder.resolve("inverse.cube"), "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
        CliResult.run("render", scene, "-o", linear).assertSuccess();
        Path shown = folder.resolve("shown.png");
        for (String word : List.of("log2", "log2:-10,6.5")) {
            CliResult.run("render", scene, "-o", shown, "--view", word + "+" + table).assertSuccess();
            ViewTransform expected = ViewTransform.DEFAULT.withLut(Optional.of(CubeLutReader.read(table)))
                    .withShaper(Optional.of(word.length() == 4 ? new Log2Shaper(-6.5, 6.5) : new Log2Shaper(-10, 6.5)));
            assertThat(ViewTransform.DEFAULT.toPixels(ImageFile.read(shown))).isEqualTo(expected.toPixels(ImageFile.read(linear)));
        }
    }

    @Test
    void viewOfScene_isUsedUnlessOptionsReplaceIt() throws Exception {
        Path viewed = folder.resolve("viewed.jen");
        Files.writeString(viewed, Files.readString(Path.of(scene.toString())).replace("picture {", "picture { view agx  exposure 1.5 "));
        assertThat(Files.readString(viewed)).contains("agx");
        Path linear = folder.resolve("linear.pfm");
        Path shown = folder.resolve("shown.png");
        CliResult.run("render", scene, "-o", linear).assertSuccess();
        Film film = ImageFile.read(linear);
        CliResult.run("render", viewed, "-o", linear).assertSuccess();
        assertThat(Files.readAllBytes(linear)).isNotEmpty();
        FilmAssert.assertSameBits(ImageFile.read(linear), film, "linear");
        CliResult.run("render", viewed, "-o", shown).assertSuccess();
        assertShows(shown, film, new ViewTransform(1.5, DisplayCurve.AGX));
        CliResult.run("render", viewed, "-o", shown, "--view", "filmic").assertSuccess();
        assertShows(shown, film, new ViewTransform(1.5, DisplayCurve.FILMIC));
        CliResult.run("render", viewed, "-o", shown, "--exposure", "0").assertSuccess();
        assertShows(shown, film, new ViewTransform(0, DisplayCurve.AGX));
        CliResult.run("render", viewed, "-o", shown, "--view", "srgb", "--exposure", "0").assertSuccess();
        assertShows(shown, film, ViewTransform.DEFAULT);
    }

    private static void assertShows(Path shown, Film linear, ViewTransform view) throws Exception {
        assertThat(ViewTransform.DEFAULT.toPixels(ImageFile.read(shown))).isEqualTo(view.toPixels(linear));
    }

    @Test
    void xpm_isWrittenAsText() throws Exception {
        Path picture = folder.resolve("a.xpm");
        CliResult.run("render", scene, "-o", picture).assertSuccess();
        assertThat(Files.readString(picture)).startsWith("/* XPM */");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void linkToIrregularFile_isRejectedBeforeTracing() throws Exception {
        // A socket stands in for a device: a real device would be lost if this failed for an administrator.
        Path socket = folder.resolve("s");
        Path link = Files.createSymbolicLink(folder.resolve("a.png"), socket);
        String sentence = link + ": expected a file, found a device, a pipe or a socket";
        try (var server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(socket));
            CliResult.run("render", scene, "-o", link).assertRejected(sentence);
            CliResult.run("relight", scene, "-o", folder.resolve("b.png"), "--set", "sun.intensity=2", "--save", link)
                    .assertRejected(sentence);
        }
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void readOnlyPicture_isRejectedAndKept() throws Exception {
        Path picture = Files.writeString(folder.resolve("a.png"), "old");
        Files.setPosixFilePermissions(picture, PosixFilePermissions.fromString("r--r--r--"));
        CliResult.run("render", scene, "-o", picture).assertRejected(picture + ": is read-only");
        assertThat(picture).hasContent("old");
    }

    @Test
    void report_showsSizeAndRays() {
        assertThat(CliResult.run("render", scene, "-o", folder.resolve("a.png")).assertSuccess().out())
                .contains("48 x 32 pixels, depth 2", "1536 eye rays", "shadow rays");
    }

    @ParameterizedTest
    @ValueSource(strings = {"--threads=1", "--traditional"})
    void coldTime_isMarked(String option) {
        assertThat(CliResult.run("render", scene, "-o", folder.resolve("a.png"), option).assertSuccess().out())
                .contains(" ms (cold start): ");
    }

    /** Scaled by 2⁻⁴⁰ every value is below white; by 2⁴⁰ every lit value is above it. */
    @Test
    void report_showsClippedPixels() {
        assertThat(CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--exposure", "40").assertSuccess().out())
                .containsPattern("a.png: \\d+ of 1536 pixels \\([\\d.]+ %\\) are clipped, the peak is .+ times white");
        assertThat(CliResult.run("render", scene, "-o", folder.resolve("a.png"), "--exposure", "-40").assertSuccess().out())
                .doesNotContain("cut off");
        assertThat(CliResult.run("render", scene, "-o", folder.resolve("a.pfm"), "--exposure", "40").assertSuccess().out())
                .doesNotContain("cut off");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--size | 3 | expected WIDTHxHEIGHT",
        "--size | 0x5 | from 1 to 16384",
        "--size | 99999x5 | from 1 to 16384",
        "--depth | 11 | --depth must be from 0 to 10, was 11",
        "--camera | side | --camera: the scene has no camera 'side', it has no named ones",
        "--depth | -1 | --depth must be from 0 to 10, was -1",
        "--depth | x | --depth",
        "--threads | 0 | --threads must be from 1 to 1024, was 0",
        "--view | rec709 | expected srgb, 1998, filmic, aces, aces2, agx, false, ocio:DISPLAY/VIEW or a .cube file, found 'rec709'",
        "--primaries | p3 | --primaries: expected rec709 or acescg, found 'p3'",
        "--primaries | acescg | --primaries acescg needs an .exr file",
        "--view | log2 | expected a .cube file after log2, such as log2+look.cube",
        "--view | log2:1+a.cube | expected two numbers of stops such as log2:-6.5,6.5, found 'log2:1'",
        "--view | log2:2,x+a.cube | log2: expected two rising numbers of stops from -64 to 64, found 2,NaN",
        "--exposure | 65 | --exposure must be from -64 to 64 stops, was 65"})
    void invalidOption_isRejected(String option, String value, String sentence) {
        CliResult.run("render", scene, "-o", folder.resolve("a.png"), option, value).assertRejected(sentence);
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    @Test
    void missingOutput_isRejected() {
        CliResult.run("render", scene).assertRejected("--output");
    }

    @Test
    void unwritableOutput_isRejectedBeforeTracing() {
        CliResult.run("render", scene, "-o", folder.resolve("a.gif")).assertRejected("must end in .png, .xpm, .pfm, .exr or .hdr");
        CliResult.run("render", scene, "-o", folder.resolve("no/a.png")).assertRejected("folder not found: " + folder.resolve("no"));
    }

    @Test
    void sceneProblems_arePrintedOnePerLine() throws Exception {
        Files.writeString(scene, "jen 1\nlight a point { intensity -1 }\nsphere b { scal 1 1 1 }\n");
        CliResult refused = CliResult.run("render", scene, "-o", folder.resolve("a.png"));
        refused.assertRejected(scene + ":2:", scene + ":3:");
        assertThat(refused.err()).hasLineCount(2);
    }

    @Test
    void interruptedTrace_leavesOnlyTheOldPicture() throws Exception {
        Path picture = Files.writeString(folder.resolve("a.png"), "old");
        int[] exit = new int[1];
        Thread command = new Thread(() -> {
            Thread.currentThread().interrupt();
            exit[0] = CliResult.run("render", scene, "-o", picture).exit();
        });
        command.start();
        command.join();
        assertThat(exit[0]).isEqualTo(130);
        assertThat(picture).hasContent("old");
        assertThat(names()).containsExactlyInAnyOrder("a.jen", "a.png");
    }

    private List<String> names() throws Exception {
        try (var files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).toList();
        }
    }
}
