package lightning.scene.attribute;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.NumberUnit;
import lightning.base.text.RefusalException;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.LensShift;
import lightning.scene.value.SceneLimits;

/**
 * Value kind made of one or several numbers with a common range.
 *
 * @param form       meaning of the numbers together
 * @param labels     name of each number; empty for a single one
 * @param min        minimum of each
 * @param max        maximum of each
 * @param step       increment of a click in a widget
 * @param integer    true for whole numbers
 * @param unit       unit of each
 * @param components numbers of a value, as many as labels
 * @param compose    value of as many numbers
 * @param rangeCheck rejects a value with a number out of range, or with inconsistent numbers
 */
public record NumericKind<V>(Form form, List<String> labels, double min, double max, double step, boolean integer,
        NumberUnit unit,
        Function<V, List<Double>> components, Function<List<Double>, V> compose, RangeCheck<V> rangeCheck)
        implements ValueKind.LightKind<V>, ValueKind.MaterialKind<V> {

    private static final List<String> CHANNELS = List.of("red", "green", "blue");
    private static final List<String> AXES = List.of("x", "y", "z");

    /** Meaning of the numbers of a value together. */
    public enum Form {
        /** Linear color. */
        COLOR,
        /** Position. */
        POSITION,
        /** Direction of any length. */
        DIRECTION,
        /** Independent numbers. */
        INDEPENDENT
    }

    /** Range check of values. */
    @FunctionalInterface
    public interface RangeCheck<V> {
        void check(String name, V value);
    }

    /** Returns a kind for one number. */
    public static NumericKind<Double> number(double min, double max, double step) {
        return number(min, max, step, NumberUnit.FACTOR);
    }

    /** Returns a kind for one angle in degrees. */
    public static NumericKind<Double> degrees(double min, double max, double step) {
        return number(min, max, step, NumberUnit.DEGREES);
    }

    /** Returns a kind for one number of stops. */
    public static NumericKind<Double> stops(double min, double max, double step) {
        return number(min, max, step, NumberUnit.STOPS);
    }

    /** Returns a kind for one color temperature. */
    public static NumericKind<Double> kelvin(double min, double max, double step) {
        return number(min, max, step, NumberUnit.KELVIN);
    }

    private static NumericKind<Double> number(double min, double max, double step, NumberUnit unit) {
        return new NumericKind<>(Form.INDEPENDENT, List.of(""), min, max, step, false, unit, List::of, List::getFirst,
                (what, v) -> SceneLimits.checkRange(what, v, min, max));
    }

    /** Returns a kind for one whole number. */
    public static NumericKind<Integer> integer(int min, int max) {
        return new NumericKind<>(Form.INDEPENDENT, List.of(""), min, max, 1, true, NumberUnit.FACTOR, v -> List.of((double) v),
                n -> n.getFirst().intValue(),
                (what, v) -> SceneLimits.checkRange(what, v, min, max));
    }

    /** Returns this kind with another check of its values. */
    public NumericKind<V> withCheck(RangeCheck<V> newCheck) {
        return new NumericKind<>(form, labels, min, max, step, integer, unit, components, compose, newCheck);
    }

    /** Returns a kind for red, green and blue, from 0. */
    public static NumericKind<Rgb> color(double max) {
        return new NumericKind<>(Form.COLOR, CHANNELS, 0, max, 0.1, false, NumberUnit.FACTOR, c -> List.of(c.r(), c.g(), c.b()),
                n -> new Rgb(n.get(0), n.get(1), n.get(2)), (what, c) -> SceneLimits.checkRange(what, c, max));
    }

    public static NumericKind<Vec3> position() {
        return vector(Form.POSITION, SceneLimits::checkPosition);
    }

    public static NumericKind<Vec3> direction() {
        return vector(Form.DIRECTION, SceneLimits::checkDirection);
    }

    private static NumericKind<Vec3> vector(Form form, RangeCheck<Vec3> rangeCheck) {
        return vector(form, SceneLimits.MAX_COORDINATE, 0.1, NumberUnit.FACTOR, rangeCheck);
    }

    /** Returns a kind for x, y and z of either sign. */
    public static NumericKind<Vec3> axes(double max, double step, NumberUnit unit, RangeCheck<Vec3> rangeCheck) {
        return vector(Form.INDEPENDENT, max, step, unit, rangeCheck);
    }

    /** Returns a kind for lengths along x, y and z, from 0. */
    public static NumericKind<Vec3> lengths(double max) {
        return vector(Form.INDEPENDENT, 0, max, 0.1, NumberUnit.FACTOR, (what, v) -> SceneLimits.checkRange(what, v, 0, max));
    }

    private static NumericKind<Vec3> vector(Form form, double max, double step, NumberUnit unit, RangeCheck<Vec3> rangeCheck) {
        return vector(form, -max, max, step, unit, rangeCheck);
    }

    private static NumericKind<Vec3> vector(Form form, double min, double max, double step, NumberUnit unit, RangeCheck<Vec3> rangeCheck) {
        return new NumericKind<>(form, AXES, min, max, step, false, unit, v -> List.of(v.x(), v.y(), v.z()),
                n -> new Vec3(n.get(0), n.get(1), n.get(2)), rangeCheck);
    }

    /** Returns a kind for numbers along u and v of either sign. */
    public static NumericKind<List<Double>> pair(double max, double step, RangeCheck<List<Double>> rangeCheck) {
        return new NumericKind<>(Form.INDEPENDENT, List.of("u", "v"), -max, max, step, false, NumberUnit.FACTOR, v -> v, List::copyOf,
                rangeCheck);
    }

    public static NumericKind<Attenuation> attenuation() {
        return new NumericKind<>(Form.INDEPENDENT, List.of("constant", "linear", "quadratic"), 0, SceneLimits.MAX_ATTENUATION, 0.1, false,
                NumberUnit.FACTOR,
                a -> List.of(a.constant(), a.linear(), a.quadratic()), n -> new Attenuation(n.get(0), n.get(1), n.get(2)),
                (what, a) -> {});
    }

    public static NumericKind<LensShift> shift() {
        return new NumericKind<>(Form.INDEPENDENT, List.of("x", "y"), -SceneLimits.MAX_SHIFT, SceneLimits.MAX_SHIFT, 0.01, false,
                NumberUnit.FACTOR, s -> List.of(s.x(), s.y()), n -> new LensShift(n.get(0), n.get(1)), (what, s) -> {});
    }

    public static NumericKind<BarnDoors> doors() {
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
     * Checks that a number is in range and, if required, whole.
     *
     * @param name the number's name in the message
     * @throws RefusalException with the expected and the actual value
     */
    public void check(String name, double number) {
        if (integer && number != Math.rint(number)) {
            throw new RefusalException(name + " must be a whole number, was " + SceneLimits.format(number));
        }
        SceneLimits.checkRange(name, number, min, max);
    }

    /** Returns whether the numbers are x, y and z. */
    public boolean isVector() {
        return form == Form.POSITION || form == Form.DIRECTION;
    }

    /** Returns the number at an index of the labels. */
    public double number(V value, int index) {
        return components.apply(value).get(index);
    }

    /** Returns the value of as many numbers. */
    public V of(Double... numbers) {
        return compose.apply(List.of(numbers));
    }

    /** Returns the value with the number at an index of the labels replaced. */
    public V with(V value, int index, double number) {
        List<Double> numbers = new ArrayList<>(components.apply(value));
        numbers.set(index, number);
        return compose.apply(numbers);
    }

    /** Directions are equivalent if parallel, whatever their length. */
    @Override
    public boolean isEquivalent(V a, V b) {
        return a.equals(b) || switch (form) {
            case POSITION -> samePoint(vector(a), vector(b));
            case DIRECTION -> samePoint(vector(a).normalized(), vector(b).normalized());
            case COLOR, INDEPENDENT -> false;
        };
    }

    /** Returns the first three numbers of a value as x, y and z. */
    public Vec3 vector(V value) {
        List<Double> n = components.apply(value);
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }

    /** Returns the first three numbers of a value as red, green and blue. */
    public Rgb color(V value) {
        List<Double> n = components.apply(value);
        return new Rgb(n.get(0), n.get(1), n.get(2));
    }

    private static boolean samePoint(Vec3 a, Vec3 b) {
        return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
    }

    /** Formats each number with four digits, enough to recognize a value. */
    @Override
    public String format(V value) {
        return components.apply(value).stream().map(SceneLimits::formatShort).collect(Collectors.joining(" "));
    }
}
