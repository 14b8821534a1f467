package lightning.editor.window.traced;

import javafx.scene.control.Label;
import lightning.editor.window.widget.DelayedMessage;

/** Badge over the picture that says what the picture does not show. Appears only for a message that applies longer than a moment. */
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

    /** Sets the message; an empty text hides the badge after a delay. */
    void setMessage(String text) {
        message.set(text);
    }

    /** Sets the message without a delay, for when the window's thread may be too busy to show it later. */
    void setMessageImmediately(String text) {
        message.setImmediately(text);
    }
}
