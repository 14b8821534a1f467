package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.base.text.Messages;
import lightning.scene.asset.Environment;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/**
 * Further environment of a scene, whose radiance is added to that of the world's own environment.
 *
 * @param name       unique among domes, lights, light groups, shapes and groups
 * @param image      environment map; a dome without one has no effect
 * @param rotation   rotation of the image
 * @param intensity  factor of its image and light
 * @param gain       factor of its light alone; its image stays
 * @param lightCount maximum number of directional lights that represent its small bright parts
 * @param softness   spread of each light over its part, 0 … 1
 * @param on         false if it is neither visible nor lights anything
 * @param solo       true if its light is soloed: if it is not dark, all lights and environments that are not solo are dark
 */
@RecordBuilder
public record Dome(String name, Optional<Environment> image, DomeRotation rotation, double intensity, double gain, int lightCount,
        double softness, boolean on, boolean solo) implements DomeBuilder.With {
    public static final SceneAttribute<Dome, Optional<Environment>> ENVIRONMENT =
            like(World.ENVIRONMENT, "image", Dome::image, Dome::withImage);
    public static final SceneAttribute<Dome, Double> ROTATION = like(World.ROTATION, "rotation", dome -> dome.rotation.rotation(),
            (dome, v) -> dome.withRotation(dome.rotation.withRotation(v)));
    public static final SceneAttribute<Dome, Double> TILT = like(World.TILT, "tilt", dome -> dome.rotation.tilt(),
            (dome, v) -> dome.withRotation(dome.rotation.withTilt(v)));
    public static final SceneAttribute<Dome, Double> ROLL = like(World.ROLL, "roll", dome -> dome.rotation.roll(),
            (dome, v) -> dome.withRotation(dome.rotation.withRoll(v)));
    public static final SceneAttribute<Dome, Double> INTENSITY = like(World.INTENSITY, "intensity", Dome::intensity, Dome::withIntensity);
    public static final SceneAttribute<Dome, Double> GAIN = like(World.GAIN, "light gain", Dome::gain, Dome::withGain);
    public static final SceneAttribute<Dome, Integer> LIGHT_COUNT =
            like(World.LIGHT_COUNT, "bright lights", Dome::lightCount, Dome::withLightCount);
    public static final SceneAttribute<Dome, Double> SOFTNESS =
            like(World.SOFTNESS, "shadow smoothing", Dome::softness, Dome::withSoftness);
    public static final SceneAttribute<Dome, Boolean> ON =
            new SceneAttribute<>("on", "on", ChoiceKind.YES_OR_NO, true, "", Dome::on, Dome::withOn);
    public static final SceneAttribute<Dome, Boolean> SOLO = like(World.SOLO, "solo", Dome::solo, Dome::withSolo);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<Dome, ?>> ATTRIBUTES =
            List.of(ENVIRONMENT, ROTATION, TILT, ROLL, INTENSITY, GAIN, LIGHT_COUNT, SOFTNESS, ON, SOLO);

    public Dome {
        SceneLimits.checkName(name);
        ROTATION.check(rotation.rotation());
        TILT.check(rotation.tilt());
        ROLL.check(rotation.roll());
        INTENSITY.check(intensity);
        GAIN.check(gain);
        LIGHT_COUNT.check(lightCount);
        SOFTNESS.check(softness);
    }

    /** Returns a dome without an image. */
    public static Dome of(String name) {
        return new Dome(name, Optional.empty(), DomeRotation.NONE, INTENSITY.initial(), GAIN.initial(), LIGHT_COUNT.initial(),
                SOFTNESS.initial(), ON.initial(), SOLO.initial());
    }

    /** Returns an attribute with the name, range and default of one of the world's environment. */
    private static <V> SceneAttribute<Dome, V> like(SceneAttribute<World, V> attribute, String title,
            Function<Dome, V> getter, BiFunction<Dome, V, Dome> setter) {
        return new SceneAttribute<>(attribute.name(), title, attribute.kind(), attribute.initial(), attribute.unit(), getter, setter);
    }

    /** Returns a clause that says why an attribute has no effect; empty if it has. */
    public Optional<String> inactiveReason(SceneAttribute<Dome, ?> attribute) {
        return image.isEmpty() && attribute != ENVIRONMENT ? Optional.of(Messages.tr("the dome has no image"))
                : !on && attribute != ON ? Optional.of(Messages.tr("the dome is off")) : Optional.empty();
    }

    /** Returns its environment; empty without an image. */
    Optional<EnvironmentLayer> layer() {
        return image.map(e -> new EnvironmentLayer(name, e.map(), rotation, intensity, gain, lightCount, softness, on, solo));
    }

    /** Returns the factor of its light, ≥ 0; 0 if it is off or without an image. */
    public double lightIntensity() {
        return on && image.isPresent() ? intensity * gain : 0;
    }
}
