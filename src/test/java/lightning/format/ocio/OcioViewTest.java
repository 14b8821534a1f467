package lightning.format.ocio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.format.image.CubeLutReader;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tables of views, compared with OpenColorIO's own conversion. */
@Slow
class OcioViewTest {
    private static final String CONFIG = "ocio://cg-config-v4.0.0_aces-v2.0_ocio-v2.5";
    private static final int COLORS = 2000;
    /** Steps of 8 bits by which rounding to 16 bits moves a color. */
    private static final double ROUNDING = 0.01;

    private static final Map<String, OcioView> BAKED = new HashMap<>();

    @TempDir
    private Path folder;

    @BeforeEach
    void requireOpenColorIo() {
        PythonPrograms.require("PyOpenColorIO");
    }

    private static OcioView bake(String config, String view) throws IOException {
        return OcioView.bake(new OcioReference(config, view), Progress.NONE);
    }

    /** Bakes a view of the configuration, once for all tests. */
    private static OcioView baked(String view) throws IOException {
        if (!BAKED.containsKey(view)) {
            BAKED.put(view, bake(CONFIG, view));
        }
        return BAKED.get(view);
    }

    private Path config(String text) throws IOException {
        return Files.writeString(folder.resolve("show.ocio"), text);
    }

    /** Colors of which each channel is between −7 and 5 stops from middle gray. */
    private static float[][] randomColors() {
        var random = new Random(3);
        return IntStream.range(0, COLORS).mapToObj(_ -> new float[] {light(random), light(random), light(random)}).toArray(float[][]::new);
    }

    private static float light(Random random) {
        return (float) (0.18 * Math.pow(2, random.nextDouble(-7, 5)));
    }

    /** Returns what OpenColorIO shows, in steps of 8 bits; the configuration's own Rec. 709 is the source. */
    private double[][] exact(String display, String view, float[][] colors) throws IOException {
        String text = Arrays.stream(colors).map(c -> c[0] + " " + c[1] + " " + c[2]).collect(Collectors.joining("\n"));
        Path file = Files.writeString(folder.resolve("colors.txt"), text);
        String shown = PythonPrograms.script(folder, List.of("-c", """
                import sys
                import PyOpenColorIO as ocio
                config = ocio.Config.CreateFromFile(sys.argv[1])
                view = ocio.DisplayViewTransform("Linear Rec.709 (sRGB)", sys.argv[2], sys.argv[3])
                processor = config.getProcessor(view).getDefaultCPUProcessor()
                for line in open(sys.argv[4]):
                    print(*processor.applyRGB([float(v) for v in line.split()]))
                """, CONFIG, display, view, file.toString()));
        return shown.lines().map(line -> Arrays.stream(line.split(" ")).mapToDouble(v -> 255 * Math.clamp(Double.parseDouble(v), 0, 1))
                .toArray()).toArray(double[][]::new);
    }

