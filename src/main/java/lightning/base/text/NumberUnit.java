package lightning.base.text;

import java.math.BigDecimal;
import java.util.List;

/** Unit of a number field, with the unit names that a user may type after the number. */
public enum NumberUnit {
    /** No unit: {@code 2 stops} multiplies the value by four, {@code -1 stop} halves it. */
    FACTOR("", "stop", "stops"),
    /** Degrees: {@code 0.25 turn}, {@code 1 rad}. */
    DEGREES("°", "deg", "°", "degree", "degrees", "rad", "turn", "turns"),
    /** Photographic stops: each doubles the light. */
    STOPS("stops", "stop", "stops"),
    KELVIN("K", "k", "kelvin");

    private final String symbol;
    private final List<String> names;

    NumberUnit(String sign, String... words) {
        this.symbol = sign;
        this.names = List.of(words);
    }

    /** Returns the symbol shown after a label; empty if there is no unit. */
    public String sign() {
        return symbol;
    }

    /** Returns the unit names in lower case, the most common first. */
    List<String> words() {
        return names;
    }

    /**
     * Converts a number with a unit name.
     *
     * @param name    one of the unit names
     * @param current the field's current value
     */
    double convert(String name, Fraction number, double current) {
        return switch (this) {
            case FACTOR -> current * Math.pow(2, number.toDouble());
            case DEGREES -> switch (name) {
                case "rad" -> Math.toDegrees(number.toDouble());
                case "turn", "turns" -> number.times(Fraction.of(BigDecimal.valueOf(360))).toDouble();
                default -> number.toDouble();
            };
            case STOPS, KELVIN -> number.toDouble();
        };
    }
}
