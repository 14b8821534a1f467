package lightning.editor.window.widget;

import java.util.Optional;
import lightning.base.text.NumberUnit;
import lightning.editor.document.StepRange;

/** A number that a widget edits. */
public interface NumberSetting {
    /** For people, lower case: {@code intensity}. */
    String title();

    /** What a click adds, and the limits. */
    StepRange steps();

    /** What the number is measured in. */
    NumberUnit measure();

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

    /** A setting of numbers without a unit. */
    static NumberSetting of(String title, StepRange steps, Setter setter) {
        return of(title, steps, NumberUnit.FACTOR, setter);
    }

    /** A setting. */
    static NumberSetting of(String title, StepRange steps, NumberUnit measure, Setter setter) {
        return new NumberSetting() {
            @Override
            public String title() {
                return title;
            }

            @Override
            public StepRange steps() {
                return steps;
            }

            @Override
            public NumberUnit measure() {
                return measure;
            }

            @Override
            public Optional<String> set(double value, Object gesture) {
                return setter.set(value, gesture);
            }
        };
    }
}
