package lightning.format.review.live;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.render.relight.LightContributions;
import lightning.scene.Scene;
import lightning.scene.ViewSettings;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.value.SceneLimits;

/**
 * Values of the faders of a live page: those of the scene, never differences. Those from a page are only the changed ones.
 *
 * @param exposure stops; empty if it did not change
 */
public record LiveState(List<LightValue> lights, List<GroupValue> groups, Optional<Double> exposure) {
    /**
     * Values of a light, or of the environment.
     *
     * @param intensity ≥ 0, in the light's unit
     * @param color     linear RGB, 0 to 1; white for the environment
     */
    public record LightValue(String name, double intensity, Rgb color, boolean mute, boolean solo) {}

    /**
     * Values of a light group.
     *
     * @param intensity ≥ 0
     */
    public record GroupValue(String name, double intensity, boolean mute, boolean solo) {}

    /** Returns all values of a scene; the environment comes after the lights. */
    public static LiveState of(Scene scene) {
        List<LightValue> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(new LightValue(light.name(), light.intensity(), light.color(), !light.on(), light.solo()));
        }
        if (hasEnvironment(scene)) {
            lights.add(new LightValue(LightContributions.ENVIRONMENT, scene.world().intensity(), Rgb.WHITE, false,
                    scene.world().solo()));
        }
        return new LiveState(List.copyOf(lights), scene.rig().lightGroups().stream()
                .map(group -> new GroupValue(group.name(), group.intensity(), !group.on(), group.solo())).toList(),
                Optional.of(scene.picture().view().exposure()));
    }

    private static boolean hasEnvironment(Scene scene) {
        return scene.world().environment().isPresent() && scene.light(LightContributions.ENVIRONMENT).isEmpty();
    }

    /** Returns a scene with these values, within the limits of scenes. Lights and groups that it does not have are left out. */
    public Scene applyTo(Scene scene) {
        Scene changed = scene;
        for (LightValue value : lights) {
            Optional<Light> light = changed.light(value.name());
            if (light.isPresent()) {
                Light old = light.get();
                changed = changed.withLight(old.withIntensity(Math.min(value.intensity(), SceneLimits.MAX_INTENSITY / old.maxFactor()))
                        .withColor(value.color()).withOn(!value.mute()).withSolo(value.solo()));
            } else if (value.name().equals(LightContributions.ENVIRONMENT) && hasEnvironment(changed)) {
                double intensity = value.mute() ? 0 : value.intensity();
                changed = changed.withWorld(changed.world().withIntensity(Math.min(intensity, SceneLimits.MAX_GROUP_INTENSITY))
                        .withSolo(value.solo()));
            }
        }
        for (GroupValue value : groups) {
            Optional<LightGroup> group = changed.rig().lightGroup(value.name());
            if (group.isPresent()) {
                changed = changed.withRig(changed.rig().with(group.get()
                        .withIntensity(Math.min(value.intensity(), SceneLimits.MAX_GROUP_INTENSITY)).withOn(!value.mute())
                        .withSolo(value.solo())));
            }
        }
        if (exposure.isEmpty()) {
            return changed;
        }
        ViewSettings view = changed.picture().view();
        double limited = Math.clamp(exposure.get(), -ViewSettings.MAX_EXPOSURE, ViewSettings.MAX_EXPOSURE);
        return changed.withPicture(changed.picture().withView(view.withExposure(limited)));
    }
}
