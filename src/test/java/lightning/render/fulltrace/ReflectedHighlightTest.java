package lightning.render.fulltrace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import org.junit.jupiter.api.Test;

/** Tests that a glossy floor shows the highlight that a spot makes on a metal wall. The floor itself is not lit. */
class ReflectedHighlightTest {
    private static final int SIZE = 24;
    private static final String WALL = """
            jen 1
            picture { size 24 24  depth 0 }
            world { ambience 0  background 0 0 0 }
            material wall { model principled  base 1 1 1  metalness 1  roughness 0.7 }
            material floor { model principled  base 1 1 1  metalness 1  roughness 0.15 }
            plane wall { material wall  at 0 4 -2  rotate 90 0 0  scale 10 1 10 }
            light key spot { at 0 3 2  direction 0 -2.6666667 -4  angle 12 }
            """;

    private static double mean(String scene) throws JenException {
        Film film;
        try (WorkerPool workers = new WorkerPool(1)) {
            film = new TraditionalTracer(JenReader.read(scene, "wall.jen", Path.of("")).scene()).trace(workers, Progress.NONE).film();
        }
        double sum = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            sum += film.green(i % SIZE, i / SIZE);
        }
        return sum / (SIZE * SIZE);
    }

    /** A white metal floor shows what its mirror image of the camera sees without it. */
    @Test
    void glossyFloor_showsHighlightOfMetalWall() throws JenException {
        double reflected = mean(WALL + "plane floor { material floor  at 0 -1 0  scale 6 1 4 }\ncamera { from 0 1 3  to 0 -1 0  fov 8 }\n");
        double seen = mean(WALL + "camera { from 0 -3 3  to 0 -1 0  fov 8 }\n");
        assertThat(seen).isGreaterThan(0.05);
        assertThat(reflected).isCloseTo(seen, within(0.1 * seen));
    }
}
