package lightning.document;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Edits of the light mixer on one or all selected channels, each one undo step. */
public final class MixerEdits {
    /** Significant digits of a fader's value, so that files stay readable: a step of 10⁻⁵ is 1/70000 stop. */
    private static final MathContext DIGITS = new MathContext(6);

    private MixerEdits() {}

    /** Converts an intensity to stops, its base-2 logarithm; −∞ for 0. */
    public static double stops(double intensity) {
        return Math.log(intensity) / Math.log(2);
    }

    /** Converts stops to an intensity with six digits; 0 for −∞. */
    public static double intensityOfStops(double stops) {
        return rounded(Math.pow(2, stops));
    }

    private static double rounded(double v) {
        return v == 0 || !Double.isFinite(v) ? v : BigDecimal.valueOf(v).round(DIGITS).doubleValue();
    }

    /** Sets the intensity of each channel (absolute edit). */
    public static EditOutcome setIntensity(Scene scene, Collection<MixerChannel> channels, double intensity) {
        return editEach(scene, channels, (s, channel) -> channel.with(s, v -> v.withIntensity(intensity)));
    }

    /**
     * Multiplies the intensity of each channel (relative edit). Refused if one exceeds its maximum.
     *
     * @param base scene with the initial intensities
     */
    public static EditOutcome scaleIntensity(Scene scene, Scene base, Collection<MixerChannel> channels, double factor) {
        return editEach(scene, channels, (s, channel) -> {
            double intensity = channel.values(base).intensity();
            return channel.with(s, v -> v.withIntensity(factor == 1 ? intensity : rounded(intensity * factor)));
        });
    }

    /**
     * Multiplies all light sources: every light and the environment. Light groups, which multiply their lights, stay unchanged, as do
     * ambience and background.
     */
    public static EditOutcome scaleAll(Scene scene, Scene base, double factor) {
        return scaleIntensity(scene, base,
                MixerChannel.channelsOf(scene).stream().filter(c -> !(c instanceof MixerChannel.OfLightGroup)).toList(), factor);
    }

    /** Edits each channel. */
    public static EditOutcome editEach(Scene scene, Collection<MixerChannel> channels, BiFunction<Scene, MixerChannel, Scene> edit) {
        return EditOutcome.of(() -> {
            Scene edited = scene;
            for (MixerChannel channel : channels) {
                edited = edit.apply(edited, channel);
            }
            return edited;
        });
    }

    /**
     * Moves a light within the order of the scene, which is that of its file.
     *
     * @param before light that follows it then; the moved light joins that light's group
     */
    public static EditOutcome moveBefore(Scene scene, String light, String before) {
        return EditOutcome.of(() -> {
            Light moved = LightEdits.light(scene, light);
            Light next = LightEdits.light(scene, before);
            if (moved == next) {
                return scene;
            }
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.remove(moved);
            lights.add(lights.indexOf(next), moved.withLightGroup(next.lightGroup()));
            return scene.withLights(lights);
        });
    }

    /**
     * Moves a light group within the order of the groups, which is that of the file.
     *
     * @param before group that follows it then; empty for the last place
     */
    public static EditOutcome moveLightGroup(Scene scene, String group, Optional<String> before) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().moveLightGroup(group, before)));
    }

    /**
     * Moves a light after the last one of a group, which it joins.
     *
     * @param group name of a group; empty for lights without a group
     */
    public static EditOutcome moveToEnd(Scene scene, String light, String group) {
        return EditOutcome.of(() -> {
            Light moved = LightEdits.light(scene, light);
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.remove(moved);
            OptionalInt last = IntStream.range(0, lights.size()).filter(i -> lights.get(i).lightGroup().equals(group)).reduce((_, i) -> i);
            lights.add(last.isPresent() ? last.getAsInt() + 1 : lights.size(), moved.withLightGroup(group));
            return scene.withLights(lights);
        });
    }
}
