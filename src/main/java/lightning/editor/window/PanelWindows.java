package lightning.editor.window;

import static java.util.Objects.requireNonNull;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.scene.Parent;
import javafx.scene.layout.Region;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.link.LinkPane;
import lightning.editor.window.match.MatchPane;
import lightning.editor.window.measure.AccuracyPane;
import lightning.editor.window.measure.EffectsPane;
import lightning.editor.window.measure.SettingAccuracyPane;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.review.LiveReviewPane;
import lightning.editor.window.sequence.SequencePane;
import lightning.editor.window.widget.PanelWindow;

/**
 * Secondary windows of the editor for panels that cannot be docked. Each is open at most once and has the title of the command that opens
 * it.
 */
final class PanelWindows implements AutoCloseable {
    private static final Map<Command, PanelSpec> PANELS = Map.of(
            Command.ACCURACY_PANEL,
            new PanelSpec(960, 760, m -> new AccuracyPane(m.workbench(), m.editor().editorStateProperty(), m.picture().viewProperty())),
            Command.EFFECTS_PANEL,
            new PanelSpec(760, 680,
                    m -> new EffectsPane(m.editor(), m.workbench(), m.accuracyModeProperty(), m.pictureDisplay().effectsProperty())),
            Command.COMPARE_SETTINGS, new PanelSpec(920, 470, m -> new SettingAccuracyPane(m.editor(), m.accuracyModeProperty())),
            Command.KEYS, new PanelSpec(880, 720, m -> new ShortcutsPane(m.commands())),
            Command.LIVE_REVIEW, new PanelSpec(560, 420, LiveReviewPane::new),
            Command.MATCH_REFERENCE, new PanelSpec(860, 640, MatchPane::new),
            Command.SEQUENCE, new PanelSpec(860, 640, SequencePane::new),
            Command.LIGHT_LINKS, new PanelSpec(760, 520, m -> new LinkPane(m.editor(), m.files())));

    private final EditorModel model;
    private final Supplier<Window> owner;
    private final Map<Command, Stage> windows = new EnumMap<>(Command.class);

    /**
     * Content and size of a window.
     *
     * @param width pixels
     * @param height pixels
     */
    private record PanelSpec(double width, double height, Function<EditorModel, Region> pane) {}

    /**
     * Creates no window yet.
     *
     * @param owner returns the editor's window once it exists
     */
    PanelWindows(EditorModel model, Supplier<Window> owner) {
        this.model = model;
        this.owner = owner;
    }

    /** Registers the commands that open the windows. */
    void registerCommands(CommandRegistry commands) {
        PANELS.keySet().forEach(command -> commands.setAction(command, () -> open(command)));
    }

    /** Returns, for each window, steps that create it ahead of time. Each step blocks the window's thread only briefly. */
    Stream<Runnable> preloadSteps() {
        return PANELS.keySet().stream().sorted().flatMap(
                command -> Stream.of(() -> getOrCreate(command), () -> root(command).applyCss(), () -> root(command).layout()));
    }

    private Stage getOrCreate(Command command) {
        return windows.computeIfAbsent(command, c -> createWindow(c, requireNonNull(PANELS.get(c))));
    }

    private Parent root(Command command) {
        return getOrCreate(command).getScene().getRoot();
    }

    private void open(Command command) {
        Stage stage = getOrCreate(command);
        stage.show();
        stage.toFront();
    }

    /** Creates a window in which the editor's shortcuts work as well. */
    private Stage createWindow(Command command, PanelSpec panel) {
        var stage = new PanelWindow(owner.get(), command.plainTitle(), panel.pane().apply(model), panel.width(), panel.height());
        CommandKeys.install(stage.getScene(), model.commands());
        return stage;
    }

    @Override
    public void close() {
        windows.values().forEach(Stage::close);
    }
}
