package lightning.render.gather.rim;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.CellTable;
import lightning.render.gather.cell.DirectionCells;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Tests which cells of a point's directions contain a rim: {@code -} is a ray that leaves the scene, {@code x} one that does not. */
class RimCellsTest {
    private static final GatherSettings SETTINGS = new GatherSettings(2, 4, 8, true, 0);

    @Test
    void cellInWhichOtherPointsDiffer_isRim() throws JenException {
        assertThat(rims("----", "x--x", "x-x-")).isEqualTo("..xx");
        assertThat(rims("xxxx", "x--x", "x-x-")).isEqualTo("..xx");
    }

    /** Otherwise the mean of its light would be biased. */
    @Test
    void ownRays_haveNoSay() throws JenException {
        assertThat(rims("----", "xxxx", "xxxx")).isEqualTo("....");
        assertThat(rims("-x-x", "-xx-")).isEqualTo("....");
    }

    private static String rims(String... points) throws JenException {
        Scene scene = JenReader.read("jen 1\ncamera { from 0 0 9  to 0 0 0 }\n", "empty.jen", Path.of("")).scene();
        CellKeys keys = new CellKeys(scene, SETTINGS);
        char[] found = new char[4];
        int count;
        try (WorkerPool workers = new WorkerPool(1)) {
            count = new RimCells(keys, surface(points.length), links(points), workers, Progress.NONE).find(0, found);
        }
        char[] rims = "....".toCharArray();
        for (int i = 0; i < count; i++) {
            rims[found[i]] = 'x';
        }
        return new String(rims);
    }

    /** Returns points at one place. */
    private static SurfaceColumns surface(int count) {
        SurfaceColumns surface = new SurfaceColumns();
        for (int p = 0; p < count; p++) {
            surface.add(0, 0, 0, 0, 0, 1, 0);
        }
        return surface;
    }

    private static RayLinks links(String[] points) {
        RayLinks links = new RayLinks(4, DirectionCells.COUNT, new PathMemory(SETTINGS, 1 << 20));
        links.setPoints(points.length);
        CellTable cells = new CellTable();
        cells.add(1, 0);
        cells.setNumber(1, 0);
        for (int ray = 0; ray < 4 * points.length; ray++) {
            if (points[ray / 4].charAt(ray % 4) == 'x') {
                links.setKey(ray, 1, false);
            } else {
                links.setMiss(ray, 0, 1, 0);
            }
        }
        links.allocateNumbers(1, new int[0]);
        links.resolve(cells, 0, links.rayCount());
        links.finish();
        return links;
    }
}
