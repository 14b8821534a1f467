package lightning.editor.window;

import static java.util.Objects.requireNonNull;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.stage.Window;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.contribution.ContributionPane;
import lightning.editor.window.dock.DockTabs;
import lightning.editor.window.look.LookPane;
import lightning.editor.window.measure.ScopesPane;
import lightning.editor.window.mixer.MixerPane;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PanelArrangement;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.timeline.MotionRecording;
import lightning.editor.window.timeline.Playback;
import lightning.editor.window.timeline.TimelinePane;
import lightning.editor.window.widget.PanelWindow;
import org.jspecify.annotations.Nullable;

/** Panels in the docks of the editor's window and in windows of their own, as the {@link PanelArrangement} says. */
final class DockedPanels implements DockTabs.Callbacks, AutoCloseable {
    private final EditorModel model;
    private final Supplier<Window> owner;
    private final WindowLayout layout;
    private final Playback playback;
    private final MotionRecording recording;
    private final Map<Command, Region> panes = new EnumMap<>(Command.class);
    private final Map<Command, PanelWindow> windows = new EnumMap<>(Command.class);
    private final DockTabs left;
    private final DockTabs below;
    /** False until the editor's window is open. */
    private boolean canShowWindows;

    /**
     * Creates the docks without panels.
     *
     * @param owner returns the editor's window once it exists
     */
    DockedPanels(EditorModel model, Supplier<Window> owner, Playback playback, MotionRecording recording) {
        this.model = model;
        this.owner = owner;
        this.playback = playback;
        this.recording = recording;
        layout = model.layout();
        left = new DockTabs(PanelPlace.LEFT, model.commands(), this::pane, this);
        below = new DockTabs(PanelPlace.BELOW, model.commands(), this::pane, this);
        registerCommands(model.commands());
    }

    DockTabs left() {
        return left;
    }

    DockTabs below() {
        return below;
    }

    private void registerCommands(CommandRegistry commands) {
        PanelArrangement.INITIAL.slots().stream().map(PanelArrangement.Slot::panel).filter(p -> p != Command.TIMELINE)
                .forEach(panel -> commands.setAction(panel, () -> openOrClose(panel)));
        commands.setAction(Command.CLOSE_PANEL, () -> panelInUse().ifPresentOrElse(this::close, this::reportNoPanel));
        commands.setAction(Command.FLOAT_PANEL, () -> panelInUse().ifPresentOrElse(
                p -> move(p, arrangement().place(p).isDock() ? PanelPlace.WINDOW : arrangement().dock(p)), this::reportNoPanel));
        commands.setAction(Command.MOVE_PANEL, () -> panelInUse().ifPresentOrElse(
                p -> move(p, arrangement().dock(p) == PanelPlace.LEFT ? PanelPlace.BELOW : PanelPlace.LEFT), this::reportNoPanel));
    }

    private void reportNoPanel() {
        model.editor().message().show(Messages.tr("No panel is open"));
    }

    /** Shows the docks now, and again after each change. */
    void bind() {
        layout.panelsProperty().subscribe(this::show);
    }

    /** Shows panels in windows of their own, which need the editor's window. */
    void showWindows() {
        canShowWindows = true;
        show(arrangement());
    }

    private PanelArrangement arrangement() {
        return layout.panelsProperty().get();
    }

    private Region pane(Command panel) {
        return panes.computeIfAbsent(panel, this::createPane);
    }

    private Region createPane(Command panel) {
        return switch (panel) {
            case MIXER -> new MixerPane(model.editor(), model.picture(), model.workbench(), model.files().windowExecutor());
            case LOOKS -> new LookPane(model.editor(), model.picture(), model.files());
            case CONTRIBUTIONS -> new ContributionPane(model);
            case SCOPES -> new ScopesPane(model.picture(), model.files().windowExecutor());
            case HISTORY_PANEL -> new HistoryPane(model.editor(), model.workbench());
            case UPDATES_PANEL -> new UpdatesPane(model.updates());
            case TIMELINE -> new TimelinePane(model, playback, recording);
            default -> throw new IllegalArgumentException(panel.name());
        };
    }

    /** Returns steps that each create a panel ahead of time. */
    Stream<Runnable> preloadSteps() {
        return PanelArrangement.INITIAL.slots().stream().map(slot -> () -> pane(slot.panel()));
    }

    /** Opens a panel and moves the keyboard focus to it. Closes it if it has the focus. */
    private void openOrClose(Command panel) {
        if (hasFocus(panel)) {
            close(panel);
        } else {
            layout.panelsHiddenProperty().set(false);
            layout.panelsProperty().set(arrangement().open(panel));
            show(arrangement());
            focus(panel);
        }
    }

