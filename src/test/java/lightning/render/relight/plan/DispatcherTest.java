package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.RatioMethod;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.layer.ConeChange;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.Texture;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests the origin of each layer and its least update, for lists of lights and at accuracy ratio. */
class DispatcherTest {
    private static final LightUpdate KEEP = new LightUpdate.Keep();
    private static final LightUpdate REWEIGHT = new LightUpdate.Reweight();
    private static final LightUpdate ADDED = new LightUpdate.FullRecompute(true);
    private static final LightUpdate MOVED = new LightUpdate.FullRecompute(false);
    private static final LightUpdate REFRESH = new LightUpdate.Refresh();

    private static Light light(String name, double x) {
        return StudioScene.key(LightType.SPOT).withName(name).withPosition(new Vec3(x, 4, 2));
    }

    private static final Light A = light("a", 0);
    private static final Light B = light("b", 1);
    private static final Scene STUDIO = StudioScene.of(LightType.SPOT).withLights(List.of(A, B));

    private static Renderer renderedWith(Accuracy accuracy, ReflectionMode reflections, Scene scene) {
        Renderer renderer = new Renderer(new RenderOptions(accuracy, reflections, MirrorStorage.FULL_ROWS, 1));
        renderer.render(scene, Progress.NONE);
        return renderer;
    }

