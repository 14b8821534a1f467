package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/** Edits of lights that change more than one {@link NumericParameter}. Each is refused if the named light does not exist. */
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
        return scene.light(name).orElseThrow(() -> new IllegalArgumentException(Messages.tr("light {0} not found", Quote.of(name))));
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
     * Sets the color of a black body, keeping the light's brightest channel.
     *
     * @param kelvin 1667…25000
     */
    public static EditOutcome setTemperature(Scene scene, String name, double kelvin) {
        return edit(scene, name, l -> l.withColor(ColorTemperature.rgb(kelvin).times(l.color().isBlack() ? 1 : l.color().max())));
    }

    /** Changes the type and keeps all attributes (paper §4.5). */
    public static EditOutcome setType(Scene scene, String name, LightType type) {
        return edit(scene, name, l -> l.withType(type));
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
            Light light = light(scene, name);
            return scene.withLights(scene.lights().stream().map(l -> l == light ? l.withName(newName) : l).toList());
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

    /** Adds a white light at the upper right of the camera, aimed at the camera's target. */
    public static EditOutcome add(Scene scene, LightType type) {
        return EditOutcome.of(() -> {
            var view = PreviewCamera.of(scene);
            double distance = view.distance();
            Vec3 position = view.camera().from().plus(view.right().times(distance / 2)).plus(view.up().times(distance / 2));
            Light light = Light.of(type.name().toLowerCase(Locale.ROOT), type)
                    .withPosition(position).withDirection(view.camera().to().minus(position));
            // Area lights have a typical studio size: half as wide as they are distant.
            return add(scene,
                    type.isSurface() ? light.withArea(light.area().withRadius(halfSize(distance)).withWidth(2 * halfSize(distance))
                            .withHeight(2 * halfSize(distance))) : light)
                    .sceneOr(scene);
        });
    }

    private static double halfSize(double distance) {
        return Math.min(distance / 4, SceneLimits.MAX_EXTENT / 2);
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