    private void focus(Command panel) {
        switch (arrangement().place(panel)) {
            case LEFT -> focus(left);
            case BELOW -> focus(below);
            case WINDOW -> requireNonNull(windows.get(panel)).toFront();
        }
    }

    private static void focus(DockTabs dock) {
        dock.getScene().getRoot().applyCss();
        dock.focusContent();
    }

    private boolean hasFocus(Command panel) {
        if (!arrangement().isShown(panel)) {
            return false;
        }
        return arrangement().place(panel).isDock() ? isIn(pane(panel).getScene() == null ? null : pane(panel).getScene().getFocusOwner(),
                dock(arrangement().place(panel))) && !isWindowFocused()
                : windows.containsKey(panel) && windows.get(panel).isFocused();
    }

    private boolean isWindowFocused() {
        return windows.values().stream().anyMatch(Window::isFocused);
    }

    private DockTabs dock(PanelPlace place) {
        return place == PanelPlace.LEFT ? left : below;
    }

    private static boolean isIn(@Nullable Node node, Node ancestor) {
        return node != null && (node == ancestor || isIn(node.getParent(), ancestor));
    }

    /** Returns the panel with the keyboard focus, else one that is shown; empty if none is open. */
    private Optional<Command> panelInUse() {
        List<Command> shown = arrangement().slots().stream().map(PanelArrangement.Slot::panel).filter(arrangement()::isShown).toList();
        return shown.stream().filter(this::hasFocus).findFirst().or(() -> shown.stream().findFirst());
    }

    @Override
    public void select(Command panel) {
        layout.panelsProperty().set(arrangement().inFront(panel));
    }

    @Override
    public void close(Command panel) {
        layout.panelsProperty().set(arrangement().close(panel));
    }

    @Override
    public void move(Command panel, PanelPlace place) {
        layout.panelsProperty().set(arrangement().move(panel, place));
        focus(panel);
    }

    /** Moves a panel to a place where its tab was dropped, in screen pixels. */
    void drop(Command panel, PanelPlace place, double screenX, double screenY) {
        move(panel, place);
        if (!place.isDock()) {
            requireNonNull(windows.get(panel)).setX(screenX);
            windows.get(panel).setY(screenY);
        }
    }

    private void show(PanelArrangement now) {
        List<Command> floating = now.openIn(PanelPlace.WINDOW);
        windows.forEach((panel, window) -> {
            if (!floating.contains(panel)) {
                content(window).setCenter(null);
                window.hide();
            }
        });
        List<DockTabs> docks = List.of(left, below);
        docks.forEach(dock -> dock.retain(now.openIn(place(dock))));
        docks.forEach(dock -> dock.show(now.openIn(place(dock)), now.front(place(dock))));
        if (canShowWindows) {
            floating.forEach(this::showWindow);
        }
    }

    private PanelPlace place(DockTabs dock) {
        return dock == left ? PanelPlace.LEFT : PanelPlace.BELOW;
    }

    private void showWindow(Command panel) {
        PanelWindow window = windows.computeIfAbsent(panel, this::createWindow);
        content(window).setCenter(pane(panel));
        if (!window.isShowing()) {
            window.show();
        }
    }

    private static BorderPane content(PanelWindow window) {
        return (BorderPane) window.pane();
    }

    /** Creates a window in which the editor's shortcuts work as well. */
    private PanelWindow createWindow(Command panel) {
        var bar = new HBox(CommandButton.iconButton(model.commands(), Command.FLOAT_PANEL));
        bar.getStyleClass().add("panel-bar");
        var content = new BorderPane();
        content.setTop(bar);
        var size = PanelSize.of(panel);
        var window = new PanelWindow(owner.get(), panel.plainTitle(), content, size.width(), size.height());
        window.setOnCloseRequest(_ -> close(panel));
        CommandKeys.install(window.getScene(), model.commands());
        return window;
    }

    /**
     * Size of a panel's own window.
     *
     * @param width pixels
     * @param height pixels
     */
    private record PanelSize(double width, double height) {
        static PanelSize of(Command panel) {
            return switch (panel) {
                case MIXER -> new PanelSize(1000, 490);
                case LOOKS -> new PanelSize(820, 670);
                case CONTRIBUTIONS -> new PanelSize(680, 510);
                case SCOPES -> new PanelSize(540, 570);
                case HISTORY_PANEL -> new PanelSize(380, 590);
                default -> new PanelSize(1200, 450);
            };
        }
    }

    @Override
    public void close() {
        windows.values().forEach(Window::hide);
        if (panes.get(Command.TIMELINE) instanceof TimelinePane timeline) {
            timeline.close();
        }
    }
}
