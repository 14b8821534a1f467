package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
import lightning.render.shading.RayCounts;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Edits of objects that most rays can meet, in a room whose surfaces gather light: a new trace is the most that they may cost. */
@Slow
class LargeEditTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final String ROOM = """
            jen 1
            picture { size 20 12 depth 1 %s }
            camera { from 0 0 3.9  to 0 0 0  fov 40 }
            world { ambience 0  %s  %s }
            material white { diffuse 0.8 0.8 0.8 }
            material tiles { diffuse 0.5 0.5 0.5  reflective 0.3 0.3 0.3 }
            plane floor { material tiles  at 0 -1 0  scale 2 1 2 }
            plane ceiling { material white  at 0 1 0  scale 2 1 2 }
            plane back { material %s  at 0 0 -1  rotate 90 0 0  scale 2 1 2 }
            plane left { material white  at -1 0 0  rotate 0 0 90  scale 2 1 2 }
            plane right { material white  at 1 0 0  rotate 0 0 90  scale 2 1 2 }
            sphere ball { material white  at 0.2 -0.5 -0.2  scale 0.4 0.4 0.4 }
            cylinder tube { material white  at 0 0 -3  rotate 90 0 0  scale 1.6 6 1.6  caps no }
            light lamp point { at 0 0.5 0.5  intensity 0.5 }
            """;

    private static Scene room(boolean indirect, boolean fog, boolean mirror) {
        try {
            return JenReader.read(
                    String.format(Locale.ROOT, ROOM, indirect ? "indirect { rays 16 bounces 1 }" : "", indirect ? "" : "sky yes",
                            fog ? "fog 0.05" : "",
                            mirror ? "tiles" : "white"),
                    "room.jen", Path.of("")).scene();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private static Scene edited(Scene scene, Random random) {
        List<SceneNode> nodes = new ArrayList<>(scene.nodes());
        Shape shape = (Shape) nodes.get(random.nextInt(nodes.size()));
        Placement at = shape.placement();
        Vec3 by = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).times(0.6);
        return scene.withNode(shape.name(), shape.withPlacement(
                new Placement(at.position().plus(by), at.rotation(), at.scale().times(0.5 + 1.5 * random.nextDouble()))));
    }

    /** All rays can meet the tube, which is around everything. */
    @Test
    void movedShell_castsNoRayTwice() {
        Scene scene = room(true, false, false);
        Shape tube = (Shape) scene.nodes().getLast();
        Placement at = tube.placement();
        Scene moved = scene.withNode("tube",
                tube.withPlacement(new Placement(at.position().plus(new Vec3(0.1, 0, 0)), at.rotation(), at.scale())));
        try (Renderer session = new Renderer(OPTIONS); Renderer fresh = new Renderer(OPTIONS)) {
            session.render(scene, Progress.NONE);
            long again = session.render(moved, Progress.NONE).rays().gather();
            assertThat(again).isLessThanOrEqualTo(fresh.render(moved, Progress.NONE).rays().gather());
            FilmAssert.assertSameBits(session.film(), fresh.film(), "moved shell");
        }
    }

    @Property(tries = 6)
    void editOfObjects_castsNoMoreRaysThanANewTrace(@ForAll long seed, @ForAll boolean indirect, @ForAll boolean fog,
            @ForAll boolean mirror) {
        Random random = new Random(seed);
        Scene scene = room(indirect, fog, mirror);
        try (Renderer session = new Renderer(OPTIONS); WorkerPool workers = new WorkerPool(1)) {
            session.render(scene, Progress.NONE);
            for (int edit = 0; edit < 3; edit++) {
                scene = edited(scene, random);
                RayCounts rays = session.render(scene, Progress.NONE).rays();
                try (Renderer fresh = new Renderer(OPTIONS)) {
                    RayCounts all = fresh.render(scene, Progress.NONE).rays();
                    assertThat(rays.gather()).isLessThanOrEqualTo(all.gather());
                    assertThat(rays.total()).isLessThanOrEqualTo(all.total());
                }
                FilmAssert.assertSameBits(session.film(), new TraditionalTracer(scene).trace(workers, Progress.NONE).film(),
                        "edit " + edit);
            }
        }
    }
}
