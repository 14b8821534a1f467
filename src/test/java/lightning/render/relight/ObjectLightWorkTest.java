package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Falloff;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Work after edits of a light that is the surface of a shape, and of the shape. */
class ObjectLightWorkTest {
    private final StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene());

    /** Returns the studio with a glowing ball that is its light, and a sun. */
    private static Scene scene() {
        Scene studio = StudioScene.of(LightType.OBJECT);
        List<Material> materials = new java.util.ArrayList<>(studio.materials());
        materials.add(Material.of("glow").withDiffuse(Rgb.BLACK).withBulb(Bulb.NONE.withLight(StudioScene.KEY)));
        List<Light> lights = List.of(studio.lights().getFirst(), StudioScene.key(LightType.DIRECTIONAL).withName("sun"));
        return studio.withStage(studio.stage().withMaterials(materials)).withLights(lights)
                .withNode("ball", ((Shape) studio.stage().node("ball").orElseThrow()).withMaterial("glow"));
    }

    @AfterEach
    void close() {
        assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
        studio.close();
    }

    private void assertNoRay(UnaryOperator<Light> edit) {
        assertThat(studio.edit(edit).rays().total()).isZero();
    }

    @Test
    void weight_castsNoRay() {
        assertNoRay(light -> light.withIntensity(3).withColor(new Rgb(1, 0.5, 0.2)));
        assertNoRay(light -> light.withEmission(light.emission().withExposure(1)));
        assertNoRay(light -> light.withOn(false));
        assertNoRay(light -> light.withOn(true).withSolo(true));
    }

    @Test
    void falloff_castsNoRay() {
        assertNoRay(light -> light.withFalloff(Falloff.INVERSE_SQUARE));
    }

    /** The light moves with its shape; that of the sun casts rays only where the shape was or is in its way. */
    @Test
    void movedShape_movesItsLight() {
        UpdateResult update = move(new Vec3(0.3, 0.4, 0));
        assertThat(update.rays().shadow()).isPositive();
        assertThat(StudioRenderer.layers(update).getFirst()).isInstanceOf(LightUpdate.FullRecompute.class);
    }

    private UpdateResult move(Vec3 at) {
        Shape ball = (Shape) studio.scene().stage().node("ball").orElseThrow();
        return studio.render(studio.scene().withNode("ball", ball.withPlacement(ball.placement().withPosition(at))));
    }

    @Test
    void movedOtherShape_keepsTheLightsPlace() {
        Shape mirror = (Shape) studio.scene().stage().node("mirror").orElseThrow();
        studio.render(studio.scene().withNode("mirror", mirror.withPlacement(mirror.placement().withPosition(new Vec3(-2, 0.5, -1)))));
        assertThat(studio.key().area().shape()).isEqualTo("ball");
    }

    @Test
    void deletedShape_darkensItsLight() {
        studio.render(studio.scene().replaceNode("ball", List.of()));
        assertThat(studio.key().area().shape()).isEmpty();
    }

    @Test
    void hiddenShape_isDarkAndComesBack() {
        Shape ball = (Shape) studio.scene().stage().node("ball").orElseThrow();
        studio.render(studio.scene().withNode("ball", ball.withVisible(false)));
        assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
        studio.render(studio.scene().withNode("ball", ball));
    }

    @Test
    void otherShape_becomesTheLight() {
        studio.edit(light -> light.withArea(light.area().withShape("mirror")));
    }

    @Test
    void glowMap_changesTheLight() {
        var map = new TextureMap("a.png", 1, 1, new Texture(1, 2, new float[] {1, 0, 0, 0, 0, 1}));
        studio.render(studio.scene().withStage(studio.scene().stage().withMaterials(studio.scene().materials().stream()
                .map(m -> m.name().equals("glow") ? m.withGlowMap(Optional.of(map)) : m).toList())));
        assertNoRay(light -> light.withIntensity(0.5));
        assertNoRay(light -> light.withFalloff(Falloff.INVERSE_SQUARE));
    }
}
