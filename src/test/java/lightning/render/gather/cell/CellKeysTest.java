package lightning.render.gather.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the sizes of the cells of surfels around a camera that looks along −z. */
class CellKeysTest {
    private static CellKeys keys(double fov) throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 400 300  indirect { bounces 2 } }
                camera { from 0 0 0  to 0 0 -1  fov FOV }
                """.replace("FOV", String.valueOf(fov)), "view.jen", Path.of("")).scene();
        return new CellKeys(scene, GatherSettings.of(scene).orElseThrow());
    }

    /** Returns the side of the cell at distance 1.5 along a direction, seen from afar, relative to one in the middle of the view. */
    private static double side(CellKeys keys, double x, double y, double z) {
        double length = 1.5 / Math.sqrt(x * x + y * y + z * z);
        return keys.surfelSide((float) (x * length), (float) (y * length), (float) (z * length), 100) / keys.surfelSide(0, 0, -1.5f, 100);
    }

    @ParameterizedTest
    @ValueSource(doubles = {40, 50, 120})
    void usualView_hasCellsOfOneSizeAround(double fov) throws JenException {
        CellKeys keys = keys(fov);
        assertThat(side(keys, 0, 0, 1)).isEqualTo(1);
        assertThat(side(keys, 1, 0, 0)).isEqualTo(1);
    }

    /** The view is a quarter as high as one of 40°, so that cells behind the camera are at most four times as wide. */
    @Test
    void narrowView_hasWideCellsBehindTheCamera() throws JenException {
        CellKeys keys = keys(10);
        assertThat(side(keys, 0, 0, 1)).isEqualTo(4);
        assertThat(side(keys, 1, 0, 0)).isEqualTo(4);
    }

    /** The corner of the picture is at a tangent of 0.0875 · 5/3 to the axis. Cells grow from there on. */
    @Test
    void narrowView_keepsCellsInTheView() throws JenException {
        CellKeys keys = keys(10);
        double corner = Math.tan(Math.toRadians(5)) * 5 / 3;
        assertThat(side(keys, 0.99 * corner, 0, -1)).isEqualTo(1);
        assertThat(side(keys, 1.01 * corner, 0, -1)).isEqualTo(2);
        assertThat(side(keys, 2.01 * corner, 0, -1)).isEqualTo(4);
    }

    /** The number of cells that cover everything around the camera does not grow without limit as the view gets narrower. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 1, 0.1})
    void closeUp_dividesItsSurroundingsAsAViewOf20To40Degrees(double fov) throws JenException {
        double usual = keys(40).surfelSide(0, 0, 1.5f, 100);
        assertThat(keys(fov).surfelSide(0, 0, 1.5f, 100)).isBetween(usual / 2, usual);
    }
}
