package lightning.format.exchange.usd;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import lightning.base.text.DecimalNumber;
import lightning.format.exchange.assembly.ConeProfile;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.asset.IesProfile;
import lightning.scene.light.Light;

/**
 * Soft edges of the cones of UsdLux, as light profiles: full light up to {@code (1 − softness) · angle} from the axis, then 1 − t²(3 − 2t)
 * to the angle.
 */
public final class SoftCones {
    private static final Pattern NAME = Pattern.compile("cone [0-9.]+ soft ([0-9.]+)\\.ies");

    private final SceneAssembler assembler;
    private final Map<String, IesProfile> profiles = new HashMap<>();

    SoftCones(SceneAssembler assembler) {
        this.assembler = assembler;
    }

    /** Returns a profile, shared by equal cones; empty if the scene would have too many. */
    Optional<IesProfile> profile(double angle, double softness) {
        String name = "cone " + DecimalNumber.format(angle) + " soft " + DecimalNumber.format(softness) + ".ies";
        if (!profiles.containsKey(name)) {
            // Half of the limit is left to the stage's own profiles.
            if (profiles.size() >= JenLimits.PROFILES / 2) {
                return Optional.empty();
            }
            ConeProfile curve = curve(angle, softness);
            profiles.put(name, new IesProfile(assembler.addFile(name, curve.file()), curve.photometry()));
        }
        return Optional.of(profiles.get(name));
    }

    /** Returns the softness of a light whose profile was made here for its angle; empty for any other. */
    public static OptionalDouble softness(Light light) {
        return ConeProfile.parameter(light, NAME, softness -> softness > 0 && softness <= 1, softness -> curve(light.angle(), softness));
    }

    private static ConeProfile curve(double angle, double softness) {
        return new ConeProfile("soft cone of UsdLux", angle * (1 - softness), angle, t -> 1 - t * t * (3 - 2 * t));
    }
}
