package lightning.format.json;

import java.util.ArrayList;
import java.util.List;
import lightning.render.match.LightFactor;
import lightning.render.match.MatchResult;
import lightning.render.match.ReferenceImage;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import org.jspecify.annotations.Nullable;

/**
 * Lights that were matched to a reference.
 *
 * @param output         the written scene; absent if none was
 * @param errorBefore    root mean square of the difference relative to the reference, with {@code errorAfter}
 * @param referenceScale factors by which red, green and blue of the reference were scaled
 * @param moved          other attributes that changed
 * @param alike          pairs of lights of which only the sum is known
 * @param unseen         lights that contribute nothing to the picture
 * @param invalidPixels  pixels of the reference that are infinite or not a number, and did not count
 */
public record MatchReport(@Nullable String output, double errorBefore, double errorAfter, List<Double> referenceScale, List<Matched> lights,
        List<Moved> moved, List<List<String>> alike, List<String> unseen, int invalidPixels) {
    /**
     * One light, or an environment.
     *
     * @param factors of red, green and blue
     */
    public record Matched(String light, List<Double> factors, double intensityBefore, double intensityAfter) {}

    /**
     * Change of another attribute of a light or the environment, as in scene files.
     *
     * @param attribute its keyword
     */
    public record Moved(String light, String attribute, String before, String after) {}

    /**
     * Returns the report of a match.
     *
     * @param before scene that was matched
     * @param after  scene with the matched lights
     */
    public static MatchReport of(@Nullable String output, MatchResult result, ReferenceImage reference, Scene before, Scene after) {
        List<Matched> matched = new ArrayList<>();
        for (LightFactor f : result.factors()) {
            matched.add(new Matched(f.light().name(before), List.of(f.red(), f.green(), f.blue()), f.light().values(before).intensity(),
                    f.light().values(after).intensity()));
        }
        return new MatchReport(output, result.errorBefore(), result.errorAfter(), result.exposure(), matched, moved(before, after),
                result.alike().stream().map(pair -> List.of(pair.first().name(before), pair.second().name(before))).toList(),
                result.unseen().stream().map(light -> light.name(before)).toList(), reference.invalidPixels());
    }

    private static List<Moved> moved(Scene before, Scene after) {
        List<Moved> moved = new ArrayList<>();
        for (Light old : before.lights()) {
            Light light = after.light(old.name()).orElseThrow();
            LightAttribute.ALL.stream().filter(a -> a != LightAttribute.INTENSITY && a != LightAttribute.COLOR).forEach(
                    attribute -> addChange(attribute, old.name(), old, light, moved));
        }
        addChange(World.ROTATION, Contribution.ENVIRONMENT.name(before), before.world(), after.world(), moved);
        return moved;
    }

    private static <T> void addChange(SceneAttribute<T, ?> attribute, String light, T before, T after, List<Moved> to) {
        if (!attribute.format(before).equals(attribute.format(after))) {
            to.add(new Moved(light, attribute.name(), attribute.format(before), attribute.format(after)));
        }
    }
}
