package lightning.document;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.document.manipulation.DuplicateOffset;
import lightning.document.manipulation.ViewFocus;
import lightning.scene.Scene;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Emission;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;

/** Edits of lights that change more than one number. Each is refused if the named light does not exist. */
public final class LightEdits {
    /** Leaves room for a number within the maximum name length. */
    private static final int MAX_STEM = SceneLimits.MAX_NAME - 7;

    private LightEdits() {}

    /**
     * Returns the light with that name.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static Light light(Scene scene, String name) {
        return scene.light(name).orElseThrow(() -> new RefusalException(Messages.tr("light {0} not found", Quote.of(name))));
    }

    /** Edits one light, keeping its name. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<Light> edit) {
        return EditOutcome.of(() -> scene.withLight(edit.apply(light(scene, name))));
    }

    /** Sets the color as hue, saturation and value of linear channels. */
    public static EditOutcome setHsv(Scene scene, String name, HsvColor color) {
        return EditOutcome.of(() -> scene.withLight(light(scene, name).withColor(color.rgb())));
    }

    /**
     * Sets the color temperature, which multiplies the light's color.
     *
     * @param kelvin 1667…25000
     */
    public static EditOutcome setTemperature(Scene scene, String name, double kelvin) {
        return edit(scene, name, l -> LightAttribute.TEMPERATURE.with(l, kelvin));
    }

    /**
     * Changes the type and keeps all attributes (paper §4.5), except that a light with inverse-square falloff or a photometric unit keeps
     * its brightness where the camera looks.
     */
    public static EditOutcome setType(Scene scene, String name, LightType type) {
        return edit(scene, name, light -> {
            IntensityUnit unit = light.emission().unit();
            Light relative = withUnit(scene, light, IntensityUnit.RELATIVE);
            return withUnit(scene, keepBrightness(scene, relative, relative.withType(type)), unit);
        });
    }

    /**
     * Sets a value of a list. A light keeps its brightness where the camera looks if its falloff changes, and everywhere if the unit of its
     * intensity changes.
     */
    public static <V> EditOutcome setChoice(Scene scene, String name, SceneAttribute<Light, V> attribute, V value) {
        return edit(scene, name, light -> attribute == LightAttribute.UNIT ? withUnit(scene, light, (IntensityUnit) value)
                : attribute == LightAttribute.FALLOFF ? keepBrightness(scene, light, attribute.with(light, value))
                : attribute.with(light, value));
    }

    private static Light withUnit(Scene scene, Light light, IntensityUnit unit) {
        return Emission.withUnit(light, unit, scene.world().meters());
    }

    private static Light keepBrightness(Scene scene, Light before, Light after) {
        boolean changes = before.falloff() != after.falloff()
                || before.falloff() == Falloff.INVERSE_SQUARE && before.type().hasPosition() != after.type().hasPosition();
        return !changes ? after : NewLight.keepBrightness(before, after, ViewFocus.of(scene).minus(before.position()).length());
    }

    public static EditOutcome setOn(Scene scene, String name, boolean on) {
        return edit(scene, name, l -> l.withOn(on));
    }

    public static EditOutcome setSolo(Scene scene, String name, boolean solo) {
        return edit(scene, name, l -> l.withSolo(solo));
    }

    /** Renames a light; refused if the name is taken or invalid in a scene file. */
    public static EditOutcome rename(Scene scene, String name, String newName) {
        return EditOutcome.of(() -> {
            light(scene, name);
            return scene.renameLight(name, newName);
        });
    }

    /** Adds a light at the end. If its name is taken, appends a number, {@code key2}. */
    public static EditOutcome add(Scene scene, Light light) {
        return EditOutcome.of(() -> {
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.add(light.withName(freeName(scene, light.name())));
            return scene.withLights(lights);
        });
    }

    /** Adds a white light at the upper right of the camera, aimed at the point that the camera looks at ({@link NewLight}). */
    public static EditOutcome add(Scene scene, LightType type) {
        return EditOutcome.of(() -> add(scene, NewLight.of(scene, type)).sceneOr(scene));
    }

    public static EditOutcome delete(Scene scene, String name) {
        return EditOutcome.of(() -> {
            Light light = light(scene, name);
            return scene.withLights(scene.lights().stream().filter(l -> l != light).toList());
        });
    }

    /** Adds a copy of a light after it, with a unique name and a small offset. */
    public static EditOutcome duplicate(Scene scene, String name) {
        return EditOutcome.of(() -> {
            Light light = light(scene, name);
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.add(lights.indexOf(light) + 1,
                    light.withName(freeName(scene, name)).withPosition(DuplicateOffset.duplicatePosition(scene, light.position())));
            return scene.withLights(lights);
        });
    }

    /** Applies the settings of another light: type, color and shaping. Keeps name, position, direction and switches. */
    public static EditOutcome pasteSettings(Scene scene, String name, Light settings) {
        return edit(scene, name, light -> {
            Light pasted = light;
            for (LightAttribute<?> attribute : LightAttribute.ALL) {
                pasted = attribute.isSetting() ? attribute.copy(settings, pasted) : pasted;
            }
            return pasted;
        });
    }

    /** Returns the name itself, or the name with the smallest number that no light, shape or group has: {@code key2}. */
    public static String freeName(Scene scene, String name) {
        if (!scene.isNameUsed(name)) {
            return name;
        }
        String stem = name.replaceFirst("\\d+$", "");
        String shortStem = stem.codePointCount(0, stem.length()) <= MAX_STEM ? stem
                : stem.substring(0, stem.offsetByCodePoints(0, MAX_STEM));
        return IntStream.iterate(2, i -> i + 1).mapToObj(i -> shortStem + i).filter(n -> !scene.isNameUsed(n)).findFirst().orElseThrow();
    }
}
