package lightning.editor.window;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.scene.Parent;
import javafx.scene.layout.Region;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.contribution.ContributionPane;
import lightning.editor.window.cue.CuePane;
import lightning.editor.window.measure.AccuracyPane;
import lightning.editor.window.measure.EffectsPane;
import lightning.editor.window.measure.ScopesPane;
import lightning.editor.window.mixer.MixerPane;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.PanelWindow;

/** The windows beside the editor's, each open at most once and called as the command that opens it. */
final class Panels implements AutoCloseable {
    private static final Map<Command, Panel> PANELS = Map.of(
            Command.ACCURACY_PANEL, new Panel(960, 760, AccuracyPane::new),
            Command.EFFECTS_PANEL, new Panel(760, 680, EffectsPane::new),
            Command.KEYS, new Panel(880, 720, KeysPane::new),
            Command.SCOPES, new Panel(540, 540, ScopesPane::new),
            Command.HISTORY_PANEL, new Panel(380, 560, HistoryPane::new),
            Command.UPDATES_PANEL, new Panel(1200, 420, UpdatesPane::new),
            Command.MIXER, new Panel(1000, 460, MixerPane::new),
            Command.CUES, new Panel(820, 640, CuePane::new),
            Command.CONTRIBUTIONS, new Panel(680, 480, ContributionPane::new));

    private final EditorModel model;
    private final Supplier<Window> owner;
    private final Map<Command, Stage> opened = new EnumMap<>(Command.class);

    /**
     * What stands in a window.
     *
     * @param width pixels; likewise {@code height}
     */
    private record Panel(double width, double height, Function<EditorModel, Region> pane) {}

    /** @param owner the editor's window, once there is one */
    Panels(EditorModel model, Supplier<Window> owner) {
        this.model = model;
        this.owner = owner;
    }

    /** Does the commands that open them. */
    void addTo(EditorModel editor) {
        PANELS.keySet().forEach(command -> editor.commands().setAction(command, () -> open(command)));
    }

    /** For each window the steps that make it before it is wanted, each of which takes a moment of the window's thread. */
    Stream<Runnable> ahead() {
        return PANELS.keySet().stream().sorted().flatMap(
                command -> Stream.of(() -> made(command), () -> root(command).applyCss(), () -> root(command).layout()));
    }

    private Stage made(Command command) {
        return opened.computeIfAbsent(command, c -> window(c, PANELS.get(c)));
    }

    private Parent root(Command command) {
        return made(command).getScene().getRoot();
    }

    private void open(Command command) {
        Stage stage = made(command);
        stage.show();
        stage.toFront();
    }

    /** The commands' keys work in it as in the editor's window. */
    private Stage window(Command command, Panel panel) {
        var stage = new PanelWindow(owner.get(), command.plainTitle(), panel.pane().apply(model), panel.width(), panel.height());
        CommandKeys.take(stage.getScene(), model);
        return stage;
    }

    @Override
    public void close() {
        opened.values().forEach(Stage::close);
    }
}
