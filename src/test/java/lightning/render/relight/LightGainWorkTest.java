package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Influence;
import lightning.scene.light.LightType;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeGains;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that edits of a light's gains only compose, and that a light without shadows casts no shadow rays. */
class LightGainWorkTest {
    private static final LightUpdate SHADOWS =
            new LightUpdate.Partial(lightning.render.shading.layer.ConeChange.NONE, false, false, true);

    private static UpdateResult contribute(StudioRenderer studio, Influence contribution) {
        return studio.edit(l -> l.withInfluence(contribution));
    }

    private static void assertComposedOnly(StudioRenderer studio, UpdateResult update) {
        assertThat(StudioRenderer.layers(update)).containsExactly(new LightUpdate.Reweight());
        assertThat(update.rays().total()).as("rays").isZero();
        assertThat(update.rowsTouched()).as("rows touched").isZero();
        assertExact(studio);
    }

    private static void assertExact(StudioRenderer studio) {
        assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
    }

    private static StudioRenderer current(Scene scene) {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene);
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void diffuseAndSpecularGain_onlyCompose(LightType type) {
        try (StudioRenderer studio = current(StudioScene.of(type))) {
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT.withDiffuse(0.3)));
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT.withSpecular(2.5)));
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT.withDiffuse(0)));
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT));
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void gainOnObject_findsOwnersOnceAndThenOnlyComposes(LightType type) {
        try (StudioRenderer studio = current(StudioScene.of(type))) {
            UpdateResult first = contribute(studio, Influence.DEFAULT.withGains(ShapeGains.of("ball", 0.5)));
            assertThat(StudioRenderer.layers(first)).containsExactly(new LightUpdate.Reweight());
            assertThat(first.rays().shadow()).isZero();
            assertThat(first.rays().eye()).isPositive();
            assertExact(studio);
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT.withGains(ShapeGains.of("ball", 0.3))));
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT.withGains(ShapeGains.of("ball", 0).with("floor", 2))));
            assertComposedOnly(studio, contribute(studio, Influence.DEFAULT.withGains(ShapeGains.of("floor", 1))));
        }
    }

    /** In every mode of reflections, because gains of an older scene may be in mirrors. */
    @ParameterizedTest
    @EnumSource(ReflectionMode.class)
    void gainOnObject_isInMirrors(ReflectionMode mode) {
        try (var studio = new StudioRenderer(mode, MirrorStorage.FULL_ROWS, StudioScene.of(LightType.POINT))) {
            Scene before = studio.scene();
            contribute(studio, Influence.DEFAULT.withGains(ShapeGains.of("floor", 0.25)));
            Scene mirrored = mode == ReflectionMode.STALE ? before : studio.scene();
            assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene(), mirrored).trace())).isTrue();
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void lightWithoutShadows_castsNoShadowRays(LightType type) {
        Scene scene = StudioScene.of(type);
        scene = scene.withLight(scene.lights().getFirst().withInfluence(Influence.DEFAULT.withCastsShadows(false)));
        try (Renderer renderer = new Renderer(new lightning.render.RenderOptions(
                lightning.render.relight.paper.Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1))) {
            UpdateResult first = renderer.render(scene, lightning.base.work.Progress.NONE);
            assertThat(first.rays().shadow()).isZero();
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(scene).trace())).isTrue();
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void removedShadows_castNoShadowRays(LightType type) {
        try (StudioRenderer studio = current(StudioScene.of(type))) {
            UpdateResult off = contribute(studio, Influence.DEFAULT.withCastsShadows(false));
            assertThat(StudioRenderer.layers(off)).containsExactly(SHADOWS);
            assertThat(off.rays().shadow()).isZero();
            assertExact(studio);
            assertThat(contribute(studio, Influence.DEFAULT).rays().shadow()).isPositive();
            assertExact(studio);
        }
    }

    /** A shape that joins a group takes the group's gain. */
    @Test
    void regroupedShape_onlyComposes() {
        Scene start = StudioScene.of(LightType.POINT);
        SceneNode ball = start.stage().node("ball").orElseThrow();
        NodeGroup empty = new NodeGroup("a", Placement.IDENTITY, List.of(), true);
        NodeGroup full = new NodeGroup("b", Placement.IDENTITY, List.of(ball), true);
        try (StudioRenderer studio = current(start.replaceNode("ball", List.of(empty, full)))) {
            contribute(studio, Influence.DEFAULT.withGains(ShapeGains.of("a", 0.5)));
            assertExact(studio);
            Scene moved = studio.scene().replaceNode("b", List.of(full.withChildren(List.of())));
            UpdateResult update = studio.render(moved.replaceNode("a", List.of(empty.withChildren(List.of(ball)))));
            assertThat(update.rays().shadow()).isZero();
            assertExact(studio);
        }
    }

    @Test
    void innermostGain_applies() {
        Scene studio = StudioScene.of(LightType.POINT);
        SceneNode ball = studio.stage().node("ball").orElseThrow();
        Scene grouped = studio.replaceNode("ball", List.of(new NodeGroup("set", Placement.IDENTITY, List.of(ball), true)));
        ShapeGains onBall = ShapeGains.of("ball", 0.5);
        assertThat(picture(grouped, ShapeGains.of("set", 0.2).with("ball", 0.5))).isEqualTo(picture(grouped, onBall));
        assertThat(picture(grouped, ShapeGains.of("set", 0.5))).isEqualTo(picture(grouped, onBall));
        assertThat(picture(grouped, ShapeGains.of("set", 0.2))).isNotEqualTo(picture(grouped, onBall));
    }

    private static List<Float> picture(Scene scene, ShapeGains gains) {
        try (StudioRenderer studio = current(scene.withLight(
                scene.lights().getFirst().withInfluence(Influence.DEFAULT.withGains(gains))))) {
            var film = studio.renderer().film();
            return java.util.stream.IntStream.range(0, film.width() * film.height())
                    .mapToObj(i -> film.red(i % film.width(), i / film.width())).toList();
        }
    }

    /** Edges are found from rounded gains, like weights. */
    @Test
    void gainsThatAreNoPowersOfTwo_smoothTheEdgesOfTheReference() throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 40 24  antialias edges  samples 3 }
                camera { from 0 1 6  to 0 0 0 }
                material white { diffuse 0.8 0.7 0.6 }
                plane floor { material white  at 0 -1 0  scale 14 1 14 }
                sphere ball { material white }
                sphere small { material white  at 1.5 0 0  scale 0.4 0.4 0.4 }
                light key point { at 3 4 3  gains "ball" 0.4 "small" 0.7 "floor" 0.75 }
                """, "edges.jen", Path.of("")).scene();
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "gains at edges");
        }
    }
}