    @Test
    void planWithoutMirrors_omitsReflections() {
        Scene mirroring = STUDIO.withPicture(STUDIO.picture().withDepth(2));
        Scene brighter = mirroring.withLights(List.of(A.withIntensity(2), B));
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.CURRENT, mirroring)) {
            assertThat(renderer.plan(brighter).update().description()).isEqualTo("a: weight, reflections");
        }
        UnaryOperator<Scene> matte =
                scene -> scene.withMaterials(scene.materials().stream().map(m -> m.withReflective(Rgb.BLACK)).toList());
        for (Scene[] edit : new Scene[][] {{matte.apply(mirroring), matte.apply(brighter)},
            {mirroring.withPicture(mirroring.picture().withDepth(0)), brighter.withPicture(brighter.picture().withDepth(0))}}) {
            try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.CURRENT, edit[0])) {
                assertThat(renderer.plan(edit[1]).update().description()).isEqualTo("a: weight");
            }
        }
    }

    /** Asserts the old layer and the update of each target light after a picture with the lights A and B. */
    private static void assertOrigins(List<Light> target, List<Integer> from, List<LightUpdate> updates) {
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, STUDIO)) {
            List<LayerPlan> layers = ((UpdatePlan.Relight) renderer.plan(STUDIO.withLights(target)).update()).top().layers();
            assertThat(layers).extracting(layer -> layer.base() == null ? -1 : layer.base().index()).isEqualTo(from);
            assertThat(layers).extracting(LayerPlan::update).isEqualTo(updates);
        }
    }

    @Test
    void reorderedLights_keepLayersByName() {
        assertOrigins(List.of(B, A), List.of(1, 0), List.of(KEEP, KEEP));
    }

    @Test
    void renamedLight_keepsLayerOfEqualLight() {
        assertOrigins(List.of(B.withName("x"), A), List.of(1, 0), List.of(KEEP, KEEP));
        assertOrigins(List.of(B.withName("x")), List.of(1), List.of(KEEP));
        assertOrigins(List.of(B.withName("x"), A.withName("y")), List.of(1, 0), List.of(KEEP, KEEP));
    }

    @Test
    void twoCopiesOfDeletedLight_doNotShareLayer() {
        assertOrigins(List.of(A, B.withName("x"), B.withName("y")), List.of(0, 1, -1), List.of(KEEP, KEEP, ADDED));
    }

    /** A light renamed and dimmed in one edit is matched by index, if the list has the same length and the index is free. */
    @Test
    void renamedAndEditedLight_usesLayerAtSameIndex() {
        Light edited = B.withName("x").withIntensity(0.5);
        assertOrigins(List.of(A, edited), List.of(0, 1), List.of(KEEP, REWEIGHT));
        assertOrigins(List.of(A.withName("y").withIntensity(2), edited), List.of(0, 1), List.of(REWEIGHT, REWEIGHT));
        assertOrigins(List.of(A, edited, B), List.of(0, -1, 1), List.of(KEEP, ADDED, KEEP));
        assertOrigins(List.of(B, edited), List.of(1, -1), List.of(KEEP, ADDED));
        assertOrigins(List.of(edited), List.of(-1), List.of(ADDED));
    }

    @Test
    void changedSizeCameraOrAllShapes_needFirstPass() {
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, STUDIO)) {
            Camera c = STUDIO.camera();
            assertThat(renderer.plan(STUDIO.withPicture(STUDIO.picture().withSize(31, 24))).update())
                    .isEqualTo(new UpdatePlan.FirstPass("resolution changed"));
            assertThat(renderer.plan(STUDIO.withPicture(STUDIO.picture().withSize(30, 25))).update())
                    .isEqualTo(new UpdatePlan.FirstPass("resolution changed"));
            assertThat(renderer.plan(STUDIO.withCamera(new Camera(c.from(), c.to(), c.up(), 41))).update())
                    .isEqualTo(new UpdatePlan.FirstPass("camera changed"));
            Scene others = STUDIO.withNodes(STUDIO.nodes().stream().<SceneNode>map(n -> ((Shape) n).withName(n.name() + "2")).toList());
            assertThat(renderer.plan(others).update()).isEqualTo(new UpdatePlan.FirstPass("objects changed"));
            Scene finer = STUDIO.withPicture(STUDIO.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 2)));
            assertThat(renderer.plan(finer).update()).isEqualTo(new UpdatePlan.FirstPass("anti-aliasing changed"));
            renderer.clear();
            assertThat(renderer.plan(STUDIO).update()).isEqualTo(new UpdatePlan.FirstPass("no image yet"));
        }
    }

    private static LightUpdate ratioUpdate(Light before, UnaryOperator<Light> edit) {
        Scene scene = STUDIO.withLights(List.of(before, B));
        try (Renderer renderer = renderedWith(Accuracy.RATIO, ReflectionMode.STALE, scene)) {
            List<LayerPlan> layers =
                    ((UpdatePlan.Relight) renderer.plan(scene.withLights(List.of(edit.apply(before), B.withIntensity(3)))).update()).top()
                            .layers();
            assertThat(layers.get(1).update()).isEqualTo(REWEIGHT);
            return layers.getFirst().update();
        }
    }

    /** The paper's rules: a turned light and one whose weight was 0 are recomputed in full, as is one that was almost 0. */
    @Test
    void ratioAccuracy_scalesIfPossibleElseRecomputes() {
        assertThat(ratioUpdate(A, l -> l)).isEqualTo(KEEP);
        assertThat(ratioUpdate(A, l -> l.withIntensity(0.2))).isEqualTo(REWEIGHT);
        assertThat(ratioUpdate(A, l -> l.withIntensity(0))).isEqualTo(REWEIGHT);
        assertThat(ratioUpdate(A, l -> l.withDropoff(7))).isEqualTo(new LightUpdate.Partial(ConeChange.NONE, true, false));
        assertThat(ratioUpdate(A, l -> l.withAngle(7).withIntensity(3)))
                .isEqualTo(new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, false, true));
        assertThat(ratioUpdate(A, l -> l.withDirection(new Vec3(0, -1, 0)))).isEqualTo(MOVED);
        assertThat(ratioUpdate(A, l -> l.withType(LightType.POINT))).isEqualTo(MOVED);
        assertThat(ratioUpdate(A.withColor(new Rgb(1, 0, 1)), l -> l.withColor(Rgb.WHITE))).isEqualTo(MOVED);
        assertThat(ratioUpdate(A.withIntensity(1e-40), l -> l.withDropoff(7))).isEqualTo(MOVED);
        assertThat(ratioUpdate(A.withIntensity(1e-40), l -> l)).as("nothing to scale").isEqualTo(KEEP);
    }

    private static List<LightUpdate> updates(LevelPlan plan) {
        return plan.layers().stream().map(LayerPlan::update).toList();
    }

    /** Refreshes only scaled lights that shine: A was not edited, C was edited and is off now, D never shone. */
    @Test
    void refresh_recomputesScaledContributions() {
        Light c = light("c", 2);
        Light d = light("d", -1).withOn(false);
        Scene first = STUDIO.withLights(List.of(A, B, c, d));
        Scene second = STUDIO.withLights(List.of(A, B.withIntensity(2), c.withIntensity(2), d));
        Scene third = STUDIO.withLights(List.of(A, B.withIntensity(2), c.withIntensity(2).withOn(false), d));
        for (ReflectionMode reflections : ReflectionMode.values()) {
            try (Renderer renderer = renderedWith(Accuracy.RATIO, reflections, first)) {
                renderer.render(second, Progress.NONE);
                renderer.render(third, Progress.NONE);
                UpdatePlan.Relight refresh = RatioMethod.refresh(renderer.cache());
                assertThat(updates(refresh.top())).containsExactly(KEEP, REFRESH, KEEP, KEEP);
                if (reflections == ReflectionMode.STALE) {
                    assertThat(refresh.mirrors()).as("mirrors show another scene").isNull();
                } else {
                    assertThat(updates(refresh.mirrors())).containsExactly(KEEP, REFRESH, KEEP, KEEP);
                }
            }
        }
    }

    private static Scene sampled(Scene scene, AntialiasMode antialias) {
        return scene.withPicture(scene.picture().withSampling(new SamplingSettings(antialias, 2)));
    }

    private static Scene withMirrorBall(Scene scene) {
        return scene.withMaterial(scene.material("matt").orElseThrow().withReflective(Rgb.gray(0.5)));
    }

    private static Scene withMovedBall(Scene scene, Vec3 to) {
        Shape ball = (Shape) scene.stage().node("ball").orElseThrow();
        return scene.withNode("ball", ball.withPlacement(new Placement(to, Vec3.ZERO, Vec3.ONE)));
    }

    private static void assertFirstPass(Renderer renderer, Scene target, String reason) {
        assertThat(renderer.plan(target).update()).isEqualTo(new UpdatePlan.FirstPass(reason));
    }

    @Test
    void edgesEnabled_keepCentersUnlessMirrorsOrShapesChange() {
        Scene edges = sampled(STUDIO, AntialiasMode.EDGES);
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.CURRENT, STUDIO)) {
            assertThat(renderer.plan(edges).update()).isInstanceOf(UpdatePlan.Relight.class);
            assertFirstPass(renderer, withMirrorBall(edges), "anti-aliasing and reflections changed");
            assertFirstPass(renderer, withMovedBall(edges, new Vec3(0.5, 0, 0)), "objects changed");
            assertThat(renderer.plan(withMovedBall(STUDIO, new Vec3(0.5, 0, 0))).update()).isInstanceOf(UpdatePlan.Relight.class);
        }
    }

    /** The mirror images still show a ball that does not mirror. */
    @Test
    void edgesEnabledAfterNewMirror_needFirstPassIfReflectionsAreStale() {
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, STUDIO)) {
            renderer.render(withMirrorBall(STUDIO), Progress.NONE);
            assertFirstPass(renderer, sampled(withMirrorBall(STUDIO), AntialiasMode.EDGES), "anti-aliasing and reflections changed");
        }
    }

    @Test
    void samplesOfEveryPixel_leaveNoCentersToKeep() {
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, sampled(STUDIO, AntialiasMode.EVERY))) {
            assertFirstPass(renderer, sampled(STUDIO, AntialiasMode.EDGES), "anti-aliasing changed");
        }
    }

    @Test
    void edgesEnabledWithForcedMirrors_needFirstPass() {
        ViewEffects forced = ViewEffects.ALL.withForced(Set.of(RenderEffect.REFLECTION));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withView(forced).withThreads(1))) {
            renderer.render(STUDIO, Progress.NONE);
            assertFirstPass(renderer, sampled(STUDIO, AntialiasMode.EDGES), "anti-aliasing changed");
        }
    }

    private static LevelPlan top(Renderer renderer, Scene target) {
        return ((UpdatePlan.Relight) renderer.plan(target).update()).top();
    }

    @Test
    void lightThatNeverShone_isAddedWhenSwitchedOn() {
        Scene dark = STUDIO.withLights(List.of(A, B.withOn(false)));
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, dark)) {
            assertThat(updates(top(renderer, STUDIO))).containsExactly(KEEP, ADDED);
        }
    }

    @Test
    void lightThatNeverShone_keepsSumOfOthers() {
        Scene dark = STUDIO.withLights(List.of(A, B.withOn(false)));
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, dark)) {
            assertThat(updates(top(renderer, dark.withLight(A.withIntensity(2))))).containsExactly(REWEIGHT, KEEP);
        }
    }

    /** Returns the studio with two groups: the ball is in the second, or in the first. */
    private static Scene grouped(boolean inFirst, Light... lights) {
        SceneNode ball = STUDIO.stage().node("ball").orElseThrow();
        NodeGroup first = new NodeGroup("first", Placement.IDENTITY, inFirst ? List.of(ball) : List.of(), true);
        NodeGroup second = new NodeGroup("second", Placement.IDENTITY, inFirst ? List.of() : List.of(ball), true);
        return STUDIO.replaceNode("ball", List.of(first, second)).withLights(List.of(lights));
    }

    /** All its rows on the ball are outside its links afterwards. A dark light loses its layers until it shines. */
    @Test
    void regroupedShape_invalidatesLayersOfLinkedLight() {
        Light linked = A.withIlluminates(ShapeLinks.only("second"));
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, grouped(false, linked, B))) {
            LevelPlan lit = top(renderer, grouped(true, linked, B));
            assertThat(updates(lit)).containsExactly(MOVED, KEEP);
            assertThat(lit.layers().getFirst().base()).isNotNull();
            renderer.render(grouped(false, linked.withOn(false), B), Progress.NONE);
            LevelPlan dark = top(renderer, grouped(true, linked.withOn(false), B));
            assertThat(updates(dark)).containsExactly(KEEP, KEEP);
            assertThat(dark.layers()).extracting(layer -> layer.base() == null).containsExactly(true, false);
        }
    }

    /** Contributions contain gains, terms do not. */
    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void regroupedShape_invalidatesGainsAtAccuracyRatio(Accuracy accuracy) {
        Light gained = A.withInfluence(Influence.DEFAULT.withGains(ShapeGains.of("first", 0.5)));
        try (Renderer renderer = renderedWith(accuracy, ReflectionMode.STALE, grouped(false, gained, B))) {
            assertThat(updates(top(renderer, grouped(true, gained, B)))).containsExactly(accuracy == Accuracy.RATIO ? MOVED : KEEP, KEEP);
            assertThat(updates(top(renderer, withMovedBallInGroup(gained)))).containsExactly(KEEP, KEEP);
        }
    }

    private static Scene withMovedBallInGroup(Light gained) {
        return withMovedBall(grouped(false, gained, B), new Vec3(0.5, 0, 0));
    }

    /**
     * Whether a light lies on a surface is decided up to the rounding of shadow rays, 2⁻⁴⁷ of the largest coordinates in the scene: less
     * than 10⁻¹² with the ball in the studio, more than 10⁻⁸ with the ball at 10⁶.
     */
    @Test
    void farShape_invalidatesLayersOfLightJustAboveAnother() {
        Light near = Light.of("near", LightType.POINT).withPosition(new Vec3(0, -1 + 1e-9, 3));
        Light above = near.withName("above").withPosition(new Vec3(0, 1, 3));
        Light sun = Light.of("sun", LightType.DIRECTIONAL);
        Scene scene = STUDIO.withLights(List.of(near, above, sun));
        try (Renderer renderer = renderedWith(Accuracy.EXACT, ReflectionMode.STALE, scene)) {
            assertThat(updates(top(renderer, withMovedBall(scene, new Vec3(1e6, 0, 0))))).containsExactly(MOVED, KEEP, KEEP);
            assertThat(updates(top(renderer, withMovedBall(scene, new Vec3(0.5, 0, 0))))).containsExactly(KEEP, KEEP, KEEP);
        }
    }

    /** A gobo fills the cone, so another angle changes the light at each point. */
    @Test
    void goboInCone_changesFalloffWithAngleOnly() {
        Light gobo = A.withGobo(Optional.of(new Gobo("half.png", new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0}))));
        assertThat(LightDifference.between(gobo, gobo.withAngle(10)).update())
                .isEqualTo(new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, true, false));
        assertThat(LightDifference.between(gobo, gobo.withIntensity(2)).update()).isEqualTo(REWEIGHT);
        assertThat(LightDifference.between(A, A.withAngle(10)).update())
                .isEqualTo(new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, false, false));
    }
}
