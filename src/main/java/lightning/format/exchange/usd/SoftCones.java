package lightning.format.exchange.usd;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lightning.base.text.DecimalNumber;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.asset.IesProfile;
import lightning.scene.light.Light;
import lightning.scene.value.Photometry;

/**
 * Soft edges of the cones of UsdLux, as light profiles: full light up to {@code (1 − softness) · angle} from the axis, then 1 − t²(3 − 2t)
 * to the angle.
 */
public final class SoftCones {
    private static final int STEPS = 64;
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
            var curve = new Curve(angle, softness);
            profiles.put(name, new IesProfile(assembler.addFile(name, curve.file()), curve.photometry()));
        }
        return Optional.of(profiles.get(name));
    }

    /** Returns the softness of a light whose profile was made here for its angle; empty for any other. */
    public static OptionalDouble softness(Light light) {
        Matcher name = NAME.matcher(light.profile().map(IesProfile::file).orElse(""));
        if (!name.matches() || light.angle() <= 0) {
            return OptionalDouble.empty();
        }
        try {
            double softness = Double.parseDouble(name.group(1));
            boolean isSame = softness > 0 && softness <= 1
                    && new Curve(light.angle(), softness).photometry().equals(light.profile().orElseThrow().photometry());
            return isSame ? OptionalDouble.of(softness) : OptionalDouble.empty();
        } catch (IllegalArgumentException e) {
            return OptionalDouble.empty();
        }
    }

    /** Values at angles from the axis, in degrees. */
    private static final class Curve {
        private final List<Double> angles = new ArrayList<>(List.of(0.0));
        private final List<Double> values = new ArrayList<>(List.of(1.0));

        Curve(double angle, double softness) {
            double start = angle * (1 - softness);
            for (int i = 0; i <= STEPS; i++) {
                double t = (double) i / STEPS;
                add(UsdNumbers.rounded(start + t * (angle - start)), UsdNumbers.rounded(1 - t * t * (3 - 2 * t)));
            }
            add(angle < 90 ? 90 : 180, 0);
        }

        private void add(double angle, double value) {
            if (angle > angles.getLast()) {
                angles.add(angle);
                values.add(value);
            }
        }

        Photometry photometry() {
            return new Photometry(Photometry.Type.C, angles.stream().mapToDouble(v -> v).toArray(), new double[] {0},
                    values.stream().mapToDouble(v -> v).toArray());
        }

        byte[] file() {
            return ("IESNA:LM-63-2002\n[OTHER] soft cone of UsdLux\nTILT=NONE\n1 1000 1 " + angles.size() + " 1 1 2 0 0 0\n1 1 10\n"
                    + text(angles) + "\n0\n" + text(values) + "\n").getBytes(StandardCharsets.US_ASCII);
        }

        private static String text(List<Double> numbers) {
            return numbers.stream().map(DecimalNumber::format).collect(Collectors.joining(" "));
        }
    }
}