    /** Returns the largest difference of the three channels, in steps of 8 bits. */
    private static double difference(ViewTransform view, float[] color, double[] expected) {
        short[] codes = new short[3];
        view.pack16(color[0], color[1], color[2], codes, 0);
        return IntStream.range(0, 3).mapToDouble(c -> Math.abs((codes[c] & 0xffff) / 257.0 - expected[c])).max().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "sRGB - Display/ACES 2.0 - SDR 100 nits (Rec.709)",
        "sRGB - Display/Un-tone-mapped",
        "sRGB - Display/Raw",
        "Rec.2100-PQ - Display/ACES 2.0 - HDR 1000 nits (Rec.2020)"})
    void table_isWithinStatedError(String name) throws IOException {
        OcioView baked = baked(name);
        float[][] colors = randomColors();
        double[][] expected = exact(baked.display(), baked.view(), colors);
        double[] errors =
                IntStream.range(0, COLORS).mapToDouble(i -> difference(baked.transform(), colors[i], expected[i])).sorted().toArray();
        // Other colors than those of the statement: their largest error may be a little larger.
        assertThat(errors[COLORS - 1]).isLessThan(1.5 * baked.facts().largestError() + ROUNDING);
        assertThat(Arrays.stream(errors).average().orElseThrow()).isLessThan(3 * baked.facts().meanError() + ROUNDING);
        assertThat(baked.facts().error99()).isLessThan(2);
        assertThat(baked.facts().meanError()).isLessThan(0.25);
    }

    @Test
    void black_staysBlack() throws IOException {
        assertThat(baked("").transform().pack(0, 0, 0)).isEqualTo(0xFF000000);
    }

    /** Both are ACES 2.0 for sRGB displays of 100 nits. */
    @Test
    void aces2OfConfiguration_isThatOfLightning() throws IOException {
        ViewTransform table = baked("sRGB - Display/ACES 2.0 - SDR 100 nits (Rec.709)").transform();
        ViewTransform own = ViewTransform.DEFAULT.withCurve(DisplayCurve.ACES2);
        double sum = 0;
        for (float[] color : randomColors()) {
            short[] codes = new short[3];
            own.pack16(color[0], color[1], color[2], codes, 0);
            sum += difference(table, color, IntStream.range(0, 3).mapToDouble(c -> (codes[c] & 0xffff) / 257.0).toArray());
        }
        assertThat(sum / COLORS).isLessThan(0.5);
    }

    @Test
    void writtenFile_showsTheSameWithoutOpenColorIo() throws IOException {
        OcioView baked = baked("sRGB - Display/Un-tone-mapped");
        Path file = folder.resolve(baked.fileName("room"));
        baked.write(file);
        ViewTransform read = ViewTransform.DEFAULT.withLut(Optional.of(CubeLutReader.read(file)));
        for (float[] color : randomColors()) {
            assertThat(read.pack(color[0], color[1], color[2])).isEqualTo(baked.transform().pack(color[0], color[1], color[2]));
        }
        assertThat(file).hasFileName("room.sRGB - Display-Un-tone-mapped.cube");
    }

    @Test
    void brokenConfiguration_isOneSentence() throws IOException {
        Path file = config("ocio_profile_version: 2\n  bad: [\n");
        assertThatThrownBy(() -> bake(file.toString(), "")).isInstanceOf(IOException.class)
                .hasMessage(file + ": cannot be read by OpenColorIO: yaml-cpp: error at line 2, column 6: illegal map value");
    }

    /** A view whose only color space has a transform. */
    private Path configWith(String transform) throws IOException {
        return config("""
                ocio_profile_version: 2
                search_path: .
                roles: {default: lin, scene_linear: lin}
                displays:
                  TV:
                    - !<View> {name: Film, colorspace: film}
                colorspaces:
                  - !<ColorSpace> {name: lin}
                  - !<ColorSpace>
                    name: film
                    from_scene_reference: TRANSFORM
                """.replace("TRANSFORM", transform));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "!<FileTransform> {src: none.cube} | this view cannot be used: The specified file reference 'none.cube' could not be located",
        "!<FileTransform> {src: tables} | its table 'tables' is a folder, expected a file",
        "!<GroupTransform> {children: [!<FileTransform> {src: tables}]} | its table 'tables' is a folder, expected a file",
        "!<MatrixTransform> {matrix: [.nan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]} | this view has results that are no finite numbers",
        "!<MatrixTransform> {matrix: [.inf, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]} | this view has results that are no finite numbers"})
    void viewThatCannotBeBaked_isOneSentence(String transform, String sentence) throws IOException {
        Path file = configWith(transform);
        Files.createDirectory(file.resolveSibling("tables"));
        assertThatThrownBy(() -> bake(file.toString(), "TV/Film")).isInstanceOf(IOException.class)
                .hasMessageStartingWith(file + ": " + sentence);
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void deviceAsTable_isRefused() throws IOException {
        Path file = configWith("!<FileTransform> {src: /dev/zero}");
        assertThatThrownBy(() -> bake(file.toString(), "TV/Film")).isInstanceOf(IOException.class)
                .hasMessage(file + ": its table '/dev/zero' is a pipe or device, expected a file");
    }

    @Test
    void configurationWithoutViews_isOneSentence() throws IOException {
        Path file = config("""
                ocio_profile_version: 2
                roles: {default: raw, scene_linear: raw}
                displays: {}
                colorspaces:
                  - !<ColorSpace> {name: raw}
                """);
        assertThatThrownBy(() -> bake(file.toString(), "")).isInstanceOf(IOException.class)
                .hasMessage(file + ": has no displays with views");
    }

    @Test
    void viewWithoutItsColorSpace_isOneSentence() throws IOException {
        Path file = config("""
                ocio_profile_version: 2
                roles: {default: raw, scene_linear: raw}
                displays:
                  TV:
                    - !<View> {name: Film, colorspace: missing}
                colorspaces:
                  - !<ColorSpace> {name: raw}
                """);
        assertThatThrownBy(() -> bake(file.toString(), "TV/Film")).isInstanceOf(IOException.class)
                .hasMessageStartingWith(file + ": this view cannot be used: ").hasMessageContaining("'missing'");
    }

    @Test
    void configurationWithoutSceneLinear_isOneSentence() throws IOException {
        Path file = config("""
                ocio_profile_version: 2
                roles: {default: raw}
                displays:
                  TV:
                    - !<View> {name: Film, colorspace: raw}
                colorspaces:
                  - !<ColorSpace> {name: raw}
                """);
        assertThatThrownBy(() -> bake(file.toString(), "")).isInstanceOf(IOException.class)
                .hasMessage(file + ": has no role scene_linear, the color space of rendered light");
    }

    /** A configuration of version 1: its names have a line break, quotes and slashes, and it does not say what its primaries are. */
    @Test
    void oldConfiguration_isTakenAsRec709_withNote() throws IOException {
        Path file = config("""
                ocio_profile_version: 1
                roles: {default: linear, scene_linear: linear}
                displays:
                  "My\\nTV 'x'":
                    - !<View> {name: "Film/\\"q\\"", colorspace: out}
                colorspaces:
                  - !<ColorSpace> {name: linear}
                  - !<ColorSpace> {name: out, from_reference: !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}}
                """);
        OcioView baked = bake(file.toString(), "My\nTV 'x'/Film/\"q\"");
        assertThat(baked.facts().note()).contains("takes it as Rec. 709");
        int[] shown = baked.transform().displayed(0.25f, 0.5f, 1);
        assertThat(shown[0]).isCloseTo(128, within(1));
        assertThat(shown[1]).isCloseTo(180, within(1));
        assertThat(shown[2]).isEqualTo(255);
        assertThat(baked.fileName("a")).isEqualTo("a.My_TV _x_-Film__q_.cube");
        Path cube = folder.resolve("a.cube");
        baked.write(cube);
        assertThat(CubeLutReader.read(cube).log()).isPresent();
    }

    @Test
    void hugeNames_areShortenedInFileNames() throws IOException {
        String name = "x".repeat(900);
        Path file = config(String.format(Locale.ROOT, """
                ocio_profile_version: 1
                roles: {default: linear, scene_linear: linear}
                displays:
                  %s:
                    - !<View> {name: %s, colorspace: linear}
                colorspaces:
                  - !<ColorSpace> {name: linear}
                """, name, name));
        assertThat(bake(file.toString(), "").fileName("a")).hasSizeLessThan(100);
    }
}
