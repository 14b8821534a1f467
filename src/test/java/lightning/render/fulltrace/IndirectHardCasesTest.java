package lightning.render.fulltrace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.sample.SampleMeshes;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.BumpMapping;
import lightning.scene.node.Mesh;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Laws of indirect light in scenes that provoke leaks, spots at contacts, rays below surfaces and growing light. */
class IndirectHardCasesTest {
    /** As in {@link IndirectLightTest}, for at most 1024 points. */
    private static final float FILTER_ROUNDING = 2 * 1024 * 0x1p-24f;
    /** Shell of light 1 that reflects nothing. */
    private static final String SKY = """
            material sky { diffuse 0 0 0  glow 1 1 1 }
            sphere sky { material sky  scale 50 50 50 }
            """;
    private static final TextureMap STEPS = new TextureMap("steps.png", 9, 9,
            new Texture(3, 1, new float[] {0, 0, 0, 1, 1, 1, 0.2f, 0.2f, 0.2f}));

    private static Scene scene(String picture, String text, int bounces) throws JenException {
        Scene scene = JenReader.read("jen 1\npicture { " + picture + "  depth 0 }\n" + text, "hard.jen", Path.of("")).scene();
        return scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(bounces, 16, 4, false))));
    }

    private static Film trace(Scene scene) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
        }
    }

    /** A convex body meets only the sky, whatever its shading normals: each of its points receives 1. */
    @ParameterizedTest
    @ValueSource(strings = {"plane body { material white  scale 4 1 4 }", "sphere body { material white }",
        "cylinder body { material white  at 0 -0.5 0 }"})
    void bumpsOnConvexBody_receiveSkyAlone(String body) throws JenException {
        Scene flat =
                scene("size 32 24", "camera { from 0 2 4  to 0 0 0  fov 30 }\nmaterial white { diffuse 0.5 0.5 0.5 }\n" + SKY + body, 1);
        BumpMapping steep = BumpMapping.NONE.withBump(Optional.of(STEPS)).withHeight(2);
        Film film = trace(flat.withMaterial(flat.material("white").orElseThrow().withBumpMapping(steep)));
        for (int i = 0; i < 32 * 24; i++) {
            float value = film.red(i % 32, i / 32);
            assertThat(value == 1 ? 0.5f : value).as("pixel %d, %d", i % 32, i / 32).isCloseTo(0.5f, within(FILTER_ROUNDING));
        }
    }

    /** Boxes that touch are one body for the light: no point of their common front meets anything but the sky. */
    @Test
    void touchingBoxes_showNoSeam() throws JenException {
        StringBuilder boxes = new StringBuilder("material white { diffuse 0.5 0.5 0.5 }\n");
        for (int i = -2; i <= 2; i++) {
            boxes.append("plane front" + (i + 2) + " { material white  at " + i + " 0 0.5  rotate 90 0 0  scale 1 1 2 }\n");
            boxes.append("plane right" + (i + 2) + " { material white  at " + (i + 0.5) + " 0 0  rotate 0 0 90  scale 2 1 1 }\n");
            boxes.append("plane left" + (i + 2) + " { material white  at " + (i - 0.5) + " 0 0  rotate 0 0 90  scale 2 1 1 }\n");
        }
        Film film = trace(scene("size 48 16", "camera { from 0.3 0 6  to 0 0 0  fov 14 }\n" + SKY + boxes, 2));
        for (int i = 0; i < 48 * 16; i++) {
            assertThat(film.red(i % 48, i / 48)).as("pixel %d, %d", i % 48, i / 48).isCloseTo(0.5f, within(FILTER_ROUNDING));
        }
    }

    /** With an albedo of 1 each bounce adds the light of the shell once, and never more. */
    @ParameterizedTest
    @ValueSource(ints = {1, 8})
    void largestAlbedo_addsNoEnergy(int bounces) throws JenException {
        Film film = trace(scene("size 16 12", """
                camera { from 0.2 0.1 0.3  to 0 0 -1 }
                material shell { diffuse 1 1 1  glow 1 1 1 }
                sphere around { material shell  scale 2 2 2 }
                """, bounces));
        for (int i = 0; i < 16 * 12; i++) {
            assertThat(film.red(i % 16, i / 16)).isCloseTo(bounces + 1, within((bounces + 1) * FILTER_ROUNDING));
        }
    }

    /** Only places below the floor meet light. Vertex normals lift points of a body that touches it, but none below it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void smoothMeshOnThinFloor_isNotLitFromBelow(boolean isBox) throws JenException {
        Scene floor = scene("size 48 24", """
                camera { from 0 0.3 6  to 0 0 0  fov 20 }
                material white { diffuse 0.9 0.9 0.9 }
                material lamp { diffuse 0 0 0  glow 100 100 100 }
                plane floor { material white  at 0 -1 0  scale 400 1 400 }
                plane below { material lamp  at 0 -3 0  scale 20 1 20 }
                """, 3);
        Mesh mesh = isBox ? SampleMeshes.beveledCube(0.04) : SampleMeshes.ball(8, 12, true);
        List<SceneNode> nodes = new ArrayList<>(floor.nodes());
        nodes.add(new Shape(SampleMeshes.solid(mesh), "body", "white", Placement.IDENTITY));
        Film film = trace(floor.withNodes(nodes));
        for (int i = 0; i < 48 * 24; i++) {
            assertThat(film.red(i % 48, i / 48)).as("pixel %d, %d", i % 48, i / 48).isZero();
        }
    }

    /** Cells at the foot of a thin wall may reach below it. What they let through is small against the light of the room beside. */
    @Test
    void thinWallBetweenVisibleRooms_leaksLessThanOnePercent() throws JenException {
        Film film = trace(scene("size 160 64", """
                camera { from 0 0 5  to 0 0 0  fov 24 }
                material white { diffuse 0.8 0.8 0.8 }
                plane floor { material white  at 0 -1 0  scale 4 1 2 }
                plane ceiling { material white  at 0 1 0  scale 4 1 2 }
                plane back { material white  at 0 0 -1  rotate 90 0 0  scale 4 1 2 }
                plane left { material white  at -2 0 0  rotate 0 0 90  scale 2 1 2 }
                plane right { material white  at 2 0 0  rotate 0 0 90  scale 2 1 2 }
                plane wall { material white  at 0.013 0 0  rotate 0 0 90  scale 2 1 2 }
                light lamp point { at 1.2 0.5 0.2 }
                """, 2));
        double dark = 0;
        double lit = 0;
        for (int i = 0; i < 160 * 64; i++) {
            dark += i % 160 < 80 ? film.red(i % 160, i / 160) : 0;
            lit += i % 160 > 80 ? film.red(i % 160, i / 160) : 0;
        }
        assertThat(dark).isLessThan(0.01 * lit);
    }
}
