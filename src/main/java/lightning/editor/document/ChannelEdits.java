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
public final class ChannelEdits {
    /** What a fader sets has so many digits, that files stay readable: a step of 10⁻⁵ is a 70000th of a stop. */
    private static final MathContext DIGITS = new MathContext(6);

    private ChannelEdits() {}

    /** Stops of an intensity: its logarithm to the base of 2; −∞ for 0. */
    public static double stops(double intensity) {
        return Math.log(intensity) / Math.log(2);
    }

    /** The intensity of so many stops, to six digits; 0 for −∞. */
    public static double ofStops(double stops) {
        return rounded(Math.pow(2, stops));
    }

    private static double rounded(double v) {
        return v == 0 || !Double.isFinite(v) ? v : BigDecimal.valueOf(v).round(DIGITS).doubleValue();
    }

    /** Sets the intensity of each: the absolute edit. */
    public static Change intensity(Scene scene, Collection<Channel> channels, double intensity) {
        return each(scene, channels, (s, channel) -> channel.withIntensity(s, intensity));
    }

    /**
     * Makes the intensity of each so many times what it was: the relative edit. Refused where that is too much for one.
     *
     * @param base the scene of which they were
     */
    public static Change scaled(Scene scene, Scene base, Collection<Channel> channels, double factor) {
        return each(scene, channels, (s, channel) -> channel.withIntensity(s,
                factor == 1 ? channel.intensity(base) : rounded(channel.intensity(base) * factor)));
    }

    /**
     * Makes all that shines so many times what it was: every light and the environment. Banks, which are factors of their
     * lights, stay, and so do ambience and background.
     */
    public static Change mastered(Scene scene, Scene base, double factor) {
        return scaled(scene, base, Channel.all(scene).stream().filter(c -> !(c instanceof Channel.OfBank)).toList(), factor);
    }

    /** Any edit of each. */
    public static Change each(Scene scene, Collection<Channel> channels, BiFunction<Scene, Channel, Scene> edit) {
        return Change.of(() -> {
            Scene edited = scene;
            for (Channel channel : channels) {
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
    public static Change moveBefore(Scene scene, String light, String before) {
        return Change.of(() -> {
            Light moved = LightEdits.light(scene, light);
            Light next = LightEdits.light(scene, before);
            if (moved == next) {
                return scene;
            }
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.remove(moved);
            lights.add(lights.indexOf(next), moved.withBank(next.bank()));
            return scene.withLights(lights);
        });
    }

    /**
     * Puts a bank to another place in the order of the banks, which is that of the file.
     *
     * @param before the bank that it stands before then; empty for the last place
     */
    public static Change moveBank(Scene scene, String bank, Optional<String> before) {
        return Change.of(() -> scene.withRig(scene.rig().withBankBefore(bank, before)));
    }

    /**
     * Puts a light behind the last of a bank, which it joins.
     *
     * @param bank a bank's name; empty for the lights in none
     */
    public static Change moveLast(Scene scene, String light, String bank) {
        return Change.of(() -> {
            Light moved = LightEdits.light(scene, light);
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.remove(moved);
            OptionalInt last = IntStream.range(0, lights.size()).filter(i -> lights.get(i).bank().equals(bank)).reduce((_, i) -> i);
            lights.add(last.isPresent() ? last.getAsInt() + 1 : lights.size(), moved.withBank(bank));
            return scene.withLights(lights);
        });
    }
}
