package lightning.editor.window.property;

import java.text.NumberFormat;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.skin.VirtualFlow;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.NodeEdits;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.command.ShapeKeys;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Stage;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import org.jspecify.annotations.Nullable;

/**
 * Outliner of the scene's shapes and groups, initially collapsed. Creates cells for visible rows only.
 *
 * <p>Keys: F2 renames, Delete deletes, Ctrl+D duplicates, H or Space toggles visibility, Left and Right collapse and expand.
 */
final class OutlinePane extends VBox {
    private final SceneEditor editor;
    private final CommandRegistry commands;
    private final ListView<OutlineRow> list = new ListView<>();
    private final Label count = new Label();
    /** Cached: creating a number format takes a twentieth of an edit's time. */
    private final NumberFormat countFormat = NumberFormat.getIntegerInstance(Messages.locale());
    private final Set<String> expandedGroups = new HashSet<>();
    /** Listed stage and selected node; null before the first update. */
    private @Nullable Stage listedStage;
    private @Nullable SceneNode selected;
    private boolean isUpdating;

    OutlinePane(SceneEditor editor, MaterialSelection materials, CommandRegistry commands) {
        this.editor = editor;
        this.commands = commands;
        setId("shapes");
        getStyleClass().add("lights");
        list.setId("shape-list");
        list.getStyleClass().addAll("light-list", "shape-list", "edge-to-edge");
        list.setAccessibleText(Messages.tr("objects and groups"));
        list.setPlaceholder(new Label(Messages.tr("No objects.")));
        list.setCellFactory(_ -> new OutlineCell(editor, materials, commands, this));
        CommandMenuItems items = CommandMenuItems.forMenu(commands, "of-shape-");
        list.setContextMenu(new ContextMenu(items.item(Command.RENAME_SHAPE), items.item(Command.DUPLICATE_SHAPE),
                items.item(Command.DELETE_SHAPE), new SeparatorMenuItem(), items.item(Command.SHOW_SHAPE),
                items.item(Command.MAKE_LIGHT)));
        list.addEventHandler(KeyEvent.KEY_PRESSED, this::handleKey);
        list.getSelectionModel().selectedIndexProperty().addListener((_, _, now) -> select(now.intValue()));
        setVgrow(list, Priority.ALWAYS);
        count.setId("shape-count");
        count.getStyleClass().add("caption");
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var tools = new HBox(count, gap, CommandButton.iconButton(commands, Command.SHOW_SHAPE),
                CommandButton.iconButton(commands, Command.DUPLICATE_SHAPE), CommandButton.iconButton(commands, Command.DELETE_SHAPE));
        tools.getStyleClass().add("lights-tools");
        getChildren().addAll(tools, list);
        commands.setAction(Command.RENAME_SHAPE, this::rename);
        editor.editorStateProperty().subscribe(this::show);
    }

    private void handleKey(KeyEvent event) {
        if (list.getEditingIndex() >= 0) {
            return;
        }
        switch (event.getCode()) {
            case F2 -> commands.run(Command.RENAME_SHAPE);
            case LEFT -> setExpanded(false);
            case RIGHT -> setExpanded(true);
            default -> {
                if (!ShapeKeys.handle(commands, event)) {
                    return;
                }
            }
        }
        event.consume();
    }

    private void setExpanded(boolean expand) {
        if (selected instanceof NodeGroup g && isExpanded(g.name()) != expand) {
            toggleExpanded(g.name());
        }
    }

    boolean isExpanded(String group) {
        return expandedGroups.contains(group);
    }

    /** Collapses or expands a group. */
    void toggleExpanded(String group) {
        if (!expandedGroups.remove(group)) {
            expandedGroups.add(group);
        }
        updateList(editor.scene().stage());
        updateSelection(editor.scene().stage(), false);
    }

    /** Renames the selected node. The list is editable only meanwhile, since a second click would otherwise rename. */
    private void rename() {
        list.setEditable(true);
        list.edit(list.getSelectionModel().getSelectedIndex());
    }

    /** Renames a shape or group and keeps it selected. Returns why it was refused, or empty. */
    Optional<String> rename(String name, String typed) {
        Optional<String> refusal = editor.editOrReport(scene -> NodeEdits.rename(scene, name, typed));
        if (refusal.isEmpty()) {
            if (expandedGroups.remove(name)) {
                expandedGroups.add(typed);
            }
            editor.selection().selectNode(typed);
        }
        return refusal;
    }

    private void select(int index) {
        if (!isUpdating && index >= 0) {
            SceneNode node = list.getItems().get(index).node(editor.scene().stage());
            if (node != null) {
                editor.selection().selectNode(node.name());
            }
        }
    }

    private void show(EditorState state) {
        Stage stage = state.scene().stage();
        boolean outlineChanged = listedStage == null || !stage.sharesStructure(listedStage);
        SceneNode oldSelection = selected;
        selected = state.selectedNode().orElse(null);
        boolean selectionChanged = selected != oldSelection
                && (selected == null || oldSelection == null || !selected.name().equals(oldSelection.name()));
        if (selectionChanged && selected != null) {
            outlineChanged |= expandedGroups.addAll(stage.enclosingGroups(selected.name()).stream().map(NodeGroup::name).toList());
        }
        if (outlineChanged) {
            updateList(stage);
        }
        if (outlineChanged || selectionChanged) {
            // After an update below a group, the visible rows are unknown until layout.
            updateSelection(stage, selectionChanged && (outlineChanged && !expandedGroups.isEmpty() || !isInView(rowIndex(stage))));
        }
    }

    private void updateList(Stage stage) {
        isUpdating = true;
        listedStage = stage;
        // Changing the list would move its selection row by row; it is set again afterwards.
        list.getSelectionModel().clearSelection();
        OutlineRow.update(list.getItems(), stage, expandedGroups);
        int shapes = stage.shapeCount();
        count.setText(shapes == 1 ? Messages.tr("1 object") : Messages.tr("{0} objects", countFormat.format(shapes)));
        isUpdating = false;
    }

    /** Returns the row of the selected node, or −1. */
    private int rowIndex(Stage stage) {
        return selected == null ? -1 : stage.path(selected.name()).map(places -> OutlineRow.indexOf(list.getItems(), places)).orElse(-1);
    }

    /** Returns whether a row lies strictly between the first and last visible cells, which may be clipped. */
    private boolean isInView(int row) {
        return list.lookup(".virtual-flow") instanceof VirtualFlow<?> flow && flow.getFirstVisibleCell() != null
                && flow.getFirstVisibleCell().getIndex() < row && row < flow.getLastVisibleCell().getIndex();
    }

    /** @param scroll  true to scroll the row into view, which takes time proportional to the number of rows */
    private void updateSelection(Stage stage, boolean scroll) {
        isUpdating = true;
        int row = rowIndex(stage);
        if (row < 0) {
            list.getSelectionModel().clearSelection();
        } else if (list.getSelectionModel().getSelectedIndex() != row) {
            list.getSelectionModel().clearAndSelect(row);
            if (scroll) {
                list.scrollTo(row);
            }
        }
        isUpdating = false;
    }
}
