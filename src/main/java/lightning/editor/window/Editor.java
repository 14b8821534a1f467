package lightning.editor.window;

import java.nio.file.Path;
import java.util.List;
import javafx.beans.Observable;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.FileThread;
import lightning.editor.Command;
import lightning.editor.window.command.EditorDialogs;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.widget.ColorTheme;

/** Editor of one document in one window, from opening to closing. */
public final class Editor implements AutoCloseable {
    private final Stage stage;
    private final StartupSession startup;
    private final Preferences preferences;
    private final FileThread thread;
    private final EditorDialogs notices;
    private final FileActions files;
    private final EditorModel model;
    private final EditorWindow window;
    private final ExternalChangeBar changeBar;

    /**
     * Opens the window.
     *
     * @param startup document's model and picture; closed with the editor
     * @param thread reads and writes files; closed with the editor
     * @param maxWidth maximum width of the window: that of the screen, pixels
     * @param maxHeight maximum height of the window, pixels
     */
    Editor(Stage stage, StartupSession startup, Preferences preferences, FileThread thread, FilePrompt prompt, double maxWidth,
            double maxHeight) {
        this.stage = stage;
        this.startup = startup;
        this.preferences = preferences;
        this.thread = thread;
        notices = new EditorDialogs(stage);
        model = startup.model();
        files = new FileActions(model, prompt, notices, preferences, this::closeWindow);
        window = new EditorWindow(startup.frame(), model, files, notices);
        changeBar = new ExternalChangeBar(model.workbench(), model.commands(), thread.windowExecutor(), files::compareWithDisk);
        window.addBar(changeBar);
        model.editor().editorStateProperty()
                .subscribe(now -> stage.setTitle((now.dirty() ? "• " : "") + model.editor().document().title() + " – Lightning"));
        stage.focusedProperty().subscribe(_ -> changeBar.checkFile());
        stage.setOnCloseRequest(e -> {
            e.consume();
            files.confirmClose(() -> {
                savePreferences();
                closeOtherWindows();
                stage.hide();
            });
        });
        if (!model.editor().document().isUntitled()) {
            preferences.addRecent(model.editor().document().file());
        }
        savePreferencesOnChange();
        EditorStage.show(stage, startup.frame(), preferences, maxWidth, maxHeight);
        window.showPanelWindows();
        window.focus();
    }

    EditorModel model() {
        return model;
    }

    EditorWindow window() {
        return window;
    }

    /** Returns whether the picture is rendered and no other task is running. */
    boolean isIdle() {
        return model.picture().frame() != null && model.fileActivity().file() == null
                && model.editor().editorStateProperty().get().sceneInProgress().isEmpty();
    }

    public FileActions files() {
        return files;
    }

    /** Shows the welcome page next to the start scene, unless the user has switched it off. */
    void welcome() {
        if (model.layout().welcomeAtStartProperty().get()) {
            model.commands().run(Command.WELCOME);
        }
    }

    /** Reports a scene that could not be opened, then continues with the scene that was read instead. */
    void reportFailedOpen(Path file, Exception failure) {
        notices.showFailureAndWait(Messages.tr("{0} could not be opened", Quote.path(file)), failure);
    }

    private void closeWindow() {
        stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
    }

    /** Saves each choice immediately, so that a crash does not lose it. */
    private void savePreferencesOnChange() {
        PreviewSettings settings = model.previewSettings();
        for (Observable choice : List.of(model.accuracyModeProperty(), model.editor().liveProperty(),
                settings.glowingTexturesProperty(),
                settings.gizmoSizeProperty(), settings.navigationProperty(), settings.shadowsProperty(),
                model.commands().keyBindings().changesProperty(), model.layout().canvasLayoutProperty(),
                model.layout().welcomeAtStartProperty(), model.layout().panelsProperty(),
                model.languageProperty(), model.commands().toggleState(Command.KEEP_PICTURES).orElseThrow(),
                model.renderMachines().hostsProperty(), model.renderMachines().certificateProperty(),
                model.commands().toggleState(Command.LIGHT_THEME).orElseThrow())) {
            choice.addListener(_ -> savePreferences());
        }
    }

    private void savePreferences() {
        preferences.set("width", stage.getScene().getWidth());
        preferences.set("height", stage.getScene().getHeight());
        preferences.set("theme", ColorTheme.current().name());
        model.languageProperty().get().save(preferences);
        model.previewSettings().save(preferences);
        model.commands().keyBindings().save(preferences);
        model.layout().save(preferences);
        model.renderMachines().save(preferences);
        preferences.set("live", model.editor().liveProperty().get());
        preferences.set("keep-pictures", model.commands().toggleState(Command.KEEP_PICTURES).orElseThrow().getValue());
        preferences.set("precision", model.accuracyModeProperty().get().name());
        preferences.save();
    }

    /** Closes secondary windows before their owner: the toolkit may still access a child window after the owner has closed it. */
    private void closeOtherWindows() {
        List.copyOf(Window.getWindows()).reversed().stream().filter(window -> window != stage).forEach(Window::hide);
    }

    @Override
    public void close() {
        closeOtherWindows();
        changeBar.close();
        window.close();
        startup.close();
        thread.close();
    }
}
