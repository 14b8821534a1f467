package lightning.editor.window.traced;

import javafx.scene.control.Label;
import lightning.editor.window.widget.DelayedMessage;

/** What a picture does not show, written on it; there only while there is something to say, and not for a moment. */
final class Badge extends Label {
    private final DelayedMessage message;

    Badge(String id, DelayedMessage.Scheduler scheduler) {
        setId(id);
        getStyleClass().add("badge");
        setWrapText(true);
        managedProperty().bind(visibleProperty());
        message = new DelayedMessage(scheduler, DelayedMessage.MIN_DURATION, text -> {
            setText(text);
            setVisible(!text.isEmpty());
        });
    }

    /** What there is to say now; empty for nothing. */
    void setMessage(String text) {
        message.set(text);
    }

    /** The same where the window's thread may have no time to say it later. */
    void setMessageImmediately(String text) {
        message.setImmediately(text);
    }
}
