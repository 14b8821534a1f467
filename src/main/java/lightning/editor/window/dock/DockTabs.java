package lightning.editor.window.dock;

import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.layout.Region;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.PanelPlace;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;

/** Panels of a dock as tabs. Only the panel in front is part of the window, so that the others cost nothing. */
public final class DockTabs extends TabPane {
    private final PanelPlace place;
    private final CommandRegistry commands;
    private final Function<Command, Region> panes;
    private final Callbacks callbacks;
    private final Map<Command, Tab> tabs = new EnumMap<>(Command.class);
    private boolean isUpdating;

    /** Receives the user's changes. */
    public interface Callbacks {
        /** Brings a panel to the front. */
        void select(Command panel);

        /** Closes a panel. */
        void close(Command panel);

        /** Moves a panel to another place. */
        void move(Command panel, PanelPlace place);
    }

    /**
     * Creates an empty dock.
     *
     * @param panes returns the content of a panel; called when it comes to the front for the first time
     */
    public DockTabs(PanelPlace place, CommandRegistry commands, Function<Command, Region> panes, Callbacks callbacks) {
        this.place = place;
        this.commands = commands;
        this.panes = panes;
        this.callbacks = callbacks;
        setId("dock-" + place.name().toLowerCase(Locale.ROOT));
        setAccessibleText(place.toString());
        getStyleClass().addAll("dense", "side", "dock");
        setTabClosingPolicy(TabClosingPolicy.ALL_TABS);
        // The split pane decides, not the content.
        setMinSize(0, 0);
        getSelectionModel().selectedItemProperty().subscribe(tab -> {
            if (tab != null && !isUpdating) {
                callbacks.select(panel(tab));
            }
        });
    }

    PanelPlace place() {
        return place;
    }

    private static Command panel(Tab tab) {
        return (Command) tab.getUserData();
    }

    /** Removes all tabs except those of the given panels, whose content can then move to another place. */
    public void retain(List<Command> panels) {
        update(() -> {
            for (Tab tab : List.copyOf(getTabs())) {
                if (!panels.contains(panel(tab))) {
                    ((ScrollPane) tab.getContent()).setContent(null);
                    getTabs().remove(tab);
                }
            }
        });
    }

    /** Shows panels as tabs in the given order. */
    public void show(List<Command> panels, Optional<Command> front) {
        retain(panels);
        update(() -> {
            List<Tab> wanted = panels.stream().map(p -> tabs.computeIfAbsent(p, this::createTab)).toList();
            if (!getTabs().equals(wanted)) {
                getTabs().setAll(wanted);
            }
            front.map(tabs::get).ifPresent(getSelectionModel()::select);
        });
        for (Tab tab : getTabs()) {
            var scroll = (ScrollPane) tab.getContent();
            Region content = front.filter(p -> p == panel(tab)).map(panes).orElse(null);
            if (scroll.getContent() != content) {
                scroll.setContent(content);
            }
        }
    }

    private void update(Runnable change) {
        boolean wasUpdating = isUpdating;
        isUpdating = true;
        change.run();
        isUpdating = wasUpdating;
    }

    private Tab createTab(Command panel) {
        var tab = new Tab(panel.plainTitle());
        tab.setId("tab-" + panel.id());
        tab.setUserData(panel);
        tab.setGraphic(new FontIcon(panel.icon()));
        var scroll = new ScrollPane();
        scroll.getStyleClass().add("edge-to-edge");
        scroll.setFitToWidth(true);
        scroll.setFitToHeight(true);
        tab.setContent(scroll);
        tab.setOnCloseRequest(e -> {
            callbacks.close(panel);
            e.consume();
        });
        var items = CommandMenuItems.forMenu(commands, "dock-");
        var menu = new ContextMenu();
        Stream.of(PanelPlace.values()).filter(p -> p != place)
                .forEach(p -> menu.getItems().add(items.value(Command.FLOAT_PANEL, p.toString(), () -> callbacks.move(panel, p))));
        menu.getItems().add(items.value(Command.CLOSE_PANEL, Command.CLOSE_PANEL.title(), () -> callbacks.close(panel)));
        tab.setContextMenu(menu);
        return tab;
    }

    /** Returns the panel whose tab header is at a position of the scene. */
    Optional<Command> panelAt(double sceneX, double sceneY) {
        return getTabs().stream().filter(tab -> lookup("#" + tab.getId()) instanceof Node header
                && header.contains(header.sceneToLocal(sceneX, sceneY))).map(DockTabs::panel).findFirst();
    }

    /** Gives the keyboard focus to the first control of the panel in front, or to its tab. */
    public void focusContent() {
        Tab front = getSelectionModel().getSelectedItem();
        if (front != null) {
            firstFocusable(((ScrollPane) front.getContent()).getContent()).orElse(this).requestFocus();
        }
    }

    /** Returns the first visible control in a part of the window that Tab can reach. */
    public static Optional<Node> firstFocusable(@Nullable Node node) {
        if (node == null || !node.isVisible() || node.isDisabled()) {
            return Optional.empty();
        }
        if (node.isFocusTraversable() && !(node instanceof ScrollPane)) {
            return Optional.of(node);
        }
        return node instanceof Parent p ? p.getChildrenUnmodifiable().stream().flatMap(c -> firstFocusable(c).stream()).findFirst()
                : Optional.empty();
    }
}
