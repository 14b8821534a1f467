package lightning.base.text;

import java.math.BigDecimal;
import java.util.List;

/** What a number that people type is measured in, and the words that they may write behind it. */
public enum NumberUnit {
    /** Of no unit: {@code 2 stops} makes it four times as large, {@code -1 stop} half. */
    FACTOR("", "stop", "stops"),
    /** In degrees: {@code 0.25 turn}, {@code 1 rad}. */
    DEGREES("°", "deg", "°", "degree", "degrees", "rad", "turn", "turns"),
    /** Of photography: each is twice the light. */
    STOPS("stops", "stop", "stops"),
    KELVIN("K", "k", "kelvin");

    private final String symbol;
    private final List<String> names;

    NumberUnit(String sign, String... words) {
        this.symbol = sign;
        this.names = List.of(words);
    }

    /** What stands behind a label; empty where there is no unit. */
    public String sign() {
        return symbol;
    }

    /** In lower case, the commonest first. */
    List<String> words() {
        return names;
    }

    /**
     * The value that a number with a unit stands for.
     *
     * @param name    one of the words
     * @param current the value that stands there now
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
