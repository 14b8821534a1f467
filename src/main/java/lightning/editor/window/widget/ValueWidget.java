package lightning.editor.window.widget;

import java.util.Optional;

/** Control that shows a value of an attribute and edits it. */
public interface ValueWidget<V> {
    void show(V value);

    /** Clears the control. */
    void showNothing();

    /** Discards uncommitted input. */
    default void revert() {
        // Most controls commit each input.
    }

    /** Disables the control with a reason, as a clause, or enables it. */
    void setDisabledReason(Optional<String> reason);
}
