package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.node.SceneNode;
import org.junit.jupiter.api.Test;

/** Tests which edits cast rays for blurred reflections, and that the picture is that of a full trace. */
class BlurredReflectionWorkTest {
    private static Scene scene() throws JenException {
        return JenReader.read("""
                jen 1
                picture { size 40 30  depth 2 }
                camera { from 0 1 5  to 0 0.4 0  fov 40 }
                world { ambience 0 }
                material table { model principled  base 0.3 0.2 0.1  roughness 0.4 }
                material red { diffuse 0.8 0.1 0.1 }
                material lamp { diffuse 0 0 0  glow 2 2 2 }
                plane top { material table  scale 6 1 6 }
                sphere ball { material red  at 0 0.5 0  scale 0.5 0.5 0.5 }
                sphere bulb { material lamp  at -1 0.4 0.5  scale 0.1 0.1 0.1 }
                light key point { at 2 3 3 }
                """, "table", Path.of(".")).scene();
    }

    private static UpdateResult edit(Scene before, Scene after) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(before, Progress.NONE);
            Film first = renderer.film().copy();
            UpdateResult update = renderer.render(after, Progress.NONE);
            assertThat(renderer.film().hasSameBits(first)).as("same picture").isFalse();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(after).trace(), "reflection");
            return update;
        }
    }

    private static Scene withMaterial(Scene scene, String name, UnaryOperator<Material> edit) {
        return scene.withMaterials(scene.materials().stream().map(m -> m.name().equals(name) ? edit.apply(m) : m).toList());
    }

    /** Returns the rays that gather light in the first pass of a scene with indirect light, and those of an edit. */
    private static long[] gatherRays(UnaryOperator<Scene> edit) throws JenException {
        Scene scene = scene();
        Scene before = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        Scene after = edit.apply(before);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            long first = renderer.render(before, Progress.NONE).rays().gather();
            long edited = renderer.render(after, Progress.NONE).rays().gather();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(after).trace(), "reflection");
            return new long[] {first, edited};
        }
    }

    @Test
    void roughness_keepsPathsOfIndirectLight() throws JenException {
        long[] rays = gatherRays(scene -> withMaterial(scene, "table", m -> m.withRoughness(0.5)));
        assertThat(rays[1]).isLessThan(rays[0] / 2);
    }

    @Test
    void roughness_castsNoRayOfGatherPoints() throws JenException {
        Scene scene = scene();
        Scene before = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        Scene after = withMaterial(before, "table", m -> m.withRoughness(0.5));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            assertThat(renderer.render(before, Progress.NONE).rays().gathering().points()).isPositive();
            assertThat(renderer.render(after, Progress.NONE).rays().gathering().points()).isZero();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(after).trace(), "reflection");
        }
    }

    @Test
    void hiddenObject_keepsPathsOfIndirectLightThatPassIt() throws JenException {
        long[] rays = gatherRays(scene -> scene.withNode("bulb", scene.stage().node("bulb").orElseThrow().withVisible(false)));
        assertThat(rays[1]).isLessThan(rays[0]);
    }

    private static Scene moved(Scene scene, String name, Vec3 by) {
        SceneNode node = scene.stage().node(name).orElseThrow();
        return scene.withNode(name, node.withPlacement(node.placement().withPosition(node.placement().position().plus(by))));
    }

    @Test
    void movedObject_keepsReflectionsThatCannotMeetIt() throws JenException {
        SceneNode ball = scene().stage().node("ball").orElseThrow();
        Scene scene = scene().withNode("ball",
                ball.withPlacement(ball.placement().withScale(new Vec3(0.1, 0.1, 0.1)).withPosition(new Vec3(1.5, 0.1, -1))));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            long first = renderer.render(scene, Progress.NONE).rays().gather();
            Scene after = moved(scene, "ball", new Vec3(0.1, 0, 0));
            long moved = renderer.render(after, Progress.NONE).rays().gather();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(after).trace(), "moved-ball");
            assertThat(moved).isPositive().isLessThan(first / 2);
        }
    }

    @Test
    void objectSeenInAMirrorByRays_isMovedThereToo() throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 40 30  depth 2 }
                camera { from 0 1 5  to 0 0.4 0  fov 40 }
                world { ambience 0 }
                material table { model principled  base 0.9 0.9 0.9  metalness 1  roughness 0.3 }
                material mirror { diffuse 0 0 0  reflective 0.95 0.95 0.95 }
                material red { diffuse 0.9 0.1 0.1 }
                plane top { material table  scale 4 1 4 }
                plane back { material mirror  at 0 2 -2  rotate 90 0 0  scale 6 1 4 }
                sphere ball { material red  at 0 2 6  scale 0.7 0.7 0.7 }
                light key point { at 2 3 3 }
                """, "mirror", Path.of(".")).scene();
        assertThat(edit(scene, moved(scene, "ball", new Vec3(1, 0, 0))).rays().gather()).isPositive();
    }

    @Test
    void lightColor_castsNoRay() throws JenException {
        Scene scene = scene();
        UpdateResult update = edit(scene, scene.withLight(scene.lights().getFirst().withColor(new Rgb(1, 0.5, 0.2))));
        assertThat(update.rays().gather()).isZero();
        assertThat(update.rays().shadow()).isZero();
    }

    @Test
    void movedLight_castsShadowRaysOnly() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, scene.withLight(scene.lights().getFirst().withPosition(new Vec3(1, 3, 3)))).rays().gather()).isZero();
    }

    @Test
    void colorOfReflectedObject_castsNoRay() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, withMaterial(scene, "red", m -> m.withDiffuse(new Rgb(0.1, 0.8, 0.1)))).rays().gather()).isZero();
    }

    @Test
    void colorOfReflectingSurface_castsNoRay() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withBase(new Rgb(0.1, 0.2, 0.3)).withF0(0.08))).rays().gather())
                .isZero();
    }

    @Test
    void colorOfSheen_castsNoRay() throws JenException {
        Scene scene = withMaterial(scene(), "table", m -> m.withSheen(new Sheen(Rgb.gray(0.5), 0.5)));
        UpdateResult update = edit(scene, withMaterial(scene, "table", m -> m.withSheen(m.sheen().withColor(new Rgb(0.2, 0.9, 0.4)))));
        assertThat(update.rays().gather()).isZero();
        assertThat(update.rays().shadow()).isZero();
        assertThat(update.rowsTouched()).isZero();
    }

    @Test
    void roughnessOfSheen_castsReflectedRaysAgain() throws JenException {
        Scene scene = withMaterial(scene(), "table", m -> m.withSheen(new Sheen(Rgb.gray(0.5), 0.5)));
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withSheen(m.sheen().withRoughness(0.7)))).rays().gather()).isPositive();
    }

    @Test
    void anisotropyThatBegins_castsReflectedRaysAgain() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withAnisotropy(new Anisotropy(0.8, 20)))).rays().gather()).isPositive();
    }

    @Test
    void anisotropyThatEnds_castsReflectedRaysAgain() throws JenException {
        Scene scene = withMaterial(scene(), "table", m -> m.withAnisotropy(new Anisotropy(0.8, 20)));
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withAnisotropy(Anisotropy.NONE))).rays().gather()).isPositive();
    }

    @Test
    void rotationOfAnisotropy_castsReflectedRaysAgain() throws JenException {
        Scene scene = withMaterial(scene(), "table", m -> m.withAnisotropy(new Anisotropy(0.8, 0)));
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withAnisotropy(m.anisotropy().withRotation(90)))).rays().gather())
                .isPositive();
    }

    @Test
    void colorOfAnisotropicNonmetal_castsNoRay() throws JenException {
        Scene scene = withMaterial(scene(), "table", m -> m.withAnisotropy(new Anisotropy(0.8, 30)));
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withBase(new Rgb(0.1, 0.2, 0.3)))).rays().gather()).isZero();
    }

    @Test
    void strongerGlow_castsNoRay() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, withMaterial(scene, "lamp", m -> m.withGlow(new Rgb(3, 2, 1)))).rays().gather()).isZero();
    }

    @Test
    void roughness_castsReflectedRaysAgain() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, withMaterial(scene, "table", m -> m.withRoughness(0.2))).rays().gather()).isPositive();
    }

    /** Rays of an edit are those of its material, and those that find what the picture shows, at most one for each pixel and bounce. */
    @Test
    void roughness_castsRaysOfItsMaterialOnly() throws JenException {
        Scene scene = withBall(scene(), 0.5);
        long table = edit(scene, withMaterial(scene, "table", m -> m.withRoughness(0.3))).rays().gather();
        long ball = edit(scene, withBall(scene, 0.3)).rays().gather();
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            long both =
                    renderer.render(withBall(withMaterial(scene, "table", m -> m.withRoughness(0.3)), 0.3), Progress.NONE).rays().gather();
            assertThat(table + ball - both).isBetween(0L, 40L * 30 * 2);
            assertThat(ball).isGreaterThan(40 * 30 * 2);
        }
    }

    private static Scene withBall(Scene scene, double roughness) {
        return withMaterial(scene, "red", m -> Material.of("red").withModel(ShadingModel.PRINCIPLED).withRoughness(roughness));
    }

    /** Each edit keeps paths that an edit before it kept. */
    @Test
    void editsInSequence_equalFullTraces() throws JenException {
        Scene scene = withBall(scene(), 0.5);
        Scene gathers = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        List<UnaryOperator<Scene>> edits = List.of(s -> withBall(s, 0.3), s -> withMaterial(s, "table", m -> m.withRoughness(0.2)),
                s -> withMaterial(s, "table", m -> m.withCoat(new Coat(1, 0.3, 1.5))), s -> withBall(s, 0.02), s -> withBall(s, 0.6),
                s -> withMaterial(s, "table", m -> m.withRoughness(0.5)), s -> s.withPicture(s.picture().withDepth(3)),
                s -> withMaterial(s, "lamp", m -> m.withGlow(Rgb.BLACK)), s -> withBall(s, 0.4));
        for (Scene first : List.of(scene, gathers)) {
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
                renderer.render(first, Progress.NONE);
                Scene edited = first;
                for (int i = 0; i < edits.size(); i++) {
                    edited = edits.get(i).apply(edited);
                    renderer.render(edited, Progress.NONE);
                    FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edited).trace(), "reflection " + i);
                }
            }
        }
    }

    @Test
    void glowThatEnds_castsReflectedRaysAgain() throws JenException {
        Scene scene = scene();
        assertThat(edit(scene, withMaterial(scene, "lamp", m -> m.withGlow(Rgb.BLACK))).rays().gather()).isPositive();
    }
}
