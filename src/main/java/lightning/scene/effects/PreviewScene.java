package lightning.scene.effects;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.WeakHashMap;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentLight;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * Converts scenes for the editor's preview, which has a few levels of sharp reflections, and shadows of one light at most: limits the depth,
 * replaces the light of environments by a few lights, dimmed where it would overexpose the picture without shadows, and removes other shadows.
 * Materials that would be black without their blurred or other reflections get diffuse color instead.
 */
public final class PreviewScene {
    /** Remaining metalness of a metal. The rest becomes diffuse, in place of its reflections. */
    private static final double METAL_FACTOR = 0.4;
    /** Share of a mirror's reflection color that becomes diffuse. */
    private static final double REFLECTION_FACTOR = 0.5;

    /** Lights that stand for an environment. */
    private static final int ENVIRONMENT_LIGHTS = 16;

    /** Approximate upper limit of a white diffuse surface's brightness in an environment. */
    private static final double MAX_WHITE = 0.9;

    /** Maximum bounces of a scene without transparent materials. Glass would be black where a ray needs more bounces to leave it. */
    private static final int MAX_DEPTH = 3;

    private @Nullable Stage stage;
    private @Nullable Stage previewStage;
    private boolean isSharpShown;
    /** Maximum brightness of a white diffuse surface lit by the lights of an environment, over the orientations toward each light. */
    private final Map<EnvironmentMap, Double> maxBrightness = new WeakHashMap<>();

    /**
     * Scene and effects of a preview.
     *
     * @param scene   converted scene
     * @param effects effects to show
     */
    public record Request(Scene scene, ViewEffects effects) {}

    /**
     * Returns what to render.
     *
     * @param shadowLight name of the only light that casts shadows; empty for none
     * @param effects     {@link ViewEffects#PREVIEW} or {@link ViewEffects#PREVIEW_1998}
     * @param wantsShadows false without any shadows
     */
    public Request request(Scene scene, String shadowLight, ViewEffects effects, boolean wantsShadows) {
        return new Request(wantsShadows ? withoutOtherShadows(of(scene), shadowLight) : of(scene),
                effects.with(RenderEffect.SHADOWS, wantsShadows).with(RenderEffect.REFLECTION, showsReflections(scene)));
    }

    private static Scene withoutOtherShadows(Scene scene, String shadowLight) {
        return scene.withLights(scene.lights().stream()
                .map(light -> light.name().equals(shadowLight) ? light : LightAttribute.SHADOWED_BY.with(light, ShapeLinks.NONE)).toList());
    }

    /** Returns whether the preview of a scene shows reflections. */
    static boolean showsReflections(Scene scene) {
        return scene.picture().depth() > 0;
    }

    Scene of(Scene scene) {
        List<Dome> environments = scene.world().environments();
        Scene dimmed = environments.isEmpty() ? scene : withLights(scene, environments);
        Scene shown = showsReflections(scene) ? dimmed.withPicture(scene.picture().withDepth(depth(scene))) : dimmed;
        return shown.withStage(withoutHiddenReflections(scene));
    }

    /** Replaces the light of environments, but not their images, by lights: a preview gathers no light. */
    private Scene withLights(Scene scene, List<Dome> environments) {
        double dimming = dimming(environments);
        int count = Math.min(ENVIRONMENT_LIGHTS, SceneLimits.MAX_LIGHTS - scene.lights().size()) / environments.size();
        List<Light> lights = new ArrayList<>(scene.lights());
        Set<String> names = new HashSet<>();
        for (Dome environment : count > 0 ? environments : List.<Dome>of()) {
            List<Light> added = environment.withGain(dimming * environment.gain())
                    .approximateLights(count, name -> scene.isNameUsed(name) || names.contains(name));
            added.forEach(light -> names.add(light.name()));
            lights.addAll(added);
        }
        World world = scene.world();
        return scene.withWorld(world.withDomes(world.domes().stream().map(d -> d.withGain(0)).toList())).withLights(lights);
    }

    private static int depth(Scene scene) {
        int depth = scene.picture().depth();
        return scene.materials().stream().anyMatch(Material::isClear) ? depth : Math.min(depth, MAX_DEPTH);
    }

    private Stage withoutHiddenReflections(Scene scene) {
        if (previewStage == null || scene.stage() != stage || isSharpShown != showsReflections(scene)) {
            stage = scene.stage();
            isSharpShown = showsReflections(scene);
            // withMaterials returns the same stage for an equal list, so that caches stay valid.
            previewStage = stage.withMaterials(stage.materials().stream()
                    .map(m -> m.reflectsRoughly() || isSharpShown ? scatterBlur(m) : scatterReflections(m)).toList());
        }
        return previewStage;
    }

    /** Replaces blurred reflections, whose rays a preview has no time for, by diffuse color. */
    public static Scene withoutBlur(Scene scene) {
        return scene.withMaterials(scene.materials().stream().map(PreviewScene::scatterBlur).toList());
    }

    private static Material scatterBlur(Material material) {
        return material.reflectsRoughly() ? scatterReflections(material).withModel(ShadingModel.METALLIC) : material;
    }

    static Material scatterReflections(Material material) {
        return material.isMetallic() ? material.withMetalness(METAL_FACTOR * material.metalness())
                : material.reflective().isBlack() ? material
                : material.withDiffuse(sum(material.diffuse(), material.reflective()));
    }

    private static Rgb sum(Rgb diffuse, Rgb reflective) {
        return new Rgb(Math.min(1, diffuse.r() + REFLECTION_FACTOR * reflective.r()),
                Math.min(1, diffuse.g() + REFLECTION_FACTOR * reflective.g()),
                Math.min(1, diffuse.b() + REFLECTION_FACTOR * reflective.b()));
    }

    /**
     * Returns the factor of the environments' light, not of their images, by which white diffuse surfaces stay below 1. Without shadows, an
     * interior that a window lights sparsely would receive light from the whole environment.
     */
    private double dimming(List<Dome> environments) {
        double total = 0;
        for (Dome environment : environments) {
            total += maxBrightness.computeIfAbsent(environment.map(), PreviewScene::maxBrightness) * environment.lightIntensity()
                    / MAX_WHITE;
        }
        return total > 0 ? Math.min(-Math.expm1(-total) / total, 1) : 1;
    }

    private static double maxBrightness(EnvironmentMap map) {
        List<EnvironmentLight> lights = map.lights(ENVIRONMENT_LIGHTS);
        return lights.stream().mapToDouble(lamp -> brightness(lamp.direction(), lights)).max().orElse(0);
    }

    private static double brightness(Vec3 normal, List<EnvironmentLight> lights) {
        return lights.stream().mapToDouble(light -> Math.max(0, normal.dot(light.direction()))
                * new Rgb(light.red(), light.green(), light.blue()).luminance()).sum();
    }
}
