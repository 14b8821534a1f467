package lightning.editor.window;

import javafx.event.EventHandler;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.util.Subscription;
import lightning.editor.Command;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.welcome.LessonBar;
import lightning.editor.window.welcome.WelcomePane;
import org.jspecify.annotations.Nullable;

/** Shows and closes the welcome page and the bar of its lessons. Opening a document or Escape closes the page. */
final class WelcomePage {
    private final EditorLayout layout;
    private final EditorModel model;
    private final FileActions files;
    private final LessonBar lessons;
    private final Runnable onClosed;
    private final EventHandler<KeyEvent> escape = this::closeOnEscape;
    private final LateEscape lateEscape;
    /** Null while the page is closed. */
    private @Nullable WelcomePane pane;
    private Subscription documents = Subscription.EMPTY;

    /** @param onClosed moves the keyboard focus back to the editor */
    WelcomePage(EditorLayout layout, EditorModel model, FileActions files, LessonBar lessons, Runnable onClosed) {
        this.layout = layout;
        this.model = model;
        this.files = files;
        this.lessons = lessons;
        this.onClosed = onClosed;
        lateEscape = new LateEscape(layout);
        model.commands().setAction(Command.WELCOME, this::show);
    }

    /** Shows the page with the keyboard focus on its first button. */
    void show() {
        if (pane == null) {
            pane = new WelcomePane(files, model.commands(), lessons, model.layout().welcomeAtStartProperty(), this::hide);
            lateEscape.end();
            layout.showPage(pane);
            layout.addEventHandler(KeyEvent.KEY_PRESSED, escape);
            documents = model.editor().documentProperty().subscribe((_, _) -> hide());
        }
        pane.focus();
    }

    private void hide() {
        if (pane != null) {
            layout.hidePage(pane);
            layout.removeEventHandler(KeyEvent.KEY_PRESSED, escape);
            documents.unsubscribe();
            pane = null;
            lateEscape.ignore();
            onClosed.run();
        }
    }

    private void closeOnEscape(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE) {
            hide();
            event.consume();
        }
    }
}
