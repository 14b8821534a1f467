package lightning.editor.window;

import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.input.InputEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;

/**
 * Ignores an Escape that was meant for a page that has just closed by itself or by the press before: it would cancel the trace of the opened
 * scene. Ends with the first other key or mouse button.
 */
final class LateEscape {
    private final Node content;
    private final EventHandler<InputEvent> filter = this::handle;
    private boolean hasIgnored;

    /** @param content part of the window that gets all of its input */
    LateEscape(Node content) {
        this.content = content;
    }

    /** Ignores the next Escape, with the repeats of a held key. */
    void ignore() {
        hasIgnored = false;
        content.getScene().addEventFilter(InputEvent.ANY, filter);
    }

    private void handle(InputEvent event) {
        boolean isEscape = event instanceof KeyEvent key && key.getCode() == KeyCode.ESCAPE;
        if (isEscape && event.getEventType() == KeyEvent.KEY_PRESSED) {
            hasIgnored = true;
            event.consume();
        } else if (isEscape && event.getEventType() == KeyEvent.KEY_RELEASED && hasIgnored
                || event.getEventType() == KeyEvent.KEY_PRESSED || event.getEventType() == MouseEvent.MOUSE_PRESSED) {
            end();
        }
    }

    /** Ends to ignore Escape. */
    void end() {
        content.getScene().removeEventFilter(InputEvent.ANY, filter);
    }
}
