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

/** The edits of lights that are more than one {@link NumericParameter}. Each is refused if there is no light of the name given. */
public final class LightEdits {
    /** Leaves room for a number in a name of the greatest length. */
    private static final int MAX_STEM = SceneLimits.MAX_NAME - 7;

    private LightEdits() {}

    /**
     * The light of that name.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static Light light(Scene scene, String name) {
        return scene.light(name).orElseThrow(() -> new IllegalArgumentException(Messages.tr("light {0} not found", Quote.of(name))));
    }

    /** Any edit of one light that keeps its name. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<Light> edit) {
        return EditOutcome.of(() -> scene.withLight(edit.apply(light(scene, name))));
    }

    /** The color as hue, saturation and value, of linear channels. */
    public static EditOutcome setHsv(Scene scene, String name, HsvColor color) {
        return EditOutcome.of(() -> scene.withLight(light(scene, name).withColor(color.rgb())));
    }

    /**
     * The color of a glowing body, at the brightest channel that the light has now.
     *
     * @param kelvin 1667…25000
     */
    public static EditOutcome setTemperature(Scene scene, String name, double kelvin) {
        return edit(scene, name, l -> l.withColor(ColorTemperature.rgb(kelvin).times(l.color().isBlack() ? 1 : l.color().max())));
    }

    /** Another type; all attributes are kept (paper §4.5). */
    public static EditOutcome setType(Scene scene, String name, LightType type) {
        return edit(scene, name, l -> l.withType(type));
    }

    public static EditOutcome setOn(Scene scene, String name, boolean on) {
        return edit(scene, name, l -> l.withOn(on));
    }

    public static EditOutcome setSolo(Scene scene, String name, boolean solo) {
        return edit(scene, name, l -> l.withSolo(solo));
    }

    /** Refused if the name is taken or could not stand in a scene file. */
    public static EditOutcome rename(Scene scene, String name, String newName) {
        return EditOutcome.of(() -> {
            Light light = light(scene, name);
            return scene.withLights(scene.lights().stream().map(l -> l == light ? l.withName(newName) : l).toList());
        });
    }

    /** Adds a light as the last. Its name is made free by a number, {@code key2}, where it is taken. */
    public static EditOutcome add(Scene scene, Light light) {
        return EditOutcome.of(() -> {
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.add(light.withName(freeName(scene, light.name())));
            return scene.withLights(lights);
        });
    }

    /** Adds a white light that stands at the camera, up to its right, and shines at what the camera looks at. */
    public static EditOutcome add(Scene scene, LightType type) {
        return EditOutcome.of(() -> {
            var view = PreviewCamera.of(scene);
            double distance = view.distance();
            Vec3 position = view.camera().from().plus(view.right().times(distance / 2)).plus(view.up().times(distance / 2));
            Light light = Light.of(type.name().toLowerCase(Locale.ROOT), type)
                    .withPosition(position).withDirection(view.camera().to().minus(position));
            // A surface is as large as one finds in a studio: half as wide as it is far away.
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

    /** Puts a light like this one, with a free name, behind it and a little beside it. */
    public static EditOutcome duplicate(Scene scene, String name) {
        return EditOutcome.of(() -> {
            Light light = light(scene, name);
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.add(lights.indexOf(light) + 1,
                    light.withName(freeName(scene, name)).withPosition(DuplicateOffset.duplicatePosition(scene, light.position())));
            return scene.withLights(lights);
        });
    }

    /**
     * Gives a light the settings of another: type, color and all that shapes its light. It keeps its name, its place, its
     * direction and its switches.
     */
    public static EditOutcome pasteSettings(Scene scene, String name, Light settings) {
        return edit(scene, name, light -> {
            Light pasted = light;
            for (LightAttribute<?> attribute : LightAttribute.ALL) {
                pasted = attribute.isSetting() ? attribute.copy(settings, pasted) : pasted;
            }
            return pasted;
        });
    }

    /** The name itself, or with the least number behind it that no light, shape or group has: {@code key2}. */
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
