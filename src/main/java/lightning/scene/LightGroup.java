package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import lightning.base.math.Rgb;

/**
 * Lights that are mastered together, as by one fader of a lighting desk: a light may belong to one, by its name
 * ({@link Light#lightGroup}), and each light's own settings stay what they are. {@link LightRig#effectiveLights} tells what the lights become.
 *
 * @param name      unique among all shapes, groups, lights and banks
 * @param color     a gel before all of its lights: linear factors of their colors, 0 … 1
 * @param intensity the master: a factor of their intensities, 0 … 1000
 * @param on        whether any of them shines
 * @param solo      whether they are all solo
 */
@RecordBuilder
public record LightGroup(String name, Rgb color, double intensity, boolean on, boolean solo) implements LightGroupBuilder.With {
    public static final SceneAttribute<LightGroup, Rgb> COLOR = new SceneAttribute<>("color", "color", NumericKind.color(1), Rgb.WHITE,
            "linear, multiplies the lights' colors", LightGroup::color, LightGroup::withColor);
    public static final SceneAttribute<LightGroup, Double> INTENSITY = new SceneAttribute<>("intensity", "intensity",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the lights' intensities", LightGroup::intensity,
            LightGroup::withIntensity);
    public static final SceneAttribute<LightGroup, Boolean> ON =
            new SceneAttribute<>("on", "on", ChoiceKind.YES_OR_NO, true, "", LightGroup::on, LightGroup::withOn);
    public static final SceneAttribute<LightGroup, Boolean> SOLO =
            new SceneAttribute<>("solo", "solo", ChoiceKind.YES_OR_NO, false, "", LightGroup::solo,
                    LightGroup::withSolo);

    /** All of them, in the order in which a file writes them. */
    public static final List<SceneAttribute<LightGroup, ?>> ATTRIBUTES = List.of(COLOR, INTENSITY, ON, SOLO);

    public LightGroup {
        SceneLimits.checkName(name);
        COLOR.check(color);
        INTENSITY.check(intensity);
    }

    /** A bank that leaves its lights as they are. */
    public static LightGroup of(String name) {
        return new LightGroup(name, COLOR.initial(), INTENSITY.initial(), ON.initial(), SOLO.initial());
    }

    /**
     * A light as it shines in this bank, and in none: the factors are multiplied into its color and its intensity, which stays at
     * most {@link SceneLimits#MAX_INTENSITY}.
     */
    Light applyTo(Light light) {
        return light.withLightGroup("").withColor(light.color().times(color))
                .withIntensity(Math.min(light.intensity() * intensity, SceneLimits.MAX_INTENSITY))
                .withOn(light.on() && on).withSolo(light.solo() || solo);
    }
}
