package lightning.review.live;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.FaderValues;
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
     * Values of a light or an environment.
     *
     * @param intensity ≥ 0, in the light's unit
     * @param color     linear RGB, 0 to 1; white for an environment
     */
    public record LightValue(String name, double intensity, Rgb color, boolean mute, boolean solo) {}

    /**
     * Values of a light group.
     *
     * @param intensity ≥ 0
     */
    public record GroupValue(String name, double intensity, boolean mute, boolean solo) {}

    /** Returns all values of a scene; environments come after the lights. */
    public static LiveState of(Scene scene) {
        List<LightValue> lights = new ArrayList<>();
        for (Contribution part : Contribution.sources(scene)) {
            FaderValues v = part.values(scene);
            // The intensity of the world's own environment is its switch, too: see changed.
            boolean mute = !v.on() && !part.equals(Contribution.ENVIRONMENT);
            lights.add(new LightValue(part.name(scene), v.intensity(), v.color().orElse(Rgb.WHITE), mute, v.solo()));
        }
        return new LiveState(List.copyOf(lights), scene.rig().lightGroups().stream()
                .map(group -> new GroupValue(group.name(), group.intensity(), !group.on(), group.solo())).toList(),
                Optional.of(scene.picture().view().exposure()));
    }

    private static Light changed(Light light, LightValue value) {
        return light.withIntensity(Math.min(value.intensity(), SceneLimits.MAX_INTENSITY / light.maxFactor()))
                .withColor(value.color()).withOn(!value.mute()).withSolo(value.solo());
    }

    /** Returns a scene with these values of an environment. The world's own has no switch; if it is mute, its intensity is 0. */
    private static Scene changed(Scene scene, Contribution environment, LightValue value) {
        boolean isOwn = environment.equals(Contribution.ENVIRONMENT);
        double intensity = isOwn && value.mute() ? 0 : Math.min(value.intensity(), environment.maxIntensity());
        return environment.with(scene, v -> v.withIntensity(intensity).withOn(isOwn ? v.on() : !value.mute()).withSolo(value.solo()));
    }

    /** Returns a scene with these values, within the limits of scenes. Lights and groups that it does not have are left out. */
    public Scene applyTo(Scene scene) {
        Scene changed = scene;
        for (LightValue value : lights) {
            Optional<Contribution> part = Contribution.named(scene, value.name()).filter(Contribution.sources(scene)::contains);
            Optional<Light> light = scene.light(value.name());
            changed = light.isPresent() ? changed.withLight(changed(light.get(), value))
                    : part.isPresent() ? changed(changed, part.get(), value) : changed;
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
