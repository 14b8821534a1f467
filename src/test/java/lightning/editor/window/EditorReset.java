package lightning.editor.window;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javafx.event.Event;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.document.OpenDocument;
import lightning.editor.Command;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PanelArrangement;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.model.WorkingSize;
import lightning.editor.window.widget.ColorTheme;
import lightning.render.relight.SceneView;
import lightning.scene.effects.ViewEffects;

/**
 * Returns an open editor to the state in which it opened: opens a document, closes all other windows and restores all settings. Call its
 * methods on the window's thread.
 *
 * @param x initial position of the window's left edge, pixels of the screen
 * @param y initial position of its upper edge, pixels
 * @param width initial width of the window, pixels
 * @param height initial height of the window, pixels
 */
record EditorReset(Stage stage, Editor editor, double x, double y, double width, double height) {
    /** Folder that does not exist, so all settings have their defaults. */
    private static final Path NO_PREFERENCES = Path.of("target/no-preferences");

    private static final int ESCAPES = 3;

    static EditorReset of(Stage stage, Editor editor) {
        return new EditorReset(stage, editor, stage.getX(), stage.getY(), stage.getWidth(), stage.getHeight());
    }

    void restore(OpenDocument document) {
        hideOtherWindows();
        cancelTools();
        restoreWindow();
        restoreSettings();
        editor.model().open(document);
        editor.model().picture().viewProperty().set(SceneView.of(document.scene()));
        editor.model().editor().materialShownProperty().set(false);
        editor.model().materials().choose("");
        editor.model().editor().message().clear();
        scrollPanes().forEach(pane -> {
            pane.setHvalue(0);
            pane.setVvalue(0);
        });
        editor.window().focus();
    }

    private Stream<ScrollPane> scrollPanes() {
        return stage.getScene().getRoot().lookupAll(".scroll-pane").stream().filter(ScrollPane.class::isInstance)
                .map(ScrollPane.class::cast);
    }

    /** Closes secondary windows, menus and dialogs. */
    void hideOtherWindows() {
        // On the headless platform, a window that closes would keep the focus.
        stage.requestFocus();
        List.copyOf(Window.getWindows()).reversed().stream().filter(window -> window != stage).forEach(Window::hide);
    }

    /** Each Escape ends one of a drag, a tool and a choice of pixels or a region, which outlive their document. */
    private void cancelTools() {
        Node picture = stage.getScene().lookup("#traced-picture");
        for (int i = 0; i < ESCAPES; i++) {
            Event.fireEvent(picture, new KeyEvent(KeyEvent.KEY_PRESSED, "", "", KeyCode.ESCAPE, false, false, false, false));
        }
    }

    private void restoreWindow() {
        ColorTheme.DARK.apply();
        stage.setFullScreen(false);
        stage.setX(x);
        stage.setY(y);
        stage.setWidth(width);
        stage.setHeight(height);
        if (!stage.isShowing()) {
            stage.show();
        }
        stage.requestFocus();
    }

    private void restoreSettings() {
        EditorModel model = editor.model();
        var defaults = new Preferences(NO_PREFERENCES, Runnable::run);
        model.layout().restore(defaults);
        model.layout().workingSizeProperty().set(WorkingSize.SCENE);
        model.layout().canvasLayoutProperty().set(CanvasLayout.SIDE_BY_SIDE);
        model.layout().panelsHiddenProperty().set(false);
        model.layout().filmStripShownProperty().set(false);
        model.layout().panelsProperty().set(PanelArrangement.INITIAL.closeAll());
        model.accuracyModeProperty().set(AccuracyMode.EXACT);
        model.editor().liveProperty().set(false);
        model.previewSettings().restore(defaults);
        model.previewSettings().gizmosHiddenProperty().set(false);
        model.commands().keyBindings().reset();
        model.renderMachines().restore(defaults);
        model.languageProperty().set(UiLanguage.SYSTEM);
        for (Command toggle : List.of(Command.KEEP_PICTURES, Command.ONLY_SELECTED)) {
            if (model.commands().toggleState(toggle).orElseThrow().getValue()) {
                model.commands().run(toggle);
            }
        }
        model.pictureDisplay().effectsProperty().set(ViewEffects.ALL);
    }
}
