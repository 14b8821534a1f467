package lightning.editor.window.model;

import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;

/** The message in the status line: why an edit was refused, what was saved; empty where there is nothing to read. */
public final class StatusMessage {
    private final ReadOnlyStringWrapper text = new ReadOnlyStringWrapper("");

    public ReadOnlyStringProperty textProperty() {
        return text.getReadOnlyProperty();
    }

    /** Shows a sentence until the next edit. */
    public void show(String sentence) {
        text.set(sentence);
    }

    public void clear() {
        text.set("");
    }
}
