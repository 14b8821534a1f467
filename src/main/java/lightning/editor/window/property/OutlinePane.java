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
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.NodeEdits;
import lightning.editor.document.Situation;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.command.ShapeKeys;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Group;
import lightning.scene.Node;
import lightning.scene.Stage;

/**
 * The shapes and groups of the scene, groups folded at first. Cells are made for the lines in view alone. The keyboard: F2 renames,
 * Delete deletes, Ctrl+D duplicates, H or Space hides and shows, left and right fold and unfold.
 */
final class OutlinePane extends VBox {
    private final SceneEditor editor;
    private final Commands commands;
    private final ListView<OutlineRow> list = new ListView<>();
    private final Label count = new Label();
    /** Made once: to look up how a language writes numbers takes a twentieth of an edit. */
    private final NumberFormat grouped = NumberFormat.getIntegerInstance(Texts.locale());
    private final Set<String> unfolded = new HashSet<>();
    /** What is listed, and which of it is selected; null before the first. */
    private Stage listed;
    private Node selected;
    private boolean showing;

    OutlinePane(SceneEditor editor, Commands commands) {
        this.editor = editor;
        this.commands = commands;
        setId("shapes");
        getStyleClass().add("lights");
        list.setId("shape-list");
        list.getStyleClass().addAll("light-list", "shape-list", "edge-to-edge");
        list.setAccessibleText(Texts.of("shapes and groups"));
        list.setPlaceholder(new Label(Texts.of("No shapes.")));
        list.setCellFactory(_ -> new OutlineCell(editor, commands, this));
        CommandItems items = CommandItems.of(commands, "of-shape-");
        list.setContextMenu(new ContextMenu(items.item(Command.RENAME_SHAPE), items.item(Command.DUPLICATE_SHAPE),
                items.item(Command.DELETE_SHAPE), new SeparatorMenuItem(), items.item(Command.SHOW_SHAPE)));
        list.addEventHandler(KeyEvent.KEY_PRESSED, this::press);
        list.getSelectionModel().selectedIndexProperty().addListener((_, _, now) -> select(now.intValue()));
        setVgrow(list, Priority.ALWAYS);
        count.setId("shape-count");
        count.getStyleClass().add("caption");
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var tools = new HBox(count, gap, CommandButton.icon(commands, Command.SHOW_SHAPE),
                CommandButton.icon(commands, Command.DUPLICATE_SHAPE), CommandButton.icon(commands, Command.DELETE_SHAPE));
        tools.getStyleClass().add("lights-tools");
        getChildren().addAll(tools, list);
        commands.setAction(Command.RENAME_SHAPE, this::rename);
        editor.situationProperty().subscribe(this::show);
    }

    private void press(KeyEvent event) {
        if (list.getEditingIndex() >= 0) {
            return;
        }
        switch (event.getCode()) {
            case F2 -> commands.run(Command.RENAME_SHAPE);
            case LEFT -> fold(false);
            case RIGHT -> fold(true);
            default -> {
                if (!ShapeKeys.pressed(commands, event)) {
                    return;
                }
            }
        }
        event.consume();
    }

    private void fold(boolean unfold) {
        if (selected instanceof Group g && isUnfolded(g.name()) != unfold) {
            fold(g.name());
        }
    }

    boolean isUnfolded(String group) {
        return unfolded.contains(group);
    }

    /** Folds a group, or unfolds it. */
    void fold(String group) {
        if (!unfolded.remove(group)) {
            unfolded.add(group);
        }
        list(editor.scene().stage());
        mark(editor.scene().stage(), false);
    }

    /** Only until the cell ends it is the list editable, or a second click on a shape would rename it. */
    private void rename() {
        list.setEditable(true);
        list.edit(list.getSelectionModel().getSelectedIndex());
    }

    /** Renames a shape or a group, and goes on with it; returns why it was refused. */
    Optional<String> rename(String name, String typed) {
        Optional<String> refusal = editor.editOrReport(scene -> NodeEdits.rename(scene, name, typed));
        if (refusal.isEmpty()) {
            if (unfolded.remove(name)) {
                unfolded.add(typed);
            }
            editor.selection().selectNode(typed);
        }
        return refusal;
    }

    private void select(int index) {
        if (!showing && index >= 0) {
            Node node = list.getItems().get(index).node(editor.scene().stage());
            if (node != null) {
                editor.selection().selectNode(node.name());
            }
        }
    }

    private void show(Situation now) {
        Stage stage = now.scene().stage();
        boolean other = listed == null || !stage.sharesOutlineWith(listed);
        Node before = selected;
        selected = now.node().orElse(null);
        boolean moved = selected != before
                && (selected == null || before == null || !selected.name().equals(before.name()));
        if (moved && selected != null) {
            other |= unfolded.addAll(stage.around(selected.name()).stream().map(Group::name).toList());
        }
        if (other) {
            list(stage);
        }
        if (other || moved) {
            // Where lines are listed anew below a group, those in view are not known before they are laid out.
            mark(stage, moved && (other && !unfolded.isEmpty() || !isInView(line(stage))));
        }
    }

    private void list(Stage stage) {
        showing = true;
        listed = stage;
        // A list that gains or loses lines moves its selection along, line by line; here it is made anew.
        list.getSelectionModel().clearSelection();
        OutlineRow.update(list.getItems(), stage, unfolded);
        int shapes = stage.shapeCount();
        count.setText(shapes == 1 ? Texts.of("1 shape") : Texts.of("{0} shapes", grouped.format(shapes)));
        showing = false;
    }

    /** The line of what is selected; −1 for none. */
    private int line(Stage stage) {
        return selected == null ? -1 : stage.places(selected.name()).map(places -> OutlineRow.line(list.getItems(), places)).orElse(-1);
    }

    /** Whether a line is among those laid out last, between the first and the last of these, which may be cut off. */
    private boolean isInView(int row) {
        return list.lookup(".virtual-flow") instanceof VirtualFlow<?> flow && flow.getFirstVisibleCell() != null
                && flow.getFirstVisibleCell().getIndex() < row && row < flow.getLastVisibleCell().getIndex();
    }

    /** @param scroll whether the line is brought into view, which takes the longer the more lines there are */
    private void mark(Stage stage, boolean scroll) {
        showing = true;
        int row = line(stage);
        if (row < 0) {
            list.getSelectionModel().clearSelection();
        } else if (list.getSelectionModel().getSelectedIndex() != row) {
            list.getSelectionModel().clearAndSelect(row);
            if (scroll) {
                list.scrollTo(row);
            }
        }
        showing = false;
    }
}
