package lightning.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.NumberUnit;

/**
 * A value made of one or several numbers, each with the same range.
 *
 * @param form   what the numbers are together
 * @param labels the name of each; empty where there is one and the attribute's own name says it
 * @param min    the least value of each
 * @param max    the largest value of each
 * @param step   what one click of a widget adds
 * @param integer  whether they are whole
 * @param unit what they are measured in
 * @param components  the numbers of a value, as many as labels
 * @param compose   the value of as many numbers
 * @param rangeCheck  refuses a value with a number out of range, or whose numbers do not go together
 */
public record NumericKind<V>(Form form, List<String> labels, double min, double max, double step, boolean integer,
        NumberUnit unit,
        Function<V, List<Double>> components, Function<List<Double>, V> compose, RangeCheck<V> rangeCheck)
        implements ValueKind.LightKind<V>, ValueKind.MaterialKind<V> {

    private static final List<String> CHANNELS = List.of("red", "green", "blue");
    private static final List<String> AXES = List.of("x", "y", "z");
    private static final MathContext DISPLAY_PRECISION = new MathContext(4);

    /** What the numbers of a value are together. */
    public enum Form {
        /** A linear color. */
        COLOR,
        /** A place. */
        POSITION,
        /** A direction, whose length does not matter. */
        DIRECTION,
        /** Each is set for itself. */
        INDEPENDENT
    }

    /** Refuses values. */
    @FunctionalInterface
    public interface RangeCheck<V> {
        void check(String name, V value);
    }

    /** One number. */
    static NumericKind<Double> number(double min, double max, double step) {
        return number(min, max, step, NumberUnit.FACTOR);
    }

    /** One number of degrees. */
    static NumericKind<Double> degrees(double min, double max, double step) {
        return number(min, max, step, NumberUnit.DEGREES);
    }

    private static NumericKind<Double> number(double min, double max, double step, NumberUnit unit) {
        return new NumericKind<>(Form.INDEPENDENT, List.of(""), min, max, step, false, unit, List::of, List::getFirst,
                (what, v) -> SceneLimits.checkRange(what, v, min, max));
    }

    /** One whole number. */
    static NumericKind<Integer> integer(int min, int max) {
        return new NumericKind<>(Form.INDEPENDENT, List.of(""), min, max, 1, true, NumberUnit.FACTOR, v -> List.of((double) v),
                n -> n.getFirst().intValue(),
                (what, v) -> SceneLimits.checkRange(what, v, min, max));
    }

    /** Red, green and blue, from 0. */
    static NumericKind<Rgb> color(double max) {
        return new NumericKind<>(Form.COLOR, CHANNELS, 0, max, 0.1, false, NumberUnit.FACTOR, c -> List.of(c.r(), c.g(), c.b()),
                n -> new Rgb(n.get(0), n.get(1), n.get(2)), (what, c) -> SceneLimits.checkRange(what, c, max));
    }

    static NumericKind<Vec3> position() {
        return vector(Form.POSITION, SceneLimits::checkPosition);
    }

    static NumericKind<Vec3> direction() {
        return vector(Form.DIRECTION, SceneLimits::checkDirection);
    }

    private static NumericKind<Vec3> vector(Form form, RangeCheck<Vec3> rangeCheck) {
        return vector(form, SceneLimits.MAX_COORDINATE, 0.1, NumberUnit.FACTOR, rangeCheck);
    }

    /** A number for each axis, either sign. */
    static NumericKind<Vec3> axes(double max, double step, NumberUnit unit, RangeCheck<Vec3> rangeCheck) {
        return vector(Form.INDEPENDENT, max, step, unit, rangeCheck);
    }

    private static NumericKind<Vec3> vector(Form form, double max, double step, NumberUnit unit, RangeCheck<Vec3> rangeCheck) {
        return new NumericKind<>(form, AXES, -max, max, step, false, unit, v -> List.of(v.x(), v.y(), v.z()),
                n -> new Vec3(n.get(0), n.get(1), n.get(2)), rangeCheck);
    }

    static NumericKind<Attenuation> attenuation() {
        return new NumericKind<>(Form.INDEPENDENT, List.of("constant", "linear", "quadratic"), 0, SceneLimits.MAX_ATTENUATION, 0.1, false,
                NumberUnit.FACTOR,
                a -> List.of(a.constant(), a.linear(), a.quadratic()), n -> new Attenuation(n.get(0), n.get(1), n.get(2)),
                (what, a) -> {});
    }

    static NumericKind<BarnDoors> doors() {
        return new NumericKind<>(Form.INDEPENDENT, List.of("left", "right", "bottom", "top"), -BarnDoors.OPEN_ANGLE, BarnDoors.OPEN_ANGLE,
                1, false,
                NumberUnit.DEGREES,
                d -> List.of(d.left(), d.right(), d.bottom(), d.top()), n -> new BarnDoors(n.get(0), n.get(1), n.get(2), n.get(3)),
                (what, d) -> {});
    }

    @Override
    public void check(String name, V value) {
        rangeCheck.check(name, value);
    }

    /**
     * Refuses a number that is out of range, or not whole where it must be.
     *
     * @param name the number's name in the message
     * @throws IllegalArgumentException that says what was expected and found
     */
    public void check(String name, double number) {
        if (integer && number != Math.rint(number)) {
            throw new IllegalArgumentException(name + " must be a whole number, was " + SceneLimits.format(number));
        }
        SceneLimits.checkRange(name, number, min, max);
    }

    /** Whether the numbers are x, y and z. */
    public boolean isVector() {
        return form == Form.POSITION || form == Form.DIRECTION;
    }

    /** The number at a place among the labels. */
    public double number(V value, int index) {
        return components.apply(value).get(index);
    }

    /** The value with another number at a place among the labels. */
    public V with(V value, int index, double number) {
        List<Double> numbers = new ArrayList<>(components.apply(value));
        numbers.set(index, number);
        return compose.apply(numbers);
    }

    /** Directions are alike whatever their length. */
    @Override
    public boolean isEquivalent(V a, V b) {
        return a.equals(b) || switch (form) {
            case POSITION -> samePoint(vector(a), vector(b));
            case DIRECTION -> samePoint(vector(a).normalized(), vector(b).normalized());
            case COLOR, INDEPENDENT -> false;
        };
    }

    /** The first three numbers of a value as x, y and z. */
    public Vec3 vector(V value) {
        List<Double> n = components.apply(value);
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }

    /** The first three numbers of a value as red, green and blue. */
    public Rgb color(V value) {
        List<Double> n = components.apply(value);
        return new Rgb(n.get(0), n.get(1), n.get(2));
    }

    private static boolean samePoint(Vec3 a, Vec3 b) {
        return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
    }

    /** Four digits of each, enough to recognize a value. */
    @Override
    public String format(V value) {
        return components.apply(value).stream().map(NumericKind::formatShort).collect(Collectors.joining(" "));
    }

    static String formatShort(double v) {
        return SceneLimits.format(new BigDecimal(v).round(DISPLAY_PRECISION).doubleValue());
    }
}
