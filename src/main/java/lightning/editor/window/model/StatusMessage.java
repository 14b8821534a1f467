package lightning.editor.window.model;

import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;

/** Message in the status line, for example a refused edit or a saved file; empty for none. */
public final class StatusMessage {
    private final ReadOnlyStringWrapper text = new ReadOnlyStringWrapper("");

    public ReadOnlyStringProperty textProperty() {
        return text.getReadOnlyProperty();
    }

    /** Shows a message until the next edit. */
    public void show(String sentence) {
        text.set(sentence);
    }

    public void clear() {
        text.set("");
    }
}
