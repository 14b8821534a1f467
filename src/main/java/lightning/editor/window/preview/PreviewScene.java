package lightning.editor.window.preview;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Environment;
import lightning.scene.EnvironmentLight;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;

/**
 * The scene as the preview traces it, which has neither mirrors nor shadows: what would be black without the one has a color, and what
 * would burn out without the other is dimmed.
 */
final class PreviewScene {
    /** How much of a metal stays one: all else scatters its color, in place of what it would mirror. */
    private static final double METAL_FACTOR = 0.4;
    /** Which part of what a mirror would show it scatters. */
    private static final double REFLECTION_FACTOR = 0.5;

    /** What white paper in an environment stays below, about. */
    private static final double MAX_WHITE = 0.9;

    private Stage stage;
    private Stage previewStage;
    private List<EnvironmentLight> environmentLights = List.of();
    /** What white paper shines with under these, where it is turned to the most light. */
    private double maxBrightness;

    Scene of(Scene scene) {
        if (scene.stage() != stage) {
            stage = scene.stage();
            // A list that is equal leaves the stage as it is, and with it all that is known of it.
            previewStage = stage.withMaterials(stage.materials().stream().map(PreviewScene::scatterReflections).toList());
        }
        World world = scene.world();
        return scene.withStage(previewStage).withWorld(world.environment().map(e -> dim(world, e)).orElse(world));
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
     * A world whose environment leaves white paper below 1. Nothing shades its lamps here: what lets a little of them through a window
     * would be lit by all.
     */
    private World dim(World world, Environment environment) {
        List<EnvironmentLight> newLights = environment.map().lights(world.lightCount());
        if (newLights != environmentLights) {
            environmentLights = newLights;
            maxBrightness = newLights.stream().mapToDouble(lamp -> brightness(lamp.direction(), newLights)).max().orElse(0);
        }
        double total = maxBrightness * world.intensity() / MAX_WHITE;
        return total > 0 ? world.withIntensity(-Math.expm1(-total) * MAX_WHITE / maxBrightness) : world;
    }

    private static double brightness(Vec3 normal, List<EnvironmentLight> lights) {
        return lights.stream().mapToDouble(light -> Math.max(0, normal.dot(light.direction()))
                * new Rgb(light.red(), light.green(), light.blue()).luminance()).sum();
    }
}
