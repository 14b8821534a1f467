package lightning.editor.document;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import lightning.scene.Light;
import lightning.scene.Scene;

/** The edits of the light mixer: of one strip or of all that are selected, each one step to undo. */
public final class MixerEdits {
    /** What a fader sets has so many digits, that files stay readable: a step of 10⁻⁵ is a 70000th of a stop. */
    private static final MathContext DIGITS = new MathContext(6);

    private MixerEdits() {}

    /** Stops of an intensity: its logarithm to the base of 2; −∞ for 0. */
    public static double stops(double intensity) {
        return Math.log(intensity) / Math.log(2);
    }

    /** The intensity of so many stops, to six digits; 0 for −∞. */
    public static double intensityOfStops(double stops) {
        return rounded(Math.pow(2, stops));
    }

    private static double rounded(double v) {
        return v == 0 || !Double.isFinite(v) ? v : BigDecimal.valueOf(v).round(DIGITS).doubleValue();
    }

    /** Sets the intensity of each: the absolute edit. */
    public static EditOutcome setIntensity(Scene scene, Collection<MixerChannel> channels, double intensity) {
        return editEach(scene, channels, (s, channel) -> channel.withIntensity(s, intensity));
    }

    /**
     * Makes the intensity of each so many times what it was: the relative edit. Refused where that is too much for one.
     *
     * @param base the scene of which they were
     */
    public static EditOutcome scaleIntensity(Scene scene, Scene base, Collection<MixerChannel> channels, double factor) {
        return editEach(scene, channels, (s, channel) -> channel.withIntensity(s,
                factor == 1 ? channel.intensity(base) : rounded(channel.intensity(base) * factor)));
    }

    /**
     * Makes all that shines so many times what it was: every light and the environment. Banks, which are factors of their
     * lights, stay, and so do ambience and background.
     */
    public static EditOutcome scaleAll(Scene scene, Scene base, double factor) {
        return scaleIntensity(scene, base,
                MixerChannel.channelsOf(scene).stream().filter(c -> !(c instanceof MixerChannel.OfLightGroup)).toList(), factor);
    }

    /** Any edit of each. */
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
     * Puts a light to another place in the order of the scene, which is that of its file.
     *
     * @param before the light that it stands before then; of another bank, or none, it joins that one too
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
     * Puts a bank to another place in the order of the banks, which is that of the file.
     *
     * @param before the bank that it stands before then; empty for the last place
     */
    public static EditOutcome moveLightGroup(Scene scene, String group, Optional<String> before) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().moveLightGroup(group, before)));
    }

    /**
     * Puts a light behind the last of a bank, which it joins.
     *
     * @param group a bank's name; empty for the lights in none
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
