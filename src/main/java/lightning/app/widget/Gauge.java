package lightning.app.widget;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.edit.Steps;
import lightning.text.Decimal;
import lightning.text.Quote;

/** A number that a widget edits. Both edits return why they were refused, a clause, and change nothing then. */
public interface Gauge {
    /** What a click adds, and the limits. */
    Steps steps();

    /**
     * Sets the value.
     *
     * @param gesture any object that stands for one drag, which is one step to undo; null for a step of its own
     */
    Optional<String> set(double value, Object gesture);

    /** Sets the value that a person typed. */
    Optional<String> typed(String text);

    /** Sets a value, which the receiver may refuse. */
    interface Setter {
        Optional<String> set(double value, Object gesture);
    }

    /** A gauge that reads plain numbers. */
    static Gauge of(String title, Steps steps, Setter setter) {
        return new Gauge() {
            @Override
            public Steps steps() {
                return steps;
            }

            @Override
            public Optional<String> set(double value, Object gesture) {
                return setter.set(value, gesture);
            }

            @Override
            public Optional<String> typed(String text) {
                OptionalDouble number = Decimal.read(text.strip());
                return number.isPresent() ? set(number.getAsDouble(), null)
                        : Optional.of(title + " must be a number, was " + Quote.of(text.strip()));
            }
        };
    }
}
