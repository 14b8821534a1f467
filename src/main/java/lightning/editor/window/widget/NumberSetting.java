package lightning.editor.window.widget;

import java.util.Optional;
import lightning.base.text.NumberUnit;
import lightning.document.StepRange;
import org.jspecify.annotations.Nullable;

/** Number edited by a widget. */
public interface NumberSetting {
    /** Returns the display title in lower case, for example {@code intensity}. */
    String title();

    /** Returns the step size and the limits. */
    StepRange steps();

    /** Returns the unit. */
    NumberUnit measure();

    /**
     * Sets the value. Returns why it was refused, as a clause, in which case nothing changes.
     *
     * @param gesture  object that identifies one drag, which is one undo step; null for a separate step
     */
    Optional<String> set(double value, @Nullable Object gesture);

    /** Receiver of values; returns why a value was refused. */
    interface Setter {
        Optional<String> set(double value, @Nullable Object gesture);
    }

    /** Creates a setting without a unit. */
    static NumberSetting of(String title, StepRange steps, Setter setter) {
        return of(title, steps, NumberUnit.FACTOR, setter);
    }

    /** Creates a setting with a unit. */
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
            public Optional<String> set(double value, @Nullable Object gesture) {
                return setter.set(value, gesture);
            }
        };
    }
}
