package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.cache.TileLevel;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.composition.BranchSums;
import lightning.render.shading.layer.LightLayer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Contribution;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.value.ShapeGains;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests whether an edit changes one light only, so that the sum of the others can be cached, and whether it changes colors or edges. */
class LevelPlanTest {
    private static final String MATT = "matt";
    private static final Scene SCENE = StudioScene.withFourLights(30, 24);
    /** Shines away from all shapes. */
    private static final Light UNSEEN = StudioScene.key(LightType.SPOT).withName("unseen").withPosition(new Vec3(0, 20, 0))
            .withDirection(Vec3.Y);
    private final Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1));

    @BeforeEach
    void renderScene() {
        renderer.render(SCENE, Progress.NONE);
    }

    @AfterEach
    void close() {
        renderer.close();
    }

    private LevelPlan plan(Scene target) {
        return ((UpdatePlan.Relight) renderer.plan(target).update()).top();
    }

    private int singleChange(Scene target) {
        return plan(target).singleChange();
    }

    private static Scene brighter(Scene scene, int... lights) {
        List<Light> all = new ArrayList<>(scene.lights());
        for (int light : lights) {
            all.set(light, all.get(light).withIntensity(2 * all.get(light).intensity()));
        }
        return scene.withLights(all);
    }

    private static Scene withMatt(Scene scene, UnaryOperator<Material> edit) {
        return scene.withMaterial(edit.apply(scene.material(MATT).orElseThrow()));
    }

    private static Scene withOtherAmbience(Scene scene) {
        return scene.withWorld(scene.world().withAmbience(0.5));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3})
    void editedLight_isSingleChange(int light) {
        assertThat(singleChange(brighter(SCENE, light))).isEqualTo(light);
    }

    @Test
    void editedLights_areSeveral() {
        assertThat(singleChange(brighter(SCENE, 0, 1))).isEqualTo(LevelPlan.SEVERAL);
        assertThat(singleChange(brighter(SCENE, 1, 2, 3))).isEqualTo(LevelPlan.SEVERAL);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 3})
    void editedLightAndSurfaces_areSeveral(int light) {
        Scene edited = brighter(SCENE, light);
        assertThat(singleChange(withOtherAmbience(edited))).isEqualTo(LevelPlan.SEVERAL);
        assertThat(singleChange(withMatt(edited, m -> m.withDiffuse(Rgb.WHITE)))).isEqualTo(LevelPlan.SEVERAL);
    }

    @Test
    void ambienceAndColors_changeNoLight() {
        assertThat(singleChange(withOtherAmbience(SCENE))).isEqualTo(BranchSums.Key.NO_LIGHT);
        assertThat(singleChange(withMatt(SCENE, m -> m.withDiffuse(Rgb.WHITE)))).isEqualTo(BranchSums.Key.NO_LIGHT);
    }

    @Test
    void highlightsTexturesAndMirrors_changeAllLights() {
        TextureMap checks = new TextureMap("checks.png", 3, 2, new Texture(2, 1, new float[] {1, 0.5f, 0, 0, 0.25f, 1}));
        for (UnaryOperator<Material> edit : List.<UnaryOperator<Material>>of(m -> m.withShininess(3), m -> m.withReflective(Rgb.gray(0.5)),
                m -> m.withTexture(Optional.of(checks)))) {
            assertThat(singleChange(withMatt(SCENE, edit))).isEqualTo(LevelPlan.SEVERAL);
        }
    }

    @Test
    void deletedReorderedAndAddedLights_changeTheSum() {
        List<Light> lights = SCENE.lights();
        assertThat(singleChange(SCENE.withLights(lights.subList(0, 3)))).isEqualTo(LevelPlan.SEVERAL);
        assertThat(singleChange(SCENE.withLights(lights.reversed()))).isEqualTo(LevelPlan.SEVERAL);
        List<Light> more = new ArrayList<>(lights);
        more.add(UNSEEN.withOn(false));
        assertThat(singleChange(SCENE.withLights(more))).isEqualTo(LevelPlan.SEVERAL);
    }

    private TileLevel level() {
        return renderer.cache().tile(0).levels[0];
    }

    /** Asserts whether an edit from one scene to another may change colors and edges of the only tile. */
    private void assertChanges(Scene before, Scene target, boolean colors, boolean edges) {
        renderer.render(before, Progress.NONE);
        LevelPlan plan = plan(target);
        TileLevel old = level();
        renderer.render(target, Progress.NONE);
        LightLayer[] after = level().layers();
        assertThat(plan.canChangeColors(old, after)).as("colors").isEqualTo(colors);
        assertThat(plan.canChangeEdges(old, after)).as("edges").isEqualTo(edges);
    }

    /** Edges are detected with weights rounded to powers of two: 1.2 is rounded to 1, and 2 stays. */
    @Test
    void weight_changesEdgesOnlyAtAnotherPowerOfTwo() {
        Light key = SCENE.lights().getFirst().withIntensity(1).withColor(Rgb.WHITE);
        Scene white = SCENE.withLight(key);
        assertChanges(white, white.withLight(key.withIntensity(1.2)), true, false);
        assertChanges(white, white.withLight(key.withIntensity(2)), true, true);
    }

    /** Gains are rounded in the same way: 0.4 is rounded to 0.5. */
    @Test
    void gainOnShape_changesEdgesOnlyAtAnotherPowerOfTwo() {
        Scene dimmed = withGainOnBall(0.4);
        assertChanges(dimmed, withGainOnBall(0.5), true, false);
        assertChanges(dimmed, withGainOnBall(2), true, true);
    }

    private static Scene withGainOnBall(double gain) {
        return SCENE.withLight(SCENE.lights().getFirst().withContribution(Contribution.DEFAULT.withGains(ShapeGains.of("ball", gain))));
    }

    @Test
    void movedAddedOrSwitchedOffLight_changesEdges() {
        Light fill = SCENE.lights().get(1);
        assertChanges(SCENE, SCENE.withLight(fill.withPosition(new Vec3(3, 3, 3))), true, true);
        assertChanges(SCENE, SCENE.withLight(fill.withOn(false)), true, true);
        assertChanges(SCENE.withLights(SCENE.lights().subList(0, 3)), SCENE, true, true);
    }

    @Test
    void lightThatReachesNoRow_changesNothing() {
        Scene unseen = SCENE.withLights(List.of(SCENE.lights().getFirst(), UNSEEN));
        assertChanges(unseen, brighter(unseen, 1), false, false);
    }

    @Test
    void ambience_changesColorsAndEdges() {
        assertChanges(SCENE, withOtherAmbience(SCENE), true, true);
    }

    @Test
    void materialOfTile_changesColorsAndEdges() {
        assertChanges(SCENE, withMatt(SCENE, m -> m.withDiffuse(Rgb.WHITE)), true, true);
    }
}
