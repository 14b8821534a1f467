package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** AgX and Filmic against those of Blender 5.0, which {@code blender_views.py} asks for random pixels. */
class BlenderViewTest {
    private static final String SCRIPT = "src/test/python/blender_views.py";
    private static final List<DisplayCurve> VIEWS = List.of(DisplayCurve.AGX, DisplayCurve.FILMIC);
    private static final int MAX_DIFFERENCE = 3;
    private static final double MAX_MEAN = 0.5;

    @Test
    void agxAndFilmic_areThoseOfBlender() throws IOException {
        try (InputStream in = BlenderViewTest.class.getResourceAsStream("blender_views.txt")) {
            assertEqual(new String(in.readAllBytes(), StandardCharsets.US_ASCII));
        }
    }

    @Test
    @Slow
    void agxAndFilmic_areThoseOfInstalledBlender(@TempDir Path folder) throws IOException {
        PythonPrograms.require("bpy");
        assertEqual(PythonPrograms.output(folder, List.of("-B", Path.of(SCRIPT).toAbsolutePath().toString(), "20000", "2")));
    }

    private static void assertEqual(String table) {
        List<double[]> rows = table.lines().filter(line -> !line.isBlank())
                .map(line -> Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray()).toList();
        assertThat(rows.size()).isGreaterThanOrEqualTo(400);
        for (int v = 0; v < VIEWS.size(); v++) {
            ViewTransform view = ViewTransform.DEFAULT.withCurve(VIEWS.get(v));
            double sum = 0;
            for (double[] row : rows) {
                int[] shown = view.displayed((float) row[0], (float) row[1], (float) row[2]);
                for (int c = 0; c < 3; c++) {
                    double difference = Math.abs(shown[c] - row[3 + 3 * v + c]);
                    assertThat(difference).as("%s of %s: %s", view.curve(), Arrays.toString(row), Arrays.toString(shown))
                            .isLessThanOrEqualTo(MAX_DIFFERENCE);
                    sum += difference;
                }
            }
            assertThat(sum / (3 * rows.size())).as(view.curve().title()).isLessThanOrEqualTo(MAX_MEAN);
        }
    }
}
