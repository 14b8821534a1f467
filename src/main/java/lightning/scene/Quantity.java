package lightning.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Measure;

/**
 * A value made of one or several numbers, each with the same range.
 *
 * @param form   what the numbers are together
 * @param labels the name of each; empty where there is one and the attribute's own name says it
 * @param min    the least value of each
 * @param max    the largest value of each
 * @param step   what one click of a widget adds
 * @param whole  whether they are whole
 * @param measure what they are measured in
 * @param split  the numbers of a value, as many as labels
 * @param join   the value of as many numbers
 * @param range  refuses a value with a number out of range, or whose numbers do not go together
 */
public record Quantity<V>(Form form, List<String> labels, double min, double max, double step, boolean whole,
        Measure measure,
        Function<V, List<Double>> split, Function<List<Double>, V> join, Range<V> range)
        implements ValueKind.OfLight<V>, ValueKind.OfMaterial<V> {

    private static final List<String> CHANNELS = List.of("red", "green", "blue");
    private static final List<String> AXES = List.of("x", "y", "z");
    private static final MathContext SHORT = new MathContext(4);

    /** What the numbers of a value are together. */
    public enum Form {
        /** A linear colour. */
        COLOR,
        /** A place. */
        POSITION,
        /** A direction, whose length does not matter. */
        DIRECTION,
        /** Each is set for itself. */
        EACH
    }

    /** Refuses values. */
    @FunctionalInterface
    public interface Range<V> {
        void check(String what, V value);
    }

    /** One number. */
    static Quantity<Double> number(double min, double max, double step) {
        return number(min, max, step, Measure.FACTOR);
    }

    /** One number of degrees. */
    static Quantity<Double> degrees(double min, double max, double step) {
        return number(min, max, step, Measure.DEGREES);
    }

    private static Quantity<Double> number(double min, double max, double step, Measure measure) {
        return new Quantity<>(Form.EACH, List.of(""), min, max, step, false, measure, List::of, List::getFirst,
                (what, v) -> Limits.range(what, v, min, max));
    }

    /** One whole number. */
    static Quantity<Integer> whole(int min, int max) {
        return new Quantity<>(Form.EACH, List.of(""), min, max, 1, true, Measure.FACTOR, v -> List.of((double) v),
                n -> n.getFirst().intValue(),
                (what, v) -> Limits.range(what, v, min, max));
    }

    /** Red, green and blue, from 0. */
    static Quantity<Rgb> color(double max) {
        return new Quantity<>(Form.COLOR, CHANNELS, 0, max, 0.1, false, Measure.FACTOR, c -> List.of(c.r(), c.g(), c.b()),
                n -> new Rgb(n.get(0), n.get(1), n.get(2)), (what, c) -> Limits.range(what, c, max));
    }

    static Quantity<Vec3> position() {
        return vector(Form.POSITION, Limits::position);
    }

    static Quantity<Vec3> direction() {
        return vector(Form.DIRECTION, Limits::direction);
    }

    private static Quantity<Vec3> vector(Form form, Range<Vec3> range) {
        return vector(form, Limits.MAX_COORDINATE, 0.1, Measure.FACTOR, range);
    }

    /** A number for each axis, either sign. */
    static Quantity<Vec3> axes(double max, double step, Measure measure, Range<Vec3> range) {
        return vector(Form.EACH, max, step, measure, range);
    }

    private static Quantity<Vec3> vector(Form form, double max, double step, Measure measure, Range<Vec3> range) {
        return new Quantity<>(form, AXES, -max, max, step, false, measure, v -> List.of(v.x(), v.y(), v.z()),
                n -> new Vec3(n.get(0), n.get(1), n.get(2)), range);
    }

    static Quantity<Attenuation> attenuation() {
        return new Quantity<>(Form.EACH, List.of("constant", "linear", "quadratic"), 0, Limits.MAX_ATTENUATION, 0.1, false, Measure.FACTOR,
                a -> List.of(a.constant(), a.linear(), a.quadratic()), n -> new Attenuation(n.get(0), n.get(1), n.get(2)),
                (what, a) -> {});
    }

    static Quantity<BarnDoors> doors() {
        return new Quantity<>(Form.EACH, List.of("left", "right", "bottom", "top"), -BarnDoors.AWAY, BarnDoors.AWAY, 1, false,
                Measure.DEGREES,
                d -> List.of(d.left(), d.right(), d.bottom(), d.top()), n -> new BarnDoors(n.get(0), n.get(1), n.get(2), n.get(3)),
                (what, d) -> {});
    }

    @Override
    public void check(String what, V value) {
        range.check(what, value);
    }

    /**
     * Refuses a number that is out of range, or not whole where it must be.
     *
     * @param what the number's name in the message
     * @throws IllegalArgumentException that says what was expected and found
     */
    public void check(String what, double number) {
        if (whole && number != Math.rint(number)) {
            throw new IllegalArgumentException(what + " must be a whole number, was " + Limits.text(number));
        }
        Limits.range(what, number, min, max);
    }

    /** Whether the numbers are x, y and z. */
    public boolean isVector() {
        return form == Form.POSITION || form == Form.DIRECTION;
    }

    /** The number at a place among the labels. */
    public double number(V value, int index) {
        return split.apply(value).get(index);
    }

    /** The value with another number at a place among the labels. */
    public V with(V value, int index, double number) {
        List<Double> numbers = new ArrayList<>(split.apply(value));
        numbers.set(index, number);
        return join.apply(numbers);
    }

    /** Directions are alike whatever their length. */
    @Override
    public boolean alike(V a, V b) {
        return a.equals(b) || switch (form) {
            case POSITION -> samePoint(vector(a), vector(b));
            case DIRECTION -> samePoint(vector(a).normalized(), vector(b).normalized());
            case COLOR, EACH -> false;
        };
    }

    /** The first three numbers of a value as x, y and z. */
    public Vec3 vector(V value) {
        List<Double> n = split.apply(value);
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }

    /** The first three numbers of a value as red, green and blue. */
    public Rgb color(V value) {
        List<Double> n = split.apply(value);
        return new Rgb(n.get(0), n.get(1), n.get(2));
    }

    private static boolean samePoint(Vec3 a, Vec3 b) {
        return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
    }

    /** Four digits of each, enough to recognise a value. */
    @Override
    public String text(V value) {
        return split.apply(value).stream().map(Quantity::digits).collect(Collectors.joining(" "));
    }

    static String digits(double v) {
        return Limits.text(new BigDecimal(v).round(SHORT).doubleValue());
    }
}
