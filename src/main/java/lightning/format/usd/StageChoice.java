package lightning.format.usd;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Choice of what is read of a stage.
 *
 * @param camera   name or path of the scene's camera; empty for that of the render settings, or the first
 * @param frame    time code of a single frame; empty for all frames, as an animation
 * @param variants choices of variants, such as {@code look=red} or {@code /World/car:look=red}
 */
public record StageChoice(String camera, OptionalDouble frame, List<String> variants) {
    /** The stage as it is. */
    public static final StageChoice DEFAULT = new StageChoice("", OptionalDouble.empty(), List.of());

    public StageChoice {
        variants = List.copyOf(variants);
    }

    /** Returns the options of the converter. */
    List<String> arguments() {
        List<String> result = new ArrayList<>();
        if (!camera.isEmpty()) {
            result.add("--camera=" + camera);
        }
        frame.ifPresent(time -> result.add("--frame=" + time));
        variants.forEach(variant -> result.add("--variant=" + variant));
        return result;
    }
}
