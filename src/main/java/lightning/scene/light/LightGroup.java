package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.SceneLimits;

/**
 * Light group: a master for several lights, like a fader of a lighting desk ({@code bank} in a scene file). A light belongs to at most one
 * group, by name ({@link Light#lightGroup}); its own settings stay unchanged. {@link LightRig#effectiveLights} applies the groups.
 *
 * @param name      unique among all shapes, groups, lights and light groups
 * @param color     gel for all of its lights: linear factors of their colors, 0 … 1
 * @param intensity master intensity: factor of their intensities, 0 … 1000
 * @param on        false switches all of its lights off
 * @param solo      true solos all of its lights
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

    /** All attributes, in file order. */
    public static final List<SceneAttribute<LightGroup, ?>> ATTRIBUTES = List.of(COLOR, INTENSITY, ON, SOLO);

    public LightGroup {
        SceneLimits.checkName(name);
        COLOR.check(color);
        INTENSITY.check(intensity);
    }

    /** Returns a neutral light group. */
    public static LightGroup of(String name) {
        return new LightGroup(name, COLOR.initial(), INTENSITY.initial(), ON.initial(), SOLO.initial());
    }

    /**
     * Returns a light with this group's settings applied and its group cleared. Multiplies the factors into its color and its intensity,
     * which is limited to {@link Light#maxIntensity}.
     */
    Light applyTo(Light light) {
        return light.withLightGroup("").withColor(light.color().times(color))
                .withIntensity(Math.min(light.intensity() * intensity, light.maxIntensity()))
                .withOn(light.on() && on).withSolo(light.solo() || solo);
    }
}
