package lightning.editor.window.traced;

import javafx.animation.PauseTransition;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.util.Duration;

/** Copy of the status message over the picture, where the user looks. Disappears after a few seconds; the status line keeps the message. */
final class PictureMessage extends Label {
    private static final Duration SHOWN = Duration.seconds(4);
    private final PauseTransition hide = new PauseTransition(SHOWN);

    PictureMessage(ObservableValue<String> message) {
        setId("picture-message");
        getStyleClass().add("picture-message");
        setMouseTransparent(true);
        managedProperty().bind(visibleProperty());
        hide.setOnFinished(_ -> setVisible(false));
        message.subscribe(text -> {
            setText(text);
            setVisible(!text.isEmpty());
            if (text.isEmpty()) {
                hide.stop();
            } else {
                hide.playFromStart();
            }
        });
    }
}
