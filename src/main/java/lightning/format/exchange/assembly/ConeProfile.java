package lightning.format.exchange.assembly;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import java.util.function.DoublePredicate;
import java.util.function.DoubleUnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lightning.base.text.DecimalNumber;
import lightning.scene.asset.IesProfile;
import lightning.scene.light.Light;
import lightning.scene.value.Photometry;

/** Light profile around an axis, for soft edges of cones that a scene's own law does not have. */
public final class ConeProfile {
    private static final int STEPS = 64;

    private final String comment;
    /** Degrees from the axis. */
    private final List<Double> angles = new ArrayList<>(List.of(0.0));
    private final List<Double> values = new ArrayList<>(List.of(1.0));

    /**
     * Creates a profile of 1 up to an angle, 0 from another one on, and an edge in between.
     *
     * @param comment what it is for, in its file
     * @param start   degrees from the axis, 0 to {@code end}
     * @param end     degrees from the axis, below 180
     * @param edge    value, 0 … 1, of the edge at t from 0 to 1 between both
     */
    public ConeProfile(String comment, double start, double end, DoubleUnaryOperator edge) {
        this.comment = comment;
        for (int i = 0; i <= STEPS; i++) {
            double t = (double) i / STEPS;
            add(rounded(start + t * (end - start)), rounded(edge.applyAsDouble(t)));
        }
        add(end < 90 ? 90 : 180, 0);
    }

    private void add(double angle, double value) {
        if (angle > angles.getLast()) {
            angles.add(angle);
            values.add(value);
        }
    }

    /** Rounds to nine decimals, but not to 0. */
    private static double rounded(double v) {
        double nearest = Math.rint(v * 1e9) / 1e9;
        return v >= 1e-3 || nearest == 0 ? nearest + 0.0 : v;
    }

    /**
     * Returns the parameter, in the name of its file, of a light's profile that was made here for the light's angle; empty for any other
     * light.
     *
     * @param name    of such files; its first group is the parameter
     * @param isValid whether a curve has the parameter
     * @param curve   profile for a parameter
     */
    public static OptionalDouble parameter(Light light, Pattern name, DoublePredicate isValid, DoubleFunction<ConeProfile> curve) {
        Matcher matcher = name.matcher(light.profile().map(IesProfile::file).orElse(""));
        if (!matcher.matches() || light.angle() <= 0) {
            return OptionalDouble.empty();
        }
        try {
            double parameter = Double.parseDouble(matcher.group(1));
            boolean isSame = isValid.test(parameter)
                    && curve.apply(parameter).photometry().equals(light.profile().orElseThrow().photometry());
            return isSame ? OptionalDouble.of(parameter) : OptionalDouble.empty();
        } catch (IllegalArgumentException e) {
            return OptionalDouble.empty();
        }
    }

    public Photometry photometry() {
        return new Photometry(Photometry.Type.C, angles.stream().mapToDouble(v -> v).toArray(), new double[] {0},
                values.stream().mapToDouble(v -> v).toArray());
    }

    /** Returns it as an IES file. */
    public byte[] file() {
        return ("IESNA:LM-63-2002\n[OTHER] " + comment + "\nTILT=NONE\n1 1000 1 " + angles.size() + " 1 1 2 0 0 0\n1 1 10\n"
                + text(angles) + "\n0\n" + text(values) + "\n").getBytes(StandardCharsets.US_ASCII);
    }

    private static String text(List<Double> numbers) {
        return numbers.stream().map(DecimalNumber::format).collect(Collectors.joining(" "));
    }
}
