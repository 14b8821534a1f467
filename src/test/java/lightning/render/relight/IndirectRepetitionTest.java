package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
import lightning.render.shading.RayCounts;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Tests that edits of small objects repeat few paths of indirect light, and that the picture is that of a first pass. */
class IndirectRepetitionTest {
    private static final String ROOM = """
            jen 1
            picture { size 96 72  depth 0 }
            camera { from 0 0 0.9  to 0 0 -1  fov 70 }
            material white { diffuse 0.8 0.8 0.8 }
            material red { diffuse 0.8 0.1 0.1 }
            plane floor { material white  at 0 -1 0  scale 2 1 2 }
            sphere first { material white  at 0.7 -0.8 -0.8  scale 0.1 0.1 0.1 }
            plane ceiling { material white  at 0 1 0  scale 2 1 2 }
            plane back { material white  at 0 0 -1  rotate 90 0 0  scale 2 1 2 }
            plane front { material white  at 0 0 1  rotate 90 0 0  scale 2 1 2 }
            plane left { material red  at -1 0 0  rotate 0 0 90  scale 2 1 2 }
            plane right { material white  at 1 0 0  rotate 0 0 90  scale 2 1 2 }
            sphere ball { material red  at 0.2 -0.8 -0.3  scale 0.15 0.15 0.15 }
            light lamp point { at 0.2 0.8 0.3 }
            """;

    private static Scene room() throws JenException {
        return room(ROOM);
    }

    private static Scene room(String text) throws JenException {
        Scene scene = JenReader.read(text, "room.jen", Path.of("")).scene();
        return scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(2, 64, 8, false))));
    }

    /** Returns the rays of an edit that find surfaces relative to those of a first pass. */
    private static double share(Scene scene, Scene edited) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(2)); WorkerPool workers = new WorkerPool(2)) {
            long all = renderer.render(scene, Progress.NONE).rays().gather();
            long again = renderer.render(edited, Progress.NONE).rays().gather();
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(edited).trace(workers, Progress.NONE).film(), "repetition");
            // A second edit starts from repeated paths.
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), "undo");
            return (double) again / all;
        }
    }

    private static Scene edit(Scene scene, String name, Placement to) {
        return scene.withNode(name, ((Shape) scene.nodes().stream().filter(node -> node.name().equals(name)).findFirst().orElseThrow())
                .withPlacement(to));
    }

    @Test
    void movedObject_repeatsFewRays() throws JenException {
        Placement moved = new Placement(new Vec3(0.3, -0.8, -0.3), Vec3.ZERO, new Vec3(0.15, 0.15, 0.15));
        assertThat(share(room(), edit(room(), "ball", moved))).isBetween(0.01, 0.33);
    }

    /** The boxes of glowing objects, at which rays of reflections are aimed, are padded by the extent of the whole scene. */
    @Test
    void objectMovedFarAway_leavesReflectionsOfGlowExact() throws JenException {
        Scene scene = room(ROOM + """
                material neon { glow 3 2 1  diffuse 0.1 0.1 0.1 }
                material brass { model principled  base 0.9 0.7 0.3  metalness 1  roughness 0.4 }
                sphere bulb { material neon  at -0.1 0.2 0.1  scale 0.1 0.1 0.1 }
                sphere knob { material brass  at -0.4 -0.6 -0.3  scale 0.3 0.3 0.3 }
                """);
        Placement moved = new Placement(new Vec3(0.3, -3, -50), Vec3.ZERO, new Vec3(0.15, 0.15, 0.15));
        assertThat(share(scene, edit(scene, "ball", moved))).isBetween(0.01, 1.0);
    }

    /** All later objects have other numbers than before. */
    @Test
    void deletedObject_repeatsFewRays() throws JenException {
        List<SceneNode> nodes = new ArrayList<>(room().nodes());
        nodes.removeIf(node -> node.name().equals("first"));
        assertThat(share(room(), room().withNodes(nodes))).isBetween(0.01, 0.33);
    }

    /** The only candidate is the first pixel, which shows the background. */
    @Test
    void sceneWithoutGatherPoints_isUpdated() throws JenException {
        Scene scene = room("""
                jen 1
                picture { size 16 16  depth 0 }
                camera { from 0 0 5  to 0 0 0 }
                sphere ball { scale 0.3 0.3 0.3 }
                light lamp point { at 1 2 3 }
                """);
        Scene sparse = scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(2, 16, 64, false))));
        assertThat(share(sparse, sparse.withPicture(sparse.picture().withDepth(1)))).isPositive();
    }

    @Test
    void materialThatBecomesGlass_repeatsFewRays() throws JenException {
        String solid = ROOM.replace("plane left { material red", "plane left { material white");
        Scene scene = room(solid);
        Scene glass = room(solid.replace("0.8 0.1 0.1", "0.8 0.1 0.1  clear 0.8 0.9 1"));
        assertThat(share(scene, glass)).isBetween(0.01, 0.33);
    }

    /** The face is light that surfaces gather, so paths that can meet it are traced again; a face that is not seen is no part of them. */
    @Test
    void textureOfLight_repeatsPathsOnlyIfItsFaceIsVisible() throws JenException {
        for (boolean visible : new boolean[] {false, true}) {
            String text =
                    ROOM + "light screen rect { at -0.9 0 0  direction 1 0 0  width 0.5 height 0.5  visible " + (visible ? "yes" : "no")
                            + "  texture \"IMAGE.png\" }\n";
            Scene scene = room(text.replace("IMAGE", "wood"));
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(2)); WorkerPool workers = new WorkerPool(2)) {
                long all = renderer.render(scene, Progress.NONE).rays().gather();
                Scene edited = room(text.replace("IMAGE", "checker"));
                RayCounts rays = renderer.render(edited, Progress.NONE).rays();
                assertThat(rays.gather()).isBetween(visible ? 1L : 0, visible ? all : 0);
                assertThat(visible || rays.total() == 0).isTrue();
                FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(edited).trace(workers, Progress.NONE).film(), "texture");
            }
        }
    }
}
