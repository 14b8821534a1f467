package lightning.editor.window.widget;

import java.util.Optional;
import lightning.base.text.Measure;
import lightning.editor.document.Steps;

/** A number that a widget edits. */
public interface Gauge {
    /** For people, lower case: {@code intensity}. */
    String title();

    /** What a click adds, and the limits. */
    Steps steps();

    /** What the number is measured in. */
    Measure measure();

    /**
     * Sets the value; returns why it was refused, a clause, and changes nothing then.
     *
     * @param gesture any object that stands for one drag, which is one step to undo; null for a step of its own
     */
    Optional<String> set(double value, Object gesture);

    /** Sets a value, which the receiver may refuse. */
    interface Setter {
        Optional<String> set(double value, Object gesture);
    }

    /** A gauge of numbers without a unit. */
    static Gauge of(String title, Steps steps, Setter setter) {
        return of(title, steps, Measure.FACTOR, setter);
    }

    /** A gauge. */
    static Gauge of(String title, Steps steps, Measure measure, Setter setter) {
        return new Gauge() {
            @Override
            public String title() {
                return title;
            }

            @Override
            public Steps steps() {
                return steps;
            }

            @Override
            public Measure measure() {
                return measure;
            }

            @Override
            public Optional<String> set(double value, Object gesture) {
                return setter.set(value, gesture);
            }
        };
    }
}
