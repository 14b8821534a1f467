package lightning.format.review.live;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.Dome;
import lightning.scene.EnvironmentLayer;
import lightning.scene.Scene;
import lightning.scene.ViewSettings;
import lightning.scene.World;
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
        if (scene.world().hasEnvironment()) {
            lights.add(environment(scene));
        }
        return new LiveState(List.copyOf(lights), scene.rig().lightGroups().stream()
                .map(group -> new GroupValue(group.name(), group.intensity(), !group.on(), group.solo())).toList(),
                Optional.of(scene.picture().view().exposure()));
    }

    /** Returns the values of all environments together: the intensity of the first, which the others follow. */
    private static LightValue environment(Scene scene) {
        World world = scene.world();
        boolean isOff = world.environments().stream().noneMatch(EnvironmentLayer::on);
        return new LightValue(Contribution.ENVIRONMENT.name(scene), world.firstIntensity(), Rgb.WHITE, isOff,
                world.environments().stream().anyMatch(EnvironmentLayer::solo));
    }

    private static Light changed(Light light, LightValue value) {
        return light.withIntensity(Math.min(value.intensity(), SceneLimits.MAX_INTENSITY / light.maxFactor()))
                .withColor(value.color()).withOn(!value.mute()).withSolo(value.solo());
    }

    /**
     * Returns the world of a scene with these values of its environments. If they are mute or their fader is down, the domes are off, and keep
     * their intensities.
     */
    private static World changed(Scene scene, LightValue value) {
        World world = scene.world();
        LightValue before = environment(scene);
        double first = Math.min(value.intensity(), SceneLimits.MAX_GROUP_INTENSITY);
        boolean isOff = isOff(value);
        World lit = !isOff ? world.mapIntensities(intensity -> scaled(intensity, before.intensity(), first))
                : world.environment().isPresent() ? world.withIntensity(0) : world;
        boolean isSwitched = isOff || isOff(before) && world.domes().stream().noneMatch(Dome::on);
        World switched = isSwitched ? lit.withDomes(lit.domes().stream().map(dome -> dome.withOn(!isOff)).toList()) : lit;
        return value.solo() == before.solo() ? switched : switched.withAllSolo(value.solo());
    }

    private static boolean isOff(LightValue value) {
        return value.mute() || value.intensity() == 0;
    }

    /** Returns an environment's intensity after a change of the first one's; from 0 only those that are 0 rise, since their share is unknown. */
    private static double scaled(double intensity, double firstBefore, double first) {
        return firstBefore > 0 ? Math.min(intensity * (first / firstBefore), SceneLimits.MAX_GROUP_INTENSITY)
                : intensity == 0 ? first : intensity;
    }

    /** Returns a scene with these values, within the limits of scenes. Lights and groups that it does not have are left out. */
    public Scene applyTo(Scene scene) {
        Scene changed = scene;
        for (LightValue value : lights) {
            Optional<Contribution> part = Contribution.named(changed, value.name());
            if (part.isPresent()) {
                changed = switch (part.get()) {
                    case Contribution.OfLight(String name) -> changed.withLight(changed(changed.light(name).orElseThrow(), value));
                    case Contribution.OfEnvironment _ -> changed.withWorld(changed(changed, value));
                };
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
