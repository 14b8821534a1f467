package lightning.editor.window.traced;

import javafx.scene.control.Label;
import lightning.editor.window.widget.Lasting;

/** What a picture does not show, written on it; there only while there is something to say, and not for a moment. */
final class Badge extends Label {
    private final Lasting remark;

    Badge(String id, Lasting.Later later) {
        setId(id);
        getStyleClass().add("badge");
        setWrapText(true);
        managedProperty().bind(visibleProperty());
        remark = new Lasting(later, Lasting.NOTICED, text -> {
            setText(text);
            setVisible(!text.isEmpty());
        });
    }

    /** What there is to say now; empty for nothing. */
    void tell(String text) {
        remark.tell(text);
    }

    /** The same where the window's thread may have no time to say it later. */
    void tellAtOnce(String text) {
        remark.tellAtOnce(text);
    }
}
